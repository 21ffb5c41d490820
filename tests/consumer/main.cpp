// Bakes one triangle and lights it by a constant sky: the whole library through its public headers.
#include <shprt/base/version.h>
#include <shprt/light/project_probe.h>
#include <shprt/relight/relight.h>
#include <shprt/transfer/bake.h>

#include <cmath>
#include <cstdio>

int main() {
  shprt::Mesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  mesh.normals.assign(3, {0, 0, 1});
  mesh.triangles = {{0, 1, 2}};
  const shprt::Scene scene = shprt::makeScene(mesh, {{1, 1, 1}, {1, 1, 1}, {1, 1, 1}});
  const shprt::Bake bake = shprt::bakeShadowed(scene, {.degree = 2, .rays = 16, .seed = 1});
  const auto radiance = shprt::relight(bake.transfer, shprt::projectConstant({1, 2, 3}, 2));
  std::printf("shprt %s: radiance %g %g %g\n", shprt::kVersion, double(radiance[0].x), double(radiance[0].y),
              double(radiance[0].z));
  return std::abs(radiance[0].z - 3) < 1e-5f ? 0 : 1;
}
