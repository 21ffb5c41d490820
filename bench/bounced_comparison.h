// How near interpolated vertices come to light that bounces, measured against a much finer mesh of the same
// surfaces.
#pragma once

#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "shprt/scene/refine_scene.h"
#include "shprt/sh/basis.h"
#include "shprt/transfer/fitted.h"
#include "shprt/transfer/light_solution.h"
#include "shprt/transfer/sample_transfer.h"
#include "shprt/transfer/sent_light.h"
#include "shprt/transfer/transfer_rows.h"

namespace shprt::bench {

// Of coefficients times albedo, over area: the 2-norm of what interpolation misses, over that of the
// unshadowed transfer; the same of what the scene's own lights bring, over what they bring. In percent.
struct BouncedError {
  double transfer, emission;
};

class BouncedComparison {
 public:
  // The truth: the scene with no edge longer than maxEdge, and samples on it that gather from its vertices.
  BouncedComparison(const Scene& scene, double maxEdge, int degree, int truthRays)
      : original_(scene.mesh.positions.size()),
        degree_(degree),
        refined_(splitLongEdges(scene, maxEdge, RefinedObjects::kAll)),
        prepared_(refined_.scene) {
    BakeStatistics statistics;
    const LightSolution light = solveLight(
        prepared_, {.degree = degree, .rays = truthRays, .seed = 1001, .error = 1e-3}, {}, statistics);
    layout_ = light.layout;
    LightRows sent(refined_.scene.mesh.positions.size(), layout_.columns());
    sendBack(refined_.scene, prepared_.topology, layout_, light.received, sent);
    samples_ =
        sampleSurface(refined_.scene, prepared_.topology, {.perTriangle = 1, .minimum = 1, .seed = 1000});
    SampleTransfer measured = gatherSamples(
        prepared_, samples_, {.degree = degree, .rays = truthRays, .seed = 1001}, layout_, sent);
    removeSamples(measured.buried, samples_, measured.transfer);
    truth_ = std::move(measured.transfer);
  }

  std::size_t vertices() const { return refined_.scene.mesh.positions.size(); }

  BouncedError errorOf(const Bake& bake) const {
    const std::vector<float> values = onRefined(bake);
    const std::size_t vertexCount = vertices();
    const double unshadowed = unshadowedNorm();
    double squares = 0, unit = 0, emissionSquares = 0, emissionUnit = 0;
    for (std::size_t s = 0; s < samples_.size(); ++s) {
      const SurfaceSample& sample = samples_[s];
      const auto& [a, b, c] = refined_.scene.mesh.triangles[sample.triangle];
      const Vec3f albedo = refined_.scene.albedoAt(sample.triangle, sample.u, sample.v);
      const float channelAlbedo[3] = {albedo.x, albedo.y, albedo.z};
      for (int i = 0; i < layout_.bandCount(); ++i) {
        const LightLayout::Band band = layout_.band(i);
        const bool emission = i >= layout_.channels;
        const auto reflected = static_cast<double>(channelAlbedo[band.albedoChannel]);
        for (std::size_t column = band.first; column < band.end; ++column) {
          const float* value = values.data() + column * vertexCount;
          const double truth = reflected * static_cast<double>(truth_.at(s)[column]);
          const double error = static_cast<double>(value[a] * (1 - sample.u - sample.v) +
                                                   value[b] * sample.u + value[c] * sample.v) -
                               truth;
          (emission ? emissionSquares : squares) += sample.weight * error * error;
          if (emission) emissionUnit += sample.weight * truth * truth;
        }
        if (!emission) unit += sample.weight * reflected * reflected * unshadowed * unshadowed;
      }
    }
    return {100 * std::sqrt(squares / unit),
            emissionUnit > 0 ? 100 * std::sqrt(emissionSquares / emissionUnit) : 0};
  }

 private:
  // What interpolation over the original triangles gives the refined mesh's vertices: [column][vertex].
  std::vector<float> onRefined(const Bake& bake) const {
    const std::size_t vertexCount = vertices();
    std::vector<float> values(layout_.columns() * vertexCount);
    std::vector<Vec3f> own = ownEmission(refined_.scene);
    for (std::size_t column = 0; column < layout_.columns(); ++column) {
      float* value = values.data() + column * vertexCount;
      for (std::size_t vertex = 0; vertex < original_; ++vertex) {
        if (column < layout_.emissionColumn()) {
          value[vertex] = bake.transfer.values[column * original_ + vertex];
        } else {
          const Vec3f received = bake.emission[vertex] - own[vertex];
          const float channels[3] = {received.x, received.y, received.z};
          value[vertex] = channels[column - layout_.emissionColumn()];
        }
      }
      for (std::size_t i = 0; i < refined_.vertexParents.size(); ++i) {
        const auto& [p, q] = refined_.vertexParents[i];
        value[original_ + i] = (value[p] + value[q]) / 2;
      }
    }
    return values;
  }

  double unshadowedNorm() const {
    std::vector<double> unshadowed(static_cast<std::size_t>(coefficientCount(degree_)));
    UnshadowedTransfer(degree_).evaluate({0, 0, 1}, unshadowed);
    double squares = 0;
    for (const double c : unshadowed) squares += c * c;
    return std::sqrt(squares);
  }

  std::size_t original_;
  int degree_;
  RefinedScene refined_;
  PreparedScene prepared_;
  LightLayout layout_;
  std::vector<SurfaceSample> samples_;
  SampleValues truth_;
};

}  // namespace shprt::bench
