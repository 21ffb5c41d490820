// A scene made ready for rays, once for all who trace it: the plan before a bake and the bake itself.
#pragma once

#include <mutex>
#include <optional>

#include "shprt/scene/occluder_bounds.h"
#include "shprt/scene/ray_caster.h"
#include "shprt/scene/scene.h"
#include "shprt/transfer/front_faces.h"
#include "shprt/transfer/stopwatch.h"
#include "shprt/transfer/surface_topology.h"

namespace shprt {

// Immutable; may be used from many threads at once. The scene must outlive it.
class PreparedScene {
 public:
  // Throws Error when Embree reports a failure.
  explicit PreparedScene(const Scene& scene);
  PreparedScene(const PreparedScene&) = delete;
  PreparedScene& operator=(const PreparedScene&) = delete;

 private:
  Stopwatch watch_;  // first: before anything is built

 public:
  const Scene& scene;
  const SurfaceTopology topology;
  const RayCaster caster;
  const OccluderBounds bounds;
  const double buildSeconds;

  // Made when it is first asked for: who traces shadows alone has no use for it.
  const FrontFaces& fronts() const {
    std::call_once(frontsOnce_, [&] { fronts_.emplace(topology); });
    return *fronts_;
  }

 private:
  mutable std::once_flag frontsOnce_;
  mutable std::optional<FrontFaces> fronts_;
};

}  // namespace shprt
