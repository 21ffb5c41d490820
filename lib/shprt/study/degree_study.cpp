// Radiance is the sum over bands of transfer times light, so cutting either cuts both: only bands that both
// have meet. What differs is how much of itself each leaves out. Energies of the bands give, besides, the
// error of radiance averaged over all rotations of the light (band_tails.h).

#include "shprt/study/degree_study.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "shprt/sh/basis.h"
#include "shprt/study/curve_effort.h"
#include "shprt/study/reference.h"
#include "shprt/study/section_parts.h"
#include "shprt/transfer/band_tails.h"

namespace shprt {
namespace {

// Of transfer at the reference's degree, in floats: a gigabyte.
constexpr std::size_t kMostCoefficients = std::size_t{1} << 28;

struct DegreeMeasurement {
  std::vector<double> transferEnergy;  // per band, of what unshadowed transfer of all degrees has in all
  std::vector<double> radianceTail;    // per degree, of this light; empty without one
};

int referenceDegree(const StudyRun& run) {
  int degree = std::max(curveEffort(run.options).referenceDegree, run.options.degree);
  const std::size_t perCoefficient = 3 * run.prepared.scene.mesh.positions.size();
  while (degree > run.options.degree &&
         perCoefficient * static_cast<std::size_t>(coefficientCount(degree)) > kMostCoefficients)
    degree = std::max(degree / 2, run.options.degree);
  return degree;
}

// Mean over vertices and channels of each band's squared norm.
std::vector<double> transferBandEnergy(const TransferCoefficients& transfer) {
  std::vector<double> energy;
  for (int l = 0; l <= transfer.degree; ++l) {
    double sum = 0;
    for (int channel = 0; channel < transfer.channels; ++channel) {
      const float* first = transfer.row(channel, shIndex(l, -l));
      const std::size_t count = static_cast<std::size_t>(2 * l + 1) * transfer.vertexCount;
      for (std::size_t i = 0; i < count; ++i)
        sum += static_cast<double>(first[i]) * static_cast<double>(first[i]);
    }
    energy.push_back(shareOf(sum, static_cast<double>(transfer.vertexCount) * transfer.channels));
  }
  return energy;
}

// For each degree, the RMS over vertices and channels of the radiance that bands beyond it bring, over that
// of all.
std::vector<double> radianceTails(const TransferCoefficients& transfer, const LightCoefficients& light) {
  const int common = std::min(transfer.degree, light.degree);
  std::vector<double> squares(static_cast<std::size_t>(transfer.degree) + 1);
  double whole = 0;
  for (std::size_t colour = 0; colour < 3; ++colour) {
    const int channel = transfer.channels == 3 ? static_cast<int>(colour) : 0;
    std::vector<double> beyond(transfer.vertexCount);
    for (int l = common; l >= 0; --l) {
      for (int i = shIndex(l, -l); i <= shIndex(l, l); ++i) {
        const float* row = transfer.row(channel, i);
        const double c = light.coefficients[static_cast<std::size_t>(i)][colour];
        for (std::size_t v = 0; v < beyond.size(); ++v) beyond[v] += c * static_cast<double>(row[v]);
      }
      double& sum = l > 0 ? squares[static_cast<std::size_t>(l) - 1] : whole;
      for (const double radiance : beyond) sum += radiance * radiance;
    }
  }
  for (double& square : squares) square = std::sqrt(shareOf(square, whole));
  return squares;
}

DegreeMeasurement measureDegrees(StudyRun& run, const VertexSample& sample, int degree) {
  const CurveEffort effort = curveEffort(run.options);
  std::string key = fmt::format("degree: up to {}, {} rays, seed {}, {} vertices", degree,
                                effort.referenceRays, run.options.seed, sample.vertices().size());
  if (run.light) key += ", under " + run.light->name;
  const std::vector<double> measured = run.journal.measure(key, [&] {
    const TransferCoefficients transfer =
        sample.bake({.degree = degree, .rays = effort.referenceRays, .seed = run.options.seed});
    std::vector<double> numbers = transferBandEnergy(transfer);
    if (run.light) {
      const std::vector<double> tails = radianceTails(transfer, run.light->coefficients);
      numbers.insert(numbers.end(), tails.begin(), tails.end());
    }
    return numbers;
  });
  const auto bands = measured.begin() + degree + 1;
  return {{measured.begin(), bands}, {bands, measured.end()}};
}

// Root of what lies in bands beyond each degree.
std::vector<double> tailNorms(const std::vector<double>& energy, double whole) {
  std::vector<double> tails(energy.size());
  double beyond = 0;
  for (std::size_t l = energy.size(); l-- > 0; beyond += energy[l])
    tails[l] = std::sqrt(beyond) / (whole > 0 ? whole : 1);
  return tails;
}

StudyCurve curveOf(std::string name, const std::vector<double>& tails) {
  StudyCurve curve = beginCurve(std::move(name));
  for (std::size_t l = 0; l < tails.size(); ++l) addPoint(curve, static_cast<double>(l), tails[l]);
  return curve;
}

struct NamedTails {
  std::string id, name;
  std::vector<double> tails;
};

std::string describe(const StudyRun& run, const std::vector<NamedTails>& all, StudySection& section) {
  const auto degree = static_cast<std::size_t>(run.options.degree);
  std::string text = fmt::format("Cut at degree {}, the default of this study, ", degree);
  text += fmt::format("the transfer leaves {} of itself out", shortNumber(all[0].tails[degree]));
  if (!run.light)
    return text + ". How much of that radiance shows depends on the light: give one to see it.\n";
  const std::vector<double>& radiance = all[2].tails;
  text += fmt::format(
      ", the light {}, and the radiance is off by {}: what one of them lacks, the other cannot show.\n",
      shortNumber(all[1].tails[degree]), shortNumber(radiance[degree]));
  for (const double bound : {0.1, 0.01}) {
    const auto first = std::find_if(radiance.begin(), radiance.end(), [&](double e) { return e <= bound; });
    const auto least = static_cast<double>(first - radiance.begin());
    if (first == radiance.end()) continue;
    section.figures.emplace_back(fmt::format("degree.least.{}", bound), least);
    text += fmt::format("An error of radiance of {} takes degree {}.\n", bound, least);
  }
  return text;
}

StudySection measureSection(StudyRun& run) {
  const VertexSample sample = sampleOf(run);
  const int degree = referenceDegree(run);
  run.announce(fmt::format("transfer of degree {}", degree));
  const DegreeMeasurement measured = measureDegrees(run, sample, degree);

  std::vector<NamedTails> all = {
      {"transfer", "transfer",
       tailNorms(measured.transferEnergy, unshadowedRms(run.prepared.scene, sample.vertices(), degree))}};
  if (run.light) {
    const std::vector<double> energy = lightBandEnergy({&run.light->coefficients, 1}, degree);
    all.push_back({"light", "light", tailShares(energy)});
    all.push_back({"radiance", "radiance, both cut", measured.radianceTail});
    all.push_back({"turned", "radiance, mean over all turns of the light",
                   tailShares(radianceBandEnergy(measured.transferEnergy, energy))});
  }

  StudySection section = beginSection("degree", "Error against degree");
  StudyTable table{"degree", "Left out beyond a degree", {"degree", "coefficients"}, {}};
  StudyChart chart = beginChart("error-degree", "Error against degree", "degree", "relative RMS error");
  chart.logX = false;
  for (const NamedTails& named : all) {
    table.columns.push_back(named.name);
    addCurve(chart, curveOf(named.name, named.tails));
  }
  for (int l = 0; l < degree; ++l) {
    std::vector<std::string>& row = table.rows.emplace_back();
    row = {std::to_string(l), std::to_string(coefficientCount(l))};
    for (const NamedTails& named : all) {
      const double tail = named.tails[static_cast<std::size_t>(l)];
      row.push_back(shortNumber(tail));
      section.figures.emplace_back(fmt::format("degree.{}.{}", l, named.id), tail);
    }
  }
  section.text = fmt::format(
      "What bands beyond a degree hold, of shadowed transfer to degree {} at {} vertices ({} rays each), "
      "relative to the unshadowed transfer",
      degree, sample.vertices().size(), curveEffort(run.options).referenceRays);
  if (run.light) {
    section.text += fmt::format(
        "; of the light, known to degree {}, relative to all of it; and of the radiance that they make "
        "together. Cutting the transfer, the light or both changes radiance by the same: only bands that "
        "both "
        "have meet",
        std::min(degree, run.light->coefficients.degree));
  }
  section.text += ".\n" + describe(run, all, section);
  addChart(section, std::move(chart));
  section.tables.push_back(std::move(table));
  return section;
}

}  // namespace

StudyExperiment degreeStudy(const StudyRun&) {
  return {"degree", 1, measureSection};
}

}  // namespace shprt
