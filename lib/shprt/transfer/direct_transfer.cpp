#include "shprt/transfer/direct_transfer.h"

#include <algorithm>

#include "shprt/sh/accumulate.h"
#include "shprt/sh/basis.h"
#include "shprt/transfer/hemisphere_tracer.h"
#include "shprt/transfer/sample_tracer.h"

namespace shprt {

DirectTransfer::DirectTransfer(int degree, const UnshadowedTransfer& unshadowed)
    : degree_(degree),
      unshadowed_(unshadowed),
      transfer_(static_cast<std::size_t>(coefficientCount(degree))),
      differences_(transfer_.size()) {}

template <class Tracer>
std::span<const double> DirectTransfer::evaluate(const Tracer& tracer) {
  const std::size_t rays = tracer.rays(), visible = tracer.visible();
  if (visible == 0) {
    std::fill(transfer_.begin(), transfer_.end(), 0.0);
    return transfer_;
  }
  unshadowed_.evaluate(tracer.normal(), transfer_);
  if (visible == rays) return transfer_;

  const double share = static_cast<double>(visible) / static_cast<double>(rays);
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

template std::span<const double> DirectTransfer::evaluate(const HemisphereTracer&);
template std::span<const double> DirectTransfer::evaluate(const SampleTracer&);

}  // namespace shprt
