#include "shprt/relight/error_summary.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace shprt {
namespace {

double rms(std::span<const Vec3f> vectors) {
  if (vectors.empty()) return 0;
  double sum = 0;
  for (const Vec3f& v : vectors) sum += dot(toDouble(v), toDouble(v));
  return std::sqrt(sum / (3 * static_cast<double>(vectors.size())));
}

}  // namespace

ErrorSummary summariseErrors(std::span<const Vec3f> radiance, std::span<const Vec3f> standardErrors) {
  assert(radiance.size() == standardErrors.size());
  ErrorSummary summary;
  summary.rmsRadiance = rms(radiance);
  summary.rms = rms(standardErrors);
  for (std::size_t v = 0; v < standardErrors.size(); ++v) {
    const Vec3d error = toDouble(standardErrors[v]);
    const double largest = std::max({error.x, error.y, error.z});
    if (largest > summary.largest) summary.largest = largest, summary.largestVertex = v;
  }
  return summary;
}

}  // namespace shprt
