// The sky as path tracing asks for it, and directions drawn where it is bright.
#pragma once

#include <functional>
#include <vector>

#include "shprt/base/vec.h"

namespace shprt {

// Radiance that arrives from far away. Immutable: from any thread.
class Sky {
 public:
  virtual ~Sky() = default;

  // Linear Rec.709, from a unit direction. Parts may be negative.
  virtual Vec3d radiance(Vec3d direction) const = 0;
  // Maps (u, v) in [0,1)^2 to a unit direction of this density, so that near points stay near.
  virtual Vec3d sample(double u, double v) const = 0;
  // With respect to solid angle. It should be high where radiance is; where it is zero, radiance need not be.
  virtual double density(Vec3d direction) const = 0;
};

// A density over the sphere that is constant in the cells of a latitude-longitude grid around +Y: row r of
// `rows` from +Y to -Y has polar angles from pi r/rows to pi (r+1)/rows, and azimuth begins at -Z and goes
// by +X, as in the pictures of image/environment.h.
class SkySampler {
 public:
  // Density in proportion to the mean of `magnitude` (of a unit direction; finite, not negative) over each
  // cell, taken at 3 x 3 directions in it; a little of it leaks into the cells around it, which may hold the
  // rest of what those directions saw. Uniform where it is zero everywhere. rows, columns >= 1. magnitude is
  // called from many threads.
  SkySampler(int rows, int columns, const std::function<double(Vec3d)>& magnitude);

  Vec3d sample(double u, double v) const;
  double density(Vec3d direction) const;

 private:
  std::size_t cell(std::size_t row, std::size_t column) const { return row * columns_ + column; }

  std::size_t rows_, columns_;
  std::vector<double> heights_;  // cosine of the polar angle where each row begins, and the last ends
  std::vector<double> rowEnds_, cellEnds_;  // cumulated probability of rows, and of cells within their row
  std::vector<double> densities_;           // per cell
};

}  // namespace shprt
