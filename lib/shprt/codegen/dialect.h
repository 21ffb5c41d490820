// What differs between the languages of generated code. Statements come out indented, with their line ends.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "shprt/base/vec.h"
#include "shprt/codegen/generate.h"

namespace shprt {

enum class CodeType { kDirection, kRotation, kColour, kColours, kScalars };

struct CodeVariable {
  CodeType type;
  std::string name;
  int count = 1;  // of kColours and kScalars
};

struct CodeFunction {
  std::string name;
  std::vector<CodeVariable> inputs;
  std::optional<CodeVariable> updated;  // an array that the function adds to
  std::optional<CodeVariable> result;
};

// weight * colour, where the colour is a variable or, with an index, an entry of an array of colours. An
// empty weight is 1, a mere minus sign -1.
struct ColourTerm {
  std::string weight, colour;
  int index = -1;
};
using ColourSum = std::vector<ColourTerm>;

class Dialect {
 public:
  virtual ~Dialect() = default;

  virtual std::string number(double value) const = 0;
  virtual std::string component(const std::string& direction, int axis) const = 0;
  virtual std::string rotationEntry(const std::string& rotation, int row, int column) const = 0;

  // The file around its content.
  virtual std::string wrapped(const std::string& content) const = 0;
  // Small functions that the statements below call, each with an empty line after it.
  virtual std::string helpers(const CodeRequest& request) const = 0;
  virtual std::string constantColours(const std::string& name, const std::vector<Vec3d>& colours) const = 0;

  // usesInputs tells whether the body reads its inputs at all.
  virtual std::string functionBegin(const CodeFunction& function, bool usesInputs) const = 0;
  virtual std::string functionEnd(const CodeFunction& function) const = 0;
  virtual std::string declareScalar(const std::string& name, const std::string& expression) const = 0;
  virtual std::string declareColour(const std::string& name, const ColourSum& sum) const = 0;
  virtual std::string setColour(const std::string& array, int index, const ColourSum& sum) const = 0;
  // Sets entries first .. end-1 of the array that is the result of the function to zero.
  virtual std::string clearColours(const std::string& array, int first, int end) const = 0;
  // Adds one term to the result of the function, which is a colour.
  virtual std::string addToResult(const std::string& result, const ColourTerm& term) const = 0;
  // Adds one term to an entry of the array that the function updates.
  virtual std::string addToUpdated(const std::string& array, int index, const ColourTerm& term) const = 0;
  // What callLobe needs declared once in its function.
  virtual std::string declareLobe() const = 0;
  // Calls function(array, rotation * direction, amount).
  virtual std::string callLobe(const std::string& function, const std::string& array,
                               const std::string& rotation, Vec3d direction,
                               const ColourSum& amount) const = 0;
};

// Throws nothing; doublePrecision is for C only.
std::unique_ptr<Dialect> makeDialect(CodeLanguage language, bool doublePrecision);
std::unique_ptr<Dialect> makeCDialect(bool doublePrecision);
std::unique_ptr<Dialect> makeShaderDialect(CodeLanguage language);

// The shortest decimal that reads back as the same float (or double), always with a point or an exponent.
std::string shortestDecimal(double value, bool doublePrecision);
// "a + b - c" from terms of which some begin with a minus sign.
std::string joinSum(const std::vector<std::string>& terms);
// A statement at the given depth of two blanks each, broken before + and - where it is over 100 columns.
std::string statement(const std::string& text, int depth = 1);

}  // namespace shprt
