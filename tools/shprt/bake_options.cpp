#include "bake_options.h"

#include <fmt/core.h>

#include <charconv>
#include <cmath>
#include <map>

#include "commands.h"
#include "output.h"
#include "shprt/sh/basis.h"

namespace shprt {
namespace {

constexpr int kMostBounces = 1000;
constexpr double kLeastError = 1e-6;
constexpr int kLeastJudgedRays = 32;  // two for each sixteenth of them

EffectChoice parseEffects(const std::string& text) {
  EffectChoice choice;
  if (text == "auto") return choice;
  choice.automatic = false;
  if (text == "none") return choice;
  if (text == "all") return {false, true, true, true};
  std::size_t begin = 0;
  while (begin <= text.size()) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    const std::string name = text.substr(begin, end - begin);
    if (name != "shadows" && name != "interreflection")
      throw CLI::ValidationError(
          "--effects", "'" + text + "' is not auto, all, none, or a list of shadows, interreflection");
    choice.shadows = true;  // light that bounces is light that was not stopped before
    choice.interreflection = choice.interreflection || name == "interreflection";
    begin = end + 1;
  }
  return choice;
}

EffectChoice effectsOfModel(const std::string& model) {
  if (model == "auto") return {};
  return {false, model != "unshadowed", model == "interreflected", false};
}

AssetCompression compressionOf(const std::string& name) {
  if (name == "zip") return AssetCompression::kZip;
  if (name == "zips") return AssetCompression::kZips;
  if (name == "piz") return AssetCompression::kPiz;
  return AssetCompression::kNone;
}

EdgeLimit parseEdgeLimit(const std::string& text) {
  if (text == "auto") return {};
  double length = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), length);
  if (error != std::errc{} || end != text.data() + text.size() || !(length > 0) || std::isinf(length))
    throw CLI::ValidationError("--max-edge", "'" + text + "' is not auto or a length above 0");
  return {length};
}

}  // namespace

void checkBakeOptions(const BakeOptions& options, const CLI::App& parsed) {
  const auto given = [&](const char* name) { return parsed.get_option(name)->count() > 0; };
  const EffectChoice& effects = options.effects;
  if (!options.degree && options.lights.empty())
    throw UsageError("--degree: auto needs the lights that are meant; name them with --light");
  if (!options.lights.empty() && options.degree)
    throw UsageError(
        "--light: names the lights that --degree auto chooses the degree for; add --degree auto");
  if (!options.degree && !effects.automatic)
    throw UsageError("--degree: auto is a finding of the plan; leave out --model and --effects");
  if (given("--bounces") && !effects.automatic && !effects.interreflection)
    throw UsageError("--bounces: nothing bounces without interreflection");
  if (suffixOf(options.output) != ".exr")
    throw UsageError("--output: an asset is an OpenEXR file; end " + options.output + " in .prt.exr");
  if (options.fit && !effects.automatic && !effects.shadows)
    throw UsageError("--fit: the unshadowed model needs no fit");
  if (options.fit && options.seconds)
    throw UsageError("--time: a fit takes the same rays everywhere; leave out --fit, or give --rays instead");
  if (options.fit && options.choosesRays())
    throw UsageError("--error: a fit takes the same rays everywhere; add --rays N, or leave out --fit");
  if (options.errorPart && options.areRaysGiven && options.rays < kLeastJudgedRays)
    throw UsageError(fmt::format("--error-part: {} do not tell how far they are off; give --rays {} or more",
                                 options.rays == 1 ? "1 ray" : std::to_string(options.rays) + " rays",
                                 kLeastJudgedRays));
  if (options.fit && options.errorPart)
    throw UsageError("--error-part: the errors of a fit are not known; leave out --fit");
}

void addBakeOptions(CLI::App& sub, BakeOptions& options) {
  sub.add_option("SCENE", options.scene, "OBJ, PLY, OFF or STL file, or a scene of several (SCENE.json)")
      ->required();
  sub.add_option("-o,--output", options.output, "Asset to write, NAME.prt.exr")->required()->type_name("OUT");

  CLI::Option* effects =
      sub.add_option_function<std::string>(
             "--effects", [&options](const std::string& text) { options.effects = parseEffects(text); },
             "What to simulate: auto (what shprt plan finds needed) | all | none | a list of shadows, "
             "interreflection")
          ->type_name("LIST")
          ->default_str("auto");
  sub.add_option_function<std::string>(
         "--model", [&options](const std::string& name) { options.effects = effectsOfModel(name); },
         "The same by the model's name: auto | unshadowed | shadowed | interreflected")
      ->check(CLI::IsMember({"auto", "unshadowed", "shadowed", "interreflected"}))
      ->type_name("NAME")
      ->default_str("auto")
      ->excludes(effects);
  addNumber(
      sub, "--error", options.wantedError, kLeastError, 1,
      "Relative RMS error of the transfer to reach: rays, bounces and effects as it takes. With --rays, what "
      "skipped effects and bounces may cost (0.01)");
  CLI::Option* time =
      addNumber(sub, "--time", options.seconds, 0.01, 1e6,
                "Seconds that the command may take: the least error that fits, or --error if that is "
                "reached sooner");
  addIntegerOrAuto(sub, "--degree", options.degree, 0, kMaximumBakeDegree,
                   "Highest spherical-harmonic band; auto: the least that --light calls for");
  sub.add_option("--light", options.lights, "Light that --degree auto is to serve; may be repeated")
      ->type_name("LIGHT");
  addRays(sub, options.rays)->excludes(time)->each([&options](const std::string&) {
    options.areRaysGiven = true;
  });
  sub.add_flag("--error-part", options.errorPart,
               "Store the standard error of every vertex in the asset, for relight --error-bars");
  addIntegerOrAuto(
      sub, "--bounces", options.bounces, 0, kMostBounces,
      "How often light bounces between surfaces; auto: until the rest is below what --error allows bounces");
  sub.add_option_function<std::string>(
         "--max-edge", [&options](const std::string& text) { options.maxEdge = parseEdgeLimit(text); },
         "Subdivide until no edge is longer, in scene units; auto: where vertices cannot carry the shadows")
      ->type_name("LENGTH|auto");
  sub.add_flag("--fit", options.fit,
               "Fit the vertices to samples all over the triangles, for coarse meshes (least squares)");
  addLoadingOptions(sub, options.loading);
  addBytes(
      sub, "--memory", options.hitMemory,
      "Memory for the rays' hits, such as 500M (default: 2G); what does not fit is traced anew for every "
      "bounce");
  sub.add_flag("--per-mesh", options.perMesh, "One asset per receiver, OUT with its name before the suffix");
  addSeed(sub, options.seed);
  addThreads(sub, options.threads);
  sub.add_flag("--half", options.writing.half, "Store 16-bit halves instead of 32-bit floats");
  sub.add_option_function<std::string>(
         "--compression",
         [&options](const std::string& name) { options.writing.compression = compressionOf(name); },
         "How the file is packed: none | zip | zips | piz")
      ->check(CLI::IsMember({"none", "zip", "zips", "piz"}))
      ->type_name("NAME")
      ->default_str("none");
  addCommonOptions(sub, options.common);
}

}  // namespace shprt
