// OpenMesh's parsers hand vertices and polygons to whatever implements BaseImporter. This one puts them into
// plain arrays, so nothing is duplicated, split or dropped for the sake of a manifold.
//
// Normals and texture coordinates of OBJ corners arrive through the per-vertex calls just before the face
// that uses them; between two faces those calls therefore belong to corners, and elsewhere (PLY, OFF) to
// vertices.

#include "shprt/mesh/openmesh_import.h"

#include <OpenMesh/Core/IO/IOManager.hh>
#include <OpenMesh/Core/IO/MeshIO.hh>
#include <OpenMesh/Core/IO/importer/BaseImporter.hh>
#include <OpenMesh/Core/System/omstream.hh>

#include <algorithm>
#include <exception>
#include <limits>
#include <locale>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "shprt/base/error.h"

namespace shprt {
namespace {

using OpenMesh::EdgeHandle;
using OpenMesh::FaceHandle;
using OpenMesh::HalfedgeHandle;
using OpenMesh::Vec2f;
using OpenMesh::Vec3d;
using OpenMesh::Vec3uc;
using OpenMesh::Vec4f;
using OpenMesh::Vec4uc;
using OpenMesh::VertexHandle;
using OpenMesh::Attributes::StatusInfo;
using OpenMeshVec3f = OpenMesh::Vec3f;

shprt::Vec3f toVec(const OpenMeshVec3f& v) {
  return {v[0], v[1], v[2]};
}
shprt::Vec2f toVec(const Vec2f& v) {
  return {v[0], v[1]};
}

class ArrayImporter final : public OpenMesh::IO::BaseImporter {
 public:
  ArrayImporter(bool attributesBelongToCorners, const CanonicalFile& file)
      : toCorners_(attributesBelongToCorners), cornerCount_(file.corners) {
    // Sizes are known; growing by doubling would hold arrays twice.
    mesh.positions.reserve(file.vertices);
    mesh.faceStarts.reserve(file.faces + 1);
    mesh.corners.reserve(file.corners);
  }

  RawMesh mesh;
  std::vector<shprt::Vec3f> vertexNormals;
  std::vector<shprt::Vec2f> vertexTextureCoordinates;

  VertexHandle add_vertex(const OpenMeshVec3f& point) override {
    mesh.positions.push_back(toVec(point));
    return VertexHandle(static_cast<int>(mesh.positions.size()) - 1);
  }
  VertexHandle add_vertex() override { return add_vertex(OpenMeshVec3f(0, 0, 0)); }
  void set_point(VertexHandle vertex, const OpenMeshVec3f& point) override {
    mesh.positions.at(indexOf(vertex)) = toVec(point);
  }

  FaceHandle add_face(const VHandles& corners) override {
    for (const VertexHandle corner : corners) {
      mesh.corners.push_back(static_cast<std::uint32_t>(indexOf(corner)));
      if (indexOf(corner) >= mesh.positions.size())
        throw std::out_of_range("a face names a vertex that does not exist");
    }
    mesh.faceStarts.push_back(static_cast<std::uint32_t>(mesh.corners.size()));
    if (toCorners_) {
      flush(pendingNormals_, corners.size(), mesh.cornerNormals);
      flush(pendingTexture_, corners.size(), mesh.cornerTextureCoordinates);
    }
    return FaceHandle(static_cast<int>(mesh.faceCount()) - 1);
  }

  void set_normal(VertexHandle vertex, const OpenMeshVec3f& normal) override {
    take(vertex, toVec(normal), pendingNormals_, vertexNormals);
  }
  void set_normal(VertexHandle vertex, const Vec3d& normal) override {
    set_normal(vertex, OpenMeshVec3f(normal));
  }
  void set_texcoord(VertexHandle vertex, const Vec2f& texture) override {
    take(vertex, toVec(texture), pendingTexture_, vertexTextureCoordinates);
  }

  std::size_t n_vertices() const override { return mesh.positions.size(); }
  std::size_t n_faces() const override { return mesh.faceCount(); }
  std::size_t n_edges() const override { return 0; }

  // What a bake has no use for, and colours, which the preflight has read.
  HalfedgeHandle add_edge(VertexHandle, VertexHandle) override { return HalfedgeHandle(); }
  FaceHandle add_face(HalfedgeHandle) override { return FaceHandle(); }
  void add_face_texcoords(FaceHandle, VertexHandle, const std::vector<Vec2f>&) override {}
  void add_face_texcoords(FaceHandle, VertexHandle, const std::vector<OpenMeshVec3f>&) override {}
  void set_face_texindex(FaceHandle, int) override {}
  void set_halfedge(VertexHandle, HalfedgeHandle) override {}
  void set_color(VertexHandle, const Vec3uc&) override {}
  void set_color(VertexHandle, const Vec4uc&) override {}
  void set_color(VertexHandle, const OpenMeshVec3f&) override {}
  void set_color(VertexHandle, const Vec4f&) override {}
  void set_status(VertexHandle, const StatusInfo&) override {}
  void set_next(HalfedgeHandle, HalfedgeHandle) override {}
  void set_face(HalfedgeHandle, FaceHandle) override {}
  void request_face_texcoords2D() override {}
  void set_texcoord(HalfedgeHandle, const Vec2f&) override {}
  void set_texcoord(VertexHandle, const OpenMeshVec3f&) override {}
  void set_texcoord(HalfedgeHandle, const OpenMeshVec3f&) override {}
  void set_status(HalfedgeHandle, const StatusInfo&) override {}
  void set_color(EdgeHandle, const Vec3uc&) override {}
  void set_color(EdgeHandle, const Vec4uc&) override {}
  void set_color(EdgeHandle, const OpenMeshVec3f&) override {}
  void set_color(EdgeHandle, const Vec4f&) override {}
  void set_status(EdgeHandle, const StatusInfo&) override {}
  void set_normal(FaceHandle, const OpenMeshVec3f&) override {}
  void set_normal(FaceHandle, const Vec3d&) override {}
  void set_color(FaceHandle, const Vec3uc&) override {}
  void set_color(FaceHandle, const Vec4uc&) override {}
  void set_color(FaceHandle, const OpenMeshVec3f&) override {}
  void set_color(FaceHandle, const Vec4f&) override {}
  void set_status(FaceHandle, const StatusInfo&) override {}
  void add_texture_information(int, std::string) override {}

 private:
  static std::size_t indexOf(VertexHandle vertex) { return static_cast<std::size_t>(vertex.idx()); }

  template <typename T>
  void take(VertexHandle vertex, const T& value, std::vector<T>& pending, std::vector<T>& perVertex) {
    if (toCorners_) {
      pending.push_back(value);
      return;
    }
    perVertex.resize(std::max(perVertex.size(), indexOf(vertex) + 1));
    perVertex[indexOf(vertex)] = value;
  }

  // Moves what was collected for a face to its corners. The array stays empty until the first face that has
  // any.
  template <typename T>
  void flush(std::vector<T>& pending, std::size_t corners, std::vector<T>& perCorner) {
    if (pending.size() == corners) {
      perCorner.reserve(cornerCount_);
      perCorner.resize(mesh.corners.size() - corners);
      perCorner.insert(perCorner.end(), pending.begin(), pending.end());
    }
    pending.clear();
  }

  bool toCorners_;
  std::size_t cornerCount_;
  std::vector<shprt::Vec3f> pendingNormals_;
  std::vector<shprt::Vec2f> pendingTexture_;
};

template <typename T>
void spreadToCorners(const std::vector<T>& perVertex, const std::vector<std::uint32_t>& corners,
                     std::vector<T>& perCorner) {
  if (perVertex.empty()) return;
  perCorner.reserve(corners.size());
  for (const std::uint32_t corner : corners)
    perCorner.push_back(corner < perVertex.size() ? perVertex[corner] : T{});
}

// OpenMesh parses numbers with streams of its own, which follow the global locale.
class ClassicLocale {
 public:
  ClassicLocale() : previous_(std::locale::global(std::locale::classic())) {}
  ~ClassicLocale() { std::locale::global(previous_); }
  ClassicLocale(const ClassicLocale&) = delete;
  ClassicLocale& operator=(const ClassicLocale&) = delete;

 private:
  std::locale previous_;
};

}  // namespace

RawMesh importWithOpenMesh(const std::string& path, CanonicalFile& file) {
  using OpenMesh::IO::Options;
  // OpenMesh counts vertices in int, the arrays here count corners of polygons and of triangles in 32 bits.
  const std::uint64_t most = std::max(file.corners, 3 * (file.corners - 2 * file.faces));
  if (file.vertices > std::numeric_limits<std::int32_t>::max() ||
      most > std::numeric_limits<std::uint32_t>::max())
    throw Error(path,
                "has " + std::to_string(file.vertices) + " vertices and " + std::to_string(file.corners) +
                    " corners, more than 32-bit indices can name",
                "split the mesh");
  omlog().disable();
  omout().disable();
  omerr().disable();
  Options options = Options::VertexNormal | Options::VertexTexCoord;
  if (file.binary) options += Options::Binary;
  ArrayImporter importer(file.extension == "obj", file);
  bool understood = false;
  try {
    const ClassicLocale classic;
    std::istringstream stream(std::move(file.bytes), std::ios::binary);
    understood = OpenMesh::IO::IOManager().read(stream, file.extension, importer, options);
  } catch (const std::exception& problem) {
    throw Error(path, std::string("OpenMesh failed: ") + problem.what(), "export the mesh again");
  }
  RawMesh mesh = std::move(importer.mesh);
  const bool welded = file.extension == "stl";  // its vertices are not known before OpenMesh welds them
  if (!understood || mesh.faceCount() != file.faces || mesh.corners.size() != file.corners ||
      (!welded && mesh.positions.size() != file.vertices)) {
    throw Error(path,
                "OpenMesh delivered " + std::to_string(mesh.positions.size()) + " vertices and " +
                    std::to_string(mesh.faceCount()) + " faces of " + std::to_string(file.vertices) +
                    " and " + std::to_string(file.faces),
                "export the mesh again");
  }
  const std::size_t own = mesh.positions.size() - file.duplicateOf.size();
  for (std::size_t i = 0; i < file.duplicateOf.size(); ++i)
    mesh.positions[own + i] = mesh.positions[file.duplicateOf[i]];
  const auto copyDuplicates = [&](auto& perVertex) {
    if (perVertex.empty()) return;
    perVertex.resize(mesh.positions.size());
    for (std::size_t i = 0; i < file.duplicateOf.size(); ++i)
      perVertex[own + i] = perVertex[file.duplicateOf[i]];
  };
  copyDuplicates(importer.vertexNormals);
  copyDuplicates(importer.vertexTextureCoordinates);
  spreadToCorners(importer.vertexNormals, mesh.corners, mesh.cornerNormals);
  spreadToCorners(importer.vertexTextureCoordinates, mesh.corners, mesh.cornerTextureCoordinates);
  if (!file.cornerNormals.empty()) mesh.cornerNormals = std::move(file.cornerNormals);
  if (!file.cornerTextureCoordinates.empty())
    mesh.cornerTextureCoordinates = std::move(file.cornerTextureCoordinates);
  mesh.vertexColours = std::move(file.vertexColours);
  copyDuplicates(mesh.vertexColours);
  // Faces after the last one that had any are without.
  if (!mesh.cornerNormals.empty()) mesh.cornerNormals.resize(mesh.corners.size());
  if (!mesh.cornerTextureCoordinates.empty()) mesh.cornerTextureCoordinates.resize(mesh.corners.size());
  return mesh;
}

}  // namespace shprt
