// shprt bake: a scene to its transfer coefficients.
#include <fmt/core.h>

#include <cstdint>
#include <filesystem>
#include <memory>
#include <utility>
#include <vector>

#include "bake_job.h"
#include "bake_options.h"
#include "bake_report.h"
#include "commands.h"
#include "file_kind.h"
#include "shprt/base/error.h"
#include "shprt/base/parallel.h"
#include "shprt/coefficients/asset_file.h"
#include "shprt/coefficients/select_vertices.h"
#include "shprt/transfer/stopwatch.h"

namespace shprt {
namespace {

std::vector<std::uint32_t> verticesWhere(std::size_t count, const auto& wanted) {
  std::vector<std::uint32_t> vertices;
  for (std::uint32_t vertex = 0; vertex < count; ++vertex)
    if (wanted(vertex)) vertices.push_back(vertex);
  return vertices;
}

// The assets to write: one, or one per receiver.
std::vector<std::string> writeAssets(const BakeOptions& options, TransferAsset&& whole, const Scene& scene) {
  const std::vector<SceneObject>& objects = scene.objects;
  const std::vector<std::uint32_t>& vertexObjects = scene.vertexObjects;
  if (!options.perMesh) {
    writeAsset(options.output,
               selectVertices(std::move(whole),
                              verticesWhere(vertexObjects.size(),
                                            [&](std::uint32_t vertex) { return scene.isReceiver(vertex); })),
               options.writing);
    return {options.output};
  }
  std::vector<std::string> files;
  for (std::uint32_t object = 0; object < objects.size(); ++object) {
    if (objects[object].role != Role::kReceiver) continue;
    files.push_back(assetFile(options, objects[object]));
    const auto vertices = verticesWhere(
        vertexObjects.size(), [&](std::uint32_t vertex) { return vertexObjects[vertex] == object; });
    writeAsset(files.back(), selectVertices(whole, vertices), options.writing);
  }
  return files;
}

int runBake(const BakeOptions& options, const CLI::App& parsed) {
  const Stopwatch watch;
  const Console console = makeConsole(options.common, "");
  checkBakeOptions(options, parsed);
  checkInput(options.scene);
  std::vector<std::string> inputs = options.lights;
  inputs.push_back(options.scene);
  checkTargets(options.output, options.common, inputs);
  setThreadCount(options.threads);

  BakeOutcome outcome = runBakeSteps(console, options, inputs);
  TransferAsset asset = makeAsset(options, outcome);
  const AssetMetadata metadata = asset.metadata;
  const std::vector<std::string> files = writeAssets(options, std::move(asset), outcome.scene);
  const double seconds = watch.seconds();
  printOutcome(console, options, outcome, metadata);
  if (options.seconds && seconds > 1.1 * *options.seconds)
    console.note(fmt::format(
        "--time was exceeded, {:.2f} s instead of {:g} s: loading, planning and a first pass are always "
        "made, and the time of others is a prediction; give more, or --rays",
        seconds, *options.seconds));
  for (const std::string& file : files)
    console.field("wrote",
                  fmt::format("{}, {}; {:.2f} s in all", file, formatBytes(fileSize(file)), seconds));
  writeFigures(options.common, figuresOf(options, outcome, metadata, files, seconds));
  return 0;
}

}  // namespace

void addBakeCommand(CLI::App& app, Command& chosen) {
  const auto options = std::make_shared<BakeOptions>();
  CLI::App& sub = *app.add_subcommand(
      "bake", "Bake a scene: how much of the light from each direction every vertex sends on");
  addBakeOptions(sub, *options);
  sub.footer(
      "Examples:\n"
      "  shprt bake bunny.obj -o bunny.prt.exr\n"
      "  shprt bake bunny.obj -o bunny.prt.exr --degree 6 --rays 1024 --albedo 0.7,0.5,0.3\n"
      "  shprt bake room.json -o room.prt.exr --bounces 4 --max-edge auto\n"
      "  shprt bake bunny.obj -o bunny.prt.exr --degree auto --light sky.hdr --error 0.03\n"
      "  shprt bake part.stl -o part.prt.exr --model shadowed --half --compression zip --json figures.json");
  sub.callback([options, &sub, &chosen] { chosen = [options, &sub] { return runBake(*options, sub); }; });
}

}  // namespace shprt
