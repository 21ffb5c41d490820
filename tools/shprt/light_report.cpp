#include "light_report.h"

#include <fmt/core.h>

#include <algorithm>
#include <cstddef>

#include "shprt/light/dominant_light.h"

namespace shprt {
namespace {

// Bands listed one by one; the rest of a light of high degree becomes one line.
constexpr std::size_t kListedBands = 33;

Json dominantLightJson(const DominantLight& dominant) {
  const Vec3d& d = dominant.direction;
  return {{"direction", {d.x, d.y, d.z}},
          {"irradiance", dominant.irradiance},
          {"ambientRadiance", dominant.ambientRadiance},
          {"unexplained", dominant.unexplained}};
}

void printDominantLight(const Console& console, const DominantLight& dominant) {
  const bool directed = dominant.direction != Vec3d{};
  console.field("dominant light", directed ? formatTriple(dominant.irradiance) : "      none");
  console.field("ambient rest", formatTriple(dominant.ambientRadiance));
  if (!directed) return;
  const auto& [r, g, b] = dominant.unexplained;
  console.field("unexplained", fmt::format("{:>9.2f}% {:>9.2f}% {:>9.2f}%", 100 * r, 100 * g, 100 * b));
}

}  // namespace

std::string formatTriple(const std::array<double, 3>& values) {
  return fmt::format("{:>10.5g} {:>10.5g} {:>10.5g}", values[0], values[1], values[2]);
}

void printLight(const Console& console, const LightCoefficients& light) {
  const LightStatistics statistics = measureLight(light);
  const bool directed = statistics.dominantDirection != std::array<double, 3>{};
  console.field("", "       red      green       blue");
  console.field("average radiance", formatTriple(statistics.averageRadiance));
  console.field("dominant direction",
                directed ? formatTriple(statistics.dominantDirection) + "  (x, y, z)" : "      none");
  console.field("directionality", formatTriple(statistics.directionality));
  printDominantLight(console, dominantLight(light));
  const std::size_t listed = std::min(kListedBands, statistics.bandEnergy.size());
  for (std::size_t band = 0; band < listed; ++band) {
    console.field(fmt::format("energy of band {}", band), formatTriple(statistics.bandEnergy[band]));
  }
  if (listed == statistics.bandEnergy.size()) return;
  std::array<double, 3> rest{};
  for (std::size_t band = listed; band < statistics.bandEnergy.size(); ++band)
    for (std::size_t c = 0; c < 3; ++c) rest[c] += statistics.bandEnergy[band][c];
  console.field("energy above", formatTriple(rest));
}

Json lightStatisticsJson(const LightCoefficients& light) {
  const LightStatistics statistics = measureLight(light);
  return {{"averageRadiance", statistics.averageRadiance},
          {"dominantDirection", statistics.dominantDirection},
          {"directionality", statistics.directionality},
          {"dominantLight", dominantLightJson(dominantLight(light))},
          {"bandEnergy", statistics.bandEnergy}};
}

}  // namespace shprt
