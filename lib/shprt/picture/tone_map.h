// Linear radiance to display values.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "shprt/base/vec.h"
#include "shprt/image/image.h"

namespace shprt {

// Of linear Rec.709.
float luminance(Vec3f rgb);
// The exposure (a factor) that brings the given percentile of luminance to 0.9: for pictures when none is
// asked for.
float autoExposure(std::span<const Vec3f> radiance);
// sRGB transfer function (IEC 61966-2-1) of exposure * linear, clamped to [0,1].
Vec3f encodeSrgb(Vec3f linear, float exposure);
std::array<std::uint8_t, 3> encodeSrgb8(Vec3f linear, float exposure);
Image encodeSrgb(const Image& linear, float exposure);

}  // namespace shprt
