// An orthonormal frame around a unit normal, continuous except at n = -z.
// Based on: Duff et al. 2017, "Building an Orthonormal Basis, Revisited", listing 3.
#pragma once

#include <cmath>

#include "shprt/base/vec.h"

namespace shprt {

struct Frame {
  Vec3d tangent, bitangent, normal;  // right-handed: tangent x bitangent = normal

  // The direction with the given coordinates in this frame.
  Vec3d toWorld(Vec3d local) const { return tangent * local.x + bitangent * local.y + normal * local.z; }
};

// normal must be of unit length.
inline Frame frameFromNormal(Vec3d normal) {
  const double sign = std::copysign(1.0, normal.z);
  const double a = -1.0 / (sign + normal.z);
  const double b = normal.x * normal.y * a;
  return {{1.0 + sign * normal.x * normal.x * a, sign * b, -sign * normal.x},
          {b, sign + normal.y * normal.y * a, -normal.y},
          normal};
}

}  // namespace shprt
