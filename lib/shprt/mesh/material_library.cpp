#include "shprt/mesh/material_library.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <optional>

#include "shprt/base/file.h"
#include "shprt/mesh/preflight.h"
#include "shprt/mesh/text.h"
#include "shprt/mesh/text_encoding.h"

namespace shprt {
namespace {

// "map_Kd -s 1 1 1 -clamp on my file.png": options come first, the rest is the name, blanks included.
std::string textureName(std::string_view line) {
  for (;;) {
    line = trimBlanks(line);
    std::string_view rest = line;
    std::string_view token = takeToken(rest);
    if (token.size() < 2 || token.front() != '-' || parseFloat(token)) return std::string(line);
    line = rest;
    if (token == "-imfchan" || token == "-type") {
      takeToken(line);
      continue;
    }
    for (token = takeToken(rest); parseFloat(token) || token == "on" || token == "off";
         token = takeToken(rest))
      line = rest;
  }
}

// Three numbers, each finite; nothing otherwise.
std::optional<Vec3f> readColour(std::string_view line) {
  std::array<float, 3> colour{};
  for (float& channel : colour) {
    const std::optional<float> value = parseFloat(takeToken(line));
    if (!value) return {};
    channel = *value;
  }
  return Vec3f{colour[0], colour[1], colour[2]};
}

Vec3f clampEach(Vec3f colour, float highest) {
  return {std::clamp(colour.x, 0.0f, highest), std::clamp(colour.y, 0.0f, highest),
          std::clamp(colour.z, 0.0f, highest)};
}

}  // namespace

void readMaterialLibrary(const std::filesystem::path& path, MaterialLibrary& library,
                         std::vector<std::string>& notes) {
  constexpr std::uint64_t kMaximumBytes = std::uint64_t{1} << 28;
  const std::string bytes = decodeText(readFile(path, kMaximumBytes), notes);
  const std::string name = path.filename().string();
  std::string_view text = bytes;
  Material* current = nullptr;
  std::uint64_t specular = 0;
  const auto note = [&](const std::string& quantity, const std::string& problem) {
    notes.push_back(name + ": " + quantity + " of '" + shownToken(current->name) + "' " + problem);
  };
  while (!text.empty()) {
    std::string_view line = takeLine(text);
    const std::string_view keyword = takeToken(line);
    if (keyword == "newmtl") {
      const auto [entry, fresh] = library.try_emplace(std::string(trimBlanks(line)));
      current = fresh ? &entry->second : nullptr;
      if (!fresh) continue;
      current->name = entry->first;
      current->folder = path.parent_path().string();
    } else if (current && keyword == "Kd") {
      if (const std::optional<Vec3f> colour = readColour(line)) {
        current->diffuse = clampEach(*colour, 1);
        current->hasDiffuse = true;
        if (current->diffuse != *colour) note("Kd", "clamped to [0,1]");
      } else {
        note("Kd", "cannot be read");
      }
    } else if (current && keyword == "Ke") {
      if (const std::optional<Vec3f> colour = readColour(line)) {
        current->emission = clampEach(*colour, std::numeric_limits<float>::max());
        if (current->emission != *colour) note("Ke", "clamped: light cannot be negative");
      } else {
        note("Ke", "cannot be read; no emission used");
      }
    } else if (current && keyword == "Ks") {
      specular += readColour(line).value_or(Vec3f{}) != Vec3f{};
    } else if (current && keyword == "map_Kd") {
      current->diffuseTexture = textureName(line);
      if (current->diffuseTexture != trimBlanks(line)) note("options of map_Kd", "ignored");
    }
  }
  if (specular) notes.push_back(name + ": Ks of " + countOf(specular, "material") + " ignored");
}

}  // namespace shprt
