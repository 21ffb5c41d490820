// Quadrature weights for the pixels of balls.
#pragma once

#include <vector>

#include "shprt/image/environment.h"

namespace shprt {

// Factors of the pixels' solid angles as a Legendre series in z, the axis of both balls: with them, sums over
// the pixels of a width x height ball integrate every Legendre polynomial of z up to some degree exactly.
class BallWeights {
 public:
  // degree is the highest that products of the functions to be summed have. Pictures too coarse for it get
  // less; the series never leaves [1/4, 4].
  BallWeights(EnvironmentLayout ball, int width, int height, int degree);

  // Up to which degree sums are exact; 0 leaves only their total.
  int degree() const { return static_cast<int>(series_.size()) - 1; }
  double factor(double z) const;

 private:
  std::vector<double> series_;
};

}  // namespace shprt
