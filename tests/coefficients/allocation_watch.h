// Replaces operator new for the test program, to see the largest piece of memory that was asked for at once,
// whether or not it was granted.
#pragma once

#include <cstddef>

namespace shprt {

void forgetAllocations();
// In bytes, by any thread, since forgetAllocations().
std::size_t largestAllocation();

}  // namespace shprt
