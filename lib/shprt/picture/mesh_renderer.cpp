// Pictures by one ray per sample: nearest triangle, radiance interpolated between its corners, the sky
// behind. A pixel depends on nothing but its own samples, so any number of threads gives the same bits.
#include <cassert>
#include <cmath>
#include <cstddef>
#include <mutex>
#include <numbers>
#include <utility>

#include "shprt/base/box.h"
#include "shprt/base/parallel.h"
#include "shprt/mesh/mesh.h"
#include "shprt/mesh/opposite_triangles.h"
#include "shprt/picture/camera_fit.h"
#include "shprt/picture/pixel_samples.h"
#include "shprt/picture/render.h"
#include "shprt/scene/ray_caster.h"
#include "shprt/scene/scene_frame.h"

namespace shprt {
namespace {

constexpr std::size_t kRowsPerBlock = 4;

// Rays through the pixels of a pinhole camera.
class CameraRays {
 public:
  CameraRays(const Camera& camera, int width, int height)
      : axes_(cameraAxes(camera.eye - camera.target, camera.up)), width_(width), height_(height) {
    tangent_ = std::tan(camera.verticalFovDegrees * std::numbers::pi / 360);
  }

  // The unit direction through a pixel position; pixel centres at +0.5, rows from the top.
  Vec3d direction(double x, double y) const {
    const double right = (2 * x - width_) / height_ * tangent_;
    const double up = (1 - 2 * y / height_) * tangent_;
    return normalize(axes_.right * right + axes_.up * up - axes_.back);
  }

 private:
  CameraAxes axes_;
  double width_, height_;
  double tangent_ = 0;
};

struct Ball {
  Vec3d centre;
  double radius = 0;
};

Ball boundingBall(std::span<const Vec3f> positions) {
  const auto [low, high] = boxAround(positions);
  return {(low + high) * 0.5, length(high - low) * 0.5 * (1 + 1e-6)};
}

// Moves the origin of a ray up to the ball, in double, so that tracing in float starts near the mesh however
// far the eye is. False when the ray misses the ball.
bool advanceTo(const Ball& ball, Vec3d& origin, Vec3d direction) {
  const Vec3d toCentre = ball.centre - origin;
  const double along = dot(toCentre, direction);
  const Vec3d across = toCentre - direction * along;
  const double halfChordSquared = ball.radius * ball.radius - dot(across, across);
  if (halfChordSquared < 0) return false;
  const double halfChord = std::sqrt(halfChordSquared);
  if (along + halfChord < 0) return false;
  if (along > halfChord) origin += direction * (along - halfChord);
  return true;
}

Vec3d behind(const RenderOptions& options, Vec3d direction) {
  if (options.environment) {
    const Vec3d unrotated = transpose(options.environmentRotation) * direction;
    return toDouble(sampleEnvironment(*options.environment, unrotated)) *
           static_cast<double>(options.environmentScale);
  }
  return toDouble(options.background.value_or(Vec3f{}));
}

}  // namespace

struct MeshRenderer::Impl {
  Impl(std::span<const Vec3f> positions, std::span<const Vec3f> normals,
       std::span<const std::array<std::uint32_t, 3>> triangles)
      : frame(chooseSceneFrame(positions)),
        mesh(makeMesh(toScene(frame, positions), normals, triangles)),
        opposite(oppositeTriangles(mesh)),
        ball(boundingBall(mesh.positions)),
        caster(mesh.positions, mesh.triangles) {}

  static Mesh makeMesh(std::vector<Vec3f> positions, std::span<const Vec3f> normals,
                       std::span<const std::array<std::uint32_t, 3>> triangles) {
    Mesh mesh;
    mesh.positions = std::move(positions);
    mesh.normals.assign(normals.begin(), normals.end());
    mesh.triangles.assign(triangles.begin(), triangles.end());
    return mesh;
  }

  Vec3f position(std::uint32_t triangle, std::size_t corner) const {
    return mesh.positions[mesh.triangles[triangle][corner]];
  }

  // Whether something that comes along the direction meets the triangle's front.
  bool facesAgainst(Vec3d direction, std::uint32_t triangle) const {
    const Vec3d origin = toDouble(position(triangle, 0));
    const Vec3d across =
        cross(toDouble(position(triangle, 1)) - origin, toDouble(position(triangle, 2)) - origin);
    Vec3d outside;
    for (const std::uint32_t corner : mesh.triangles[triangle]) outside += toDouble(mesh.normals[corner]);
    return dot(across, direction) * dot(across, outside) < 0;
  }

  // Which of two triangles back to back a ray meets is chance; this is the one that it sees.
  RayHit towardsEye(const RayHit& hit, Vec3d direction) const {
    const std::uint32_t other = opposite[hit.triangle];
    if (other == kNoTriangle || facesAgainst(direction, hit.triangle) || !facesAgainst(direction, other))
      return hit;
    const std::array<float, 3> weights = {1 - hit.u - hit.v, hit.u, hit.v};
    const auto weightAt = [&](Vec3f place) {
      std::size_t corner = 0;
      while (corner < 2 && position(hit.triangle, corner) != place) ++corner;
      return weights[corner];
    };
    return {hit.distance, other, weightAt(position(other, 1)), weightAt(position(other, 2))};
  }

  SceneFrame frame;
  Mesh mesh;                            // positions, in the scene's frame, normals and triangles only
  std::vector<std::uint32_t> opposite;  // per triangle
  Ball ball;
  RayCaster caster;
};

MeshRenderer::MeshRenderer(std::span<const Vec3f> positions, std::span<const Vec3f> normals,
                           std::span<const std::array<std::uint32_t, 3>> triangles)
    : impl_(std::make_unique<Impl>(positions, normals, triangles)) {}

MeshRenderer::~MeshRenderer() = default;

Image MeshRenderer::render(const Camera& camera, std::span<const Vec3f> radiance,
                           const RenderOptions& options, const ProgressCallback& progress) const {
  assert(options.width > 0 && options.height > 0 && options.samples > 0);
  const CameraRays rays(camera, options.width, options.height);
  const Vec3d eye = (camera.eye - impl_->frame.offset) * impl_->frame.scale;
  const std::vector<PixelOffset> offsets = tentOffsets(options.samples);

  const auto seen = [&](Vec3d direction) {
    Vec3d origin = eye;
    if (!advanceTo(impl_->ball, origin, direction)) return behind(options, direction);
    const RayHit nearest = impl_->caster.intersect(toFloat(origin), toFloat(direction));
    if (nearest.distance < 0) return behind(options, direction);
    const RayHit hit = impl_->towardsEye(nearest, direction);
    const std::array<std::uint32_t, 3>& corners = impl_->mesh.triangles[hit.triangle];
    const double u = hit.u, v = hit.v;
    return toDouble(radiance[corners[0]]) * (1 - u - v) + toDouble(radiance[corners[1]]) * u +
           toDouble(radiance[corners[2]]) * v;
  };

  Image image;
  image.width = options.width;
  image.height = options.height;
  image.pixels.resize(static_cast<std::size_t>(options.width) * static_cast<std::size_t>(options.height));
  std::mutex mutex;
  ProgressReport report;
  report.total = static_cast<std::uint64_t>(options.height);
  parallelForBlocks(
      static_cast<std::size_t>(options.height), kRowsPerBlock, [&](std::size_t begin, std::size_t end) {
        for (std::size_t y = begin; y < end; ++y) {
          for (int x = 0; x < options.width; ++x) {
            Vec3d sum;
            for (const PixelOffset& offset : offsets) {
              sum += seen(rays.direction(x + 0.5 + offset.x, static_cast<double>(y) + 0.5 + offset.y));
            }
            image.at(x, static_cast<int>(y)) = toFloat(sum / static_cast<double>(offsets.size()));
          }
        }
        if (!progress) return;
        const std::lock_guard lock(mutex);
        report.done += end - begin;
        report.rays += (end - begin) * static_cast<std::uint64_t>(options.width) * offsets.size();
        progress(report);
      });
  return image;
}

}  // namespace shprt
