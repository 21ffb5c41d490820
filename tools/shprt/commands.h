// The subcommands: each adds itself to the parser and, when it is the one asked for, leaves what is to be
// done.
#pragma once

#include <CLI/CLI.hpp>
#include <functional>

namespace shprt {

// Runs the chosen subcommand and returns the exit code.
using Command = std::function<int()>;

void addBakeCommand(CLI::App& app, Command& chosen);
void addPlanCommand(CLI::App& app, Command& chosen);
void addStudyCommand(CLI::App& app, Command& chosen);
void addProjectProbeCommand(CLI::App& app, Command& chosen);
void addRelightCommand(CLI::App& app, Command& chosen);
void addConvertCommand(CLI::App& app, Command& chosen);
void addCodegenCommand(CLI::App& app, Command& chosen);
void addDiffCommand(CLI::App& app, Command& chosen);
void addInfoCommand(CLI::App& app, Command& chosen);

// Options that contradict each other or the files they meet: exit code 2.
class UsageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace shprt
