// Where results go: checked before the work is done, written whole or not at all.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "console.h"
#include "options.h"

namespace shprt {

using Json = nlohmann::ordered_json;

// Throws Error when target cannot be written or is one of the inputs. "-" is always fine.
void checkOutput(const std::string& target, const std::vector<std::string>& inputs);

// Throws Error when target is one of the inputs; for those that show themselves only while reading: materials
// of a mesh, probes of a list.
void checkNotInput(const std::string& target, const std::vector<std::filesystem::path>& inputs);

// Throws UsageError when the figures would go to the same file as the result.
void checkDistinct(const std::string& output, const CommonOptions& common);

// checkOutput() and checkDistinct() for a command with one result: its file and that of its figures.
void checkTargets(const std::string& output, const CommonOptions& common,
                  const std::vector<std::string>& inputs);

// Lower-case suffix with its dot; "" for none.
std::string suffixOf(const std::string& path);

// A file's size in bytes, 0 when unknown.
std::uint64_t fileSize(const std::string& path);

// Writes text to a file, or to standard output for "-".
void writeText(const std::string& target, std::string_view text);

// Writes the figures where --json says; nothing when it was not given.
void writeFigures(const CommonOptions& common, const Json& figures);

// The console for a command whose data go to `target` ("" for none). Throws UsageError when data and figures
// both claim standard output.
Console makeConsole(const CommonOptions& common, const std::string& target);

}  // namespace shprt
