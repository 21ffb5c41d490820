#include <algorithm>

#include "shprt/mesh/preflight.h"

namespace shprt {

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
  std::vector<std::int64_t> sorted = corners;
  std::sort(sorted.begin(), sorted.end());
  if (std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end()) {
    for (std::size_t i = 1; i < corners.size(); ++i) {
      if (std::find(corners.begin(), corners.begin() + static_cast<std::ptrdiff_t>(i), corners[i]) ==
          corners.begin() + static_cast<std::ptrdiff_t>(i)) {
        continue;
      }
      file_.duplicateOf.push_back(static_cast<std::uint32_t>(corners[i]));
      corners[i] = static_cast<std::int64_t>(vertexCount_ + file_.duplicateOf.size() - 1);
    }
  }
  return true;
}

std::string countOf(std::uint64_t count, const std::string& thing, const std::string& things) {
  return std::to_string(count) + " " + (count == 1 ? thing : things.empty() ? thing + "s" : things);
}

}  // namespace shprt
