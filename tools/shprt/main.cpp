// shprt: precomputed radiance transfer for meshes. Parses, runs one subcommand, turns failures into one line
// and an exit code: 0 done, 1 bad data or a failed comparison, 2 bad usage, 130 interrupted.
#include <CLI/CLI.hpp>
#include <exception>
#include <new>
#include <string>
#include <vector>

#include "commands.h"
#include "console.h"
#include "interrupt.h"
#include "shprt/base/error.h"
#include "shprt/base/version.h"

namespace {

constexpr int kBadData = 1, kBadUsage = 2, kInterrupted = 130;
// shprt diff keeps 1 for files that differ: a script must be able to tell a failed test from one that could
// not be made, or whose result could not be written.
constexpr int kNotComparable = 2;

std::string hint(const CLI::App& app) {
  const auto chosen = app.get_subcommands();
  return "; see shprt " + (chosen.empty() ? "" : chosen.front()->get_name() + " ") + "--help";
}

// CLI11 misses the subcommand before it says that it does not know the word in its place.
std::string describe(const CLI::App& app, const CLI::ParseError& error) {
  const std::vector<std::string> unknown = app.remaining();
  if (app.get_subcommands().empty() && !unknown.empty())
    return "'" + unknown.front() + "' is no subcommand or option";
  return error.what();
}

void parse(CLI::App& app, int argc, char** argv, shprt::Command& chosen) {
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& help) {
    chosen = [&app, request = CLI::Error(help)] { return app.exit(request); };
  }
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{
      "Precomputed radiance transfer: bake how light reaches a mesh once, relight it with dot products."};
  app.name("shprt");
  app.set_version_flag("--version", std::string("shprt ") + shprt::kVersion);
  app.require_subcommand(1);
  app.footer(
      "Examples:\n"
      "  shprt bake bunny.obj -o bunny.prt.exr\n"
      "  shprt project-probe sky.hdr -o sky.json\n"
      "  shprt relight bunny.prt.exr sky.json -o bunny.png\n"
      "Exit codes: 0 done, 1 bad data, 2 bad usage; of diff: 0 equal, 1 different, 2 not comparable.");
  shprt::Command chosen;
  shprt::addBakeCommand(app, chosen);
  shprt::addPlanCommand(app, chosen);
  shprt::addStudyCommand(app, chosen);
  shprt::addProjectProbeCommand(app, chosen);
  shprt::addRelightCommand(app, chosen);
  shprt::addConvertCommand(app, chosen);
  shprt::addCodegenCommand(app, chosen);
  shprt::addDiffCommand(app, chosen);
  shprt::addInfoCommand(app, chosen);
  shprt::handleInterrupts();
  int failure = kBadData;
  try {
    parse(app, argc, argv, chosen);
    if (app.got_subcommand("diff")) failure = kNotComparable;
    const int code = chosen();
    shprt::flushStandardOutput();
    return code;
  } catch (const CLI::ParseError& error) {
    shprt::printError(describe(app, error) + hint(app));
    return kBadUsage;
  } catch (const shprt::UsageError& error) {
    shprt::printError(error.what() + hint(app));
    return kBadUsage;
  } catch (const shprt::Interrupted&) {
    shprt::printError("interrupted; what was not finished was not written");
    return kInterrupted;
  } catch (const shprt::Error& error) {
    shprt::printError(error.what());
  } catch (const std::bad_alloc&) {
    shprt::printError("out of memory; try a lower --degree or a smaller mesh or image");
  } catch (const std::exception& error) {
    shprt::printError(std::string("unexpected failure: ") + error.what());
  }
  return failure;
}
