#include "shprt/mesh/material_library.h"

#include <algorithm>
#include <array>

#include "shprt/base/file.h"
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

}  // namespace

void readMaterialLibrary(const std::filesystem::path& path, MaterialLibrary& library,
                         std::vector<std::string>& notes) {
  constexpr std::uint64_t kMaximumBytes = std::uint64_t{1} << 28;
  const std::string bytes = decodeText(readFile(path, kMaximumBytes), notes);
  const std::string name = path.filename().string();
  std::string_view text = bytes;
  Material* current = nullptr;
  while (!text.empty()) {
    std::string_view line = takeLine(text);
    const std::string_view keyword = takeToken(line);
    if (keyword == "newmtl") {
      const auto [entry, fresh] = library.try_emplace(std::string(trimBlanks(line)));
      entry->second.name = entry->first;
      current = fresh ? &entry->second : nullptr;
    } else if (current && keyword == "Kd") {
      std::array<float, 3> colour{};
      bool readable = true, clamped = false;
      for (float& channel : colour) {
        const std::optional<float> value = parseFloat(takeToken(line));
        readable = readable && value;
        channel = std::clamp(value.value_or(0), 0.0f, 1.0f);
        clamped = clamped || (value && channel != *value);
      }
      if (clamped) notes.push_back(name + ": Kd of '" + shownToken(current->name) + "' clamped to [0,1]");
      if (readable) {
        current->diffuse = {colour[0], colour[1], colour[2]};
        current->hasDiffuse = true;
      } else {
        notes.push_back(name + ": Kd of '" + shownToken(current->name) +
                        "' cannot be read; default albedo used");
      }
    } else if (current && keyword == "map_Kd") {
      current->diffuseTexture = textureName(line);
    }
  }
}

}  // namespace shprt
