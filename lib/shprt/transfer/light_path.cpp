#include "shprt/transfer/light_path.h"

#include <algorithm>
#include <array>

#include "shprt/base/frame.h"
#include "shprt/sampling/hemisphere.h"
#include "shprt/sampling/random.h"

namespace shprt {
namespace {

// Of a triangle's size: far above the rounding of coordinates, far below what a vertex sees change.
constexpr float kNearby = 0.01f;

// Roulette begins after this many bounces, lets no path live on with more certainty than this, and lifts the
// throughput of those that do to at least a half.
constexpr int kCertainBounces = 2;
constexpr double kMostSurvival = 0.95;

double largest(Vec3d a) {
  return std::max({a.x, a.y, a.z});
}

Vec3d scaled(Vec3d a, Vec3f b) {
  return {a.x * static_cast<double>(b.x), a.y * static_cast<double>(b.y), a.z * static_cast<double>(b.z)};
}

}  // namespace

std::optional<ReflectingPoint> PathFollower::meet(const SurfacePoint& hit, Vec3d direction) const {
  const std::optional<SurfacePoint> front = prepared_.fronts().facing(hit, toFloat(direction));
  if (!front) return std::nullopt;
  const auto& [a, b, c] = prepared_.topology.triangles()[front->triangle];
  const auto at = [&](std::uint32_t vertex) { return toDouble(prepared_.topology.positions()[vertex]); };
  const double u = static_cast<double>(front->u), v = static_cast<double>(front->v);
  return ReflectingPoint{front->triangle, toFloat(at(a) * (1 - u - v) + at(b) * u + at(c) * v),
                         normalize(toDouble(prepared_.fronts().normal(front->triangle))),
                         prepared_.scene.albedoAt(front->triangle, front->u, front->v),
                         prepared_.scene.materialOf(front->triangle).emission};
}

std::optional<ReflectingPoint> PathFollower::meetNearby(const SurfacePoint& hit, Vec3d direction) const {
  return meet({hit.triangle, hit.u + (1.0f / 3 - hit.u) * kNearby, hit.v + (1.0f / 3 - hit.v) * kNearby},
              direction);
}

std::optional<ReflectingPoint> PathFollower::trace(const ReflectingPoint& from, Vec3d direction,
                                                   bool& reachesSky) const {
  const std::uint32_t back = prepared_.fronts().backOf(from.triangle);
  const std::array<std::uint32_t, 2> ignored = {std::min(from.triangle, back), std::max(from.triangle, back)};
  float x[kRayPacketSize] = {}, y[kRayPacketSize] = {}, z[kRayPacketSize] = {};
  x[0] = static_cast<float>(direction.x);
  y[0] = static_cast<float>(direction.y);
  z[0] = static_cast<float>(direction.z);
  RayPacketHits hits;
  reachesSky = !prepared_.caster.nearest(from.position, {x, y, z}, 1u, {{}, ignored, 0}, hits);
  if (reachesSky) return std::nullopt;
  return meet({hits.triangle[0], hits.u[0], hits.v[0]}, direction);
}

LightPath PathFollower::follow(const ReflectingPoint& first, std::uint64_t index) const {
  LightPath path;
  path.throughput = {1, 1, 1};
  std::optional<ReflectingPoint> here = first;
  for (unsigned dimension = 0; here && path.bounces < kMostBounces;) {
    ++path.bounces;
    path.emission += scaled(path.throughput, here->emission);
    path.throughput = scaled(path.throughput, here->albedo);
    const double u = uniformRandom(seed_, index, dimension++), v = uniformRandom(seed_, index, dimension++),
                 chance = uniformRandom(seed_, index, dimension++);
    const double brightness = largest(path.throughput);
    if (brightness <= 0) break;
    if (path.bounces > kCertainBounces) {
      const double survival = std::min(kMostSurvival, 2 * brightness);
      if (chance >= survival) break;
      path.throughput = path.throughput / survival;
    }
    path.direction = frameFromNormal(here->normal).toWorld(sampleCosineHemisphere(u, v));
    here = trace(*here, path.direction, path.reachesSky);
  }
  return path;
}

}  // namespace shprt
