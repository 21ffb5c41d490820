// Lights of a study as skies that paths can be traced under.
#pragma once

#include "shprt/coefficients/light_coefficients.h"
#include "shprt/image/environment.h"
#include "shprt/transfer/sky_sampler.h"

namespace shprt {

// A probe as the picture of constant pixels that projectProbe integrates: the radiance of the pixel that
// shows a direction, not interpolated, any layout. Pixels that are not finite are black, and the rest is as
// much brighter as stands for them; negative pixels stay. Directions are drawn by luminance, of
// magnitudes.
class ProbeSky final : public Sky {
 public:
  // The map must outlive it.
  explicit ProbeSky(const EnvironmentMap& map);

  Vec3d radiance(Vec3d direction) const override;
  Vec3d sample(double u, double v) const override { return sampler_.sample(u, v); }
  double density(Vec3d direction) const override { return sampler_.density(direction); }

 private:
  const EnvironmentMap& map_;
  double scale_;
  SkySampler sampler_;
};

// The light that coefficients stand for, negative lobes and all, with bands up to `degree`, and
// kMaximumBakeDegree, at most.
class ExpandedSky final : public Sky {
 public:
  ExpandedSky(const LightCoefficients& light, int degree);

  Vec3d radiance(Vec3d direction) const override;
  Vec3d sample(double u, double v) const override { return sampler_.sample(u, v); }
  double density(Vec3d direction) const override { return sampler_.density(direction); }

 private:
  LightCoefficients light_;
  SkySampler sampler_;
};

}  // namespace shprt
