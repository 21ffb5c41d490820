// Cameras from text: "eye:0,1,3 target:0,0,0 fov:40" or "orbit:azimuth,elevation,distance".
#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "shprt/base/error.h"
#include "shprt/picture/camera_fit.h"
#include "shprt/picture/render.h"

namespace shprt {
namespace {

constexpr double kSmallestFov = 0.1, kLargestFov = 170;

[[noreturn]] void refuse(const std::string& specification, const std::string& problem) {
  throw Error("camera '" + specification + "'", problem,
              "give eye:x,y,z target:x,y,z up:x,y,z fov:degrees (each optional), or "
              "orbit:azimuth,elevation[,distance]");
}

using Fields = std::map<std::string, std::vector<double>>;

std::vector<double> parseNumbers(std::string_view text, const std::string& specification,
                                 const std::string& field) {
  std::vector<double> numbers;
  while (true) {
    const std::string_view item = text.substr(0, text.find(','));
    double number = 0;
    const auto [end, error] = std::from_chars(item.data(), item.data() + item.size(), number);
    if (error != std::errc{} || end != item.data() + item.size() || !std::isfinite(number)) {
      refuse(specification, "'" + std::string(item) + "' in " + field + " is not a number");
    }
    numbers.push_back(number);
    if (item.size() == text.size()) return numbers;
    text.remove_prefix(item.size() + 1);
  }
}

Fields parseFields(const std::string& specification) {
  Fields fields;
  std::string_view rest = specification;
  while (!rest.empty()) {
    const std::string_view word = rest.substr(0, rest.find_first_of(" ;\t"));
    rest.remove_prefix(std::min(rest.size(), word.size() + 1));
    if (word.empty()) continue;
    const std::size_t colon = word.find(':');
    if (colon == std::string_view::npos) refuse(specification, "'" + std::string(word) + "' has no ':'");
    const std::string name(word.substr(0, colon));
    if (name != "eye" && name != "target" && name != "up" && name != "fov" && name != "orbit") {
      refuse(specification, "unknown field '" + name + "'");
    }
    if (!fields.emplace(name, parseNumbers(word.substr(colon + 1), specification, name)).second) {
      refuse(specification, name + " is given twice");
    }
  }
  if (fields.empty()) refuse(specification, "is empty");
  return fields;
}

std::optional<Vec3d> vectorField(const Fields& fields, const std::string& name,
                                 const std::string& specification) {
  const auto found = fields.find(name);
  if (found == fields.end()) return std::nullopt;
  if (found->second.size() != 3) refuse(specification, name + " needs three numbers");
  return Vec3d{found->second[0], found->second[1], found->second[2]};
}

Camera orbitCamera(const std::vector<double>& orbit, double fov, std::span<const Vec3f> positions,
                   double aspect, const std::string& specification) {
  if (orbit.size() != 2 && orbit.size() != 3) refuse(specification, "orbit needs two or three numbers");
  if (std::fabs(orbit[1]) > 90) refuse(specification, "the elevation is outside -90 to 90 degrees");
  const double distance = orbit.size() == 3 ? orbit[2] : 1;
  if (!(distance > 0)) refuse(specification, "the distance must be above 0");
  const OrbitDirection direction = orbitDirection(orbit[0], orbit[1]);
  Camera camera = fitCamera(positions, direction.toEye, direction.up, fov, aspect);
  camera.eye = camera.target + (camera.eye - camera.target) * distance;
  return camera;
}

}  // namespace

Camera parseCamera(const std::string& specification, std::span<const Vec3f> positions, double aspect) {
  const Fields fields = parseFields(specification);
  double fov = Camera{}.verticalFovDegrees;
  if (const auto found = fields.find("fov"); found != fields.end()) {
    if (found->second.size() != 1) refuse(specification, "fov needs one number");
    fov = found->second[0];
    if (!(fov >= kSmallestFov && fov <= kLargestFov))
      refuse(specification, "fov is outside 0.1 to 170 degrees");
  }
  const auto eye = vectorField(fields, "eye", specification);
  const auto target = vectorField(fields, "target", specification);
  const auto up = vectorField(fields, "up", specification);
  if (const auto orbit = fields.find("orbit"); orbit != fields.end()) {
    if (eye || target || up) refuse(specification, "orbit excludes eye, target and up");
    return orbitCamera(orbit->second, fov, positions, aspect, specification);
  }

  // What is not given comes from the automatic camera, framed again where the eye is free.
  const Camera automatic = frameCamera(positions, aspect);
  const Vec3d upWanted = up.value_or(Vec3d{0, 1, 0});
  Camera camera = fitCamera(positions, automatic.eye - automatic.target, upWanted, fov, aspect);
  const Vec3d offset = camera.eye - camera.target;
  if (target) camera.target = *target;
  camera.eye = eye ? *eye : camera.target + offset;
  camera.up = upWanted;

  const Vec3d view = camera.eye - camera.target;
  if (view == Vec3d{}) refuse(specification, "eye and target are the same point");
  if (length(cross(normalize(view), normalize(upWanted))) < 1e-9) {
    refuse(specification, "up is zero or points along the view");
  }
  return camera;
}

}  // namespace shprt
