// Whether a light file holds a directional light: its coefficients against evaluateSh, and against the
// reference values of high degree where a file with them is given. For the scripts of this folder.
// Usage: check_directional LIGHT.json X Y Z IRRADIANCE TOLERANCE [SH_EVAL.json NAME]
// The tolerance is relative to sqrt((2l+1)/4pi), the scale of band l.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <fstream>
#include <nlohmann/json.hpp>
#include <numbers>
#include <string>
#include <vector>

#include "shprt/coefficients/light_coefficients.h"
#include "shprt/sh/basis.h"

namespace {

double bandScale(int l) {
  return std::sqrt((2 * l + 1) / (4 * std::numbers::pi));
}

double errorOf(const shprt::LightCoefficients& light, int i, double y, double irradiance) {
  double error = 0;
  for (const double value : light.coefficients[static_cast<std::size_t>(i)])
    error = std::max(error, std::abs(value / irradiance - y) / bandScale(shprt::bandOf(i)));
  return error;
}

int check(const std::vector<std::string>& arguments) {
  const auto number = [&](std::size_t i) { return std::stod(arguments.at(i)); };
  const shprt::LightCoefficients light = shprt::readLight(arguments.at(0));
  const shprt::Vec3d direction = shprt::normalize({number(1), number(2), number(3)});
  std::vector<double> basis(light.coefficients.size());
  shprt::evaluateSh(light.degree, direction, basis);
  double worst = 0;
  std::size_t compared = basis.size();
  for (std::size_t i = 0; i < basis.size(); ++i)
    worst = std::max(worst, errorOf(light, static_cast<int>(i), basis[i], number(4)));
  if (arguments.size() > 6) {
    const nlohmann::json reference = nlohmann::json::parse(std::ifstream(arguments.at(6)));
    std::size_t samples = 0;
    for (const nlohmann::json& entry : reference.at("high_degree")) {
      if (entry.at("name") != arguments.at(7)) continue;
      for (const nlohmann::json& sample : entry.at("samples")) {
        const int l = sample.at(0), m = sample.at(1);
        if (l > light.degree) continue;
        worst = std::max(worst, errorOf(light, shprt::shIndex(l, m), sample.at(2), number(4)));
        ++samples;
      }
    }
    if (samples == 0) compared = 0;
    compared += samples;
  }
  std::printf("%zu compared, largest error %.3g of the band's scale\n", compared, worst);
  return compared > 0 && worst <= number(5) ? 0 : 1;
}

}  // namespace

int main(int count, char** values) {
  try {
    return check({values + 1, values + count});
  } catch (const std::exception& error) {
    std::fprintf(stderr, "check_directional: %s\n", error.what());
    return 2;
  }
}
