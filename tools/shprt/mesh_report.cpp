#include "mesh_report.h"

namespace shprt {

std::vector<std::string> describeMending(const MeshReport& report) {
  std::vector<std::string> lines;
  const auto say = [&lines](std::uint64_t count, const char* one, const char* many, const char* what) {
    if (count > 0) lines.push_back(countOf(count, one, many) + what);
  };
  say(report.nonFiniteVertices, "vertex", "vertices", " with NaN, infinite or unreadable coordinates");
  say(report.nonFiniteFaces, "face", "faces", " left out: they use such a vertex");
  say(report.badIndexFaces, "face", "faces", " left out: an index is out of range or unreadable");
  say(report.shortFaces, "face", "faces", " left out: fewer than 3 corners");
  say(report.zeroAreaTriangles, "triangle", "triangles", " left out: no area");
  say(report.unreferencedVertices, "vertex", "vertices", " left out: no face uses them");
  if (report.normalsFromFile) {
    say(report.generatedNormals, "normal", "normals", " computed: the file's were missing or unusable");
  }
  lines.insert(lines.end(), report.notes.begin(), report.notes.end());
  return lines;
}

void printMesh(const Console& console, const std::string& label, const std::string& path,
               const MeshReport& report) {
  console.field(label, path + ": " + report.format + ", " +
                           countOf(report.sourceVertices, "vertex", "vertices") + ", " +
                           countOf(report.sourceFaces, "face", "faces"));
  console.field("", report.normalsFromFile ? "normals from the file" : "normals computed, angle-weighted");
  for (const std::string& line : describeMending(report)) console.field("", line);
}

std::map<std::string, std::uint64_t> meshCounts(const Mesh& mesh) {
  const MeshReport& report = mesh.report;
  return {{"vertices", mesh.positions.size()},
          {"triangles", mesh.triangles.size()},
          {"sourceVertices", report.sourceVertices},
          {"sourceFaces", report.sourceFaces},
          {"sourceTriangles", report.sourceTriangles},
          {"nonFiniteVertices", report.nonFiniteVertices},
          {"nonFiniteFaces", report.nonFiniteFaces},
          {"badIndexFaces", report.badIndexFaces},
          {"shortFaces", report.shortFaces},
          {"zeroAreaTriangles", report.zeroAreaTriangles},
          {"unreferencedVertices", report.unreferencedVertices},
          {"generatedNormals", report.generatedNormals}};
}

}  // namespace shprt
