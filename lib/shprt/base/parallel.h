// Parallel loops over index ranges. Work is cut into fixed blocks that do not depend on the number of
// threads, so a body that writes only to its own range gives the same bits for one thread and many.
#pragma once

#include <cstddef>
#include <functional>

namespace shprt {

// Limits all later loops to this many threads; 0 means one per core. Throws Error when negative.
void setThreadCount(int threads);
int threadCount();

// Calls body(begin, end) for consecutive blocks of at most blockSize indices that cover [0, count), in
// parallel and in no particular order. An exception thrown by a body stops the loop and is rethrown.
void parallelForBlocks(std::size_t count, std::size_t blockSize,
                       const std::function<void(std::size_t begin, std::size_t end)>& body);

// Runs both, at the same time where there are two threads.
void parallelInvoke(const std::function<void()>& first, const std::function<void()>& second);

}  // namespace shprt
