// shprt bake: a mesh to its transfer coefficients.
#include <fmt/core.h>
#include <unistd.h>

#include <chrono>
#include <memory>
#include <optional>
#include <utility>

#include "albedo.h"
#include "commands.h"
#include "console.h"
#include "file_kind.h"
#include "interrupt.h"
#include "mesh_report.h"
#include "options.h"
#include "output.h"
#include "progress_bar.h"
#include "shprt/base/error.h"
#include "shprt/base/file.h"
#include "shprt/base/parallel.h"
#include "shprt/base/version.h"
#include "shprt/coefficients/asset_file.h"
#include "shprt/mesh/load_mesh.h"
#include "shprt/transfer/bake.h"

namespace shprt {
namespace {

using Clock = std::chrono::steady_clock;

constexpr int kMostRays = 65536;

struct BakeOptions {
  std::string mesh, output, model = "shadowed", compression = "none";
  ShadowedOptions shadowed;
  std::optional<Vec3f> albedo;
  std::optional<double> creaseAngle;
  bool half = false;
  int threads = 0;
  CommonOptions common;
};

AssetCompression compressionOf(const std::string& name) {
  if (name == "zip") return AssetCompression::kZip;
  if (name == "zips") return AssetCompression::kZips;
  if (name == "piz") return AssetCompression::kPiz;
  return AssetCompression::kNone;
}

double secondsSince(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

// Linux grants memory it does not have and ends the process when it is used; better to say so first.
void checkMemory(const std::string& path, std::size_t vertices, int degree) {
  const double needed = static_cast<double>(vertices) * 3 * coefficientCount(degree) * sizeof(float);
  const double present =
      static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGESIZE));
  if (needed <= present) return;
  throw Error(path,
              fmt::format("transfer of degree {} for {} vertices takes {}, more than this machine's {}",
                          degree, formatCount(vertices), formatBytes(static_cast<std::uint64_t>(needed)),
                          formatBytes(static_cast<std::uint64_t>(present))),
              "use a lower --degree");
}

Bake bakeModel(const BakeOptions& options, const Scene& scene) {
  if (options.model == "unshadowed") return bakeUnshadowed(scene, options.shadowed.degree);
  ProgressBar bar("baking", options.common.quiet);
  const InterruptGuard guard;
  Bake bake = bakeShadowed(scene, options.shadowed, bar.callback());
  throwIfInterrupted();
  return bake;
}

AssetMetadata describeBake(const BakeOptions& options, const LoadedMesh& loaded, const AlbedoChoice& albedo,
                           const BakeStatistics& statistics, double loadSeconds) {
  AssetMetadata metadata;
  metadata.toolVersion = kVersion;
  metadata.model = options.model;
  if (options.model == "shadowed") {
    metadata.rays = options.shadowed.rays;
    metadata.seed = options.shadowed.seed;
  }
  for (const std::filesystem::path& source : loaded.sources) {
    metadata.sources.push_back({source.string(), sha256OfFile(source)});
  }
  metadata.seconds = {
      {"load", loadSeconds}, {"build", statistics.buildSeconds}, {"trace", statistics.traceSeconds}};
  metadata.counts = meshCounts(loaded.mesh);
  metadata.counts["rays"] = statistics.rays;
  metadata.counts["samplePoints"] = statistics.samplePoints;
  metadata.counts["fullyVisible"] = statistics.fullyVisible;
  metadata.counts["fullyHidden"] = statistics.fullyHidden;
  metadata.notes = describeMending(loaded.mesh.report);
  metadata.notes.push_back("albedo " + albedo.description);
  return metadata;
}

double raysPerSecond(const BakeStatistics& statistics) {
  return statistics.traceSeconds > 0 ? static_cast<double>(statistics.rays) / statistics.traceSeconds : 0;
}

void printSummary(const Console& console, const BakeOptions& options, const MeshReport& report,
                  const std::string& albedo, const TransferAsset& asset, const BakeStatistics& statistics) {
  printMesh(console, "mesh", options.mesh, report);
  console.field("baked", countOf(asset.positions.size(), "vertex", "vertices") + ", " +
                             countOf(asset.triangles.size(), "triangle", "triangles"));
  console.field("albedo", albedo);
  if (options.model == "unshadowed") {
    console.field("model", fmt::format("unshadowed, degree {}", options.shadowed.degree));
    return;
  }
  console.field("model",
                fmt::format("shadowed, degree {}, {} per vertex, seed {}", options.shadowed.degree,
                            countOf(static_cast<std::uint64_t>(options.shadowed.rays), "ray", "rays"),
                            options.shadowed.seed));
  console.field("rays", fmt::format("{} in {:.2f} s, {:.1f} Mrays/s ({:.2f} s more to build, {} in Embree)",
                                    formatCount(statistics.rays), statistics.traceSeconds,
                                    raysPerSecond(statistics) * 1e-6, statistics.buildSeconds,
                                    formatBytes(statistics.embreeBytes)));
  console.field("mean visibility",
                fmt::format("{:.4f}; {} see everything, {} nothing", statistics.meanVisibility,
                            countOf(statistics.fullyVisible, "vertex", "vertices"),
                            formatCount(statistics.fullyHidden)));
}

Json figuresOf(const BakeOptions& options, const TransferAsset& asset, const BakeStatistics& statistics,
               double seconds) {
  Json sources = Json::array();
  for (const SourceFile& source : asset.metadata.sources)
    sources.push_back({{"file", source.file}, {"sha256", source.sha256}});
  return {{"command", "bake"},
          {"version", kVersion},
          {"output", options.output},
          {"outputBytes", fileSize(options.output)},
          {"model", options.model},
          {"degree", asset.transfer.degree},
          {"channels", asset.transfer.channels},
          {"raysPerVertex", asset.metadata.rays},
          {"seed", asset.metadata.seed},
          {"threads", threadCount()},
          {"vertices", asset.positions.size()},
          {"triangles", asset.triangles.size()},
          {"meanVisibility", statistics.meanVisibility},
          {"raysPerSecond", raysPerSecond(statistics)},
          {"embreeBytes", statistics.embreeBytes},
          {"seconds", asset.metadata.seconds},
          {"totalSeconds", seconds},
          {"counts", asset.metadata.counts},
          {"sources", sources},
          {"notes", asset.metadata.notes}};
}

int runBake(const BakeOptions& options) {
  const Clock::time_point start = Clock::now();
  const Console console = makeConsole(options.common, "");
  if (suffixOf(options.output) != ".exr") {
    throw UsageError("--output: an asset is an OpenEXR file; end " + options.output + " in .prt.exr");
  }
  checkInput(options.mesh);
  const std::vector<std::string> inputs = {options.mesh};
  checkTargets(options.output, options.common, inputs);
  setThreadCount(options.threads);

  LoadedMesh loaded = loadMesh(options.mesh, {options.creaseAngle});
  const double loadSeconds = secondsSince(start);
  checkNotInput(options.output, loaded.sources);
  checkNotInput(options.common.jsonFile, loaded.sources);
  checkMemory(options.mesh, loaded.mesh.positions.size(), options.shadowed.degree);
  AlbedoChoice albedo = chooseAlbedo(loaded.mesh, options.albedo);

  Bake bake = bakeModel(options, makeScene(loaded.mesh, albedo.perVertex));

  TransferAsset asset;
  asset.metadata = describeBake(options, loaded, albedo, bake.statistics, loadSeconds);
  asset.transfer = std::move(bake.transfer);
  asset.positions = std::move(loaded.mesh.positions);
  asset.normals = std::move(loaded.mesh.normals);
  asset.albedo = std::move(albedo.perVertex);
  asset.textureCoordinates = std::move(loaded.mesh.textureCoordinates);
  asset.triangles = std::move(loaded.mesh.triangles);
  writeAsset(options.output, asset, {options.half, compressionOf(options.compression)});

  const double seconds = secondsSince(start);
  printSummary(console, options, loaded.mesh.report, albedo.description, asset, bake.statistics);
  console.field("wrote", fmt::format("{}, {}; {:.2f} s in all", options.output,
                                     formatBytes(fileSize(options.output)), seconds));
  writeFigures(options.common, figuresOf(options, asset, bake.statistics, seconds));
  return 0;
}

}  // namespace

void addBakeCommand(CLI::App& app, Command& chosen) {
  const auto options = std::make_shared<BakeOptions>();
  CLI::App& sub = *app.add_subcommand(
      "bake", "Bake a mesh: how much of the light from each direction every vertex sends on");
  sub.add_option("MESH", options->mesh, "OBJ, PLY, OFF or STL file")->required();
  sub.add_option("-o,--output", options->output, "Asset to write, NAME.prt.exr")
      ->required()
      ->type_name("OUT");
  sub.add_option("--model", options->model, "Transport model")
      ->check(CLI::IsMember({"shadowed", "unshadowed"}))
      ->type_name("NAME")
      ->default_str(options->model);
  addDegree(sub, options->shadowed.degree);
  addInteger(sub, "--rays", options->shadowed.rays, 1, kMostRays, "Rays per vertex");
  addColour(sub, "--albedo", options->albedo, 0, 1,
            "Albedo of the whole mesh, one number or r,g,b (default: the materials' Kd, else 0.8)");
  addNumber(sub, "--crease-angle", options->creaseAngle, 0, 180,
            "Compute normals even where the file has some; edges sharper than this many degrees stay hard");
  addSeed(sub, options->shadowed.seed);
  addThreads(sub, options->threads);
  sub.add_flag("--half", options->half, "Store 16-bit halves instead of 32-bit floats");
  sub.add_option("--compression", options->compression, "How the file is packed")
      ->check(CLI::IsMember({"none", "zip", "zips", "piz"}))
      ->type_name("NAME")
      ->default_str(options->compression);
  addCommonOptions(sub, options->common);
  sub.footer(
      "Examples:\n"
      "  shprt bake bunny.obj -o bunny.prt.exr\n"
      "  shprt bake bunny.obj -o bunny.prt.exr --degree 6 --rays 1024 --albedo 0.7,0.5,0.3\n"
      "  shprt bake part.stl -o part.prt.exr --crease-angle 30 --half --compression zip --json figures.json");
  sub.callback([options, &chosen] { chosen = [options] { return runBake(*options); }; });
}

}  // namespace shprt
