// Another program, run to its end: text in, text out, and never longer than it may take.
#pragma once

#include <chrono>
#include <cstdint>
#include <string>
#include <vector>

namespace shprt {

struct ChildResult {
  std::string output, errors;  // what it wrote to its standard output and standard error
  std::string failure;         // one line: why it did not run to a good end; "" where it did
  bool found = true;           // whether there is such a program at all
};

inline constexpr std::uint64_t kMostChildBytes = std::uint64_t{1} << 26;

// Runs command[0], found as a shell would find it, with `input` on its standard input and LC_ALL=C; there is
// no shell in between. A program that is not there, that fails or crashes is a result. One that takes longer
// than `limit`, or writes more than kMostChildBytes, is ended, together with what it has started.
ChildResult runChild(const std::vector<std::string>& command, const std::string& input,
                     std::chrono::milliseconds limit);

}  // namespace shprt
