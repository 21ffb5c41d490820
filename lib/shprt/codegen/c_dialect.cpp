// C99, as a header of static inline functions. C has no vectors: a direction is three numbers, an array of
// colours three numbers per entry, one after the other, and the statements on colours are loops over
// channels.
#include <cstdint>
#include <string>

#include "shprt/codegen/dialect.h"

namespace shprt {
namespace {

class CDialect final : public Dialect {
 public:
  explicit CDialect(bool doublePrecision)
      : doublePrecision_(doublePrecision), real_(doublePrecision ? "double" : "float") {}

  std::string number(double value) const override {
    return shortestDecimal(value, doublePrecision_) + (doublePrecision_ ? "" : "f");
  }
  std::string component(const std::string& direction, int axis) const override {
    return direction + "[" + std::to_string(axis) + "]";
  }
  std::string rotationEntry(const std::string& rotation, int row, int column) const override {
    return rotation + "[" + std::to_string(3 * row + column) + "]";
  }

  // Two headers share their names. The same one may be included twice; of different ones the second would be
  // passed over in silence, so it is refused by what it holds.
  std::string wrapped(const std::string& content) const override {
    std::uint32_t hash = 2166136261u;  // FNV-1a
    for (const char c : content) hash = (hash ^ static_cast<unsigned char>(c)) * 16777619u;
    const std::string number = std::to_string(hash) + "u";
    return "#if !defined(SHPRT_CODE)\n#define SHPRT_CODE " + number + "\n\n" + content +
           "\n#elif SHPRT_CODE != " + number +
           "\n#error \"two generated headers share their names: generate one that holds all\"\n#endif\n";
  }

  std::string helpers(const CodeRequest& request) const override {
    const bool lobes = request.functions.rotation && request.degree > 1;
    if (!request.functions.radiance && !request.functions.irradiance && !lobes) return "";
    std::string text = "static inline void shAddColour(" + real_ + " *sum, " + real_ + " weight, const " +
                       real_ + " *colour) {\n" +
                       statement("for (int c = 0; c < 3; ++c) sum[c] += weight * colour[c];") + "}\n\n";
    if (!lobes) return text;
    return text + "static inline void shTurn(const " + real_ + " rotation[9], " + real_ + " x, " + real_ +
           " y, " + real_ + " z, " + real_ + " turned[3]) {\n" + statement("for (int i = 0; i < 3; ++i)") +
           statement("turned[i] = rotation[3 * i] * x + rotation[3 * i + 1] * y + rotation[3 * i + 2] * z;",
                     2) +
           "}\n\n";
  }

  std::string constantColours(const std::string& name, const std::vector<Vec3d>& colours) const override {
    std::string text =
        "static const " + real_ + " " + name + "[" + std::to_string(3 * colours.size()) + "] = {\n";
    for (const Vec3d& colour : colours)
      text += "  " + number(colour.x) + ", " + number(colour.y) + ", " + number(colour.z) + ",\n";
    return text + "};\n";
  }

  std::string functionBegin(const CodeFunction& function, bool usesInputs) const override {
    std::string parameters, unused;
    const auto add = [&](const CodeVariable& variable, bool constant) {
      parameters += (parameters.empty() ? "" : ", ") + std::string(constant ? "const " : "") + real_ + " " +
                    variable.name + "[" + std::to_string(count(variable)) + "]";
    };
    if (function.updated) add(*function.updated, false);
    for (const CodeVariable& input : function.inputs) {
      add(input, true);
      const bool direction = input.type == CodeType::kDirection || input.type == CodeType::kRotation;
      if (!usesInputs && direction) unused += statement("(void)" + input.name + ";");
    }
    if (function.result) add(*function.result, false);
    std::string text = "static inline void " + function.name + "(" + parameters + ") {\n" + unused;
    if (returnsColour(function)) text += statement(real_ + " sum[3] = {" + zeros() + "};");
    return text;
  }
  // The sum is kept in a local array: results might overlap coefficients, for all that the compiler knows.
  std::string functionEnd(const CodeFunction& function) const override {
    const std::string copy =
        returnsColour(function)
            ? statement("for (int c = 0; c < 3; ++c) " + function.result->name + "[c] = sum[c];")
            : "";
    return copy + "}\n";
  }

  std::string declareScalar(const std::string& name, const std::string& expression) const override {
    return statement("const " + real_ + " " + name + " = " + expression + ";");
  }
  std::string declareColour(const std::string& name, const ColourSum& sum) const override {
    return statement(real_ + " " + name + "[3];") + assignChannels(name + "[c]", sum, 1);
  }
  std::string setColour(const std::string& array, int index, const ColourSum& sum) const override {
    return assignChannels(channel({"", array, index}), sum, 1);
  }
  std::string clearColours(const std::string& array, int first, int end) const override {
    return statement("for (int i = " + std::to_string(3 * first) + "; i < " + std::to_string(3 * end) +
                     "; ++i) " + array + "[i] = " + number(0) + ";");
  }
  std::string addToResult(const std::string&, const ColourTerm& term) const override {
    return statement("shAddColour(sum, " + term.weight + ", " + pointer(term.colour, term.index) + ");");
  }
  std::string addToUpdated(const std::string& array, int index, const ColourTerm& term) const override {
    return statement("shAddColour(" + pointer(array, index) + ", " + term.weight + ", " +
                     pointer(term.colour, term.index) + ");");
  }
  std::string callLobe(const std::string& function, const std::string& array, const std::string& rotation,
                       Vec3d direction, const ColourSum& amount) const override {
    return statement("shTurn(" + rotation + ", " + number(direction.x) + ", " + number(direction.y) + ", " +
                     number(direction.z) + ", dir);") +
           assignChannels("amount[c]", amount, 1) + statement(function + "(" + array + ", dir, amount);");
  }
  std::string declareLobe() const override { return statement(real_ + " dir[3], amount[3];"); }

 private:
  static int count(const CodeVariable& variable) {
    switch (variable.type) {
      case CodeType::kRotation:
        return 9;
      case CodeType::kColours:
        return 3 * variable.count;
      case CodeType::kScalars:
        return variable.count;
      default:
        return 3;
    }
  }
  static bool returnsColour(const CodeFunction& function) {
    return function.result && function.result->type == CodeType::kColour;
  }
  std::string zeros() const { return number(0) + ", " + number(0) + ", " + number(0); }
  static std::string pointer(const std::string& array, int index) {
    return index <= 0 ? array : array + " + " + std::to_string(3 * index);
  }
  static std::string channel(const ColourTerm& term) {
    return term.colour + (term.index <= 0 ? "[c]" : "[" + std::to_string(3 * term.index) + " + c]");
  }
  static std::string assignChannels(const std::string& target, const ColourSum& sum, int depth) {
    std::vector<std::string> terms;
    for (const ColourTerm& term : sum) {
      const std::string colour = channel(term);
      terms.push_back(term.weight.empty()  ? colour
                      : term.weight == "-" ? "-" + colour
                                           : term.weight + " * " + colour);
    }
    const std::string assignment = target + " = " + joinSum(terms) + ";";
    if (assignment.size() < 64) return statement("for (int c = 0; c < 3; ++c) " + assignment, depth);
    return statement("for (int c = 0; c < 3; ++c)", depth) + statement(assignment, depth + 1);
  }

  bool doublePrecision_;
  std::string real_;
};

}  // namespace

std::unique_ptr<Dialect> makeCDialect(bool doublePrecision) {
  return std::make_unique<CDialect>(doublePrecision);
}

}  // namespace shprt
