// shprt convert: a light file turned, to another degree, or to the convention of another tool and back.
#include <fmt/core.h>

#include <algorithm>
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
#include "shprt/coefficients/convention_file.h"
#include "shprt/light/project_probe.h"

namespace shprt {
namespace {

struct ConvertOptions {
  std::string input, output;
  std::optional<RotationArgument> rotation;
  std::optional<int> degree;
  std::optional<Convention> convention;
  CommonOptions common;
};

LightCoefficients loadConvertible(const std::string& path) {
  checkInput(path);
  if (isConventionFile(path)) return readConventionFile(path);
  const FileKind kind = fileKind(path);
  if (kind != FileKind::kLight) {
    throw Error(path, std::string("is ") + kindName(kind) + ", and convert takes light files",
                "make one with shprt project-probe");
  }
  return readLight(path);
}

std::string degreeChange(int from, int to) {
  if (from == to) return fmt::format("{}", to);
  return fmt::format("{}, from {}{}", to, from, to > from ? "; the new bands are zero" : "");
}

// The light at a degree that the convention holds; what that costs becomes a note and a figure.
LightCoefficients fitToConvention(const Console& console, const LightCoefficients& light,
                                  const ConventionFacts& facts, Json& figures) {
  figures["convention"] = facts.name;
  const int degree = std::clamp(light.degree, facts.minimumDegree, facts.maximumDegree);
  if (degree < light.degree) {
    const std::array<double, 3> dropped = energyShareAbove(light, degree);
    figures["energyDropped"] = dropped;
    console.note(
        fmt::format("{} holds bands 0 to {}; those above are dropped, {:.2f}% {:.2f}% {:.2f}% of the "
                    "light's energy",
                    facts.name, degree, 100 * dropped[0], 100 * dropped[1], 100 * dropped[2]));
  }
  return withDegree(light, degree);
}

int runConvert(const ConvertOptions& options) {
  const Console console = makeConsole(options.common, options.output);
  std::vector<std::string> inputs = {options.input};
  if (options.rotation) inputs.push_back(options.rotation->file);
  checkTargets(options.output, options.common, inputs);
  noteCorrection(console, options.rotation);
  const LightCoefficients original = loadConvertible(options.input);
  LightCoefficients light = original;
  if (options.degree) light = withDegree(light, *options.degree);
  if (options.rotation) light = rotateLight(light, options.rotation->matrix);
  Json conversion = Json::object();
  if (options.convention)
    light = fitToConvention(console, light, conventionFacts(*options.convention), conversion);
  Json figures = lightStatisticsJson(light);
  if (options.rotation) figures["rotation"] = options.rotation->matrix.m;
  // What only the maker could measure holds as long as the light is the same.
  Json statistics = Json::object();
  if (!options.rotation && light.degree == original.degree && !original.statisticsJson.empty())
    statistics = Json::parse(original.statisticsJson);
  statistics.update(figures);
  light.statisticsJson = statistics.dump();
  writeText(options.output,
            options.convention ? formatConventionFile(light, *options.convention) : formatLight(light));

  console.field("light", options.input);
  console.field("degree", degreeChange(original.degree, light.degree));
  if (options.convention) {
    const ConventionFacts& facts = conventionFacts(*options.convention);
    console.field("convention", facts.name);
    console.field("", facts.meaning);
    console.field("", std::string("axes ") + facts.frame);
  }
  printLight(console, light);
  console.field("wrote", options.output == "-" ? "standard output" : options.output);
  Json report = {
      {"command", "convert"}, {"input", options.input}, {"output", options.output}, {"degree", light.degree}};
  report.update(conversion);
  report.update(figures);
  writeFigures(options.common, report);
  return 0;
}

std::string conventionNames() {
  std::string names;
  for (const ConventionFacts& facts : allConventions())
    names += (names.empty() ? "" : " | ") + std::string(facts.name);
  return names;
}

}  // namespace

void addConvertCommand(CLI::App& app, Command& chosen) {
  const auto options = std::make_shared<ConvertOptions>();
  CLI::App& sub = *app.add_subcommand(
      "convert", "Turn a light file, bring it to another degree, or to another tool's convention and back");
  sub.add_option("IN", options->input, "Light file, or one that --convention wrote")->required();
  sub.add_option("-o,--output", options->output, "File to write, - for standard output")
      ->required()
      ->type_name("OUT");
  addRotation(sub, options->rotation);
  addInteger(sub, "--degree", options->degree, 0, kMaximumLightDegree,
             "Drop bands above this, or add zero bands up to it");
  addParsed(
      sub, "--convention", "NAME",
      [options](const std::string& text) { options->convention = parseConvention(text); },
      "Write the coefficients as another tool holds them: " + conventionNames());
  addCommonOptions(sub, options->common);
  sub.footer(
      "Examples:\n"
      "  shprt convert sky.json -o turned.json --rotate axis:0,1,0,90\n"
      "  shprt convert sky.json -o small.json --degree 2\n"
      "  shprt convert sky.json -o sky_unity.json --convention unity\n"
      "  shprt convert sky_unity.json -o back.json");
  sub.callback([options, &chosen] { chosen = [options] { return runConvert(*options); }; });
}

}  // namespace shprt
