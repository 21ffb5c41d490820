// The best bake of its scene that a study can afford: what errors of cheaper ones are measured against.
#pragma once

#include <optional>

#include "shprt/coefficients/transfer_asset.h"
#include "shprt/study/study_run.h"

namespace shprt {

// Errors are distances of responses (bake_response.h). With a light they are relative to the reference's
// radiance: degree, rays, bounces and storage all count. Without one they are relative to the unshadowed
// transfer of the asked degree, which is held fixed.
class StudyReference {
 public:
  // Bakes nothing yet: who has all measurements in the journal needs no reference. The run must outlive it.
  explicit StudyReference(const StudyRun& run);

  // Whether rays matter at all: something stands above a tangent plane, or the scene has lights.
  bool traces() const { return traces_; }
  int degree() const { return degree_; }
  int rays() const { return rays_; }  // per vertex; with another seed than the bakes that are judged
  double bounceError() const { return run_.options.quick ? 1e-3 : 1e-4; }  // what its bounces leave out
  // Of the bakes that measure one source of error alone, where degree does not matter.
  int pilotDegree() const { return pilotDegree_; }

  // Errors of an asset of the receivers: by all of its bands; by those up to `degree` only, the reference cut
  // off there as well; and what cutting off alone costs. The scale is above 0, see isBlack().
  double errorOf(const TransferAsset& asset);
  double errorWithin(int degree, const TransferAsset& asset);
  double errorOfDegree(int degree);
  // Distance of two, over the same scale.
  double difference(int degree, const TransferAsset& a, const TransferAsset& b);
  // Whether there is nothing to be relative to: no light falls on anything, or nothing reflects.
  bool isBlack() { return !(scale() > 0); }

 private:
  const LightCoefficients* light() const { return run_.light ? &run_.light->coefficients : nullptr; }
  const TransferAsset& asset();
  double scale();

  const StudyRun& run_;
  bool traces_;
  int degree_, rays_, pilotDegree_;
  std::optional<TransferAsset> asset_;
  std::optional<double> scale_;
};

}  // namespace shprt
