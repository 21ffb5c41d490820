// Writes docs/numerics.md and its plots from measurements. Usage: bench_numerics [DOCS_DIR]; default: the
// docs of the source tree. Takes some minutes.
#include <fmt/core.h>

#include <exception>
#include <filesystem>
#include <string>

#include "bench/numerics/sections.h"
#include "shprt/base/file.h"

namespace shprt::numerics {

std::string promiseRow(const std::string& what, double measured, double required) {
  return fmt::format("| {} | {:.1e} | {:.0e} | {} |\n", what, measured, required,
                     measured <= required ? "holds" : "**missed**");
}

}  // namespace shprt::numerics

int main(int argc, char** argv) {
  using namespace shprt::numerics;
  try {
    const std::filesystem::path docs = argc > 1 ? argv[1] : SHPRT_SOURCE_DIR "/docs";
    const Page page{docs / "pictures", "pictures/"};
    std::filesystem::create_directories(page.pictures);
    std::string text =
        "# Numerics\n\n"
        "How exact the mathematics is, measured. This page and its plots are written by a program: "
        "`bench_numerics` (sources in\n"
        "`bench/numerics/`); do not edit them by hand. References are computed there in quadruple precision "
        "(34 digits) at the\n"
        "very numbers that the routines are given, so rounding of inputs does not count. Solid lines are "
        "shprt, dashed lines\n"
        "formulas as papers print them. Infinite and NaN results stand on the upper edge.\n\n";
    text += evaluationSection(page);
    text += rotationSection(page);
    text += zonalSection(page);
    shprt::writeFile(docs / "numerics.md", text);
    fmt::print("wrote {}\n", (docs / "numerics.md").string());
    return 0;
  } catch (const std::exception& error) {
    fmt::print(stderr, "bench_numerics: {}\n", error.what());
    return 1;
  }
}
