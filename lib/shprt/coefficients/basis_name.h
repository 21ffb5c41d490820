// The SH basis as JSON files name it, so that a file in another convention is refused and not misread.
#pragma once

#include "shprt/base/json_input.h"

namespace shprt {

inline constexpr const char* kBasisConvention = "real-orthonormal";
inline constexpr const char* kBasisIndex = "l(l+1)+m";

// Throws Error unless the object's field "basis" names the basis of sh/basis.h.
void checkBasis(const JsonObject& file);

}  // namespace shprt
