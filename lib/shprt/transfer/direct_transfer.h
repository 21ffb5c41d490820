// Transfer of light that comes straight from the sky, from the rays of one point.
//
// What is estimated by rays is only the difference from a known integral: with a the point's visible share,
// T = a U + mean((V - a) y), U being the unshadowed transfer. Points that see everything or nothing come out
// exact, and few rays gain most. (a is measured from the same rays, which leaves a bias of the order of the
// squared error.)
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "shprt/transfer/transfer_rows.h"

namespace shprt {

class DirectTransfer {
 public:
  // unshadowed must outlive it and be of the same degree. Without controlVariate, T = mean(V y).
  DirectTransfer(int degree, const UnshadowedTransfer& unshadowed, bool controlVariate = true);

  // Mean of visibility times y_lm over the cosine-weighted hemisphere of the point traced last:
  // coefficientCount(degree) numbers, per unit albedo, good until the next call. For HemisphereTracer and
  // SampleTracer.
  template <class Tracer>
  std::span<const double> evaluate(const Tracer& tracer);

  // What the quarters of the rays give for the point evaluated last (with the same a) as contrasts
  // (point_errors.h), and how far sixteenths are from their quarters: the mean over all of them of the
  // squared norm of the difference; 0 unless asked for. For HemisphereTracer.
  struct Parts {
    std::array<std::span<const double>, 3> contrasts;  // per coefficient, good until the next call
    double sixteenthSquare = 0;
  };
  template <class Tracer>
  Parts parts(const Tracer& tracer, bool withSixteenths);

 private:
  template <class Tracer>
  void sumPart(const Tracer& tracer, std::span<const std::uint8_t> parts, unsigned part,
               std::vector<double>& mean);

  int degree_;
  const UnshadowedTransfer& unshadowed_;
  bool controlVariate_;
  bool isExact_ = true;
  std::vector<float> weights_;
  std::vector<double> transfer_, differences_;
  std::array<std::vector<float>, 4> partRays_;  // x, y, z, weight
  std::array<std::vector<double>, 4> quarters_, sixteenths_;
  std::array<std::vector<double>, 3> contrasts_;
};

}  // namespace shprt
