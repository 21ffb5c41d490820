// What the curves of a study may cost, and how its seconds are taken.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "shprt/study/study_run.h"
#include "shprt/transfer/prepared_scene.h"

namespace shprt {

struct CurveEffort {
  std::size_t vertices;  // of samples
  int referenceRays;     // per vertex
  int referenceDegree;
  std::uint64_t bakeRays;      // most that a bake of the whole scene may trace
  std::uint64_t bounceRays;    // the same with bounces, of which there are many bakes
  std::vector<int> rays;       // per vertex, whose error is measured; increasing, with 256 among them
  std::vector<double> errors;  // asked for of adaptive bakes; decreasing
  int bounces;                 // most
};
CurveEffort curveEffort(const StudyOptions& options);

// Receivers' distinct (position, normal): each is traced once.
std::uint64_t tracedPoints(const PreparedScene& prepared);

// The least of the seconds that run() returns, called up to three times while that is short.
double bestSeconds(const std::function<double()>& run);

}  // namespace shprt
