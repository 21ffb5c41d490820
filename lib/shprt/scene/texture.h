// Looking up a picture that is wrapped around a surface.
#pragma once

#include "shprt/base/vec.h"
#include "shprt/image/image.h"

namespace shprt {

// Bilinear, repeating in both directions. Texture coordinates as mesh files give them: (0, 0) is the lower
// left corner of the picture, (1, 1) the upper right.
Vec3f sampleTexture(const Image& image, Vec2f coordinates);

}  // namespace shprt
