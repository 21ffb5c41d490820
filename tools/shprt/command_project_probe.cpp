// shprt project-probe: an image of the surroundings, or a list of lights, to a light file.
#include <fmt/core.h>

#include <cmath>
#include <memory>
#include <optional>

#include "commands.h"
#include "console.h"
#include "file_kind.h"
#include "light_arguments.h"
#include "light_report.h"
#include "options.h"
#include "output.h"
#include "shprt/base/error.h"
#include "shprt/light/window.h"
#include "shprt/sh/basis.h"
#include "window_option.h"

namespace shprt {
namespace {

struct ProbeOptions {
  std::string input, output;
  LightOptions light;
  Window window = Window::kNone;
  std::optional<RotationArgument> rotation;
  std::optional<double> exposure;
  CommonOptions common;
};

// How the coefficients came about, beyond what they say themselves.
Json makingOf(const ProbeOptions& options, const LoadedLight& loaded, const WindowResult& windowed) {
  Json making;
  if (loaded.projection) {
    const ProbeProjection& projection = *loaded.projection;
    making["layout"] = layoutName(loaded.map->layout);
    making["layoutReason"] = loaded.map->layoutReason;
    making["width"] = loaded.map->image.width;
    making["height"] = loaded.map->image.height;
    making["pixels"] = projection.pixels;
    making["nonFinitePixels"] = projection.nonFinitePixels;
    making["negativePixels"] = projection.negativePixels;
    making["solidAngle"] = projection.solidAngle;
    making["energyMissed"] = projection.energyMissed;
  }
  if (options.rotation) making["rotation"] = options.rotation->matrix.m;
  if (options.exposure) making["exposure"] = *options.exposure;
  making["window"] = windowed.name;
  making["windowStrength"] = windowed.strength;
  if (windowed.minimumIrradiance) making["minimumIrradiance"] = *windowed.minimumIrradiance;
  if (windowed.minimumRadiance) making["minimumRadiance"] = *windowed.minimumRadiance;
  return making;
}

// One of the least values of a WindowResult, and the window that would lift it to zero.
void printLeast(const Console& console, const char* label, std::optional<double> least, const char* window) {
  if (!least)
    return console.field(label, "      none: a colour has no positive average, or the degree is above 32");
  console.field(label, fmt::format("{:>10.3g} of the average{}", *least,
                                   *least < 0 ? fmt::format("; --window {} mends that", window) : ""));
}

void printResult(const Console& console, const ProbeOptions& options, const LoadedLight& loaded,
                 const WindowResult& windowed) {
  console.field("light", options.input);
  if (loaded.map) {
    console.field("", fmt::format("{} x {} pixels", loaded.map->image.width, loaded.map->image.height));
  }
  for (const std::string& note : loaded.notes) console.field("", note);
  const int degree = windowed.light.degree;
  console.field("degree", fmt::format("{}, {} per colour", degree,
                                      countOf(static_cast<std::uint64_t>(windowed.light.coefficients.size()),
                                              "coefficient", "coefficients")));
  if (options.window != Window::kNone) {
    console.field("window", fmt::format("{}, strength {:.3g}", windowed.name, windowed.strength));
  }
  printLight(console, windowed.light);
  if (loaded.projection) {
    const std::array<double, 3>& missed = loaded.projection->energyMissed;
    console.field(
        "energy missed",
        fmt::format("{:>9.2f}% {:>9.2f}% {:>9.2f}%  in higher bands, which diffuse shading hardly sees",
                    100 * missed[0], 100 * missed[1], 100 * missed[2]));
  }
  printLeast(console, "least irradiance", windowed.minimumIrradiance, "auto");
  printLeast(console, "least radiance", windowed.minimumRadiance, "auto-radiance");
}

int runProjectProbe(const ProbeOptions& options) {
  const Console console = makeConsole(options.common, options.output);
  checkInput(options.input);
  std::vector<std::string> inputs = {options.input};
  if (options.rotation) inputs.push_back(options.rotation->file);
  checkTargets(options.output, options.common, inputs);
  noteCorrection(console, options.rotation);
  if (fileKind(options.input) == FileKind::kLight) {
    readLight(options.input);  // says what is wrong with it, if anything is
    throw Error(options.input, "is a light file already", "turn or cut it with shprt convert");
  }
  const LoadedLight loaded = loadLight(options.input, options.light);
  checkNotInput(options.output, loaded.sources);
  checkNotInput(options.common.jsonFile, loaded.sources);
  LightCoefficients light = loaded.light;
  if (options.rotation) light = rotateLight(light, options.rotation->matrix);
  if (options.exposure) light = scaleLight(light, std::exp2(*options.exposure));
  WindowResult windowed = applyWindow(light, options.window);

  Json figures = lightStatisticsJson(windowed.light);
  figures.update(makingOf(options, loaded, windowed));
  windowed.light.statisticsJson = figures.dump();
  if (!options.output.empty()) writeText(options.output, formatLight(windowed.light));
  printResult(console, options, loaded, windowed);
  if (!options.output.empty()) {
    console.field("wrote", options.output == "-" ? "standard output" : options.output);
  }
  Json report = {{"command", "project-probe"},
                 {"input", options.input},
                 {"output", options.output},
                 {"degree", windowed.light.degree}};
  report.update(figures);
  report["notes"] = loaded.notes;
  writeFigures(options.common, report);
  return 0;
}

}  // namespace

void addProjectProbeCommand(CLI::App& app, Command& chosen) {
  const auto options = std::make_shared<ProbeOptions>();
  CLI::App& sub = *app.add_subcommand(
      "project-probe", "Project an image of the surroundings, or a list of lights, into spherical harmonics");
  sub.add_option("INPUT", options->input, "Image, folder of six faces, or LIGHTS.json")->required();
  sub.add_option("-o,--output", options->output,
                 "Light file to write, - for standard output; without it, figures are only printed")
      ->type_name("OUT");
  addLayout(sub, options->light.layout);
  addInteger(sub, "--degree", options->light.degree, 0, kMaximumLightDegree,
             fmt::format("Highest spherical-harmonic band; of images at most {}", kMaximumBakeDegree));
  addWindow(sub, options->window);
  addRotation(sub, options->rotation);
  addExposure(sub, options->exposure, "Multiply the light by 2^EV");
  sub.add_flag("--clamp-negative", options->light.clampNegative,
               "Take negative pixel values as 0 instead of as they are");
  sub.add_flag("--strict", options->light.strict, "Refuse NaN, infinite and negative pixels");
  addCommonOptions(sub, options->common);
  sub.footer(
      "Examples:\n"
      "  shprt project-probe sky.hdr\n"
      "  shprt project-probe sky.hdr -o sky.json --degree 8 --window auto\n"
      "  shprt project-probe sun.json -o sun_sh.json --degree 1000\n"
      "  shprt project-probe ball.hdr --layout mirrored-ball --rotate axis:0,1,0,90 -o turned.json");
  sub.callback([options, &chosen] { chosen = [options] { return runProjectProbe(*options); }; });
}

}  // namespace shprt
