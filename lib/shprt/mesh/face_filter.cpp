#include <algorithm>
#include <numeric>

#include "shprt/mesh/preflight.h"

namespace shprt {
namespace {

// Exact for the few corners that faces usually have; larger faces are sorted anyway.
bool mayRepeat(const std::vector<std::int64_t>& corners) {
  if (corners.size() > 8) return true;
  for (std::size_t i = 1; i < corners.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      if (corners[i] == corners[j]) return true;
    }
  return false;
}

}  // namespace

void FaceFilter::separateRepeats(std::vector<std::int64_t>& corners) {
  std::vector<std::size_t> order(corners.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return corners[a] != corners[b] ? corners[a] < corners[b] : a < b;
  });
  // From the back, so that each corner still meets its neighbour's own index.
  for (std::size_t k = order.size() - 1; k > 0; --k) {
    if (corners[order[k]] != corners[order[k - 1]]) continue;
    file_.duplicateOf.push_back(static_cast<std::uint32_t>(corners[order[k]]));
    corners[order[k]] = static_cast<std::int64_t>(vertexCount_ + file_.duplicateOf.size() - 1);
  }
}

bool FaceFilter::keep(std::vector<std::int64_t>& corners) {
  MeshReport& report = file_.report;
  ++report.sourceFaces;
  if (corners.size() < 3) {
    ++report.shortFaces;
    return false;
  }
  report.sourceTriangles += corners.size() - 2;
  for (const std::int64_t corner : corners) {
    if (corner < 0 || corner >= static_cast<std::int64_t>(vertexCount_)) {
      ++report.badIndexFaces;
      return false;
    }
  }
  if (!file_.unusableVertex.empty()) {
    for (const std::int64_t corner : corners) {
      if (file_.unusableVertex[static_cast<std::size_t>(corner)]) {
        ++report.nonFiniteFaces;
        return false;
      }
    }
  }
  file_.corners += corners.size();
  if (mayRepeat(corners)) separateRepeats(corners);
  return true;
}

std::string countOf(std::uint64_t count, const std::string& thing, const std::string& things) {
  return std::to_string(count) + " " + (count == 1 ? thing : things.empty() ? thing + "s" : things);
}

}  // namespace shprt
