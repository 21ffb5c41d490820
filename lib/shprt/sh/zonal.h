// Zonal functions, those that depend on one angle only, by their band factors.
#pragma once

#include <vector>

#include "shprt/base/vec.h"

namespace shprt {

// Band factors A_l = 2 pi * integral_0^1 t P_l(t) dt of the clamped cosine, l = 0..degree: pi, 2pi/3, pi/4,
// 0, -pi/24, ... Convolution with the clamped cosine multiplies band l by A_l. Based on: Ramamoorthi and
// Hanrahan 2001, eq. 8.
std::vector<double> clampedCosineFactors(int degree);

}  // namespace shprt
