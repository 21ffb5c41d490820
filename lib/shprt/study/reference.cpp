#include "shprt/study/reference.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>

#include "shprt/sampling/random.h"
#include "shprt/study/curve_effort.h"
#include "shprt/transfer/transfer_rows.h"

namespace shprt {
namespace {

double sumOfSquares(const Vec3f& v) {
  const Vec3d d = toDouble(v);
  return dot(d, d);
}

// Receivers that are not in the (increasing) sample become blockers: every object is doubled.
void keepReceivers(Scene& scene, std::span<const std::uint32_t> vertices) {
  const auto objects = static_cast<std::uint32_t>(scene.objects.size());
  for (std::uint32_t i = 0; i < objects; ++i) {
    SceneObject rest = scene.objects[i];
    rest.role = Role::kBlocker;
    scene.objects.push_back(std::move(rest));
  }
  for (std::uint32_t vertex = 0; vertex < scene.vertexObjects.size(); ++vertex) {
    if (!std::binary_search(vertices.begin(), vertices.end(), vertex)) scene.vertexObjects[vertex] += objects;
  }
}

// The vertices whose bake does not depend on whether others are baked, as numbers for the journal.
std::vector<double> withoutBuried(const Scene& scene, const std::vector<std::uint32_t>& vertices) {
  const ShadowedOptions glance{.degree = 0, .rays = 64};
  const std::vector<std::uint32_t> receivers = receiverVertices(scene);
  const TransferCoefficients whole = VertexSample(scene, receivers).bake(glance),
                             alone = VertexSample(scene, vertices).bake(glance);
  std::vector<double> kept;
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const auto found = std::lower_bound(receivers.begin(), receivers.end(), vertices[i]);
    if (whole.row(0, 0)[found - receivers.begin()] == alone.row(0, 0)[i]) kept.push_back(vertices[i]);
  }
  return kept;
}

}  // namespace

TransferCoefficients selectColumns(const TransferCoefficients& transfer,
                                   std::span<const std::uint32_t> vertices) {
  TransferCoefficients columns = makeTransfer(transfer.channels, vertices.size(), transfer.degree);
  for (int channel = 0; channel < transfer.channels; ++channel)
    for (int i = 0; i < transfer.rows(); ++i) {
      const float* row = transfer.row(channel, i);
      std::transform(vertices.begin(), vertices.end(), columns.row(channel, i),
                     [row](std::uint32_t vertex) { return row[vertex]; });
    }
  return columns;
}

std::vector<std::uint32_t> receiverVertices(const Scene& scene) {
  std::vector<std::uint32_t> receivers;
  for (std::uint32_t vertex = 0; vertex < scene.vertexObjects.size(); ++vertex)
    if (scene.isReceiver(vertex)) receivers.push_back(vertex);
  return receivers;
}

Scene shadowScene(const Scene& scene) {
  Scene shadows;
  shadows.mesh = scene.mesh;
  shadows.albedo = scene.albedo;
  shadows.vertexObjects = scene.vertexObjects;
  shadows.objects = scene.objects;
  shadows.materials = scene.materials;
  for (SurfaceMaterial& material : shadows.materials) {
    material.texture.reset();
    material.emission = {};
  }
  return shadows;
}

std::vector<std::uint32_t> drawVertices(const Scene& scene, std::size_t atMost, std::uint64_t seed) {
  const std::vector<std::uint32_t> receivers = receiverVertices(scene);
  const std::size_t count = std::min(atMost, receivers.size());
  std::vector<std::uint32_t> vertices;
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t begin = i * receivers.size() / count, end = (i + 1) * receivers.size() / count;
    const double u = uniformRandom(seed, i, 0);
    vertices.push_back(receivers[begin + static_cast<std::size_t>(u * static_cast<double>(end - begin))]);
  }
  return vertices;
}

VertexSample::VertexSample(const Scene& scene, std::vector<std::uint32_t> vertices)
    : scene_(scene), vertices_(std::move(vertices)) {}

const PreparedScene& VertexSample::prepared() const {
  if (!prepared_) {
    alone_ = std::make_unique<Scene>(shadowScene(scene_));
    keepReceivers(*alone_, vertices_);
    prepared_ = std::make_unique<PreparedScene>(*alone_);
  }
  return *prepared_;
}

TransferCoefficients VertexSample::bake(const ShadowedOptions& options) const {
  return selectColumns(bakeShadowed(prepared(), options).transfer, vertices_);
}

double rmsNorm(const TransferCoefficients& transfer) {
  double sum = 0;
  for (const float value : transfer.values) sum += static_cast<double>(value) * static_cast<double>(value);
  return std::sqrt(shareOf(sum, static_cast<double>(transfer.vertexCount) * transfer.channels));
}

double rmsDifference(const TransferCoefficients& a, const TransferCoefficients& b) {
  assert(a.values.size() == b.values.size() && a.vertexCount == b.vertexCount);
  double sum = 0;
  for (std::size_t i = 0; i < a.values.size(); ++i) {
    const double difference = static_cast<double>(a.values[i]) - static_cast<double>(b.values[i]);
    sum += difference * difference;
  }
  return std::sqrt(shareOf(sum, static_cast<double>(a.vertexCount) * a.channels));
}

double unshadowedRms(const Scene& scene, std::span<const std::uint32_t> vertices, int degree) {
  double sum = 0;
  for (const std::uint32_t vertex : vertices) sum += sumOfSquares(scene.albedo[vertex]);
  return unshadowedNorm(degree) * std::sqrt(shareOf(sum, 3 * static_cast<double>(vertices.size())));
}

double radianceError(std::span<const Vec3f> radiance, std::span<const Vec3f> reference) {
  assert(radiance.size() == reference.size());
  double difference = 0, whole = 0;
  for (std::size_t i = 0; i < radiance.size(); ++i) {
    difference += sumOfSquares(radiance[i] - reference[i]);
    whole += sumOfSquares(reference[i]);
  }
  return std::sqrt(shareOf(difference, whole));
}

double shareOf(double a, double b) {
  return b > 0 ? a / b : 0;
}

VertexSample sampleOf(const StudyRun& run) {
  const Scene& scene = run.prepared.scene;
  const std::size_t atMost = curveEffort(run.options).vertices;
  const std::uint64_t seed = run.options.seed;
  const std::vector<double> kept =
      run.journal.measure(fmt::format("vertices: {}, seed {}", atMost, seed), [&] {
        const std::vector<std::uint32_t> drawn = drawVertices(scene, atMost, seed);
        return withoutBuried(scene, drawn);
      });
  return {scene, std::vector<std::uint32_t>(kept.begin(), kept.end())};
}

std::uint64_t referenceSeed(const StudyOptions& options) {
  return hashCounter(options.seed, 0);
}

}  // namespace shprt
