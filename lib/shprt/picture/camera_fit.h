// Fitting a perspective camera tightly around points, seen from a given direction.
#pragma once

#include <span>

#include "shprt/base/vec.h"
#include "shprt/picture/render.h"

namespace shprt {

// The camera's own axes: unit, orthogonal, `back` pointing from the target to the eye.
struct CameraAxes {
  Vec3d right, up, back;
};

// back: any nonzero length. Where up is parallel to it, some direction across it serves as up.
CameraAxes cameraAxes(Vec3d back, Vec3d up);

// The nearest camera that looks along -directionToEye and shows all positions (at least one, all finite) with
// a margin of kFrameMargin. aspect is width over height. The target lies in the middle of the points' depth.
inline constexpr double kFrameMargin = 0.06;  // of the half picture, along the axis that fills it
Camera fitCamera(std::span<const Vec3f> positions, Vec3d directionToEye, Vec3d up, double verticalFovDegrees,
                 double aspect);

// The direction to the eye at an azimuth (0 is +Z, 90 is +X) and an elevation above the horizon, in degrees,
// and the direction that is up there, also at the zenith.
struct OrbitDirection {
  Vec3d toEye, up;
};
OrbitDirection orbitDirection(double azimuthDegrees, double elevationDegrees);

}  // namespace shprt
