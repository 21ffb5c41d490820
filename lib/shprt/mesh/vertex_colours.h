// Colours that a mesh file gives its vertices, collected while it is read and brought to [0,1] at its end:
// only the whole file shows whether its numbers count to 1 or to 255.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "shprt/mesh/raw_mesh.h"

namespace shprt {

class VertexColours {
 public:
  // The colour of one vertex; vertices come in ascending order and may be passed over. A colour with a
  // channel that is no finite number is none.
  void add(std::uint64_t vertex, Vec3f colour);
  void add(std::uint64_t vertex, std::string_view red, std::string_view green, std::string_view blue);

  // Hands the colours of all vertices to the file, with notes on what was assumed and clamped; without any
  // colour, none. maximum: what full intensity is, where the file's types tell; otherwise values of 2 and
  // more mean that it is 255, and it is 1 when there are none.
  void finish(std::uint64_t vertexCount, std::optional<float> maximum, CanonicalFile& file);

 private:
  std::vector<Vec3f> colours_;
  std::uint64_t coloured_ = 0, unusable_ = 0;
  float largest_ = 0, smallest_ = 0;
};

}  // namespace shprt
