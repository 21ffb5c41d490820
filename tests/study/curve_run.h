// A study's run over a scene in memory, quick and without a journal on disk, that counts announcements.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "../transfer/test_meshes.h"
#include "shprt/light/project_probe.h"
#include "shprt/study/study_run.h"

namespace shprt::test {

class CurveRun {
 public:
  explicit CurveRun(Scene scene, std::string model = "shadowed")
      : scene_(std::move(scene)),
        prepared_(scene_),
        journal_({}, "test"),
        run{.prepared = prepared_,
            .scene = "test",
            .arguments = "test",
            .light = {},
            .options = {.quick = true, .rays = 64},
            .plan = {},
            .journal = journal_,
            .announce = [this](const std::string& what) { announced.push_back(what); }} {
    run.plan.model = std::move(model);
    run.plan.bounces = 1;
  }

  void lightBy(const LightCoefficients& coefficients) { run.light = StudyLight{"light", {}, coefficients}; }
  void lightBy(const EnvironmentMap& map) {
    run.light = StudyLight{"map", map, projectProbe(map, {.degree = 8}).light};
  }

 private:
  Scene scene_;
  PreparedScene prepared_;
  StudyJournal journal_;

 public:
  StudyRun run;
  std::vector<std::string> announced;
};

// A floor under a ball, some of it in its shadow.
inline Scene ballOverFloor(int cells = 9) {
  Mesh mesh;
  addPatch(mesh, {-2, 0, -2}, {0, 0, 4}, {4, 0, 0}, cells);
  append(mesh, moved(makeIcosphere(1), 0.7, {0.2, 1.0, 0.1}));
  return grey(mesh, 0.5f);
}

inline double figure(const StudySection& section, const std::string& name) {
  for (const auto& [known, number] : section.figures)
    if (known == name) return number;
  ADD_FAILURE() << "no figure " << name;
  return -1;
}

// Radiance 1 + x, y and z of the pixel's direction, by channel.
inline EnvironmentMap slopedMap(EnvironmentLayout layout, int width, int height) {
  EnvironmentMap map;
  map.image = {width, height, {}};
  map.layout = layout;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const PixelFootprint pixel = pixelFootprint(layout, width, height, x, y);
      const Vec3d radiance = Vec3d{1, 1, 1} + pixel.direction;
      map.image.pixels.push_back(pixel.solidAngle > 0 ? toFloat(radiance) : Vec3f{});
    }
  return map;
}

}  // namespace shprt::test
