// Kept vertices are in increasing order, so an entry never moves up: each array can be packed into its own
// beginning, and the rows of the transfer one after the other.
#include "shprt/coefficients/select_vertices.h"

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <vector>

#include "shprt/coefficients/object_ranges.h"

namespace shprt {
namespace {

constexpr std::uint32_t kDropped = 0xffffffffu;

// to[k] = from[kept[k]]; `to` may be `from` or lie before it.
template <typename T>
void gather(const T* from, T* to, std::span<const std::uint32_t> kept) {
  for (std::size_t k = 0; k < kept.size(); ++k) to[k] = from[kept[k]];
}

// Both may be the same array.
template <typename T>
void selectEntries(const std::vector<T>& whole, std::vector<T>& selected,
                   std::span<const std::uint32_t> kept) {
  if (whole.empty()) return;
  if (&selected != &whole) selected.resize(kept.size());
  gather(whole.data(), selected.data(), kept);
  selected.resize(kept.size());
}

int rowsPerChannel(const TransferCoefficients& transfer) {
  return transfer.rows();
}

int rowsPerChannel(const TransferError& error) {
  return error.bands();
}

// Of TransferCoefficients and TransferError, whose rows run over the vertices.
template <typename T>
void selectColumns(const T& whole, T& selected, std::span<const std::uint32_t> kept) {
  const auto rows = static_cast<std::size_t>(whole.channels * rowsPerChannel(whole));
  const std::size_t stride = whole.vertexCount;
  selected.degree = whole.degree;
  selected.channels = whole.channels;
  if (&selected != &whole) selected.values.resize(rows * kept.size());
  for (std::size_t row = 0; row < rows; ++row)
    gather(whole.values.data() + row * stride, selected.values.data() + row * kept.size(), kept);
  selected.values.resize(rows * kept.size());
  selected.vertexCount = kept.size();
}

void selectTriangles(const TransferAsset& whole, TransferAsset& selected,
                     std::span<const std::uint32_t> kept) {
  std::vector<std::uint32_t> newIndex(whole.positions.size(), kDropped);
  for (std::size_t k = 0; k < kept.size(); ++k) newIndex[kept[k]] = static_cast<std::uint32_t>(k);
  std::size_t count = 0;
  for (std::size_t t = 0; t < whole.triangles.size(); ++t) {
    const auto& [a, b, c] = whole.triangles[t];
    const std::array<std::uint32_t, 3> corners = {newIndex[a], newIndex[b], newIndex[c]};
    if (std::find(corners.begin(), corners.end(), kDropped) != corners.end()) continue;
    if (count == selected.triangles.size()) selected.triangles.emplace_back();
    selected.triangles[count++] = corners;
  }
  selected.triangles.resize(count);
}

// Both may be the same asset. Triangles come first: they are renumbered by the number of vertices there were.
void select(const TransferAsset& whole, TransferAsset& selected, std::span<const std::uint32_t> kept) {
  assert(std::adjacent_find(kept.begin(), kept.end(), std::greater_equal<>()) == kept.end());
  assert(kept.empty() || kept.back() < whole.transfer.vertexCount);
  selectTriangles(whole, selected, kept);
  selectColumns(whole.transfer, selected.transfer, kept);
  if (!whole.error.empty()) selectColumns(whole.error, selected.error, kept);
  selectEntries(whole.positions, selected.positions, kept);
  selectEntries(whole.normals, selected.normals, kept);
  selectEntries(whole.albedo, selected.albedo, kept);
  selectEntries(whole.emission, selected.emission, kept);
  selectEntries(whole.emissionError, selected.emissionError, kept);
  selectEntries(whole.textureCoordinates, selected.textureCoordinates, kept);
  selected.metadata.objects = keepRanges(whole.metadata.objects, kept);
}

}  // namespace

TransferAsset selectVertices(const TransferAsset& whole, std::span<const std::uint32_t> kept) {
  TransferAsset selected;
  selected.metadata = whole.metadata;
  select(whole, selected, kept);
  return selected;
}

TransferAsset selectVertices(TransferAsset&& whole, std::span<const std::uint32_t> kept) {
  if (kept.size() != whole.transfer.vertexCount) select(whole, whole, kept);
  return std::move(whole);
}

}  // namespace shprt
