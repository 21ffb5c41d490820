#include "shprt/transfer/direct_transfer.h"

#include <algorithm>

#include "shprt/sh/accumulate.h"
#include "shprt/sh/basis.h"
#include "shprt/transfer/hemisphere_tracer.h"
#include "shprt/transfer/point_errors.h"
#include "shprt/transfer/sample_tracer.h"

namespace shprt {

DirectTransfer::DirectTransfer(int degree, const UnshadowedTransfer& unshadowed, bool controlVariate)
    : degree_(degree),
      unshadowed_(unshadowed),
      controlVariate_(controlVariate),
      transfer_(static_cast<std::size_t>(coefficientCount(degree))),
      differences_(transfer_.size()) {}

template <class Tracer>
std::span<const double> DirectTransfer::evaluate(const Tracer& tracer) {
  const std::size_t rays = tracer.rays(), visible = tracer.visible();
  isExact_ = visible == 0 || (visible == rays && controlVariate_);
  if (visible == 0) {
    std::fill(transfer_.begin(), transfer_.end(), 0.0);
    return transfer_;
  }
  unshadowed_.evaluate(tracer.normal(), transfer_);
  if (isExact_) return transfer_;

  const double share = controlVariate_ ? static_cast<double>(visible) / static_cast<double>(rays) : 0;
  const std::size_t padded = (rays + kRayPacketSize - 1) / kRayPacketSize * kRayPacketSize;
  weights_.assign(padded, 0.0f);
  for (std::size_t ray = 0; ray < rays; ++ray) {
    weights_[ray] = static_cast<float>((tracer.seesSky(ray) ? 1 : 0) - share);
  }
  accumulateSh(degree_, tracer.x(), tracer.y(), tracer.z(), weights_.data(), padded, differences_.data());
  for (std::size_t i = 0; i < transfer_.size(); ++i) {
    transfer_[i] = share * transfer_[i] + differences_[i] / static_cast<double>(rays);
  }
  return transfer_;
}

// Mean over the rays of one part of the difference that was accumulated before.
template <class Tracer>
void DirectTransfer::sumPart(const Tracer& tracer, std::span<const std::uint8_t> parts, unsigned part,
                             std::vector<double>& mean) {
  for (std::vector<float>& values : partRays_) values.clear();
  for (std::size_t ray = 0; ray < parts.size(); ++ray) {
    if (parts[ray] != part) continue;
    partRays_[0].push_back(tracer.x()[ray]);
    partRays_[1].push_back(tracer.y()[ray]);
    partRays_[2].push_back(tracer.z()[ray]);
    partRays_[3].push_back(weights_[ray]);
  }
  mean.assign(transfer_.size(), 0.0);
  const auto rays = static_cast<double>(partRays_[3].size());
  if (rays == 0) return;
  while (partRays_[3].size() % kAccumulateLanes != 0) {
    for (std::size_t i = 0; i < 3; ++i) partRays_[i].push_back(partRays_[i].back());
    partRays_[3].push_back(0);
  }
  accumulateSh(degree_, partRays_[0].data(), partRays_[1].data(), partRays_[2].data(), partRays_[3].data(),
               partRays_[3].size(), mean.data());
  for (double& value : mean) value /= rays;
}

template <class Tracer>
DirectTransfer::Parts DirectTransfer::parts(const Tracer& tracer, bool withSixteenths) {
  Parts result;
  for (std::size_t i = 0; i < 3; ++i) {
    contrasts_[i].assign(transfer_.size(), 0.0);
    result.contrasts[i] = contrasts_[i];
  }
  if (isExact_) return result;
  for (unsigned quarter = 0; quarter < 4; ++quarter)
    sumPart(tracer, tracer.quarters(), quarter, quarters_[quarter]);
  for (std::size_t i = 0; i < transfer_.size(); ++i) {
    const auto contrasts = contrastsOf(quarters_[0][i], quarters_[1][i], quarters_[2][i], quarters_[3][i]);
    for (std::size_t k = 0; k < 3; ++k) contrasts_[k][i] = contrasts[k];
  }
  if (!withSixteenths) return result;
  for (unsigned quarter = 0; quarter < 4; ++quarter) {
    for (unsigned part = 0; part < 4; ++part)
      sumPart(tracer, tracer.sixteenths(), 4 * quarter + part, sixteenths_[part]);
    for (std::size_t i = 0; i < transfer_.size(); ++i)
      for (const double contrast :
           contrastsOf(sixteenths_[0][i], sixteenths_[1][i], sixteenths_[2][i], sixteenths_[3][i]))
        result.sixteenthSquare += contrast * contrast / 4;
  }
  return result;
}

template std::span<const double> DirectTransfer::evaluate(const HemisphereTracer&);
template std::span<const double> DirectTransfer::evaluate(const SampleTracer&);
template DirectTransfer::Parts DirectTransfer::parts(const HemisphereTracer&, bool);

}  // namespace shprt
