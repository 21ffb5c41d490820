// Stanford PLY in its three encodings: the canonical file is little-endian with positions, normals and
// texture coordinates per vertex and one index list per face, in this order. Triangle strips are unrolled,
// colours, and texture coordinates that belong to faces, are handed over beside the file, because OpenMesh's
// PLY parser misreads them.

#include <algorithm>
#include <bit>
#include <cmath>
#include <optional>
#include <set>
#include <vector>

#include "shprt/base/error.h"
#include "shprt/mesh/ply_reader.h"
#include "shprt/mesh/preflight.h"
#include "shprt/mesh/text.h"
#include "shprt/mesh/vertex_colours.h"

namespace shprt {
namespace {

void appendBytes(std::string& bytes, std::uint32_t word) {
  for (int shift = 0; shift < 32; shift += 8) bytes += static_cast<char>(word >> shift & 255);
}
void appendBytes(std::string& bytes, float value) {
  appendBytes(bytes, std::bit_cast<std::uint32_t>(value));
}

class PlyPreflight {
 public:
  PlyPreflight(const std::filesystem::path& path, std::string_view bytes)
      : path_(path.string()), reader_(bytes, path_) {
    file_.extension = "ply";
    file_.binary = true;
    file_.report.format = reader_.ascii() ? "PLY ascii" : "PLY binary";
  }

  CanonicalFile run() {
    std::vector<std::vector<double>> values;
    std::set<std::string> seen;
    for (const PlyElement& element : reader_.elements()) {
      if (!seen.insert(element.name).second)
        throw Error(path_, "has the element '" + element.name + "' twice", "export the mesh again");
      if (element.name == "vertex") {
        prepareVertices(element);
      } else if (element.name == "face" || element.name == "tristrips") {
        prepareFaces(element);
      } else {
        file_.report.notes.push_back("element '" + element.name + "' (" + countOf(element.count, "record") +
                                     ") ignored");
      }
      for (std::uint64_t record = 0; record < element.count; ++record) {
        reader_.readRecord(element, record, values);
        if (element.name == "vertex") addVertex(record, values);
        if (element.name == "face") addFace(values);
        if (element.name == "tristrips") addStrips(values);
      }
    }
    if (reader_.overlongLines())
      file_.report.notes.push_back("values beyond the header on " + countOf(reader_.overlongLines(), "line") +
                                   " ignored");
    if (reader_.bytesLeft())
      file_.report.notes.push_back(countOf(reader_.bytesLeft(), "byte") + " after the last record ignored");
    if (!haveVertices_) throw Error(path_, "has no element 'vertex'", "give a mesh");
    write();
    return std::move(file_);
  }

 private:
  void prepareVertices(const PlyElement& element) {
    haveVertices_ = true;
    vertexCount_ = element.count;
    const auto locate = [&](std::initializer_list<const char*> names, std::vector<int>& columns) {
      columns.clear();
      for (const char* name : names) columns.push_back(element.find(name));
      for (const int column : columns) {
        if (column < 0 || element.properties[static_cast<std::size_t>(column)].list) columns.clear();
        if (columns.empty()) break;
      }
      return !columns.empty();
    };
    if (!locate({"x", "y", "z"}, position_))
      throw Error(path_, "element 'vertex' has no x, y and z", "give a mesh");
    locate({"nx", "ny", "nz"}, normal_);
    locate({"s", "t"}, texture_) || locate({"u", "v"}, texture_) ||
        locate({"texture_u", "texture_v"}, texture_);
    locate({"red", "green", "blue"}, colour_) ||
        locate({"diffuse_red", "diffuse_green", "diffuse_blue"}, colour_) ||
        locate({"r", "g", "b"}, colour_) || locate({"color_0", "color_1", "color_2"}, colour_);
    if (!colour_.empty())
      colourMaximum_ = maximumOf(element.properties[static_cast<std::size_t>(colour_[0])].type);
    std::vector<int> used = position_;
    used.insert(used.end(), normal_.begin(), normal_.end());
    used.insert(used.end(), texture_.begin(), texture_.end());
    used.insert(used.end(), colour_.begin(), colour_.end());
    noteIgnored(element, used);
  }

  // What full intensity is in a type, as far as the type tells.
  static std::optional<float> maximumOf(PlyType type) {
    if (type == PlyType::kUint8) return 255.0f;
    if (type == PlyType::kUint16) return 65535.0f;
    return {};
  }

  void prepareFaces(const PlyElement& element) {
    list_ = element.find("vertex_indices");
    if (list_ < 0) list_ = element.find("vertex_index");
    if (list_ < 0 || !element.properties[static_cast<std::size_t>(list_)].list) {
      throw Error(path_, "element '" + element.name + "' has no list vertex_indices", "give a mesh");
    }
    faceTexture_ = element.find("texcoord");
    if (faceTexture_ >= 0 && !element.properties[static_cast<std::size_t>(faceTexture_)].list)
      faceTexture_ = -1;
    noteIgnored(element, {list_, faceTexture_});
  }

  void noteIgnored(const PlyElement& element, const std::vector<int>& used) {
    std::string names;
    for (std::size_t i = 0; i < element.properties.size(); ++i) {
      const std::string& name = element.properties[i].name;
      if (std::find(used.begin(), used.end(), static_cast<int>(i)) != used.end()) continue;
      names += (names.empty() ? "" : ", ") + shownToken(name);
    }
    if (!names.empty())
      file_.report.notes.push_back("properties of element '" + element.name + "' ignored: " + names);
  }

  void addVertex(std::uint64_t record, const std::vector<std::vector<double>>& values) {
    const auto append = [&](const std::vector<int>& columns) {
      bool usable = true;
      float numbers[3] = {};
      for (std::size_t i = 0; i < columns.size(); ++i) {
        numbers[i] = static_cast<float>(values[static_cast<std::size_t>(columns[i])][0]);
        usable = usable && std::isfinite(numbers[i]);
      }
      for (std::size_t i = 0; i < columns.size(); ++i) appendBytes(vertices_, usable ? numbers[i] : 0.0f);
      return usable;
    };
    if (!append(position_)) {
      file_.unusableVertex.resize(vertexCount_, false);
      file_.unusableVertex[record] = true;
      ++file_.report.nonFiniteVertices;
    }
    append(normal_);
    append(texture_);
    if (colour_.empty()) return;
    const auto channel = [&](std::size_t i) {
      return static_cast<float>(values[static_cast<std::size_t>(colour_[i])][0]);
    };
    colours_.add(record, {channel(0), channel(1), channel(2)});
  }

  // Faces may come before vertices, so they are kept until all is read.
  void addFace(const std::vector<std::vector<double>>& values) {
    const std::vector<double>& indices = values[static_cast<std::size_t>(list_)];
    for (const double index : indices) corners_.push_back(indexOf(index));
    faceEnds_.push_back(corners_.size());
    if (faceTexture_ < 0) return;
    const std::vector<double>& texture = values[static_cast<std::size_t>(faceTexture_)];
    mismatched_ = mismatched_ || texture.size() != 2 * indices.size();
    perCorner_ = !mismatched_;
    if (!perCorner_) return;
    cornerTexture_.resize(corners_.size());
    Vec2f* const own = cornerTexture_.data() + corners_.size() - indices.size();
    for (std::size_t i = 0; i < indices.size(); ++i) {
      own[i] = {static_cast<float>(texture[2 * i]), static_cast<float>(texture[2 * i + 1])};
      if (!std::isfinite(own[i].x) || !std::isfinite(own[i].y)) own[i] = {};
    }
  }

  // Strips end at -1; every second triangle turns the other way.
  void addStrips(const std::vector<std::vector<double>>& values) {
    std::size_t length = 0;
    std::int64_t before = 0, last = 0;
    for (const double value : values[static_cast<std::size_t>(list_)]) {
      const std::int64_t index = indexOf(value);
      if (index < 0) {
        length = 0;
        continue;
      }
      if (length >= 2) {
        const bool turned = length % 2;
        corners_.insert(corners_.end(), {turned ? last : before, turned ? before : last, index});
        faceEnds_.push_back(corners_.size());
      }
      before = last;
      last = index;
      ++length;
    }
  }

  static std::int64_t indexOf(double value) {
    const bool whole = value == std::floor(value) && std::abs(value) < 9e15;
    return whole ? static_cast<std::int64_t>(value) : -1;
  }

  void write() {
    file_.report.sourceVertices = vertexCount_;
    colours_.finish(vertexCount_, colourMaximum_, file_);
    if (mismatched_)
      file_.report.notes.push_back("texture coordinates of faces do not match their corners; ignored");
    std::string faces;
    cornerTexture_.resize(perCorner_ ? corners_.size() : 0);  // strips have none
    FaceFilter filter(vertexCount_, file_);
    std::vector<std::int64_t> indices;
    std::size_t begin = 0;
    for (const std::size_t end : faceEnds_) {
      indices.assign(corners_.begin() + static_cast<std::ptrdiff_t>(begin),
                     corners_.begin() + static_cast<std::ptrdiff_t>(end));
      if (filter.keep(indices)) {
        appendBytes(faces, static_cast<std::uint32_t>(indices.size()));
        for (const std::int64_t index : indices) appendBytes(faces, static_cast<std::uint32_t>(index));
        if (perCorner_)
          file_.cornerTextureCoordinates.insert(file_.cornerTextureCoordinates.end(),
                                                cornerTexture_.begin() + static_cast<std::ptrdiff_t>(begin),
                                                cornerTexture_.begin() + static_cast<std::ptrdiff_t>(end));
        ++file_.faces;
      }
      begin = end;
    }
    file_.vertices = vertexCount_ + file_.duplicateOf.size();
    const std::size_t floats = 3 + normal_.size() + texture_.size();
    for (std::size_t i = 0; i < floats * file_.duplicateOf.size(); ++i) appendBytes(vertices_, 0.0f);

    std::string& bytes = file_.bytes;
    bytes = "ply\nformat binary_little_endian 1.0\nelement vertex ";
    appendInteger(bytes, static_cast<long long>(file_.vertices));
    bytes += "\nproperty float x\nproperty float y\nproperty float z\n";
    if (!normal_.empty()) bytes += "property float nx\nproperty float ny\nproperty float nz\n";
    if (!texture_.empty()) bytes += "property float u\nproperty float v\n";
    bytes += "element face ";
    appendInteger(bytes, static_cast<long long>(file_.faces));
    bytes += "\nproperty list int int vertex_indices\nend_header\n";
    bytes += vertices_;
    bytes += faces;
  }

  std::string path_;
  PlyReader reader_;
  CanonicalFile file_;
  bool haveVertices_ = false, perCorner_ = false, mismatched_ = false;
  std::uint64_t vertexCount_ = 0;
  std::vector<int> position_, normal_, texture_, colour_;  // columns of the vertex element
  std::optional<float> colourMaximum_;
  VertexColours colours_;
  int list_ = -1, faceTexture_ = -1;
  std::string vertices_;
  std::vector<std::int64_t> corners_;
  std::vector<std::size_t> faceEnds_;
  std::vector<Vec2f> cornerTexture_;
};

}  // namespace

CanonicalFile preflightPly(const std::filesystem::path& path, std::string bytes) {
  return PlyPreflight(path, bytes).run();
}

}  // namespace shprt
