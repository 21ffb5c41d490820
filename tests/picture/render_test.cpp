// Pictures whose pixels are known in closed form: constants, ramps, a filtered edge, the sky behind.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <numbers>

#include "shprt/base/parallel.h"
#include "shprt/picture/camera_fit.h"
#include "shprt/picture/pixel_samples.h"
#include "shprt/picture/render.h"

namespace shprt {
namespace {

using Triangles = std::vector<std::array<std::uint32_t, 3>>;
const Triangles kQuadTriangles = {{0, 1, 2}, {0, 2, 3}};

// A square in the plane z = 0 with half width `half` about (x, 0, 0).
std::vector<Vec3f> quad(float half, float x = 0) {
  return {{x - half, -half, 0}, {x + half, -half, 0}, {x + half, half, 0}, {x - half, half, 0}};
}

// Looks along -z from distance 1; the picture is 2 high and wide at z = 0.
Camera frontCamera() {
  Camera camera;
  camera.eye = {0, 0, 1};
  camera.target = {0, 0, 0};
  camera.verticalFovDegrees = 90;
  return camera;
}

RenderOptions smallPicture(int size, int samples) {
  RenderOptions options;
  options.width = options.height = size;
  options.samples = samples;
  options.background = Vec3f{0.25f, 0.5f, 0.75f};
  return options;
}

// Of meshes with no two triangles back to back, for which normals do not matter.
MeshRenderer makeRenderer(const std::vector<Vec3f>& positions, const Triangles& triangles) {
  return {positions, std::vector<Vec3f>(positions.size(), {0, 0, 1}), triangles};
}

bool sameBits(const Image& a, const Image& b) {
  return a.pixels.size() == b.pixels.size() &&
         std::memcmp(a.pixels.data(), b.pixels.data(), a.pixels.size() * sizeof(Vec3f)) == 0;
}

TEST(TentOffsets, HaveTheMomentsOfATent) {
  for (const int count : {1, 2, 3, 4, 16, 64, 1000}) {
    double x = 0, y = 0, xx = 0, yy = 0, xy = 0;
    for (const PixelOffset& o : tentOffsets(count)) {
      ASSERT_LT(std::fabs(o.x), 1);
      ASSERT_LT(std::fabs(o.y), 1);
      x += o.x / count, y += o.y / count;
      xx += o.x * o.x / count, yy += o.y * o.y / count, xy += o.x * o.y / count;
    }
    EXPECT_NEAR(x, 0, 1e-12) << count;
    EXPECT_NEAR(y, 0, 1e-12) << count;
    if (count < 16) continue;
    // Variance of the tent: 1/6. The lattice's error falls as 1/count.
    EXPECT_NEAR(xx, 1.0 / 6, 1.0 / count) << count;
    EXPECT_NEAR(yy, 1.0 / 6, 2.0 / count) << count;
    EXPECT_NEAR(xy, 0, 2.0 / count) << count;
  }
  EXPECT_EQ(tentOffsets(1)[0].x, 0);
  EXPECT_EQ(tentOffsets(1)[0].y, 0);
}

TEST(MeshRenderer, ConstantRadianceInFrontOfAPlainBackground) {
  const MeshRenderer renderer = makeRenderer(quad(0.5f), kQuadTriangles);
  const Image image = renderer.render(frontCamera(), std::vector<Vec3f>(4, {1, 2, 3}), smallPicture(16, 4));
  // The quad covers pixels 4..11; a tent reaches one pixel further.
  for (int y = 0; y < 16; ++y)
    for (int x = 0; x < 16; ++x) {
      if (x > 4 && x < 11 && y > 4 && y < 11) {
        EXPECT_NEAR(image.at(x, y).y, 2, 1e-6);
      } else if (x < 3 || x > 12 || y < 3 || y > 12) {
        EXPECT_NEAR(image.at(x, y).z, 0.75, 1e-6);
      }
    }
}

TEST(MeshRenderer, InterpolatesRadianceLinearly) {
  const std::vector<Vec3f> positions = quad(2);
  std::vector<Vec3f> radiance;
  for (const Vec3f& p : positions) radiance.push_back({3 + p.x, 5 + p.y, 4 + 0.5f * p.x - p.y});
  const Image image =
      makeRenderer(positions, kQuadTriangles).render(frontCamera(), radiance, smallPicture(8, 16));
  for (int row = 0; row < 8; ++row)
    for (int column = 0; column < 8; ++column) {
      // A plane across the view maps to the picture by a scale: the pixel's centre is (x, y).
      const double x = (column + 0.5) / 4 - 1, y = 1 - (row + 0.5) / 4;
      EXPECT_NEAR(image.at(column, row).x, 3 + x, 1e-5);
      EXPECT_NEAR(image.at(column, row).y, 5 + y, 1e-5);
      EXPECT_NEAR(image.at(column, row).z, 4 + 0.5 * x - y, 1e-5);
    }
}

TEST(MeshRenderer, EdgesAreFilteredByATent) {
  // The quad's right edge lies at a fraction f of pixel 4 (of 8, each 0.25 wide); left of it everything is
  // covered.
  for (const double f : {0.0, 0.25, 0.5, 0.9}) {
    const float edge = static_cast<float>(0.25 * f);
    const std::vector<Vec3f> positions = quad(4, edge - 4);
    RenderOptions options = smallPicture(8, 256);
    options.background = Vec3f{};
    const Image image = makeRenderer(positions, kQuadTriangles)
                            .render(frontCamera(), std::vector<Vec3f>(4, {1, 1, 1}), options);
    const double t = f - 0.5;  // from the pixel's centre
    const double covered = t < 0 ? 0.5 * (1 + t) * (1 + t) : 1 - 0.5 * (1 - t) * (1 - t);
    EXPECT_NEAR(image.at(4, 4).x, covered, 1.5 / 256) << f;
  }
}

TEST(MeshRenderer, ShowsTrianglesFromBothSides) {
  Camera camera = frontCamera();
  camera.eye = {0, 0, -1};
  const Image image = makeRenderer(quad(2), kQuadTriangles)
                          .render(camera, std::vector<Vec3f>(4, {1, 1, 1}), smallPicture(4, 1));
  for (const Vec3f& pixel : image.pixels) EXPECT_NEAR(pixel.x, 1, 1e-6);
}

// The quad as a two-sided surface is held: a red front towards +z, and a back of its own vertices, green to
// blue from left to right, whose triangles begin at other corners.
TEST(MeshRenderer, ShowsTheSideOfATwoSidedSurfaceThatFacesTheEye) {
  std::vector<Vec3f> positions = quad(2), normals(4, {0, 0, 1}), radiance(4, {1, 0, 0});
  for (const Vec3f& p : quad(2)) {
    positions.push_back(p);
    normals.push_back({0, 0, -1});
    radiance.push_back({0, (2 - p.x) / 4, (2 + p.x) / 4});
  }
  Camera front = frontCamera(), back = frontCamera();
  back.eye = {0, 0, -1};
  // Normals decide and not windings, which files get wrong; and so does the order of triangles not.
  for (const Triangles& triangles : {Triangles{{0, 1, 2}, {0, 2, 3}, {5, 4, 6}, {7, 6, 4}},
                                     Triangles{{6, 5, 4}, {4, 7, 6}, {1, 2, 0}, {2, 3, 0}},
                                     Triangles{{2, 1, 0}, {3, 2, 0}, {4, 5, 6}, {7, 4, 6}}}) {
    const MeshRenderer renderer(positions, normals, triangles);
    for (const Vec3f& pixel : renderer.render(front, radiance, smallPicture(8, 4)).pixels)
      ASSERT_LT(length(toDouble(pixel) - Vec3d{1, 0, 0}), 1e-6);
    const Image image = renderer.render(back, radiance, smallPicture(8, 16));
    for (int row = 0; row < 8; ++row)
      for (int column = 0; column < 8; ++column) {
        const double x = 1 - (column + 0.5) / 4;  // seen from behind, +x is to the left
        ASSERT_LT(length(toDouble(image.at(column, row)) - Vec3d{0, (2 - x) / 4, (2 + x) / 4}), 1e-5);
      }
  }
}

TEST(MeshRenderer, TheNearestSurfaceHidesTheOthers) {
  std::vector<Vec3f> positions = quad(2);
  for (const Vec3f& p : quad(2)) positions.push_back({p.x, p.y, -1});
  const Triangles triangles = {{4, 5, 6}, {4, 6, 7}, {0, 1, 2}, {0, 2, 3}};
  std::vector<Vec3f> radiance(4, {1, 0, 0});
  radiance.resize(8, {0, 1, 0});
  const Image image = makeRenderer(positions, triangles).render(frontCamera(), radiance, smallPicture(4, 4));
  for (const Vec3f& pixel : image.pixels) EXPECT_NEAR(pixel.x, 1, 1e-6);
}

TEST(MeshRenderer, ScaleAndPlaceDoNotMatter) {
  // A bent quad under automatic framing. Scales are powers of two and the offset is exact, so only the camera
  // rounds.
  std::vector<Vec3f> positions = quad(1);
  positions[2].z = 1;
  const std::vector<Vec3f> radiance = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 0}};
  const auto picture = [&](float scale, Vec3f offset) {
    std::vector<Vec3f> moved;
    for (const Vec3f& p : positions) moved.push_back(p * scale + offset);
    return makeRenderer(moved, kQuadTriangles).render(frameCamera(moved, 1), radiance, smallPicture(24, 4));
  };
  const Image reference = picture(1, {});
  for (const Image& image :
       {picture(0x1p-14f, {}), picture(0x1p20f, {}), picture(1, {0x1p17f, -0x1p17f, 0x1p17f})}) {
    std::size_t differing = 0;
    for (std::size_t i = 0; i < image.pixels.size(); ++i) {
      differing += length(toDouble(image.pixels[i]) - toDouble(reference.pixels[i])) > 1e-4;
    }
    EXPECT_LE(differing, 2u);  // a sample on an edge may fall to the other side
  }
}

TEST(MeshRenderer, AnEyeFarAwayWithANarrowFieldSeesSharply) {
  // Radiance is the place on the plane z = 0, so each pixel tells where its ray arrived.
  const std::vector<Vec3f> positions = quad(2);
  std::vector<Vec3f> radiance;
  for (const Vec3f& p : positions) radiance.push_back({p.x, p.y, 1});
  Camera camera;
  camera.eye = {3e6, -2e6, 6e6};
  camera.target = {0, 0, 0};
  camera.verticalFovDegrees = 2 * std::atan(1 / 7e6) * 180 / std::numbers::pi;
  const Image image = makeRenderer(positions, kQuadTriangles).render(camera, radiance, smallPicture(8, 1));
  const CameraAxes axes = cameraAxes(camera.eye, camera.up);
  for (int row = 0; row < 8; ++row)
    for (int column = 0; column < 8; ++column) {
      const double x = (column + 0.5) / 4 - 1, y = 1 - (row + 0.5) / 4;
      const Vec3d direction = (axes.right * x + axes.up * y) / 7e6 - axes.back;
      const Vec3d arrived = camera.eye - direction * (camera.eye.z / direction.z);
      EXPECT_NEAR(image.at(column, row).x, arrived.x, 1e-5);
      EXPECT_NEAR(image.at(column, row).y, arrived.y, 1e-5);
    }
}

TEST(MeshRenderer, AnEyeInsideTheMeshSeesWhatLiesAhead) {
  std::vector<Vec3f> positions = quad(2);
  for (const Vec3f& p : quad(2)) positions.push_back({p.x, p.y, -10});
  const Triangles triangles = {{4, 5, 6}, {4, 6, 7}, {0, 1, 2}, {0, 2, 3}};
  std::vector<Vec3f> radiance(4, {1, 0, 0});
  radiance.resize(8, {0, 1, 0});
  Camera camera = frontCamera();
  camera.eye = {0, 0, -9};  // past the middle, looking away from it
  camera.target = {0, 0, -10};
  const Image image = makeRenderer(positions, triangles).render(camera, radiance, smallPicture(4, 4));
  for (const Vec3f& pixel : image.pixels) EXPECT_NEAR(pixel.y, 1, 1e-6);
}

TEST(MeshRenderer, TheEnvironmentBehindTurnsWithItsRotation) {
  // A sky whose radiance is 0.5 + 0.5 direction, so that each pixel tells where it looks.
  EnvironmentMap sky;
  sky.image.width = 256;
  sky.image.height = 128;
  for (int y = 0; y < 128; ++y)
    for (int x = 0; x < 256; ++x) {
      const Vec3d d = pixelFootprint(sky.layout, 256, 128, x, y).direction;
      sky.image.pixels.push_back(toFloat(Vec3d{0.5, 0.5, 0.5} + d * 0.5));
    }
  const MeshRenderer renderer = makeRenderer(quad(1e-3f), kQuadTriangles);
  RenderOptions options = smallPicture(3, 1);
  options.environment = &sky;
  options.environmentScale = 2;
  options.environmentRotation.m[0][0] = 0, options.environmentRotation.m[0][2] = 1;  // a quarter about +y
  options.environmentRotation.m[2][0] = -1, options.environmentRotation.m[2][2] = 0;
  for (const Vec3d look : {Vec3d{1, 0, 0}, Vec3d{0.3, -0.5, 1}, Vec3d{-1, 0.8, -0.2}}) {
    Camera camera;
    camera.eye = look * 5.0;  // away from the quad
    camera.target = look * 6.0;
    const Image image = renderer.render(camera, std::vector<Vec3f>(4), options);
    const Vec3d expected = Vec3d{1, 1, 1} + transpose(options.environmentRotation) * normalize(look);
    EXPECT_LT(length(toDouble(image.at(1, 1)) - expected), 0.01);
  }
}

TEST(MeshRenderer, SameBitsForAnyThreadCountAndProgressReachesTheEnd) {
  std::vector<Vec3f> positions = quad(1);
  positions[2].z = 1;
  const std::vector<Vec3f> radiance = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 0}};
  const MeshRenderer renderer = makeRenderer(positions, kQuadTriangles);
  const Camera camera = frameCamera(positions, 1);
  ProgressReport last;
  setThreadCount(1);
  const Image one =
      renderer.render(camera, radiance, smallPicture(50, 4), [&](const ProgressReport& r) { last = r; });
  setThreadCount(0);
  const Image many = renderer.render(camera, radiance, smallPicture(50, 4));
  EXPECT_TRUE(sameBits(one, many));
  EXPECT_EQ(last.done, 50u);
  EXPECT_EQ(last.total, 50u);
  EXPECT_EQ(last.rays, 50u * 50 * 4);
}

}  // namespace
}  // namespace shprt
