// How others write down the same function: their order, signs, folded factors and axes (docs/conventions.md
// has the tables and their sources).
#pragma once

#include <span>
#include <string>
#include <vector>

namespace shprt {

enum class Convention { kCondonShortley, kL1Vector, kThreeJs, kUnity, kUnreal, kFilament, kGltf };

struct ConventionFacts {
  Convention convention;
  const char* name;     // on the command line and in files
  int minimumDegree;    // layouts of fixed size hold this degree always, padded with zeros
  int maximumDegree;    // bands above it have no place there
  const char* order;    // of the values
  const char* meaning;  // what they are, and how the function is rebuilt from them
  const char* frame;    // their axes in terms of this project's right-handed, +Y-up ones
};

std::span<const ConventionFacts> allConventions();
const ConventionFacts& conventionFacts(Convention convention);
Convention parseConvention(const std::string& name);  // throws Error that lists the names

// Values that a function of this degree has; degree within the facts' limits.
int conventionSize(Convention convention, int degree);

// Coefficients of sh/basis.h, one colour, coefficientCount(degree) of them with degree within the facts'
// limits, to the convention's values and back. Signs and orders are exact, factors and exchanged axes to
// rounding (4e-16 of the largest coefficient of the band). Going back, a trace in R2 of l1-vector is taken
// out.
std::vector<double> toConvention(Convention convention, int degree, std::span<const double> coefficients);
std::vector<double> fromConvention(Convention convention, int degree, std::span<const double> values);

}  // namespace shprt
