#include "shprt/codegen/dialect.h"

#include <array>
#include <cassert>
#include <charconv>

namespace shprt {

std::string shortestDecimal(double value, bool doublePrecision) {
  std::array<char, 32> digits{};
  char* const first = digits.data();
  char* const last = first + digits.size();
  const auto end = doublePrecision ? std::to_chars(first, last, value)
                                   : std::to_chars(first, last, static_cast<float>(value));
  std::string text(first, end.ptr);
  if (text.find_first_of(".e") == std::string::npos) text += ".0";
  return text;
}

std::string joinSum(const std::vector<std::string>& terms) {
  std::string sum;
  for (const std::string& term : terms) {
    if (sum.empty()) {
      sum = term;
    } else if (term.front() == '-') {
      sum += " - " + term.substr(1);
    } else {
      sum += " + " + term;
    }
  }
  return sum;
}

std::string statement(const std::string& text, int depth) {
  constexpr std::size_t kColumns = 100;
  std::string indent(2 * static_cast<std::size_t>(depth), ' ');
  std::string lines, rest = text;
  while (indent.size() + rest.size() > kColumns) {
    std::size_t cut = std::string::npos;
    // Breaks go between the terms of a sum, not inside its brackets.
    int depthOfBrackets = 0;
    for (std::size_t i = 0; i + 2 < rest.size() && indent.size() + i <= kColumns; ++i) {
      if (rest[i] == '(' || rest[i] == '[') ++depthOfBrackets;
      if (rest[i] == ')' || rest[i] == ']') --depthOfBrackets;
      const bool sign = rest[i] == ' ' && (rest[i + 1] == '+' || rest[i + 1] == '-') && rest[i + 2] == ' ';
      if (sign && depthOfBrackets == 0) cut = i;
    }
    if (cut == std::string::npos) break;
    lines += indent + rest.substr(0, cut) + "\n";
    rest = rest.substr(cut + 1);
    if (lines.find('\n') == lines.size() - 1) indent += "    ";
  }
  return lines + indent + rest + "\n";
}

std::unique_ptr<Dialect> makeDialect(CodeLanguage language, bool doublePrecision) {
  assert(language == CodeLanguage::kC || !doublePrecision);
  return language == CodeLanguage::kC ? makeCDialect(doublePrecision) : makeShaderDialect(language);
}

}  // namespace shprt
