#include "shprt/codegen/rotation_code.h"

#include <array>
#include <cassert>
#include <cmath>
#include <numbers>

#include "shprt/codegen/basis_code.h"
#include "shprt/codegen/solid_harmonic.h"
#include "shprt/sh/basis.h"

namespace shprt {
namespace {

// cos of the cone's angle for bands 2 to 8: where the least g_m is largest.
constexpr std::array<double, 7> kConeHeights = {0.3075, 0.2355, 0.5256, 0.1538, 0.1305, 0.1160, 0.1030};

std::string bandFunctionName(int l) {
  return "shAddBand" + std::to_string(l);
}

// rotated += amount * y_l(dir), band l only.
std::string bandFunction(const Dialect& dialect, int degree, int l) {
  const CodeFunction function = {bandFunctionName(l),
                                 {{CodeType::kDirection, "dir"}, {CodeType::kColour, "amount"}},
                                 CodeVariable{CodeType::kColours, "rotated", coefficientCount(degree)},
                                 {}};
  BasisCode basis(dialect);
  std::string body = basis.declareBand(l, 1);
  for (int m = -l; m <= l; ++m)
    body += dialect.addToUpdated("rotated", shIndex(l, m), {basis.value(m), "amount"});
  return "// rotated += amount * y_lm(dir) for band " + std::to_string(l) + ", a step of shRotate.\n" +
         dialect.functionBegin(function, true) + basis.declarePowers("dir") + body +
         dialect.functionEnd(function) + "\n";
}

// y_lm on the cone, without its cos or sin of m phi.
double coneValue(int l, int m, double height) {
  const double s = 1 - height * height;
  double sum = 0, power = std::pow(s, 0.5 * m);
  int zPower = l - m;
  for (const double coefficient : solidHarmonic(l, m)) {
    sum += coefficient * std::pow(height, zPower) * power;
    zPower -= 2;
    power *= s;
  }
  return sum;
}

// Splits band l into lobes around the cone and adds each where the rotation takes it.
std::string bandLobes(const Dialect& dialect, int l) {
  const double height = kConeHeights[static_cast<std::size_t>(l - 2)];
  const double radius = std::sqrt(1 - height * height);
  const int lobes = 2 * l + 1;
  const std::string band = std::to_string(l);
  std::string code;
  for (int j = 0; j <= l; ++j) {
    const double phi = 2 * std::numbers::pi * j / lobes;
    ColourSum even, odd;
    for (int m = 0; m <= l; ++m) {
      const double share = (m == 0 ? 1.0 : 2.0) / (lobes * coneValue(l, m, height));
      // m j modulo the number of lobes keeps the angle small and exact.
      const double angle = 2 * std::numbers::pi * ((m * j) % lobes) / lobes;
      even.push_back({dialect.number(share * std::cos(angle)), "coefficients", shIndex(l, m)});
      if (m > 0 && j > 0)
        odd.push_back({dialect.number(share * std::sin(angle)), "coefficients", shIndex(l, -m)});
    }
    const Vec3d direction = {radius * std::cos(phi), radius * std::sin(phi), height};
    const std::string suffix = band + "_" + std::to_string(j);
    const std::string evenName = "even" + suffix, oddName = "odd" + suffix;
    code += dialect.declareColour(evenName, even);
    if (j == 0) {
      code += dialect.callLobe(bandFunctionName(l), "rotated", "rotation", direction, {{"", evenName}});
      continue;
    }
    code += dialect.declareColour(oddName, odd);
    code += dialect.callLobe(bandFunctionName(l), "rotated", "rotation", direction,
                             {{"", evenName}, {"", oddName}});
    code += dialect.callLobe(bandFunctionName(l), "rotated", "rotation",
                             {direction.x, -direction.y, direction.z}, {{"", evenName}, {"-", oddName}});
  }
  return code;
}

// (c_{1,1}, c_{1,-1}, c_{1,0}) turns like (x, y, z).
std::string bandOne(const Dialect& dialect) {
  constexpr std::array<int, 3> kIndexOfAxis = {3, 1, 2};
  std::string code;
  for (const std::size_t row : {1u, 2u, 0u}) {
    ColourSum sum;
    for (std::size_t column = 0; column < 3; ++column)
      sum.push_back({dialect.rotationEntry("rotation", static_cast<int>(row), static_cast<int>(column)),
                     "coefficients", kIndexOfAxis[column]});
    code += dialect.setColour("rotated", kIndexOfAxis[row], sum);
  }
  return code;
}

}  // namespace

std::string rotationCode(const Dialect& dialect, int degree) {
  assert(degree >= 0 && degree <= kMaximumCodeRotationDegree);
  static_assert(kConeHeights.size() == kMaximumCodeRotationDegree - 1);
  std::string code;
  for (int l = 2; l <= degree; ++l) code += bandFunction(dialect, degree, l);
  const int count = coefficientCount(degree);
  const CodeFunction function = {
      "shRotate",
      {{CodeType::kRotation, "rotation"}, {CodeType::kColours, "coefficients", count}},
      {},
      CodeVariable{CodeType::kColours, "rotated", count}};
  code +=
      "// Coefficients of the function turned by a rotation: (R f)(u) = f(R^-1 u), so light that came from "
      "s\n"
      "// comes from R s.\n";
  code += dialect.functionBegin(function, degree > 0);
  code += dialect.setColour("rotated", 0, {{"", "coefficients", 0}});
  if (degree > 0) code += bandOne(dialect);
  if (degree > 1) code += dialect.clearColours("rotated", shIndex(2, -2), count) + dialect.declareLobe();
  for (int l = 2; l <= degree; ++l) code += bandLobes(dialect, l);
  return code + dialect.functionEnd(function);
}

}  // namespace shprt
