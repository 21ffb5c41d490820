// What scenes add to the asset file: it survives, is checked like the rest, and may be absent.
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

using test::scratch;

// Of no scene, and of one: both have 5 vertices.
TransferAsset plainAsset() {
  return test::makeAsset(1, 1, 5, false);
}

TransferAsset sceneAsset() {
  return test::makeSceneAsset(5);
}

std::string errorOf(const std::function<void()>& action) {
  try {
    action();
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

void expectError(const std::function<void()>& action, const std::string& fragment) {
  const std::string error = errorOf(action);
  EXPECT_NE(error.find(fragment), std::string::npos) << "'" << error << "' lacks '" << fragment << "'";
}

std::string writtenBytes(const TransferAsset& asset) {
  writeAsset(scratch("scene.prt.exr"), asset);
  return readFile(scratch("scene.prt.exr"));
}

// Reads an asset after some bytes of its file, all occurrences, were replaced by as many others.
TransferAsset readEdited(const TransferAsset& asset, const std::string& from, const std::string& to) {
  std::string bytes = writtenBytes(asset);
  EXPECT_EQ(from.size(), to.size());
  EXPECT_NE(bytes.find(from), std::string::npos) << from;
  for (std::size_t at = bytes.find(from); at != std::string::npos; at = bytes.find(from, at + to.size()))
    bytes.replace(at, from.size(), to);
  std::filesystem::remove(scratch("edited.prt.exr"));
  std::ofstream(scratch("edited.prt.exr"), std::ios::binary) << bytes;
  return readAsset(scratch("edited.prt.exr"));
}

TEST(SceneAsset, ReadsBackWhatScenesAdd) {
  const TransferAsset asset = sceneAsset();
  for (const bool half : {false, true}) {
    writeAsset(scratch("scene.prt.exr"), asset, {.half = half});
    const TransferAsset back = readAsset(scratch("scene.prt.exr"));
    EXPECT_EQ(back.emission, asset.emission);  // half is for the transfer alone
    EXPECT_EQ(back.metadata.objects, asset.metadata.objects);
    EXPECT_EQ(back.metadata.bounces, 7);
    EXPECT_TRUE(back.metadata.tailSummed);
    EXPECT_EQ(back.metadata.plan, asset.metadata.plan);
  }
  Imf::MultiPartInputFile file(scratch("scene.prt.exr").c_str());
  ASSERT_EQ(file.parts(), 7);
  EXPECT_EQ(file.header(4).name(), "emission");
}

TEST(SceneAsset, HasNoneOfItForAPlainMesh) {
  const std::string bytes = writtenBytes(plainAsset());
  for (const char* word : {"emission", "\"objects\"", "\"bounces\"", "\"tailSummed\"", "\"plan\""})
    EXPECT_EQ(bytes.find(word), std::string::npos) << word;
  const TransferAsset back = readAsset(scratch("scene.prt.exr"));
  EXPECT_TRUE(back.emission.empty());
  EXPECT_TRUE(back.metadata.objects.empty());
  EXPECT_EQ(back.metadata.bounces, -1);
  EXPECT_FALSE(back.metadata.tailSummed);
  EXPECT_EQ(back.metadata.plan, "");
}

// Made by the first release, before there were scenes.
TEST(SceneAsset, OlderFilesStillRead) {
  for (const char* name : {"knot.prt.exr", "courtyard.prt.exr"}) {
    const TransferAsset asset = readAsset(std::string(SHPRT_SOURCE_DIR "/tests/golden/") + name);
    EXPECT_TRUE(asset.emission.empty());
    EXPECT_TRUE(asset.metadata.objects.empty());
    EXPECT_EQ(asset.metadata.bounces, -1);
  }
}

TEST(SceneAsset, RefusesToWriteWhatItWouldNotRead) {
  const auto refuses = [](const auto& change, const char* fragment) {
    TransferAsset asset = sceneAsset();
    change(asset);
    expectError([&] { writeAsset(scratch("refused.prt.exr"), asset); }, fragment);
    EXPECT_FALSE(std::filesystem::exists(scratch("refused.prt.exr")));
  };
  refuses([](TransferAsset& a) { a.emission.pop_back(); }, "different numbers of vertices");
  for (const char* plan : {"[]", "3", "{", "{},{}", "{}]", "{\"a\":1e999}"})
    refuses([&](TransferAsset& a) { a.metadata.plan = plan; }, "plan");
  refuses([](TransferAsset& a) { a.metadata.plan = "{\"a\":\"" + std::string(1 << 20, 'x') + "\"}"; },
          "1 MB");
  refuses([](TransferAsset& a) { a.metadata.objects[1].firstVertex = 1; }, "objects[1] begins before");
  refuses([](TransferAsset& a) { a.metadata.objects[1].vertexCount = 4; }, "objects[1] ends beyond the 5");
  refuses([](TransferAsset& a) { a.metadata.objects[0].firstVertex = 6; }, "objects[0] ends beyond");
  refuses(
      [](TransferAsset& a) { a.metadata.objects[1].vertexCount = std::numeric_limits<std::uint64_t>::max(); },
      "objects[1] ends beyond");
}

// Whatever depth is written can be read.
TEST(SceneAsset, NestsPlansAsDeepAsItReads) {
  TransferAsset asset = sceneAsset();
  std::size_t deepest = 0;
  for (std::size_t depth = 1; depth < 200; ++depth) {
    asset.metadata.plan = "{\"a\":" + std::string(depth, '[') + std::string(depth, ']') + "}";
    if (!errorOf([&] { writeAsset(scratch("deep.prt.exr"), asset); }).empty()) break;
    EXPECT_EQ(readAsset(scratch("deep.prt.exr")).metadata.plan, asset.metadata.plan);
    deepest = depth;
  }
  EXPECT_GT(deepest, 50u);
  EXPECT_LT(deepest, 150u);
}

// The attributes of a part stand in alphabetical order, so its name is the place to look back from.
TransferAsset readWithEditedEmission(const std::string& from, const std::string& to) {
  std::string bytes = writtenBytes(sceneAsset());
  bytes.replace(bytes.rfind(from, bytes.find("emission")), from.size(), to);
  std::ofstream(scratch("edited.prt.exr"), std::ios::binary) << bytes;
  return readAsset(scratch("edited.prt.exr"));
}

std::string littleEndian(std::initializer_list<std::int32_t> words) {
  std::string bytes;
  for (const std::int32_t word : words) bytes.append(reinterpret_cast<const char*>(&word), 4);
  return bytes;
}

TEST(SceneAsset, RefusesEmissionOfAnotherSizeOrKind) {
  const std::string zero(1, '\0');
  const auto refuses = [](const std::string& from, const std::string& to, const char* fragment) {
    expectError([&] { readWithEditedEmission(from, to); }, fragment);
  };
  refuses(littleEndian({0, 0, 4, 0}), littleEndian({0, 0, 3, 0}), "part emission is 4 x 1, not 5 x 1");
  forgetAllocations();
  EXPECT_THROW(readWithEditedEmission(littleEndian({0, 0, 4, 0}), littleEndian({0, 0, 1'000'000'000, 0})),
               Error);
  EXPECT_LT(largestAllocation(), std::size_t{16} << 20);
  refuses("R" + zero + littleEndian({2}), "R" + zero + littleEndian({0}),
          "part emission has values of another type");
  refuses("R" + zero + littleEndian({2}), "S" + zero + littleEndian({2}),
          "part emission has the channels B,G,S instead of B,G,R");
}

TEST(SceneAsset, RefusesDamage) {
  const TransferAsset asset = sceneAsset();
  const auto refuses = [&](const std::string& from, const std::string& to, const std::string& fragment) {
    expectError([&] { readEdited(asset, from, to); }, fragment);
  };
  refuses("\"bounces\": 7", "\"bounces\":-7", "bounces is out of range");
  refuses("\"tailSummed\": true", "\"tailSummed\": 1234", "tailSummed is neither true nor false");
  refuses("\"vertexCount\": 2", "\"vertexCount\": 4",
          "objects[1] begins before the end of the one before it");
  refuses("\"firstVertex\": 2", "\"firstVertex\": 4", "objects[1] ends beyond the 5 vertices");
  refuses("\"vertexCount\": 2", "\"vertexCount\":-2", "objects[0].vertexCount is no whole number");
  refuses("\"firstVertex\"", "\"firztVertex\"", "objects[0].firstVertex is missing");
  TransferAsset planless = asset;
  planless.metadata.plan = "{}";
  expectError([&] { readEdited(planless, "\"plan\": {}", "\"plan\": []"); },
              "shprtMetadata.plan is no object");
  TransferAsset notFinite = asset;
  notFinite.emission[3].y = std::numeric_limits<float>::quiet_NaN();
  writeAsset(scratch("nan.prt.exr"), notFinite);
  expectError([&] { readAsset(scratch("nan.prt.exr")); },
              "part emission holds a value that is not finite at vertex 3");
  // A reader that does not know a part passes over it, as older ones do with emission.
  EXPECT_TRUE(readEdited(asset, "emission", "radiance").emission.empty());
}

}  // namespace
}  // namespace shprt
