// What a bake will take: seconds from the rates that a pilot measured, bytes from the file's layout
// (docs/file-formats.md).
#pragma once

#include <cstdint>

#include "shprt/transfer/bounce_pilot.h"

namespace shprt {

struct BakeWork {
  std::uint64_t points = 0;       // of the scene
  std::uint64_t pointsBelow = 0;  // of them, with geometry above their tangent plane
  int rays = 256;                 // per point
  int degree = 4;
  int channels = 1;
  bool interreflected = false;  // whether nearest hits are needed
  int bounces = 0;
  std::uint64_t hitMemory = 0;  // as InterreflectedOptions
};

struct BakeSeconds {
  double shadows = 0;  // of a bake of shadows alone
  double bounces = 0;  // that an interreflected bake takes beyond that
  double terms = 0;    // part of shadows: coefficients
};

// With as many threads as threadCount().
BakeSeconds predictSeconds(const BouncePilot& pilot, const BakeWork& work);

struct AssetContent {
  std::uint64_t vertices = 0, triangles = 0;
  int degree = 4, channels = 1;
  bool half = false, textureCoordinates = false, emission = false;
};

// Of the transfer alone, and of the whole asset as written without compression but for its text (a few
// kilobytes).
std::uint64_t transferBytes(const AssetContent& content);
std::uint64_t assetBytes(const AssetContent& content);

}  // namespace shprt
