// Pictures of a relit mesh: a camera, rays through Embree, radiance interpolated over triangles.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "shprt/base/progress.h"
#include "shprt/base/vec.h"
#include "shprt/image/environment.h"
#include "shprt/image/image.h"

namespace shprt {

struct Camera {
  Vec3d eye, target, up{0, 1, 0};
  double verticalFovDegrees = 35;
};

// A camera that shows all positions with a small margin, from the front, a little above and to the right.
Camera frameCamera(std::span<const Vec3f> positions, double aspect);
// "eye:x,y,z target:x,y,z up:x,y,z fov:degrees", fields optional, separated by spaces or semicolons;
// "orbit:azimuth,elevation[,distance]" in degrees turns the automatic camera (distance 1 frames the mesh).
// Throws Error.
Camera parseCamera(const std::string& specification, std::span<const Vec3f> positions, double aspect);

struct RenderOptions {
  int width = 960, height = 720;
  int samples = 16;                             // per pixel, stratified, fixed pattern
  std::optional<Vec3f> background;              // radiance where nothing is hit, when there is no environment
  const EnvironmentMap* environment = nullptr;  // shown behind the mesh
  Mat3 environmentRotation;                     // turns it with the light
  float environmentScale = 1;
};

// Prepares the mesh once, renders many frames (turntables). A triangle shows the same radiance from both
// sides; of two that lie back to back, as a two-sided surface is held, the one is seen whose front (the side
// on which its corners' normals are) faces the eye.
class MeshRenderer {
 public:
  // normals: one per position.
  MeshRenderer(std::span<const Vec3f> positions, std::span<const Vec3f> normals,
               std::span<const std::array<std::uint32_t, 3>> triangles);
  ~MeshRenderer();

  // radiance: linear, one per vertex.
  Image render(const Camera& camera, std::span<const Vec3f> radiance, const RenderOptions& options,
               const ProgressCallback& progress = {}) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace shprt
