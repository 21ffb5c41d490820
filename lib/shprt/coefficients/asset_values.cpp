#include "shprt/coefficients/asset_values.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "shprt/coefficients/asset_layout.h"

namespace shprt {
namespace {

using namespace asset_layout;

// The first value that fails the test, in rows over vertices: [channel][row][vertex].
template <typename Test>
std::string problemOfRows(const char* part, const char* rowName, const std::vector<float>& values, int rows,
                          std::size_t vertexCount, const char* what, const Test& test) {
  const auto bad = std::find_if_not(values.begin(), values.end(), test);
  if (bad == values.end()) return "";
  const auto index = static_cast<std::size_t>(bad - values.begin());
  return std::string("part ") + part + " holds a value that is " + what + " at vertex " +
         std::to_string(index % vertexCount) + ", " + rowName + " " +
         std::to_string(index / vertexCount % static_cast<std::size_t>(rows));
}

template <typename Test>
std::string problemOfVectors(const char* part, const std::vector<Vec3f>& vectors, const char* what,
                             const Test& test) {
  const auto bad = std::find_if_not(vectors.begin(), vectors.end(), test);
  if (bad == vectors.end()) return "";
  return std::string("part ") + part + " holds a value that is " + what + " at vertex " +
         std::to_string(bad - vectors.begin());
}

std::string problemOfTriangles(const TransferAsset& asset) {
  for (std::size_t t = 0; t < asset.triangles.size(); ++t) {
    const std::uint32_t largest = *std::max_element(asset.triangles[t].begin(), asset.triangles[t].end());
    if (largest >= asset.transfer.vertexCount) {
      return std::string("part ") + kTriangles + " names vertex " + std::to_string(largest) +
             " in triangle " + std::to_string(t) + ", but there are " +
             std::to_string(asset.transfer.vertexCount);
    }
  }
  return "";
}

constexpr const char* kNotFinite = "not finite";
constexpr const char* kNoError = "negative or not finite";

bool isError(float value) {
  return std::isfinite(value) && value >= 0;
}

std::string problemOfErrors(const TransferAsset& asset) {
  std::string problem = problemOfRows(kError, "band", asset.error.values, asset.error.bands(),
                                      asset.error.vertexCount, kNoError, isError);
  if (!problem.empty()) return problem;
  return problemOfVectors(kEmissionError, asset.emissionError, kNoError,
                          [](const Vec3f& v) { return isError(v.x) && isError(v.y) && isError(v.z); });
}

}  // namespace

std::string problemOfValues(const TransferAsset& asset) {
  const TransferCoefficients& transfer = asset.transfer;
  std::string problem =
      problemOfRows(kTransfer, "coefficient", transfer.values, transfer.rows(), transfer.vertexCount,
                    kNotFinite, [](float value) { return std::isfinite(value); });
  const auto look = [&](const char* part, const std::vector<Vec3f>& vectors) {
    if (problem.empty())
      problem = problemOfVectors(part, vectors, kNotFinite, [](const Vec3f& v) { return isFinite(v); });
  };
  look(kPositions, asset.positions);
  look(kNormals, asset.normals);
  look(kAlbedo, asset.albedo);
  look(kEmission, asset.emission);
  if (problem.empty()) problem = problemOfErrors(asset);
  return problem.empty() ? problemOfTriangles(asset) : problem;
}

}  // namespace shprt
