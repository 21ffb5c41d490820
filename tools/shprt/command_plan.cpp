// shprt plan: which effects a scene calls for, before it is baked.
#include <fmt/core.h>

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "commands.h"
#include "console.h"
#include "file_kind.h"
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

struct PlanCommandOptions {
  std::string scene;
  std::vector<std::string> lights;
  LoadSceneOptions loading;
  std::optional<EnvironmentLayout> layout;
  PlanOptions plan;
  int threads = 0;
  CommonOptions common;
};

int runPlan(const PlanCommandOptions& options) {
  const Console console = makeConsole(options.common, "");
  checkInput(options.scene);
  std::vector<std::string> inputs = options.lights;
  inputs.push_back(options.scene);
  checkOutput(options.common.jsonFile, inputs);
  setThreadCount(options.threads);

  const Scene scene = loadScene(options.scene, options.loading);
  std::vector<std::filesystem::path> sources = scene.sources;
  const std::vector<LightCoefficients> lights =
      loadPlanLights(console, options.lights, options.layout, sources);
  checkNotInput(options.common.jsonFile, sources);

  const EffectPlan plan = withProgress(
      "planning", options.common.quiet,
      [&](const ProgressCallback& progress) { return planEffects(scene, lights, options.plan, progress); });
  std::string table = formatPlan(plan);
  table.pop_back();  // line() ends it
  console.line(table);
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
  addRays(sub, options->plan.rays);
  addLoadingOptions(sub, options->loading);
  sub.add_flag("--half", options->plan.half, "Plan for 16-bit halves instead of 32-bit floats");
  addLayout(sub, options->layout);
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
