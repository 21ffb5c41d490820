// Projection against functions whose coefficients are known, against the manifest of the shared probes, and
// between layouts.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>
#include <numbers>

#include "shprt/base/error.h"
#include "shprt/base/file.h"
#include "shprt/base/parallel.h"
#include "shprt/light/light_list.h"
#include "shprt/light/project_probe.h"
#include "shprt/light/window.h"
#include "shprt/sh/basis.h"
#include "shprt/sh/rotation.h"
#include "shprt/sh/zonal.h"

namespace shprt {
namespace {

using std::numbers::pi;

std::string scratch(const std::string& name) {
  return std::string(SHPRT_TEST_OUTPUT_DIR) + "/" + name;
}

struct Case {
  EnvironmentLayout layout;
  int width, height;
};
// 512 x 256 pixels; balls of the same width, cubes of as many pixels on the sphere.
const Case kCases[] = {
    {EnvironmentLayout::kLatitudeLongitude, 512, 256}, {EnvironmentLayout::kAngularMap, 512, 512},
    {EnvironmentLayout::kMirroredBall, 512, 512},      {EnvironmentLayout::kVerticalCross, 444, 592},
    {EnvironmentLayout::kHorizontalCross, 592, 444},   {EnvironmentLayout::kCubeStrip, 148, 888},
    {EnvironmentLayout::kOpenExrCube, 148, 888}};

template <typename Function>
EnvironmentMap paint(const Case& c, const Function& radiance) {
  EnvironmentMap map;
  map.layout = c.layout;
  map.image = {c.width, c.height,
               std::vector<Vec3f>(static_cast<std::size_t>(c.width) * static_cast<std::size_t>(c.height))};
  for (int y = 0; y < c.height; ++y)
    for (int x = 0; x < c.width; ++x)
      map.image.at(x, y) = radiance(pixelFootprint(c.layout, c.width, c.height, x, y).direction);
  return map;
}

TEST(ProjectProbe, ASphericalHarmonicComesBackAsItsCoefficient) {
  const int degree = 8;
  std::vector<double> y(static_cast<std::size_t>(coefficientCount(degree)));
  for (const Case& c : kCases)
    for (const auto [first, second, third] :
         {std::array{0, 1, 2}, std::array{3, 4, 5}, std::array{6, 7, 8}, std::array{9, 12, 15},
          std::array{16, 20, 23}, std::array{24, 30, 42}, std::array{56, 64, 72}, std::array{80, 65, 70}}) {
      const EnvironmentMap map = paint(c, [&](Vec3d d) {
        if (d == Vec3d{}) return Vec3f{};
        evaluateSh(degree, d, y);
        return toFloat({y[size_t(first)], y[size_t(second)], y[size_t(third)]});
      });
      const LightCoefficients light = projectProbe(map, {.degree = degree}).light;
      const int own[3] = {first, second, third};
      for (std::size_t i = 0; i < light.coefficients.size(); ++i)
        for (std::size_t colour = 0; colour < 3; ++colour) {
          const double expected = int(i) == own[colour] ? 1 : 0;
          // The rim of a mirrored ball shows much of the sphere in few pixels: 3e-4 to degree 4, 3e-3 above.
          const bool coarse = c.layout == EnvironmentLayout::kMirroredBall &&
                              std::max(bandOf(int(i)), bandOf(own[colour])) > 4;
          ASSERT_NEAR(light.coefficients[i][colour], expected,
                      coarse                                         ? 3e-3
                      : c.layout == EnvironmentLayout::kMirroredBall ? 3e-4
                                                                     : 1e-4)
              << layoutName(c.layout) << ", harmonic " << own[colour] << ", coefficient " << i;
        }
    }
}

TEST(ProjectProbe, ConstantImagesAreExact) {
  for (const Case& c : kCases) {
    const ProbeProjection projection = projectProbe(paint(c,
                                                          [](Vec3d) {
                                                            return Vec3f{1, 2, 0.5f};
                                                          }),
                                                    {.degree = 0});
    EXPECT_NEAR(projection.light.coefficients[0][1], 2 * std::sqrt(4 * pi), 1e-11) << layoutName(c.layout);
    EXPECT_NEAR(projection.energy[0], 4 * pi, 1e-10);
    EXPECT_NEAR(projection.energyMissed[0], 0, 1e-12);
  }
}

TEST(ProjectProbe, CountsAndMendsBadPixels) {
  EnvironmentMap map = paint({EnvironmentLayout::kLatitudeLongitude, 64, 32}, [](Vec3d) {
    return Vec3f{1, 1, 1};
  });
  map.image.at(3, 4) = {NAN, 1, 1};
  map.image.at(50, 20) = {1, INFINITY, 1};
  map.image.at(10, 10) = {-1, 1, 1};
  const ProbeProjection projection = projectProbe(map, {.degree = 2});
  EXPECT_EQ(projection.nonFinitePixels, 2u);
  EXPECT_EQ(projection.negativePixels, 1u);
  EXPECT_LT(projection.solidAngle, 4 * pi);
  // The rest stands for what was left out, so green stays the radiance of the others; the negative pixel
  // counts as it is.
  EXPECT_NEAR(projection.light.coefficients[0][1], std::sqrt(4 * pi), 1e-12);
  const double own = pixelFootprint(map.layout, 64, 32, 10, 10).solidAngle / projection.solidAngle;
  EXPECT_NEAR(projection.light.coefficients[0][0], std::sqrt(4 * pi) * (1 - 2 * own), 1e-12);
  EXPECT_NEAR(projectProbe(map, {.degree = 2, .clampNegative = true}).light.coefficients[0][0],
              std::sqrt(4 * pi) * (1 - own), 1e-12);
  EXPECT_THROW(projectProbe(map, {.degree = 2, .strict = true}), Error);
  for (Vec3f& pixel : map.image.pixels) pixel = {NAN, 0, 0};
  EXPECT_THROW(projectProbe(map, {.degree = 2}), Error);
}

TEST(ProjectProbe, LargeValuesDoNotOverflow) {
  const EnvironmentMap map = paint({EnvironmentLayout::kLatitudeLongitude, 32, 16}, [](Vec3d) {
    return Vec3f{3e38f, 57600, 1e-38f};
  });
  const ProbeProjection projection = projectProbe(map, {.degree = 4});
  EXPECT_NEAR(projection.light.coefficients[0][0] / (3e38 * std::sqrt(4 * pi)), 1, 1e-6);
  EXPECT_TRUE(std::isfinite(projection.energy[0]));
}

TEST(ProjectProbe, GivesTheSameBitsForAnyNumberOfThreads) {
  const auto scene = [](Vec3d d) {
    return Vec3f{float(1 + d.x * d.y), float(1 + d.z), float(2 + std::sin(9 * d.y))};
  };
  for (const Case& c : kCases) {
    const EnvironmentMap map = paint(c, scene);
    setThreadCount(1);
    const LightCoefficients one = projectProbe(map, {.degree = 4}).light;
    setThreadCount(2);
    EXPECT_EQ(one.coefficients, projectProbe(map, {.degree = 4}).light.coefficients);
  }
  setThreadCount(0);
}

TEST(Analytic, DirectionalAndConstantLights) {
  const LightCoefficients sun = projectDirectional({0, 5, 0}, {2, 1, 0}, 3);
  std::vector<double> y(16);
  evaluateSh(3, Vec3d{0, 1, 0}, y);
  for (std::size_t i = 0; i < 16; ++i) EXPECT_NEAR(sun.coefficients[i][0], 2 * y[i], 1e-15);
  // Irradiance on a surface that faces it, in the limit of all bands: here through the cosine's factors.
  const std::vector<double> cosine = clampedCosineFactors(64);
  const LightCoefficients fine = projectDirectional({0, 0, 1}, {2, 1, 0}, 64);
  std::vector<double> up(static_cast<std::size_t>(coefficientCount(64)));
  evaluateSh(64, Vec3d{0, 0, 1}, up);
  double irradiance = 0;
  for (int i = 0; i < coefficientCount(64); ++i)
    irradiance += cosine[static_cast<std::size_t>(bandOf(i))] *
                  fine.coefficients[static_cast<std::size_t>(i)][0] * up[static_cast<std::size_t>(i)];
  EXPECT_NEAR(irradiance, 2, 0.02);
  EXPECT_THROW(projectDirectional({0, 0, 0}, {1, 1, 1}, 2), Error);
  EXPECT_NEAR(projectConstant({1, 2, 3}, 2).coefficients[0][2], 3 * std::sqrt(4 * pi), 1e-14);
  EXPECT_EQ(projectConstant({1, 2, 3}, 2).coefficients[5][2], 0);
}

TEST(Analytic, SumsDegreesAndRotations) {
  const LightCoefficients a = projectDirectional({1, 0, 0}, {1, 1, 1}, 4), b = projectConstant({1, 1, 1}, 2);
  EXPECT_EQ(addLights(a, b).degree, 2);
  EXPECT_EQ(addLights(a, b).coefficients.size(), 9u);
  EXPECT_EQ(withDegree(b, 4).coefficients.size(), 25u);
  const LightCoefficients turned = rotateLight(a, parseRotation("axis:0,1,0,90")),
                          there = projectDirectional({0, 0, -1}, {1, 1, 1}, 4);
  for (std::size_t i = 0; i < 25; ++i)
    EXPECT_NEAR(turned.coefficients[i][0], there.coefficients[i][0], 1e-14);
}

// Turning the light's coefficients is turning the image: here by painting the turned scene.
TEST(Analytic, RotatingCoefficientsIsRotatingTheImage) {
  const Mat3 rotation = parseRotation("euler:zyz,20,35,-70");
  const auto scene = [](Vec3d d) {
    return Vec3f{float(1 + d.x + 0.5 * d.y * d.z), float(2 + d.x * d.x - d.z), 1};
  };
  const Case c = kCases[0];
  const LightCoefficients turned = rotateLight(projectProbe(paint(c, scene), {.degree = 4}).light, rotation);
  const LightCoefficients painted =
      projectProbe(paint(c, [&](Vec3d d) { return scene(transpose(rotation) * d); }), {.degree = 4}).light;
  for (std::size_t i = 0; i < 25; ++i)
    for (std::size_t colour = 0; colour < 3; ++colour)
      EXPECT_NEAR(turned.coefficients[i][colour], painted.coefficients[i][colour], 2e-4) << i;
}

TEST(Windows, HaveTheirFormulas) {
  LightCoefficients light;
  light.degree = 3;
  light.coefficients.assign(16, {1, 1, 1});
  const LightCoefficients hann = applyWindow(light, Window::kHann).light,
                          lanczos = applyWindow(light, Window::kLanczos).light;
  EXPECT_NEAR(hann.coefficients[0][0], 1, 1e-15);
  EXPECT_NEAR(hann.coefficients[4][0], 0.5, 1e-15);
  EXPECT_NEAR(hann.coefficients[9][0], (1 + std::cos(0.75 * pi)) / 2, 1e-15);
  EXPECT_NEAR(lanczos.coefficients[4][0], std::sin(0.5 * pi) / (0.5 * pi), 1e-15);
  EXPECT_EQ(applyWindow(light, Window::kNone).light.coefficients, light.coefficients);
  EXPECT_THROW(parseWindow("blackman"), Error);
}

double leastIrradiance(const LightCoefficients& light) {
  const std::vector<double> cosine = clampedCosineFactors(light.degree);
  std::vector<double> y(light.coefficients.size());
  double least = 1e300;
  for (int i = 0; i <= 180; ++i)
    for (int j = 0; j < 360; ++j) {
      const double theta = pi * i / 180, phi = 2 * pi * j / 360;
      evaluateSh(light.degree,
                 {std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)}, y);
      double sum = 0;
      for (std::size_t k = 0; k < y.size(); ++k)
        sum += cosine[static_cast<std::size_t>(bandOf(int(k)))] * light.coefficients[k][0] * y[k];
      least = std::min(least, sum);
    }
  return least;
}

TEST(Windows, AutoIsTheLeastThatKeepsIrradiancePositive) {
  // A sun in a dark sky rings below zero; an overcast sky does not and is left alone.
  for (const int degree : {2, 4, 8}) {
    const LightCoefficients sun = addLights(projectDirectional({1, 2, 3}, {1, 1, 1}, degree),
                                            projectConstant({0.002, 0.002, 0.002}, degree));
    ASSERT_LT(leastIrradiance(sun), 0);
    const WindowResult result = applyWindow(sun, Window::kAuto);
    EXPECT_GE(leastIrradiance(result.light), -1e-9);
    EXPECT_LT(leastIrradiance(result.light), 0.01);  // and no more than needed
    EXPECT_GT(result.strength, 0);
    EXPECT_LT(result.strength, 1);
    EXPECT_NEAR(result.light.coefficients[0][0], sun.coefficients[0][0], 1e-15);
  }
  const LightCoefficients overcast =
      addLights(projectDirectional({1, 2, 3}, {0.1, 0.1, 0.1}, 4), projectConstant({1, 1, 1}, 4));
  EXPECT_EQ(applyWindow(overcast, Window::kAuto).light.coefficients, overcast.coefficients);
  EXPECT_EQ(applyWindow(overcast, Window::kAuto).strength, 0);
}

TEST(LightList, AddsItsLights) {
  writeFile(scratch("a.json"), formatLight(projectConstant({1, 1, 1}, 4)));
  writeFile(scratch("lights.json"),
            R"({"lights":[{"type":"directional","direction":[0,1,0],"irradiance":[1,2,3]},
    {"type":"constant","radiance":[0.5,0.5,0.5]},{"type":"probe","file":"a.json","scale":2,"rotate":"axis:0,1,0,30"}]})");
  EXPECT_TRUE(isLightList(scratch("lights.json")));
  EXPECT_FALSE(isLightList(scratch("a.json")));
  const LightCoefficients light = projectLightList(scratch("lights.json"), 3).light;
  EXPECT_EQ(light.degree, 3);
  std::vector<double> y(16);
  evaluateSh(3, Vec3d{0, 1, 0}, y);
  EXPECT_NEAR(light.coefficients[0][1], 2 * y[0] + 2.5 * std::sqrt(4 * pi), 1e-13);
  EXPECT_NEAR(light.coefficients[1][2], 3 * y[1], 1e-13);
}

TEST(LightList, RefusesEachMistakeInOneLine) {
  const std::pair<const char*, const char*> cases[] = {
      {"{", "not valid JSON"},
      {R"({"lights":[]})", "no list of lights"},
      {R"({"lights":[3]})", "lights[0] is no object"},
      {R"({"lamps":[]})", "lamps is not known"},
      {R"({"lights":[{"type":"sun"}]})", "lights[0].type 'sun' is not known"},
      {R"({"lights":[{"direction":[0,1,0]}]})", "lights[0].type is missing"},
      {R"({"lights":[{"type":"directional","direction":[0,1],"irradiance":[1,1,1]}]})",
       "lights[0].direction does not have three numbers"},
      {R"({"lights":[{"type":"directional","direction":[0,0,0],"irradiance":[1,1,1]}]})",
       "lights[0].direction is zero"},
      {R"({"lights":[{"type":"directional","direction":[0,1,0],"irradiance":[1,-1,1]}]})",
       "lights[0].irradiance has a negative"},
      {R"({"lights":[{"type":"directional","direction":[0,1,0],"radiance":[1,1,1]}]})",
       "lights[0].radiance is not known"},
      {R"({"lights":[{"type":"constant","radiance":[1,1,1]},{"type":"constant"}]})",
       "lights[1].radiance is missing"},
      {R"({"lights":[{"type":"constant","radiance":["1",1,1]}]})", "lights[0].radiance has an entry"},
      {R"({"lights":[{"type":"probe","file":"nowhere.exr"}]})", "lights[0].file names"},
      {R"({"lights":[{"type":"probe","file":"a.json","scale":-1}]})", "lights[0].scale is negative"},
      {R"({"lights":[{"type":"probe","file":"a.json","rotate":"turn"}]})", "rotation 'turn'"}};
  writeFile(scratch("a.json"), formatLight(projectConstant({1, 1, 1}, 4)));
  for (const auto& [text, fragment] : cases) {
    writeFile(scratch("bad.json"), text);
    try {
      projectLightList(scratch("bad.json"), 2);
      ADD_FAILURE() << text;
    } catch (const Error& error) {
      EXPECT_NE(std::string(error.what()).find(fragment), std::string::npos) << error.what();
      EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
    }
  }
}

// --- shared probes
// ----------------------------------------------------------------------------------------------------

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
        EXPECT_NEAR(own[k], oracle.values[k][c], printed + 2e-3 * oracle.values[k][c])
            << oracle.file << " figure " << k << " colour " << c;
      }
    }
  }
}

double relativeDifference(const LightCoefficients& a, const LightCoefficients& b,
                          const std::function<double(int l, int m)>& sign) {
  double difference = 0, norm = 0;
  for (int l = 0; l <= a.degree; ++l)
    for (int m = -l; m <= l; ++m)
      for (std::size_t c = 0; c < 3; ++c) {
        const double va = a.coefficients[size_t(shIndex(l, m))][c],
                     vb = sign(l, m) * b.coefficients[size_t(shIndex(l, m))][c];
        difference += (va - vb) * (va - vb);
        norm += va * va;
      }
  return std::sqrt(difference / norm);
}

TEST(SharedProbes, PairsOfOneSceneAgreeDirectionIncluded) {
  if (!std::filesystem::exists(kProbes)) GTEST_SKIP() << "SKIPPED: no probes in " SHPRT_SHARED_DIR;
  const auto project = [](const char* file) {
    return projectProbe(loadEnvironment(kProbes + file), {.degree = 4}).light;
  };
  const auto same = [](int, int) { return 1.0; };
  EXPECT_LT(relativeDifference(project("KernerEnvLatLong.exr"), project("KernerEnvCube.exr"), same), 0.01);
  EXPECT_LT(relativeDifference(project("studio_small_03_1k.exr"), project("studio_small_03_1k.hdr"), same),
            1e-6);
  EXPECT_LT(relativeDifference(project("uffizi_latlong.hdr"), project("uffizi_256.hdr"), same), 0.01);
  // pbrt's copy of Grace stands upside down: y is negated, and with it the harmonics that are odd in y (those
  // with m < 0).
  const auto upsideDown = [](int, int m) { return m < 0 ? -1.0 : 1.0; };
  EXPECT_LT(relativeDifference(project("grace_probe.hdr"), scaleLight(project("grace_latlong.exr"), 31.86),
                               upsideDown),
            0.02);
  // OpenImageIO's conversion of the Uffizi ball looks the other way along x (odd for m > 0 odd, and for m < 0
  // even).
  const auto mirrored = [](int, int m) {
    return (m > 0 && m % 2 != 0) || (m < 0 && m % 2 == 0) ? -1.0 : 1.0;
  };
  EXPECT_LT(
      relativeDifference(project("uffizi_probe-128.exr"), project("uffizi_latlong_env-128.exr"), mirrored),
      0.02);
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

}  // namespace
}  // namespace shprt
