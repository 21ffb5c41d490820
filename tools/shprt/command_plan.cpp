// shprt plan: which effects a scene calls for, before it is baked.
#include <fmt/core.h>

#include <memory>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "commands.h"
#include "console.h"
#include "file_kind.h"
#include "interrupt.h"
#include "light_arguments.h"
#include "options.h"
#include "output.h"
#include "progress_bar.h"
#include "shprt/base/parallel.h"
#include "shprt/base/version.h"
#include "shprt/report/plan_report.h"
#include "shprt/scene/load_scene.h"
#include "shprt/sh/basis.h"
#include "shprt/transfer/effect_plan.h"

namespace shprt {
namespace {

constexpr int kMostRays = 65536;
// Lights are looked at to here, to know what a lower degree leaves out.
constexpr int kLightDegree = 16;

struct PlanCommandOptions {
  std::string scene;
  std::vector<std::string> lights;
  LoadSceneOptions loading;
  LightOptions light{kLightDegree, {}, false, false};
  PlanOptions plan;
  int threads = 0;
  CommonOptions common;
};

EffectPlan makePlan(const PlanCommandOptions& options, const Scene& scene,
                    const std::vector<LightCoefficients>& lights) {
  ProgressBar bar("planning", options.common.quiet);
  const InterruptGuard guard;
  EffectPlan plan = planEffects(scene, lights, options.plan, bar.callback());
  throwIfInterrupted();
  return plan;
}

int runPlan(const PlanCommandOptions& options) {
  const Console console = makeConsole(options.common, "");
  checkInput(options.scene);
  std::vector<std::string> inputs = options.lights;
  inputs.push_back(options.scene);
  checkOutput(options.common.jsonFile, inputs);
  setThreadCount(options.threads);

  const Scene scene = loadScene(options.scene, options.loading);
  checkNotInput(options.common.jsonFile, scene.sources);
  std::vector<LightCoefficients> lights;
  for (const std::string& path : options.lights) {
    LoadedLight light = loadLight(path, options.light);
    checkNotInput(options.common.jsonFile, light.sources);
    for (const std::string& note : light.notes) console.note(path + ": " + note);
    lights.push_back(std::move(light.light));
  }

  const EffectPlan plan = makePlan(options, scene, lights);
  const std::string text = formatPlan(plan);
  for (std::string_view rest = text; !rest.empty();) {
    const std::size_t end = rest.find('\n');
    console.line(rest.substr(0, end));
    rest.remove_prefix(end + 1);
  }
  Json figures = Json::parse(planToJson(plan));
  figures["command"] = "plan";
  figures["tool"] = kVersion;
  figures["scene"] = options.scene;
  figures["lights"] = options.lights;
  figures["threads"] = threadCount();
  writeFigures(options.common, figures);
  return 0;
}

}  // namespace

void addPlanCommand(CLI::App& app, Command& chosen) {
  const auto options = std::make_shared<PlanCommandOptions>();
  CLI::App& sub = *app.add_subcommand(
      "plan", "Which effects a scene calls for, with evidence, and what baking them will take");
  sub.add_option("SCENE", options->scene, "OBJ, PLY, OFF or STL file, or a scene of several (SCENE.json)")
      ->required();
  sub.add_option("LIGHT", options->lights, "Light files, lists of lights or images; several add up");
  addNumber(sub, "--error", options->plan.error, 1e-6, 1,
            "What may be left out, relative to the unshadowed transfer");
  addIntegerOrAuto(sub, "--degree", options->plan.degree, 0, kMaximumBakeDegree,
                   "Highest band of the transfer; auto: the least that the lights call for");
  addInteger(sub, "--rays", options->plan.rays, 1, kMostRays, "Rays per vertex of the bake");
  addColour(sub, "--albedo", options->loading.albedo, 0, 1,
            "Albedo of everything, one number or r,g,b (default: as the materials say, else 0.8)");
  sub.add_flag("--two-sided", options->loading.twoSided, "Plan for both sides of every triangle");
  addNumber(sub, "--crease-angle", options->loading.creaseAngleDegrees, 0, 180,
            "Compute normals even where the file has some; edges sharper than this many degrees stay hard");
  sub.add_flag("--half", options->plan.half, "Plan for 16-bit halves instead of 32-bit floats");
  addLayout(sub, options->light.layout);
  addSeed(sub, options->plan.seed);
  addThreads(sub, options->threads);
  addCommonOptions(sub, options->common);
  sub.footer(
      "Examples:\n"
      "  shprt plan bunny.obj\n"
      "  shprt plan bunny.obj sky.hdr --degree auto --error 0.02\n"
      "  shprt plan bunny.obj --rays 1024 --json plan.json -q");
  sub.callback([options, &chosen] { chosen = [options] { return runPlan(*options); }; });
}

}  // namespace shprt
