#include "shprt/scene/transform.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "shprt/mesh/triangulate.h"

namespace shprt {
namespace {

Vec3d row(const Mat3& a, int i) {
  return {a.m[i][0], a.m[i][1], a.m[i][2]};
}

double largestEntry(const Mat3& a) {
  double largest = 0;
  for (const auto& entries : a.m)
    for (const double entry : entries) largest = std::max(largest, std::abs(entry));
  return largest;
}

Mat3 divided(Mat3 a, double divisor) {
  for (auto& entries : a.m)
    for (double& entry : entries) entry /= divisor;
  return a;
}

// The volume that the rows span, over that of a box with edges of their lengths: 1 when they are orthogonal.
double orthogonality(const Mat3& a) {
  Mat3 unit;
  for (int i = 0; i < 3; ++i) {
    const Vec3d direction = normalize(row(a, i));
    unit.m[i][0] = direction.x, unit.m[i][1] = direction.y, unit.m[i][2] = direction.z;
  }
  return std::abs(determinant(unit));
}

// det(A) times the inverse transpose of A.
Mat3 cofactors(const Mat3& a) {
  Mat3 c;
  for (int i = 0; i < 3; ++i) {
    const Vec3d entries = cross(row(a, (i + 1) % 3), row(a, (i + 2) % 3));
    c.m[i][0] = entries.x, c.m[i][1] = entries.y, c.m[i][2] = entries.z;
  }
  return c;
}

double sine(double degrees) {
  const double turned = std::remainder(degrees, 360);
  if (std::remainder(turned, 90) == 0) return turned == 90 ? 1 : turned == -90 ? -1 : 0;
  return std::sin(turned * (std::numbers::pi / 180));
}

template <typename T>
void keepOnly(const std::vector<std::uint32_t>& kept, std::vector<T>& perVertex) {
  if (perVertex.empty()) return;
  for (std::size_t i = 0; i < kept.size(); ++i) perVertex[i] = perVertex[kept[i]];
  perVertex.resize(kept.size());
}

// Leaves out vertices that no triangle uses; the others keep their order.
void dropUnusedVertices(Mesh& mesh) {
  std::vector<std::uint32_t> numbers(mesh.positions.size());
  for (const Triangle& triangle : mesh.triangles)
    for (const std::uint32_t vertex : triangle) numbers[vertex] = 1;
  std::vector<std::uint32_t> kept;
  for (std::uint32_t vertex = 0; vertex < numbers.size(); ++vertex) {
    if (!numbers[vertex]) continue;
    numbers[vertex] = static_cast<std::uint32_t>(kept.size());
    kept.push_back(vertex);
  }
  for (Triangle& triangle : mesh.triangles)
    for (std::uint32_t& vertex : triangle) vertex = numbers[vertex];
  keepOnly(kept, mesh.positions);
  keepOnly(kept, mesh.normals);
  keepOnly(kept, mesh.textureCoordinates);
  keepOnly(kept, mesh.colours);
  keepOnly(kept, mesh.vertexMaterials);
}

}  // namespace

bool isSingular(const Mat3& linear) {
  constexpr double kFlat = 1e-12;
  const double largest = largestEntry(linear);
  if (!(largest > 0) || !std::isfinite(largest)) return true;
  // Scaling after a rotation shows as orthogonal rows, before it as orthogonal columns.
  return std::max(orthogonality(linear), orthogonality(transpose(linear))) < kFlat;
}

Mat3 rotationAbout(Vec3d axis, double degrees) {
  const auto [x, y, z] = normalize(axis);
  const double s = sine(degrees), c = sine(90 - std::abs(std::remainder(degrees, 360))), d = 1 - c;
  return {{{c + x * x * d, x * y * d - z * s, x * z * d + y * s},
           {y * x * d + z * s, c + y * y * d, y * z * d - x * s},
           {z * x * d - y * s, z * y * d + x * s, c + z * z * d}}};
}

std::uint64_t transformMesh(Mesh& mesh, const Transform& transform) {
  if (transform == Transform{}) return 0;
  assert(!isSingular(transform.linear));
  for (Vec3f& position : mesh.positions)
    position = toFloat(transform.linear * toDouble(position) + transform.translation);
  // Scaled to order one, so that products of three entries stay in range.
  const Mat3 scaled = divided(transform.linear, largestEntry(transform.linear));
  const bool mirrors = determinant(scaled) < 0;
  if (transform.linear != Mat3{}) {
    const Mat3 normalTransform = divided(cofactors(scaled), mirrors ? -1 : 1);
    for (Vec3f& normal : mesh.normals) normal = toFloat(normalize(normalTransform * toDouble(normal)));
  }
  if (mirrors)
    for (Triangle& triangle : mesh.triangles) std::swap(triangle[1], triangle[2]);
  const std::size_t before = mesh.triangles.size();
  std::erase_if(mesh.triangles, [&](const Triangle& triangle) {
    const auto corner = [&](std::size_t i) { return toDouble(mesh.positions[triangle[i]]); };
    const Vec3d a = corner(0), b = corner(1), c = corner(2);
    return isFinite(a) && isFinite(b) && isFinite(c) && areaDirection(a, b, c) == Vec3d{};
  });
  if (mesh.triangles.size() < before) dropUnusedVertices(mesh);
  return before - mesh.triangles.size();
}

}  // namespace shprt
