// How numbers in files stand for light: proportionally, or along the curve of sRGB.
// Based on: IEC 61966-2-1.
#pragma once

#include "shprt/base/vec.h"

namespace shprt {

enum class ColourSpace { kLinear, kSrgb };

// From sRGB in [0,1] to linear light, for each channel; the curve is continued outside.
Vec3f decodeSrgb(Vec3f colour);

}  // namespace shprt
