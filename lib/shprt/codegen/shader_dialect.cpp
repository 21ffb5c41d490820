// GLSL (ES 3.00 and 1.50 on), HLSL and WGSL: vectors and matrices are types, and differ in spelling only.
#include <cassert>

#include "shprt/codegen/dialect.h"

namespace shprt {
namespace {

class ShaderDialect final : public Dialect {
 public:
  explicit ShaderDialect(CodeLanguage language) : language_(language) {}

  std::string number(double value) const override { return shortestDecimal(value, false); }

  std::string component(const std::string& direction, int axis) const override {
    return direction + "." + "xyz"[axis];
  }

  // GLSL and WGSL index a matrix by column first.
  std::string rotationEntry(const std::string& rotation, int row, int column) const override {
    const bool rowFirst = language_ == CodeLanguage::kHlsl;
    return rotation + "[" + std::to_string(rowFirst ? row : column) + "][" +
           std::to_string(rowFirst ? column : row) + "]";
  }

  std::string wrapped(const std::string& content) const override { return content; }
  std::string helpers(const CodeRequest&) const override { return ""; }

  std::string constantColours(const std::string& name, const std::vector<Vec3d>& colours) const override {
    const std::string type = arrayType(colour(), colours.size());
    std::string text;
    switch (language_) {
      case CodeLanguage::kGlsl:
        text =
            "const " + colour() + " " + name + "[" + std::to_string(colours.size()) + "] = " + type + "(\n";
        break;
      case CodeLanguage::kHlsl:
        text = "static const " + colour() + " " + name + "[" + std::to_string(colours.size()) + "] = {\n";
        break;
      default:
        text = "const " + name + " = " + type + "(\n";
    }
    for (std::size_t i = 0; i < colours.size(); ++i)
      text += "  " + vector(colours[i]) + (i + 1 < colours.size() ? ",\n" : "\n");
    return text + (language_ == CodeLanguage::kHlsl ? "};\n" : ");\n");
  }

  std::string functionBegin(const CodeFunction& function, bool) const override {
    std::string parameters;
    const auto add = [&](const std::string& parameter) {
      parameters += (parameters.empty() ? "" : ", ") + parameter;
    };
    if (function.updated)
      add(wgsl() ? pointer(*function.updated) : "inout " + declaration(*function.updated));
    for (const CodeVariable& input : function.inputs) add(declaration(input));
    if (wgsl()) {
      std::string text = "fn " + function.name + "(" + parameters + ")";
      if (function.result) text += " -> " + type(*function.result);
      text += " {\n";
      if (function.result)
        text += statement("var " + function.result->name + ": " + type(*function.result) + ";");
      return text;
    }
    const bool returned = function.result && function.result->type == CodeType::kColour;
    if (function.result && !returned) add("out " + declaration(*function.result));
    std::string text = (returned ? colour() : "void") + " " + function.name + "(" + parameters + ") {\n";
    if (returned) text += statement(colour() + " " + function.result->name + " = " + vector({}) + ";");
    return text;
  }

  std::string functionEnd(const CodeFunction& function) const override {
    const bool returned = function.result && (wgsl() || function.result->type == CodeType::kColour);
    return (returned ? statement("return " + function.result->name + ";") : "") + "}\n";
  }

  std::string declareScalar(const std::string& name, const std::string& expression) const override {
    return statement((wgsl() ? "let " + name + ": f32" : "float " + name) + " = " + expression + ";");
  }
  std::string declareColour(const std::string& name, const ColourSum& sum) const override {
    return statement((wgsl() ? "let " + name + ": " + colour() : colour() + " " + name) + " = " + print(sum) +
                     ";");
  }
  std::string setColour(const std::string& array, int index, const ColourSum& sum) const override {
    return statement(entry(array, index) + " = " + print(sum) + ";");
  }
  // Variables of WGSL begin as zero.
  std::string clearColours(const std::string& array, int first, int end) const override {
    if (wgsl()) return "";
    return statement("for (int i = " + std::to_string(first) + "; i < " + std::to_string(end) + "; ++i) " +
                     array + "[i] = " + vector({}) + ";");
  }
  std::string addToResult(const std::string& result, const ColourTerm& term) const override {
    return statement(result + " += " + print({term}) + ";");
  }
  std::string addToUpdated(const std::string& array, int index, const ColourTerm& term) const override {
    const std::string target = wgsl() ? "(*" + array + ")" : array;
    return statement(entry(target, index) + " += " + print({term}) + ";");
  }
  std::string declareLobe() const override { return ""; }
  std::string callLobe(const std::string& function, const std::string& array, const std::string& rotation,
                       Vec3d direction, const ColourSum& amount) const override {
    const std::string turned = language_ == CodeLanguage::kHlsl
                                   ? "mul(" + rotation + ", " + vector(direction) + ")"
                                   : rotation + " * " + vector(direction);
    return statement(function + "(" + (wgsl() ? "&" : "") + array + ", " + turned + ", " + print(amount) +
                     ");");
  }

 private:
  bool wgsl() const { return language_ == CodeLanguage::kWgsl; }
  std::string colour() const {
    return wgsl() ? "vec3<f32>" : language_ == CodeLanguage::kHlsl ? "float3" : "vec3";
  }
  std::string vector(Vec3d v) const {
    return colour() + "(" + number(v.x) + ", " + number(v.y) + ", " + number(v.z) + ")";
  }
  std::string arrayType(const std::string& element, std::size_t count) const {
    return wgsl() ? "array<" + element + ", " + std::to_string(count) + ">"
                  : element + "[" + std::to_string(count) + "]";
  }
  std::string scalarType(CodeType type) const {
    switch (type) {
      case CodeType::kDirection:
      case CodeType::kColour:
      case CodeType::kColours:
        return colour();
      case CodeType::kRotation:
        return wgsl() ? "mat3x3<f32>" : language_ == CodeLanguage::kHlsl ? "float3x3" : "mat3";
      case CodeType::kScalars:
        return wgsl() ? "f32" : "float";
    }
    return "";
  }
  static bool isArray(CodeType type) { return type == CodeType::kColours || type == CodeType::kScalars; }
  std::string type(const CodeVariable& variable) const {
    const std::string element = scalarType(variable.type);
    return isArray(variable.type) ? arrayType(element, static_cast<std::size_t>(variable.count)) : element;
  }
  std::string declaration(const CodeVariable& variable) const {
    if (wgsl()) return variable.name + ": " + type(variable);
    return scalarType(variable.type) + " " + variable.name +
           (isArray(variable.type) ? "[" + std::to_string(variable.count) + "]" : "");
  }
  std::string pointer(const CodeVariable& variable) const {
    return variable.name + ": ptr<function, " + type(variable) + ">";
  }
  static std::string entry(const std::string& array, int index) {
    return index < 0 ? array : array + "[" + std::to_string(index) + "]";
  }
  static std::string print(const ColourSum& sum) {
    std::vector<std::string> terms;
    for (const ColourTerm& term : sum) {
      const std::string colour = entry(term.colour, term.index);
      terms.push_back(term.weight.empty()  ? colour
                      : term.weight == "-" ? "-" + colour
                                           : term.weight + " * " + colour);
    }
    return joinSum(terms);
  }

  CodeLanguage language_;
};

}  // namespace

std::unique_ptr<Dialect> makeShaderDialect(CodeLanguage language) {
  assert(language != CodeLanguage::kC);
  return std::make_unique<ShaderDialect>(language);
}

}  // namespace shprt
