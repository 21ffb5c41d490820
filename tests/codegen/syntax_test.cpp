// Whether shader code is valid: GLSL and HLSL by glslang where it is installed, WGSL, which no Debian package
// checks, by the rules of that language which generated code could break.
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <fstream>
#include <set>
#include <string>
#include <vector>

#include "shprt/codegen/generate.h"
#include "shprt/sh/basis.h"
#include "tests/codegen/compiled_code.h"
#include "tests/scratch.h"

namespace shprt {
namespace {

CodeRequest withLight(CodeRequest request) {
  for (int i = 0; i < coefficientCount(request.degree); ++i)
    request.light.push_back({0.5 * i, -1.0 / (i + 1), 1e-9});
  return request;
}

bool haveGlslang() {
  return std::system("glslangValidator --version >/dev/null 2>&1") == 0;
}

// Runs glslang and fails the test with what it says unless it is content.
void validate(const std::string& options, const std::string& file, const std::string& source) {
  const std::string path = test::scratch(file);
  std::ofstream(path) << source;
  const std::string log = path + ".log";
  const std::string command = "glslangValidator " + options + " '" + path + "' >'" + log + "' 2>&1";
  const int code = std::system(command.c_str());
  std::ifstream stream(log);
  const std::string said{std::istreambuf_iterator<char>(stream), {}};
  EXPECT_EQ(code, 0) << command << "\n" << said;
  EXPECT_EQ(said.find("WARNING"), std::string::npos) << said;
}

// The body of a main function that calls everything.
std::string calls(const CodeRequest& request, const std::string& colour) {
  const std::string n = std::to_string(coefficientCount(request.degree));
  std::string text = "  float basis[" + n + "];\n  shEvaluateBasis(dir, basis);\n  " + colour +
                     " sum = shRadiance(light, dir) + shIrradiance(shLight, dir) + basis[0];\n";
  if (request.functions.rotation) {
    text += "  " + colour + " turned[" + n + "];\n  shRotate(turn, light, turned);\n  sum += turned[0];\n";
  }
  return text;
}

class EveryDegree : public testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(Degrees, EveryDegree, testing::Range(0, kMaximumCodeDegree + 1));

TEST_P(EveryDegree, GlslIsValid) {
  if (!haveGlslang()) GTEST_SKIP() << "SKIPPED: no glslangValidator (Debian package glslang-tools)";
  const CodeRequest request = withLight(test::requestAll(CodeLanguage::kGlsl, GetParam()));
  for (const char* version : {"300 es", "450"}) {
    const std::string n = std::to_string(coefficientCount(GetParam()));
    validate("-S frag", std::string("glsl") + version[0] + ".frag",
             std::string("#version ") + version + "\nprecision highp float;\n" + generateCode(request) +
                 "\nuniform vec3 light[" + n + "];\nuniform mat3 turn;\nin vec3 dir;\nout vec4 colour;\n" +
                 "void main() {\n" + calls(request, "vec3") + "  colour = vec4(sum, 1.0);\n}\n");
  }
}

TEST_P(EveryDegree, HlslIsValid) {
  if (!haveGlslang()) GTEST_SKIP() << "SKIPPED: no glslangValidator (Debian package glslang-tools)";
  const CodeRequest request = withLight(test::requestAll(CodeLanguage::kHlsl, GetParam()));
  const std::string n = std::to_string(coefficientCount(GetParam()));
  validate("-D -V -e main -S frag -o " + test::scratch("hlsl.spv"), "hlsl.hlsl",
           generateCode(request) + "\ncbuffer Light { float3 light[" + n + "]; float3x3 turn; };\n" +
               "float4 main(float3 dir : DIRECTION) : SV_Target {\n" + calls(request, "float3") +
               "  return float4(sum, 1.0);\n}\n");
}

std::vector<std::string> tokenize(const std::string& code) {
  std::vector<std::string> tokens;
  for (std::size_t i = 0; i < code.size();) {
    const auto is = [&](std::size_t k, int (*kind)(int)) {
      return k < code.size() && kind(static_cast<unsigned char>(code[k])) != 0;
    };
    std::size_t end = i + 1;
    if (code.compare(i, 2, "//") == 0) {
      i = std::min(code.find('\n', i), code.size());
      continue;
    }
    if (is(i, std::isspace)) {
      ++i;
      continue;
    }
    if (is(i, std::isdigit)) {
      while (is(end, std::isalnum) || (end < code.size() && code[end] == '.') ||
             (end < code.size() && (code[end] == '-' || code[end] == '+') && code[end - 1] == 'e'))
        ++end;
    } else if (is(i, std::isalpha) || code[i] == '_') {
      while (is(end, std::isalnum) || (end < code.size() && code[end] == '_')) ++end;
    } else if (code.compare(i, 2, "->") == 0 || code.compare(i, 2, "+=") == 0) {
      end = i + 2;
    }
    tokens.push_back(code.substr(i, end - i));
    i = end;
  }
  return tokens;
}

// The first rule of WGSL that the code breaks, or "". It knows just what generated code uses.
std::string wgslProblem(const std::string& code) {
  const std::set<std::string> known = {"fn",  "let",      "var",  "const",  "return", "f32",
                                       "ptr", "function", "vec3", "mat3x3", "array"};
  const std::set<std::string> reserved = {"matrix", "vector", "final",  "half",   "sample", "input",
                                          "output", "std",    "common", "target", "mat",    "vec",
                                          "out",    "inout",  "float",  "double", "int",    "of",
                                          "set",    "get",    "self",   "where",  "this"};
  const std::vector<std::string> tokens = tokenize(code);
  std::set<std::string> moduleNames, localNames;
  std::string open;
  const auto at = [&](std::size_t i) { return i < tokens.size() ? tokens[i] : std::string(); };
  for (std::size_t i = 0; i < tokens.size(); ++i) {
    const std::string& token = tokens[i];
    const std::string before = i > 0 ? tokens[i - 1] : "";
    const bool inFunction = open.find('{') != std::string::npos;
    if (token == "(" || token == "[" || token == "{" || token == "<") {
      open += token;
    } else if (token == ")" || token == "]" || token == "}" || token == ">") {
      const std::string pairs = "()[]{}<>";
      if (open.empty() || pairs[pairs.find(token) - 1] != open.back()) return "unbalanced " + token;
      open.pop_back();
      if (token == "}") {
        if (before != ";" && before != "{") return "a statement without its semicolon";
        localNames.clear();
      }
    } else if (std::isdigit(static_cast<unsigned char>(token[0]))) {
      const bool whole = token.find_first_of(".e") == std::string::npos;
      const bool wholeExpected = (before == "[" && at(i + 1) == "]") || (before == "," && at(i + 1) == ">");
      if (whole != wholeExpected) return "a number of the wrong kind: " + before + token + at(i + 1);
    } else if (std::isalpha(static_cast<unsigned char>(token[0])) || token[0] == '_') {
      if (known.contains(token)) continue;
      if (reserved.contains(token) || token.starts_with("__")) return "the reserved word " + token;
      const bool moduleName = before == "fn" || (before == "const" && !inFunction);
      const bool parameter = !inFunction && at(i + 1) == ":" && (before == "(" || before == ",");
      if (moduleName) {
        if (!moduleNames.insert(token).second) return token + " declared twice";
        localNames.clear();
      } else if (parameter || before == "let" || before == "var") {
        if (at(i + 1) != ":") return token + " declared without a type";
        if (!localNames.insert(token).second) return token + " declared twice";
      } else if (before == ".") {
        if (token != "x" && token != "y" && token != "z") return "no component " + token;
      } else if (!localNames.contains(token) && !moduleNames.contains(token)) {
        return token + " used before it is declared";
      }
    } else if (token.find_first_of("%&|!?~'\"\\#@^$/") != std::string::npos && token != "&") {
      return "unexpected " + token;
    }
  }
  return open.empty() ? "" : "unclosed " + open;
}

TEST_P(EveryDegree, WgslKeepsTheRulesThatCanBeChecked) {
  EXPECT_EQ(wgslProblem(generateCode(withLight(test::requestAll(CodeLanguage::kWgsl, GetParam())))), "");
}

// The checker itself must see what it is there for.
TEST(WgslChecker, SeesMistakes) {
  EXPECT_EQ(wgslProblem("fn f(a: f32) -> f32 {\n  let b: f32 = 2.0 * a;\n  return b;\n}\n"), "");
  for (const char* bad : {
           "fn f(a: f32) -> f32 {\n  return 2 * a;\n}\n",
           "fn f(a: f32) -> f32 {\n  return b;\n}\n",
           "fn f(a: f32) -> f32 {\n  let a: f32 = 1.0;\n  return a;\n}\n",
           "fn f(a: f32) -> f32 {\n  return a\n}\n",
           "fn f(a: f32) -> f32 {\n  return (a;\n}\n",
           "fn f(a: array<f32, 2>) -> f32 {\n  return a[1.0];\n}\n",
           "fn f(a: f32) -> f32 {\n  let matrix: f32 = a;\n  return matrix;\n}\n",
           "fn f(a: f32) -> f32 {\n  let b = a;\n  return b;\n}\n",
           "fn f(a: vec3<f32>) -> f32 {\n  return a.w;\n}\n",
           "fn f(a: f32) -> f32 {\n  return a;\n}\nfn f(a: f32) -> f32 {\n  return a;\n}\n",
           "fn f(a: f32) -> f32 {\n  return a;\n",
       })
    EXPECT_NE(wgslProblem(bad), "") << bad;
}

}  // namespace
}  // namespace shprt
