#include "shprt/transfer/adaptive_refinement.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numeric>
#include <span>
#include <unordered_map>
#include <utility>

#include "shprt/base/box.h"
#include "shprt/transfer/bake.h"
#include "shprt/transfer/twin_transfers.h"
#include "shprt/transfer/vertices_below.h"

namespace shprt {
namespace {

// A white scene in which only the wanted vertices are baked.
Scene probeScene(const Mesh& mesh, const std::vector<bool>& wanted) {
  Scene scene = makeScene(mesh, std::vector<Vec3f>(mesh.positions.size(), Vec3f{1, 1, 1}));
  scene.objects.resize(2);
  scene.objects[1].role = Role::kBlocker;
  for (std::size_t v = 0; v < wanted.size(); ++v) scene.vertexObjects[v] = wanted[v] ? 0 : 1;
  return scene;
}

// What the probes of one level found. Differences are per edge of the scene; negative where none was
// compared.
struct Comparison {
  std::vector<double> differences;
  std::unordered_map<std::uint64_t, std::uint32_t> probeBetween;  // by its parents
  TwinTransfers transfers;                                        // of the scene's vertices and the probes
  std::uint64_t probes = 0;
};

std::uint64_t pairKey(const std::array<std::uint32_t, 2>& parents) {
  return (std::uint64_t{parents[0]} << 32) | parents[1];
}

class Refiner {
 public:
  Refiner(Scene scene, const AdaptiveRefinementOptions& options, const ProgressCallback& progress)
      : options_(options), progress_(progress), transfers_(options.degree) {
    const double extent = boxAround(scene.mesh.positions).extent();
    coarsest_ = options.coarsest * extent;
    finest_ = options.finest * extent;
    report_.verticesBefore = scene.mesh.positions.size();
    report_.trianglesBefore = scene.mesh.triangles.size();
    vertexLimit_ = static_cast<std::uint64_t>(options.growth * static_cast<double>(report_.verticesBefore)) +
                   options.extraVertices;
    refined_.scene = std::move(scene);
    refined_.triangleParents.resize(report_.trianglesBefore);
    std::iota(refined_.triangleParents.begin(), refined_.triangleParents.end(), 0u);
    transfers_.resize(report_.verticesBefore);
  }

  AdaptiveRefinement run() {
    const bool shadowed = !findVerticesBelow(PreparedScene(refined_.scene)).vertices.empty();
    while (shadowed && refineOnce()) {
    }
    report_.verticesAfter = refined_.scene.mesh.positions.size();
    report_.trianglesAfter = refined_.scene.mesh.triangles.size();
    return {std::move(refined_), std::move(report_)};
  }

 private:
  // One level; false when there is nothing more to do.
  bool refineOnce() {
    const MeshEdges edges = findEdges(refined_.scene.mesh);
    wanted_ = trianglesToRefine(refined_.scene, options_.objects);
    const std::vector<bool> compared = edgesToCompare(edges);
    if (std::find(compared.begin(), compared.end(), true) == compared.end()) return false;
    const Comparison comparison = compare(edges, compared);

    RefinementLevel& level = report_.levels.emplace_back();
    level.probes = comparison.probes;
    for (const double d : comparison.differences)
      level.largestDifference = std::max(level.largestDifference, d);

    bool limited = false;
    const std::vector<bool> marked = edgesToSplit(edges, comparison.differences, limited);
    noteWhatRemains(edges, comparison.differences, marked, limited);
    split(edges, marked, comparison, level);
    return !limited && level.edgesSplit > 0;
  }

  // Long edges of what may be refined. Those of triangles that did not change have been compared before: an
  // edge is new when one of its ends is. Where the probes around are dense, edges whose ends nearly agree are
  // taken to be right in between: along an edge on which transfer only rises or only falls, its middle is off
  // the mean by no more than half of what the ends differ by.
  std::vector<bool> edgesToCompare(const MeshEdges& edges) {
    const Mesh& mesh = refined_.scene.mesh;
    std::vector<bool> candidate(edges.lengths.size()), compared(edges.lengths.size());
    std::vector<bool> needed(mesh.positions.size());
    for (std::size_t t = 0; t < wanted_.size(); ++t) {
      if (!wanted_[t]) continue;
      for (const std::uint32_t edge : edges.ofTriangle[t]) {
        if (!(edges.lengths[edge] > finest_) ||
            std::max(edges.ends[edge][0], edges.ends[edge][1]) < firstNewVertex_)
          continue;
        candidate[edge] = true;
        for (const std::uint32_t v : mesh.triangles[t]) needed[v] = !transfers_.known(v);
      }
    }
    bake(mesh, needed, transfers_);
    for (std::size_t t = 0; t < wanted_.size(); ++t)
      for (std::size_t i = 0; i < 3; ++i) {
        const std::uint32_t edge = edges.ofTriangle[t][i], a = mesh.triangles[t][i],
                            b = mesh.triangles[t][(i + 1) % 3];
        if (wanted_[t] && candidate[edge] &&
            (edges.lengths[edge] > coarsest_ / 2 ||
             transfers_.difference(a, transfers_, b) > 2 * options_.tolerance))
          compared[edge] = true;
      }
    return compared;
  }

  Comparison compare(const MeshEdges& edges, const std::vector<bool>& compared) {
    const Mesh& mesh = refined_.scene.mesh;
    const std::size_t vertexCount = mesh.positions.size();
    const Subdivision halved = splitEdges(mesh, edges, compared);
    std::vector<bool> probed(halved.mesh.triangles.size());
    for (std::size_t t = 0; t < probed.size(); ++t) {
      const std::uint32_t parent = halved.triangleParents[t];
      const auto& sides = edges.ofTriangle[parent];
      probed[t] = wanted_[parent] &&
                  std::any_of(sides.begin(), sides.end(), [&](std::uint32_t e) { return compared[e]; });
    }
    const Subdivision dense = splitLongEdges(halved.mesh, probeSpacing(halved.mesh, probed), probed);

    Comparison comparison{.differences = std::vector<double>(edges.lengths.size(), -1.0),
                          .probeBetween = {},
                          .transfers = transfers_,
                          .probes = 0};
    std::vector<bool> needed(dense.mesh.positions.size());
    for (std::size_t t = 0; t < dense.mesh.triangles.size(); ++t)
      if (probed[dense.triangleParents[t]])
        for (const std::uint32_t v : dense.mesh.triangles[t])
          needed[v] = v >= vertexCount || !transfers_.known(v);
    bake(dense.mesh, needed, comparison.transfers);
    for (std::uint32_t v = 0; v < vertexCount; ++v)
      if (needed[v]) transfers_.copy(comparison.transfers, v, v);

    std::vector<double> differences = differencesAtProbes(halved, dense, comparison.transfers);
    for (std::size_t i = 0; i < halved.vertexParents.size(); ++i) {
      const auto probe = static_cast<std::uint32_t>(vertexCount + i);
      if (!needed[probe]) continue;
      comparison.probeBetween[pairKey(halved.vertexParents[i])] = probe;
      double& atEdge = comparison.differences[halved.vertexEdges[i]];
      atEdge = std::max(atEdge, differences[i]);
    }
    // A difference deeper inside a triangle speaks for its longest edge.
    for (std::size_t t = 0; t < dense.mesh.triangles.size(); ++t) {
      if (!probed[dense.triangleParents[t]]) continue;
      double& atLongest =
          comparison.differences[edges.longestOf(halved.triangleParents[dense.triangleParents[t]])];
      for (const std::uint32_t v : dense.mesh.triangles[t])
        if (v >= halved.mesh.positions.size()) atLongest = std::max(atLongest, differences[v - vertexCount]);
    }
    comparison.probes = static_cast<std::uint64_t>(
        std::count(needed.begin() + static_cast<std::ptrdiff_t>(vertexCount), needed.end(), true));
    return comparison;
  }

  // Wide enough apart that the probes are not many more than the vertices there may be.
  double probeSpacing(const Mesh& mesh, const std::vector<bool>& probed) const {
    constexpr double kWiden = 1.4;
    const auto most = std::max<std::uint64_t>(2 * vertexLimit_, mesh.triangles.size());
    double spacing = coarsest_;
    while (countSplitTriangles(mesh, spacing, probed, most) > static_cast<double>(most)) spacing *= kWiden;
    return spacing;
  }

  void bake(const Mesh& mesh, const std::vector<bool>& needed, TwinTransfers& transfers) {
    transfers.resize(mesh.positions.size());
    if (std::find(needed.begin(), needed.end(), true) == needed.end()) return;
    const Scene scene = probeScene(mesh, needed);
    for (int twin = 0; twin < 2; ++twin) {
      const Bake baked = bakeShadowed(scene, {.degree = options_.degree,
                                              .rays = options_.rays,
                                              .seed = 2 * options_.seed + static_cast<std::uint64_t>(twin)});
      for (std::uint32_t v = 0; v < needed.size(); ++v)
        if (needed[v]) transfers.store(baked.transfer, twin, v);
      report_.rays += baked.statistics.rays;
      ++bakesDone_;
      if (progress_) progress_({bakesDone_, 0, report_.rays});
    }
  }

  // Per probe: between its transfer and the one interpolated from the scene's vertices, which halving repeats
  // exactly, as a probe's parents lie in the same triangle.
  std::vector<double> differencesAtProbes(const Subdivision& halved, const Subdivision& dense,
                                          const TwinTransfers& transfers) const {
    const std::size_t vertexCount = transfers_.vertexCount();
    TwinTransfers interpolated = transfers_;
    interpolated.resize(dense.mesh.positions.size());
    std::vector<double> differences;
    for (const auto* parents : {&halved.vertexParents, &dense.vertexParents})
      for (const auto& [a, b] : *parents) {
        const auto probe = static_cast<std::uint32_t>(vertexCount + differences.size());
        interpolated.setMean(a, b, probe);
        differences.push_back(transfers.difference(probe, interpolated, probe));
      }
    return differences;
  }

  // The edges above the tolerance and what keeps angles in order; where that makes too many vertices, as many
  // of the worst as there is room for. Area counts: a difference weighs as much as the surface that shows it.
  std::vector<bool> edgesToSplit(const MeshEdges& edges, const std::vector<double>& differences,
                                 bool& limited) const {
    std::vector<std::uint32_t> wanted;
    for (std::uint32_t edge = 0; edge < differences.size(); ++edge)
      if (differences[edge] > options_.tolerance && edges.lengths[edge] > finest_) wanted.push_back(edge);
    const auto weight = [&](std::uint32_t edge) { return differences[edge] * edges.lengths[edge]; };
    std::stable_sort(wanted.begin(), wanted.end(),
                     [&](std::uint32_t a, std::uint32_t b) { return weight(a) > weight(b); });
    const auto worst = [&](std::size_t count) {
      std::vector<bool> marked(edges.lengths.size());
      for (std::size_t i = 0; i < count; ++i) marked[wanted[i]] = true;
      markLongestEdges(edges, marked);
      return marked;
    };
    std::vector<bool> marked = worst(wanted.size());
    if (fits(edges, marked)) return marked;
    limited = true;
    std::size_t fitting = 0, tooMany = wanted.size();
    while (tooMany - fitting > 1) {
      const std::size_t middle = fitting + (tooMany - fitting) / 2;
      (fits(edges, worst(middle)) ? fitting : tooMany) = middle;
    }
    return worst(fitting);
  }

  bool fits(const MeshEdges& edges, const std::vector<bool>& marked) const {
    const Mesh& mesh = refined_.scene.mesh;
    return mesh.positions.size() + splitEdges(mesh, edges, marked).vertexParents.size() <= vertexLimit_;
  }

  void noteWhatRemains(const MeshEdges& edges, const std::vector<double>& differences,
                       const std::vector<bool>& marked, bool limited) {
    if (limited) report_.stop = RefinementStop::kVertexLimit;
    for (std::size_t edge = 0; edge < differences.size(); ++edge) {
      const bool tooShort = marked[edge] && edges.lengths[edge] / 2 <= finest_;
      if (marked[edge] && !tooShort) continue;
      report_.remainingDifference = std::max(report_.remainingDifference, differences[edge]);
      if (tooShort && differences[edge] > options_.tolerance && !limited)
        report_.stop = RefinementStop::kFinest;
    }
  }

  void split(const MeshEdges& edges, const std::vector<bool>& marked, const Comparison& comparison,
             RefinementLevel& level) {
    level.edgesSplit = static_cast<std::uint64_t>(std::count(marked.begin(), marked.end(), true));
    Subdivision finer = splitEdges(refined_.scene.mesh, edges, marked);
    firstNewVertex_ = static_cast<std::uint32_t>(refined_.scene.mesh.positions.size());
    transfers_.resize(finer.mesh.positions.size());
    for (std::size_t i = 0; i < finer.vertexParents.size(); ++i) {
      const auto probe = comparison.probeBetween.find(pairKey(finer.vertexParents[i]));
      if (probe != comparison.probeBetween.end())
        transfers_.copy(comparison.transfers, probe->second, static_cast<std::uint32_t>(firstNewVertex_ + i));
    }
    refined_.vertexParents.insert(refined_.vertexParents.end(), finer.vertexParents.begin(),
                                  finer.vertexParents.end());
    for (std::uint32_t& parent : finer.triangleParents) parent = refined_.triangleParents[parent];
    refined_.triangleParents = std::move(finer.triangleParents);
    refined_.scene = onSubdivision(std::move(refined_.scene), std::move(finer));
  }

  const AdaptiveRefinementOptions& options_;
  const ProgressCallback& progress_;
  double coarsest_ = 0, finest_ = 0;
  std::uint64_t vertexLimit_ = 0, bakesDone_ = 0;
  std::uint32_t firstNewVertex_ = 0;
  std::vector<bool> wanted_;  // per triangle, whether it may be refined
  RefinedScene refined_;
  TwinTransfers transfers_;  // of the scene's vertices, as far as known
  AdaptiveRefinementReport report_;
};

}  // namespace

AdaptiveRefinement refineAdaptively(Scene scene, const AdaptiveRefinementOptions& options,
                                    const ProgressCallback& progress) {
  assert(options.tolerance > 0 && options.finest > 0 && options.coarsest >= options.finest);
  assert(options.rays >= 1 && options.degree >= 0 && options.growth >= 1);
  return Refiner(std::move(scene), options, progress).run();
}

}  // namespace shprt
