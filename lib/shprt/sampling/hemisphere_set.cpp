#include "shprt/sampling/hemisphere_set.h"

#include "shprt/sampling/fibonacci_hemisphere.h"
#include "shprt/sampling/jittered_hemisphere.h"
#include "shprt/sampling/random_hemisphere.h"
#include "shprt/sampling/sobol_hemisphere.h"

namespace shprt {

const char* pointSetName(PointSet set) {
  switch (set) {
    case PointSet::kLattice:
      return "lattice";
    case PointSet::kSobol:
      return "sobol";
    case PointSet::kJittered:
      return "jittered";
    case PointSet::kRandom:
      break;
  }
  return "random";
}

std::unique_ptr<HemisphereSet> makeHemisphereSet(PointSet set, int count, int groupSize) {
  switch (set) {
    case PointSet::kLattice:
      return std::make_unique<FibonacciHemisphere>(count, groupSize);
    case PointSet::kSobol:
      return std::make_unique<SobolHemisphere>(count, groupSize);
    case PointSet::kJittered:
      return std::make_unique<JitteredHemisphere>(count, groupSize);
    case PointSet::kRandom:
      break;
  }
  return std::make_unique<RandomHemisphere>(count, groupSize);
}

}  // namespace shprt
