// Which layout a file has, cubes in six files, and where labelled cubes show things.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "shprt/base/error.h"
#include "shprt/image/environment.h"
#include "tests/scratch.h"

namespace shprt {
namespace {

namespace fs = std::filesystem;

using test::scratch;

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
  EXPECT_STREQ(guess("plain.exr", 24, 4, 1), "strip");
  EXPECT_STREQ(guess("plain.exr", 16, 16, 0), "angular");
  EXPECT_STREQ(guess("my_probe.exr", 16, 16, 1), "angular");
  EXPECT_STREQ(guess("mirror.exr", 16, 16, 1), "mirrored-ball");
  EXPECT_THROW(guess("plain.exr", 16, 16, 1), Error);
  EXPECT_THROW(guess("plain.exr", 16, 16, NAN), Error);
  EXPECT_THROW(guess("plain.exr", 1, 1, 0), Error);
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

TEST(Environment, StacksAStripThatLiesOnItsSide) {
  Image image{12, 2, std::vector<Vec3f>(24)};
  for (int y = 0; y < 2; ++y)
    for (int x = 0; x < 12; ++x)
      image.at(x, y) = {float(x / 2), float(x % 2), float(y)};  // face, place within it
  saveImage(scratch("lying.exr"), image);
  const EnvironmentMap map = loadEnvironment(scratch("lying.exr"));
  ASSERT_EQ(map.image.width, 2);
  ASSERT_EQ(map.image.height, 12);
  for (int y = 0; y < 12; ++y)
    for (int x = 0; x < 2; ++x) EXPECT_EQ(map.image.at(x, y), (Vec3f{float(y / 2), float(x), float(y % 2)}));
}

// The names written on the faces of labelled cubes show where each lies and which way up. A face of one
// colour with dark letters: its mean and the colours of its corners tell it.
TEST(SharedEnvironments, LabelledCubesAgreeOnTheirFaces) {
  const std::string probes = SHPRT_SHARED_DIR "/data/probes/";
  if (!fs::exists(probes + "labelled_vertical_cross.hdr"))
    GTEST_SKIP() << "SKIPPED: no labelled cubes in " SHPRT_SHARED_DIR;
  // Colours as painted: right cyan, left red, top magenta, bottom green, front yellow, back blue; right of
  // the front, seen from inside, is -X.
  const std::pair<Vec3d, Vec3f> faces[] = {{{-1, 0, 0}, {0, 1, 1}}, {{1, 0, 0}, {1, 0, 0}},
                                           {{0, 1, 0}, {1, 0, 1}},  {{0, -1, 0}, {0, 1, 0}},
                                           {{0, 0, 1}, {1, 1, 0}},  {{0, 0, -1}, {0, 0, 1}}};
  for (const char* name :
       {"labelled_vertical_cross.hdr", "labelled_horizontal_cross.hdr", "faces_labelled/px.hdr"}) {
    const EnvironmentMap map = loadEnvironment(probes + name);
    for (const auto& [middle, colour] : faces) {
      const Vec3d aside =
          normalize(middle + 0.4 * Vec3d{middle.y, middle.z, middle.x});  // beside the letters
      const Vec3f seen = sampleEnvironment(map, aside);
      const float brightest = std::max({seen.x, seen.y, seen.z});
      ASSERT_GT(brightest, 0.1f) << name;
      EXPECT_EQ((Vec3f{seen.x > brightest / 2 ? 1.0f : 0.0f, seen.y > brightest / 2 ? 1.0f : 0.0f,
                       seen.z > brightest / 2 ? 1.0f : 0.0f}),
                colour)
          << name << " " << middle.x << " " << middle.y << " " << middle.z;
    }
  }
}

}  // namespace
}  // namespace shprt
