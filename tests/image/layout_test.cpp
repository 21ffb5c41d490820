// Layouts as maps of the whole sphere.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "shprt/base/error.h"
#include "shprt/image/environment.h"

namespace shprt {
namespace {

using std::numbers::pi;

struct Case {
  EnvironmentLayout layout;
  int width, height;
};
const Case kCases[] = {
    {EnvironmentLayout::kLatitudeLongitude, 64, 32}, {EnvironmentLayout::kLatitudeLongitude, 33, 17},
    {EnvironmentLayout::kAngularMap, 48, 48},        {EnvironmentLayout::kAngularMap, 31, 31},
    {EnvironmentLayout::kMirroredBall, 48, 48},      {EnvironmentLayout::kMirroredBall, 31, 31},
    {EnvironmentLayout::kVerticalCross, 48, 64},     {EnvironmentLayout::kHorizontalCross, 64, 48},
    {EnvironmentLayout::kCubeFaces, 16, 96},         {EnvironmentLayout::kCubeStrip, 15, 90},
    {EnvironmentLayout::kOpenExrCube, 16, 96}};

TEST(Layouts, SolidAnglesCoverTheSphereOnce) {
  for (const Case& c : kCases) {
    double sum = 0;
    Vec3d moment;
    for (int y = 0; y < c.height; ++y)
      for (int x = 0; x < c.width; ++x) {
        const PixelFootprint footprint = pixelFootprint(c.layout, c.width, c.height, x, y);
        ASSERT_GE(footprint.solidAngle, 0);
        ASSERT_NEAR(length(footprint.direction), footprint.solidAngle > 0 ? 1 : length(footprint.direction),
                    1e-12);
        sum += footprint.solidAngle;
        moment += footprint.direction * footprint.solidAngle;
      }
    EXPECT_NEAR(sum / (4 * pi), 1, c.layout == EnvironmentLayout::kAngularMap ? 1e-10 : 1e-12)
        << layoutName(c.layout) << " " << c.width;
    EXPECT_NEAR(length(moment), 0, 0.02) << layoutName(c.layout);  // no side of the sphere is favoured
  }
}

TEST(Layouts, BallsOfFewPixelsStillLookSomewhere) {
  for (const EnvironmentLayout layout : {EnvironmentLayout::kAngularMap, EnvironmentLayout::kMirroredBall})
    for (int size = 1; size < 5; ++size)
      for (int i = 0; i < size * size; ++i) {
        const PixelFootprint footprint = pixelFootprint(layout, size, size, i % size, i / size);
        EXPECT_NEAR(length(footprint.direction), 1, 1e-12) << layoutName(layout) << " " << size << " " << i;
        EXPECT_GT(footprint.solidAngle, 0);
      }
}

TEST(Layouts, PositionsAndDirectionsAreInverse) {
  for (const Case& c : kCases)
    for (int y = 0; y < c.height; ++y)
      for (int x = 0; x < c.width; ++x) {
        const PixelFootprint footprint = pixelFootprint(c.layout, c.width, c.height, x, y);
        if (footprint.solidAngle <= 0) continue;
        const bool ball =
            c.layout == EnvironmentLayout::kAngularMap || c.layout == EnvironmentLayout::kMirroredBall;
        if (ball && std::hypot((2 * x + 1.0) / c.width - 1, (2 * y + 1.0) / c.height - 1) > 1 - 3.0 / c.width)
          continue;
        const PixelPosition position = pixelPosition(c.layout, c.width, c.height, footprint.direction);
        ASSERT_NEAR(position.x, x + 0.5, 1e-6) << layoutName(c.layout) << " " << x << " " << y;
        ASSERT_NEAR(position.y, y + 0.5, 1e-6) << layoutName(c.layout) << " " << x << " " << y;
      }
}

// The same scene in every layout: a smooth function of direction, painted by one mapping and read by the
// other.
TEST(Layouts, AgreeOnWhereThingsAre) {
  const auto scene = [](Vec3d d) { return Vec3f{float(1 + d.x), float(1 + d.y), float(1 + d.z)}; };
  for (const Case& c : kCases) {
    EnvironmentMap map;
    map.layout = c.layout;
    map.image = {4 * c.width, 4 * c.height, {}};
    for (int y = 0; y < map.image.height; ++y)
      for (int x = 0; x < map.image.width; ++x)
        map.image.pixels.push_back(
            scene(pixelFootprint(c.layout, map.image.width, map.image.height, x, y).direction));
    for (const Vec3d d : {Vec3d{1, 0, 0}, Vec3d{-1, 0, 0}, Vec3d{0, 1, 0}, Vec3d{0, -1, 0}, Vec3d{0, 0, 1},
                          normalize({1, 2, 3}), normalize({-2, 1, -1})}) {
      // The whole rim of a mirrored ball shows the one direction behind it, too coarsely to be read.
      if (c.layout == EnvironmentLayout::kMirroredBall && d.z > 0.9) continue;
      const Vec3f seen = sampleEnvironment(map, d), expected = scene(d);
      EXPECT_NEAR(seen.x, expected.x, 0.06) << layoutName(c.layout) << " " << d.x << " " << d.y << " " << d.z;
      EXPECT_NEAR(seen.y, expected.y, 0.06) << layoutName(c.layout);
      EXPECT_NEAR(seen.z, expected.z, 0.06) << layoutName(c.layout);
    }
  }
}

TEST(Layouts, AreDrawnAsTheConventionsSay) {
  const auto look = [](EnvironmentLayout layout, int w, int h, double x, double y) {
    const PixelFootprint f = pixelFootprint(layout, w, h, int(x * w), int(y * h));
    return f.direction;
  };
  // Middle of a latitude-longitude picture: +z; a quarter to the right of it: -x; the upper edge: +y.
  EXPECT_GT(look(EnvironmentLayout::kLatitudeLongitude, 64, 32, 0.5, 0.5).z, 0.99);
  EXPECT_LT(look(EnvironmentLayout::kLatitudeLongitude, 64, 32, 0.75, 0.5).x, -0.99);
  EXPECT_GT(look(EnvironmentLayout::kLatitudeLongitude, 64, 32, 0.5, 0).y, 0.99);
  EXPECT_GT(look(EnvironmentLayout::kAngularMap, 33, 33, 0.5, 0.5).z, 0.99);
  EXPECT_LT(look(EnvironmentLayout::kAngularMap, 65, 65, 0.75, 0.5).x, -0.99);
  EXPECT_LT(look(EnvironmentLayout::kMirroredBall, 33, 33, 0.5, 0.5).z, -0.99);
  EXPECT_GT(look(EnvironmentLayout::kMirroredBall, 65, 65, 0.5, 0.15).y, 0.9);
  EXPECT_GT(look(EnvironmentLayout::kVerticalCross, 33, 44, 0.5, 0.375).z, 0.99);
  EXPECT_LT(look(EnvironmentLayout::kVerticalCross, 33, 44, 0.5, 0.875).z, -0.99);
  EXPECT_LT(look(EnvironmentLayout::kVerticalCross, 33, 44, 0.84, 0.375).x, -0.99);
  EXPECT_LT(look(EnvironmentLayout::kHorizontalCross, 44, 33, 0.875, 0.5).z, -0.99);
  EXPECT_GT(look(EnvironmentLayout::kOpenExrCube, 11, 66, 0.5, 0.5 / 6).x, 0.99);
  EXPECT_LT(look(EnvironmentLayout::kCubeStrip, 11, 66, 0.5, 0.5 / 6).x, -0.99);
  EXPECT_EQ(pixelFootprint(EnvironmentLayout::kVerticalCross, 33, 44, 0, 0).solidAngle, 0);
  EXPECT_EQ(pixelFootprint(EnvironmentLayout::kMirroredBall, 33, 33, 0, 0).solidAngle, 0);
}

// Seams of a cube: pixels that touch across an edge of the picture look in nearly the same direction.
TEST(Layouts, CrossesJoinAtTheirInnerEdges) {
  const int n = 32;
  for (int i = 0; i < n; ++i) {
    for (const auto [ax, ay, bx, by] :
         {std::array{n - 1, n + i, n, n + i}, std::array{2 * n - 1, n + i, 2 * n, n + i},
          std::array{n + i, n - 1, n + i, n}, std::array{n + i, 2 * n - 1, n + i, 2 * n},
          std::array{n + i, 3 * n - 1, n + i, 3 * n}}) {
      const Vec3d a = pixelFootprint(EnvironmentLayout::kVerticalCross, 3 * n, 4 * n, ax, ay).direction;
      const Vec3d b = pixelFootprint(EnvironmentLayout::kVerticalCross, 3 * n, 4 * n, bx, by).direction;
      EXPECT_GT(dot(a, b), std::cos(2.5 / n));
    }
  }
}

TEST(Layouts, NamesReadBack) {
  for (const Case& c : kCases) EXPECT_EQ(parseLayout(layoutName(c.layout)), c.layout);
  EXPECT_THROW(parseLayout("cube"), Error);
}

// A ring of a ball within angle theta of its middle covers 2 pi (1 - cos theta), whatever pixels it is cut
// into: here the four quadrants, which the circle cuts, and a picture of one pixel.
TEST(Layouts, PixelsThatTheCircleCutsAreExact) {
  for (const EnvironmentLayout ball : {EnvironmentLayout::kAngularMap, EnvironmentLayout::kMirroredBall}) {
    EXPECT_NEAR(pixelFootprint(ball, 1, 1, 0, 0).solidAngle, 4 * pi, 1e-13);
    for (int i = 0; i < 4; ++i)
      EXPECT_NEAR(pixelFootprint(ball, 2, 2, i % 2, i / 2).solidAngle, pi, 1e-13) << layoutName(ball);
    // A pixel that the circle cuts is the sum of the nine that it splits into, some whole, some cut, some
    // empty.
    for (int x = 0; x < 7; ++x)
      for (int y = 0; y < 7; ++y) {
        double parts = 0;
        for (int i = 0; i < 9; ++i)
          parts += pixelFootprint(ball, 21, 21, 3 * x + i % 3, 3 * y + i / 3).solidAngle;
        EXPECT_NEAR(parts, pixelFootprint(ball, 7, 7, x, y).solidAngle, 1e-7) << layoutName(ball) << x << y;
      }
  }
}

}  // namespace
}  // namespace shprt
