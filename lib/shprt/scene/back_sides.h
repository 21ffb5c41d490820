// Surfaces that are seen from both sides.
#pragma once

#include "shprt/scene/scene.h"

namespace shprt {

// Gives every triangle of a two-sided material a reversed copy at the same place, with vertices of its own at
// the end: normals negated, all else alike. Call it once, since copies are copied too. Throws Error when
// there are then more vertices or triangle corners than 32 bits can number.
void addBackSides(Scene& scene);

}  // namespace shprt
