// Pictures in and out, layouts as maps of the whole sphere, and damaged files.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <numbers>

#include "shprt/base/error.h"
#include "shprt/base/file.h"
#include "shprt/image/environment.h"
#include "shprt/image/image.h"

namespace shprt {
namespace {

namespace fs = std::filesystem;
using std::numbers::pi;

std::string scratch(const std::string& name) {
  return std::string(SHPRT_TEST_OUTPUT_DIR) + "/" + name;
}

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
    const bool ball =
        c.layout == EnvironmentLayout::kAngularMap || c.layout == EnvironmentLayout::kMirroredBall;
    EXPECT_NEAR(sum / (4 * pi), 1, ball ? 2e-5 : 1e-12) << layoutName(c.layout) << " " << c.width;
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

TEST(Images, RoundTripThroughTheFormats) {
  Image image{5, 3, {}};
  for (int i = 0; i < 15; ++i) image.pixels.push_back({float(i) / 16, 0.5f, 1});
  saveImage(scratch("a.exr"), image);
  EXPECT_EQ(loadImage(scratch("a.exr")).image.pixels, image.pixels);
  EXPECT_EQ(loadImage(scratch("a.exr")).format, "openexr");
  saveImage(scratch("a.png"), image);
  const LoadedImage png = loadImage(scratch("a.png"));
  ASSERT_EQ(png.image.pixels.size(), 15u);
  EXPECT_NEAR(png.image.pixels[0].y, 0.21404, 2e-3);  // an sRGB value of one half
  ASSERT_FALSE(png.notes.empty());
  EXPECT_THROW(saveImage(scratch("a.nonsense"), image), Error);
  EXPECT_THROW(saveImage(scratch("missing/a.png"), image), Error);
  EXPECT_FALSE(fs::exists(scratch("a.nonsense")));
}

TEST(Images, PfmBeginsWithItsLowestRow) {
  std::string bytes = "PF\n2 2\n-1.0\n";
  for (const float row : {1.0f, 2.0f})
    for (int i = 0; i < 6; ++i) bytes.append(reinterpret_cast<const char*>(&row), 4);
  writeFile(scratch("rows.pfm"), bytes);
  const Image image = loadImage(scratch("rows.pfm")).image;
  EXPECT_EQ(image.at(0, 0).x, 2);
  EXPECT_EQ(image.at(0, 1).x, 1);
}

TEST(Images, EveryTruncationEndsInAnErrorOrAPicture) {
  Image image{16, 8, std::vector<Vec3f>(128, Vec3f{1, 2, 3})};
  for (const char* name : {"t.exr", "t.hdr", "t.png"}) {
    saveImage(scratch(name), image);
    const std::string bytes = readFile(scratch(name));
    for (std::size_t length = 0; length < bytes.size(); length += 3) {
      std::ofstream(scratch(std::string("cut_") + name), std::ios::binary) << bytes.substr(0, length);
      try {
        loadImage(scratch(std::string("cut_") + name));
      } catch (const Error& error) {
        ASSERT_EQ(std::string(error.what()).find('\n'), std::string::npos);
      }
    }
  }
}

TEST(Environment, GuessesTheLayoutAndSaysWhy) {
  const auto guess = [](const std::string& name, int w, int h, float corner) {
    Image image{w, h,
                std::vector<Vec3f>(static_cast<std::size_t>(w) * static_cast<std::size_t>(h),
                                   Vec3f{corner, corner, corner})};
    image.at(w / 2, h / 2) = {1, 1, 1};
    saveImage(scratch(name), image);
    return layoutName(loadEnvironment(scratch(name)).layout);
  };
  EXPECT_STREQ(guess("plain.exr", 16, 8, 1), "latlong");
  EXPECT_STREQ(guess("plain.exr", 12, 16, 1), "vertical-cross");
  EXPECT_STREQ(guess("plain.exr", 16, 12, 1), "horizontal-cross");
  EXPECT_STREQ(guess("plain.exr", 4, 24, 1), "strip");
  EXPECT_STREQ(guess("plain.exr", 16, 16, 0), "angular");
  EXPECT_STREQ(guess("my_probe.exr", 16, 16, 1), "angular");
  EXPECT_STREQ(guess("mirror.exr", 16, 16, 1), "mirrored-ball");
  EXPECT_THROW(guess("plain.exr", 16, 16, 1), Error);
  EXPECT_THROW(guess("plain.exr", 17, 10, 1), Error);
  EXPECT_THROW(loadEnvironment(scratch("plain.exr"), EnvironmentLayout::kCubeStrip), Error);
}

TEST(Environment, FindsSixFaces) {
  const fs::path folder = scratch("faces");
  fs::create_directories(folder);
  int value = 1;
  for (const char* face : {"px", "nx", "py", "ny", "pz", "nz"}) {
    saveImage(folder / ("sky_" + std::string(face) + ".exr"),
              Image{2, 2, std::vector<Vec3f>(4, Vec3f{float(value), 0, 0})});
    ++value;
  }
  for (const fs::path& way : {folder, folder / "sky_%s.exr", folder / "sky_ny.exr"}) {
    const EnvironmentMap map = loadEnvironment(way);
    EXPECT_EQ(map.layout, EnvironmentLayout::kCubeFaces);
    EXPECT_EQ(map.image.height, 12);
    EXPECT_EQ(map.image.at(0, 0).x, 1);
    EXPECT_EQ(map.image.at(1, 11).x, 6);
  }
  fs::remove(folder / "sky_pz.exr");
  EXPECT_THROW(loadEnvironment(folder), Error);
}

TEST(SharedImages, ProblemFilesEndInAPictureOrOneLine) {
  if (!fs::exists(SHPRT_SHARED_DIR "/data/problem"))
    GTEST_SKIP() << "SKIPPED: no problem images in " SHPRT_SHARED_DIR;
  const std::pair<const char*, const char*> refused[] = {{"img_bomb-40000.hdr", "bytes can hold"},
                                                         {"img_crash-res.hdr", ""},
                                                         {"img_lfs_pointer.hdr", "git lfs pull"},
                                                         {"img_damaged1.exr", ""},
                                                         {"img_damaged2.exr", ""},
                                                         {"cow.obj", "cannot be read as an image"},
                                                         {"empty.obj", "is empty"}};
  for (const auto& [file, fragment] : refused) {
    try {
      loadImage(std::string(SHPRT_SHARED_DIR "/data/problem/") + file);
      ADD_FAILURE() << file << " was taken";
    } catch (const Error& error) {
      EXPECT_NE(std::string(error.what()).find(fragment), std::string::npos) << error.what();
      EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
    }
  }
  for (const char* file : {"img_BrightRingsNanInf.exr", "img_WideColorGamut.exr", "img_AllHalfValues.exr",
                           "img_GrayRampsHorizontal.exr", "img_Garden_Y.exr"}) {
    EXPECT_GT(loadImage(std::string(SHPRT_SHARED_DIR "/data/problem/") + file).image.pixels.size(), 0u)
        << file;
  }
}

}  // namespace
}  // namespace shprt
