#include "shprt/coefficients/convention_file.h"

#include <cmath>
#include <vector>

#include "shprt/base/error.h"
#include "shprt/base/file.h"
#include "shprt/base/json_input.h"
#include "shprt/sh/basis.h"

namespace shprt {
namespace {

constexpr int kVersion = 1;
constexpr const char* kFormat = "shprt-convention";

// R2 has no trace by definition; more than rounding of float means that something else was stored there.
constexpr double kTraceTolerance = 1e-5;

using Triples = std::vector<std::array<double, 3>>;

// Each colour apart through `convert`, from one list of r, g, b to another.
template <typename Convert>
Triples convertColours(const Triples& triples, const Convert& convert) {
  Triples converted;
  for (std::size_t c = 0; c < 3; ++c) {
    std::vector<double> colour;
    for (const auto& rgb : triples) colour.push_back(rgb[c]);
    const std::vector<double> result = convert(colour);
    converted.resize(result.size());
    for (std::size_t i = 0; i < result.size(); ++i) converted[i][c] = result[i];
  }
  return converted;
}

void checkTrace(const JsonObject& file, const Triples& triples) {
  if (triples.size() < 10) return;
  for (std::size_t c = 0; c < 3; ++c) {
    const double xx = triples[4][c], yy = triples[5][c], zz = triples[6][c];
    if (std::abs(xx + yy + zz) > kTraceTolerance * (std::abs(xx) + std::abs(yy) + std::abs(zz)))
      file.fail("coefficients", "4 to 6, the diagonal of R2, do not add up to 0",
                "take a third of their sum from each");
  }
}

}  // namespace

bool isConventionFile(const std::filesystem::path& path) {
  return outlineJson(path).format == kFormat;
}

std::string formatConventionFile(const LightCoefficients& light, Convention convention) {
  const Triples values = convertColours(light.coefficients, [&](const std::vector<double>& colour) {
    return toConvention(convention, light.degree, colour);
  });
  for (const auto& value : values)
    for (const double channel : value)
      if (!std::isfinite(channel))
        throw Error("light", "a value is beyond double in this convention", "scale the light down");
  const ConventionFacts& facts = conventionFacts(convention);
  const auto quoted = [](const std::string& text) {
    return nlohmann::json(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
  };
  std::string text = "{\n  \"format\": " + quoted(kFormat) + ",\n  \"version\": " + std::to_string(kVersion) +
                     ",\n  \"convention\": " + quoted(facts.name) +
                     ",\n  \"meaning\": " + quoted(facts.meaning) + ",\n  \"order\": " + quoted(facts.order) +
                     ",\n  \"axes\": " + quoted(facts.frame) +
                     ",\n  \"degree\": " + std::to_string(light.degree) + ",\n  \"coefficients\": [\n";
  for (std::size_t i = 0; i < values.size(); ++i) {
    text += "    " + nlohmann::json(values[i]).dump() + (i + 1 < values.size() ? ",\n" : "\n");
  }
  text += "  ]";
  if (!light.source.empty()) text += ",\n  \"source\": " + quoted(light.source);
  return text + "\n}\n";
}

LightCoefficients readConventionFile(const std::filesystem::path& path) {
  const nlohmann::json content = readJsonObject(path);
  const JsonObject file(path.string(), "", content);
  if (file.text("format") != kFormat)
    file.fail("format", "is not '" + std::string(kFormat) + "'",
              "give a file that convert --convention wrote");
  const std::int64_t version = file.integer("version");
  if (version < 1 || version > kVersion) {
    file.fail("version",
              "is " + std::to_string(version) + "; this shprt reads up to " + std::to_string(kVersion),
              version > kVersion ? "use a newer shprt" : "versions begin at 1");
  }
  Convention convention{};
  const std::string name = file.text("convention");
  try {
    convention = parseConvention(name);
  } catch (const Error& error) {
    file.fail("convention", std::string("is wrong: ") + error.what());
  }
  const ConventionFacts& facts = conventionFacts(convention);
  const std::int64_t degree = file.integer("degree");
  if (degree < facts.minimumDegree || degree > facts.maximumDegree) {
    file.fail("degree", "is " + std::to_string(degree) + ", and " + name + " holds " +
                            std::to_string(facts.minimumDegree) + " to " +
                            std::to_string(facts.maximumDegree));
  }
  LightCoefficients light;
  light.degree = static_cast<int>(degree);
  const std::size_t count = file.list("coefficients").size(),
                    expected = static_cast<std::size_t>(conventionSize(convention, light.degree));
  if (count != expected) {
    file.fail("coefficients", "has " + std::to_string(count) + " entries where degree " +
                                  std::to_string(degree) + " of " + name + " needs " +
                                  std::to_string(expected));
  }
  const Triples values = file.triples("coefficients");
  if (convention == Convention::kL1Vector) checkTrace(file, values);
  light.coefficients = convertColours(values, [&](const std::vector<double>& colour) {
    return fromConvention(convention, light.degree, colour);
  });
  if (file.has("source")) light.source = file.text("source");
  return light;
}

std::array<double, 3> energyShareAbove(const LightCoefficients& light, int degree) {
  const auto kept = static_cast<std::size_t>(coefficientCount(degree));
  std::array<double, 3> above{}, total{};
  for (std::size_t i = 0; i < light.coefficients.size(); ++i)
    for (std::size_t c = 0; c < 3; ++c) {
      const double energy = light.coefficients[i][c] * light.coefficients[i][c];
      total[c] += energy;
      if (i >= kept) above[c] += energy;
    }
  for (std::size_t c = 0; c < 3; ++c) above[c] = total[c] > 0 ? above[c] / total[c] : 0;
  return above;
}

}  // namespace shprt
