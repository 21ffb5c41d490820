#include "shprt/transfer/edge_smoothing.h"

#include <algorithm>
#include <cassert>
#include <vector>

namespace shprt {

void smoothOverEdges(const SurfaceTopology& topology, std::span<const std::uint8_t> isLeftOut, int times,
                     std::size_t columns, std::span<float> values) {
  assert(values.size() == isLeftOut.size() * columns);
  const auto pointIds = topology.pointIds();
  std::vector<float> counts(isLeftOut.size(), 2.0f), sums(values.size());
  const auto forEdges = [&](const auto& visit) {
    for (const Triangle& triangle : topology.triangles())
      for (std::size_t corner = 0; corner < 3; ++corner)
        for (const std::size_t next : {(corner + 1) % 3, (corner + 2) % 3}) {
          const std::uint32_t to = pointIds[triangle[corner]], from = pointIds[triangle[next]];
          if (!isLeftOut[to] && !isLeftOut[from]) visit(to, from);
        }
  };
  forEdges([&](std::uint32_t to, std::uint32_t) { counts[to] += 1; });
  for (int time = 0; time < times; ++time) {
    std::transform(values.begin(), values.end(), sums.begin(), [](float value) { return 2 * value; });
    forEdges([&](std::uint32_t to, std::uint32_t from) {
      for (std::size_t column = 0; column < columns; ++column)
        sums[to * columns + column] += values[from * columns + column];
    });
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = sums[i] / counts[i / columns];
  }
}

}  // namespace shprt
