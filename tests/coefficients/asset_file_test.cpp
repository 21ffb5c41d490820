// The asset file: bits survive, and whatever is cut, flipped or claimed too large is refused.
#include <gtest/gtest.h>

#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfMultiPartInputFile.h>
#include <half.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <limits>

#include "allocation_watch.h"
#include "shprt/base/error.h"
#include "shprt/base/file.h"
#include "shprt/coefficients/asset_file.h"
#include "tests/coefficients/test_assets.h"
#include "tests/scratch.h"

namespace shprt {
namespace {

using test::makeAsset;
using test::makeMeasuredAsset;
using test::scratch;

// A file written anew: overwriting one in place makes some file systems wait for the disk at every close.
void writeBytes(const std::string& path, const std::string& bytes) {
  std::filesystem::remove(path);
  std::ofstream(path, std::ios::binary) << bytes;
}

// What a reader may ask for at once on behalf of a damaged file of a few kB: deflate's bound on what its
// bytes can hold, twice because OpenEXR's buffers have room to spare, and a table of a million chunks.
std::size_t allowedAllocation(std::size_t fileBytes) {
  return std::size_t{2} * 1032 * fileBytes + (std::size_t{8} << 20);
}

void expectSame(const TransferAsset& a, const TransferAsset& b) {
  EXPECT_EQ(a.transfer.degree, b.transfer.degree);
  EXPECT_EQ(a.transfer.channels, b.transfer.channels);
  EXPECT_EQ(a.transfer.vertexCount, b.transfer.vertexCount);
  EXPECT_EQ(a.transfer.values, b.transfer.values);
  EXPECT_EQ(a.positions, b.positions);
  EXPECT_EQ(a.normals, b.normals);
  EXPECT_EQ(a.albedo, b.albedo);
  EXPECT_EQ(a.emission, b.emission);
  EXPECT_EQ(a.textureCoordinates, b.textureCoordinates);
  EXPECT_EQ(a.triangles, b.triangles);
  EXPECT_EQ(a.metadata.model, b.metadata.model);
  EXPECT_EQ(a.metadata.seed, b.metadata.seed);
  EXPECT_EQ(a.metadata.rays, b.metadata.rays);
  EXPECT_EQ(a.metadata.seconds, b.metadata.seconds);
  EXPECT_EQ(a.metadata.counts, b.metadata.counts);
  EXPECT_EQ(a.metadata.notes, b.metadata.notes);
  EXPECT_EQ(a.metadata.objects, b.metadata.objects);
  EXPECT_EQ(a.metadata.bounces, b.metadata.bounces);
  EXPECT_EQ(a.metadata.tailSummed, b.metadata.tailSummed);
  EXPECT_EQ(a.error.values, b.error.values);
  EXPECT_EQ(a.emissionError, b.emissionError);
  ASSERT_EQ(a.metadata.sources.size(), b.metadata.sources.size());
  EXPECT_EQ(a.metadata.sources[0].file, b.metadata.sources[0].file);
}

TEST(AssetFile, ReadsBackTheSameBitsWithEveryCompression) {
  for (const AssetCompression compression :
       {AssetCompression::kNone, AssetCompression::kZip, AssetCompression::kZips, AssetCompression::kPiz})
    for (const int channels : {1, 3})
      for (const std::size_t vertices : {3u, 64u, 20000u}) {
        const TransferAsset asset = makeAsset(vertices > 1000 ? 2 : 4, channels, vertices, channels == 3);
        writeAsset(scratch("same.prt.exr"), asset, {.half = false, .compression = compression});
        expectSame(asset, readAsset(scratch("same.prt.exr")));
      }
  const TransferAsset high = makeAsset(32, 1, 200, false);
  writeAsset(scratch("high.prt.exr"), high);
  expectSame(high, readAsset(scratch("high.prt.exr")));
}

TEST(AssetFile, NothingIsTooUniformToBeReadBack) {
  TransferAsset asset = makeAsset(4, 3, 30000, true);
  std::fill(asset.transfer.values.begin(), asset.transfer.values.end(), 0.0f);
  std::fill(asset.positions.begin(), asset.positions.end(), Vec3f{1, 1, 1});
  asset.emission.assign(30000, {});
  for (auto& triangle : asset.triangles) triangle = {0, 0, 0};
  for (const AssetCompression compression :
       {AssetCompression::kNone, AssetCompression::kZip, AssetCompression::kZips, AssetCompression::kPiz})
    for (const bool half : {false, true}) {
      writeAsset(scratch("uniform.prt.exr"), asset, {.half = half, .compression = compression});
      expectSame(asset, readAsset(scratch("uniform.prt.exr")));
    }
}

TEST(AssetFile, EqualAssetsGiveEqualBytes) {
  writeAsset(scratch("one.prt.exr"), makeAsset(3, 3, 700, true), {.compression = AssetCompression::kZip});
  writeAsset(scratch("two.prt.exr"), makeAsset(3, 3, 700, true), {.compression = AssetCompression::kZip});
  EXPECT_EQ(readFile(scratch("one.prt.exr")), readFile(scratch("two.prt.exr")));
}

TEST(AssetFile, HalfIsRoundedToNearest) {
  const TransferAsset asset = makeAsset(2, 3, 50, false);
  writeAsset(scratch("half.prt.exr"), asset, {.half = true});
  const TransferAsset back = readAsset(scratch("half.prt.exr"));
  for (std::size_t i = 0; i < asset.transfer.values.size(); ++i)
    EXPECT_EQ(back.transfer.values[i], float(Imath::half(asset.transfer.values[i])));
  TransferAsset large = asset;
  large.transfer.values[57] = 1e6f;
  try {
    writeAsset(scratch("large.prt.exr"), large, {.half = true});
    ADD_FAILURE() << "a value beyond half was written";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("coefficient 1 of vertex 7"), std::string::npos) << error.what();
  }
  EXPECT_FALSE(std::filesystem::exists(scratch("large.prt.exr")));
}

TEST(AssetFile, IsAnOrdinaryMultiPartFile) {
  writeAsset(scratch("parts.prt.exr"), makeAsset(4, 3, 100, true));
  Imf::MultiPartInputFile file(scratch("parts.prt.exr").c_str());
  ASSERT_EQ(file.parts(), 6);
  EXPECT_EQ(file.header(0).name(), "transfer");
  EXPECT_EQ(file.header(5).name(), "triangles");
  EXPECT_EQ(listAssetParts(scratch("parts.prt.exr"))[0].height, 25);
  EXPECT_TRUE(isAssetFile(scratch("parts.prt.exr")));
  EXPECT_FALSE(isAssetFile(scratch("missing.prt.exr")));
}

TEST(AssetFile, EveryTruncationIsRefused) {
  writeAsset(scratch("whole.prt.exr"), makeMeasuredAsset(5));
  const std::string bytes = readFile(scratch("whole.prt.exr"));
  ASSERT_GT(bytes.size(), 1000u);
  for (std::size_t length = 0; length < bytes.size(); ++length) {
    writeBytes(scratch("cut.prt.exr"), bytes.substr(0, length));
    EXPECT_THROW(readAsset(scratch("cut.prt.exr")), Error) << length << " of " << bytes.size();
    isAssetFile(scratch("cut.prt.exr"));
  }
}

TEST(AssetFile, FlippedBytesAreRefusedOrHarmless) {
  for (const AssetCompression compression : {AssetCompression::kNone, AssetCompression::kZip}) {
    writeAsset(scratch("whole2.prt.exr"), makeMeasuredAsset(6), {.compression = compression});
    const std::string bytes = readFile(scratch("whole2.prt.exr"));
    for (std::size_t at = 0; at < bytes.size(); at += at < 2000 ? 1 : 5) {
      constexpr unsigned char kFlips[] = {0x01, 0x7f, 0xff};
      std::string damaged = bytes;
      damaged[at] = static_cast<char>(static_cast<unsigned char>(damaged[at]) ^ kFlips[at % 3]);
      writeBytes(scratch("flip.prt.exr"), damaged);
      forgetAllocations();
      try {
        const TransferAsset asset = readAsset(scratch("flip.prt.exr"));
        ASSERT_EQ(asset.positions.size(), asset.transfer.vertexCount);
        for (const auto& t : asset.triangles)
          ASSERT_LT(std::max({t[0], t[1], t[2]}), asset.transfer.vertexCount);
      } catch (const Error& error) {
        ASSERT_EQ(std::string(error.what()).find('\n'), std::string::npos);
      }
      ASSERT_LE(largestAllocation(), allowedAllocation(bytes.size())) << "byte " << at;
    }
  }
}

// What the reader says after every occurrence of some bytes in a good file was replaced.
std::string errorAfterReplacing(const std::string& from, const std::string& to) {
  writeAsset(scratch("edit.prt.exr"), makeAsset(1, 1, 5, false));
  std::string bytes = readFile(scratch("edit.prt.exr"));
  EXPECT_NE(bytes.find(from), std::string::npos);
  EXPECT_EQ(from.size(), to.size());
  for (std::size_t at = bytes.find(from); at != std::string::npos; at = bytes.find(from, at + to.size()))
    bytes.replace(at, from.size(), to);
  writeBytes(scratch("edit.prt.exr"), bytes);
  forgetAllocations();
  try {
    readAsset(scratch("edit.prt.exr"));
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

std::string littleEndian(std::initializer_list<std::int32_t> words) {
  std::string bytes;
  for (const std::int32_t word : words) bytes.append(reinterpret_cast<const char*>(&word), 4);
  return bytes;
}

std::string attribute(const std::string& name, int value) {
  return name + std::string("\0int\0", 5) + littleEndian({4, value});
}

TEST(AssetFile, RefusesWhatIsNewerOrInconsistent) {
  EXPECT_NE(errorAfterReplacing(attribute("shprtFormatVersion", 1), attribute("shprtFormatVersion", 2))
                .find("use a newer shprt"),
            std::string::npos);
  EXPECT_NE(errorAfterReplacing(attribute("shprtDegree", 1), attribute("shprtDegree", 2)).find("disagrees"),
            std::string::npos);
  EXPECT_NE(errorAfterReplacing("no Condon-Shortley phase; right", "a Condon-Shortley phase!; right")
                .find("another convention"),
            std::string::npos);
  EXPECT_NE(errorAfterReplacing("\"degree\": 1", "\"degree\": 2").find("disagrees"), std::string::npos);
  EXPECT_NE(errorAfterReplacing("\"condonShortley\": false", "\"condonShortley\": true ").find("convention"),
            std::string::npos);
  const auto expectError = [](const std::string& from, const std::string& to, const std::string& fragment) {
    const std::string error = errorAfterReplacing(from, to);
    EXPECT_NE(error.find(fragment), std::string::npos) << "'" << error << "' lacks '" << fragment << "'";
  };
  const std::string zero(1, '\0');
  expectError(littleEndian({6}) + "albedo", littleEndian({6}) + "albexo", "part albedo is missing");
  expectError(littleEndian({9}) + "triangles", littleEndian({9}) + "trianglez", "part triangles is missing");
  expectError("C" + zero + littleEndian({0}), "D" + zero + littleEndian({0}),
              "part triangles has the channels A,B,D instead of A,B,C");
  expectError("Y" + zero + littleEndian({2}), "L" + zero + littleEndian({2}),
              "part transfer has the channels L instead of Y or R,G,B");
  expectError("Z" + zero + littleEndian({2}), "Z" + zero + littleEndian({1}),
              "part positions has values of another type");
  expectError(attribute("shprtRays", 64), attribute("shprtRays", 65), "shprtRays disagrees");
  expectError("shprtDegree", "shprtDegrex", "attribute shprtDegree is missing");
  expectError("\"rays\": 64", "\"rays\": -4", "shprtMetadata.rays is out of range");
  expectError("\"rays\": 64", "\"rays\": .4", "shprtMetadata holds no JSON object");
  expectError("\"zeroAreaTriangles\": 3", "\"zeroAreaTriangles\":-3",
              "shprtMetadata.counts.zeroAreaTriangles is no whole number");
  // The last row of 5 x 1 pixels becomes one of 4: a part that fits no other.
  expectError(littleEndian({0, 0, 4, 0}), littleEndian({0, 0, 3, 0}), "part positions is 4 x 1, not 5 x 1");
}

TEST(AssetFile, RefusesClaimsWithoutTakingMemoryForThem) {
  const std::string zero(1, '\0');
  const auto expectRefusal = [&](const std::string& from, const std::string& to) {
    const std::string error = errorAfterReplacing(from, to);
    EXPECT_NE(error, "");
    EXPECT_LT(largestAllocation(), std::size_t{16} << 20) << error;
    forgetAllocations();
    isAssetFile(scratch("edit.prt.exr"));
    EXPECT_LT(largestAllocation(), std::size_t{16} << 20) << error;
  };
  // A string attribute of 2 GB.
  expectRefusal("shprtModel" + zero + "string" + zero + littleEndian({8}),
                "shprtModel" + zero + "string" + zero + littleEndian({0x7fffffff}));
  // A billion vertices, in the windows of the geometry alone and of all parts; and a hundred thousand, for
  // which the file is long enough to hold something that passes for the table of chunks.
  constexpr std::int32_t kMany = 1'000'000'000;
  expectRefusal(littleEndian({0, 0, 4, 0}), littleEndian({0, 0, kMany, 0}));
  expectRefusal(littleEndian({0, 0, 4}), littleEndian({0, 0, kMany}));
  EXPECT_NE(errorAfterReplacing(littleEndian({0, 0, 4}), littleEndian({0, 0, 100'000}))
                .find("part transfer claims more data than"),
            std::string::npos);
  // Tiles of a billion pixels.
  expectRefusal("tiledesc" + zero + littleEndian({9, 16384, 4}),
                "tiledesc" + zero + littleEndian({9, kMany / 4, 4}));
}

TEST(AssetFile, RefusesIndicesAndValuesThatMakeNoSense) {
  TransferAsset asset = makeAsset(1, 1, 5, false);
  asset.triangles.push_back({0, 1, 5});
  writeAsset(scratch("bad.prt.exr"), asset);
  EXPECT_THROW(readAsset(scratch("bad.prt.exr")), Error);
  asset = makeAsset(1, 1, 5, false);
  asset.transfer.values[3] = std::numeric_limits<float>::quiet_NaN();
  writeAsset(scratch("bad.prt.exr"), asset);
  EXPECT_THROW(readAsset(scratch("bad.prt.exr")), Error);
  asset = makeAsset(1, 1, 5, false);
  asset.normals.pop_back();
  EXPECT_THROW(writeAsset(scratch("bad2.prt.exr"), asset), Error);
  EXPECT_THROW(writeAsset(scratch("bad2.prt.exr"), TransferAsset{}), Error);
  EXPECT_FALSE(std::filesystem::exists(scratch("bad2.prt.exr")));
}

TEST(AssetFile, ReportsAFullDisk) {
  if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "SKIPPED: no /dev/full here";
  for (const std::size_t vertices : {5u, 100000u}) {
    try {
      writeAsset("/dev/full", makeAsset(1, 1, vertices, false));
      ADD_FAILURE() << "a full disk went unnoticed";
    } catch (const Error& error) {
      EXPECT_NE(std::string(error.what()).find("/dev/full: cannot be written"), std::string::npos)
          << error.what();
    }
  }
  EXPECT_TRUE(std::filesystem::is_character_file("/dev/full"));
}

}  // namespace
}  // namespace shprt
