// Three steps, each undone in the opposite order: the axes, by way of moments, on which a signed permutation
// of axes acts exactly; the Condon-Shortley sign; the factors folded into each value. Based on: the engines'
// own sources, listed in docs/conventions.md.

#include "shprt/sh/convention.h"

#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "shprt/base/error.h"
#include "shprt/base/vec.h"
#include "shprt/sh/basis.h"
#include "shprt/sh/moments.h"
#include "shprt/sh/zonal.h"

namespace shprt {
namespace {

constexpr const char* kFlatOrder = "l(l+1)+m";

constexpr std::array<ConventionFacts, 7> kFacts = {{
    {Convention::kCondonShortley, "condon-shortley", 0, 4096, kFlatOrder,
     "radiance, coefficients of the real orthonormal basis with Condon-Shortley phase: y_lm times (-1)^m",
     "right-handed, +Y up: x, y, z"},
    {Convention::kL1Vector, "l1-vector", 0, 2, "R0; R1 x, y, z; R2 xx, yy, zz, xy, xz, yz",
     "radiance: averages over the sphere of L, L w and L (w w^T - I/3); L(w) = R0 + 3 R1.w + 15/2 w.R2 w",
     "right-handed, +Y up: x, y, z"},
    {Convention::kThreeJs, "three.js", 2, 2, kFlatOrder,
     "radiance, coefficients as SphericalHarmonics3 and LightProbe hold them: real orthonormal, no "
     "Condon-Shortley phase",
     "right-handed, +Y up: x, y, z"},
    {Convention::kUnity, "unity", 2, 2, kFlatOrder,
     "irradiance / pi, as SphericalHarmonicsL2 holds it: values of 1, y, z, x, xy, yz, 3z^2-1, xz, x^2-y^2 "
     "of the normal",
     "left-handed, +Y up: -x, y, z"},
    {Convention::kUnreal, "unreal", 2, 2, kFlatOrder,
     "radiance, coefficients as FSHVector3 holds them: real orthonormal with Condon-Shortley phase",
     "left-handed, +Z up: x, z, y"},
    {Convention::kFilament, "filament", 2, 2, kFlatOrder,
     "irradiance / pi, as IndirectLight::Builder::irradiance takes it: values of 1, y, z, x, xy, yz, 3z^2-1, "
     "xz, x^2-y^2 of the normal",
     "right-handed, +Y up: x, y, z"},
    {Convention::kGltf, "gltf", 2, 2, kFlatOrder,
     "irradiance, coefficients as EXT_lights_image_based holds them: real orthonormal, without "
     "Condon-Shortley "
     "phase as in the paper it cites (Babylon.js reads them with the phase)",
     "right-handed, +Y up: x, y, z"},
}};

bool hasPhase(Convention convention) {
  return convention == Convention::kCondonShortley || convention == Convention::kUnreal;
}

// Irradiance over pi by plain polynomials of the normal.
bool holdsPolynomials(Convention convention) {
  return convention == Convention::kUnity || convention == Convention::kFilament;
}

// From this project's axes to the convention's; both are their own inverses.
Mat3 axesOf(Convention convention) {
  if (convention == Convention::kUnity) return {{{-1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  if (convention == Convention::kUnreal) return {{{1, 0, 0}, {0, 0, 1}, {0, 1, 0}}};
  return {};
}

std::vector<double> exchangeAxes(Convention convention, int degree, std::span<const double> coefficients) {
  const Mat3 axes = axesOf(convention);
  if (axes == Mat3{}) return {coefficients.begin(), coefficients.end()};
  return coefficientsOf(transformMoments(momentsOf(coefficients), axes), degree);
}

// y_lm = constant times one of 1, y, z, x, xy, yz, 3z^2-1, xz, x^2-y^2.
double polynomialConstant(int i) {
  using std::numbers::inv_pi;
  if (i == 0) return std::sqrt(inv_pi / 4);
  if (i < 4) return std::sqrt(3 * inv_pi / 4);
  if (i == 6) return std::sqrt(5 * inv_pi / 16);
  return std::sqrt(15 * inv_pi / (i == 8 ? 16 : 4));
}

// What coefficient i is multiplied by.
std::vector<double> factorsOf(Convention convention, int degree) {
  std::vector<double> factors(static_cast<std::size_t>(coefficientCount(degree)), 1.0);
  const std::vector<double> cosine = clampedCosineFactors(degree);
  for (int l = 0; l <= degree; ++l)
    for (int m = -l; m <= l; ++m) {
      double& factor = factors[static_cast<std::size_t>(shIndex(l, m))];
      if (hasPhase(convention) && m % 2 != 0) factor = -1;
      if (convention == Convention::kGltf) factor = cosine[static_cast<std::size_t>(l)];
      if (holdsPolynomials(convention))
        factor *=
            cosine[static_cast<std::size_t>(l)] * std::numbers::inv_pi * polynomialConstant(shIndex(l, m));
    }
  return factors;
}

std::vector<double> toValues(const Moments& moments, int degree) {
  const Vec3d& v = moments.vector;
  const auto& m = moments.matrix.m;
  std::vector<double> values = {moments.mean, v.x,     v.y,     v.z,     m[0][0],
                                m[1][1],      m[2][2], m[0][1], m[0][2], m[1][2]};
  values.resize(static_cast<std::size_t>(conventionSize(Convention::kL1Vector, degree)));
  return values;
}

Moments toMoments(std::span<const double> values) {
  Moments moments;
  moments.mean = values[0];
  if (values.size() > 1) moments.vector = {values[1], values[2], values[3]};
  if (values.size() > 4)
    moments.matrix = {{{values[4], values[7], values[8]},
                       {values[7], values[5], values[9]},
                       {values[8], values[9], values[6]}}};
  return moments;
}

}  // namespace

std::span<const ConventionFacts> allConventions() {
  return kFacts;
}

const ConventionFacts& conventionFacts(Convention convention) {
  return kFacts[static_cast<std::size_t>(convention)];
}

Convention parseConvention(const std::string& name) {
  std::string known;
  for (const ConventionFacts& facts : kFacts) {
    if (name == facts.name) return facts.convention;
    known += (known.empty() ? "" : ", ") + std::string(facts.name);
  }
  throw Error("convention '" + name.substr(0, 40) + "'", "is not known", "use one of " + known);
}

int conventionSize(Convention convention, int degree) {
  return coefficientCount(degree) + (convention == Convention::kL1Vector && degree == 2 ? 1 : 0);
}

std::vector<double> toConvention(Convention convention, int degree, std::span<const double> coefficients) {
  assert(degree >= conventionFacts(convention).minimumDegree &&
         degree <= conventionFacts(convention).maximumDegree);
  assert(coefficients.size() == static_cast<std::size_t>(coefficientCount(degree)));
  if (convention == Convention::kL1Vector) return toValues(momentsOf(coefficients), degree);
  std::vector<double> values = exchangeAxes(convention, degree, coefficients);
  const std::vector<double> factors = factorsOf(convention, degree);
  for (std::size_t i = 0; i < values.size(); ++i) values[i] *= factors[i];
  return values;
}

std::vector<double> fromConvention(Convention convention, int degree, std::span<const double> values) {
  assert(degree >= conventionFacts(convention).minimumDegree &&
         degree <= conventionFacts(convention).maximumDegree);
  assert(values.size() == static_cast<std::size_t>(conventionSize(convention, degree)));
  if (convention == Convention::kL1Vector) return coefficientsOf(toMoments(values), degree);
  std::vector<double> coefficients(values.begin(), values.end());
  const std::vector<double> factors = factorsOf(convention, degree);
  for (std::size_t i = 0; i < coefficients.size(); ++i) coefficients[i] /= factors[i];
  return exchangeAxes(convention, degree, coefficients);
}

}  // namespace shprt
