#include "options.h"

#include <fmt/core.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <string_view>
#include <vector>

#include "shprt/base/error.h"
#include "shprt/sh/basis.h"
#include "shprt/sh/rotation.h"

namespace shprt {
namespace {

constexpr int kLargestPictureSide = 16384;
constexpr double kLargestExposure = 60;
constexpr int kLargestThreadCount = 4096;

template <typename Number>
std::optional<Number> parseWhole(std::string_view text) {
  Number number{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return number;
}

[[noreturn]] void refuse(const std::string& name, const std::string& text, const std::string& wanted) {
  throw CLI::ValidationError(name, "'" + text + "' is not " + wanted);
}

int parseInteger(const std::string& name, const std::string& text, int minimum, int maximum) {
  const std::optional<int> number = parseWhole<int>(text);
  if (!number || *number < minimum || *number > maximum) {
    refuse(name, text, fmt::format("a whole number from {} to {}", minimum, maximum));
  }
  return *number;
}

double parseNumber(const std::string& name, const std::string& text, double minimum, double maximum) {
  const std::optional<double> number = parseWhole<double>(text);
  if (!number || !(*number >= minimum && *number <= maximum)) {
    refuse(name, text,
           std::isinf(maximum) ? fmt::format("a finite number, {:g} or more", minimum)
                               : fmt::format("a number from {:g} to {:g}", minimum, maximum));
  }
  return *number;
}

std::string rangeName(double minimum, double maximum) {
  return std::isinf(maximum) ? fmt::format("{:g}..", minimum) : fmt::format("{:g}..{:g}", minimum, maximum);
}

CLI::Option* addText(CLI::App& app, const std::string& name, const std::string& typeName,
                     const std::function<void(const std::string&)>& take, const std::string& description) {
  return app.add_option_function<std::string>(name, take, description)->type_name(typeName);
}

}  // namespace

CLI::Option* addInteger(CLI::App& app, const std::string& name, int& value, int minimum, int maximum,
                        const std::string& description) {
  const auto take = [=, &value](const std::string& text) {
    value = parseInteger(name, text, minimum, maximum);
  };
  return addText(app, name, rangeName(minimum, maximum), take, description)
      ->default_str(std::to_string(value));
}

CLI::Option* addInteger(CLI::App& app, const std::string& name, std::optional<int>& value, int minimum,
                        int maximum, const std::string& description) {
  const auto take = [=, &value](const std::string& text) {
    value = parseInteger(name, text, minimum, maximum);
  };
  return addText(app, name, rangeName(minimum, maximum), take, description);
}

CLI::Option* addSeed(CLI::App& app, std::uint64_t& seed) {
  const auto take = [&seed](const std::string& text) {
    const std::optional<std::uint64_t> number = parseWhole<std::uint64_t>(text);
    if (!number) refuse("--seed", text, "a whole number from 0 to 18446744073709551615");
    seed = *number;
  };
  return addText(app, "--seed", "N", take, "Seed of all random numbers")->default_str(std::to_string(seed));
}

CLI::Option* addNumber(CLI::App& app, const std::string& name, double& value, double minimum, double maximum,
                       const std::string& description) {
  const auto take = [=, &value](const std::string& text) {
    value = parseNumber(name, text, minimum, maximum);
  };
  return addText(app, name, rangeName(minimum, maximum), take, description)
      ->default_str(fmt::format("{:g}", value));
}

CLI::Option* addNumber(CLI::App& app, const std::string& name, std::optional<double>& value, double minimum,
                       double maximum, const std::string& description) {
  const auto take = [=, &value](const std::string& text) {
    value = parseNumber(name, text, minimum, maximum);
  };
  return addText(app, name, rangeName(minimum, maximum), take, description);
}

CLI::Option* addIntegerOrAuto(CLI::App& app, const std::string& name, std::optional<int>& value, int minimum,
                              int maximum, const std::string& description) {
  const auto take = [=, &value](const std::string& text) {
    if (text == "auto") {
      value.reset();
      return;
    }
    const std::optional<int> number = parseWhole<int>(text);
    if (!number || *number < minimum || *number > maximum)
      refuse(name, text, fmt::format("a whole number from {} to {}, or auto", minimum, maximum));
    value = number;
  };
  return addText(app, name, fmt::format("{}..{}|auto", minimum, maximum), take, description)
      ->default_str(value ? std::to_string(*value) : "auto");
}

CLI::Option* addBytes(CLI::App& app, const std::string& name, std::uint64_t& bytes,
                      const std::string& description) {
  static constexpr std::string_view kUnits = "KMGT";
  const auto take = [=, &bytes](const std::string& text) {
    std::string_view digits = text;
    const std::size_t unit = text.empty() ? std::string_view::npos : kUnits.find(text.back());
    if (unit != std::string_view::npos) digits.remove_suffix(1);
    const int shift = unit == std::string_view::npos ? 0 : 10 * (static_cast<int>(unit) + 1);
    const std::optional<std::uint64_t> number = parseWhole<std::uint64_t>(digits);
    if (!number || *number > (std::numeric_limits<std::uint64_t>::max() >> shift))
      refuse(name, text, "a number of bytes such as 500M or 2G");
    bytes = *number << shift;
  };
  return addText(app, name, "SIZE", take, description);
}

CLI::Option* addColour(CLI::App& app, const std::string& name, std::optional<Vec3f>& value, double minimum,
                       double maximum, const std::string& description) {
  const auto take = [=, &value](const std::string& text) {
    std::vector<float> channels;
    std::size_t begin = 0;
    while (begin <= text.size()) {
      const std::size_t end = std::min(text.find(',', begin), text.size());
      const std::optional<double> number =
          parseWhole<double>(std::string_view(text).substr(begin, end - begin));
      if (!number || !(*number >= minimum && *number <= maximum)) break;
      channels.push_back(static_cast<float>(*number));
      begin = end + 1;
    }
    const bool complete = begin == text.size() + 1 && (channels.size() == 1 || channels.size() == 3);
    if (!complete) {
      refuse(name, text, fmt::format("one number, or three as r,g,b, from {:g} to {:g}", minimum, maximum));
    }
    value = Vec3f{channels.front(), channels[channels.size() / 2], channels.back()};
  };
  return addText(app, name, "R,G,B", take, description);
}

CLI::Option* addSize(CLI::App& app, const std::string& name, int& width, int& height,
                     const std::string& description) {
  const auto take = [=, &width, &height](const std::string& text) {
    const std::size_t cross = std::min(text.find('x'), text.size());
    const std::optional<int> w = parseWhole<int>(std::string_view(text).substr(0, cross));
    const std::optional<int> h =
        parseWhole<int>(std::string_view(text).substr(std::min(cross + 1, text.size())));
    const auto fits = [](const std::optional<int>& side) {
      return side && *side >= 1 && *side <= kLargestPictureSide;
    };
    if (!fits(w) || !fits(h))
      refuse(name, text, fmt::format("WIDTHxHEIGHT, each from 1 to {}", kLargestPictureSide));
    width = *w;
    height = *h;
  };
  return addText(app, name, "WxH", take, description)->default_str(fmt::format("{}x{}", width, height));
}

CLI::Option* addParsed(CLI::App& app, const std::string& name, const std::string& typeName,
                       const std::function<void(const std::string&)>& parse, const std::string& description) {
  const auto take = [=](const std::string& text) {
    try {
      parse(text);
    } catch (const Error& error) {
      throw CLI::ValidationError(name, error.what());
    }
  };
  return addText(app, name, typeName, take, description);
}

void noteCorrection(const Console& console, const std::optional<RotationArgument>& rotation) {
  constexpr double kWorthTelling = 1e-12;
  if (!rotation || rotation->correction <= kWorthTelling) return;
  console.note(fmt::format("--rotate: the matrix is off by {:.2g}; the rotation nearest to it is used",
                           rotation->correction));
}

CLI::Option* addRotation(CLI::App& app, std::optional<RotationArgument>& rotation) {
  // Whether it is a rotation at all is judged here and not after minutes of other work.
  const auto parse = [&rotation](const std::string& text) {
    const NearestRotation nearest = parseNearestRotation(text);
    const std::size_t mark = text.find_first_not_of(" \t");
    const bool named = mark != std::string::npos && text[mark] == '@';
    rotation = RotationArgument{nearest.rotation, nearest.correction, named ? text.substr(mark + 1) : ""};
  };
  return addParsed(
      app, "--rotate", "SPEC", parse,
      "Turn the light: axis:x,y,z,degrees | quat:w,x,y,z | euler:zyz,a,b,c | matrix:nine numbers in rows | "
      "@FILE that holds one of these");
}

CLI::Option* addExposure(CLI::App& app, std::optional<double>& exposure, const std::string& description) {
  return addNumber(app, "--exposure", exposure, -kLargestExposure, kLargestExposure, description);
}

CLI::Option* addDegree(CLI::App& app, int& degree) {
  return addInteger(app, "--degree", degree, 0, kMaximumBakeDegree, "Highest spherical-harmonic band");
}

CLI::Option* addRays(CLI::App& app, int& rays) {
  constexpr int kMostRays = 65536;
  return addInteger(app, "--rays", rays, 1, kMostRays, "Rays per vertex");
}

void addLoadingOptions(CLI::App& app, LoadSceneOptions& loading) {
  addColour(app, "--albedo", loading.albedo, 0, 1,
            "Albedo of everything, one number or r,g,b (default: as the materials say, else 0.8)");
  app.add_flag("--two-sided", loading.twoSided, "Bake both sides of every triangle");
  addNumber(app, "--crease-angle", loading.creaseAngleDegrees, 0, 180,
            "Compute normals even where the file has some; edges sharper than this many degrees stay hard");
}

void addCommonOptions(CLI::App& app, CommonOptions& common) {
  app.add_flag("-q,--quiet", common.quiet, "Print nothing but errors");
  app.add_option("--json", common.jsonFile, "Write the figures as JSON; - for standard output")
      ->type_name("FILE");
}

CLI::Option* addThreads(CLI::App& app, int& threads) {
  return addInteger(app, "--threads", threads, 0, kLargestThreadCount,
                    "Worker threads, 0 for one per core; results do not depend on it");
}

}  // namespace shprt
