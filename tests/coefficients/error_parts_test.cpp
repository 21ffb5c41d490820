// The standard errors in the asset file: they survive, are checked against the transfer, and may be absent.
#include <gtest/gtest.h>

#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfMultiPartInputFile.h>

#include <filesystem>
#include <fstream>
#include <functional>
#include <limits>
#include <string>

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
using test::makeSceneAsset;
using test::scratch;

void expectError(const std::function<void()>& action, const std::string& fragment) {
  std::string problem;
  try {
    action();
  } catch (const Error& error) {
    problem = error.what();
  }
  EXPECT_NE(problem.find(fragment), std::string::npos) << "'" << problem << "' lacks '" << fragment << "'";
}

// One channel, no emission, 5 vertices; the error at band l and vertex v is l + v / 8.
TransferAsset greyAsset() {
  TransferAsset asset = makeAsset(3, 1, 5, false);
  asset.error = {.degree = 3, .channels = 1, .vertexCount = 5, .values = {}};
  for (int l = 0; l <= 3; ++l)
    for (int v = 0; v < 5; ++v) asset.error.values.push_back(static_cast<float>(l) + 0.125f * float(v));
  return asset;
}

std::string writtenBytes(const TransferAsset& asset) {
  writeAsset(scratch("errors.prt.exr"), asset);
  return readFile(scratch("errors.prt.exr"));
}

TransferAsset readBytes(const std::string& bytes) {
  std::filesystem::remove(scratch("edited.prt.exr"));
  std::ofstream(scratch("edited.prt.exr"), std::ios::binary) << bytes;
  return readAsset(scratch("edited.prt.exr"));
}

std::string littleEndian(std::initializer_list<std::int32_t> words) {
  std::string bytes;
  for (const std::int32_t word : words) bytes.append(reinterpret_cast<const char*>(&word), 4);
  return bytes;
}

// The value of a part's attribute `name` as it lies in the file.
std::string nameOfPart(const std::string& part) {
  return littleEndian({static_cast<std::int32_t>(part.size())}) + part;
}

// Reads the file after `from` became `to` in the header of a part; its attributes stand in alphabetical
// order, so `name` is the place to look back from.
TransferAsset readWithEditedPart(const TransferAsset& asset, const std::string& part, const std::string& from,
                                 const std::string& to) {
  std::string bytes = writtenBytes(asset);
  bytes.replace(bytes.rfind(from, bytes.find(nameOfPart(part))), from.size(), to);
  return readBytes(bytes);
}

TransferAsset readEdited(const TransferAsset& asset, const std::string& from, const std::string& to) {
  std::string bytes = writtenBytes(asset);
  EXPECT_EQ(from.size(), to.size());
  EXPECT_NE(bytes.find(from), std::string::npos) << from;
  for (std::size_t at = bytes.find(from); at != std::string::npos; at = bytes.find(from, at + to.size()))
    bytes.replace(at, from.size(), to);
  return readBytes(bytes);
}

void expectSameErrors(const TransferAsset& a, const TransferAsset& b) {
  EXPECT_EQ(a.error.degree, b.error.degree);
  EXPECT_EQ(a.error.channels, b.error.channels);
  EXPECT_EQ(a.error.vertexCount, b.error.vertexCount);
  EXPECT_EQ(a.error.values, b.error.values);
  EXPECT_EQ(a.emissionError, b.emissionError);
}

TEST(ErrorParts, ReadBackTheSameBits) {
  // More than one of OpenEXR's blocks of scan lines: 16 with zip, 32 with piz.
  TransferAsset high = makeAsset(32, 3, 70, false);
  high.error = {.degree = 32, .channels = 3, .vertexCount = 70, .values = {}};
  for (int i = 0; i < 3 * 33 * 70; ++i) high.error.values.push_back(1 / (1 + static_cast<float>(i)));
  for (const TransferAsset& asset : {greyAsset(), makeMeasuredAsset(5), makeMeasuredAsset(3000), high})
    for (const AssetCompression compression :
         {AssetCompression::kNone, AssetCompression::kZip, AssetCompression::kZips, AssetCompression::kPiz}) {
      // Half is for the transfer alone.
      writeAsset(scratch("same.prt.exr"), asset, {.half = true, .compression = compression});
      expectSameErrors(asset, readAsset(scratch("same.prt.exr")));
    }
}

TEST(ErrorParts, FollowEmission) {
  writtenBytes(makeMeasuredAsset(5));
  Imf::MultiPartInputFile file(scratch("errors.prt.exr").c_str());
  ASSERT_EQ(file.parts(), 9);
  EXPECT_EQ(file.header(4).name(), "emission");
  EXPECT_EQ(file.header(5).name(), "error");
  EXPECT_EQ(file.header(6).name(), "emissionError");
  const AssetPart part = listAssetParts(scratch("errors.prt.exr"))[5];
  EXPECT_EQ(part.name, "error");
  EXPECT_EQ(part.pixelType, "float");
  EXPECT_EQ(part.channels, "B,G,R");
  EXPECT_EQ(part.width, 5);
  EXPECT_EQ(part.height, 2);
}

TEST(ErrorParts, AreAbsentWhereNothingWasMeasured) {
  TransferAsset asset = makeSceneAsset(5);
  asset.metadata.plan.clear();
  EXPECT_EQ(writtenBytes(asset).find("rror"), std::string::npos);
  EXPECT_EQ(writtenBytes(asset).find("\"sampling\""), std::string::npos);
  const TransferAsset back = readAsset(scratch("errors.prt.exr"));
  EXPECT_TRUE(back.error.empty());
  EXPECT_TRUE(back.emissionError.empty());
  EXPECT_LT(back.metadata.samplingError, 0);
  EXPECT_LT(back.metadata.samplingErrorBound, 0);
  EXPECT_TRUE(back.metadata.verticesByRays.empty());
}

TEST(ErrorParts, OlderReadersPassOverThem) {
  const std::string unknown = nameOfPart("other");
  EXPECT_TRUE(readEdited(greyAsset(), nameOfPart("error"), unknown).error.empty());
}

TEST(ErrorParts, AreNotWrittenInAnotherShape) {
  const auto refuses = [](const auto& change, const char* fragment) {
    TransferAsset asset = makeMeasuredAsset(5);
    change(asset);
    expectError([&] { writeAsset(scratch("refused.prt.exr"), asset); }, fragment);
    EXPECT_FALSE(std::filesystem::exists(scratch("refused.prt.exr")));
  };
  const char* shape = "errors do not have the shape of its transfer";
  refuses([](TransferAsset& a) { a.error.degree = 0; }, shape);
  refuses([](TransferAsset& a) { a.error.channels = 1; }, shape);
  refuses([](TransferAsset& a) { a.error.vertexCount = 4; }, shape);
  refuses([](TransferAsset& a) { a.error.values.pop_back(); }, shape);
  const char* alone = "errors of emission";
  refuses([](TransferAsset& a) { a.error = {}; }, alone);
  refuses([](TransferAsset& a) { a.emission.clear(); }, alone);
  refuses([](TransferAsset& a) { a.emissionError.pop_back(); }, alone);
}

TEST(ErrorParts, AreRefusedInAnotherShape) {
  const std::string zero(1, '\0');
  const auto refuses = [&](const std::string& part, const std::string& from, const std::string& to,
                           const char* fragment) {
    expectError([&] { readWithEditedPart(makeMeasuredAsset(5), part, from, to); }, fragment);
  };
  refuses("error", littleEndian({0, 0, 4, 1}), littleEndian({0, 0, 3, 1}), "part error is 4 x 2, not 5 x 2");
  refuses("error", littleEndian({0, 0, 4, 1}), littleEndian({0, 0, 4, 0}), "part error is 5 x 1, not 5 x 2");
  refuses("error", littleEndian({0, 0, 4, 1}), littleEndian({0, 0, 4, 2}), "part error is 5 x 3, not 5 x 2");
  refuses("error", "R" + zero + littleEndian({2}), "R" + zero + littleEndian({0}),
          "part error has values of another type");
  refuses("error", "R" + zero + littleEndian({2}), "S" + zero + littleEndian({2}),
          "part error has the channels B,G,S instead of B,G,R");
  refuses("emissionError", littleEndian({0, 0, 4, 0}), littleEndian({0, 0, 3, 0}),
          "part emissionError is 4 x 1, not 5 x 1");
  expectError(
      [&] {
        readWithEditedPart(greyAsset(), "error", "Y" + zero + littleEndian({2}),
                           "L" + zero + littleEndian({2}));
      },
      "part error has the channels L instead of Y");
  forgetAllocations();
  EXPECT_THROW(readWithEditedPart(makeMeasuredAsset(5), "error", littleEndian({0, 0, 4, 1}),
                                  littleEndian({0, 0, 1'000'000'000, 1})),
               Error);
  EXPECT_LT(largestAllocation(), std::size_t{16} << 20);
  expectError([&] { readEdited(makeMeasuredAsset(5), nameOfPart("error"), nameOfPart("other")); },
              "part emissionError needs the parts error and emission");
  expectError([&] { readEdited(makeMeasuredAsset(5), nameOfPart("emission"), nameOfPart("radiance")); },
              "part emissionError needs the parts error and emission");
}

TEST(ErrorParts, AreNeitherNegativeNorInfinite) {
  const float bad[] = {-0x1p-100f, std::numeric_limits<float>::infinity(),
                       std::numeric_limits<float>::quiet_NaN()};
  for (const float value : bad) {
    TransferAsset asset = makeMeasuredAsset(5);
    asset.error.row(2, 1)[3] = value;
    expectError([&] { readBytes(writtenBytes(asset)); },
                "part error holds a value that is negative or not finite at vertex 3, band 1");
    asset = makeMeasuredAsset(5);
    asset.emissionError[4].y = value;
    expectError([&] { readBytes(writtenBytes(asset)); },
                "part emissionError holds a value that is negative or not finite at vertex 4");
  }
}

TEST(SamplingMetadata, ReadsBack) {
  const TransferAsset asset = makeMeasuredAsset(5);
  const AssetMetadata back = readBytes(writtenBytes(asset)).metadata;
  EXPECT_EQ(back.samplingError, asset.metadata.samplingError);
  EXPECT_EQ(back.samplingErrorBound, asset.metadata.samplingErrorBound);
  EXPECT_EQ(back.verticesByRays, asset.metadata.verticesByRays);
  TransferAsset adaptive = makeAsset(1, 1, 5, false);  // rays that differ, nothing measured
  adaptive.metadata.verticesByRays = {{16, 5}};
  EXPECT_EQ(readBytes(writtenBytes(adaptive)).metadata.verticesByRays, adaptive.metadata.verticesByRays);
  EXPECT_LT(readBytes(writtenBytes(adaptive)).metadata.samplingError, 0);
}

TEST(SamplingMetadata, RefusesDamage) {
  const TransferAsset asset = makeMeasuredAsset(5);
  const auto refuses = [&](const std::string& from, const std::string& to, const std::string& fragment) {
    expectError([&] { readEdited(asset, from, to); }, fragment);
  };
  refuses("\"error\": 0.0078125", "\"error\": -.0078125", "shprtMetadata holds no JSON object");
  refuses("\"error\": 0.0078125", "\"error\":-0.0078125", "shprtMetadata.sampling.error is negative");
  refuses("\"error\": 0.0078125", "\"error\": \"a lot!!\"", "shprtMetadata.sampling.error");
  refuses("\"errorBound\": 0.01", "\"errorBound\":-0.01", "shprtMetadata.sampling.errorBound is negative");
  refuses("65536", "    1", "verticesByRays has rays that are out of range or do not increase");
  refuses("65536", "   64", "verticesByRays has rays that are out of range or do not increase");
  refuses("65536", "9e999", "shprtMetadata holds no JSON object");
  refuses("65536", "-6553", "verticesByRays has an entry that is no pair of rays and vertices");
  refuses("65536", "6.536", "verticesByRays has an entry that is no pair of rays and vertices");
}

}  // namespace
}  // namespace shprt
