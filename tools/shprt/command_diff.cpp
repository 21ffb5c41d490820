// shprt diff: how two files of a kind differ. Exit code 0 equal within tolerance, 1 different, 2 not
// comparable.
#include <limits>
#include <memory>

#include "commands.h"
#include "console.h"
#include "file_kind.h"
#include "options.h"
#include "output.h"
#include "shprt/base/error.h"
#include "shprt/coefficients/asset_file.h"
#include "shprt/report/compare.h"

namespace shprt {
namespace {

constexpr int kEqual = 0, kDifferent = 1, kNotComparable = 2;

struct DiffOptions {
  std::string a, b;
  Tolerance tolerance;
  CommonOptions common;
};

Comparison compareFiles(const DiffOptions& options) {
  const FileKind kindA = fileKind(options.a), kindB = fileKind(options.b);
  if (kindA != kindB)
    return notComparable(std::string("one is ") + kindName(kindA) + ", the other " + kindName(kindB));
  switch (kindA) {
    case FileKind::kAsset:
      return compareAssets(readAsset(options.a), readAsset(options.b), options.tolerance);
    case FileKind::kLight:
      return compareLights(readLight(options.a), readLight(options.b), options.tolerance);
    case FileKind::kImage:
      return compareImages(loadImage(options.a).image, loadImage(options.b).image, options.tolerance);
    case FileKind::kLightList:
      return notComparable("lists of lights are not compared; project both first");
    case FileKind::kScene:
    case FileKind::kMesh:
      break;
  }
  return notComparable("meshes are not compared; bake both first");
}

int runDiff(const DiffOptions& options) {
  const Console console = makeConsole(options.common, "");
  checkOutput(options.common.jsonFile, std::vector<std::string>{options.a, options.b});
  const Comparison comparison = compareFiles(options);
  if (comparison.comparable) {
    console.line(formatComparison(comparison, options.a, options.b));
  } else {
    printError(options.a + " and " + options.b + " cannot be compared: " + comparison.whyNot);
  }
  if (!options.common.jsonFile.empty()) {
    writeText(options.common.jsonFile, comparisonToJson(comparison, options.a, options.b) + "\n");
  }
  if (!comparison.comparable) return kNotComparable;
  return comparison.equal() ? kEqual : kDifferent;
}

}  // namespace

void addDiffCommand(CLI::App& app, Command& chosen) {
  const auto options = std::make_shared<DiffOptions>();
  CLI::App& sub = *app.add_subcommand("diff", "Compare two assets, two light files or two pictures");
  sub.add_option("A", options->a, "The reference")->required();
  sub.add_option("B", options->b, "What is compared with it")->required();
  constexpr double kUnbounded = std::numeric_limits<double>::infinity();
  addNumber(sub, "--rtol", options->tolerance.relative, 0, kUnbounded, "Relative tolerance");
  addNumber(sub, "--atol", options->tolerance.absolute, 0, kUnbounded,
            "Absolute tolerance: |a-b| <= atol + rtol max(|a|,|b|)");
  addCommonOptions(sub, options->common);
  sub.footer(
      "Exit codes: 0 equal within tolerance, 1 different, 2 not comparable.\n"
      "Examples:\n"
      "  shprt diff golden.prt.exr today.prt.exr --atol 1e-5\n"
      "  shprt diff a.json b.json --rtol 1e-9\n"
      "  shprt diff before.png after.png --atol 0.01 --json difference.json");
  sub.callback([options, &chosen] { chosen = [options] { return runDiff(*options); }; });
}

}  // namespace shprt
