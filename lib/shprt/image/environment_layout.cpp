// The mapping of each layout. All pictures show the sphere as seen from inside it, not mirrored, with +Y up
// and +Z in the middle; so +X lies to the left (the frame is right-handed). Mirrored balls show what the ball
// reflects: the camera looks along +Z, and the middle of the ball shows -Z, the direction back to it. Based
// on: OpenEXR environment maps (latitude-longitude, cube); Debevec 1998 (angular map, mirrored ball).

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

#include "shprt/base/error.h"
#include "shprt/image/environment.h"

namespace shprt {
namespace {

using std::numbers::pi;

constexpr EnvironmentLayout kLayouts[] = {
    EnvironmentLayout::kLatitudeLongitude, EnvironmentLayout::kAngularMap,
    EnvironmentLayout::kMirroredBall,      EnvironmentLayout::kVerticalCross,
    EnvironmentLayout::kHorizontalCross,   EnvironmentLayout::kCubeFaces,
    EnvironmentLayout::kCubeStrip,         EnvironmentLayout::kOpenExrCube};

// --- cubes
// ------------------------------------------------------------------------------------------------------------

// A face of a cube in a picture: the cell it fills, and the directions of its middle, of its right and of its
// lower side.
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

struct CubeLayout {
  std::span<const Face> faces;
  int columns, rows;
};

CubeLayout cubeLayout(EnvironmentLayout layout) {
  switch (layout) {
    case EnvironmentLayout::kVerticalCross:
      return {kVerticalCross, 3, 4};
    case EnvironmentLayout::kHorizontalCross:
      return {kHorizontalCross, 4, 3};
    case EnvironmentLayout::kOpenExrCube:
      return {kOpenExrStrip, 1, 6};
    default:
      return {kStrip, 1, 6};
  }
}

// Solid angle of the rectangle [0,s] x [0,t] in the plane at distance 1, seen from the origin; odd in s and
// t.
double cornerAngle(double s, double t) {
  return std::atan2(s * t, std::sqrt(s * s + t * t + 1));
}

PixelFootprint cubeFootprint(const CubeLayout& cube, int width, int height, int x, int y) {
  const double cellWidth = static_cast<double>(width) / cube.columns,
               cellHeight = static_cast<double>(height) / cube.rows;
  for (const Face& face : cube.faces) {
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

PixelPosition cubePosition(const CubeLayout& cube, int width, int height, Vec3d direction) {
  const Face* best = &cube.faces[0];
  for (const Face& face : cube.faces) {
    if (dot(face.middle, direction) > dot(best->middle, direction)) best = &face;
  }
  const double depth = dot(best->middle, direction);
  const double s = dot(best->right, direction) / depth, t = dot(best->down, direction) / depth;
  return {(best->column + (s + 1) / 2) * width / cube.columns,
          (best->row + (t + 1) / 2) * height / cube.rows};
}

// --- balls
// ------------------------------------------------------------------------------------------------------------

// Direction at a point of the unit disc; u to the right, v up.
Vec3d ballDirection(bool mirrored, double u, double v) {
  const double r = std::min(std::hypot(u, v), 1.0);
  if (r == 0) return mirrored ? -kZ : kZ;
  const double angle = mirrored ? 2 * std::asin(r) : pi * r;
  const double across = std::sin(angle) / std::hypot(u, v);
  return {-across * u, across * v, (mirrored ? -1 : 1) * std::cos(angle)};
}

// Solid angle per area of the unit disc.
double ballDensity(bool mirrored, double u, double v) {
  if (mirrored) return 4;  // Lambert's equal-area projection
  const double r = std::hypot(u, v);
  return r < 1e-9 ? pi * pi : pi * std::sin(pi * r) / r;
}

// Area of the part of [0,x] x [0,y] inside the unit disc, for x, y >= 0.
double discCorner(double x, double y) {
  x = std::min(x, 1.0), y = std::min(y, 1.0);
  if (x * x + y * y <= 1) return x * y;
  const auto primitive = [](double a) {
    return (a * std::sqrt(std::max(0.0, 1 - a * a)) + std::asin(a)) / 2;
  };
  const double split = std::sqrt(1 - y * y);  // from here on the circle is lower than y
  return split * y + primitive(x) - primitive(split);
}

double discArea(double left, double right, double bottom, double top) {
  const auto signedCorner = [](double x, double y) {
    return std::copysign(1.0, x) * std::copysign(1.0, y) * discCorner(std::abs(x), std::abs(y));
  };
  return signedCorner(right, top) - signedCorner(left, top) - signedCorner(right, bottom) +
         signedCorner(left, bottom);
}

PixelFootprint ballFootprint(bool mirrored, int width, int height, int x, int y) {
  const double left = 2.0 * x / width - 1, right = 2.0 * (x + 1) / width - 1;
  const double top = 1 - 2.0 * y / height, bottom = 1 - 2.0 * (y + 1) / height;
  const double full = (right - left) * (top - bottom);
  const double inside = discArea(left, right, bottom, top);
  if (inside <= 1e-12 * full) return {};
  const double u = (left + right) / 2, v = (top + bottom) / 2;
  // The mean density over the pixel: by Simpson's rule where it lies inside the disc, by midpoints of its
  // part inside elsewhere, whose middle also gives the direction.
  const bool whole = inside >= full * (1 - 1e-12);
  const int steps = whole ? 3 : 16;
  double density = 0, weights = 0, sumU = 0, sumV = 0;
  for (int i = 0; i < steps; ++i)
    for (int j = 0; j < steps; ++j) {
      const double s = whole ? (i - 1) / 2.0 : (i + 0.5) / steps - 0.5,
                   t = whole ? (j - 1) / 2.0 : (j + 0.5) / steps - 0.5;
      const double a = u + s * (right - left), b = v + t * (top - bottom);
      if (!whole && std::hypot(a, b) >= 1) continue;
      const double weight = whole ? (i == 1 ? 4 : 1) * (j == 1 ? 4 : 1) : 1;
      density += weight * ballDensity(mirrored, a, b);
      sumU += weight * a, sumV += weight * b;
      weights += weight;
    }
  // A sliver of the rim that no midpoint hits.
  if (weights == 0)
    return {ballDirection(mirrored, u, v),
            inside * ballDensity(mirrored, u / std::hypot(u, v), v / std::hypot(u, v))};
  if (whole) return {ballDirection(mirrored, u, v), inside * density / weights};
  // Sums over pixel centres miss (h^2/24) times the outward derivative along the rim (Euler and Maclaurin).
  // Partial pixels, half a pixel wide on average, make up for it when they look h/12 further out.
  const double middleU = sumU / weights, middleV = sumV / weights, distance = std::hypot(middleU, middleV);
  const double outward = distance > 0 ? 1 + (right - left) / 12 / distance : 1;
  return {ballDirection(mirrored, outward * middleU, outward * middleV), inside * density / weights};
}

PixelPosition ballPosition(bool mirrored, int width, int height, Vec3d direction) {
  const double forward = mirrored ? -direction.z : direction.z, across = std::hypot(direction.x, direction.y);
  const double angle = std::atan2(across, forward);
  const double r = mirrored ? std::sin(angle / 2) : angle / pi;
  const double u = across > 0 ? -direction.x / across * r : 0, v = across > 0 ? direction.y / across * r : 0;
  return {(u + 1) / 2 * width, (1 - v) / 2 * height};
}

}  // namespace

const char* layoutName(EnvironmentLayout layout) {
  switch (layout) {
    case EnvironmentLayout::kLatitudeLongitude:
      return "latlong";
    case EnvironmentLayout::kAngularMap:
      return "angular";
    case EnvironmentLayout::kMirroredBall:
      return "mirrored-ball";
    case EnvironmentLayout::kVerticalCross:
      return "vertical-cross";
    case EnvironmentLayout::kHorizontalCross:
      return "horizontal-cross";
    case EnvironmentLayout::kCubeFaces:
      return "faces";
    case EnvironmentLayout::kCubeStrip:
      return "strip";
    case EnvironmentLayout::kOpenExrCube:
      return "exr-cube";
  }
  return "";
}

EnvironmentLayout parseLayout(const std::string& name) {
  std::string known;
  for (const EnvironmentLayout layout : kLayouts) {
    if (name == layoutName(layout)) return layout;
    known += std::string(known.empty() ? "" : ", ") + layoutName(layout);
  }
  throw Error("layout '" + name + "'", "is not known", "use one of " + known);
}

PixelFootprint pixelFootprint(EnvironmentLayout layout, int width, int height, int x, int y) {
  switch (layout) {
    case EnvironmentLayout::kLatitudeLongitude: {
      const double top = pi * y / height, bottom = pi * (y + 1) / height;
      const double theta = (top + bottom) / 2, phi = pi * (1 - 2 * (x + 0.5) / width);
      // cos(top) - cos(bottom), without cancellation
      const double band = 2 * std::sin(theta) * std::sin((bottom - top) / 2);
      return {{std::sin(theta) * std::sin(phi), std::cos(theta), std::sin(theta) * std::cos(phi)},
              2 * pi / width * band};
    }
    case EnvironmentLayout::kAngularMap:
      return ballFootprint(false, width, height, x, y);
    case EnvironmentLayout::kMirroredBall:
      return ballFootprint(true, width, height, x, y);
    default:
      return cubeFootprint(cubeLayout(layout), width, height, x, y);
  }
}

PixelPosition pixelPosition(EnvironmentLayout layout, int width, int height, Vec3d direction) {
  switch (layout) {
    case EnvironmentLayout::kLatitudeLongitude: {
      const double theta = std::atan2(std::hypot(direction.x, direction.z), direction.y),
                   phi = std::atan2(direction.x, direction.z);
      return {(1 - phi / pi) / 2 * width, theta / pi * height};
    }
    case EnvironmentLayout::kAngularMap:
      return ballPosition(false, width, height, direction);
    case EnvironmentLayout::kMirroredBall:
      return ballPosition(true, width, height, direction);
    default:
      return cubePosition(cubeLayout(layout), width, height, direction);
  }
}

}  // namespace shprt
