// shprt codegen: source code that evaluates spherical harmonics in shaders and C.
#include <fmt/core.h>

#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <string_view>

#include "commands.h"
#include "console.h"
#include "options.h"
#include "output.h"
#include "shell_words.h"
#include "shprt/base/error.h"
#include "shprt/codegen/generate.h"
#include "shprt/coefficients/light_coefficients.h"
#include "shprt/light/project_probe.h"

namespace shprt {
namespace {

struct CodegenOptions {
  CodeRequest request;
  std::optional<int> degree;
  std::optional<std::string> lightFile;
  std::string output = "-", type;
  bool functionsGiven = false;
  CommonOptions common;
};

struct LanguageName {
  const char* name;
  CodeLanguage language;
};
constexpr std::array<LanguageName, 4> kLanguages = {{{"glsl", CodeLanguage::kGlsl},
                                                     {"hlsl", CodeLanguage::kHlsl},
                                                     {"wgsl", CodeLanguage::kWgsl},
                                                     {"c", CodeLanguage::kC}}};

struct FunctionName {
  const char* name;
  bool CodeFunctions::*member;
};
constexpr std::array<FunctionName, 4> kFunctions = {{{"basis", &CodeFunctions::basis},
                                                     {"evaluate", &CodeFunctions::radiance},
                                                     {"irradiance", &CodeFunctions::irradiance},
                                                     {"rotation", &CodeFunctions::rotation}}};

CodeLanguage parseLanguage(const std::string& text) {
  for (const LanguageName& language : kLanguages)
    if (text == language.name) return language.language;
  throw Error("'" + text + "'", "is none of glsl, hlsl, wgsl, c");
}

CodeFunctions parseFunctions(const std::string& text) {
  CodeFunctions functions = {false, false, false, false};
  std::string_view rest = text;
  for (;;) {
    const std::size_t comma = rest.find(',');
    const std::string_view word = rest.substr(0, comma);
    bool known = false;
    for (const FunctionName& function : kFunctions) {
      if (word != function.name) continue;
      functions.*function.member = true;
      known = true;
    }
    if (!known) {
      throw Error("'" + std::string(word) + "'", "is none of basis, evaluate, irradiance, rotation",
                  "give one or more of these, separated by commas");
    }
    if (comma == std::string_view::npos) return functions;
    rest.remove_prefix(comma + 1);
  }
}

std::string listFunctions(const CodeFunctions& functions) {
  std::string list;
  for (const FunctionName& function : kFunctions)
    if (functions.*function.member) list += (list.empty() ? "" : ",") + std::string(function.name);
  return list;
}

const char* nameOf(CodeLanguage wanted) {
  for (const LanguageName& language : kLanguages)
    if (language.language == wanted) return language.name;
  return "";
}

// The command that makes the same code again, whatever defaults made it now.
std::string commandOf(const CodegenOptions& options, const CodeRequest& request) {
  std::string command = fmt::format("shprt codegen --degree {} --language {} --what {}", request.degree,
                                    nameOf(request.language), listFunctions(request.functions));
  if (request.doublePrecision) command += " --type double";
  if (options.lightFile) command += " --light " + quoteForShell(*options.lightFile);
  return command;
}

// Fills in the degree and the coefficients from the light file.
void takeLight(const CodegenOptions& options, CodeRequest& request) {
  LightCoefficients light = readLight(*options.lightFile);
  request.degree = options.degree.value_or(light.degree);
  if (request.degree > kMaximumCodeDegree) {
    throw Error(*options.lightFile,
                fmt::format("has degree {}, and code goes to {}", light.degree, kMaximumCodeDegree),
                "add --degree to leave out the bands above");
  }
  light = withDegree(light, request.degree);
  for (const std::array<double, 3>& colour : light.coefficients) {
    for (const double channel : colour) {
      if (request.doublePrecision || std::fabs(channel) <= std::numeric_limits<float>::max()) continue;
      throw Error(*options.lightFile, fmt::format("the coefficient {:g} does not fit into a float", channel));
    }
    request.light.push_back({colour[0], colour[1], colour[2]});
  }
}

int runCodegen(const CodegenOptions& options) {
  const Console console = makeConsole(options.common, options.output);
  CodeRequest request = options.request;
  request.doublePrecision = options.type == "double";
  if (!options.type.empty() && request.language != CodeLanguage::kC)
    throw UsageError("--type: shader code is float; a type can be chosen for --language c only");
  checkDistinct(options.output, options.common);
  std::vector<std::string> inputs;
  if (options.lightFile) inputs.push_back(*options.lightFile);
  checkOutput(options.output, inputs);
  checkOutput(options.common.jsonFile, inputs);
  if (options.lightFile) {
    takeLight(options, request);
  } else {
    request.degree = options.degree.value_or(request.degree);
  }
  if (request.functions.rotation && request.degree > kMaximumCodeRotationDegree) {
    if (options.functionsGiven) {
      throw UsageError(fmt::format("--what: rotation goes to degree {}, not {}", kMaximumCodeRotationDegree,
                                   request.degree));
    }
    request.functions.rotation = false;
    console.note(fmt::format("no rotation above degree {}", kMaximumCodeRotationDegree));
  }
  request.command = commandOf(options, request);
  const std::string code = generateCode(request);
  writeText(options.output, code);

  console.field("language", nameOf(request.language));
  console.field("degree", fmt::format("{}", request.degree));
  console.field("functions", listFunctions(request.functions));
  console.field("wrote",
                options.output == "-" ? "standard output" : options.output + ", " + formatBytes(code.size()));
  writeFigures(options.common, {{"command", "codegen"},
                                {"output", options.output},
                                {"language", nameOf(request.language)},
                                {"type", request.doublePrecision ? "double" : "float"},
                                {"degree", request.degree},
                                {"functions", listFunctions(request.functions)},
                                {"bytes", code.size()}});
  return 0;
}

}  // namespace

void addCodegenCommand(CLI::App& app, Command& chosen) {
  const auto options = std::make_shared<CodegenOptions>();
  CLI::App& sub = *app.add_subcommand(
      "codegen", "Print code that evaluates spherical harmonics in GLSL, HLSL, WGSL or C");
  addParsed(
      sub, "--language", "glsl|hlsl|wgsl|c",
      [options](const std::string& text) { options->request.language = parseLanguage(text); }, "Of the code")
      ->required();
  addInteger(sub, "--degree", options->degree, 0, kMaximumCodeDegree,
             "Highest spherical-harmonic band; without it 2, or that of the light");
  addParsed(
      sub, "--what", "LIST",
      [options](const std::string& text) {
        options->request.functions = parseFunctions(text);
        options->functionsGiven = true;
      },
      fmt::format("Which functions: basis, evaluate, irradiance, rotation (to degree {}), separated by "
                  "commas; all by default",
                  kMaximumCodeRotationDegree));
  addParsed(
      sub, "--type", "float|double",
      [options](const std::string& text) {
        if (text != "float" && text != "double") throw Error("'" + text + "'", "is neither float nor double");
        options->type = text;
      },
      "Of numbers in C; float by default");
  sub.add_option("--light", options->lightFile, "Light file whose coefficients become the constant shLight")
      ->type_name("LIGHT");
  sub.add_option("-o,--output", options->output, "File to write, - for standard output (the default)")
      ->type_name("OUT");
  addCommonOptions(sub, options->common);
  sub.footer(
      "Examples:\n"
      "  shprt codegen --degree 2 --language glsl --what irradiance\n"
      "  shprt codegen --degree 4 --language c -o sh4.h\n"
      "  shprt codegen --language wgsl --light sky.json -o sky.wgsl");
  sub.callback([options, &chosen] { chosen = [options] { return runCodegen(*options); }; });
}

}  // namespace shprt
