#include "shprt/base/error.h"

namespace shprt {
namespace {

std::string oneLine(const std::string& where, const std::string& problem, const std::string& remedy) {
  std::string line = where;
  if (!problem.empty()) line += ": " + problem;
  if (!remedy.empty()) line += "; " + remedy;
  for (char& c : line) {
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) c = '?';
  }
  return line;
}

}  // namespace

Error::Error(const std::string& where, const std::string& problem, const std::string& remedy)
    : std::runtime_error(oneLine(where, problem, remedy)) {}

}  // namespace shprt
