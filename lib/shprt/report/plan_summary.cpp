#include "shprt/report/plan_summary.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "shprt/base/json_input.h"

namespace shprt {
namespace {

std::string textOf(const nlohmann::json& effect, const char* field) {
  const auto found = effect.find(field);
  if (found == effect.end() || !found->is_string()) return "";
  std::string text = found->get<std::string>();
  // Texts come from files and may go to a terminal.
  for (char& letter : text)
    if (static_cast<unsigned char>(letter) < ' ' || letter == 0x7f) letter = ' ';
  return text;
}

// An effect may be called for and yet not simulated, and the other way round where the user asked for it.
std::string verdict(const nlohmann::json& effect) {
  const auto truth = [&](const char* field) -> const bool* {
    const auto found = effect.find(field);
    return found == effect.end() ? nullptr : found->get_ptr<const bool*>();
  };
  const bool* needed = truth("needed");
  const bool* simulated = truth("simulated");
  if (!needed) return !simulated ? "" : *simulated ? "simulated" : "skipped";
  if (*needed) return simulated && !*simulated ? "needed, but not simulated" : "needed";
  return simulated && *simulated ? "simulated, though not needed" : "skipped";
}

PlannedEffect summarise(const nlohmann::json& effect) {
  PlannedEffect summary{textOf(effect, "effect"), verdict(effect)};
  if (summary.effect.empty()) summary.effect = "effect";
  const std::string evidence = textOf(effect, "evidence");
  if (!evidence.empty()) summary.what += (summary.what.empty() ? "" : ": ") + evidence;
  const auto contribution = effect.find("contribution");
  if (contribution != effect.end() && contribution->is_number())
    summary.what +=
        fmt::format("{}contribution {:.3g}", summary.what.empty() ? "" : "; ", contribution->get<double>());
  return summary;
}

}  // namespace

std::vector<PlannedEffect> summarisePlan(const std::string& plan) {
  std::vector<PlannedEffect> summaries;
  const nlohmann::json content = plan.empty() ? nlohmann::json() : parseJson(plan);
  if (!content.is_object()) return summaries;
  const auto effects = content.find("effects");
  if (effects == content.end() || !effects->is_array()) return summaries;
  for (const nlohmann::json& effect : *effects)
    if (effect.is_object()) summaries.push_back(summarise(effect));
  return summaries;
}

}  // namespace shprt
