#include "shprt/image/colour_space.h"

#include <cmath>

namespace shprt {
namespace {

float decodeChannel(float value) {
  return value <= 0.04045f ? value / 12.92f : std::pow((value + 0.055f) / 1.055f, 2.4f);
}

}  // namespace

Vec3f decodeSrgb(Vec3f colour) {
  return {decodeChannel(colour.x), decodeChannel(colour.y), decodeChannel(colour.z)};
}

}  // namespace shprt
