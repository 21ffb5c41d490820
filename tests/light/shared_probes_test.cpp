// The shared probes against their manifest, and against each other where they show one scene.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>

#include "shprt/base/error.h"
#include "shprt/light/project_probe.h"
#include "shprt/sh/basis.h"
#include "shprt/sh/rotation.h"

namespace shprt {
namespace {

const std::string kProbes = SHPRT_SHARED_DIR "/data/probes/";

// Mean radiance and the norms of bands 1 and 2, for each colour, as the manifest prints them: "[a, b, c];
// [..]; [..]".
struct Oracle {
  std::string file;
  double values[3][3];
};

std::vector<Oracle> readOracles() {
  std::vector<Oracle> oracles;
  std::ifstream in(SHPRT_SHARED_DIR "/data/MANIFEST.md");
  for (std::string line; std::getline(in, line);) {
    if (!line.starts_with("| probes/")) continue;
    Oracle oracle{line.substr(9, line.find(' ', 9) - 9), {}};
    const std::size_t start = line.find("| [");
    if (start == std::string::npos) continue;
    const char* cursor = line.c_str() + start + 2;
    int read = 0;
    for (auto& triple : oracle.values) {
      int used = 0;
      read += std::sscanf(cursor, " [%lf, %lf, %lf]%n", &triple[0], &triple[1], &triple[2], &used);
      cursor += used + 1;
    }
    if (read == 9) oracles.push_back(oracle);
  }
  return oracles;
}

TEST(SharedProbes, AgreeWithTheManifest) {
  if (!std::filesystem::exists(kProbes)) GTEST_SKIP() << "SKIPPED: no probes in " SHPRT_SHARED_DIR;
  const std::vector<Oracle> oracles = readOracles();
  EXPECT_GT(oracles.size(), 20u);
  for (const Oracle& oracle : oracles) {
    const ProbeProjection projection = projectProbe(loadEnvironment(kProbes + oracle.file), {.degree = 2});
    const LightStatistics statistics = measureLight(projection.light);
    for (std::size_t c = 0; c < 3; ++c) {
      const double own[3] = {statistics.averageRadiance[c], std::sqrt(statistics.bandEnergy[1][c]),
                             std::sqrt(statistics.bandEnergy[2][c])};
      for (std::size_t k = 0; k < 3; ++k) {
        const double printed = k == 0 ? 5.5e-5 : 5.5e-4;
        EXPECT_NEAR(own[k], oracle.values[k][c], printed + 1e-4 * oracle.values[k][c])
            << oracle.file << " figure " << k << " colour " << c;
      }
    }
  }
}

double relativeDifference(const LightCoefficients& a, const LightCoefficients& b) {
  double difference = 0, norm = 0;
  for (std::size_t i = 0; i < a.coefficients.size(); ++i)
    for (std::size_t c = 0; c < 3; ++c) {
      const double gap = a.coefficients[i][c] - b.coefficients[i][c];
      difference += gap * gap;
      norm += a.coefficients[i][c] * a.coefficients[i][c];
    }
  return std::sqrt(difference / norm);
}

// Negates the harmonics that are odd along an axis: those with m < 0 for y; with odd m > 0 and even m < 0 for
// x.
LightCoefficients mirrored(LightCoefficients light, char axis) {
  for (int l = 0; l <= light.degree; ++l)
    for (int m = -l; m <= l; ++m) {
      const bool odd = axis == 'y' ? m < 0 : m != 0 && (m > 0) == (m % 2 != 0);
      if (!odd) continue;
      for (double& value : light.coefficients[static_cast<std::size_t>(shIndex(l, m))]) value = -value;
    }
  return light;
}

TEST(SharedProbes, PairsOfOneSceneAgreeDirectionIncluded) {
  if (!std::filesystem::exists(kProbes)) GTEST_SKIP() << "SKIPPED: no probes in " SHPRT_SHARED_DIR;
  const auto project = [](const char* file) {
    return projectProbe(loadEnvironment(kProbes + file), {.degree = 4}).light;
  };
  // OpenEXR's own pair, latitude-longitude against cube: what is left is OpenEXR's putting the first and last
  // pixel centres on the picture's edges.
  EXPECT_LT(relativeDifference(project("KernerEnvLatLong.exr"), project("KernerEnvCube.exr")), 0.005);
  EXPECT_LT(relativeDifference(project("OrientationLatLong.exr"), project("OrientationCube.exr")), 0.003);
  EXPECT_LT(relativeDifference(project("studio_small_03_1k.exr"), project("studio_small_03_1k.hdr")), 1e-6);
  EXPECT_LT(relativeDifference(project("uffizi_latlong.hdr"), project("uffizi_256.hdr")), 0.004);
  // The Uffizi ball shows what two independent latitude-longitude pictures show a quarter turn about +Y away,
  // and not the mirror image of it: this settles the handedness of the angular map.
  const Mat3 quarter = parseRotation("axis:0,1,0,90");
  const LightCoefficients ball = project("uffizi_probe-128.exr");
  for (const char* file : {"uffizi_latlong.hdr", "uffizi_256.hdr"}) {
    EXPECT_LT(relativeDifference(ball, rotateLight(project(file), quarter)), 0.003) << file;
    EXPECT_GT(relativeDifference(ball, rotateLight(mirrored(project(file), 'x'), quarter)), 0.03) << file;
  }
  // OpenImageIO's conversion of that ball is mirrored in x, and pbrt's copy of Grace in y: it stands upside
  // down.
  EXPECT_LT(relativeDifference(ball, mirrored(project("uffizi_latlong_env-128.exr"), 'x')), 0.003);
  EXPECT_LT(relativeDifference(project("grace_probe.hdr"),
                               mirrored(scaleLight(project("grace_latlong.exr"), 31.86), 'y')),
            0.004);
}

// The mirrored ball comes with reference reflection vectors v, stored as (1 + v) / 2.
TEST(SharedProbes, MirroredBallAgreesWithItsReflectionVectors) {
  if (!std::filesystem::exists(kProbes + "mirrorball_reflect.pfm"))
    GTEST_SKIP() << "SKIPPED: no probes in " SHPRT_SHARED_DIR;
  const Image reference = loadImage(kProbes + "mirrorball_reflect.pfm").image;
  int compared = 0;
  for (int y = 0; y < reference.height; y += 5)
    for (int x = 0; x < reference.width; x += 5) {
      if (std::hypot(2.0 * x / reference.width - 1, 2.0 * y / reference.height - 1) > 0.9) continue;
      const Vec3d own =
          pixelFootprint(EnvironmentLayout::kMirroredBall, reference.width, reference.height, x, y).direction;
      const Vec3f given = reference.at(x, y);
      // There the camera looks along -z, and +x is to the right: half a turn about y from here.
      const Vec3d turned{-own.x, own.y, -own.z};
      ASSERT_NEAR(given.x, 0.5 + 0.5 * turned.x, 0.01) << x << " " << y;
      ASSERT_NEAR(given.y, 0.5 + 0.5 * turned.y, 0.01) << x << " " << y;
      ASSERT_NEAR(given.z, 0.5 + 0.5 * turned.z, 0.01) << x << " " << y;
      ++compared;
    }
  EXPECT_GT(compared, 3000);
}

// Constant faces are a furnace: nothing but the average.
TEST(SharedProbes, GreyFacesAreConstant) {
  if (!std::filesystem::exists(kProbes + "faces_grey"))
    GTEST_SKIP() << "SKIPPED: no probes in " SHPRT_SHARED_DIR;
  const ProbeProjection projection = projectProbe(loadEnvironment(kProbes + "faces_grey"), {.degree = 1});
  EXPECT_NEAR(measureLight(projection.light).averageRadiance[1], 0.5, 1e-12);
  EXPECT_NEAR(projection.energyMissed[1], 0, 1e-12);
  for (std::size_t i = 1; i < 4; ++i) EXPECT_NEAR(projection.light.coefficients[i][1], 0, 1e-12);
}

// Each channel has 2 NaN and 4 infinite values, says the manifest; they lie in 12 pixels (counted with
// numpy).
TEST(SharedProbes, NonFinitePixelsAreLeftOut) {
  const std::string file = SHPRT_SHARED_DIR "/data/problem/img_BrightRingsNanInf.exr";
  if (!std::filesystem::exists(file)) GTEST_SKIP() << "SKIPPED: no " << file;
  const EnvironmentMap map = loadEnvironment(file, EnvironmentLayout::kLatitudeLongitude);
  const ProbeProjection projection = projectProbe(map, {.degree = 4});
  EXPECT_EQ(projection.nonFinitePixels, 12u);
  for (const auto& coefficient : projection.light.coefficients)
    for (const double value : coefficient) EXPECT_TRUE(std::isfinite(value));
  EXPECT_THROW(projectProbe(map, {.degree = 4, .strict = true}), Error);
}

}  // namespace
}  // namespace shprt
