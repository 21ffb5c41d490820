#include "shprt/scene/read_transform.h"

#include <cmath>
#include <string>

#include "shprt/base/json_input.h"

namespace shprt {
namespace {

Transform readMatrix(const JsonObject& entry, std::string_view field) {
  const nlohmann::json& entries = entry.field(field);
  if (!entries.is_array() || entries.size() != 16)
    entry.fail(field, "does not have 16 numbers", "write the four rows of the matrix as one list");
  double m[16];
  for (std::size_t i = 0; i < 16; ++i) {
    if (!entries[i].is_number() || !std::isfinite(entries[i].get<double>()))
      entry.fail(std::string(field) + "[" + std::to_string(i) + "]", "is no finite number");
    m[i] = entries[i].get<double>();
  }
  if (m[12] != 0 || m[13] != 0 || m[14] != 0 || m[15] != 1)
    entry.fail(field, "does not end with 0, 0, 0, 1",
               "write the matrix row by row, the translation in numbers 4, 8 and 12");
  return {{{{m[0], m[1], m[2]}, {m[4], m[5], m[6]}, {m[8], m[9], m[10]}}}, {m[3], m[7], m[11]}};
}

Mat3 readScale(const JsonObject& entry) {
  const nlohmann::json& value = entry.field("scale");
  if (!value.is_number() && !value.is_array())
    entry.fail("scale", "is neither a number nor a list", "write 2 or [2, 1, 1]");
  std::array<double, 3> factors{};
  if (value.is_array()) {
    factors = entry.triple("scale");
  } else {
    factors.fill(entry.number("scale"));
  }
  for (const double factor : factors)
    if (factor == 0) entry.fail("scale", "is zero", "nothing would be left; give another factor");
  return {{{factors[0], 0, 0}, {0, factors[1], 0}, {0, 0, factors[2]}}};
}

Mat3 readRotation(const JsonObject& entry) {
  const JsonObject rotation = entry.object("rotate");
  rotation.allowOnly({"axis", "degrees"});
  const auto [x, y, z] = rotation.triple("axis");
  if (x == 0 && y == 0 && z == 0) rotation.fail("axis", "is zero", "give a direction, as [0, 1, 0]");
  return rotationAbout({x, y, z}, rotation.number("degrees"));
}

Transform readParts(const JsonObject& parts) {
  parts.allowOnly({"translate", "rotate", "scale", "matrix"});
  if (parts.has("matrix")) {
    if (parts.has("translate") || parts.has("rotate") || parts.has("scale"))
      parts.fail("matrix", "is given beside other parts", "give either the matrix or the parts");
    return readMatrix(parts, "matrix");
  }
  Transform transform;
  if (parts.has("scale")) transform.linear = readScale(parts);
  if (parts.has("rotate")) transform.linear = readRotation(parts) * transform.linear;
  if (parts.has("translate")) {
    const auto [x, y, z] = parts.triple("translate");
    transform.translation = {x, y, z};
  }
  return transform;
}

}  // namespace

Transform readTransform(const JsonObject& entry, std::string_view field) {
  const Transform transform =
      entry.field(field).is_array() ? readMatrix(entry, field) : readParts(entry.object(field));
  if (isSingular(transform.linear))
    entry.fail(field, "is singular: it makes solid things flat", "give an invertible one");
  return transform;
}

}  // namespace shprt
