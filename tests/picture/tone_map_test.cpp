// Display encoding against the values of IEC 61966-2-1; exposure from what should be shown.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "shprt/picture/tone_map.h"

namespace shprt {
namespace {

TEST(EncodeSrgb, MatchesTheStandard) {
  // 0.0031308 is where the line meets the curve; 0.5 encodes to 0.735357, 0.18 to 0.461356 (1.055 x^(1/2.4) -
  // 0.055).
  const Vec3f low = encodeSrgb({0, 0.001f, 0.0031308f}, 1);
  EXPECT_EQ(low.x, 0);
  EXPECT_NEAR(low.y, 0.01292f, 1e-7);
  EXPECT_NEAR(low.z, 0.04045f, 1e-5);
  const Vec3f high = encodeSrgb({0.18f, 0.5f, 1}, 1);
  EXPECT_NEAR(high.x, 0.461356, 1e-5);
  EXPECT_NEAR(high.y, 0.735357, 1e-5);
  EXPECT_EQ(high.z, 1);
}

TEST(EncodeSrgb, ExposureMultipliesAndTheRangeClamps) {
  const Vec3f encoded = encodeSrgb({0.25f, -1, 100}, 2);
  EXPECT_NEAR(encoded.x, 0.735357, 1e-5);
  EXPECT_EQ(encoded.y, 0);
  EXPECT_EQ(encoded.z, 1);
  constexpr float kNan = std::numeric_limits<float>::quiet_NaN(),
                  kInf = std::numeric_limits<float>::infinity();
  EXPECT_EQ(encodeSrgb({kNan, kInf, -kInf}, 1), (Vec3f{0, 1, 0}));
}

TEST(EncodeSrgb8, RoundsToTheNearestByte) {
  // The decoded middle between bytes 187 and 188 lies at linear 0.49831; bytes change there.
  const auto byte = [](float linear) { return int(encodeSrgb8({linear, 0, 0}, 1)[0]); };
  EXPECT_EQ(byte(0.5f), 188);
  EXPECT_EQ(byte(static_cast<float>(std::pow((187.49 / 255 + 0.055) / 1.055, 2.4))), 187);
  EXPECT_EQ(byte(static_cast<float>(std::pow((187.51 / 255 + 0.055) / 1.055, 2.4))), 188);
  EXPECT_EQ(byte(1), 255);
  EXPECT_EQ(byte(0), 0);
}

TEST(AutoExposure, BringsTheBrightPartToNineTenths) {
  // Equal grey: every percentile is the same luminance.
  EXPECT_NEAR(autoExposure(std::vector<Vec3f>(100, {3, 3, 3})), 0.3f, 1e-6);
  EXPECT_NEAR(autoExposure(std::vector<Vec3f>(1, {0, 2, 0})), 0.9f / (2 * 0.7152f), 1e-6);
}

TEST(AutoExposure, IgnoresAFewHighlightsAndWhatIsNoRadiance) {
  std::vector<Vec3f> radiance(1000, {1, 1, 1});
  for (std::size_t i = 0; i < 10; ++i) radiance[i * 100] = {1e6f, 1e6f, 1e6f};
  radiance[1] = {std::numeric_limits<float>::quiet_NaN(), 0, 0};
  radiance[2] = {std::numeric_limits<float>::infinity(), 0, 0};
  radiance[3] = {-5, -5, -5};
  EXPECT_NEAR(autoExposure(radiance), 0.9f, 1e-6);
}

TEST(AutoExposure, OfDarknessIsOne) {
  EXPECT_EQ(autoExposure({}), 1);
  EXPECT_EQ(autoExposure(std::vector<Vec3f>(10)), 1);
  EXPECT_TRUE(std::isfinite(autoExposure(std::vector<Vec3f>(10, {0, 1e-44f, 0}))));
}

}  // namespace
}  // namespace shprt
