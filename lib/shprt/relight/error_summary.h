// Standard errors of radiance, in a few figures.
#pragma once

#include <cstddef>
#include <span>

#include "shprt/base/vec.h"

namespace shprt {

// Over vertices and colours, in units of radiance.
struct ErrorSummary {
  double rmsRadiance = 0;
  double rms = 0;                 // of the standard errors
  double largest = 0;             // single one
  std::size_t largestVertex = 0;  // the first that has it
};

// Both have an entry per vertex, as relight() and relightError() give them; standard errors are not negative.
ErrorSummary summariseErrors(std::span<const Vec3f> radiance, std::span<const Vec3f> standardErrors);

}  // namespace shprt
