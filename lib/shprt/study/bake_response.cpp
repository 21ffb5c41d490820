#include "shprt/study/bake_response.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "shprt/light/project_probe.h"
#include "shprt/relight/relight.h"

namespace shprt {

std::vector<float> responseOf(const TransferAsset& asset, const LightCoefficients* light, int degree) {
  std::vector<float> response;
  if (light) {
    const std::vector<Vec3f> radiance =
        relight(asset, withDegree(*light, std::min(degree, light->degree)), 1);
    response.reserve(radiance.size() * 3);
    for (const Vec3f& value : radiance) response.insert(response.end(), {value.x, value.y, value.z});
    return response;
  }
  const TransferCoefficients& transfer = asset.transfer;
  assert(degree <= transfer.degree);
  const auto count = static_cast<std::size_t>(coefficientCount(degree)) * transfer.vertexCount;
  response.reserve(static_cast<std::size_t>(transfer.channels) * count);
  for (int channel = 0; channel < transfer.channels; ++channel) {
    const float* rows = transfer.row(channel, 0);
    response.insert(response.end(), rows, rows + count);
  }
  return response;
}

double normOf(const std::vector<float>& response) {
  double sum = 0;
  for (const float value : response) sum += static_cast<double>(value) * static_cast<double>(value);
  return std::sqrt(sum);
}

double distanceOf(const std::vector<float>& a, const std::vector<float>& b) {
  assert(a.size() == b.size());
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const double difference = static_cast<double>(a[i]) - static_cast<double>(b[i]);
    sum += difference * difference;
  }
  return std::sqrt(sum);
}

}  // namespace shprt
