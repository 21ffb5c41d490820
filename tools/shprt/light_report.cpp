#include "light_report.h"

#include <fmt/core.h>

#include <cstddef>

namespace shprt {

std::string formatTriple(const std::array<double, 3>& values) {
  return fmt::format("{:>10.5g} {:>10.5g} {:>10.5g}", values[0], values[1], values[2]);
}

void printLight(const Console& console, const LightCoefficients& light) {
  const LightStatistics statistics = measureLight(light);
  const bool directed = statistics.dominantDirection != std::array<double, 3>{};
  console.field("average radiance", formatTriple(statistics.averageRadiance));
  console.field("dominant direction", directed ? formatTriple(statistics.dominantDirection) : "      none");
  console.field("directionality", formatTriple(statistics.directionality));
  for (std::size_t band = 0; band < statistics.bandEnergy.size(); ++band) {
    console.field(fmt::format("energy of band {}", band), formatTriple(statistics.bandEnergy[band]));
  }
}

Json lightStatisticsJson(const LightCoefficients& light) {
  const LightStatistics statistics = measureLight(light);
  return {{"averageRadiance", statistics.averageRadiance},
          {"dominantDirection", statistics.dominantDirection},
          {"directionality", statistics.directionality},
          {"bandEnergy", statistics.bandEnergy}};
}

}  // namespace shprt
