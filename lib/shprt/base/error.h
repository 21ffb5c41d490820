// The one exception of the project: what went wrong, where, and what to do about it, in a single line.
// Thrown where data enters, caught once in main(), where it becomes exit code 1.
#pragma once

#include <stdexcept>
#include <string>

namespace shprt {

class Error : public std::runtime_error {
 public:
  // what() reads "where: problem; remedy". where is a file or an option; problem names the field, line or
  // value at fault; remedy (may be empty) says what the user can do. Control characters are replaced, so the
  // line stays one.
  Error(const std::string& where, const std::string& problem, const std::string& remedy = "");
};

}  // namespace shprt
