#include "shprt/report/plan_report.h"

#include <fmt/core.h>

#include <array>
#include <nlohmann/json.hpp>
#include <string_view>
#include <utility>
#include <vector>

namespace shprt {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kEvidenceWidth = 49;

std::string shownBytes(std::uint64_t bytes) {
  if (bytes == 0) return "";
  constexpr std::array<const char*, 4> kUnits = {"B", "kB", "MB", "GB"};
  auto amount = static_cast<double>(bytes);
  std::size_t unit = 0;
  while (amount >= 999.5 && unit + 1 < kUnits.size()) {
    amount /= 1000;
    ++unit;
  }
  return fmt::format("{:.3g} {}", amount, kUnits[unit]);
}

std::string shownSeconds(double seconds) {
  return seconds > 0 ? fmt::format("{:.2g} s", seconds) : "";
}

std::string shownContribution(const EffectFinding& finding) {
  const Interval& interval = finding.contribution;
  if (interval.high <= 0) return "0";
  if (interval.low == interval.high) return fmt::format("{:.3g}", interval.value);
  return fmt::format("{:.2g} to {:.2g}", interval.low, interval.high);
}

const char* verdict(const EffectFinding& finding) {
  return !finding.needed ? "no" : finding.simulated ? "yes" : "yes*";
}

// Broken at spaces; a word that is too long stays whole.
std::vector<std::string> wrapped(std::string_view text, std::size_t width) {
  std::vector<std::string> lines;
  while (text.size() > width) {
    std::size_t end = text.rfind(' ', width);
    if (end == std::string_view::npos || end == 0) end = std::min(text.find(' ', width), text.size());
    lines.emplace_back(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  if (!text.empty() || lines.empty()) lines.emplace_back(text);
  return lines;
}

std::string row(std::string_view effect, std::string_view needed, std::string_view evidence,
                std::string_view contribution, std::string_view seconds, std::string_view bytes) {
  std::string line = fmt::format("{:<15}  {:<6}  {:<{}}  {:<16}  {:>7}  {:>7}", effect, needed, evidence,
                                 kEvidenceWidth, contribution, seconds, bytes);
  line.erase(line.find_last_not_of(' ') + 1);
  return line + "\n";
}

std::string describeBake(const EffectPlan& plan) {
  std::string text = "bake: " + plan.model;
  if (plan.model == "interreflected")
    text += fmt::format(", {} {}", plan.bounces, plan.bounces == 1 ? "bounce" : "bounces");
  text += fmt::format(", degree {}, {}", plan.degree, plan.channels == 1 ? "one channel" : "three channels");
  if (plan.model != "unshadowed") text += fmt::format(", {} rays per vertex", plan.rays);
  return text + fmt::format("\nit will take about {:.2g} s and {}; planning took {:.2g} s\n", plan.seconds,
                            shownBytes(plan.bytes), plan.planSeconds);
}

Json intervalJson(const Interval& interval) {
  return {{"value", interval.value}, {"low", interval.low}, {"high", interval.high}};
}

Json pilotJson(const BouncePilot& pilot) {
  Json bounces = Json::array();
  for (const PilotBounce& bounce : pilot.bounces) {
    Json power = Json::array();
    for (const Interval& channel : bounce.power) power.push_back(intervalJson(channel));
    bounces.push_back({{"norm", intervalJson(bounce.norm)}, {"power", power}});
  }
  return {{"vertices", pilot.vertices},
          {"paths", pilot.paths},
          {"visibility", intervalJson(pilot.visibility)},
          {"ratio", pilot.ratio},
          {"bounces", bounces},
          {"bandEnergy", pilot.bandEnergy},
          {"emission", pilot.emission},
          {"emissionReach", pilot.emissionReach},
          {"seconds", pilot.seconds}};
}

}  // namespace

std::string formatPlan(const EffectPlan& plan) {
  std::string text = row("effect", "needed", "evidence", "contribution", "seconds", "bytes");
  bool missing = false;
  for (const EffectFinding& finding : plan.findings) {
    missing |= finding.needed && !finding.simulated;
    const std::vector<std::string> evidence = wrapped(finding.evidence, kEvidenceWidth);
    text += row(finding.effect, verdict(finding), evidence.front(), shownContribution(finding),
                shownSeconds(finding.seconds), shownBytes(finding.bytes));
    for (std::size_t i = 1; i < evidence.size(); ++i) text += row("", "", evidence[i], "", "", "");
  }
  if (missing) text += "* called for, but not simulated yet\n";
  return text + describeBake(plan);
}

std::string planToJson(const EffectPlan& plan) {
  Json effects = Json::array();
  for (const EffectFinding& finding : plan.findings) {
    effects.push_back({{"effect", finding.effect},
                       {"needed", finding.needed},
                       {"simulated", finding.simulated},
                       {"evidence", finding.evidence},
                       {"contribution", finding.contribution.value},
                       {"low", finding.contribution.low},
                       {"high", finding.contribution.high},
                       {"seconds", finding.seconds},
                       {"bytes", finding.bytes}});
  }
  Json tails = Json::array();
  for (const DegreeTail& tail : plan.degreeTails)
    tails.push_back({{"degree", tail.degree}, {"transfer", tail.transfer}, {"radiance", tail.radiance}});
  const Json json = {{"format", "shprt-plan"},
                     {"version", 1},
                     {"error", plan.error},
                     {"effects", effects},
                     {"model", plan.model},
                     {"bounces", plan.bounces},
                     {"degree", plan.degree},
                     {"channels", plan.channels},
                     {"rays", plan.rays},
                     {"vertices", plan.vertices},
                     {"verticesBelow", plan.verticesBelow},
                     {"seconds", plan.seconds},
                     {"bytes", plan.bytes},
                     {"buildSeconds", plan.buildSeconds},
                     {"planSeconds", plan.planSeconds},
                     {"degreeTails", tails},
                     {"pilot", pilotJson(plan.pilot)}};
  return json.dump();
}

}  // namespace shprt
