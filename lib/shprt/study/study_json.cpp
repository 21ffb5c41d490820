#include "shprt/study/study_json.h"

#include <nlohmann/json.hpp>
#include <utility>
#include <vector>

namespace shprt {
namespace {

using Json = nlohmann::ordered_json;

template <typename Value>
Json byName(const std::vector<std::pair<std::string, Value>>& list) {
  Json object = Json::object();
  for (const auto& [name, value] : list) object[name] = value;
  return object;
}

Json curveToJson(const StudyCurve& curve) {
  Json json = {{"name", curve.name}, {"slope", nullptr}, {"points", Json::array()}};
  if (curve.slope) json["slope"] = *curve.slope;
  for (const auto& [x, y] : curve.points) json["points"].push_back(Json::array({x, y}));
  return json;
}

Json chartToJson(const StudyChart& chart) {
  Json json = {{"id", chart.id},
               {"title", chart.title},
               {"x", {{"label", chart.xLabel}, {"logarithmic", chart.logX}}},
               {"y", {{"label", chart.yLabel}, {"logarithmic", chart.logY}}},
               {"curves", Json::array()}};
  for (const StudyCurve& curve : chart.curves) json["curves"].push_back(curveToJson(curve));
  return json;
}

Json tableToJson(const StudyTable& table) {
  Json json = {{"id", table.id}, {"title", table.title}, {"columns", table.columns}, {"rows", Json::array()}};
  for (const std::vector<std::string>& row : table.rows) json["rows"].push_back(row);
  return json;
}

Json sectionToJson(const StudySection& section) {
  Json json = {{"id", section.id}, {"title", section.title}, {"text", section.text}};
  if (!section.missing.empty()) json["missing"] = section.missing;
  json["charts"] = Json::array();
  for (const StudyChart& chart : section.charts) json["charts"].push_back(chartToJson(chart));
  json["tables"] = Json::array();
  for (const StudyTable& table : section.tables) json["tables"].push_back(tableToJson(table));
  json["figures"] = byName(section.figures);
  return json;
}

}  // namespace

std::string studyToJson(const Study& study) {
  Json json = {{"format", "shprt-study"},
               {"version", 1},
               {"title", study.title},
               {"facts", byName(study.facts)},
               {"headlines", byName(study.headlines)},
               {"sections", Json::array()}};
  for (const StudySection& section : study.sections) json["sections"].push_back(sectionToJson(section));
  return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace shprt
