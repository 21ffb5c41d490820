// Faces of a cube: where each lies in the picture, which way it looks, and the solid angle of its pixels in
// closed form. Based on: OpenEXR environment maps (the cube); the labelled crosses and faces that
// docs/conventions.md names.

#include "shprt/image/cube_layout.h"

#include <cmath>
#include <span>

namespace shprt {
namespace {

// The cell that a face fills, and the directions of its middle, of its right and of its lower side.
struct Face {
  int column, row;
  Vec3d middle, right, down;
};

constexpr Vec3d kX{1, 0, 0}, kY{0, 1, 0}, kZ{0, 0, 1};

constexpr Face kVerticalCross[] = {{1, 0, kY, -kX, kZ},   {0, 1, kX, kZ, -kY},   {1, 1, kZ, -kX, -kY},
                                   {2, 1, -kX, -kZ, -kY}, {1, 2, -kY, -kX, -kZ}, {1, 3, -kZ, -kX, kY}};
constexpr Face kHorizontalCross[] = {{1, 0, kY, -kX, kZ},   {0, 1, kX, kZ, -kY},  {1, 1, kZ, -kX, -kY},
                                     {2, 1, -kX, -kZ, -kY}, {3, 1, -kZ, kX, -kY}, {1, 2, -kY, -kX, -kZ}};
// px is the face to the right of pz.
constexpr Face kStrip[] = {{0, 0, -kX, -kZ, -kY}, {0, 1, kX, kZ, -kY},  {0, 2, kY, -kX, kZ},
                           {0, 3, -kY, -kX, -kZ}, {0, 4, kZ, -kX, -kY}, {0, 5, -kZ, kX, -kY}};
constexpr Face kOpenExrStrip[] = {{0, 0, kX, kZ, -kY}, {0, 1, -kX, -kZ, -kY}, {0, 2, kY, kX, -kZ},
                                  {0, 3, -kY, kX, kZ}, {0, 4, kZ, -kX, -kY},  {0, 5, -kZ, kX, -kY}};

std::span<const Face> facesOf(EnvironmentLayout cube) {
  switch (cube) {
    case EnvironmentLayout::kVerticalCross:
      return kVerticalCross;
    case EnvironmentLayout::kHorizontalCross:
      return kHorizontalCross;
    case EnvironmentLayout::kOpenExrCube:
      return kOpenExrStrip;
    default:
      return kStrip;
  }
}

// Solid angle of the rectangle [0,s] x [0,t] in the plane at distance 1, seen from the origin; odd in s and
// t.
double cornerAngle(double s, double t) {
  return std::atan2(s * t, std::sqrt(s * s + t * t + 1));
}

}  // namespace

bool isCube(EnvironmentLayout layout) {
  return layout != EnvironmentLayout::kLatitudeLongitude && layout != EnvironmentLayout::kAngularMap &&
         layout != EnvironmentLayout::kMirroredBall;
}

CubeCells cubeCells(EnvironmentLayout cube) {
  if (cube == EnvironmentLayout::kVerticalCross) return {3, 4};
  if (cube == EnvironmentLayout::kHorizontalCross) return {4, 3};
  return {1, 6};
}

PixelFootprint cubeFootprint(EnvironmentLayout cube, int width, int height, int x, int y) {
  const auto [columns, rows] = cubeCells(cube);
  const double cellWidth = static_cast<double>(width) / columns,
               cellHeight = static_cast<double>(height) / rows;
  for (const Face& face : facesOf(cube)) {
    const double left = (x - face.column * cellWidth) / cellWidth * 2 - 1,
                 top = (y - face.row * cellHeight) / cellHeight * 2 - 1;
    const double right = left + 2 / cellWidth, bottom = top + 2 / cellHeight;
    const double s = (left + right) / 2, t = (top + bottom) / 2;
    if (std::abs(s) >= 1 || std::abs(t) >= 1) continue;
    const double angle = cornerAngle(right, bottom) - cornerAngle(left, bottom) - cornerAngle(right, top) +
                         cornerAngle(left, top);
    return {normalize(face.middle + face.right * s + face.down * t), angle};
  }
  return {};
}

PixelPosition cubePosition(EnvironmentLayout cube, int width, int height, Vec3d direction) {
  const std::span<const Face> faces = facesOf(cube);
  const auto [columns, rows] = cubeCells(cube);
  const Face* best = &faces[0];
  for (const Face& face : faces) {
    if (dot(face.middle, direction) > dot(best->middle, direction)) best = &face;
  }
  const double depth = dot(best->middle, direction);
  const double s = dot(best->right, direction) / depth, t = dot(best->down, direction) / depth;
  return {(best->column + (s + 1) / 2) * width / columns, (best->row + (t + 1) / 2) * height / rows};
}

}  // namespace shprt
