// Where the error of relit radiance comes from, for a study's default settings.
//
// With R the radiance of a bake under the light's coefficients c of the bake's degree, and T truth
// (reference_radiance.h), the error is a chain of differences, each of which one thing causes:
//
//   R(default) - R(all bounces)                  bounces, and other effects that the plan left out
//   R(all bounces) - R(endless rays)             sampling
//   R(endless rays) - T(under c as a sky)        gathering: light that bounces comes from rows that are
//                                                interpolated between vertices
//   T(under c as a sky) - T(under the light)     truncation to the degree
//
// The third line rests on the basis being orthogonal: under a sky without higher bands, a transfer that is
// cut off at the same degree loses nothing, so harmonics drop out of it, as bakes do out of the fourth.
// Endless rays are not needed: bakes are unbiased, so two of them with independent rays tell by their
// difference what sampling does, and the product of their differences from truth has the square of the third
// line as its mean. The differences add up to the whole error exactly; their squares do so only where they
// are uncorrelated, and what is missing is stated.
#pragma once

#include <cstddef>

#include "shprt/study/study_run.h"

namespace shprt {

// RMS over vertices (or over the area of triangles) and channels, relative to that of true radiance. Truth's
// own noise is taken out where it is part of a difference.
struct ErrorBudget {
  double bounces = 0, sampling = 0, gathering = 0, truncation = 0;
  double rounding = 0;  // of coefficients to float, expected: a rounding error is uniform
  double total = 0;     // of the default settings
  double half = 0;      // what storage as half would add, in squares
  double noise = 0;     // of truth: its standard error

  // Inside triangles, where radiance is interpolated between vertices.
  double interpolation =
      0;  // of converged bakes, sampling apart, against truth under the bands of their degree
  double truncationInside = 0, totalInside = 0, noiseInside = 0;

  std::size_t vertices = 0, samples = 0;  // that were compared
  int degree = 0, rays = 0, manyRays = 0;

  // Of the square of the total what squares of the sources leave over; negative where they overlap.
  double unexplained() const;
};

// Traces and bakes, at receivers' vertices spread evenly over the mesh, and at points uniform over the area
// of receivers; those that are buried are left out. run has a light. Announces kErrorBudgetSteps times.
ErrorBudget measureErrorBudget(StudyRun& run);
inline constexpr int kErrorBudgetSteps = 7;
inline constexpr const char* kErrorBudgetTitle = "Where the error comes from";

// As a page shows it: tables, bars, and what follows from them.
StudySection describeErrorBudget(const ErrorBudget& budget);

// The experiment "error-budget": both. Without a light it says what is missing.
StudyExperiment errorBudget();

}  // namespace shprt
