// The automatic camera shows every point, just so, for any mesh; cameras from text mean what they say.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "shprt/base/error.h"
#include "shprt/picture/camera_fit.h"
#include "shprt/picture/render.h"

namespace shprt {
namespace {

// The ends of the points in the picture, in units of half the picture: 1 is the frame itself.
struct Extent {
  double left = 1e30, right = -1e30, bottom = 1e30, top = -1e30;
};

Extent extent(const Camera& camera, double aspect, const std::vector<Vec3f>& points) {
  const CameraAxes axes = cameraAxes(camera.eye - camera.target, camera.up);
  const double tangent = std::tan(camera.verticalFovDegrees * std::numbers::pi / 360);
  Extent seen;
  for (const Vec3f& point : points) {
    const Vec3d p = toDouble(point) - camera.eye;
    const double depth = -dot(p, axes.back);
    EXPECT_GT(depth, 0);
    const double x = dot(p, axes.right) / (depth * tangent * aspect), y = dot(p, axes.up) / (depth * tangent);
    seen = {std::min(seen.left, x), std::max(seen.right, x), std::min(seen.bottom, y), std::max(seen.top, y)};
  }
  return seen;
}

// The largest picture coordinate of any point.
double fill(const Camera& camera, double aspect, const std::vector<Vec3f>& points) {
  const Extent seen = extent(camera, aspect, points);
  return std::max({-seen.left, seen.right, -seen.bottom, seen.top});
}

std::vector<Vec3f> box(Vec3f size, Vec3f offset) {
  std::vector<Vec3f> points;
  for (int i = 0; i < 8; ++i) {
    points.push_back(offset +
                     Vec3f{size.x * float(i & 1), size.y * float(i >> 1 & 1), size.z * float(i >> 2)});
  }
  return points;
}

TEST(FrameCamera, FillsThePictureUpToTheMarginWhateverTheMesh) {
  const std::vector<std::vector<Vec3f>> meshes = {
      box({1, 1, 1}, {0, 0, 0}),          box({1e-4f, 1e-4f, 1e-4f}, {0, 0, 0}),
      box({1e6f, 1e6f, 1e6f}, {0, 0, 0}), box({1, 1, 1}, {1e5f, -1e5f, 1e5f}),
      box({2, 0, 2}, {0, 3, 0}),          box({0, 2, 2}, {0, 0, 0}),
      box({2, 2, 0}, {0, 0, 0}),          box({100, 0.1f, 0.1f}, {0, 0, 0}),
      box({0.1f, 0.1f, 100}, {0, 0, 0}),  box({1e-4f, 1e-4f, 1e-4f}, {10, 10, 10})};
  for (std::size_t i = 0; i < meshes.size(); ++i)
    for (const double aspect : {4.0 / 3, 0.25, 5.0}) {
      SCOPED_TRACE("mesh " + std::to_string(i) + ", aspect " + std::to_string(aspect));
      const Camera camera = frameCamera(meshes[i], aspect);
      // The tightest fit touches the margin on one axis, exactly.
      EXPECT_NEAR(fill(camera, aspect, meshes[i]), 1 - kFrameMargin, 1e-6);
      // And the mesh is in the middle on both.
      const Extent seen = extent(camera, aspect, meshes[i]);
      EXPECT_NEAR(seen.left + seen.right, 0, 1e-6);
      EXPECT_NEAR(seen.bottom + seen.top, 0, 1e-6);
    }
}

TEST(FrameCamera, LooksFromTheFrontAboveAndRight) {
  const Camera camera = frameCamera(box({2, 2, 2}, {-1, -1, -1}), 1);
  const Vec3d toEye = normalize(camera.eye - camera.target);
  EXPECT_GT(toEye.z, toEye.x);
  EXPECT_GT(toEye.x, 0.1);
  EXPECT_GT(toEye.y, 0.1);
}

TEST(FrameCamera, PointsOnOneLineOfSightLeaveTheEyeApart) {
  const Vec3d d = orbitDirection(25, 20).toEye;
  const Camera camera = frameCamera(std::vector<Vec3f>{{0, 0, 0}, toFloat(d)}, 1);
  EXPECT_GT(dot(camera.eye, d), 1);
}

TEST(OrbitDirection, AnglesAreFromPlusZTowardsPlusXAndUp) {
  const auto expectNear = [](Vec3d a, Vec3d b) { EXPECT_LT(length(a - b), 1e-15); };
  expectNear(orbitDirection(0, 0).toEye, {0, 0, 1});
  expectNear(orbitDirection(90, 0).toEye, {1, 0, 0});
  expectNear(orbitDirection(0, 90).toEye, {0, 1, 0});
  expectNear(orbitDirection(0, 90).up, {0, 0, -1});
}

TEST(ParseCamera, TakesWhatIsGiven) {
  const std::vector<Vec3f> points = box({2, 2, 2}, {-1, -1, -1});
  const Camera camera = parseCamera("eye:1,2,3e0 target:0,-0.5,0;up:0,0,1 fov:40", points, 1);
  EXPECT_EQ(camera.eye, (Vec3d{1, 2, 3}));
  EXPECT_EQ(camera.target, (Vec3d{0, -0.5, 0}));
  EXPECT_EQ(camera.up, (Vec3d{0, 0, 1}));
  EXPECT_EQ(camera.verticalFovDegrees, 40);
}

TEST(ParseCamera, FramesAgainForAnotherFieldOfView) {
  const std::vector<Vec3f> points = box({2, 2, 2}, {-1, -1, -1});
  const Camera camera = parseCamera("fov:90", points, 1);
  EXPECT_NEAR(fill(camera, 1, points), 1 - kFrameMargin, 1e-9);
}

TEST(ParseCamera, OrbitTurnsTheAutomaticCamera) {
  const std::vector<Vec3f> points = box({2, 2, 2}, {-1, -1, -1});
  const Camera top = parseCamera("orbit:30,90", points, 1);
  EXPECT_LT(length(normalize(top.eye - top.target) - Vec3d{0, 1, 0}), 1e-12);
  EXPECT_NEAR(fill(top, 1, points), 1 - kFrameMargin, 1e-9);
  const Camera twice = parseCamera("orbit:30,90,2", points, 1);
  EXPECT_NEAR(length(twice.eye - twice.target), 2 * length(top.eye - top.target), 1e-9);
}

TEST(ParseCamera, RefusesWhatMeansNothing) {
  const std::vector<Vec3f> points = box({1, 1, 1}, {0, 0, 0});
  for (const char* text : {"",
                           " ",
                           "eye",
                           "eye:",
                           "eye:1,2",
                           "eye:1,2,3,4",
                           "eye:1,2,x",
                           "eye:1,2,nan",
                           "eye:1,2,inf",
                           "eye:1,2,3 eye:1,2,3",
                           "fov:0",
                           "fov:180",
                           "fov:40,2",
                           "lens:3",
                           "orbit:1",
                           "orbit:0,91",
                           "orbit:0,0,0",
                           "orbit:0,0,1,1",
                           "orbit:0,0 up:0,1,0",
                           "eye:1,1,1 target:1,1,1",
                           "up:0,0,0",
                           "eye:0,5,0 target:0,0,0 up:0,1,0"}) {
    EXPECT_THROW(parseCamera(text, points, 1), Error) << text;
  }
}

}  // namespace
}  // namespace shprt
