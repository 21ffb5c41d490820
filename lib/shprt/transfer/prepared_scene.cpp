#include "shprt/transfer/prepared_scene.h"

namespace shprt {

PreparedScene::PreparedScene(const Scene& prepared)
    : scene(prepared),
      topology(prepared.mesh),
      caster(topology.positions(), topology.triangles()),
      bounds(topology.positions(), topology.triangles()),
      buildSeconds(watch_.seconds()) {}

}  // namespace shprt
