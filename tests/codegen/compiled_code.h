// Generated code that has been compiled and loaded, so that its values can be looked at. C goes to the C
// compiler; shader code goes to the C++ compiler, behind a few types and macros that make it C++.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "shprt/base/vec.h"
#include "shprt/codegen/generate.h"

namespace shprt::test {

// A request for everything there is at this degree.
CodeRequest requestAll(CodeLanguage language, int degree, bool doublePrecision = false);

bool haveCompilerFor(CodeLanguage language);

class CompiledCode {
 public:
  // Writes, compiles (C as C99, warnings being errors) and loads. A failure to do so fails the test and
  // throws.
  explicit CompiledCode(const CodeRequest& request);

  // In the precision of the code; inputs are rounded to it, and results widened.
  std::vector<double> basis(Vec3d direction) const;
  std::vector<double> radiance(const std::vector<double>& coefficients, Vec3d direction) const;
  std::vector<double> irradiance(const std::vector<double>& coefficients, Vec3d normal) const;
  std::vector<double> rotate(const Mat3& rotation, const std::vector<double>& coefficients) const;

 private:
  std::vector<double> call(const char* function, const std::vector<double>& a, const std::vector<double>& b,
                           std::size_t results) const;

  std::size_t count_;
  bool doublePrecision_;
  std::shared_ptr<void> library_;
};

}  // namespace shprt::test
