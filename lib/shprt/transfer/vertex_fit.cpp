// Conjugate gradients, preconditioned with the diagonal, in double. Rows go through it a few at a time, each
// with its own steps; one that has converged stands still until the others of its group have.

#include "shprt/transfer/vertex_fit.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "shprt/base/parallel.h"
#include "shprt/transfer/fit_equations.h"

namespace shprt {
namespace {

struct Solved {
  int iterations = 0;
  FitLanes residual{};  // squared, in the preconditioner's norm
};

class ConjugateGradients {
 public:
  explicit ConjugateGradients(const FitEquations& equations)
      : equations_(equations),
        inverseDiagonal_(equations.size()),
        residual_(equations.size()),
        direction_(equations.size()),
        image_(equations.size()) {
    for (std::size_t i = 0; i < inverseDiagonal_.size(); ++i) {
      const double diagonal = equations.diagonal()[i];
      inverseDiagonal_[i] = diagonal > 0 ? 1 / diagonal : 0;
    }
  }

  // r . D^-1 r per lane; points that no sample reaches do not count.
  FitLanes squaredNorm(const FitVector& r) const {
    FitLanes sum{};
    for (std::size_t i = 0; i < r.size(); ++i)
      for (std::size_t lane = 0; lane < kFitLanes; ++lane)
        sum[lane] += inverseDiagonal_[i] * r[i][lane] * r[i][lane];
    return sum;
  }

  // Improves x until the squared norm of what is left is at most `target` in every lane.
  Solved solve(const FitVector& rightSide, double target, int maximumIterations, FitVector& x) {
    Solved solved;
    subtractImage(rightSide, x);
    std::fill(direction_.begin(), direction_.end(), FitLanes{});
    FitLanes norm = squaredNorm(residual_), previous{};
    for (; solved.iterations < maximumIterations; ++solved.iterations) {
      if (std::all_of(norm.begin(), norm.end(), [&](double n) { return n <= target; })) break;
      FitLanes turn{}, step{};
      for (std::size_t lane = 0; lane < kFitLanes; ++lane)
        turn[lane] = previous[lane] > 0 ? norm[lane] / previous[lane] : 0;
      for (std::size_t i = 0; i < direction_.size(); ++i)
        for (std::size_t lane = 0; lane < kFitLanes; ++lane)
          direction_[i][lane] = inverseDiagonal_[i] * residual_[i][lane] + turn[lane] * direction_[i][lane];
      equations_.apply(direction_, image_);
      const FitLanes curvature = product(direction_, image_);
      for (std::size_t lane = 0; lane < kFitLanes; ++lane)
        step[lane] = norm[lane] > target && curvature[lane] > 0 ? norm[lane] / curvature[lane] : 0;
      for (std::size_t i = 0; i < x.size(); ++i)
        for (std::size_t lane = 0; lane < kFitLanes; ++lane) {
          x[i][lane] += step[lane] * direction_[i][lane];
          residual_[i][lane] -= step[lane] * image_[i][lane];
        }
      previous = norm;
      norm = squaredNorm(residual_);
    }
    // The recurrence's residual drifts away from the true one by rounding.
    subtractImage(rightSide, x);
    solved.residual = squaredNorm(residual_);
    return solved;
  }

 private:
  void subtractImage(const FitVector& rightSide, const FitVector& x) {
    equations_.apply(x, image_);
    for (std::size_t i = 0; i < x.size(); ++i)
      for (std::size_t lane = 0; lane < kFitLanes; ++lane)
        residual_[i][lane] = rightSide[i][lane] - image_[i][lane];
  }

  static FitLanes product(const FitVector& a, const FitVector& b) {
    FitLanes sum{};
    for (std::size_t i = 0; i < a.size(); ++i)
      for (std::size_t lane = 0; lane < kFitLanes; ++lane) sum[lane] += a[i][lane] * b[i][lane];
    return sum;
  }

  const FitEquations& equations_;
  std::vector<double> inverseDiagonal_;
  FitVector residual_, direction_, image_;
};

// sum_s w_s b_k T_s for `lanes` rows from `firstRow` on; further lanes are zero.
FitVector rightSide(const SurfaceTopology& topology, std::span<const SurfaceSample> samples,
                    const SampleValues& values, std::size_t firstRow, std::size_t lanes) {
  FitVector sums(topology.pointCount());
  for (std::size_t s = 0; s < samples.size(); ++s) {
    const double u = static_cast<double>(samples[s].u), v = static_cast<double>(samples[s].v);
    const double barycentrics[3] = {1 - u - v, u, v};
    for (std::size_t k = 0; k < 3; ++k) {
      FitLanes& sum = sums[topology.pointIds()[topology.triangles()[samples[s].triangle][k]]];
      for (std::size_t lane = 0; lane < lanes; ++lane)
        sum[lane] += samples[s].weight * barycentrics[k] * static_cast<double>(values.at(s)[firstRow + lane]);
    }
  }
  return sums;
}

double sampleDistance(const SurfaceTopology& topology, std::span<const SurfaceSample> samples,
                      const SampleValues& values, std::span<const float> fitted) {
  const std::size_t vertexCount = topology.positions().size();
  double area = 0, squares = 0;
  for (std::size_t s = 0; s < samples.size(); ++s) {
    const auto& [a, b, c] = topology.triangles()[samples[s].triangle];
    const double u = static_cast<double>(samples[s].u), v = static_cast<double>(samples[s].v);
    double square = 0;
    for (std::size_t row = 0; row < values.rows; ++row) {
      const float* column = fitted.data() + row * vertexCount;
      const double interpolated = static_cast<double>(column[a]) * (1 - u - v) +
                                  static_cast<double>(column[b]) * u + static_cast<double>(column[c]) * v;
      const double distance = interpolated - static_cast<double>(values.at(s)[row]);
      square += distance * distance;
    }
    area += samples[s].weight;
    squares += samples[s].weight * square;
  }
  return area > 0 ? std::sqrt(squares / area) : 0;
}

}  // namespace

VertexFit fitToSamples(const SurfaceTopology& topology, std::span<const SurfaceSample> samples,
                       const SampleValues& values, std::span<const float> start, const FitOptions& options) {
  const std::size_t vertexCount = topology.positions().size();
  assert(values.values.size() == samples.size() * values.rows && start.size() == vertexCount * values.rows);
  assert(options.alpha >= 0 && options.tolerance > 0);
  const FitEquations equations(topology, samples, options.alpha);
  const auto reached = [&](std::size_t vertex) {
    return equations.diagonal()[topology.pointIds()[vertex]] > 0;
  };
  VertexFit fit;
  fit.values.assign(start.begin(), start.end());
  for (std::size_t vertex = 0; vertex < vertexCount; ++vertex) fit.fittedVertices += reached(vertex);

  // Rows are measured against the largest: those that are only noise need not be solved to their last digit.
  const std::size_t groups = (values.rows + kFitLanes - 1) / kFitLanes;
  std::vector<FitVector> rightSides(groups);
  std::vector<double> squaredNorms(groups);
  parallelForBlocks(groups, 1, [&](std::size_t group, std::size_t) {
    const std::size_t firstRow = group * kFitLanes;
    rightSides[group] =
        rightSide(topology, samples, values, firstRow, std::min(kFitLanes, values.rows - firstRow));
    const FitLanes norms = ConjugateGradients(equations).squaredNorm(rightSides[group]);
    squaredNorms[group] = *std::max_element(norms.begin(), norms.end());
  });
  const double largest = groups > 0 ? *std::max_element(squaredNorms.begin(), squaredNorms.end()) : 0;
  const double target = options.tolerance * options.tolerance * largest;

  std::vector<Solved> solved(groups);
  parallelForBlocks(groups, 1, [&](std::size_t group, std::size_t) {
    const std::size_t firstRow = group * kFitLanes, lanes = std::min(kFitLanes, values.rows - firstRow);
    FitVector x(equations.size());
    for (std::size_t lane = 0; lane < lanes; ++lane)
      for (std::size_t vertex = 0; vertex < vertexCount; ++vertex)
        x[topology.pointIds()[vertex]][lane] =
            static_cast<double>(start[(firstRow + lane) * vertexCount + vertex]);
    solved[group] =
        ConjugateGradients(equations).solve(rightSides[group], target, options.maximumIterations, x);
    for (std::size_t lane = 0; lane < lanes; ++lane)
      for (std::size_t vertex = 0; vertex < vertexCount; ++vertex)
        if (reached(vertex))
          fit.values[(firstRow + lane) * vertexCount + vertex] =
              static_cast<float>(x[topology.pointIds()[vertex]][lane]);
  });

  double left = 0;
  for (const Solved& group : solved) {
    fit.iterations = std::max(fit.iterations, group.iterations);
    left = std::max(left, *std::max_element(group.residual.begin(), group.residual.end()));
  }
  fit.residual = largest > 0 ? std::sqrt(left / largest) : 0;
  // Rounding may leave the true residual a little above what the recurrence claims.
  fit.converged = fit.residual <= 2 * options.tolerance;
  fit.sampleDistance = sampleDistance(topology, samples, values, fit.values);
  return fit;
}

}  // namespace shprt
