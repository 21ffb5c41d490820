// Spherical harmonics of many directions, structure of arrays in and out, in float.
#pragma once

#include <cstddef>

namespace shprt {

// results[i * stride + k] = y_i(x[k], y[k], z[k]) for all i < coefficientCount(degree) and k < count: one row
// of count values for each coefficient. count is any number, stride at least count; nothing else is read or
// written, no alignment is asked for, and results overlaps no input. degree from 0 to 32
// (kMaximumBakeDegree): beyond, float is too short, and evaluateSh is the way. Directions are unit vectors
// rounded to float. Error of each value at most 5e-7 sqrt((2l+1)/4pi) when degree <= 8 and 2e-6
// sqrt((2l+1)/4pi) to degree 32, against y_i(u / |u|), poles included. Values below 1e-17 may come out as
// zero, never as subnormal numbers. Chooses AVX-512, AVX2 or baseline code by what the processor has; these
// differ in the last bits, as a direction's values may with its place in the batch, while the same call gives
// the same bits. Fastest with a multiple of 64 directions, rows that begin with a cache line, and a stride
// that is no large power of two (rows a multiple of 4096 bytes apart evict each other from the cache).
void evaluateShBatch(int degree, const float* x, const float* y, const float* z, std::size_t count,
                     float* results, std::size_t stride);

}  // namespace shprt
