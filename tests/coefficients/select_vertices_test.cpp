// Selections keep what belongs to their vertices, bit for bit, whether copied or packed in place.
#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "shprt/coefficients/object_ranges.h"
#include "shprt/coefficients/select_vertices.h"

namespace shprt {
namespace {

// Every number tells where it comes from.
TransferAsset makeWhole(int channels, std::uint32_t vertices) {
  TransferAsset whole;
  whole.transfer = {.degree = 2, .channels = channels, .vertexCount = vertices, .values = {}};
  for (int row = 0; row < channels * 9; ++row)
    for (std::uint32_t v = 0; v < vertices; ++v)
      whole.transfer.values.push_back(static_cast<float>(row) * 1000 + static_cast<float>(v));
  whole.error = {.degree = 2, .channels = channels, .vertexCount = vertices, .values = {}};
  for (int row = 0; row < channels * 3; ++row)
    for (std::uint32_t v = 0; v < vertices; ++v)
      whole.error.values.push_back(static_cast<float>(row) * 100 + static_cast<float>(v));
  for (std::uint32_t v = 0; v < vertices; ++v) {
    const auto f = static_cast<float>(v);
    whole.positions.push_back({f, 1, 0});
    whole.normals.push_back({f, 2, 0});
    whole.albedo.push_back({f, 3, 0});
    whole.emission.push_back({f, 4, 0});
    whole.emissionError.push_back({f, 6, 0});
    whole.textureCoordinates.push_back({f, 5});
    if (v >= 2) whole.triangles.push_back({v, v - 2, v - 1});
  }
  whole.metadata.model = "interreflected";
  whole.metadata.objects = {
      {"first", "1.obj", 0, 4}, {"second", "2.obj", 4, 1}, {"third", "3.obj", 5, vertices - 5}};
  return whole;
}

void expectSelection(const TransferAsset& selected, const TransferAsset& whole,
                     const std::vector<std::uint32_t>& kept) {
  ASSERT_EQ(selected.transfer.vertexCount, kept.size());
  ASSERT_EQ(selected.transfer.values.size(),
            whole.transfer.values.size() / whole.positions.size() * kept.size());
  EXPECT_EQ(selected.transfer.degree, whole.transfer.degree);
  EXPECT_EQ(selected.transfer.channels, whole.transfer.channels);
  ASSERT_EQ(selected.error.vertexCount, kept.size());
  ASSERT_EQ(selected.error.values.size(), whole.error.values.size() / whole.positions.size() * kept.size());
  EXPECT_EQ(selected.error.degree, whole.error.degree);
  EXPECT_EQ(selected.error.channels, whole.error.channels);
  EXPECT_EQ(selected.metadata.model, whole.metadata.model);
  for (std::size_t k = 0; k < kept.size(); ++k) {
    const std::size_t v = kept[k];
    for (int channel = 0; channel < whole.transfer.channels; ++channel)
      for (int i = 0; i < whole.transfer.rows(); ++i)
        ASSERT_EQ(selected.transfer.row(channel, i)[k], whole.transfer.row(channel, i)[v]);
    for (int channel = 0; channel < whole.error.channels; ++channel)
      for (int l = 0; l < whole.error.bands(); ++l)
        ASSERT_EQ(selected.error.row(channel, l)[k], whole.error.row(channel, l)[v]);
    EXPECT_EQ(selected.positions.at(k), whole.positions[v]);
    EXPECT_EQ(selected.normals.at(k), whole.normals[v]);
    EXPECT_EQ(selected.albedo.at(k), whole.albedo[v]);
    EXPECT_EQ(selected.emission.at(k), whole.emission[v]);
    EXPECT_EQ(selected.emissionError.at(k), whole.emissionError[v]);
    EXPECT_EQ(selected.textureCoordinates.at(k), whole.textureCoordinates[v]);
  }
  EXPECT_EQ(selected.positions.size(), kept.size());
  EXPECT_EQ(selected.emission.size(), kept.size());
}

TEST(SelectVertices, KeepsColumnsEntriesTrianglesAndObjects) {
  const std::vector<std::uint32_t> kept = {0, 2, 3, 6, 7, 8, 9, 11};
  for (const int channels : {1, 3}) {
    const TransferAsset whole = makeWhole(channels, 12);
    const TransferAsset copied = selectVertices(whole, kept);
    expectSelection(copied, whole, kept);
    // {8,6,7} and {9,7,8} keep their corners in order; the others lose one.
    EXPECT_EQ(copied.triangles, (std::vector<std::array<std::uint32_t, 3>>{{5, 3, 4}, {6, 4, 5}}));
    EXPECT_EQ(copied.metadata.objects,
              (std::vector<ObjectRange>{{"first", "1.obj", 0, 3}, {"third", "3.obj", 3, 5}}));
    TransferAsset given = whole;
    const TransferAsset packed = selectVertices(std::move(given), kept);
    expectSelection(packed, whole, kept);
    EXPECT_EQ(packed.transfer.values, copied.transfer.values);
    EXPECT_EQ(packed.error.values, copied.error.values);
    EXPECT_EQ(packed.triangles, copied.triangles);
    EXPECT_EQ(packed.metadata.objects, copied.metadata.objects);
  }
}

TEST(SelectVertices, LeavesEmptyArraysEmpty) {
  TransferAsset whole = makeWhole(1, 6);
  whole.emission.clear();
  whole.error = {};
  whole.emissionError.clear();
  whole.textureCoordinates.clear();
  const std::vector<std::uint32_t> kept = {1, 2, 3};
  EXPECT_TRUE(selectVertices(whole, kept).emission.empty());
  EXPECT_TRUE(selectVertices(whole, kept).error.empty());
  EXPECT_TRUE(selectVertices(whole, kept).emissionError.empty());
  EXPECT_TRUE(selectVertices(std::move(whole), kept).textureCoordinates.empty());
}

TEST(SelectVertices, MovesWhatIsKeptWhole) {
  TransferAsset whole = makeWhole(3, 7);
  const TransferAsset copy = whole;
  const float* values = whole.transfer.values.data();
  std::vector<std::uint32_t> all(7);
  std::iota(all.begin(), all.end(), 0u);
  const TransferAsset selected = selectVertices(std::move(whole), all);
  EXPECT_EQ(selected.transfer.values.data(), values);
  expectSelection(selected, copy, all);
  EXPECT_EQ(selectVertices(copy, all).triangles, copy.triangles);
  EXPECT_EQ(selectVertices(copy, {}).transfer.values.size(), 0u);
}

TEST(ObjectRanges, AreTheRunsOfEqualObjects) {
  const std::vector<ObjectRange> objects = {{"a", "a.obj", 0, 0}, {"b", "b.obj", 0, 0}, {"c", "c.obj", 0, 0}};
  // As where edges of a were subdivided after b was appended.
  const std::vector<std::uint32_t> vertexObjects = {0, 0, 0, 1, 1, 0};
  EXPECT_EQ(objectRanges(vertexObjects, objects),
            (std::vector<ObjectRange>{{"a", "a.obj", 0, 3}, {"b", "b.obj", 3, 2}, {"a", "a.obj", 5, 1}}));
  EXPECT_TRUE(objectRanges({}, objects).empty());
  EXPECT_EQ(problemOfRanges(objectRanges(vertexObjects, objects), 6), "");
  EXPECT_NE(problemOfRanges(objectRanges(vertexObjects, objects), 5), "");
}

}  // namespace
}  // namespace shprt
