// Balls: the angular map and the mirrored ball, pictures whose disc shows the whole sphere.
#pragma once

#include "shprt/image/environment.h"

namespace shprt {

enum class Ball { kAngular, kMirrored };

// As pixelFootprint and pixelPosition (environment.h), for a ball that fills a width x height picture.
PixelFootprint ballFootprint(Ball ball, int width, int height, int x, int y);
PixelPosition ballPosition(Ball ball, int width, int height, Vec3d direction);

}  // namespace shprt
