#include "shprt/scene/material_overrides.h"

#include <array>
#include <limits>
#include <string>
#include <utility>

#include "shprt/base/json_input.h"

namespace shprt {
namespace {

constexpr float kNoLimit = std::numeric_limits<float>::max();

float checkRange(const JsonObject& entry, std::string_view field, double value, float highest) {
  if (value < 0) entry.fail(field, "is negative");
  if (value > static_cast<double>(highest))
    entry.fail(field, highest == 1 ? "is above 1" : "is beyond the range of float");
  return static_cast<float>(value);
}

float readNumber(const JsonObject& entry, std::string_view field, float highest) {
  return checkRange(entry, field, entry.number(field), highest);
}

// One number stands for three equal ones.
Vec3f readColour(const JsonObject& entry, std::string_view field, float highest) {
  const nlohmann::json& value = entry.field(field);
  if (!value.is_number() && !value.is_array())
    entry.fail(field, "is neither a number nor a list", "write 0.5 or [0.5, 0.4, 0.3]");
  std::array<double, 3> channels{};
  if (value.is_array()) {
    channels = entry.triple(field);
  } else {
    channels.fill(entry.number(field));
  }
  return {checkRange(entry, field, channels[0], highest), checkRange(entry, field, channels[1], highest),
          checkRange(entry, field, channels[2], highest)};
}

// The entry of `choices` that the field names.
template <typename Choice, std::size_t N>
Choice readChoice(const JsonObject& entry, std::string_view field,
                  const std::array<std::pair<const char*, Choice>, N>& choices) {
  const std::string text = entry.text(field);
  std::string known;
  for (const auto& [name, choice] : choices) {
    if (text == name) return choice;
    known += (known.empty() ? "" : ", ") + std::string(name);
  }
  entry.fail(field, "'" + text.substr(0, 40) + "' is not known", "use one of " + known);
}

Gloss readGloss(const JsonObject& entry) {
  entry.allowOnly({"reflectance", "roughness"});
  return {readColour(entry, "reflectance", 1), readNumber(entry, "roughness", 1)};
}

Translucency readTranslucency(const JsonObject& entry) {
  entry.allowOnly({"transmittance", "meanFreePath"});
  return {readColour(entry, "transmittance", 1), readNumber(entry, "meanFreePath", kNoLimit)};
}

}  // namespace

MaterialOverrides readMaterialOverrides(const JsonObject& entry, const std::filesystem::path& folder) {
  using ColourSpaceName = std::pair<const char*, ColourSpace>;
  using UseName = std::pair<const char*, VertexColourUse>;
  entry.allowOnly({"albedo", "texture", "textureColorSpace", "vertexColors", "twoSided", "emission", "glossy",
                   "translucent"});
  MaterialOverrides overrides;
  if (entry.has("albedo") && entry.has("texture"))
    entry.fail("albedo", "is given beside a texture", "give either of them");
  if (entry.has("albedo")) overrides.albedo = readColour(entry, "albedo", 1);
  if (entry.has("texture")) overrides.texture = {folder / entry.text("texture"), entry.placeOf("texture")};
  if (entry.has("textureColorSpace"))
    overrides.textureColourSpace = readChoice(entry, "textureColorSpace",
                                              std::array{ColourSpaceName{"srgb", ColourSpace::kSrgb},
                                                         ColourSpaceName{"linear", ColourSpace::kLinear}});
  if (entry.has("vertexColors"))
    overrides.vertexColours = readChoice(
        entry, "vertexColors",
        std::array{UseName{"srgb", VertexColourUse::kSrgb}, UseName{"linear", VertexColourUse::kLinear},
                   UseName{"ignore", VertexColourUse::kIgnore}});
  if (entry.has("twoSided")) overrides.twoSided = entry.boolean("twoSided");
  if (entry.has("emission")) overrides.emission = readColour(entry, "emission", kNoLimit);
  if (entry.has("glossy")) overrides.gloss = readGloss(entry.object("glossy"));
  if (entry.has("translucent")) overrides.translucency = readTranslucency(entry.object("translucent"));
  return overrides;
}

MaterialOverrides MaterialOverrides::over(const MaterialOverrides& general) const {
  MaterialOverrides both = *this;
  const auto inherit = [](auto& own, const auto& other) {
    if (!own) own = other;
  };
  if (!albedo && !texture) {
    both.albedo = general.albedo;
    both.texture = general.texture;
  }
  inherit(both.textureColourSpace, general.textureColourSpace);
  inherit(both.vertexColours, general.vertexColours);
  inherit(both.twoSided, general.twoSided);
  inherit(both.emission, general.emission);
  inherit(both.gloss, general.gloss);
  inherit(both.translucency, general.translucency);
  return both;
}

}  // namespace shprt
