// Which vertices of an asset belong to which object of the scene it was baked from.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "shprt/coefficients/transfer_asset.h"

namespace shprt {

// The runs of vertices that share an object, in order of vertices: an object whose vertices are not
// consecutive gets several ranges. vertexObjects: per vertex, index into objects, of which names and files
// are taken.
std::vector<ObjectRange> objectRanges(std::span<const std::uint32_t> vertexObjects,
                                      std::span<const ObjectRange> objects);

// What is wrong with ranges in an asset of so many vertices, for messages: one that ends beyond them, or
// begins before the end of the one before it. "" when nothing is.
std::string problemOfRanges(std::span<const ObjectRange> ranges, std::size_t vertexCount);

// The ranges of those vertices that are kept (increasing, below the vertices that the ranges cover), in their
// new numbering; objects that keep none are left out.
std::vector<ObjectRange> keepRanges(std::span<const ObjectRange> ranges, std::span<const std::uint32_t> kept);

}  // namespace shprt
