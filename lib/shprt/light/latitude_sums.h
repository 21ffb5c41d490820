// Sums over latitude-longitude pictures, which separate into longitude and latitude.
#pragma once

#include <cstddef>
#include <vector>

#include "shprt/image/image.h"
#include "shprt/light/probe_sums.h"

namespace shprt {

class LatitudeSums {
 public:
  // Tables for pictures of that width.
  LatitudeSums(int degree, int width);

  // Adds rows [begin, end) of the image to sums, as coefficients about the picture's own pole: in their frame
  // x is +Z, y is +X and z is +Y of the world.
  void addRows(const Image& image, int begin, int end, bool clampNegative, ProbeSums& sums) const;

 private:
  int degree_, width_;
  std::size_t half_;                     // columns of the left half, where longitudes are positive
  std::size_t columns_;                  // that remain once the row is folded onto itself
  std::vector<double> cosines_, sines_;  // of m times their longitude, [m][column]
};

}  // namespace shprt
