#include "shprt/sampling/jittered_hemisphere.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

#include "shprt/sampling/hemisphere.h"
#include "shprt/sampling/neighbour_order.h"
#include "shprt/sampling/random.h"

namespace shprt {

JitteredHemisphere::JitteredHemisphere(int count, int groupSize) {
  assert(count >= 1 && groupSize >= 1);
  const int rows = static_cast<int>(std::lround(std::sqrt(count)));
  const auto rowBegin = [&](int row) {
    return static_cast<int>(static_cast<std::int64_t>(row) * count / rows);
  };
  // A path that walks up and down through the cells of two rows meets the places of a block of two by two in
  // turn, so that counting along it makes the quarters equal whatever the lengths of the rows.
  std::vector<Cell> path;
  for (int pair = 0; pair < rows; pair += 2) {
    const int pairEnd = std::min(pair + 2, rows);
    const int columns =
        std::max(rowBegin(pair + 1) - rowBegin(pair), rowBegin(pairEnd) - rowBegin(pairEnd - 1));
    for (int column = 0; column < columns; ++column)
      for (int step = pair; step < pairEnd; ++step) {
        const int row = column % 2 == 0 ? step : pair + pairEnd - 1 - step;
        const int begin = rowBegin(row), cells = rowBegin(row + 1) - begin;
        if (column >= cells) continue;
        path.push_back({static_cast<double>(begin) / count, static_cast<double>(column) / cells,
                        static_cast<double>(cells) / count, 1.0 / cells});
      }
  }
  assert(path.size() == static_cast<std::size_t>(count));

  std::vector<DiscPoint> centres;
  for (const Cell& cell : path) {
    const double radius = std::sqrt(cell.u + cell.height / 2);
    const double azimuth = 2 * std::numbers::pi * (cell.v + cell.width / 2);
    centres.push_back({radius * std::cos(azimuth), radius * std::sin(azimuth)});
  }
  for (const int i : orderByNeighbours(centres, groupSize)) {
    cells_.push_back(path[static_cast<std::size_t>(i)]);
    quarters_.push_back(quarterInTurn(static_cast<std::size_t>(i)));
    sixteenths_.push_back(sixteenthInTurn(static_cast<std::size_t>(i)));
  }
  cells_.resize(wholeGroups(count, groupSize), cells_.back());
}

void JitteredHemisphere::directions(Vec3d normal, std::uint64_t seed, std::uint64_t index, float* x, float* y,
                                    float* z) const {
  const std::uint64_t key = hashCounter(seed, index);
  const Frame frame = frameFromNormal(normal);
  for (std::size_t slot = 0; slot < cells_.size(); ++slot) {
    const Cell& cell = cells_[slot];
    const SquarePoint p = randomPoint(key, std::min(slot, quarters_.size() - 1));
    const Vec3f direction =
        cosineDirectionAround(frame, cell.u + cell.height * p.u, cell.v + cell.width * p.v);
    x[slot] = direction.x, y[slot] = direction.y, z[slot] = direction.z;
  }
}

}  // namespace shprt
