// STL, ASCII and binary: the canonical file is binary, without the triangles that OpenMesh's welding would
// choke on.

#include <algorithm>
#include <array>
#include <cstring>
#include <vector>

#include "shprt/base/error.h"
#include "shprt/mesh/position_ids.h"
#include "shprt/mesh/preflight.h"
#include "shprt/mesh/text.h"

namespace shprt {
namespace {

constexpr std::size_t kHeaderBytes = 84, kTriangleBytes = 50;

std::uint32_t claimedTriangles(std::string_view bytes) {
  std::uint32_t count;
  std::memcpy(&count, bytes.data() + 80, 4);
  return count;
}

// Some exporters begin binary files with "solid" too; only ASCII has the word "facet" soon after it.
bool isAscii(std::string_view bytes) {
  if (!trimBlanks(bytes.substr(0, 512)).starts_with("solid")) return false;
  if (bytes.size() >= kHeaderBytes &&
      bytes.size() == kHeaderBytes + kTriangleBytes * std::uint64_t{claimedTriangles(bytes)})
    return false;
  return bytes.find("facet") != std::string_view::npos || bytes.find("endsolid") != std::string_view::npos;
}

// Corner positions of all triangles, three by three; an unreadable number is NaN.
std::vector<Vec3f> readAscii(std::string_view text, const std::string& path) {
  std::vector<Vec3f> corners;
  std::size_t lineNumber = 0;
  bool closed = true;
  while (!text.empty()) {
    std::string_view line = takeLine(text);
    ++lineNumber;
    const std::string_view keyword = takeToken(line);
    if (keyword == "facet") {
      if (!closed || corners.size() % 3 != 0)
        throw Error(path, "line " + std::to_string(lineNumber) + ": a facet begins inside another",
                    "export the mesh again");
      closed = false;
    } else if (keyword == "endfacet") {
      if (corners.size() % 3 != 0)
        throw Error(path, "line " + std::to_string(lineNumber) + ": a facet without three vertices",
                    "export the mesh again");
      closed = true;
    } else if (keyword == "vertex") {
      float xyz[3];
      for (float& coordinate : xyz) coordinate = parseFloat(takeToken(line)).value_or(NAN);
      corners.push_back({xyz[0], xyz[1], xyz[2]});
    }
  }
  if (!closed) throw Error(path, "ends inside a facet", "the file is truncated; export the mesh again");
  return corners;
}

std::vector<Vec3f> readBinary(std::string_view bytes, const std::string& path,
                              std::vector<std::string>& notes) {
  if (bytes.size() < kHeaderBytes)
    throw Error(path, "is too short to be an STL file", "export the mesh again");
  const std::uint64_t claimed = claimedTriangles(bytes),
                      room = (bytes.size() - kHeaderBytes) / kTriangleBytes;
  if (claimed > room) {
    throw Error(
        path,
        "claims " + std::to_string(claimed) + " triangles, the file has room for " + std::to_string(room),
        "it is truncated or no STL file");
  }
  const std::uint64_t rest = bytes.size() - kHeaderBytes - claimed * kTriangleBytes;
  if (rest > 0) notes.push_back(countOf(rest, "byte") + " after the last triangle ignored");
  std::vector<Vec3f> corners(3 * claimed);
  for (std::size_t i = 0; i < corners.size(); ++i) {
    std::memcpy(&corners[i], bytes.data() + kHeaderBytes + kTriangleBytes * (i / 3) + 12 + 12 * (i % 3), 12);
  }
  return corners;
}

}  // namespace

CanonicalFile preflightStl(const std::filesystem::path& path, std::string bytes) {
  CanonicalFile file;
  file.extension = "stl";
  file.binary = true;
  MeshReport& report = file.report;
  const bool ascii = isAscii(bytes);
  report.format = ascii ? "STL ascii" : "STL binary";
  const std::vector<Vec3f> corners =
      ascii ? readAscii(bytes, path.string()) : readBinary(bytes, path.string(), report.notes);
  report.sourceFaces = report.sourceTriangles = corners.size() / 3;

  const std::vector<std::uint32_t> ids = distinctPositionIds(corners);
  std::vector<bool> seen;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    if (ids[i] < seen.size()) continue;
    seen.push_back(true);
    if (!isFinite(corners[i])) ++report.nonFiniteVertices;
  }
  report.sourceVertices = seen.size();

  file.bytes.assign(kHeaderBytes, '\0');
  for (std::size_t t = 0; t < corners.size(); t += 3) {
    if (!isFinite(corners[t]) || !isFinite(corners[t + 1]) || !isFinite(corners[t + 2])) {
      ++report.nonFiniteFaces;
    } else if (ids[t] == ids[t + 1] || ids[t + 1] == ids[t + 2] || ids[t + 2] == ids[t]) {
      ++report.zeroAreaTriangles;
    } else {
      char record[kTriangleBytes] = {};
      std::memcpy(record + 12, &corners[t], 36);
      file.bytes.append(record, kTriangleBytes);
      ++file.faces;
      file.corners += 3;
    }
  }
  const auto kept = static_cast<std::uint32_t>(file.faces);
  std::memcpy(file.bytes.data() + 80, &kept, 4);
  return file;
}

}  // namespace shprt
