#include "console.h"

#include <fmt/core.h>
#include <spdlog/sinks/stdout_color_sinks.h>
#include <spdlog/spdlog.h>

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <memory>

#include "shprt/base/error.h"

namespace shprt {
namespace {

constexpr int kLabelWidth = 22;

// Colours on a terminal only, and none where the user asks for none (https://no-color.org).
void logToStandardError(spdlog::level::level_enum level, std::string_view text) {
  auto sink = std::make_shared<spdlog::sinks::stderr_color_sink_st>();
  const char* noColor = std::getenv("NO_COLOR");
  if (noColor && *noColor) sink->set_color_mode(spdlog::color_mode::never);
  spdlog::logger logger("shprt", sink);
  logger.set_pattern("%^shprt:%$ %v");
  std::fflush(stdout);  // results so far come first when both go to one terminal
  logger.log(level, "{}", text);
}

void writeAll(std::FILE* stream, std::string_view bytes) {
  std::fwrite(bytes.data(), 1, bytes.size(), stream);
}

}  // namespace

void Console::line(std::string_view text) const {
  if (quiet_) return;
  std::FILE* stream = dataOnStdout_ ? stderr : stdout;
  writeAll(stream, text);
  writeAll(stream, "\n");
}

void Console::field(std::string_view label, std::string_view value) const {
  // Names and texts come from files; what they hold must not steer the terminal.
  std::string shown(value);
  for (char& c : shown) {
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) c = '?';
  }
  line(fmt::format("{:<{}} {}", label, kLabelWidth - 1, shown));
}

void Console::note(std::string_view text) const {
  if (!quiet_) logToStandardError(spdlog::level::info, "note: " + std::string(text));
}

void printError(std::string_view text) {
  std::string line(text);
  for (char& c : line) {
    if (c == '\n' || c == '\r') c = ' ';
  }
  logToStandardError(spdlog::level::err, line);
}

void writeStandardOutput(std::string_view bytes) {
  writeAll(stdout, bytes);
  flushStandardOutput();
}

void flushStandardOutput() {
  errno = 0;
  const bool flushed = std::fflush(stdout) == 0;
  if (flushed && !std::ferror(stdout)) return;
  throw Error("standard output",
              "cannot be written" + (errno ? std::string(": ") + std::strerror(errno) : ""));
}

std::string formatCount(std::uint64_t count) {
  std::string digits = std::to_string(count);
  for (std::size_t place = digits.size(); place > 3; place -= 3) digits.insert(place - 3, ",");
  return digits;
}

std::string formatBytes(std::uint64_t bytes) {
  if (bytes < 1000) return fmt::format("{} bytes", bytes);
  if (bytes < 1000000) return fmt::format("{:.1f} kB", static_cast<double>(bytes) * 1e-3);
  if (bytes < 1000000000) return fmt::format("{:.1f} MB", static_cast<double>(bytes) * 1e-6);
  return fmt::format("{:.2f} GB", static_cast<double>(bytes) * 1e-9);
}

std::string countOf(std::uint64_t count, const char* one, const char* many) {
  return formatCount(count) + " " + (count == 1 ? one : many);
}

}  // namespace shprt
