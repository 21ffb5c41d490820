#include "shprt/scene/texture.h"

#include <cassert>
#include <cmath>

namespace shprt {
namespace {

// The two pixels around a position along one axis, and the share of the second.
struct Neighbours {
  int first = 0, second = 0;
  float share = 0;
};

Neighbours neighbours(double coordinate, int size) {
  const double position = (coordinate - std::floor(coordinate)) * size - 0.5;
  const double below = std::floor(position);
  const int first = static_cast<int>(below);
  return {(first + size) % size, (first + 1) % size, static_cast<float>(position - below)};
}

}  // namespace

Vec3f sampleTexture(const Image& image, Vec2f coordinates) {
  assert(image.width > 0 && image.height > 0);
  // A coordinate that is no number has no place in the picture; any will do.
  const double u = std::isfinite(coordinates.x) ? static_cast<double>(coordinates.x) : 0;
  const double v = std::isfinite(coordinates.y) ? static_cast<double>(coordinates.y) : 0;
  const Neighbours x = neighbours(u, image.width), y = neighbours(1 - v, image.height);
  const Vec3f upper = image.at(x.first, y.first) * (1 - x.share) + image.at(x.second, y.first) * x.share;
  const Vec3f lower = image.at(x.first, y.second) * (1 - x.share) + image.at(x.second, y.second) * x.share;
  return upper * (1 - y.share) + lower * y.share;
}

}  // namespace shprt
