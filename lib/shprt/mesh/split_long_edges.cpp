// Splitting until no edge is too long, and how many triangles that takes.
//
// Which edges of a triangle are split depends on their lengths alone, and so does how it is cut: the count
// follows from the three lengths, without making the triangles. Parts are similar to the whole where all
// three edges are split; the other patterns need the medians' lengths.

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <functional>
#include <numeric>
#include <string>
#include <utility>

#include "shprt/base/error.h"
#include "shprt/mesh/subdivide.h"

namespace shprt {
namespace {

class TriangleCounter {
 public:
  TriangleCounter(double maxEdge, std::uint64_t stepLimit)
      : longest_(maxEdge * maxEdge), stepsLeft_(stepLimit) {}

  // Squared lengths of the edges, in any order. Once the steps are used up, parts count as one.
  double count(std::array<double, 3> squared) {
    std::sort(squared.begin(), squared.end(), std::greater<>{});
    double factor = 1;
    while (squared[2] > longest_) {
      factor *= 4;
      for (double& s : squared) s /= 4;
    }
    const auto [a, b, c] = squared;
    if (!(a > longest_) || stepsLeft_ == 0) return factor;
    --stepsLeft_;
    const double medianOfA = (2 * b + 2 * c - a) / 4;
    if (!(b > longest_)) return factor * (count({a / 4, medianOfA, b}) + count({a / 4, medianOfA, c}));
    return factor *
           (count({a / 4, b / 4, c / 4}) + count({c, a / 4, medianOfA}) + count({medianOfA, c / 4, b / 4}));
  }

 private:
  double longest_;
  std::uint64_t stepsLeft_;
};

std::string shown(double number) {
  std::string digits = number < 1e15 ? std::to_string(static_cast<long long>(number)) : "1e15 or more";
  return digits;
}

void checkLimit(double triangles, std::uint64_t maxTriangles) {
  if (triangles <= static_cast<double>(maxTriangles)) return;
  throw Error("--max-edge",
              "splitting takes at least " + shown(triangles) + " triangles, more than " +
                  std::to_string(maxTriangles),
              "give a longer edge: " +
                  std::to_string(static_cast<long long>(
                      std::ceil(std::min(1e9, std::sqrt(triangles / static_cast<double>(maxTriangles)))))) +
                  " times the length is likely to do");
}

}  // namespace

double countSplitTriangles(const Mesh& mesh, double maxEdge, const std::vector<bool>& wanted,
                           std::uint64_t limit) {
  TriangleCounter counter(maxEdge, limit);
  double total = 0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    if (!wanted.empty() && !wanted[t]) continue;
    Vec3d p[3];
    for (std::size_t i = 0; i < 3; ++i) p[i] = toDouble(mesh.positions[mesh.triangles[t][i]]);
    const auto squared = [](Vec3d d) { return dot(d, d); };
    total += counter.count({squared(p[1] - p[0]), squared(p[2] - p[1]), squared(p[0] - p[2])});
  }
  return total;
}

Subdivision splitLongEdges(const Mesh& mesh, double maxEdge, const std::vector<bool>& wanted,
                           std::uint64_t maxTriangles) {
  assert(wanted.empty() || wanted.size() == mesh.triangles.size());
  if (!(maxEdge > 0) || !std::isfinite(maxEdge))
    throw Error("--max-edge", "the longest edge is " + std::to_string(maxEdge), "give a length above 0");
  checkLimit(countSplitTriangles(mesh, maxEdge, wanted, maxTriangles), maxTriangles);

  Subdivision result;
  result.mesh = mesh;
  result.triangleParents.resize(mesh.triangles.size());
  std::iota(result.triangleParents.begin(), result.triangleParents.end(), 0u);
  for (;;) {
    const MeshEdges edges = findEdges(result.mesh);
    std::vector<bool> marked(edges.lengths.size());
    std::uint64_t triangles = result.mesh.triangles.size();
    for (std::size_t t = 0; t < edges.ofTriangle.size(); ++t) {
      if (!wanted.empty() && !wanted[result.triangleParents[t]]) continue;
      for (const std::uint32_t edge : edges.ofTriangle[t])
        if (edges.lengths[edge] > maxEdge) marked[edge] = true;
    }
    for (const auto& ofTriangle : edges.ofTriangle)
      for (const std::uint32_t edge : ofTriangle) triangles += marked[edge];
    checkLimit(static_cast<double>(triangles), maxTriangles);
    Subdivision finer = splitEdges(result.mesh, edges, std::move(marked));
    if (finer.vertexParents.empty()) return result;
    for (std::uint32_t& parent : finer.triangleParents) parent = result.triangleParents[parent];
    result.mesh = std::move(finer.mesh);
    result.triangleParents = std::move(finer.triangleParents);
    result.vertexParents.insert(result.vertexParents.end(), finer.vertexParents.begin(),
                                finer.vertexParents.end());
  }
}

}  // namespace shprt
