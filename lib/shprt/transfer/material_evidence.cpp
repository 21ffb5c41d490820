#include "shprt/transfer/material_evidence.h"

#include <algorithm>
#include <cmath>

#include "shprt/transfer/transfer_rows.h"

namespace shprt {
namespace {

double mean(Vec3d colour) {
  return (colour.x + colour.y + colour.z) / 3;
}

double areaOf(const Mesh& mesh, const Triangle& triangle) {
  const Vec3d a = toDouble(mesh.positions[triangle[0]]), b = toDouble(mesh.positions[triangle[1]]),
              c = toDouble(mesh.positions[triangle[2]]);
  return length(cross(b - a, c - a)) / 2;
}

void examineColours(const Scene& scene, MaterialEvidence& evidence) {
  evidence.grey = isGrey(scene);
  double squares = 0, spread = 0;
  for (std::uint32_t v = 0; v < scene.albedo.size(); ++v) {
    const Vec3f albedo = scene.albedo[v];
    const SurfaceMaterial& material = scene.materials[scene.mesh.vertexMaterials[v]];
    evidence.brightest =
        std::max(evidence.brightest,
                 material.texture ? 1.0 : static_cast<double>(std::max({albedo.x, albedo.y, albedo.z})));
    evidence.emits |= material.emission != Vec3f{};
    if (!scene.isReceiver(v)) continue;
    evidence.receiversEmit |= material.emission != Vec3f{};
    const Vec3d a = toDouble(albedo);
    const double grey = mean(a);
    const Vec3d off = a - Vec3d{grey, grey, grey};
    squares += dot(a, a);
    spread += dot(off, off);
  }
  evidence.colourSpread = squares > 0 ? std::sqrt(spread / squares) : 0;
}

}  // namespace

MaterialEvidence examineMaterials(const Scene& scene) {
  MaterialEvidence evidence;
  examineColours(scene, evidence);
  double area = 0, diffuse = 0, glossy = 0, translucent = 0;
  for (std::uint32_t t = 0; t < scene.mesh.triangles.size(); ++t) {
    const Triangle& triangle = scene.mesh.triangles[t];
    if (!scene.isReceiver(triangle[0])) continue;
    const double here = areaOf(scene.mesh, triangle);
    const SurfaceMaterial& material = scene.materialOf(t);
    area += here;
    for (const std::uint32_t corner : triangle) diffuse += here * mean(toDouble(scene.albedo[corner])) / 3;
    if (material.gloss) {
      evidence.glossyArea += here;
      glossy += here * mean(toDouble(material.gloss->reflectance));
    }
    if (material.translucency) {
      evidence.translucentArea += here;
      translucent += here * mean(toDouble(material.translucency->transmittance));
    }
  }
  const auto share = [](double part, double whole) { return whole > 0 ? part / whole : 0; };
  evidence.glossyArea = share(evidence.glossyArea, area);
  evidence.translucentArea = share(evidence.translucentArea, area);
  evidence.glossyShare = share(glossy, glossy + diffuse);
  evidence.translucentShare = share(translucent, translucent + diffuse);
  return evidence;
}

}  // namespace shprt
