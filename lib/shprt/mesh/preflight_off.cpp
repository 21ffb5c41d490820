// Object File Format, ASCII and binary: counts are checked against what is there, and the canonical file is
// plain ASCII OFF of positions and polygons (comments, counts on the header line and face colours mislead
// OpenMesh). Normals, colours of vertices and texture coordinates are handed over beside it: OpenMesh looks
// at the prefix that announces them only when it opens a file by its name.

#include <bit>
#include <cstring>
#include <optional>
#include <vector>

#include "shprt/base/error.h"
#include "shprt/mesh/preflight.h"
#include "shprt/mesh/text.h"
#include "shprt/mesh/vertex_colours.h"

namespace shprt {
namespace {

struct Header {
  bool texture = false, colour = false, normal = false, binary = false;
};

class OffPreflight {
 public:
  OffPreflight(const std::filesystem::path& path, std::string_view text) : path_(path.string()), text_(text) {
    file_.extension = "off";
  }

  CanonicalFile run() {
    readHeader();
    file_.report.format = header_.binary ? "OFF binary" : "OFF";
    if (header_.binary) {
      readBinary();
    } else {
      readAscii();
    }
    file_.vertices = vertexCount_ + file_.duplicateOf.size();
    for (std::size_t i = 0; i < file_.duplicateOf.size(); ++i) positions_ += "0 0 0\n";
    file_.bytes = "OFF\n";
    appendInteger(file_.bytes, static_cast<long long>(file_.vertices));
    appendInteger(file_.bytes += ' ', static_cast<long long>(file_.faces));
    file_.bytes += " 0\n";
    file_.bytes += positions_;
    file_.bytes += faces_;
    colours_.finish(vertexCount_, std::nullopt, file_);
    if (vertexExtras_) file_.report.notes.push_back("values after coordinates that are no colour ignored");
    if (faceExtras_) file_.report.notes.push_back("values after indices (colours of faces) ignored");
    return std::move(file_);
  }

 private:
  [[noreturn]] void fail(const std::string& problem,
                         const std::string& remedy = "export the mesh again") const {
    throw Error(path_, problem, remedy);
  }

  // The next line that holds anything, without its comment.
  std::string_view nextLine() {
    while (!text_.empty()) {
      std::string_view line = takeLine(text_);
      line = trimBlanks(line.substr(0, line.find('#')));
      if (!line.empty()) return line;
    }
    return {};
  }

  void readHeader() {
    std::string_view line = nextLine();
    const std::size_t mark = line.find("OFF");
    if (mark == std::string_view::npos || mark > 4) fail("does not begin with OFF", "give an OFF file");
    std::string_view prefix = line.substr(0, mark);
    line.remove_prefix(mark + 3);
    const auto take = [&](std::string_view letters) {
      const bool has = prefix.starts_with(letters);
      if (has) prefix.remove_prefix(letters.size());
      return has;
    };
    header_.texture = take("ST");
    header_.colour = take("C");
    header_.normal = take("N");
    if (!prefix.empty())
      fail("has the header '" + shownToken(prefix) + "OFF', which is no mesh in three dimensions");
    std::string_view rest = line;
    if (takeToken(rest) == "BINARY") {
      header_.binary = true;
      return;
    }
    if (trimBlanks(line).empty()) line = nextLine();
    const std::string_view vertices = takeToken(line), faces = takeToken(line);
    readCounts(vertices, faces);
  }

  void readCounts(std::string_view vertices, std::string_view faces) {
    const auto v = parseInteger<std::uint64_t>(vertices), f = parseInteger<std::uint64_t>(faces);
    if (!v || !f) fail("the counts of vertices and faces cannot be read");
    setCounts(*v, *f, 6, 2);
  }

  // Each vertex and face takes at least so many bytes.
  void setCounts(std::uint64_t vertices, std::uint64_t faces, std::uint64_t bytesPerVertex,
                 std::uint64_t bytesPerFace) {
    if (vertices > text_.size() / bytesPerVertex + 1 || faces > text_.size() / bytesPerFace + 1) {
      fail("claims " + countOf(vertices, "vertex", "vertices") + " and " + countOf(faces, "face") +
           ", more than its remaining " + std::to_string(text_.size()) + " bytes can hold");
    }
    vertexCount_ = vertices;
    faceCount_ = faces;
    file_.report.sourceVertices = vertices;
  }

  void addVertex(std::uint64_t index, const std::optional<float>* position,
                 const std::optional<float>* normal) {
    const bool usable = position[0] && position[1] && position[2];
    if (!usable) {
      file_.unusableVertex.resize(vertexCount_, false);
      file_.unusableVertex[index] = true;
      ++file_.report.nonFiniteVertices;
    }
    for (int i = 0; i < 3; ++i) appendFloat(positions_, usable ? *position[i] : 0.0f), positions_ += ' ';
    if (normal) {
      const bool good = normal[0] && normal[1] && normal[2];
      vertexNormals_.push_back(good ? Vec3f{*normal[0], *normal[1], *normal[2]} : Vec3f{});
    }
    positions_ += '\n';
  }

  void addFace(FaceFilter& filter) {
    if (!filter.keep(corners_)) return;
    appendInteger(faces_, static_cast<long long>(corners_.size()));
    for (const std::int64_t corner : corners_) appendInteger(faces_ += ' ', corner);
    faces_ += '\n';
    ++file_.faces;
    for (const std::int64_t corner : corners_) {
      auto vertex = static_cast<std::uint64_t>(corner);
      if (vertex >= vertexCount_) vertex = file_.duplicateOf[vertex - vertexCount_];
      if (header_.normal) file_.cornerNormals.push_back(vertexNormals_[vertex]);
      if (header_.texture) file_.cornerTextureCoordinates.push_back(vertexTexture_[vertex]);
    }
  }

  // Three numbers, or four with alpha, whether the header announces them or not; one is an index into a
  // palette that is not in the file.
  void readColour(std::uint64_t index, std::string_view line) {
    const std::string_view red = takeToken(line), green = takeToken(line), blue = takeToken(line);
    takeToken(line);
    if (!blue.empty() && trimBlanks(line).empty()) {
      colours_.add(index, red, green, blue);
    } else if (!red.empty()) {
      vertexExtras_ = true;
    }
  }

  void readAscii() {
    for (std::uint64_t i = 0; i < vertexCount_; ++i) {
      std::string_view line = nextLine();
      if (line.empty())
        fail("claims " + countOf(vertexCount_, "vertex", "vertices") + ", the file ends after " +
             std::to_string(i));
      std::optional<float> numbers[6];
      const int needed = header_.normal ? 6 : 3;
      for (int k = 0; k < needed; ++k) {
        const std::string_view token = takeToken(line);
        if (token.empty()) fail("vertex " + std::to_string(i) + " has too few numbers");
        numbers[k] = parseFloat(token);
      }
      if (header_.texture) {
        const std::string_view v = takeLastToken(line), u = takeLastToken(line);
        if (u.empty()) fail("vertex " + std::to_string(i) + " has too few numbers");
        const std::optional<float> right = parseFloat(u), up = parseFloat(v);
        vertexTexture_.push_back(right && up ? Vec2f{*right, *up} : Vec2f{});
      }
      readColour(i, line);
      addVertex(i, numbers, header_.normal ? numbers + 3 : nullptr);
    }
    FaceFilter filter(vertexCount_, file_);
    for (std::uint64_t i = 0; i < faceCount_; ++i) {
      std::string_view line = nextLine();
      if (line.empty())
        fail("claims " + countOf(faceCount_, "face") + ", the file ends after " + std::to_string(i));
      const std::string_view first = takeToken(line);
      const auto count = parseInteger<std::uint64_t>(first);
      if (!count)
        fail("face " + std::to_string(i) + " begins with '" + shownToken(first) + "' instead of a count");
      corners_.clear();
      for (std::uint64_t k = 0; k < *count; ++k) {
        const std::string_view token = takeToken(line);
        if (token.empty()) fail("face " + std::to_string(i) + " has fewer indices than it says");
        corners_.push_back(parseInteger<std::int64_t>(token).value_or(-1));
      }
      faceExtras_ = faceExtras_ || !trimBlanks(line).empty();
      addFace(filter);
    }
    std::uint64_t linesLeft = 0;
    while (!nextLine().empty()) ++linesLeft;
    if (linesLeft) file_.report.notes.push_back(countOf(linesLeft, "line") + " after the last face ignored");
  }

  // Binary OFF is written in either byte order, with or without colour counts after each face; the layout
  // that uses up the file exactly is the one.
  void readBinary() {
    if (header_.texture || header_.colour)
      fail("is a binary OFF with colours or texture coordinates", "save it as ASCII OFF or PLY");
    const std::string_view body = text_;
    for (const bool swapped : {false, true})
      for (const bool colourCounts : {false, true}) {
        if (fitsBinary(body, swapped, colourCounts)) return loadBinary(body, swapped, colourCounts);
      }
    fail("is a binary OFF whose size does not fit its counts: truncated, or another variant",
         "save it as ASCII OFF or PLY");
  }

  static std::uint32_t wordAt(std::string_view bytes, std::size_t offset, bool swapped) {
    std::uint32_t word;
    std::memcpy(&word, bytes.data() + offset, 4);
    return swapped ? __builtin_bswap32(word) : word;
  }

  // Calls visit(offset of the first index, count) for each face; false when the bytes do not fit.
  template <typename Visit>
  static bool walkFaces(std::string_view body, std::size_t offset, std::uint64_t faces, bool swapped,
                        bool colourCounts, const Visit& visit) {
    for (std::uint64_t f = 0; f < faces; ++f) {
      if (body.size() - offset < 4) return false;
      const std::uint32_t count = wordAt(body, offset, swapped);
      offset += 4;
      if (count > (body.size() - offset) / 4) return false;
      visit(offset, count);
      offset += 4 * std::size_t{count};
      if (!colourCounts) continue;
      if (body.size() - offset < 4) return false;
      const std::uint32_t colours = wordAt(body, offset, swapped);
      offset += 4;
      if (colours > (body.size() - offset) / 4) return false;
      offset += 4 * std::size_t{colours};
    }
    return offset == body.size();
  }

  std::size_t bytesPerVertex() const { return header_.normal ? 24 : 12; }

  bool fitsBinary(std::string_view body, bool swapped, bool colourCounts) const {
    if (body.size() < 12) return false;
    const std::uint64_t vertices = wordAt(body, 0, swapped), faces = wordAt(body, 4, swapped);
    if (vertices > (body.size() - 12) / bytesPerVertex()) return false;
    return walkFaces(body, 12 + vertices * bytesPerVertex(), faces, swapped, colourCounts,
                     [](std::size_t, std::uint32_t) {});
  }

  void loadBinary(std::string_view body, bool swapped, bool colourCounts) {
    setCounts(wordAt(body, 0, swapped), wordAt(body, 4, swapped), bytesPerVertex(), 4);
    const auto floatAt = [&](std::size_t offset) -> std::optional<float> {
      const float value = std::bit_cast<float>(wordAt(body, offset, swapped));
      return std::isfinite(value) ? std::optional<float>(value) : std::nullopt;
    };
    for (std::uint64_t i = 0; i < vertexCount_; ++i) {
      std::optional<float> numbers[6];
      for (std::size_t k = 0; k < bytesPerVertex() / 4; ++k)
        numbers[k] = floatAt(12 + i * bytesPerVertex() + 4 * k);
      addVertex(i, numbers, header_.normal ? numbers + 3 : nullptr);
    }
    FaceFilter filter(vertexCount_, file_);
    walkFaces(
        body, 12 + vertexCount_ * bytesPerVertex(), faceCount_, swapped, colourCounts,
        [&](std::size_t offset, std::uint32_t count) {
          corners_.clear();
          for (std::uint32_t k = 0; k < count; ++k)
            corners_.push_back(static_cast<std::int32_t>(wordAt(body, offset + 4 * std::size_t{k}, swapped)));
          addFace(filter);
        });
  }

  std::string path_;
  std::string_view text_;
  Header header_;
  CanonicalFile file_;
  std::uint64_t vertexCount_ = 0, faceCount_ = 0;
  std::string positions_, faces_;
  std::vector<Vec3f> vertexNormals_;
  std::vector<Vec2f> vertexTexture_;
  std::vector<std::int64_t> corners_;
  VertexColours colours_;
  bool vertexExtras_ = false, faceExtras_ = false;
};

}  // namespace

CanonicalFile preflightOff(const std::filesystem::path& path, std::string bytes) {
  return OffPreflight(path, bytes).run();
}

}  // namespace shprt
