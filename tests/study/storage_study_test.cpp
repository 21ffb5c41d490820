#include "shprt/study/storage_study.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <stdexcept>
#include <string>

#include "../scratch.h"
#include "curve_run.h"
#include "shprt/study/temporary_folder.h"

namespace shprt {
namespace {

TEST(StorageStudy, HalfRoundsAndFloatKeeps) {
  test::CurveRun test(test::ballOverFloor(20));
  const StudySection section = storageStudy(test.run).measure(test.run);
  const double unpacked = test::figure(section, "storage.float.none.bytesPerVertex");
  for (const std::string compression : {"none", "zip", "zips", "piz"}) {
    EXPECT_EQ(test::figure(section, "storage.float." + compression + ".error"), 0);
    const double half = test::figure(section, "storage.half." + compression + ".error");
    EXPECT_GT(half, 0);
    EXPECT_LE(half, std::ldexp(1.0, -11));
    EXPECT_EQ(half, test::figure(section, "storage.half.none.error"));
    EXPECT_LE(test::figure(section, "storage.half." + compression + ".bytesPerVertex"), unpacked);
    EXPECT_GT(test::figure(section, "storage.half." + compression + ".writeSeconds"), 0);
  }
  // 25 coefficients of 4 or 2 bytes; geometry is the same in both.
  EXPECT_GT(unpacked, 100);
  EXPECT_NEAR(unpacked - test::figure(section, "storage.half.none.bytesPerVertex"), 50, 0.5);
  EXPECT_EQ(section.tables.front().rows.size(), 8u);
}

class TemporaryFolderTest : public testing::Test {
 protected:
  void SetUp() override { setenv("TMPDIR", test::scratch("").c_str(), 1); }
  void TearDown() override { unsetenv("TMPDIR"); }
  static bool clean() { return std::filesystem::is_empty(test::scratch("")); }
};

TEST_F(TemporaryFolderTest, GoesAwayWhenAnExceptionPasses) {
  std::filesystem::path path;
  try {
    const TemporaryFolder folder;
    path = folder.path();
    test::writeScratch((path.filename() / "file").string(), "content");
    EXPECT_FALSE(clean());
    throw std::runtime_error("stop");
  } catch (const std::runtime_error&) {
  }
  EXPECT_FALSE(path.empty());
  EXPECT_TRUE(clean());
}

TEST_F(TemporaryFolderTest, NothingIsLeftOfAStudy) {
  test::CurveRun test(test::ballOverFloor());
  storageStudy(test.run).measure(test.run);
  EXPECT_TRUE(clean());
}

}  // namespace
}  // namespace shprt
