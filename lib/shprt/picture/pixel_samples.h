// Where the samples of a pixel lie: the same offsets in every pixel, distributed as the reconstruction
// filter, so that their plain mean is the filtered picture.
#pragma once

#include <vector>

namespace shprt {

struct PixelOffset {
  double x = 0, y = 0;  // from the pixel's centre, in pixels
};

// count >= 1 offsets of the tent filter of radius 1 (density (1-|x|)(1-|y|)): a rank-1 lattice of the golden
// ratio, symmetric about the centre, so that a linear ramp is reproduced exactly. One sample is the centre.
std::vector<PixelOffset> tentOffsets(int count);

}  // namespace shprt
