// Reference values in quadruple precision (113 bits, 34 digits), by the plainest formulas that hold at that
// width.
#pragma once

#include <vector>

#include "shprt/base/vec.h"

namespace shprt::numerics {

using Quad = __float128;

// y_lm at a direction for all l <= degree, in the flat order of the project. The direction need only be
// nearly of unit length: what is evaluated is y(u / |u|), so a rounded direction has an exact reference.
std::vector<Quad> referenceBasis(int degree, Vec3d direction);
// The same at direction + step * offset.
std::vector<Quad> referenceBasis(int degree, Vec3d direction, Vec3d offset, Quad step);

// d^l(beta) for one band, rows m and columns n from -l to l, as Wigner's matrices of the complex harmonics.
class ReferenceWigner {
 public:
  explicit ReferenceWigner(Quad beta);
  // From band l to l + 1.
  void climb();
  int band() const { return band_; }
  Quad at(int m, int n) const;

 private:
  void halfStep();

  Quad cosine_, sine_;
  int twiceJ_ = 0, band_ = 0;
  std::vector<Quad> entries_;
};

// The real matrix D of one band, (2l+1)^2 in rows: y_l(R u) = D y_l(u) for R = Rz(alpha) Ry(beta) Rz(gamma).
// wigner stands at band l of the same beta.
std::vector<Quad> referenceRotation(const ReferenceWigner& wigner, Quad alpha, Quad gamma);

// Euler angles of the rotation nearest to a matrix: R = Rz(alpha) Ry(beta) Rz(gamma), in radians.
struct ReferenceAngles {
  Quad alpha, beta, gamma;
};
ReferenceAngles referenceAngles(const Mat3& matrix);

// Integrals of P_l over a cap of radius zeta, divided by its height: the factors of a circular window.
std::vector<Quad> referenceWindow(int degree, Quad zeta);

Quad quadPi();
Quad quadSqrt(Quad x);
Quad quadSin(Quad x);
Quad quadCos(Quad x);

}  // namespace shprt::numerics
