#include "shprt/coefficients/object_ranges.h"

#include <algorithm>

namespace shprt {

std::vector<ObjectRange> objectRanges(std::span<const std::uint32_t> vertexObjects,
                                      std::span<const ObjectRange> objects) {
  std::vector<ObjectRange> ranges;
  for (std::size_t begin = 0, end = 0; begin < vertexObjects.size(); begin = end) {
    while (end < vertexObjects.size() && vertexObjects[end] == vertexObjects[begin]) ++end;
    const ObjectRange& object = objects[vertexObjects[begin]];
    ranges.push_back({object.name, object.file, begin, end - begin});
  }
  return ranges;
}

std::string problemOfRanges(std::span<const ObjectRange> ranges, std::size_t vertexCount) {
  std::uint64_t next = 0;
  for (std::size_t i = 0; i < ranges.size(); ++i) {
    const ObjectRange& range = ranges[i];
    const std::string which = "objects[" + std::to_string(i) + "]";
    if (range.firstVertex < next) return which + " begins before the end of the one before it";
    if (range.firstVertex > vertexCount || range.vertexCount > vertexCount - range.firstVertex)
      return which + " ends beyond the " + std::to_string(vertexCount) + " vertices";
    next = range.firstVertex + range.vertexCount;
  }
  return "";
}

std::vector<ObjectRange> keepRanges(std::span<const ObjectRange> ranges,
                                    std::span<const std::uint32_t> kept) {
  std::vector<ObjectRange> remaining;
  for (const ObjectRange& range : ranges) {
    const auto begin = std::lower_bound(kept.begin(), kept.end(), range.firstVertex);
    const auto end = std::lower_bound(begin, kept.end(), range.firstVertex + range.vertexCount);
    if (begin == end) continue;
    remaining.push_back({range.name, range.file, static_cast<std::uint64_t>(begin - kept.begin()),
                         static_cast<std::uint64_t>(end - begin)});
  }
  return remaining;
}

}  // namespace shprt
