// Wavefront OBJ: every line is judged, indices are made absolute and checked, faces get their material's
// number. A corner whose texture coordinate or normal cannot be used is left without, its face stays. Colours
// ("v x y z r g b") are taken here: OpenMesh would read 0 to 255 as 1/255.

#include <array>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "shprt/base/error.h"
#include "shprt/mesh/material_library.h"
#include "shprt/mesh/preflight.h"
#include "shprt/mesh/text.h"
#include "shprt/mesh/vertex_colours.h"

namespace shprt {
namespace {

// One corner "v/vt/vn": indices from 0; kNone where the file gives none, kBad where it gives one that cannot
// be read.
constexpr std::int32_t kNone = -1, kBad = -2;

struct Corner {
  std::int32_t position = kBad, texture = kNone, normal = kNone;
};

class ObjPreflight {
 public:
  explicit ObjPreflight(const std::filesystem::path& path) : path_(path) {
    file_.extension = "obj";
    file_.report.format = "OBJ";
  }

  CanonicalFile run(std::string bytes) {
    std::string_view text = bytes;
    // Address space for the most that can come, of which only what is used becomes memory; growing by
    // doubling would hold large files' records twice.
    for (std::string* part : {&positions_, &textures_, &normals_}) part->reserve(bytes.size() / 2);
    corners_.reserve(bytes.size() / 4);
    const std::size_t size = bytes.size();
    std::string joined;
    while (!text.empty()) {
      std::string_view line = takeLine(text);
      // A backslash at the end of a line continues it; at the end of a comment it is part of a Windows path.
      if (!line.empty() && line.back() == '\\' && !trimBlanks(line).starts_with('#')) {
        joined.assign(line.substr(0, line.size() - 1));
        while (!text.empty()) {
          line = takeLine(text);
          const bool more = !line.empty() && line.back() == '\\';
          joined += ' ';
          joined += more ? line.substr(0, line.size() - 1) : line;
          if (!more) break;
        }
        line = joined;
      }
      readLine(line);
    }
    std::string().swap(bytes);  // assigning an empty string would keep its memory
    writeFaces(size);
    finishReport();
    return std::move(file_);
  }

 private:
  void readLine(std::string_view line) {
    const std::string_view keyword = takeToken(line);
    if (keyword.empty() || keyword.front() == '#') return;
    if (keyword == "v") return readPosition(line);
    if (keyword == "vt") return readTextureCoordinate(line);
    if (keyword == "vn") return readNormal(line);
    if (keyword == "f" || keyword == "fo") return readFace(line);
    if (keyword == "usemtl") return useMaterial(trimBlanks(line));
    if (keyword == "mtllib") return readMaterials(trimBlanks(line));
    if (keyword == "g" || keyword == "o" || keyword == "s") return;  // groups have no meaning for a bake
    ++ignoredLines_[std::string(shownToken(keyword))];
  }

  void readPosition(std::string_view line) {
    std::array<std::string_view, 3> tokens;
    bool usable = true;
    for (std::string_view& token : tokens) {
      token = takeToken(line);
      usable = usable && parseFloat(token).has_value();
    }
    if (usable) {
      positions_ += "v ";
      for (const std::string_view token : tokens) (positions_ += withoutPlus(token)) += ' ';
      positions_ += '\n';
    } else {
      positions_ += "v 0 0 0\n";
      file_.unusableVertex.resize(positionCount_ + 1, false);
      file_.unusableVertex.back() = true;
      ++file_.report.nonFiniteVertices;
    }
    ++positionCount_;
    readColour(line.substr(0, line.find('#')));
  }

  // A fourth number alone is a weight, which only curves use; from six on, the second three are a colour.
  void readColour(std::string_view line) {
    const std::string_view red = takeToken(line), green = takeToken(line), blue = takeToken(line);
    if (!blue.empty()) colours_.add(positionCount_ - 1, red, green, blue);
  }

  void readTextureCoordinate(std::string_view line) {
    const std::string_view first = takeToken(line), second = takeToken(line);
    const std::optional<float> u = parseFloat(first);
    const std::optional<float> v = second.empty() ? std::optional<float>(0.0f) : parseFloat(second);
    usableTexture_.push_back(u && v);
    textures_ += "vt ";
    appendFloat(textures_, u.value_or(0));
    textures_ += ' ';
    appendFloat(textures_, v.value_or(0));
    textures_ += '\n';
  }

  void readNormal(std::string_view line) {
    normals_ += "vn ";
    bool usable = true, zero = true;
    for (int i = 0; i < 3; ++i) {
      const std::optional<float> value = parseFloat(takeToken(line));
      usable = usable && value;
      zero = zero && value.value_or(0) == 0;
      appendFloat(normals_, value.value_or(0));
      normals_ += ' ';
    }
    normals_ += '\n';
    if (!usable || zero) ++unusableNormals_;
    usableNormal_.push_back(usable && !zero);
  }

  void readFace(std::string_view line) {
    for (std::string_view token = takeToken(line); !token.empty() && token.front() != '#';
         token = takeToken(line)) {
      corners_.push_back(readCorner(token));
    }
    faceEnds_.push_back(corners_.size());
    faceMaterials_.push_back(currentMaterial_);
  }

  Corner readCorner(std::string_view token) const {
    Corner corner;
    const std::size_t slash = token.find('/');
    corner.position = readIndex(token.substr(0, slash), positionCount_);
    if (slash == std::string_view::npos) return corner;
    token.remove_prefix(slash + 1);
    const std::size_t second = token.find('/');
    if (second != 0 && !token.empty())
      corner.texture = readIndex(token.substr(0, second), usableTexture_.size());
    if (second == std::string_view::npos || second + 1 == token.size()) return corner;
    corner.normal = readIndex(token.substr(second + 1), usableNormal_.size());
    return corner;
  }

  // Negative indices count back from the latest record.
  static std::int32_t readIndex(std::string_view token, std::uint64_t soFar) {
    const std::optional<std::int32_t> index = parseInteger<std::int32_t>(token);
    if (!index || *index == 0) return kBad;
    if (*index > 0) return *index - 1;
    const std::int64_t fromEnd = static_cast<std::int64_t>(soFar) + *index;
    return fromEnd >= 0 ? static_cast<std::int32_t>(fromEnd) : kBad;
  }

  void useMaterial(std::string_view name) {
    const auto [entry, fresh] =
        materialNumbers_.try_emplace(std::string(name), static_cast<std::uint32_t>(file_.materials.size()));
    if (fresh) {
      file_.materials.emplace_back();
      file_.materials.back().name = entry->first;
    }
    currentMaterial_ = entry->second;
  }

  void readMaterials(std::string_view names) {
    // A name may hold blanks, or the line several names: the whole line is tried first.
    if (readLibrary(names)) return;
    bool any = false;
    std::string_view rest = names;
    for (std::string_view name = takeToken(rest); !name.empty(); name = takeToken(rest))
      any = readLibrary(name) || any;
    if (!any) file_.report.notes.push_back("material file '" + shownToken(names) + "' not found");
  }

  bool readLibrary(std::string_view name) {
    std::string relative(name);
    for (char& c : relative) c = c == '\\' ? '/' : c;
    const std::filesystem::path library = path_.parent_path() / relative;
    std::error_code ignored;
    if (!std::filesystem::is_regular_file(library, ignored)) return false;
    readMaterialLibrary(library, library_, file_.report.notes);
    file_.sources.push_back(library);
    return true;
  }

  // Faces come last in the canonical file, so that forward references are ordinary ones.
  void writeFaces(std::size_t sourceBytes) {
    file_.report.sourceVertices = positionCount_;
    if (!file_.unusableVertex.empty()) file_.unusableVertex.resize(positionCount_, false);
    // Attributes are moved over one after another; vertices that the filter appends come after the faces,
    // which OpenMesh reads in a second pass.
    std::string& out = file_.bytes;
    out.reserve(sourceBytes + sourceBytes / 2);
    for (std::string* part : {&positions_, &textures_, &normals_}) {
      out += *part;
      std::string().swap(*part);
    }
    FaceFilter filter(positionCount_, file_);
    std::vector<std::int64_t> indices;
    std::size_t begin = 0;
    for (std::size_t face = 0; face < faceEnds_.size(); ++face) {
      const std::size_t end = faceEnds_[face];
      indices.clear();
      bool textured = false, withNormals = false;
      for (std::size_t c = begin; c < end; ++c) {
        Corner& corner = corners_[c];
        indices.push_back(corner.position);
        textured = settle(corner.texture, usableTexture_, badTextures_) || textured;
        withNormals = settle(corner.normal, usableNormal_, badNormals_) || withNormals;
      }
      if (filter.keep(indices)) {
        out += 'f';
        for (std::size_t c = begin; c < end; ++c) {
          out += ' ';
          appendInteger(out, indices[c - begin] + 1);
          if (textured || withNormals) out += '/';
          if (textured) appendInteger(out, indexOrNext(corners_[c].texture, usableTexture_));
          if (withNormals) appendInteger(out += '/', indexOrNext(corners_[c].normal, usableNormal_));
        }
        out += '\n';
        file_.faceMaterials.push_back(faceMaterials_[face]);
      }
      begin = end;
    }
    file_.faces = file_.faceMaterials.size();
    file_.vertices = positionCount_ + file_.duplicateOf.size();
    // Appended vertices only need a place of their own; their positions are copied after parsing.
    for (std::size_t i = 0; i < file_.duplicateOf.size(); ++i) out += "v 0 0 0\n";
    // OpenMesh wants all corners of a face with or all without; these stand in where some have none.
    out += "vt 0 0\nvn 0 0 0\n";
    corners_ = std::vector<Corner>();
  }

  // Whether the record that a corner names can be used; when it cannot, it is counted and the corner has
  // none.
  static bool settle(std::int32_t& index, const std::vector<bool>& usable, std::uint64_t& bad) {
    if (index >= 0 && static_cast<std::size_t>(index) < usable.size() &&
        usable[static_cast<std::size_t>(index)])
      return true;
    if (index != kNone) ++bad;
    index = kNone;
    return false;
  }

  // Counted from 1; the stand-in after the last record for a corner that has none.
  static long long indexOrNext(std::int32_t index, const std::vector<bool>& records) {
    return (index == kNone ? static_cast<long long>(records.size()) : index) + 1;
  }

  void finishReport() {
    for (Material& material : file_.materials) {
      const auto found = library_.find(material.name);
      if (found == library_.end()) {
        if (!material.name.empty())
          file_.report.notes.push_back("material '" + shownToken(material.name) + "' is defined nowhere");
        continue;
      }
      material = found->second;
    }
    colours_.finish(positionCount_, std::nullopt, file_);
    if (unusableNormals_) {
      file_.report.notes.push_back(countOf(unusableNormals_, "normal") +
                                   " zero or not finite; computed where faces use them");
    }
    if (badTextures_)
      file_.report.notes.push_back(countOf(badTextures_, "corner") +
                                   " without the texture coordinates they name, which cannot be used");
    if (badNormals_)
      file_.report.notes.push_back(countOf(badNormals_, "corner") +
                                   " without the normals they name, which cannot be used");
    // A file of garbage has no end of keywords.
    constexpr std::size_t kShownKeywords = 20;
    std::size_t shown = 0;
    std::uint64_t others = 0;
    for (const auto& [keyword, count] : ignoredLines_) {
      if (shown++ < kShownKeywords)
        file_.report.notes.push_back(countOf(count, "line") + " '" + keyword + "' ignored");
      else
        others += count;
    }
    if (others) file_.report.notes.push_back(countOf(others, "more unknown line") + " ignored");
  }

  std::filesystem::path path_;
  CanonicalFile file_;
  std::string positions_, textures_, normals_;
  std::uint64_t positionCount_ = 0, unusableNormals_ = 0;
  VertexColours colours_;
  std::vector<bool> usableTexture_, usableNormal_;
  std::vector<Corner> corners_;
  std::vector<std::size_t> faceEnds_;
  std::vector<std::uint32_t> faceMaterials_;
  std::uint32_t currentMaterial_ = kNoMaterial;
  std::map<std::string, std::uint32_t> materialNumbers_;
  MaterialLibrary library_;
  std::map<std::string, std::uint64_t> ignoredLines_;
  std::uint64_t badTextures_ = 0, badNormals_ = 0;
};

}  // namespace

CanonicalFile preflightObj(const std::filesystem::path& path, std::string bytes) {
  return ObjPreflight(path).run(std::move(bytes));
}

}  // namespace shprt
