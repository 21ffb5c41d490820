#include "shprt/coefficients/light_coefficients.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "shprt/base/error.h"
#include "shprt/base/file.h"
#include "shprt/base/json_input.h"
#include "shprt/base/vec.h"
#include "shprt/coefficients/basis_name.h"
#include "shprt/sh/basis.h"

namespace shprt {
namespace {

constexpr int kVersion = 1;
constexpr int kMaximumFileDegree = 4096;

// The shortest text that reads back as the same double. JSON's -0 is an integer, which has no sign.
std::string formatDouble(double value) {
  return value == 0 && std::signbit(value) ? "-0.0" : fmt::format("{}", value);
}

}  // namespace

LightStatistics measureLight(const LightCoefficients& light) {
  LightStatistics statistics;
  const auto& c = light.coefficients;
  for (std::size_t colour = 0; colour < 3; ++colour) {
    statistics.averageRadiance[colour] = c[0][colour] / std::sqrt(4 * std::numbers::pi);
    if (light.degree < 1) continue;
    const double band1 = std::hypot(c[1][colour], c[2][colour], c[3][colour]);
    if (c[0][colour] != 0)
      statistics.directionality[colour] = band1 / (std::abs(c[0][colour]) * std::numbers::sqrt3);
  }
  if (light.degree >= 1) {
    const auto luminance = [&](int index) {
      const auto& rgb = c[static_cast<std::size_t>(index)];
      return 0.2126 * rgb[0] + 0.7152 * rgb[1] + 0.0722 * rgb[2];
    };
    const Vec3d vector{luminance(shIndex(1, 1)), luminance(shIndex(1, -1)), luminance(shIndex(1, 0))};
    // What rounding leaves of light that comes evenly from everywhere is no direction.
    if (length(vector) > 1e-12 * std::abs(luminance(0))) {
      const Vec3d direction = normalize(vector);
      statistics.dominantDirection = {direction.x, direction.y, direction.z};
    }
  }
  for (int l = 0; l <= light.degree; ++l) {
    std::array<double, 3> energy{};
    for (int i = shIndex(l, -l); i <= shIndex(l, l); ++i)
      for (std::size_t colour = 0; colour < 3; ++colour)
        energy[colour] += c[static_cast<std::size_t>(i)][colour] * c[static_cast<std::size_t>(i)][colour];
    statistics.bandEnergy.push_back(energy);
  }
  return statistics;
}

bool isLightFile(const std::filesystem::path& path) {
  return outlineJson(path).format == "shprt-light";
}

LightCoefficients readLight(const std::filesystem::path& path) {
  const nlohmann::json content = readJsonObject(path);
  const JsonObject file(path.string(), "", content);
  if (file.text("format") == "shprt-convention")
    file.fail("format", "is 'shprt-convention', a light as another tool writes it",
              "bring it back first: shprt convert " + path.filename().string() + " -o light.json");
  if (file.text("format") != "shprt-light")
    file.fail("format", "is not 'shprt-light'", "give a light file of shprt");
  const std::int64_t version = file.integer("version");
  if (version < 1 || version > kVersion) {
    file.fail("version",
              "is " + std::to_string(version) + "; this shprt reads up to " + std::to_string(kVersion),
              version > kVersion ? "use a newer shprt" : "versions begin at 1");
  }
  checkBasis(file);
  LightCoefficients light;
  const std::int64_t degree = file.integer("degree");
  if (degree < 0 || degree > kMaximumFileDegree)
    file.fail("degree", "is outside 0 to " + std::to_string(kMaximumFileDegree));
  light.degree = static_cast<int>(degree);
  const std::size_t count = file.list("coefficients").size(),
                    expected = static_cast<std::size_t>(coefficientCount(light.degree));
  if (count != expected) {
    file.fail("coefficients", "has " + std::to_string(count) + " entries where degree " +
                                  std::to_string(degree) + " needs " + std::to_string(expected));
  }
  light.coefficients = file.triples("coefficients");
  if (file.has("source")) light.source = file.text("source");
  if (file.has("statistics")) {
    file.object("statistics");
    light.statisticsJson = content["statistics"].dump();
  }
  return light;
}

void requireWritable(const LightCoefficients& light) {
  if (light.coefficients.size() != static_cast<std::size_t>(coefficientCount(light.degree)))
    throw Error("light", "does not have as many coefficients as its degree asks for");
  for (std::size_t i = 0; i < light.coefficients.size(); ++i) {
    for (const double value : light.coefficients[i]) {
      if (!std::isfinite(value))
        throw Error("light", "coefficient " + std::to_string(i) + " is beyond double",
                    "look for infinite pixels, scales or exposures");
    }
  }
}

std::string formatLight(const LightCoefficients& light) {
  requireWritable(light);
  std::string text = fmt::format(
      "{{\n  \"format\": \"shprt-light\",\n  \"version\": {},\n  \"basis\": {{\"convention\": "
      "\"{}\", \"condonShortley\": false, \"index\": \"{}\"}},\n"
      "  \"degree\": {},\n  \"coefficients\": [\n",
      kVersion, kBasisConvention, kBasisIndex, light.degree);
  for (std::size_t i = 0; i < light.coefficients.size(); ++i) {
    const auto& [r, g, b] = light.coefficients[i];
    text += fmt::format("    [{}, {}, {}]{}\n", formatDouble(r), formatDouble(g), formatDouble(b),
                        i + 1 < light.coefficients.size() ? "," : "");
  }
  text += "  ]";
  if (!light.source.empty())
    text += ",\n  \"source\": " +
            nlohmann::json(light.source).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
  if (!light.statisticsJson.empty()) text += ",\n  \"statistics\": " + light.statisticsJson;
  return text + "\n}\n";
}

void writeLight(const std::filesystem::path& path, const LightCoefficients& light) {
  writeFile(path, formatLight(light));
}

}  // namespace shprt
