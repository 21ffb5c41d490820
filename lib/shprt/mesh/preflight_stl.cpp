// STL, ASCII and binary: the canonical file is binary, without the triangles that OpenMesh's welding would
// choke on.

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
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

bool isWord(std::string_view token, std::string_view lower) {
  return std::equal(token.begin(), token.end(), lower.begin(), lower.end(),
                    [](unsigned char a, char b) { return std::tolower(a) == b; });
}

// Some exporters begin binary files with "solid" too, so the size decides first.
bool isAscii(std::string_view bytes) {
  std::string_view head = bytes.substr(0, 512);
  head.remove_prefix(std::min(head.size(), head.find_first_not_of(" \t\r\n")));
  if (!isWord(head.substr(0, 5), "solid")) return false;
  if (bytes.size() >= kHeaderBytes &&
      bytes.size() == kHeaderBytes + kTriangleBytes * std::uint64_t{claimedTriangles(bytes)})
    return false;
  return bytes.substr(0, 4096).find('\0') == std::string_view::npos;
}

// Corner positions of all triangles, three by three; an unreadable number is NaN.
std::vector<Vec3f> readAscii(std::string_view text, const std::string& path,
                             std::vector<std::string>& notes) {
  std::vector<Vec3f> corners;
  std::size_t lineNumber = 0;
  const auto fail = [&](const std::string& problem) {
    throw Error(path, "line " + std::to_string(lineNumber) + ": " + problem, "export the mesh again");
  };
  bool inFacet = false, ended = false;
  std::size_t facetStart = 0;
  while (!text.empty()) {
    std::string_view line = takeLine(text);
    ++lineNumber;
    const std::string_view keyword = takeToken(line);
    if (isWord(keyword, "facet")) {
      if (inFacet) fail("a facet begins inside another");
      inFacet = true;
      facetStart = corners.size();
    } else if (isWord(keyword, "endfacet")) {
      if (corners.size() != facetStart + 3) fail("a facet without exactly three vertices");
      inFacet = false;
    } else if (isWord(keyword, "vertex")) {
      if (!inFacet) fail("a vertex outside any facet");
      float xyz[3];
      for (float& coordinate : xyz) coordinate = parseFloat(takeToken(line)).value_or(NAN);
      corners.push_back({xyz[0], xyz[1], xyz[2]});
    } else if (isWord(keyword, "endsolid")) {
      ended = true;
    }
  }
  if (inFacet) throw Error(path, "ends inside a facet", "the file is truncated; export the mesh again");
  if (!ended) notes.push_back("no endsolid; the file may have been cut off after a facet");
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
      ascii ? readAscii(bytes, path.string(), report.notes) : readBinary(bytes, path.string(), report.notes);
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
