// Jittered directions against the cells that their header defines.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "disc_integrands.h"
#include "shprt/sampling/jittered_hemisphere.h"

namespace shprt {
namespace {

// Back to the square: u is the squared distance from the axis, v the azimuth in turns.
struct Square {
  double u, v;
};
Square squareOf(Vec3d direction) {
  const double turns = std::atan2(direction.y, direction.x) / (2 * std::numbers::pi);
  return {1 - direction.z * direction.z, turns - std::floor(turns)};
}

TEST(JitteredHemisphere, PutsOneDirectionIntoEachCell) {
  for (const int count : {1, 2, 3, 10, 16, 100, 128, 200, 256, 1000}) {
    const JitteredHemisphere set(count, 16);
    const int rows = static_cast<int>(std::lround(std::sqrt(count)));
    std::vector<int> rowBegin;
    for (int row = 0; row <= rows; ++row) rowBegin.push_back(row * count / rows);
    for (std::uint64_t index = 0; index < 20; ++index) {
      std::vector<int> inCell(static_cast<std::size_t>(count));
      int onEdge = 0;
      for (const Vec3d direction : test::directionsOf(set, 8, index)) {
        const Square p = squareOf(direction);
        int row = 0;
        while (row + 1 < rows && p.u * count >= rowBegin[static_cast<std::size_t>(row) + 1]) ++row;
        const int begin = rowBegin[static_cast<std::size_t>(row)];
        const int cells = rowBegin[static_cast<std::size_t>(row) + 1] - begin;
        // Directions are floats, and may have been rounded over an edge of their cell.
        const double column = p.v * cells;
        onEdge += std::abs(column - std::round(column)) < 1e-4;
        for (const int edge : rowBegin) onEdge += std::abs(p.u * count - edge) < 1e-3;
        ++inCell[static_cast<std::size_t>(begin + std::min(static_cast<int>(column), cells - 1))];
      }
      int missing = 0;
      for (const int directions : inCell) missing += directions == 0;
      EXPECT_LE(missing, onEdge) << count;
    }
  }
}

// In a square grid with an even number of rows, the cells of a quarter are every second of every second row,
// and the halves are the colours of a chessboard.
TEST(JitteredHemisphere, CutsSquareGridsLikeAChessboard) {
  constexpr int kSide = 8;
  const JitteredHemisphere set(kSide * kSide, 16);
  const auto directions = test::directionsOf(set, 1, 1);
  int quarterAt[2][2] = {{-1, -1}, {-1, -1}};
  for (std::size_t i = 0; i < directions.size(); ++i) {
    const Square p = squareOf(directions[i]);
    const int row = static_cast<int>(p.u * kSide), column = static_cast<int>(p.v * kSide);
    int& quarter = quarterAt[row % 2][column % 2];
    if (quarter < 0) quarter = set.quarters()[i];
    EXPECT_EQ(quarter, set.quarters()[i]);
    EXPECT_EQ((row + column) % 2, set.quarters()[i] / 2);
  }
}

}  // namespace
}  // namespace shprt
