#include "shprt/study/study_facts.h"

#include <fmt/core.h>

#include <algorithm>
#include <ctime>
#include <fstream>
#include <thread>

#include "shprt/base/parallel.h"
#include "shprt/base/version.h"

namespace shprt {
namespace {

std::string describeModel(const EffectPlan& plan) {
  if (plan.model == "interreflected" && plan.bounces > 0)
    return fmt::format("{}, {} {}", plan.model, plan.bounces, plan.bounces == 1 ? "bounce" : "bounces");
  return plan.model;
}

std::string today() {
  const std::time_t now = std::time(nullptr);
  std::tm date{};
  gmtime_r(&now, &date);
  return fmt::format("{:04}-{:02}-{:02}", date.tm_year + 1900, date.tm_mon + 1, date.tm_mday);
}

}  // namespace

std::string processorName() {
  std::ifstream information("/proc/cpuinfo");
  for (std::string line; std::getline(information, line);) {
    const std::size_t colon = line.find(": ");
    if (line.starts_with("model name") && colon != std::string::npos) return line.substr(colon + 2);
  }
  return "unknown";
}

std::vector<std::pair<std::string, std::string>> studyFacts(const StudyRun& run) {
  const Scene& scene = run.prepared.scene;
  const StudyOptions& options = run.options;
  const auto receivers = std::count_if(scene.mesh.triangles.begin(), scene.mesh.triangles.end(),
                                       [&](const auto& triangle) { return scene.isReceiver(triangle[0]); });
  return {{"scene", run.arguments},
          {"vertices", fmt::format("{}, of them {} with geometry above their tangent plane",
                                   run.plan.vertices, run.plan.verticesBelow)},
          {"triangles", fmt::format("{}", receivers)},
          {"light", run.light ? run.light->arguments : "none: errors are those of the transfer"},
          {"model planned", describeModel(run.plan)},
          {"settings", fmt::format("degree {}, {} rays, error {:g}, seed {}{}", run.plan.degree, options.rays,
                                   options.error, options.seed, options.quick ? ", --quick" : "")},
          {"processor", processorName()},
          {"cores", fmt::format("{}, {} threads used", std::thread::hardware_concurrency(), threadCount())},
          {"version", std::string("shprt ") + kVersion},
          {"date", today()}};
}

}  // namespace shprt
