// What projecting a probe adds up over pixels, apart from the layout.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "shprt/base/vec.h"

namespace shprt {

// Sums of a block of rows. Blocks are added in order, so the result does not depend on threads.
struct ProbeSums {
  std::vector<std::array<double, 3>> coefficients;
  std::uint64_t pixels = 0, nonFinite = 0, negative = 0;
  double solidAngle = 0;  // of the pixels used
  double weight = 0;      // of the pixels used, in the sums
  std::array<double, 3> energy{};

  explicit ProbeSums(std::size_t count) : coefficients(count) {}

  void add(const ProbeSums& part);
};

// Whether a pixel can be used; counts it and makes its radiance what the sums shall see.
bool mendPixel(const Vec3f& pixel, bool clampNegative, std::array<double, 3>& radiance, ProbeSums& sums);

}  // namespace shprt
