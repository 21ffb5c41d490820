// Placing a mesh in a scene.
#pragma once

#include <cstdint>

#include "shprt/base/vec.h"
#include "shprt/mesh/mesh.h"

namespace shprt {

// p -> linear p + translation, on column vectors, from a mesh file's coordinates to the scene's.
struct Transform {
  Mat3 linear;
  Vec3d translation;

  friend bool operator==(const Transform&, const Transform&) = default;
};

// Whether the linear part squashes space flat, as far as double can tell (to about 1e-12 of its extent), or
// is not finite. Scaling by different factors along axes does not count, be they ever so different.
bool isSingular(const Mat3& linear);

// The rotation by an angle counter-clockwise seen from the tip of the axis, which has a direction; quarter
// turns about coordinate axes are exact.
Mat3 rotationAbout(Vec3d axis, double degrees);

// Moves positions and normals (by the inverse transpose), computed in double and rounded once; the identity
// changes no bit. Mirroring transforms reverse the triangles, so that winding still agrees with normals.
// Triangles that rounding leaves without area are left out, with vertices that only they use; returns how
// many. Positions beyond the range of float become infinite. The transform is not singular.
std::uint64_t transformMesh(Mesh& mesh, const Transform& transform);

}  // namespace shprt
