// Transfer of light that comes straight from the sky, from the rays of one point.
//
// What is estimated by rays is only the difference from a known integral: with a the point's visible share,
// T = a U + mean((V - a) y), U being the unshadowed transfer. Points that see everything or nothing come out
// exact, and few rays gain most. (a is measured from the same rays, which leaves a bias of the order of the
// squared error.)
#pragma once

#include <span>
#include <vector>

#include "shprt/transfer/transfer_rows.h"

namespace shprt {

class DirectTransfer {
 public:
  // unshadowed must outlive it and be of the same degree.
  DirectTransfer(int degree, const UnshadowedTransfer& unshadowed);

  // Mean of visibility times y_lm over the cosine-weighted hemisphere of the point traced last:
  // coefficientCount(degree) numbers, per unit albedo, good until the next call. For HemisphereTracer and
  // SampleTracer.
  template <class Tracer>
  std::span<const double> evaluate(const Tracer& tracer);

 private:
  int degree_;
  const UnshadowedTransfer& unshadowed_;
  std::vector<float> weights_;
  std::vector<double> transfer_, differences_;
};

}  // namespace shprt
