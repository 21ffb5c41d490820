// Cubes: crosses and strips of six square faces.
#pragma once

#include "shprt/image/environment.h"

namespace shprt {

// Whether the layout is made of the faces of a cube.
bool isCube(EnvironmentLayout layout);
// How many faces fit beside and above each other in a cube's picture.
struct CubeCells {
  int columns, rows;
};
CubeCells cubeCells(EnvironmentLayout cube);

// As pixelFootprint and pixelPosition (environment.h), for a cube.
PixelFootprint cubeFootprint(EnvironmentLayout cube, int width, int height, int x, int y);
PixelPosition cubePosition(EnvironmentLayout cube, int width, int height, Vec3d direction);

}  // namespace shprt
