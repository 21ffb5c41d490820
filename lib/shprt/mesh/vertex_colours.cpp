#include "shprt/mesh/vertex_colours.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "shprt/mesh/preflight.h"
#include "shprt/mesh/text.h"

namespace shprt {

void VertexColours::add(std::uint64_t vertex, Vec3f colour) {
  if (!isFinite(colour)) {
    ++unusable_;
    return;
  }
  colours_.resize(vertex, kNoColour);
  colours_.push_back(colour);
  ++coloured_;
  largest_ = std::max({largest_, colour.x, colour.y, colour.z});
  smallest_ = std::min({smallest_, colour.x, colour.y, colour.z});
}

void VertexColours::add(std::uint64_t vertex, std::string_view red, std::string_view green,
                        std::string_view blue) {
  const auto channel = [](std::string_view token) {
    return parseFloat(token).value_or(std::numeric_limits<float>::infinity());
  };
  add(vertex, {channel(red), channel(green), channel(blue)});
}

void VertexColours::finish(std::uint64_t vertexCount, std::optional<float> maximum, CanonicalFile& file) {
  std::vector<std::string>& notes = file.report.notes;
  if (unusable_)
    notes.push_back("colours of " + countOf(unusable_, "vertex", "vertices") + " cannot be read");
  if (coloured_ == 0) return;
  if (coloured_ + unusable_ < vertexCount)
    notes.push_back(countOf(vertexCount - coloured_ - unusable_, "vertex", "vertices") + " without colour");
  file.coloursAreIntegers = maximum || largest_ >= 2;
  if (!maximum && file.coloursAreIntegers) notes.push_back("colours of vertices above 1 taken as 0 to 255");
  const float full = maximum.value_or(file.coloursAreIntegers ? 255.0f : 1.0f);
  if (largest_ > full || smallest_ < 0) notes.push_back("colours of vertices clamped");
  colours_.resize(vertexCount, kNoColour);
  for (Vec3f& colour : colours_) {
    if (colour == kNoColour) continue;
    const auto toUnit = [&](float value) { return std::clamp(value / full, 0.0f, 1.0f); };
    colour = {toUnit(colour.x), toUnit(colour.y), toUnit(colour.z)};
  }
  file.vertexColours = std::move(colours_);
}

}  // namespace shprt
