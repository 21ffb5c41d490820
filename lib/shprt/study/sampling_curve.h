// Error and seconds of shadowed transfer against rays, for sets of directions: measured once for every
// experiment that asks, by way of the journal.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "shprt/sampling/hemisphere_set.h"
#include "shprt/study/curve_effort.h"
#include "shprt/study/reference.h"
#include "shprt/study/study_run.h"

namespace shprt {

// A way to choose directions and to use them.
struct SamplingMethod {
  std::string id, name;  // for figures; for people
  PointSet points;
  bool controlVariate;
};
// Plain random and jittered directions, as others use them; then the sets with the control variate. The last
// is what bakes use.
const std::vector<SamplingMethod>& samplingMethods();

class SamplingMeasurements {
 public:
  explicit SamplingMeasurements(StudyRun& run);
  SamplingMeasurements(const SamplingMeasurements&) = delete;
  SamplingMeasurements& operator=(const SamplingMeasurements&) = delete;

  // The reference: shadowed transfer of options.degree at the sample's vertices.
  const TransferCoefficients& reference() { return reference_.get(); }
  const VertexSample& sample() const { return sample_; }
  std::string referenceName() const;  // for keys

  // Of transfer at the sample's vertices (one column each).
  double errorOf(const TransferCoefficients& transfer);
  // RMS error with so many rays per vertex.
  double error(const SamplingMethod& method, int rays);
  // What a bake of the whole scene spends on rays; nothing where they are too many for the effort.
  std::optional<double> seconds(const SamplingMethod& method, int rays);
  // Whether a bake of the whole scene with so many rays is within the effort.
  bool affordable(double raysPerPoint) const;

  // The scene without lights of its own: they play no part in shadows.
  const PreparedScene& shadowScene() { return emits_ ? dark_.get()->prepared : run_.prepared; }

 private:
  struct Dark {
    Scene scene;
    PreparedScene prepared;
    explicit Dark(const Scene& lit) : scene(shprt::shadowScene(lit)), prepared(scene) {}
  };
  ShadowedOptions optionsOf(const SamplingMethod& method, int rays) const;

  StudyRun& run_;
  CurveEffort effort_;
  VertexSample sample_;
  bool emits_;
  std::uint64_t points_;
  Lazy<TransferCoefficients> reference_;
  Lazy<std::unique_ptr<Dark>> dark_;
};

// Where a curve of (rays, error) that falls reaches an error: between its points along straight lines in
// log-log, beyond them along its slope. Nothing where it has no slope that falls, or the error is not
// positive.
std::optional<double> raysForError(const std::vector<std::pair<double, double>>& points, double error);

}  // namespace shprt
