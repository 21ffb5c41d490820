// The field "transform" of a scene file.
#pragma once

#include <string_view>

#include "shprt/scene/transform.h"

namespace shprt {

class JsonObject;

// 16 numbers, row by row, with 0 0 0 1 last; {"matrix": those}; or {"scale", "rotate", "translate"}, applied
// in this order, each of which may be left out. Throws Error for all else, and for what is singular.
Transform readTransform(const JsonObject& entry, std::string_view field);

}  // namespace shprt
