#include "shprt/study/section_parts.h"

#include <fmt/format.h>

#include <cmath>

namespace shprt {

std::string shortNumber(double number) {
  if (!(std::abs(number) >= 10)) return fmt::format("{:.2g}", number);
  const double unit = std::pow(10, std::floor(std::log10(std::abs(number))) - 1);
  return fmt::format("{:.0f}", std::round(number / unit) * unit);
}

}  // namespace shprt
