// The text form of a rotation.

#include <charconv>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <string_view>
#include <vector>

#include "shprt/base/error.h"
#include "shprt/base/file.h"
#include "shprt/sh/rotation.h"

namespace shprt {
namespace {

constexpr const char* kForms =
    "use axis:x,y,z,degrees  quat:w,x,y,z  euler:zyz,a,b,c  matrix:nine numbers  or @FILE";

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view kBlank = " \t\r\n";
  const std::size_t first = text.find_first_not_of(kBlank);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(kBlank) - first + 1);
}

// Numbers separated by commas or white space.
std::vector<double> parseNumbers(std::string_view text, std::size_t count, const std::string& specification) {
  std::vector<double> numbers;
  while (!(text = trimmed(text)).empty()) {
    if (text.front() == '+') text.remove_prefix(1);
    double number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc{} || !std::isfinite(number)) {
      throw Error("rotation '" + specification + "'",
                  "'" + std::string(text) + "' does not begin with a finite number", kForms);
    }
    numbers.push_back(number);
    text = trimmed(text.substr(static_cast<std::size_t>(end - text.data())));
    if (!text.empty() && text.front() == ',') {
      text = trimmed(text.substr(1));
      if (text.empty()) throw Error("rotation '" + specification + "'", "ends in a comma", kForms);
    }
  }
  if (numbers.size() != count) {
    throw Error(
        "rotation '" + specification + "'",
        "has " + std::to_string(numbers.size()) + " numbers where " + std::to_string(count) + " belong",
        kForms);
  }
  return numbers;
}

// Exact at multiples of 90 degrees.
CosineSine ofDegrees(double degrees) {
  const double turned = std::remainder(degrees, 360.0);
  if (turned == 0) return {1, 0};
  if (turned == 90) return {0, 1};
  if (turned == -90) return {0, -1};
  if (std::abs(turned) == 180) return {-1, 0};
  const double radians = turned * std::numbers::pi / 180;
  return {std::cos(radians), std::sin(radians)};
}

// Based on: Rodrigues' formula.
Mat3 aboutAxis(Vec3d axis, double degrees) {
  const auto [c, s] = ofDegrees(degrees);
  const double t = 1 - c;
  const auto& [x, y, z] = axis;
  return {{{t * x * x + c, t * x * y - s * z, t * x * z + s * y},
           {t * x * y + s * z, t * y * y + c, t * y * z - s * x},
           {t * x * z - s * y, t * y * z + s * x, t * z * z + c}}};
}

}  // namespace

NearestRotation parseNearestRotation(const std::string& specification) {
  std::string_view text = trimmed(specification);
  std::string content;
  if (text.starts_with('@')) {
    content = readFile(std::string(text.substr(1)), 1 << 16);
    text = trimmed(content);
    if (text.starts_with('@')) throw Error(specification, "names another file", kForms);
  }
  const std::string shown(text.substr(0, 80));
  const auto complain = [&](const std::string& problem) {
    return Error("rotation '" + shown + "'", problem, kForms);
  };
  const std::size_t colon = text.find(':');
  if (colon == std::string_view::npos) throw complain("has no kind");
  const std::string_view kind = trimmed(text.substr(0, colon)), rest = text.substr(colon + 1);
  if (kind == "axis") {
    const auto n = parseNumbers(rest, 4, shown);
    const Vec3d axis = normalize({n[0], n[1], n[2]});
    if (axis == Vec3d{}) throw complain("has a zero axis");
    return {aboutAxis(axis, n[3])};
  }
  if (kind == "quat") {
    const auto n = parseNumbers(rest, 4, shown);
    if (n == std::vector<double>(4, 0.0)) throw complain("is a zero quaternion");
    return {rotationFromQuaternion(n[0], n[1], n[2], n[3])};
  }
  if (kind == "euler") {
    const std::size_t comma = rest.find(',');
    if (comma == std::string_view::npos || trimmed(rest.substr(0, comma)) != "zyz")
      throw complain("euler takes the order zyz");
    const auto n = parseNumbers(rest.substr(comma + 1), 3, shown);
    return {aboutAxis({0, 0, 1}, n[0]) * aboutAxis({0, 1, 0}, n[1]) * aboutAxis({0, 0, 1}, n[2])};
  }
  if (kind == "matrix") {
    const auto n = parseNumbers(rest, 9, shown);
    Mat3 matrix;
    for (std::size_t i = 0; i < 9; ++i) matrix.m[i / 3][i % 3] = n[i];
    return nearestRotation(matrix);
  }
  throw complain("has the unknown kind '" + std::string(kind) + "'");
}

Mat3 parseRotation(const std::string& specification) {
  return parseNearestRotation(specification).rotation;
}

}  // namespace shprt
