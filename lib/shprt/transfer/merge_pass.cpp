#include "shprt/transfer/merge_pass.h"

#include <cassert>
#include <cstddef>

namespace shprt {
namespace {

float mix(float a, float b, double share) {
  return static_cast<float>(static_cast<double>(a) +
                            share * (static_cast<double>(b) - static_cast<double>(a)));
}

}  // namespace

void mergePass(const Bake& before, const PointErrors& errorsBefore, double errorBefore, Bake& bake,
               PointErrors& errors, double error) {
  assert(before.transfer.values.size() == bake.transfer.values.size());
  if (!(errorBefore > 0)) return;
  const double share = error * error / (error * error + errorBefore * errorBefore);  // of the earlier
  for (std::size_t i = 0; i < bake.transfer.values.size(); ++i)
    bake.transfer.values[i] = mix(bake.transfer.values[i], before.transfer.values[i], share);
  for (std::size_t i = 0; i < bake.emission.size(); ++i) {
    const Vec3f from = bake.emission[i], to = before.emission[i];
    bake.emission[i] = {mix(from.x, to.x, share), mix(from.y, to.y, share), mix(from.z, to.z, share)};
  }
  for (std::size_t point = 0; point < errors.rays.size(); ++point) {
    for (std::size_t column = 0; column < errors.squares.stride(); ++column) {
      float& square = errors.squares.row(point)[column];
      square =
          static_cast<float>((1 - share) * (1 - share) * static_cast<double>(square) +
                             share * share * static_cast<double>(errorsBefore.squares.row(point)[column]));
    }
    errors.rays[point] += errorsBefore.rays[point];
  }
}

}  // namespace shprt
