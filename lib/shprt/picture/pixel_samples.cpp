#include "shprt/picture/pixel_samples.h"

#include <cassert>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace shprt {
namespace {

// The inverse of the tent's distribution function: u in (0,1) to an offset in (-1,1), odd about u = 1/2.
double invertTent(double u) {
  return u < 0.5 ? std::sqrt(2 * u) - 1 : 1 - std::sqrt(2 * (1 - u));
}

}  // namespace

std::vector<PixelOffset> tentOffsets(int count) {
  assert(count >= 1);
  std::vector<PixelOffset> offsets(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) {
    // Point count-1-i is the mirror image of point i: both coordinates are odd in the distance from the
    // middle index.
    const double fromMiddle = i - 0.5 * (count - 1);
    const double turns = fromMiddle * std::numbers::phi;
    const double fraction = 0.5 + turns - std::round(turns);
    offsets[static_cast<std::size_t>(i)] = {invertTent(0.5 + fromMiddle / count), invertTent(fraction)};
  }
  return offsets;
}

}  // namespace shprt
