// The inside of a spherical bowl: the scene in which every bounce of light is known in closed form.
//
// In a sphere every patch of area A sends the same irradiance to every other. Let the bowl be the share f of
// a unit sphere, albedo rho, under the sky's coefficients c. Its opening has the area (1-f) times the bowl's,
// so the mean over the bowl of the direct transfer is (1-f) U(up), U being the unshadowed transfer of a
// surface that faces the opening; and light that bounced k times adds (1-f) (rho f)^k U(up) everywhere.
#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>

#include "shprt/mesh/mesh.h"
#include "shprt/scene/scene.h"

namespace shprt::test {

// Opening upwards, +Y. Rings of equal area, so vertices are spread evenly.
inline Mesh makeBowl(double fraction, int rings, int sides) {
  Mesh mesh;
  const auto add = [&](double cosine, double phi) {
    const double sine = std::sqrt(std::max(0.0, 1 - cosine * cosine));
    const Vec3d p{sine * std::cos(phi), -cosine, sine * std::sin(phi)};
    mesh.positions.push_back(toFloat(p));
    mesh.normals.push_back(toFloat(-p));
  };
  add(1, 0);
  for (int ring = 1; ring <= rings; ++ring)
    for (int side = 0; side < sides; ++side)
      add(1 - 2 * fraction * ring / rings, 2 * std::numbers::pi * side / sides);
  const auto at = [&](int ring, int side) {
    return ring == 0 ? 0u : static_cast<std::uint32_t>(1 + (ring - 1) * sides + side % sides);
  };
  for (int side = 0; side < sides; ++side) mesh.triangles.push_back({0, at(1, side), at(1, side + 1)});
  for (int ring = 1; ring < rings; ++ring)
    for (int side = 0; side < sides; ++side) {
      mesh.triangles.push_back({at(ring, side), at(ring + 1, side), at(ring + 1, side + 1)});
      mesh.triangles.push_back({at(ring, side), at(ring + 1, side + 1), at(ring, side + 1)});
    }
  return mesh;
}

inline Scene paintedBowl(double fraction, Vec3f albedo, int rings = 24, int sides = 48) {
  const Mesh mesh = makeBowl(fraction, rings, sides);
  return makeScene(mesh, std::vector<Vec3f>(mesh.positions.size(), albedo));
}

}  // namespace shprt::test
