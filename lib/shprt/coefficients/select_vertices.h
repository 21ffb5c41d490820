// The part of an asset that belongs to some of its vertices: how the receivers of a scene leave the arrays
// that were baked over the whole of it.
#pragma once

#include <cstdint>
#include <span>

#include "shprt/coefficients/transfer_asset.h"

namespace shprt {

// The asset of the kept vertices, in their order: their columns of the transfer, their entries of every array
// that is not empty, the triangles whose corners are all kept, renumbered, and the ranges of objects that
// keep any vertex. The rest of the metadata stays. kept: strictly increasing, below the vertex count. Parts
// of `whole` have the sizes that its vertex count asks for.
TransferAsset selectVertices(const TransferAsset& whole, std::span<const std::uint32_t> kept);

// The same in place, for scenes whose transfer fills the memory: takes 4 bytes per vertex besides, and
// nothing at all when every vertex is kept.
TransferAsset selectVertices(TransferAsset&& whole, std::span<const std::uint32_t> kept);

}  // namespace shprt
