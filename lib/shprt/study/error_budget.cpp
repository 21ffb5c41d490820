#include "shprt/study/error_budget.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "shprt/light/project_probe.h"
#include "shprt/relight/relight.h"
#include "shprt/study/half_rounding.h"
#include "shprt/study/probe_sampler.h"
#include "shprt/study/surface_subset.h"
#include "shprt/transfer/planned_bake.h"
#include "shprt/transfer/reference_radiance.h"

namespace shprt {
namespace {

// How much is spent on the answer.
struct Effort {
  std::size_t points;       // vertices, and as many samples
  int manyRays;             // times the default rays
  double converged;         // what bounces may leave out of a converged bake
  double noise;             // relative, that truth may have
  double surfaces;          // that the paths of all points may go on from
  ReferenceOptions traced;  // passes: the most that noise may take
};

constexpr Effort kQuick{200, 2, 1e-3, 5e-3, 2e5, {.rays = 128, .passes = 16}};
constexpr Effort kFull{1000, 8, 1e-4, 3e-3, 8e6, {.rays = 512, .passes = 24}};
constexpr int kFewestPasses = 4;

// Sampling errors of the lattice fall about as fast as this power of rays (docs/accuracy.md). Were it 1/2 or
// 1, sampling would be misjudged by a twentieth.
constexpr double kSamplingRate = 0.75;

// Radiance at points: what was baked, without errors, or traced, with them.
struct PointRadiance {
  std::vector<Vec3d> radiance, standardError;
  std::vector<bool> buried;
};

double square(Vec3d a) {
  return dot(a, a);
}

// The budget's sums over the points that are not buried.
class Comparison {
 public:
  explicit Comparison(const PointRadiance& truth) : truth_(truth) {
    for (std::size_t i = 0; i < truth.radiance.size(); ++i) {
      if (truth.buried[i]) continue;
      ++count_;
      power_ += square(truth.radiance[i]) - square(truth.standardError[i]);
    }
  }

  std::size_t count() const { return count_; }
  // Mean squares, relative. Noise that is known is taken out, which may leave less than nothing.
  double difference(const PointRadiance& a, const PointRadiance& b) const {
    return product(a, b, a, b) - noise(a) - noise(b);
  }
  // Mean of (a - b) . (c - d).
  double product(const PointRadiance& a, const PointRadiance& b, const PointRadiance& c,
                 const PointRadiance& d) const {
    return relative(
        [&](std::size_t i) { return dot(a.radiance[i] - b.radiance[i], c.radiance[i] - d.radiance[i]); });
  }
  double noise(const PointRadiance& a) const {
    if (a.standardError.empty()) return 0;
    return relative([&](std::size_t i) { return square(a.standardError[i]); });
  }
  double relative(const std::function<double(std::size_t)>& squareAt) const {
    double sum = 0;
    for (std::size_t i = 0; i < truth_.radiance.size(); ++i)
      if (!truth_.buried[i]) sum += squareAt(i);
    return power_ > 0 ? sum / power_ : 0;
  }

 private:
  const PointRadiance& truth_;
  std::size_t count_ = 0;
  double power_ = 0;
};

double root(double square) {
  return std::sqrt(std::max(0.0, square));
}

PointRadiance unpackTraced(const std::vector<double>& numbers) {
  PointRadiance points;
  for (std::size_t i = 0; i + 7 <= numbers.size(); i += 7) {
    points.radiance.push_back({numbers[i], numbers[i + 1], numbers[i + 2]});
    points.standardError.push_back({numbers[i + 3], numbers[i + 4], numbers[i + 5]});
    points.buried.push_back(numbers[i + 6] != 0);
  }
  return points;
}

// As many passes as bring the noise down to what it may be, and cost no more than they may.
template <typename Points>
std::vector<RadianceEstimate> traceEnough(const StudyRun& run, Points points, const Sky& sky,
                                          const Effort& effort, std::uint64_t seed) {
  ReferenceOptions options = effort.traced;
  options.seed = seed;
  options.passes = kFewestPasses;
  std::vector<RadianceEstimate> estimates = traceRadiance(run.prepared, points, sky, options);
  const double ratio = relativeStandardError(estimates) / effort.noise;
  double surfaces = 0;
  for (const RadianceEstimate& estimate : estimates) surfaces += static_cast<double>(estimate.surfaces);
  const double enough = std::min({kFewestPasses * ratio * ratio, kFewestPasses * effort.surfaces / surfaces,
                                  static_cast<double>(effort.traced.passes)});
  if (enough <= kFewestPasses) return estimates;
  options.passes = static_cast<int>(std::ceil(enough));
  return traceRadiance(run.prepared, points, sky, options);
}

template <typename Points>
PointRadiance trace(StudyRun& run, const std::string& key, Points points, const Sky& sky,
                    const Effort& effort, std::uint64_t stream) {
  run.announce("error budget: " + key);
  return unpackTraced(run.journal.measure("error-budget." + key, [&] {
    std::vector<double> numbers;
    for (const RadianceEstimate& e : traceEnough(run, points, sky, effort, run.options.seed + stream))
      numbers.insert(numbers.end(), {e.radiance.x, e.radiance.y, e.radiance.z, e.standardError.x,
                                     e.standardError.y, e.standardError.z, e.buried ? 1.0 : 0.0});
    return numbers;
  }));
}

struct BakedRadiance {
  PointRadiance vertices, halves, samples;
  std::vector<double> rounding;  // expected square of what rounding to float does to a vertex's radiance
};

// Relights bakes at the points of the study.
class BakeReader {
 public:
  BakeReader(StudyRun& run, std::span<const std::uint32_t> vertices, std::span<const SurfaceSample> samples)
      : run_(run), vertices_(vertices), samples_(samples) {}

  BakedRadiance read(const std::string& key, const BakeRequest& request) {
    run_.announce("error budget: " + key);
    const std::vector<double> numbers =
        run_.journal.measure("error-budget." + key, [&] { return measure(request); });
    BakedRadiance baked;
    auto next = numbers.begin();
    const auto take = [&](PointRadiance& points, std::size_t count) {
      for (std::size_t i = 0; i < count && numbers.end() - next >= 3; ++i, next += 3)
        points.radiance.push_back({next[0], next[1], next[2]});
    };
    take(baked.vertices, vertices_.size());
    take(baked.halves, vertices_.size());
    take(baked.samples, samples_.size());
    baked.rounding.assign(next, numbers.end());
    return baked;
  }

 private:
  std::vector<double> measure(const BakeRequest& request) const {
    Bake bake = bakeRequested(run_.prepared, request);
    const std::vector<double> rounding = roundingOf(bake.transfer);
    const std::vector<Vec3f> whole = outgoing(bake);
    for (float& value : bake.transfer.values) value = roundToHalf(value);
    const std::vector<Vec3f> halves = outgoing(bake);
    std::vector<double> numbers;
    const auto put = [&](Vec3d a) { numbers.insert(numbers.end(), {a.x, a.y, a.z}); };
    for (const std::uint32_t vertex : vertices_) put(toDouble(whole[vertex]));
    for (const std::uint32_t vertex : vertices_) put(toDouble(halves[vertex]));
    for (const SurfaceSample& sample : samples_) {
      const auto& [a, b, c] = run_.prepared.topology.triangles()[sample.triangle];
      const Vec3d corners[3] = {toDouble(whole[a]), toDouble(whole[b]), toDouble(whole[c])};
      put(interpolate(corners, static_cast<double>(sample.u), static_cast<double>(sample.v)));
    }
    numbers.insert(numbers.end(), rounding.begin(), rounding.end());
    return numbers;
  }

  std::vector<Vec3f> outgoing(const Bake& bake) const {
    std::vector<Vec3f> radiance = relight(bake.transfer, run_.light->coefficients);
    for (std::size_t i = 0; i < bake.emission.size(); ++i) radiance[i] += bake.emission[i];
    return radiance;
  }

  // A value is off by up to half a unit of its last place, each as likely as any other: a variance of a
  // twelfth of that unit's square.
  std::vector<double> roundingOf(const TransferCoefficients& transfer) const {
    const auto& light = run_.light->coefficients.coefficients;
    std::vector<double> squares;
    for (const std::uint32_t vertex : vertices_) {
      double sum = 0;
      for (int i = 0; i < transfer.rows() && static_cast<std::size_t>(i) < light.size(); ++i)
        for (int channel = 0; channel < 3; ++channel) {
          const float value = transfer.row(transfer.channels == 1 ? 0 : channel, i)[vertex];
          const double unit = static_cast<double>(std::nextafter(std::fabs(value), HUGE_VALF)) -
                              static_cast<double>(std::fabs(value));
          const double part = unit * light[static_cast<std::size_t>(i)][static_cast<std::size_t>(channel)];
          sum += part * part / 12;
        }
      squares.push_back(sum);
    }
    return squares;
  }

  StudyRun& run_;
  std::span<const std::uint32_t> vertices_;
  std::span<const SurfaceSample> samples_;
};

std::unique_ptr<Sky> fullSky(const StudyLight& light) {
  if (light.map) return std::make_unique<ProbeSky>(*light.map);
  return std::make_unique<ExpandedSky>(light.coefficients, light.coefficients.degree);
}

}  // namespace

double ErrorBudget::unexplained() const {
  return total * total - bounces * bounces - sampling * sampling - gathering * gathering -
         truncation * truncation - rounding * rounding;
}

ErrorBudget measureErrorBudget(StudyRun& run) {
  assert(run.light);
  const Effort& effort = run.options.quick ? kQuick : kFull;
  const std::vector<std::uint32_t> vertices =
      spreadVertices(run.prepared.scene, effort.points, run.options.seed);
  const std::vector<SurfaceSample> samples =
      spreadSamples(run.prepared.scene, run.prepared.topology, effort.points, run.options.seed);

  const BakeRequest standard = followPlan(run.plan, {.degree = run.options.degree,
                                                     .rays = run.options.rays,
                                                     .seed = run.options.seed,
                                                     .error = run.options.error});
  // The same rays as by default, so that nothing but the bounces differs.
  BakeRequest bounced = standard;
  bounced.model = "interreflected";
  bounced.bounces.reset();
  bounced.error = std::min(effort.converged, standard.error);
  // Independent ones.
  BakeRequest many = bounced;
  many.rays = standard.rays * effort.manyRays;
  many.seed = standard.seed + 1;

  BakeReader reader(run, vertices, samples);
  const BakedRadiance asked = reader.read("default bake", standard);
  const BakedRadiance exact = reader.read("many rays", many);
  // Without rays there is no sampling, and what rays would show is what was left out.
  const BakedRadiance converged =
      standard.model == "unshadowed" ? reader.read("many rays", many) : reader.read("all bounces", bounced);

  const LightCoefficients& light = run.light->coefficients;
  const ExpandedSky band(light, standard.degree);
  const std::unique_ptr<Sky> full = fullSky(*run.light);
  // Without bands beyond the degree both skies are one.
  const bool differ = run.light->map || light.degree > standard.degree;
  const PointRadiance bandTruth = trace(run, "truth under the bands", std::span(vertices), band, effort, 0);
  const PointRadiance bandInside =
      trace(run, "the same inside triangles", std::span(samples), band, effort, 0);
  const auto traceFull = [&](const std::string& key, auto points, const PointRadiance& same) {
    if (differ) return trace(run, key, points, *full, effort, 1);
    run.announce("error budget: " + key);
    return same;
  };
  const PointRadiance truth = traceFull("truth", std::span(vertices), bandTruth);
  const PointRadiance inside = traceFull("truth inside triangles", std::span(samples), bandInside);

  ErrorBudget budget;
  const Comparison atVertices(truth), inTriangles(inside);
  budget.bounces = root(atVertices.difference(asked.vertices, converged.vertices));
  // Both bakes' errors are in their difference; the second's share falls with its rays.
  const double manyShare = std::pow(effort.manyRays, -2 * kSamplingRate);
  budget.sampling = root(atVertices.difference(converged.vertices, exact.vertices) / (1 + manyShare));
  // The errors of independent rays do not correlate: the product of two bakes' differences from truth has
  // only what they have in common.
  const auto besideSampling = [](const Comparison& comparison, const PointRadiance& one,
                                 const PointRadiance& other, const PointRadiance& traced) {
    return root(comparison.product(one, traced, other, traced) - comparison.noise(traced));
  };
  budget.gathering = besideSampling(atVertices, converged.vertices, exact.vertices, bandTruth);
  budget.truncation = differ ? root(atVertices.difference(bandTruth, truth)) : 0;
  budget.rounding = root(atVertices.relative([&](std::size_t i) { return asked.rounding[i]; }));
  budget.total = root(atVertices.difference(asked.vertices, truth));
  budget.half = root(atVertices.difference(asked.halves, asked.vertices));
  budget.noise = root(atVertices.noise(truth));
  budget.interpolation = besideSampling(inTriangles, converged.samples, exact.samples, bandInside);
  budget.truncationInside = differ ? root(inTriangles.difference(bandInside, inside)) : 0;
  budget.totalInside = root(inTriangles.difference(asked.samples, inside));
  budget.noiseInside = root(inTriangles.noise(inside));
  budget.vertices = atVertices.count();
  budget.samples = inTriangles.count();
  budget.degree = standard.degree;
  budget.rays = standard.rays;
  budget.manyRays = many.rays;
  return budget;
}

StudyExperiment errorBudget() {
  return {"error-budget", kErrorBudgetSteps, [](StudyRun& run) {
            if (run.light) return describeErrorBudget(measureErrorBudget(run));
            StudySection section;
            section.id = "error-budget";
            section.title = kErrorBudgetTitle;
            section.missing = "needs a light: give one after the scene";
            return section;
          }};
}

}  // namespace shprt
