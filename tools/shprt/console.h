// What the user reads: results on standard output, notes and errors on standard error.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace shprt {

class Console {
 public:
  // quiet drops results and notes. dataOnStdout sends results to standard error, so that they do not mix with
  // data.
  Console(bool quiet, bool dataOnStdout) : quiet_(quiet), dataOnStdout_(dataOnStdout) {}

  bool quiet() const { return quiet_; }
  // One line of results.
  void line(std::string_view text) const;
  // One line of results as an aligned label and a value; an empty label continues the one above.
  void field(std::string_view label, std::string_view value) const;
  // "shprt: note: ..." on standard error.
  void note(std::string_view text) const;

 private:
  bool quiet_, dataOnStdout_;
};

// "shprt: ..." on standard error, one line whatever the text holds.
void printError(std::string_view text);

// Writes all bytes to standard output. Throws Error when they do not fit.
void writeStandardOutput(std::string_view bytes);
// Throws Error when something written to standard output was lost.
void flushStandardOutput();

std::string formatCount(std::uint64_t count);  // 1,234,567
std::string formatBytes(std::uint64_t bytes);  // 12.3 MB, in powers of ten
// "1 vertex" or "12 vertices"
std::string countOf(std::uint64_t count, const char* one, const char* many);

}  // namespace shprt
