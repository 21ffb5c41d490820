#include "shprt/coefficients/light_coefficients.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "shprt/base/error.h"
#include "shprt/base/file.h"
#include "shprt/base/vec.h"
#include "shprt/coefficients/json_input.h"
#include "shprt/sh/basis.h"

namespace shprt {
namespace {

constexpr int kVersion = 1;
constexpr int kMaximumFileDegree = 4096;
constexpr const char* kIndexName = "l(l+1)+m";

void checkBasis(const JsonObject& file) {
  const JsonObject basis = file.object("basis");
  const nlohmann::json& phase = basis.field("condonShortley");
  if (basis.text("convention") != "real-orthonormal" || !phase.is_boolean() || phase.get<bool>() ||
      basis.text("index") != kIndexName) {
    file.fail("basis",
              "is another convention than real-orthonormal without Condon-Shortley phase, index l(l+1)+m",
              "convert the file first");
  }
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
    const Vec3d direction =
        normalize({luminance(shIndex(1, 1)), luminance(shIndex(1, -1)), luminance(shIndex(1, 0))});
    statistics.dominantDirection = {direction.x, direction.y, direction.z};
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
  const std::string bytes = readFirstBytes(path, 4096);
  const std::size_t brace = bytes.find_first_not_of(" \t\r\n");
  return brace != std::string::npos && bytes[brace] == '{' &&
         bytes.find("\"shprt-light\"") != std::string::npos;
}

LightCoefficients readLight(const std::filesystem::path& path) {
  const nlohmann::json content = readJsonObject(path);
  const JsonObject file(path.string(), "", content);
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
  const nlohmann::json& coefficients = file.field("coefficients");
  const auto expected = static_cast<std::size_t>(coefficientCount(light.degree));
  if (!coefficients.is_array() || coefficients.size() != expected) {
    file.fail("coefficients", "has " + std::to_string(coefficients.size()) + " entries where degree " +
                                  std::to_string(degree) + " needs " + std::to_string(expected));
  }
  light.coefficients.reserve(expected);
  for (const nlohmann::json& entry : coefficients) {
    const std::string name = "coefficients[" + std::to_string(light.coefficients.size()) + "]";
    if (!entry.is_array() || entry.size() != 3) file.fail(name, "does not have three numbers");
    std::array<double, 3> rgb{};
    for (std::size_t i = 0; i < 3; ++i) {
      if (!entry[i].is_number() || !std::isfinite(entry[i].get<double>()))
        file.fail(name, "has an entry that is no finite number");
      rgb[i] = entry[i].get<double>();
    }
    light.coefficients.push_back(rgb);
  }
  if (file.has("source") && content["source"].is_string())
    light.source = content["source"].get<std::string>();
  if (file.has("statistics")) {
    if (!content["statistics"].is_object()) file.fail("statistics", "is no object");
    light.statisticsJson = content["statistics"].dump();
  }
  return light;
}

std::string formatLight(const LightCoefficients& light) {
  std::string text = fmt::format(
      "{{\n  \"format\": \"shprt-light\",\n  \"version\": {},\n  \"basis\": {{\"convention\": "
      "\"real-orthonormal\", \"condonShortley\": false, \"index\": \"{}\"}},\n"
      "  \"degree\": {},\n  \"coefficients\": [\n",
      kVersion, kIndexName, light.degree);
  for (std::size_t i = 0; i < light.coefficients.size(); ++i) {
    const auto& [r, g, b] = light.coefficients[i];
    text += fmt::format("    [{}, {}, {}]{}\n", r, g, b, i + 1 < light.coefficients.size() ? "," : "");
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
