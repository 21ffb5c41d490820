// What a light looks like, for people and for machines.
#pragma once

#include <array>
#include <string>

#include "console.h"
#include "output.h"
#include "shprt/coefficients/light_coefficients.h"

namespace shprt {

// "0.123 0.456 0.789"
std::string formatTriple(const std::array<double, 3>& values);

// Average radiance, dominant direction, directionality, dominant light with its ambient rest, and energy per
// band.
void printLight(const Console& console, const LightCoefficients& light);
Json lightStatisticsJson(const LightCoefficients& light);

}  // namespace shprt
