#include "tests/codegen/compiled_code.h"

#include <dlfcn.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <regex>
#include <sstream>
#include <stdexcept>

#include "shprt/sh/basis.h"
#include "tests/scratch.h"

namespace shprt::test {
namespace {

const char* kVectors = R"(
struct V {
  float x = 0, y = 0, z = 0;
  V() = default;
  V(float a, float b, float c) : x(a), y(b), z(c) {}
};
inline V operator*(float a, V v) { return {a * v.x, a * v.y, a * v.z}; }
inline V operator+(V a, V b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
inline V operator-(V a, V b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline V operator-(V a) { return {-a.x, -a.y, -a.z}; }
inline V& operator+=(V& a, V b) { return a = a + b; }
struct Columns {
  float c[3][3];
  const float* operator[](int column) const { return c[column]; }
};
inline V operator*(const Columns& m, V v) {
  return v.x * V(m[0][0], m[0][1], m[0][2]) + v.y * V(m[1][0], m[1][1], m[1][2]) + v.z * V(m[2][0], m[2][1], m[2][2]);
}
struct Rows {
  float r[3][3];
  const float* operator[](int row) const { return r[row]; }
};
inline V mul(const Rows& m, V v) {
  return {m[0][0] * v.x + m[0][1] * v.y + m[0][2] * v.z, m[1][0] * v.x + m[1][1] * v.y + m[1][2] * v.z,
          m[2][0] * v.x + m[2][1] * v.y + m[2][2] * v.z};
}
)";

const char* kGlsl = R"(
using vec3 = V;
using mat3 = Columns;
#define out
#define inout
)";

const char* kHlsl = R"(
using float3 = V;
using float3x3 = Rows;
#define out
#define inout
)";

const char* kWgsl = R"(
using f32 = float;
template <class> using vec3 = V;
template <class> using mat3x3 = Columns;
template <class T, int N> struct array {
  T entries[N];
  T& operator[](int i) { return entries[i]; }
};
struct function;
template <class, class T> using ptr = T*;
)";

std::string cWrapper(const std::string& real, bool rotation) {
  std::string text = "typedef " + real + R"( Real;
void testBasis(const Real *dir, const Real *unused, Real *out);
void testRadiance(const Real *c, const Real *dir, Real *out);
void testIrradiance(const Real *c, const Real *dir, Real *out);
void testBasis(const Real *dir, const Real *unused, Real *out) { (void)unused; shEvaluateBasis(dir, out); }
void testRadiance(const Real *c, const Real *dir, Real *out) { shRadiance(c, dir, out); }
void testIrradiance(const Real *c, const Real *dir, Real *out) { shIrradiance(c, dir, out); }
)";
  if (rotation) {
    text += R"(
void testRotate(const Real *rotation, const Real *c, Real *out);
void testRotate(const Real *rotation, const Real *c, Real *out) { shRotate(rotation, c, out); }
)";
  }
  return text;
}

// N stands for the number of coefficients, Matrix for Rows or Columns.
std::string shaderWrapper(CodeLanguage language, int count, bool rotation) {
  const bool wgsl = language == CodeLanguage::kWgsl;
  const bool rows = language == CodeLanguage::kHlsl;
  std::string text = "constexpr int N = " + std::to_string(count) + ";\n";
  text +=
      wgsl ? "using Colours = array<V, N>;\n" : "struct Colours { V v[N]; operator V*() { return v; } };\n";
  text += "using Matrix = " + std::string(rows ? "Rows" : "Columns") + ";\n";
  text += R"(
static Colours take(const float* c) {
  Colours colours;
  for (int i = 0; i < N; ++i) colours[i] = V(c[3 * i], c[3 * i + 1], c[3 * i + 2]);
  return colours;
}
static void give(V v, float* o) { o[0] = v.x; o[1] = v.y; o[2] = v.z; }
static V vectorOf(const float* d) { return V(d[0], d[1], d[2]); }
extern "C" void testRadiance(const float* c, const float* d, float* o) {
  Colours colours = take(c);
  give(shRadiance(colours, vectorOf(d)), o);
}
extern "C" void testIrradiance(const float* c, const float* d, float* o) {
  Colours colours = take(c);
  give(shIrradiance(colours, vectorOf(d)), o);
}
)";
  text += "extern \"C\" void testBasis(const float* d, const float*, float* o) {\n";
  text += wgsl ? "  auto b = shEvaluateBasis(vectorOf(d)); for (int i = 0; i < N; ++i) o[i] = b[i];\n"
               : "  shEvaluateBasis(vectorOf(d), o);\n";
  text += "}\n";
  if (!rotation) return text;
  text += "extern \"C\" void testRotate(const float* r, const float* c, float* o) {\n";
  text += "  Matrix m; for (int i = 0; i < 3; ++i) for (int j = 0; j < 3; ++j) ";
  text += rows ? "m.r[i][j] = r[3 * i + j];\n" : "m.c[j][i] = r[3 * i + j];\n";
  text += "  Colours before = take(c), after;\n";
  text += wgsl ? "  after = shRotate(m, before);\n" : "  shRotate(m, before, after);\n";
  text += "  for (int i = 0; i < N; ++i) give(after[i], o + 3 * i);\n}\n";
  return text;
}

// "a: T, b: U" as C++ writes parameters.
std::string wgslParameters(const std::string& parameters) {
  std::vector<std::string> parts;
  int depth = 0;
  std::string part;
  for (const char c : parameters) {
    if (c == '<') ++depth;
    if (c == '>') --depth;
    if (c == ',' && depth == 0) {
      parts.push_back(part);
      part.clear();
    } else {
      part += c;
    }
  }
  parts.push_back(part);
  std::string result;
  for (const std::string& p : parts)
    result +=
        (result.empty() ? "" : ", ") + std::regex_replace(p, std::regex(R"(^\s*(\w+): (.*)$)"), "$2 $1");
  return result;
}

std::string wgslAsCpp(const std::string& code) {
  std::istringstream lines(code);
  std::string result, line;
  const std::regex function(R"(^fn (\w+)\((.*)\)( -> (.*))? \{$)");
  std::smatch match;
  while (std::getline(lines, line)) {
    if (std::regex_match(line, match, function)) {
      line = (match[3].matched ? match[4].str() : "void") + " " + match[1].str() + "(" +
             wgslParameters(match[2].str()) + ") {";
    }
    line = std::regex_replace(line, std::regex(R"(^(\s*)let (\w+): (.*?) =)"), "$1const $3 $2 =");
    line = std::regex_replace(line, std::regex(R"(^(\s*)var (\w+): (.*);$)"), "$1$3 $2{};");
    result += line + "\n";
  }
  return result;
}

std::string withoutComments(const std::string& code) {
  return std::regex_replace(code, std::regex(R"(//[^\n]*)"), "");
}

// Numbers with a point are floats; sizes and indices stay as they are.
std::string withFloatLiterals(const std::string& code) {
  return std::regex_replace(code, std::regex(R"(\b\d+\.\d+(e[-+]?\d+)?|\b\d+e[-+]?\d+)"), "$&f");
}

std::string translationUnit(const CodeRequest& request) {
  const std::string code = generateCode(request);
  if (request.language == CodeLanguage::kC)
    return code + cWrapper(request.doublePrecision ? "double" : "float", request.functions.rotation);
  const std::string wrapper =
      shaderWrapper(request.language, coefficientCount(request.degree), request.functions.rotation);
  const std::string body = withFloatLiterals(withoutComments(code));
  switch (request.language) {
    case CodeLanguage::kGlsl:
      return kVectors + std::string(kGlsl) + body + wrapper;
    case CodeLanguage::kHlsl:
      return kVectors + std::string(kHlsl) + body + wrapper;
    default:
      return kVectors + std::string(kWgsl) + wgslAsCpp(body) + wrapper;
  }
}

}  // namespace

CodeRequest requestAll(CodeLanguage language, int degree, bool doublePrecision) {
  CodeRequest request;
  request.language = language;
  request.degree = degree;
  request.doublePrecision = doublePrecision;
  request.functions.rotation = degree <= kMaximumCodeRotationDegree;
  request.command = "test";
  return request;
}

bool haveCompilerFor(CodeLanguage language) {
  const std::string compiler = language == CodeLanguage::kC ? SHPRT_C_COMPILER : SHPRT_CXX_COMPILER;
  return !compiler.empty() && std::system(("'" + compiler + "' --version >/dev/null 2>&1").c_str()) == 0;
}

CompiledCode::CompiledCode(const CodeRequest& request)
    : count_(static_cast<std::size_t>(coefficientCount(request.degree))),
      doublePrecision_(request.doublePrecision) {
  const bool c = request.language == CodeLanguage::kC;
  const std::string name =
      scratch("code" + std::to_string(static_cast<int>(request.language)) + "_" +
              std::to_string(request.degree) + (request.doublePrecision ? "_double" : ""));
  const std::string source = name + (c ? ".c" : ".cpp"), binary = name + ".so";
  std::ofstream(source) << translationUnit(request);
  const std::string compiler = c ? "'" SHPRT_C_COMPILER
                                   "' -std=c99 -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Werror"
                                 : "'" SHPRT_CXX_COMPILER "' -std=c++20 -O0";
  const std::string command = compiler + " -fPIC -shared '" + source + "' -o '" + binary + "'";
  if (std::system(command.c_str()) != 0) {
    ADD_FAILURE() << "does not compile: " << command;
    throw std::runtime_error("generated code does not compile");
  }
  library_ = {dlopen(binary.c_str(), RTLD_NOW | RTLD_LOCAL), [](void* library) {
                if (library) dlclose(library);
              }};
  if (!library_) throw std::runtime_error(dlerror());
}

namespace {

template <typename Real>
std::vector<double> callIn(void* symbol, const std::vector<double>& a, const std::vector<double>& b,
                           std::size_t results) {
  const std::vector<Real> first(a.begin(), a.end()), second(b.begin(), b.end());
  std::vector<Real> values(results);
  reinterpret_cast<void (*)(const Real*, const Real*, Real*)>(symbol)(first.data(), second.data(),
                                                                      values.data());
  return {values.begin(), values.end()};
}

}  // namespace

std::vector<double> CompiledCode::call(const char* function, const std::vector<double>& a,
                                       const std::vector<double>& b, std::size_t results) const {
  void* const symbol = dlsym(library_.get(), function);
  if (!symbol) throw std::runtime_error(std::string(function) + " is missing");
  const std::vector<double> values =
      doublePrecision_ ? callIn<double>(symbol, a, b, results) : callIn<float>(symbol, a, b, results);
  for (const double value : values)
    if (!std::isfinite(value)) throw std::runtime_error(std::string(function) + " gives what is not finite");
  return values;
}

std::vector<double> CompiledCode::basis(Vec3d direction) const {
  return call("testBasis", {direction.x, direction.y, direction.z}, {}, count_);
}
std::vector<double> CompiledCode::radiance(const std::vector<double>& coefficients, Vec3d direction) const {
  return call("testRadiance", coefficients, {direction.x, direction.y, direction.z}, 3);
}
std::vector<double> CompiledCode::irradiance(const std::vector<double>& coefficients, Vec3d normal) const {
  return call("testIrradiance", coefficients, {normal.x, normal.y, normal.z}, 3);
}
std::vector<double> CompiledCode::rotate(const Mat3& rotation,
                                         const std::vector<double>& coefficients) const {
  std::vector<double> entries;
  for (const auto& row : rotation.m) entries.insert(entries.end(), row, row + 3);
  return call("testRotate", entries, coefficients, 3 * count_);
}

}  // namespace shprt::test
