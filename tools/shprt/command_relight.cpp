// shprt relight: an asset under lights, as a picture, a coloured mesh, or numbers per vertex.
#include <fmt/core.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <memory>

#include "commands.h"
#include "console.h"
#include "file_kind.h"
#include "output.h"
#include "radiance_file.h"
#include "relight_job.h"
#include "relight_pictures.h"
#include "relight_report.h"
#include "shprt/base/error.h"
#include "shprt/base/parallel.h"
#include "shprt/coefficients/asset_file.h"
#include "shprt/mesh/write_ply.h"
#include "shprt/picture/tone_map.h"
#include "shprt/relight/relight.h"
#include "window_option.h"

namespace shprt {
namespace {

using Clock = std::chrono::steady_clock;

constexpr int kMostSamples = 4096, kMostFrames = 9999;

std::optional<RelightFormat> formatNamed(const std::string& name) {
  if (name == "ply") return RelightFormat::kPly;
  if (name == "exr") return RelightFormat::kExr;
  if (name == "png") return RelightFormat::kPng;
  if (name == "csv") return RelightFormat::kCsv;
  if (name == "json") return RelightFormat::kJson;
  return std::nullopt;
}

RelightFormat chooseFormat(const RelightOptions& options) {
  if (options.output == "-") return options.textFormat.value_or(RelightFormat::kCsv);
  const std::string suffix = suffixOf(options.output);
  const std::optional<RelightFormat> format = formatNamed(suffix.empty() ? "" : suffix.substr(1));
  if (options.textFormat) {
    if (format && *format != *options.textFormat)
      throw UsageError("--format: " + options.output + " ends in " + suffix + ", which is another format");
    return *options.textFormat;
  }
  if (format) return *format;
  throw UsageError("--output: the suffix of " + options.output +
                   " names no format; end it in .png, .exr, .ply, .csv or "
                   ".json, or give --format");
}

bool isPicture(RelightFormat format) {
  return format == RelightFormat::kExr || format == RelightFormat::kPng;
}

// Options that would have no effect are refused: the user expects one.
void checkUsage(RelightFormat format, const CLI::App& parsed) {
  if (isPicture(format)) return;
  for (const char* name :
       {"--camera", "--size", "--samples", "--background", "--background-color", "--turntable"}) {
    if (parsed.get_option(name)->count() > 0)
      throw UsageError(std::string(name) + ": applies to pictures (.png, .exr) only");
  }
}

// One exposure for all frames, such that the brightest is not burnt out.
float automaticExposure(const RelightOptions& options, const std::vector<Vec3f>& first,
                        const FrameRadiance& radiance) {
  float exposure = autoExposure(first);
  for (int frame = 1; frame < frameCount(options); ++frame) {
    exposure = std::min(exposure, autoExposure(radiance(frame)));
  }
  return exposure;
}

void writeColouredMesh(const RelightOptions& options, const TransferAsset& asset,
                       const std::vector<Vec3f>& radiance, const std::vector<Vec3f>& standardErrors,
                       float exposure) {
  std::vector<std::array<std::uint8_t, 3>> colours;
  colours.reserve(radiance.size());
  for (const Vec3f& value : radiance) colours.push_back(encodeSrgb8(value, exposure));
  writePly(options.output, asset.positions, asset.normals, colours, radiance, asset.triangles,
           standardErrors);
}

void writeResult(const RelightOptions& options, RelightFormat format, const TransferAsset& asset,
                 const std::vector<Vec3f>& first, const std::vector<Vec3f>& standardErrors,
                 const FrameRadiance& radiance, const LightSum& lights, float exposure) {
  switch (format) {
    case RelightFormat::kPly:
      return writeColouredMesh(options, asset, first, standardErrors, exposure);
    case RelightFormat::kCsv:
      return writeText(options.output, formatRadianceCsv(asset, first, standardErrors));
    case RelightFormat::kJson:
      return writeText(options.output, formatRadianceJson(asset, first, standardErrors));
    case RelightFormat::kExr:
    case RelightFormat::kPng:
      return writePictures(options, format, asset, radiance, lights, exposure);
  }
}

int runRelight(const RelightOptions& options, const CLI::App& parsed) {
  const Console console = makeConsole(options.common, options.output);
  const RelightFormat format = chooseFormat(options);
  checkUsage(format, parsed);
  // A misspelt camera is better known before anything is read.
  if (isPicture(format)) chooseCamera(options, std::vector<Vec3f>{{-1, -1, -1}, {1, 1, 1}});
  std::vector<std::string> inputs = options.lights;
  inputs.push_back(options.asset);
  if (options.rotation) inputs.push_back(options.rotation->file);
  const int frames = frameCount(options);
  for (int frame = 0; frame < frames; ++frame) checkOutput(frameFile(options, frame), inputs);
  checkInput(options.asset);
  checkOutput(options.common.jsonFile, inputs);
  for (int frame = 0; frame < frames; ++frame) checkDistinct(frameFile(options, frame), options.common);
  setThreadCount(options.threads);

  const TransferAsset asset = readAsset(options.asset);
  checkLighting(options, parsed, !asset.emission.empty());
  checkErrorBars(options, asset);
  noteCorrection(console, options.rotation);
  console.field("asset",
                fmt::format("{}, {}, degree {}", options.asset,
                            countOf(asset.positions.size(), "vertex", "vertices"), asset.transfer.degree));
  if (!asset.emission.empty())
    console.field("emission", fmt::format("the scene's own, times {:.6g}", options.emission.value_or(1)));
  const LightSum lights = addUpLights(console, options, asset.transfer.degree);
  for (int frame = 0; frame < frames; ++frame) checkNotInput(frameFile(options, frame), lights.sources);
  checkNotInput(options.common.jsonFile, lights.sources);
  backgroundMap(options, lights);

  const double emissionFactor = emissionScale(options);
  const Clock::time_point start = Clock::now();
  // Frames are relit again when they are drawn: cheaper than keeping all of them.
  const FrameRadiance radiance = [&](int frame) {
    std::vector<Vec3f> values = relight(asset, frameLight(options, lights.light, frame), emissionFactor);
    if (!std::all_of(values.begin(), values.end(), [](const Vec3f& value) { return isFinite(value); })) {
      throw Error(options.asset, "radiance under this light is beyond float",
                  "use a dimmer light, --emission or --exposure");
    }
    return values;
  };
  const std::vector<Vec3f> first = radiance(0);
  const double seconds = std::chrono::duration<double>(Clock::now() - start).count();
  console.field("relit", options.lights.empty()
                             ? fmt::format("by the emission alone in {:.4f} s", seconds)
                             : fmt::format("at degree {} in {:.4f} s", lights.light.degree, seconds));

  const std::vector<Vec3f> standardErrors =
      errorBars(console, options, asset, frameLight(options, lights.light, 0));
  const Json standardErrorFigures = describeErrorBars(console, first, standardErrors);

  // Display values need an exposure; with --exposure it is in the light already.
  const bool display = format == RelightFormat::kPng || format == RelightFormat::kPly;
  const bool automatic = display && !options.exposure;
  const float exposure = automatic ? automaticExposure(options, first, radiance) : 1;
  const double exposureValue = automatic ? std::log2(exposure) : options.exposure.value_or(0);
  if (automatic) {
    console.field("exposure", fmt::format("{:+.3f} EV, automatic; --exposure {:.3f} repeats it",
                                          exposureValue, exposureValue));
  } else if (options.exposure) {
    console.field("exposure", fmt::format("{:+.3f} EV", exposureValue));
  }
  const Ringing ringing = measureRinging(first);
  noteRinging(console, options, ringing, display);
  writeResult(options, format, asset, first, standardErrors, radiance, lights, exposure);
  console.field("wrote", options.output == "-" ? "standard output"
                         : !options.turntable
                             ? options.output
                             : frameFile(options, 0) + " ... " + frameFile(options, frames - 1));
  writeFigures(options.common,
               {{"command", "relight"},
                {"asset", options.asset},
                {"lights", options.lights},
                {"output", options.output},
                {"frames", frames},
                {"vertices", asset.positions.size()},
                {"degree", lights.light.degree},
                {"emission", asset.emission.empty() ? Json() : Json(options.emission.value_or(1))},
                {"exposure", exposureValue},
                {"exposureIsAutomatic", automatic},
                {"negativeVertices", ringing.vertices},
                {"deepestNegative", ringing.deepest},
                {"standardError", standardErrorFigures},
                {"secondsToRelight", seconds}});
  return 0;
}

void addPictureOptions(CLI::App& sub, RelightOptions& options) {
  sub.add_option(
         "--camera", options.camera,
         "eye:x,y,z target:x,y,z up:x,y,z fov:degrees (each optional), or orbit:azimuth,elevation[,distance] "
         "around the mesh (default: automatic, orbit:25,20)")
      ->type_name("SPEC");
  addSize(sub, "--size", options.width, options.height, "Picture size in pixels");
  addInteger(sub, "--samples", options.samples, 1, kMostSamples, "Rays per pixel");
  CLI::Option* background =
      sub.add_flag("--background", options.background, "Show the image that gives the light behind the mesh");
  addColour(sub, "--background-color", options.backgroundColour, 0, 1e6,
            "Linear colour behind the mesh, as it is to appear")
      ->excludes(background);
  addInteger(sub, "--turntable", options.turntable, 1, kMostFrames,
             "Write this many pictures NAME_0001.png ... of the light going once round +Y");
}

}  // namespace

void addRelightCommand(CLI::App& app, Command& chosen) {
  const auto options = std::make_shared<RelightOptions>();
  CLI::App& sub = *app.add_subcommand(
      "relight", "Light an asset: radiance per vertex, as a picture, a coloured mesh or a table");
  sub.add_option("ASSET", options->asset, "Asset made by shprt bake")->required();
  sub.add_option("LIGHT", options->lights,
                 "Light files, lists of lights or images; several add up, and with the asset's own emission, "
                 "which may do alone");
  sub.add_option("-o,--output", options->output,
                 "NAME.png | .exr | .ply | .csv | .json; - for text on standard output")
      ->required()
      ->type_name("OUT");
  sub.add_option_function<std::string>(
         "--format", [options](const std::string& name) { options->textFormat = formatNamed(name); },
         "Text for - (default: csv) or a name without a known suffix")
      ->check(CLI::IsMember({"csv", "json"}))
      ->type_name("NAME");
  addRotation(sub, options->rotation);
  addExposure(sub, options->exposure,
              "Multiply all light by 2^EV (default: 0, but for .png and colours of .ply automatic)");
  addNumber(sub, "--emission", options->emission, 0, std::numeric_limits<double>::infinity(),
            "Multiply the light that the scene itself sends out by this (default: 1)");
  sub.add_flag("--error-bars", options->errorBars,
               "Tell the standard error that rays leave in the radiance; .csv, .json and .ply have it per "
               "vertex. Needs an asset with errors (bake --error-part)");
  addLayout(sub, options->light.layout);
  addWindow(sub, options->window);
  addPictureOptions(sub, *options);
  addThreads(sub, options->threads);
  addCommonOptions(sub, options->common);
  sub.footer(
      "Examples:\n"
      "  shprt relight bunny.prt.exr sky.json -o bunny.png\n"
      "  shprt relight bunny.prt.exr sky.hdr -o bunny.png --background --size 1280x720 --camera "
      "orbit:-40,10\n"
      "  shprt relight bunny.prt.exr sky.json lamp.json -o bunny.csv --rotate axis:0,1,0,90\n"
      "  shprt relight bunny.prt.exr sky.json -o spin.png --turntable 36\n"
      "  shprt relight room.prt.exr -o lamps.png --emission 0.5");
  sub.callback([options, &sub, &chosen] { chosen = [options, &sub] { return runRelight(*options, sub); }; });
}

}  // namespace shprt
