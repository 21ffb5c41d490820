#include "output.h"

#include <algorithm>
#include <cctype>
#include <system_error>

#include "commands.h"
#include "shprt/base/error.h"
#include "shprt/base/file.h"

namespace shprt {
namespace fs = std::filesystem;

void checkNotInput(const std::string& target, const std::vector<fs::path>& inputs) {
  if (target.empty() || target == "-") return;
  for (const fs::path& input : inputs) {
    std::error_code ignored;
    if (fs::equivalent(target, input, ignored)) {
      throw Error(target, "is an input and would be overwritten", "give another output file");
    }
  }
}

void checkOutput(const std::string& target, const std::vector<std::string>& inputs) {
  if (target.empty() || target == "-") return;
  checkNotInput(target, {inputs.begin(), inputs.end()});
  const AtomicFile attempt{fs::path(target)};
}

void checkDistinct(const std::string& output, const CommonOptions& common) {
  if (output.empty() || output == "-" || common.jsonFile.empty()) return;
  std::error_code ignored;
  if (fs::weakly_canonical(output, ignored) == fs::weakly_canonical(common.jsonFile, ignored)) {
    throw UsageError("--json: " + common.jsonFile + " is the output too");
  }
}

void checkTargets(const std::string& output, const CommonOptions& common,
                  const std::vector<std::string>& inputs) {
  checkOutput(output, inputs);
  checkOutput(common.jsonFile, inputs);
  checkDistinct(output, common);
}

std::string suffixOf(const std::string& path) {
  std::string suffix = fs::path(path).extension().string();
  std::transform(suffix.begin(), suffix.end(), suffix.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return suffix;
}

std::uint64_t fileSize(const std::string& path) {
  std::error_code error;
  const std::uint64_t size = fs::file_size(path, error);
  return error ? 0 : size;
}

void writeText(const std::string& target, std::string_view text) {
  if (target == "-") {
    writeStandardOutput(text);
  } else {
    writeFile(target, text);
  }
}

void writeFigures(const CommonOptions& common, const Json& figures) {
  if (common.jsonFile.empty()) return;
  // File names need not be UTF-8; what is not becomes a replacement character.
  writeText(common.jsonFile, figures.dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
}

Console makeConsole(const CommonOptions& common, const std::string& target) {
  if (common.jsonFile == "-" && target == "-") {
    throw UsageError("--json: standard output is taken by -o already");
  }
  return Console(common.quiet, common.jsonFile == "-" || target == "-");
}

}  // namespace shprt
