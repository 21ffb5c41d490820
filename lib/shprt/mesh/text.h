// Reading text mesh files: lines and tokens as views, numbers without a locale.
#pragma once

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>

namespace shprt {

constexpr bool isBlank(char c) {
  return c == ' ' || c == '\t' || c == '\v' || c == '\f';
}

inline std::string_view trimBlanks(std::string_view text) {
  while (!text.empty() && isBlank(text.front())) text.remove_prefix(1);
  while (!text.empty() && isBlank(text.back())) text.remove_suffix(1);
  return text;
}

// Takes the next line off the front of text, whichever way it ends: LF, CR or CRLF.
inline std::string_view takeLine(std::string_view& text) {
  const std::size_t end = text.find_first_of("\r\n");
  const std::string_view line = text.substr(0, end);
  if (end == std::string_view::npos) {
    text = {};
  } else {
    text.remove_prefix(end + (text.substr(end, 2) == "\r\n" ? 2 : 1));
  }
  return line;
}

// Takes the next blank-separated token off the front of a line; empty at its end.
inline std::string_view takeToken(std::string_view& line) {
  while (!line.empty() && isBlank(line.front())) line.remove_prefix(1);
  std::size_t length = 0;
  while (length < line.size() && !isBlank(line[length])) ++length;
  const std::string_view token = line.substr(0, length);
  line.remove_prefix(length);
  return token;
}

// Takes the last blank-separated token off the back of a line; empty when there is none.
inline std::string_view takeLastToken(std::string_view& line) {
  line = trimBlanks(line);
  std::size_t begin = line.size();
  while (begin > 0 && !isBlank(line[begin - 1])) --begin;
  const std::string_view token = line.substr(begin);
  line.remove_suffix(token.size());
  return token;
}

// from_chars takes no leading plus.
inline std::string_view withoutPlus(std::string_view token) {
  if (token.size() > 1 && token[0] == '+' && token[1] != '-' && token[1] != '+') token.remove_prefix(1);
  return token;
}

template <typename Integer>
std::optional<Integer> parseInteger(std::string_view token) {
  token = withoutPlus(token);
  Integer value = 0;
  const auto [end, error] = std::from_chars(token.data(), token.data() + token.size(), value);
  if (error != std::errc{} || end != token.data() + token.size() || token.empty()) return {};
  return value;
}

// Whether a number that is out of range lies near zero: its first digit that counts tells.
inline bool isTooSmall(std::string_view token) {
  const std::size_t mark = token.find_first_of("eE");
  const std::string_view mantissa = token.substr(0, mark);
  long long exponent = 0;
  if (mark != std::string_view::npos) {
    constexpr long long kBeyond = 1'000'000'000'000;  // more than any file has digits
    exponent =
        parseInteger<long long>(token.substr(mark + 1)).value_or(token[mark + 1] == '-' ? -kBeyond : kBeyond);
    exponent = std::clamp(exponent, -kBeyond, kBeyond);
  }
  const auto point = static_cast<long long>(std::min(mantissa.find('.'), mantissa.size()));
  return point - static_cast<long long>(mantissa.find_first_of("123456789")) + exponent < 0;
}

// The number of type Real nearest to what a whole token spells: infinite when it is too large, zero when it
// is too small, nothing when it is no number.
template <typename Real>
std::optional<Real> parseReal(std::string_view token) {
  token = withoutPlus(token);
  Real value = 0;
  const auto [end, error] = std::from_chars(token.data(), token.data() + token.size(), value);
  if (end != token.data() + token.size() || token.empty()) return {};
  if (error == std::errc::result_out_of_range)
    return isTooSmall(token) ? Real{0} : std::numeric_limits<Real>::infinity();
  if (error != std::errc{}) return {};
  return value;
}

// A number that float can hold.
inline std::optional<float> parseFloat(std::string_view token) {
  const std::optional<float> value = parseReal<float>(token);
  return value && std::isfinite(*value) ? value : std::nullopt;
}

// Appends the shortest text that reads back as the same float.
inline void appendFloat(std::string& text, float value) {
  char buffer[32];
  text.append(buffer, std::to_chars(buffer, buffer + sizeof buffer, value).ptr);
}

inline void appendInteger(std::string& text, long long value) {
  char buffer[32];
  text.append(buffer, std::to_chars(buffer, buffer + sizeof buffer, value).ptr);
}

// A token for an error message: printable, and not too long.
inline std::string shownToken(std::string_view token) {
  std::string shown(token.substr(0, 24));
  for (char& c : shown) {
    if (static_cast<unsigned char>(c) < 0x20 || static_cast<unsigned char>(c) > 0x7e) c = '?';
  }
  return token.size() > 24 ? shown + "..." : shown;
}

}  // namespace shprt
