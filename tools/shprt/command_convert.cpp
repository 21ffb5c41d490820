// shprt convert: a light file turned, or to another degree.
#include <fmt/core.h>

#include <memory>
#include <optional>

#include "commands.h"
#include "console.h"
#include "file_kind.h"
#include "light_report.h"
#include "options.h"
#include "output.h"
#include "shprt/base/error.h"
#include "shprt/light/project_probe.h"
#include "shprt/sh/basis.h"

namespace shprt {
namespace {

struct ConvertOptions {
  std::string input, output;
  std::optional<Mat3> rotation;
  std::optional<int> degree;
  CommonOptions common;
};

int runConvert(const ConvertOptions& options) {
  const Console console = makeConsole(options.common, options.output);
  const std::vector<std::string> inputs = {options.input};
  checkOutput(options.output, inputs);
  checkOutput(options.common.jsonFile, inputs);
  checkDistinct(options.output, options.common);
  const FileKind kind = fileKind(options.input);
  if (kind != FileKind::kLight) {
    throw Error(options.input, std::string("is ") + kindName(kind) + ", and convert takes light files",
                "make one with shprt project-probe");
  }
  const LightCoefficients original = readLight(options.input);
  LightCoefficients light = original;
  const bool changed = options.rotation || (options.degree && *options.degree != light.degree);
  if (options.degree) light = withDegree(light, *options.degree);
  if (options.rotation) light = rotateLight(light, *options.rotation);
  Json figures = lightStatisticsJson(light);
  if (options.rotation) figures["rotation"] = options.rotation->m;
  // What the maker measured of the light holds no longer once it is turned or cut.
  if (changed) light.statisticsJson = figures.dump();
  writeText(options.output, formatLight(light));

  console.field("light", options.input);
  console.field("degree",
                light.degree == original.degree
                    ? fmt::format("{}", light.degree)
                    : fmt::format("{}, from {}{}", light.degree, original.degree,
                                  light.degree > original.degree ? "; the new bands are zero" : ""));
  printLight(console, light);
  console.field("wrote", options.output == "-" ? "standard output" : options.output);
  Json report = {
      {"command", "convert"}, {"input", options.input}, {"output", options.output}, {"degree", light.degree}};
  report.update(figures);
  writeFigures(options.common, report);
  return 0;
}

}  // namespace

void addConvertCommand(CLI::App& app, Command& chosen) {
  const auto options = std::make_shared<ConvertOptions>();
  CLI::App& sub = *app.add_subcommand("convert", "Turn a light file, or bring it to another degree");
  sub.add_option("IN", options->input, "Light file")->required();
  sub.add_option("-o,--output", options->output, "Light file to write, - for standard output")
      ->required()
      ->type_name("OUT");
  addRotation(sub, options->rotation);
  addInteger(sub, "--degree", options->degree, 0, kMaximumBakeDegree,
             "Drop bands above this, or add zero bands up to it");
  addCommonOptions(sub, options->common);
  sub.footer(
      "Examples:\n"
      "  shprt convert sky.json -o turned.json --rotate axis:0,1,0,90\n"
      "  shprt convert sky.json -o small.json --degree 2");
  sub.callback([options, &chosen] { chosen = [options] { return runConvert(*options); }; });
}

}  // namespace shprt
