// Based on: Kajiya 1986 (random walks for the rendering equation), Arvo and Kirk 1990 (Russian roulette).
#include "tests/transfer/path_tracer.h"

#if __has_include(<embree4/rtcore.h>)
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>

#include "shprt/base/frame.h"
#include "shprt/base/parallel.h"
#include "shprt/sampling/hemisphere.h"
#include "shprt/sampling/random.h"
#include "shprt/sh/basis.h"

namespace shprt::test {
namespace {

// Where rays leave a facet, in units in which the scene is between 1 and 2 wide: some dozen roundings of a
// float coordinate, so that no ray begins on the wrong side of its own facet.
constexpr double kClearance = 2e-6;

// Independent numbers without end for one walk.
class RandomStream {
 public:
  RandomStream(std::uint64_t seed, std::uint64_t index, std::uint64_t path)
      : seed_(hashCounter(hashCounter(seed, index), path)) {}
  double next() { return static_cast<double>(hashCounter(seed_, counter_++) >> 11) * 0x1p-53; }

 private:
  std::uint64_t seed_, counter_ = 0;
};

// Where the line through o along d meets the plane of a triangle, as barycentrics of its corners 1 and 2.
std::pair<double, double> barycentrics(Vec3d o, Vec3d d, Vec3d a, Vec3d b, Vec3d c) {
  const Vec3d e1 = b - a, e2 = c - a, s = o - a, p = cross(d, e2), q = cross(s, e1);
  const double determinant = dot(e1, p);
  double u = std::clamp(dot(s, p) / determinant, 0.0, 1.0), v = std::clamp(dot(d, q) / determinant, 0.0, 1.0);
  if (u + v > 1) u /= u + v, v = 1 - u;
  return {u, v};
}

// Positions of the corners in an order that does not depend on the triangle's.
std::array<std::array<float, 3>, 3> cornersOf(const Mesh& mesh, std::uint32_t triangle) {
  std::array<std::array<float, 3>, 3> corners;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3f p = mesh.positions[mesh.triangles[triangle][k]];
    corners[k] = {p.x, p.y, p.z};
  }
  std::sort(corners.begin(), corners.end());
  return corners;
}

double largest(Vec3f a) {
  return std::max({a.x, a.y, a.z});
}
Vec3d times(Vec3d a, Vec3f b) {
  return {a.x * b.x, a.y * b.y, a.z * b.z};
}

// Sums and sums of squares of one walk's results.
struct Moments {
  std::vector<Vec3d> sum, squares;

  explicit Moments(std::size_t count) : sum(count), squares(count) {}
  void add(std::size_t i, Vec3d x) {
    sum[i] += x;
    squares[i] += Vec3d{x.x * x.x, x.y * x.y, x.z * x.z};
  }
  void add(const Moments& other) {
    for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += other.sum[i], squares[i] += other.squares[i];
  }
  Vec3d mean(std::size_t i, int n) const { return sum[i] / static_cast<double>(n); }
  Vec3d error(std::size_t i, int n) const {
    const Vec3d m = mean(i, n);
    const auto of = [&](double square, double average) {
      return std::sqrt(std::max(square / n - average * average, 0.0) / std::max(n - 1, 1));
    };
    return {of(squares[i].x, m.x), of(squares[i].y, m.y), of(squares[i].z, m.z)};
  }
};

}  // namespace

struct PathTracer::Hit {
  std::uint32_t triangle;
  double u, v;
  Vec3d position;
};

struct PathTracer::Impl {
  RTCDevice device = nullptr;
  RTCScene scene = nullptr;

  ~Impl() {
    rtcReleaseScene(scene);
    rtcReleaseDevice(device);
  }
};

PathTracer::~PathTracer() = default;

PathTracer::PathTracer(const Scene& scene)
    : scene_(scene), trianglesAt_(scene.mesh.positions.size()), impl_(std::make_unique<Impl>()) {
  const Mesh& mesh = scene.mesh;
  Vec3d low = toDouble(mesh.positions[0]), high = low;
  for (const Vec3f& p : mesh.positions) {
    low = {std::min<double>(low.x, p.x), std::min<double>(low.y, p.y), std::min<double>(low.z, p.z)};
    high = {std::max<double>(high.x, p.x), std::max<double>(high.y, p.y), std::max<double>(high.z, p.z)};
  }
  const Vec3d extent = high - low, centre = (low + high) * 0.5;
  const double scale = std::exp2(-std::floor(std::log2(std::max({extent.x, extent.y, extent.z}))));
  for (const Vec3f& p : mesh.positions) positions_.push_back((toDouble(p) - centre) * scale);

  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto& [a, b, c] = mesh.triangles[t];
    const Vec3d normal = normalize(cross(positions_[b] - positions_[a], positions_[c] - positions_[a]));
    const Vec3d outward = toDouble(mesh.normals[a]) + toDouble(mesh.normals[b]) + toDouble(mesh.normals[c]);
    fronts_.push_back(dot(normal, outward) < 0 ? -normal : normal);
    for (const std::uint32_t corner : mesh.triangles[t]) trianglesAt_[corner].push_back(t);
    coincident_[cornersOf(mesh, t)].push_back(t);
  }
  std::erase_if(coincident_, [](const auto& entry) { return entry.second.size() < 2; });

  impl_->device = rtcNewDevice(nullptr);
  impl_->scene = rtcNewScene(impl_->device);
  rtcSetSceneFlags(impl_->scene, RTC_SCENE_FLAG_ROBUST);
  RTCGeometry geometry = rtcNewGeometry(impl_->device, RTC_GEOMETRY_TYPE_TRIANGLE);
  auto* vertices = static_cast<Vec3f*>(rtcSetNewGeometryBuffer(
      geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, sizeof(Vec3f), positions_.size()));
  auto* indices = static_cast<Triangle*>(rtcSetNewGeometryBuffer(
      geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, sizeof(Triangle), mesh.triangles.size()));
  std::transform(positions_.begin(), positions_.end(), vertices, toFloat);
  std::copy(mesh.triangles.begin(), mesh.triangles.end(), indices);
  rtcCommitGeometry(geometry);
  rtcAttachGeometry(impl_->scene, geometry);
  rtcReleaseGeometry(geometry);
  rtcCommitScene(impl_->scene);
}

std::optional<PathTracer::Hit> PathTracer::nearest(Vec3d origin, Vec3d direction) const {
  const Vec3f o = toFloat(origin), d = toFloat(direction);
  RTCRayHit ray{};
  ray.ray.org_x = o.x, ray.ray.org_y = o.y, ray.ray.org_z = o.z;
  ray.ray.dir_x = d.x, ray.ray.dir_y = d.y, ray.ray.dir_z = d.z;
  ray.ray.tfar = std::numeric_limits<float>::infinity();
  ray.ray.mask = ~0u;
  ray.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  ray.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
#if RTC_VERSION_MAJOR >= 4
  rtcIntersect1(impl_->scene, &ray);
#else
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  rtcIntersect1(impl_->scene, &context, &ray);
#endif
  if (ray.hit.geomID == RTC_INVALID_GEOMETRY_ID) return std::nullopt;

  std::uint32_t triangle = ray.hit.primID;
  if (dot(fronts_[triangle], direction) >= 0) {
    if (const auto found = coincident_.find(cornersOf(scene_.mesh, triangle)); found != coincident_.end())
      for (const std::uint32_t other : found->second)
        if (dot(fronts_[other], direction) < 0) triangle = other;
  }
  const auto& [a, b, c] = scene_.mesh.triangles[triangle];
  const auto [u, v] = barycentrics(origin, direction, positions_[a], positions_[b], positions_[c]);
  return Hit{triangle, u, v, positions_[a] * (1 - u - v) + positions_[b] * u + positions_[c] * v};
}

PathEstimate PathTracer::estimate(const std::vector<Vec3d>& starts, Vec3d normal, std::uint64_t index,
                                  const PathOptions& options) const {
  constexpr double kMostLikelyToGoOn = 0.95;
  const auto count = static_cast<std::size_t>(coefficientCount(options.degree));
  const std::size_t block = 512, paths = static_cast<std::size_t>(options.paths);
  std::vector<Moments> blocks((paths + block - 1) / block, Moments(count + 1));  // the last entry: emission
  parallelForBlocks(paths, block, [&](std::size_t begin, std::size_t end) {
    Moments& moments = blocks[begin / block];
    std::vector<double> y(count);
    for (std::size_t path = begin; path < end; ++path) {
      RandomStream random(options.seed, index, path);
      const double choice = random.next() * static_cast<double>(starts.size());
      Vec3d position = starts[static_cast<std::size_t>(choice)];
      Frame frame = frameFromNormal(normal);
      Vec3d throughput{1, 1, 1}, emission;
      for (int bounces = 0;; ++bounces) {
        const double squaredRadius = random.next(), turn = random.next();
        const Vec3d direction = frame.toWorld(sampleCosineHemisphere(squaredRadius, turn));
        const std::optional<Hit> hit = nearest(position, direction);
        if (!hit) {
          evaluateSh(options.degree, direction, y);
          for (std::size_t i = 0; i < count; ++i) moments.add(i, throughput * y[i]);
          break;
        }
        const Vec3d front = fronts_[hit->triangle];
        if (dot(front, direction) >= 0) break;
        emission += times(throughput, scene_.materialOf(hit->triangle).emission);
        if (options.bounces && bounces == *options.bounces) break;
        const Vec3f albedo =
            scene_.albedoAt(hit->triangle, static_cast<float>(hit->u), static_cast<float>(hit->v));
        throughput = times(throughput, albedo);
        if (!options.bounces) {
          const double goOn = std::min<double>(largest(albedo), kMostLikelyToGoOn);
          if (random.next() >= goOn) break;
          throughput = throughput / goOn;
        }
        position = hit->position + front * kClearance;
        frame = frameFromNormal(front);
      }
      moments.add(count, emission);
    }
  });
  Moments total(count + 1);
  for (const Moments& moments : blocks) total.add(moments);
  PathEstimate result;
  for (std::size_t i = 0; i < count; ++i) {
    result.transfer.push_back(total.mean(i, options.paths));
    result.transferError.push_back(total.error(i, options.paths));
  }
  result.emission = total.mean(count, options.paths);
  result.emissionError = total.error(count, options.paths);
  return result;
}

bool PathTracer::isInside(Vec3d start, Vec3d normal) const {
  constexpr int kProbes = 64;
  const Frame frame = frameFromNormal(normal);
  RandomStream random(0, 0, 0);
  int backs = 0;
  for (int probe = 0; probe < kProbes; ++probe) {
    const double squaredRadius = random.next(), turn = random.next();
    const Vec3d direction = frame.toWorld(sampleCosineHemisphere(squaredRadius, turn));
    const std::optional<Hit> hit = nearest(start, direction);
    if (!hit) return false;
    if (dot(fronts_[hit->triangle], direction) > 0) ++backs;
  }
  return backs > kProbes / 2;
}

std::vector<Vec3d> PathTracer::startsAt(std::uint32_t vertex) const {
  const Vec3d position = positions_[vertex], normal = normalize(toDouble(scene_.mesh.normals[vertex]));
  std::vector<Vec3d> starts;
  for (const std::uint32_t t : trianglesAt_[vertex]) {
    const auto& [a, b, c] = scene_.mesh.triangles[t];
    const Vec3d aside = (positions_[a] + positions_[b] + positions_[c]) / 3.0 - position;
    const double up = std::max(1e-3 * length(aside), 16 * kClearance);
    starts.push_back(position + normal * up + normalize(aside) * (up / 16));
  }
  return starts;
}

double PathTracer::buriedShare(std::uint32_t vertex) const {
  const Vec3d normal = normalize(toDouble(scene_.mesh.normals[vertex]));
  const std::vector<Vec3d> starts = startsAt(vertex);
  const auto inside =
      std::count_if(starts.begin(), starts.end(), [&](Vec3d start) { return isInside(start, normal); });
  return static_cast<double>(inside) / static_cast<double>(starts.size());
}

PathEstimate PathTracer::atVertex(std::uint32_t vertex, const PathOptions& options) const {
  const Vec3d normal = normalize(toDouble(scene_.mesh.normals[vertex]));
  const std::vector<Vec3d> starts = startsAt(vertex);
  std::vector<Vec3d> open;
  std::copy_if(starts.begin(), starts.end(), std::back_inserter(open),
               [&](Vec3d start) { return !isInside(start, normal); });
  return estimate(open.empty() ? starts : open, normal, vertex, options);
}

PathEstimate PathTracer::inTriangle(std::uint32_t triangle, double u, double v,
                                    const PathOptions& options) const {
  const auto& [a, b, c] = scene_.mesh.triangles[triangle];
  const Vec3d position = positions_[a] * (1 - u - v) + positions_[b] * u + positions_[c] * v;
  const std::uint64_t index = (std::uint64_t{1} << 40) + triangle;
  return estimate({{position + fronts_[triangle] * kClearance}}, fronts_[triangle], index, options);
}

}  // namespace shprt::test
