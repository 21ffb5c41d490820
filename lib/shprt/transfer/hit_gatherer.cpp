#include "shprt/transfer/hit_gatherer.h"

#include <algorithm>
#include <cassert>

namespace shprt {

HitGatherer::HitGatherer(const LightLayout& layout, const LightRows& sources,
                         std::span<const Triangle> triangles)
    : layout_(layout),
      sources_(sources),
      triangles_(triangles),
      partial_(sources.stride()),
      interpolated_(sources.stride()),
      sums_(sources.stride()) {}

void HitGatherer::addHit(const CompactHit& hit, float* sums) const {
  constexpr float kStep = 1.0f / CompactHit::kSteps;
  const Triangle& triangle = triangles_[hit.triangle];
  const float* __restrict a = sources_.row(triangle[0]);
  const float* __restrict b = sources_.row(triangle[1]);
  const float* __restrict c = sources_.row(triangle[2]);
  const float u = static_cast<float>(hit.u) * kStep, v = static_cast<float>(hit.v) * kStep;
  const float w = static_cast<float>(CompactHit::kSteps - hit.u - hit.v) * kStep;
  float* __restrict out = sums;
  for (std::size_t column = 0; column < sources_.stride(); ++column)
    out[column] += w * a[column] + u * b[column] + v * c[column];
}

void HitGatherer::addHit(const CompactHit& hit, const CompactAlbedo& albedo, float* sums) {
  std::fill(interpolated_.begin(), interpolated_.end(), 0.0f);
  addHit(hit, interpolated_.data());
  const Vec3f reflected = albedo.toFloat();
  const float channelAlbedo[3] = {reflected.x, reflected.y, reflected.z};
  for (int i = 0; i < layout_.bandCount(); ++i) {
    const LightLayout::Band band = layout_.band(i);
    for (std::size_t column = band.first; column < band.end; ++column)
      sums[column] += channelAlbedo[band.albedoChannel] * interpolated_[column];
  }
}

void HitGatherer::gather(std::span<const CompactHit> hits, std::span<const CompactAlbedo> albedo,
                         std::size_t rays, float* row) {
  assert(albedo.empty() || albedo.size() == hits.size());
  constexpr std::size_t kFold = 16;
  std::fill(sums_.begin(), sums_.end(), 0.0);
  for (std::size_t first = 0; first < hits.size(); first += kFold) {
    std::fill(partial_.begin(), partial_.end(), 0.0f);
    for (std::size_t i = first; i < std::min(first + kFold, hits.size()); ++i) {
      if (albedo.empty()) {
        addHit(hits[i], partial_.data());
      } else {
        addHit(hits[i], albedo[i], partial_.data());
      }
    }
    for (std::size_t column = 0; column < sums_.size(); ++column)
      sums_[column] += static_cast<double>(partial_[column]);
  }
  for (std::size_t column = 0; column < sums_.size(); ++column)
    row[column] = static_cast<float>(sums_[column] / static_cast<double>(rays));
}

}  // namespace shprt
