// Errors in one line, files that appear whole or not at all, hashes against the standard's own vectors.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <fstream>

#include "shprt/base/error.h"
#include "shprt/base/exr_header.h"
#include "shprt/base/file.h"
#include "shprt/base/frame.h"
#include "shprt/base/parallel.h"
#include "shprt/base/vec.h"

namespace shprt {
namespace {

namespace fs = std::filesystem;

fs::path freshFolder(const std::string& name) {
  const fs::path folder = fs::path(SHPRT_TEST_OUTPUT_DIR) / name;
  fs::remove_all(folder);
  fs::create_directories(folder);
  return folder;
}

std::size_t entries(const fs::path& folder) {
  return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
}

TEST(Error, IsOneLineWhateverTheFileIsCalled) {
  EXPECT_STREQ(Error("a\nb.obj", "line 3: tab\there", "mend it").what(),
               "a?b.obj: line 3: tab?here; mend it");
  EXPECT_STREQ(Error("a.obj", "is empty").what(), "a.obj: is empty");
}

TEST(AtomicFile, FollowsLinksToFilesThatDoNotExistYet) {
  const fs::path folder = freshFolder("dangling");
  fs::create_symlink("second", folder / "first");
  fs::create_symlink("target.txt", folder / "second");
  writeFile(folder / "first", "new");
  EXPECT_TRUE(fs::is_symlink(folder / "first"));
  EXPECT_EQ(readFile(folder / "target.txt"), "new");
  fs::create_symlink("nowhere/x", folder / "lost");
  EXPECT_THROW(writeFile(folder / "lost", "new"), Error);
  fs::create_symlink("round", folder / "round");
  EXPECT_THROW(writeFile(folder / "round", "new"), Error);
  EXPECT_EQ(entries(folder), 5u);
}

TEST(AtomicFile, TakesTheLongestNames) {
  const fs::path file = freshFolder("long") / (std::string(251, 'n') + ".exr");
  writeFile(file, "x");
  EXPECT_EQ(readFile(file), "x");
}

TEST(AtomicFile, TemporariesCanBeRemovedFromASignalHandler) {
  const fs::path folder = freshFolder("signal");
  writeFile(folder / "done.txt", "x");
  const AtomicFile one(folder / "a.txt"), other(folder / "b.txt");
  EXPECT_EQ(entries(folder), 3u);
  removeTemporaryFiles();
  EXPECT_EQ(entries(folder), 1u);
}

TEST(Sha256, MatchesTheVectorsOfFips180) {
  const fs::path file = freshFolder("sha256") / "a";
  writeFile(file, "");
  EXPECT_EQ(sha256OfFile(file), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  writeFile(file, "abc");
  EXPECT_EQ(sha256OfFile(file), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  writeFile(file, std::string(1'000'000, 'a'));  // many blocks and a part of one
  EXPECT_EQ(sha256OfFile(file), "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
  EXPECT_THROW(sha256OfFile(file.parent_path() / "none"), Error);
}

TEST(AtomicFile, AppearsOnlyWhenCommitted) {
  const fs::path folder = freshFolder("atomic");
  writeFile(folder / "a.txt", "old");
  {
    const AtomicFile abandoned(folder / "a.txt");
    std::ofstream(abandoned.path()) << "half";
    EXPECT_EQ(abandoned.path().extension(), ".txt");
  }
  EXPECT_EQ(readFile(folder / "a.txt"), "old");
  EXPECT_EQ(entries(folder), 1u);
  writeFile(folder / "a.txt", "new");
  EXPECT_EQ(readFile(folder / "a.txt"), "new");
  EXPECT_EQ(entries(folder), 1u);
}

TEST(AtomicFile, FollowsLinksAndRefusesWhatIsNoFile) {
  const fs::path folder = freshFolder("links");
  writeFile(folder / "real.txt", "old");
  fs::create_symlink("real.txt", folder / "link.txt");
  writeFile(folder / "link.txt", "new");
  EXPECT_TRUE(fs::is_symlink(folder / "link.txt"));
  EXPECT_EQ(readFile(folder / "real.txt"), "new");
  EXPECT_THROW(AtomicFile{folder}, Error);
  EXPECT_THROW(AtomicFile{folder / "missing" / "a.txt"}, Error);
}

TEST(WriteFile, ReportsAFullDisk) {
  if (!fs::exists("/dev/full")) GTEST_SKIP() << "SKIPPED: no /dev/full here";
  try {
    writeFile("/dev/full", "x");
    ADD_FAILURE() << "a full disk went unnoticed";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("No space left"), std::string::npos) << error.what();
  }
  EXPECT_TRUE(fs::is_character_file("/dev/full"));
}

TEST(ReadFile, RefusesWhatCannotBeRead) {
  const fs::path folder = freshFolder("read");
  EXPECT_THROW(readFile(folder), Error);
  EXPECT_THROW(readFile(folder / "missing"), Error);
  writeFile(folder / "big", std::string(1000, 'x'));
  EXPECT_EQ(readFile(folder / "big", 1000).size(), 1000u);
  EXPECT_THROW(readFile(folder / "big", 999), Error);
}

TEST(ReadFirstBytes, GivesWhatIsThereAndNoMore) {
  const fs::path folder = freshFolder("first");
  writeFile(folder / "a", std::string("ab\0cd", 5));
  EXPECT_EQ(readFirstBytes(folder / "a", 3), std::string("ab\0", 3));
  EXPECT_EQ(readFirstBytes(folder / "a", 99).size(), 5u);
  EXPECT_EQ(readFirstBytes(folder / "missing", 3), "");
  EXPECT_EQ(readFirstBytes(folder, 3), "");
  EXPECT_TRUE(isLfsPointer("version https://git-lfs.github.com/spec/v1\n"));
  EXPECT_FALSE(isLfsPointer("version 1"));
}

TEST(ExrHeader, EveryCutAndOverlongClaimIsSeen) {
  const auto word = [](std::uint32_t value) { return std::string(reinterpret_cast<const char*>(&value), 4); };
  const std::string zero(1, '\0'), magic = "\x76\x2f\x31\x01";
  const auto attribute = [&](std::uint32_t claimed) {
    return "name" + zero + "string" + zero + word(claimed) + "abc";
  };
  const fs::path file = freshFolder("exr") / "a.exr";
  const auto isWhole = [&](const std::string& bytes) {
    writeFile(file, bytes);
    return isExrFile(file) && hasWholeExrHeader(file);
  };
  const std::string one = magic + word(2) + attribute(3) + zero;
  const std::string two = magic + word(0x1002) + attribute(3) + zero + attribute(3) + zero + zero;
  for (const std::string& whole : {one, two}) {
    EXPECT_TRUE(isWhole(whole));
    EXPECT_TRUE(isWhole(whole + "pixels"));
    for (std::size_t length = 0; length < whole.size(); ++length)
      EXPECT_FALSE(isWhole(whole.substr(0, length))) << length;
  }
  EXPECT_FALSE(isWhole(magic + word(2) + attribute(0x7fffffff) + zero));
  EXPECT_FALSE(isWhole(magic + word(2) + std::string(300, 'n') + zero));
  EXPECT_FALSE(isExrFile(file.parent_path()));
  EXPECT_FALSE(hasWholeExrHeader(file.parent_path() / "none"));
}

TEST(Frame, IsOrthonormalAndRightHandedEverywhere) {
  for (const Vec3d direction :
       {Vec3d{0, 0, 1}, Vec3d{0, 0, -1}, Vec3d{1e-9, 0, -1}, Vec3d{1, 2, -3}, Vec3d{-1, 1e-12, 0}}) {
    const Frame frame = frameFromNormal(normalize(direction));
    EXPECT_NEAR(dot(frame.tangent, frame.bitangent), 0, 1e-15);
    EXPECT_NEAR(dot(frame.tangent, frame.normal), 0, 1e-15);
    EXPECT_NEAR(length(frame.tangent), 1, 1e-15);
    EXPECT_NEAR(length(cross(frame.tangent, frame.bitangent) - frame.normal), 0, 1e-15);
  }
}

TEST(Normalize, SurvivesTheEndsOfTheRange) {
  for (const double scale : {1e-300, 1e-5, 1.0, 1e300}) {
    EXPECT_NEAR(length(normalize(Vec3d{3, -4, 12} * scale) - Vec3d{3.0 / 13, -4.0 / 13, 12.0 / 13}), 0,
                1e-15);
  }
  EXPECT_EQ(normalize({0, 0, 0}), (Vec3d{0, 0, 0}));
}

TEST(Parallel, CoversEveryIndexOnceInFixedBlocks) {
  for (const int threads : {1, 2, 0}) {
    setThreadCount(threads);
    std::vector<int> visits(1001);
    parallelForBlocks(visits.size(), 64, [&](std::size_t begin, std::size_t end) {
      EXPECT_EQ(begin % 64, 0u);
      for (std::size_t i = begin; i < end; ++i) ++visits[i];
    });
    EXPECT_EQ(std::count(visits.begin(), visits.end(), 1), 1001);
  }
  EXPECT_THROW(setThreadCount(-1), Error);
  EXPECT_THROW(parallelForBlocks(10, 1,
                                 [](std::size_t begin, std::size_t) {
                                   if (begin == 7) throw Error("x", "y");
                                 }),
               Error);
  setThreadCount(0);
}

}  // namespace
}  // namespace shprt
