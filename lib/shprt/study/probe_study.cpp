#include "shprt/study/probe_study.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "shprt/light/project_probe.h"
#include "shprt/relight/relight.h"
#include "shprt/study/curve_effort.h"
#include "shprt/study/reference.h"
#include "shprt/study/section_parts.h"
#include "shprt/study/shrink_probe.h"

namespace shprt {
namespace {

constexpr std::array kFactors = {2, 4, 8, 16, 32, 64};
constexpr std::array kDegrees = {4, 8};

struct ProbeMeasurement {
  int width = 0, height = 0;
  std::array<double, 2> coefficients{}, radiance{};  // errors, by kDegrees
};

// 2-norm over coefficients and channels, relative.
double lightError(const LightCoefficients& light, const LightCoefficients& reference) {
  double difference = 0, whole = 0;
  for (std::size_t i = 0; i < reference.coefficients.size(); ++i)
    for (std::size_t channel = 0; channel < 3; ++channel) {
      const double d = light.coefficients[i][channel] - reference.coefficients[i][channel];
      difference += d * d;
      whole += reference.coefficients[i][channel] * reference.coefficients[i][channel];
    }
  return std::sqrt(shareOf(difference, whole));
}

LightCoefficients projectTo(const EnvironmentMap& map, int degree) {
  return projectProbe(map, {.degree = degree}).light;
}

class ProbeMeasurements {
 public:
  explicit ProbeMeasurements(StudyRun& run)
      : run_(run), map_(*run.light->map), sample_(sampleOf(run)), transfer_([this] {
          return sample_.bake(
              {.degree = kDegrees.back(), .rays = run_.options.rays, .seed = run_.options.seed});
        }) {}

  std::size_t vertexCount() const { return sample_.vertices().size(); }

  ProbeMeasurement measure(int factor) {
    const std::string key =
        fmt::format("probe: {}, 1/{}, {} rays, seed {}, {} vertices", run_.light->name, factor,
                    run_.options.rays, run_.options.seed, sample_.vertices().size());
    const std::vector<double> numbers = run_.journal.measure(key, [&] {
      const EnvironmentMap small = shrinkProbe(map_, factor);
      std::vector<double> made = {static_cast<double>(small.image.width),
                                  static_cast<double>(small.image.height)};
      for (const int degree : kDegrees) {
        const LightCoefficients light = projectTo(small, degree), reference = projectTo(map_, degree);
        made.push_back(lightError(light, reference));
        made.push_back(radianceError(relight(transfer_.get(), light), relight(transfer_.get(), reference)));
      }
      return made;
    });
    return {static_cast<int>(numbers[0]),
            static_cast<int>(numbers[1]),
            {numbers[2], numbers[4]},
            {numbers[3], numbers[5]}};
  }

 private:
  StudyRun& run_;
  const EnvironmentMap& map_;
  VertexSample sample_;
  Lazy<TransferCoefficients> transfer_;
};

std::string describe(const std::vector<ProbeMeasurement>& all) {
  const auto good =
      std::find_if(all.rbegin(), all.rend(), [](const ProbeMeasurement& m) { return m.radiance[0] <= 0.01; });
  if (good == all.rend()) {
    return fmt::format("Already {} x {} pixels change radiance by {} at degree {}.\n", all.front().width,
                       all.front().height, shortNumber(all.front().radiance[0]), kDegrees[0]);
  }
  return fmt::format(
      "With {} x {} pixels radiance of degree {} is off by {}, of degree {} by {}; {} x {} leave {} "
      "and {}.\n",
      good->width, good->height, kDegrees[0], shortNumber(good->radiance[0]), kDegrees[1],
      shortNumber(good->radiance[1]), all.back().width, all.back().height,
      shortNumber(all.back().radiance[0]), shortNumber(all.back().radiance[1]));
}

StudySection measureSection(StudyRun& run) {
  StudySection section = beginSection("probe", "Error against probe resolution");
  if (!run.light || !run.light->map) {
    section.missing = run.light ? "the light is no image, so it has no resolution: give a probe"
                                : "no light was given: give a probe";
    return section;
  }
  const Image& image = run.light->map->image;
  ProbeMeasurements measurements(run);
  StudyTable table{"probe", "Smaller probes", {"pixels"}, {}};
  StudyChart chart =
      beginChart("error-probe", "Error against probe resolution", "pixels across", "relative RMS error");
  std::vector<StudyCurve> curves;
  for (const int degree : kDegrees) {
    for (const char* what : {"coefficients", "radiance"}) {
      curves.push_back(beginCurve(fmt::format("{}, degree {}", what, degree)));
      table.columns.push_back(curves.back().name);
    }
  }
  std::vector<ProbeMeasurement> all;
  for (const int factor : kFactors) {
    run.announce(fmt::format("the probe at 1/{} of its resolution", factor));
    const ProbeMeasurement& measured = all.emplace_back(measurements.measure(factor));
    std::vector<std::string>& row = table.rows.emplace_back();
    row.push_back(fmt::format("{} x {}", measured.width, measured.height));
    for (std::size_t d = 0; d < kDegrees.size(); ++d) {
      const double errors[] = {measured.coefficients[d], measured.radiance[d]};
      const char* const names[] = {"coefficients", "radiance"};
      for (std::size_t k = 0; k < 2; ++k) {
        addPoint(curves[2 * d + k], measured.width, errors[k]);
        row.push_back(shortNumber(errors[k]));
        section.figures.emplace_back(fmt::format("probe.{}.{}.degree{}", factor, names[k], kDegrees[d]),
                                     errors[k]);
      }
    }
  }
  section.text = fmt::format(
      "The light's {} x {} pixels ({}) averaged to fewer, by solid angle: the error of its coefficients "
      "(2-norm, "
      "relative), and of the radiance that they make of shadowed transfer at {} vertices.\n",
      image.width, image.height, layoutName(run.light->map->layout), measurements.vertexCount());
  section.text += describe(all);
  for (StudyCurve& curve : curves) addCurve(chart, std::move(curve));
  addChart(section, std::move(chart));
  section.tables.push_back(std::move(table));
  return section;
}

}  // namespace

StudyExperiment probeStudy(const StudyRun& run) {
  const bool hasImage = run.light && run.light->map;
  return {"probe", hasImage ? static_cast<int>(kFactors.size()) : 0, measureSection};
}

}  // namespace shprt
