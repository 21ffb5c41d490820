// Compact, unrolled source code that evaluates spherical harmonics in shaders and in C.
//
// The code follows docs/conventions.md. It has no trigonometry, division, square root or branch, and every
// function can be read on its own. docs/command-reference.md says how coefficients and matrices go in.
#pragma once

#include <string>
#include <vector>

#include "shprt/base/vec.h"

namespace shprt {

enum class CodeLanguage { kGlsl, kHlsl, kWgsl, kC };

// Code in float errs by at most 1e-6 sqrt((2l+1)/4pi) to degree 8, 3e-6 to this.
inline constexpr int kMaximumCodeDegree = 12;
// Where rotation in float errs by at most 1e-6 of a band's norm, and its text has a readable length.
inline constexpr int kMaximumCodeRotationDegree = 8;

struct CodeFunctions {
  bool basis = true;       // shEvaluateBasis: all y_lm(dir)
  bool radiance = true;    // shRadiance: sum of coefficients times y_lm(dir), RGB
  bool irradiance = true;  // shIrradiance: the same with the factors of the clamped cosine folded in
  bool rotation = true;    // shRotate: RGB coefficients of the function turned by a 3x3 matrix
};

struct CodeRequest {
  int degree = 2;  // 0..kMaximumCodeDegree
  CodeLanguage language = CodeLanguage::kGlsl;
  CodeFunctions functions;       // rotation needs degree <= kMaximumCodeRotationDegree
  bool doublePrecision = false;  // C only
  // RGB coefficients that become the constant array shLight: coefficientCount(degree) of them, finite in the
  // precision of the code, or none.
  std::vector<Vec3d> light;
  std::string command;  // said in the opening comment to have made the code
};

// The source text; the same bytes for the same request. Constants are the shortest decimals that read back as
// the same float (or double).
std::string generateCode(const CodeRequest& request);

}  // namespace shprt
