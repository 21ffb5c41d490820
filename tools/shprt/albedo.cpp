#include "albedo.h"

#include <fmt/core.h>

#include <algorithm>

#include "console.h"

namespace shprt {

AlbedoChoice chooseAlbedo(const Mesh& mesh, const std::optional<Vec3f>& asked) {
  AlbedoChoice choice;
  if (asked) {
    choice.perVertex.assign(mesh.positions.size(), *asked);
    choice.description = fmt::format("{:g} {:g} {:g}, as asked for", asked->x, asked->y, asked->z);
    return choice;
  }
  const Vec3f grey{kDefaultAlbedo, kDefaultAlbedo, kDefaultAlbedo};
  std::uint64_t defaulted = 0;
  choice.perVertex.reserve(mesh.positions.size());
  for (const std::uint32_t index : mesh.vertexMaterials) {
    const Material& material = mesh.materials[index];
    choice.perVertex.push_back(material.hasDiffuse ? material.diffuse : grey);
    defaulted += !material.hasDiffuse;
  }
  const auto given = std::count_if(mesh.materials.begin(), mesh.materials.end(),
                                   [](const Material& m) { return m.hasDiffuse; });
  if (given == 0) {
    choice.description = fmt::format("{:g} grey, the default: no material gives one", kDefaultAlbedo);
  } else {
    choice.description = "from " + countOf(static_cast<std::uint64_t>(given), "material", "materials");
    if (defaulted > 0) {
      choice.description +=
          fmt::format("; {:g} grey for {} without", kDefaultAlbedo, countOf(defaulted, "vertex", "vertices"));
    }
  }
  return choice;
}

}  // namespace shprt
