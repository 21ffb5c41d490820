// Pictures in and out, and damaged files.
#include <gtest/gtest.h>

#include <OpenImageIO/imageio.h>

#include <cmath>
#include <filesystem>
#include <fstream>

#include "shprt/base/error.h"
#include "shprt/base/file.h"
#include "shprt/image/image.h"
#include "tests/scratch.h"

namespace shprt {
namespace {

namespace fs = std::filesystem;

using test::scratch;

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

void writeChannels(const std::string& path, const std::vector<std::string>& names, OIIO::TypeDesc type,
                   const std::vector<float>& pixel, int x = 0, int y = 0, int fullWidth = 2,
                   int fullHeight = 1, int orientation = 1) {
  OIIO::ImageSpec spec(2, 1, static_cast<int>(names.size()), type);
  spec.channelnames = names;
  spec.x = x, spec.y = y;
  spec.full_width = fullWidth, spec.full_height = fullHeight;
  spec.attribute("Orientation", orientation);
  const auto output = OIIO::ImageOutput::create(path);
  std::vector<float> values(pixel);
  values.insert(values.end(), pixel.begin(), pixel.end());
  for (std::size_t i = 0; i < pixel.size(); ++i) values[i] *= 2;  // the left pixel is twice as bright
  ASSERT_TRUE(output->open(path, spec));
  ASSERT_TRUE(output->write_image(OIIO::TypeDesc::FLOAT, values.data()));
  output->close();
}

TEST(Images, ChannelsAreFoundByName) {
  writeChannels(scratch("bgra.exr"), {"B", "G", "R", "A", "Z"}, OIIO::TypeDesc::FLOAT, {3, 2, 1, 0.5f, 9});
  const LoadedImage shuffled = loadImage(scratch("bgra.exr"));
  EXPECT_EQ(shuffled.image.at(1, 0), (Vec3f{1, 2, 3}));
  EXPECT_EQ(shuffled.image.at(0, 0), (Vec3f{2, 4, 6}));
  EXPECT_EQ(shuffled.notes, std::vector<std::string>{"2 further channels ignored"});
  writeChannels(scratch("layer.exr"), {"left.R", "left.G", "left.B"}, OIIO::TypeDesc::FLOAT, {1, 2, 3});
  EXPECT_EQ(loadImage(scratch("layer.exr")).image.at(1, 0), (Vec3f{1, 2, 3}));
  // Luminance with chroma is no red, green and blue.
  writeChannels(scratch("chroma.exr"), {"Y", "RY", "BY"}, OIIO::TypeDesc::FLOAT, {4, 1, 2});
  const LoadedImage grey = loadImage(scratch("chroma.exr"));
  EXPECT_EQ(grey.image.at(1, 0), (Vec3f{4, 4, 4}));
  EXPECT_EQ(grey.notes.size(), 2u);
  for (const std::vector<std::string>& names : {std::vector<std::string>{"R", "G"}, {"U", "V", "W"}}) {
    writeChannels(scratch("odd.exr"), names, OIIO::TypeDesc::FLOAT, std::vector<float>(names.size(), 1.0f));
    EXPECT_THROW(loadImage(scratch("odd.exr")), Error) << names[0];
  }
}

TEST(Images, IgnoredAlphaLeavesColoursAlone) {
  writeChannels(scratch("alpha.png"), {"R", "G", "B", "A"}, OIIO::TypeDesc::UINT8, {0.2f, 0.2f, 0.2f, 0.25f});
  // OpenImageIO stores colours divided by alpha, 0.8; decoded by the sRGB curve.
  EXPECT_NEAR(loadImage(scratch("alpha.png")).image.at(1, 0).x, std::pow((0.8 + 0.055) / 1.055, 2.4), 1e-2);
}

TEST(Images, SixteenBitsAreEncodedToo) {
  writeChannels(scratch("deep.png"), {"R", "G", "B"}, OIIO::TypeDesc::UINT16, {0.02f, 0.25f, 0.5f});
  const Vec3f pixel = loadImage(scratch("deep.png")).image.at(1, 0);
  EXPECT_NEAR(pixel.x, 0.02 / 12.92, 1e-5);
  EXPECT_NEAR(pixel.y, std::pow((0.25 + 0.055) / 1.055, 2.4), 1e-5);
}

TEST(Images, DataWindowsAreShownInTheirDisplayWindow) {
  writeChannels(scratch("window.exr"), {"R", "G", "B"}, OIIO::TypeDesc::FLOAT, {1, 2, 3}, 1, 1, 4, 2);
  const LoadedImage loaded = loadImage(scratch("window.exr"));
  ASSERT_EQ(loaded.image.width, 4);
  ASSERT_EQ(loaded.image.height, 2);
  EXPECT_EQ(loaded.image.at(1, 1), (Vec3f{2, 4, 6}));
  EXPECT_EQ(loaded.image.at(2, 1), (Vec3f{1, 2, 3}));
  EXPECT_EQ(loaded.image.at(0, 0), (Vec3f{}));
  EXPECT_EQ(loaded.image.at(3, 1), (Vec3f{}));
  EXPECT_EQ(loaded.notes.size(), 1u);
}

TEST(Images, OrientationTagsTurnThePicture) {
  // The stored row is (2, 1). By the EXIF tag: where its first pixel goes.
  const struct {
    int orientation, width, height, x, y;
  } cases[] = {{1, 2, 1, 0, 0}, {2, 2, 1, 1, 0}, {3, 2, 1, 1, 0}, {4, 2, 1, 0, 0},
               {5, 1, 2, 0, 0}, {6, 1, 2, 0, 0}, {7, 1, 2, 0, 1}, {8, 1, 2, 0, 1}};
  for (const auto& c : cases) {
    writeChannels(scratch("turned.exr"), {"R", "G", "B"}, OIIO::TypeDesc::FLOAT, {1, 1, 1}, 0, 0, 2, 1,
                  c.orientation);
    const Image image = loadImage(scratch("turned.exr")).image;
    ASSERT_EQ(image.width, c.width) << c.orientation;
    ASSERT_EQ(image.height, c.height) << c.orientation;
    EXPECT_EQ(image.at(c.x, c.y).x, 2) << c.orientation;
  }
}

// A reader that fills up what is missing and reports success.
TEST(Images, ACutJpegIsRefused) {
  Image image{64, 64, {}};
  for (int i = 0; i < 64 * 64; ++i)
    image.pixels.push_back({0.2f + 0.1f * std::sin(0.1f * float(i)), 0.3f, 0.5f});
  saveImage(scratch("whole.jpg"), image);
  EXPECT_EQ(loadImage(scratch("whole.jpg")).image.width, 64);
  const std::string bytes = readFile(scratch("whole.jpg"));
  writeFile(scratch("cut.jpg"), bytes.substr(0, bytes.size() / 2));
  EXPECT_THROW(loadImage(scratch("cut.jpg")), Error);
}

TEST(Images, ADataWindowOutsideIsRefused) {
  writeChannels(scratch("apart.exr"), {"R", "G", "B"}, OIIO::TypeDesc::FLOAT, {1, 2, 3}, 9, 0, 4, 2);
  EXPECT_THROW(loadImage(scratch("apart.exr")), Error);
}

TEST(Images, ADamagedPngIsRefusedInSilence) {
  saveImage(scratch("whole.png"), Image{16, 8, std::vector<Vec3f>(128, Vec3f{0.1f, 0.2f, 0.3f})});
  const std::string whole = readFile(scratch("whole.png"));
  testing::internal::CaptureStderr();
  for (std::size_t i = 0; i < whole.size(); ++i) {
    std::string damaged = whole;
    damaged[i] = static_cast<char>(damaged[i] ^ 0x10);
    writeFile(scratch("damaged.png"), damaged);
    EXPECT_THROW(loadImage(scratch("damaged.png")), Error) << i;
  }
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

// Headers that claim more than the file holds are refused before anything is allocated, also where
// OpenImageIO would go on.
TEST(Images, ClaimsAreCheckedAgainstTheFile) {
  for (const auto& [name, bytes] :
       {std::pair{"bomb.hdr", "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 40000 +X 40000\n"},
        std::pair{"bomb.pfm", "PF\n200000 100000\n-1.0\n"},
        std::pair{"bomb.ppm", "P6\n90000 90000\n255\n"}}) {
    writeFile(scratch(name), bytes);
    try {
      loadImage(scratch(name));
      ADD_FAILURE() << name;
    } catch (const Error& error) {
      EXPECT_NE(std::string(error.what()).find("bytes can hold"), std::string::npos) << error.what();
    }
  }
}

TEST(Images, ExrAttributesMustLieInTheFile) {
  saveImage(scratch("claim.exr"), Image{2, 1, std::vector<Vec3f>(2)});
  std::string bytes = readFile(scratch("claim.exr"));
  const std::string before("screenWindowWidth\0float\0", 24);
  const std::size_t size = bytes.find(before) + before.size();
  ASSERT_LT(size, bytes.size());
  bytes.replace(size, 4, "\xff\xff\xff\x7f");
  writeFile(scratch("claim.exr"), bytes);
  try {
    loadImage(scratch("claim.exr"));
    ADD_FAILURE() << "taken";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("damaged OpenEXR file"), std::string::npos) << error.what();
  }
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
