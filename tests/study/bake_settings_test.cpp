// Settings as options of `shprt bake`.
#include <gtest/gtest.h>

#include "shprt/study/bake_settings.h"

namespace shprt {
namespace {

std::string options(const BakeRequest& request, const WriteAssetOptions& storage = {}) {
  return optionsOf({request, storage});
}

TEST(BakeSettings, NameTheModelAndWhatMattersToIt) {
  BakeRequest request;
  request.model = "unshadowed";
  request.degree = 3;
  EXPECT_EQ(options(request), "--model unshadowed --degree 3");
  request.model = "shadowed";
  request.rays = 64;
  request.bounces = 2;
  EXPECT_EQ(options(request), "--model shadowed --degree 3 --rays 64");
  request.model = "interreflected";
  EXPECT_EQ(options(request), "--model interreflected --degree 3 --rays 64 --bounces 2");
  request.bounces = {};
  EXPECT_EQ(options(request), "--model interreflected --degree 3 --rays 64");
  request.error = 0.001;
  EXPECT_EQ(options(request), "--model interreflected --degree 3 --rays 64 --error 0.001");
}

TEST(BakeSettings, AskForAnErrorInsteadOfRays) {
  const BakeRequest request = requestForError({}, 0.03);
  EXPECT_NEAR(request.error * request.error + *request.samplingError * *request.samplingError, 0.03 * 0.03,
              1e-12);
  EXPECT_EQ(options(request), "--model interreflected --degree 4 --error 0.03");
}

TEST(BakeSettings, NameSeedAndStorageWhereTheyDiffer) {
  BakeRequest request;
  request.model = "shadowed";
  request.seed = 5;
  EXPECT_EQ(options(request, {true, AssetCompression::kPiz}),
            "--model shadowed --degree 4 --rays 256 --seed 5 --half --compression piz");
  EXPECT_EQ(options(request, {false, AssetCompression::kZip}),
            "--model shadowed --degree 4 --rays 256 --seed 5 --compression zip");
}

}  // namespace
}  // namespace shprt
