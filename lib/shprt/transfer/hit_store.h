// Where the rays of each point end on surfaces that send light back: the transport operator as a sparse
// matrix, a row per point, kept in as little memory as it takes.
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "shprt/base/vec.h"
#include "shprt/transfer/surface_topology.h"

namespace shprt {

// A place on a triangle, barycentrics in steps of 1/65535. Three times that step bounds the error of what is
// interpolated there, in units of the largest difference between corners.
struct CompactHit {
  static constexpr int kSteps = 65535;
  std::uint32_t triangle;
  std::uint16_t u, v;  // u + v is at most kSteps

  static CompactHit from(const SurfacePoint& place);
};

// Albedo in steps of 1/65535.
struct CompactAlbedo {
  std::uint16_t red, green, blue;

  static CompactAlbedo from(Vec3f albedo);
  Vec3f toFloat() const;
};

// The hits of a block of consecutive points.
struct BlockHits {
  std::vector<std::uint32_t> ends;  // per point of the block, one past its last hit
  // One past the last of each of its first three quarters of rays (HemisphereSet).
  std::vector<std::array<std::uint32_t, 3>> quarterEnds;
  std::vector<CompactHit> hits;
  std::vector<CompactAlbedo> albedo;  // per hit in textured scenes, else empty

  std::size_t bytes() const {
    return ends.size() * (sizeof ends[0] + sizeof quarterEnds[0]) + hits.size() * sizeof hits[0] +
           albedo.size() * sizeof albedo[0];
  }
};

// Blocks as far as memory goes. Which of them find room may depend on the order in which threads come; what
// is computed from them does not, because the others are traced anew and give the same hits.
class HitStore {
 public:
  HitStore(std::size_t blocks, std::uint64_t memory) : blocks_(blocks), memory_(memory) {}

  // Keeps a copy without slack, or nothing where it does not fit. From any thread, each block once.
  void keep(std::size_t block, const BlockHits& hits);
  // What was kept, or null.
  const BlockHits* find(std::size_t block) const {
    return blocks_[block].ends.empty() ? nullptr : &blocks_[block];
  }
  std::uint64_t bytes() const { return bytes_; }

 private:
  std::vector<BlockHits> blocks_;
  std::uint64_t memory_;
  std::atomic<std::uint64_t> bytes_ = 0;
};

}  // namespace shprt
