// Spherical harmonics as polynomials of x, y, z: y_lm = H_lm(z, s) Re or Im (x + iy)^|m|, with s = x^2 + y^2.
//
// H_lm is homogeneous: a sum of c_k z^(n-2k) s^k, n = l - |m|. Written so, little cancels (the terms of y_80
// add up to 3.2 times its largest value, those of powers of z alone to 208 times), and beside a pole the
// small s holds the angle that z has rounded away. So float code from it errs by 6e-7 sqrt((2l+1)/4pi) at
// degree 8 and 2.5e-6 at 12, poles included; unrolled three-term recurrences in z measure 2.3e-6 and 4.8e-6,
// Horner's scheme in z^2 8.8e-6 and 2e-4. A direction of length r gives r^l times the value.
//
// c_{k+1} / c_k follows from Laplace's equation for z^(n-2k) s^k (x + iy)^m, c_0 from the normalisation.
#pragma once

#include <vector>

namespace shprt {

// c_0 .. c_{n/2} of H_lm, for 0 <= |m| <= l <= 32, correct to a few units in the last place of a double.
std::vector<double> solidHarmonic(int l, int m);

}  // namespace shprt
