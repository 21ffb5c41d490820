// shprt study: what accuracy costs on a scene, as a page.
#include <fmt/core.h>

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "commands.h"
#include "console.h"
#include "file_kind.h"
#include "light_arguments.h"
#include "options.h"
#include "output.h"
#include "progress_bar.h"
#include "shell_words.h"
#include "shprt/base/file.h"
#include "shprt/base/parallel.h"
#include "shprt/base/version.h"
#include "shprt/scene/load_scene.h"
#include "shprt/sh/basis.h"
#include "shprt/study/run_study.h"
#include "shprt/study/study_facts.h"
#include "shprt/study/study_page.h"
#include "shprt/transfer/effect_plan.h"
#include "study_folder.h"

namespace shprt {
namespace {

struct StudyCommandOptions {
  std::string scene, light, output;
  LoadSceneOptions loading;
  std::optional<EnvironmentLayout> layout;
  StudyOptions study;
  bool restart = false;
  int threads = 0;
  CommonOptions common;
};

// As they go into the command lines that the study recommends.
std::string sceneArguments(const StudyCommandOptions& options) {
  const LoadSceneOptions& loading = options.loading;
  std::string text = quoteForShell(options.scene);
  if (const std::optional<Vec3f>& albedo = loading.albedo) {
    text += albedo->x == albedo->y && albedo->y == albedo->z
                ? fmt::format(" --albedo {}", albedo->x)
                : fmt::format(" --albedo {},{},{}", albedo->x, albedo->y, albedo->z);
  }
  if (loading.twoSided) text += " --two-sided";
  if (loading.creaseAngleDegrees) text += fmt::format(" --crease-angle {}", *loading.creaseAngleDegrees);
  return text;
}

std::string lightArguments(const StudyCommandOptions& options) {
  std::string text = quoteForShell(options.light);
  if (options.layout) text += std::string(" --layout ") + layoutName(*options.layout);
  return text;
}

std::optional<StudyLight> loadStudyLight(const Console& console, const StudyCommandOptions& options,
                                         std::vector<std::filesystem::path>& sources) {
  if (options.light.empty()) return {};
  LoadedLight loaded = loadLight(options.light, {.degree = kMaximumBakeDegree, .layout = options.layout});
  for (const std::string& note : loaded.notes) console.note(options.light + ": " + note);
  if (loaded.sources.empty()) loaded.sources.emplace_back(options.light);
  sources.insert(sources.end(), loaded.sources.begin(), loaded.sources.end());
  return StudyLight{options.light, std::move(loaded.map), std::move(loaded.light), lightArguments(options)};
}

// What measurements depend on: with another of these, all are made anew.
std::string fingerprint(const StudyCommandOptions& options,
                        const std::vector<std::filesystem::path>& sources) {
  std::string text = fmt::format(
      "shprt {}; {}; {} threads; {} {}; quick {} degree {} rays {} error {} seed {}", kVersion,
      processorName(), threadCount(), sceneArguments(options), lightArguments(options), options.study.quick,
      options.study.degree, options.study.rays, options.study.error, options.study.seed);
  for (const std::filesystem::path& source : sources) text += "; " + sha256OfFile(source);
  return text;
}

Study measureStudy(const StudyCommandOptions& options, StudyRun& run) {
  const std::vector<StudyExperiment> experiments = studyExperiments(run);
  const auto steps = static_cast<std::uint64_t>(countSteps(experiments));
  ProgressBar bar("study", options.common.quiet);
  const InterruptGuard guard;
  const ProgressCallback show = bar.callback();
  std::uint64_t begun = 0;
  run.announce = [&](const std::string& what) {
    bar.setLabel(what);
    show({begun++, steps, 0});
  };
  run.progress = [](const ProgressReport&) { throwIfInterrupted(); };
  Study study = runStudy(run, experiments);
  throwIfInterrupted();
  return study;
}

void printStudy(const Console& console, const StudyCommandOptions& options, const Study& study) {
  for (const auto& [label, value] : study.facts)
    if (label == "scene" || label == "light" || label == "model planned") console.field(label, value);
  for (const StudySection& section : study.sections) {
    if (section.id != "pareto") continue;
    if (!section.missing.empty()) console.field("errors", section.missing);
    for (const StudyTable& table : section.tables)
      for (const std::vector<std::string>& row : table.rows) {
        const bool reached = !row.back().empty();
        const std::string missed = options.study.quick ? row[1] + " of what --quick tries" : row[1];
        console.field(row[0], reached ? fmt::format("error {}, bake {}, asset {}, relight {}", row[1], row[2],
                                                    row[3], row[4])
                                      : missed);
        if (reached) console.field("", row.back());
      }
  }
  console.field("wrote", (std::filesystem::path(options.output) / "index.html").string());
}

Json figuresOf(const StudyCommandOptions& options, const Study& study) {
  Json figures = {{"command", "study"}, {"tool", kVersion}, {"scene", options.scene}};
  figures["light"] = options.light.empty() ? Json() : Json(options.light);
  figures["threads"] = threadCount();
  figures["page"] = studyFiles(options.output).front().string();
  const auto numbers = [](const std::vector<std::pair<std::string, double>>& list) {
    Json object = Json::object();
    for (const auto& [name, value] : list) object[name] = value;
    return object;
  };
  figures["facts"] = Json::object();
  for (const auto& [label, value] : study.facts) figures["facts"][label] = value;
  figures["headlines"] = numbers(study.headlines);
  figures["figures"] = Json::object();
  figures["commands"] = Json::array();
  for (const StudySection& section : study.sections) {
    figures["figures"].update(numbers(section.figures));
    for (const StudyTable& table : section.tables)
      for (const std::vector<std::string>& row : table.rows)
        if (row.back().starts_with("shprt "))
          figures["commands"].push_back({{"for", row.front()}, {"command", row.back()}});
  }
  return figures;
}

int runStudyCommand(const StudyCommandOptions& options) {
  const Console console = makeConsole(options.common, "");
  checkInput(options.scene);
  std::vector<std::string> inputs = {options.scene};
  if (!options.light.empty()) {
    checkInput(options.light);
    inputs.push_back(options.light);
  } else if (options.layout) {
    throw UsageError("--layout: there is no LIGHT that it could be for");
  }
  checkStudyFolder(options.output, {inputs.begin(), inputs.end()});
  checkOutput(options.common.jsonFile, inputs);
  for (const std::filesystem::path& file : studyFiles(options.output))
    checkDistinct(file.string(), options.common);
  setThreadCount(options.threads);

  const Scene scene = loadScene(options.scene, options.loading);
  std::vector<std::filesystem::path> sources = scene.sources;
  std::optional<StudyLight> light = loadStudyLight(console, options, sources);
  checkStudyFolder(options.output, sources);
  checkNotInput(options.common.jsonFile, sources);

  const PreparedScene prepared(scene);
  std::vector<LightCoefficients> lights;
  if (light) lights.push_back(light->coefficients);
  const EffectPlan plan =
      withProgress("planning", options.common.quiet, [&](const ProgressCallback& progress) {
        return planEffects(prepared, lights,
                           {.degree = options.study.degree,
                            .rays = options.study.rays,
                            .seed = options.study.seed,
                            .error = options.study.error},
                           progress);
      });
  makeStudyFolder(options.output);
  std::error_code ignored;
  if (options.restart) std::filesystem::remove(studyJournalPath(options.output), ignored);
  StudyJournal journal(studyJournalPath(options.output), fingerprint(options, sources));
  StudyRun run{.prepared = prepared,
               .scene = options.scene,
               .arguments = sceneArguments(options),
               .light = std::move(light),
               .options = options.study,
               .plan = plan,
               .journal = journal,
               .announce = {}};
  Study study;
  try {
    study = measureStudy(options, run);
  } catch (const Interrupted&) {
    console.note("what was measured is kept; the same command goes on from there");
    throw;
  }
  const StudyFiles files = writeStudy(options.output, study);
  if (!files.missing.empty()) console.note(files.missing);
  printStudy(console, options, study);
  writeFigures(options.common, figuresOf(options, study));
  return 0;
}

}  // namespace

void addStudyCommand(CLI::App& app, Command& chosen) {
  const auto options = std::make_shared<StudyCommandOptions>();
  CLI::App& sub = *app.add_subcommand(
      "study",
      "What accuracy costs on a scene in time and bytes: measured, as a page with plots and commands");
  sub.add_option("SCENE", options->scene, "OBJ, PLY, OFF or STL file, or a scene of several (SCENE.json)")
      ->required();
  sub.add_option(
      "LIGHT", options->light,
      "Light file, list of lights or image that errors are judged under; without it, errors are those "
      "of the transfer");
  sub.add_option("-o,--output", options->output,
                 "Folder for the page, index.html, and its figures, study.json")
      ->required()
      ->type_name("FOLDER");
  sub.add_flag("--quick", options->study.quick,
               "Under a minute on a mesh of 35,000 vertices: fewer settings, "
               "coarser references");
  sub.add_flag("--restart", options->restart,
               "Measure all anew, also what an earlier run of this study left");
  addInteger(sub, "--degree", options->study.degree, 0, kMaximumBakeDegree,
             "Of the default settings: highest band");
  addRays(sub, options->study.rays);
  addNumber(sub, "--error", options->study.error, 1e-6, 1,
            "Of the default settings: what skipped effects and bounces may cost");
  addLoadingOptions(sub, options->loading);
  addLayout(sub, options->layout);
  addSeed(sub, options->study.seed);
  addThreads(sub, options->threads);
  addCommonOptions(sub, options->common);
  sub.footer(
      "Examples:\n"
      "  shprt study bunny.obj -o study --quick\n"
      "  shprt study bunny.obj sky.hdr -o study\n"
      "  shprt study room.json sky.hdr -o study --degree 6 --rays 1024 --json figures.json");
  sub.callback([options, &chosen] { chosen = [options] { return runStudyCommand(*options); }; });
}

}  // namespace shprt
