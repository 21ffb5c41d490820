// Transfer measured twice with independent rays, so that differences can be told from noise: of two measured
// differences, the inner product has the true squared difference as its expectation.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "shprt/coefficients/transfer_asset.h"

namespace shprt {

// Per vertex, as far as known: two estimates of its transfer in one channel, in units of the unshadowed
// transfer's 2-norm.
class TwinTransfers {
 public:
  explicit TwinTransfers(int degree);

  void resize(std::size_t vertexCount);  // new vertices are not known
  std::size_t vertexCount() const { return known_.size(); }
  bool known(std::uint32_t vertex) const { return known_[vertex]; }

  // Both twins make a vertex known. twin is 0 or 1; the transfer is of unit albedo.
  void store(const TransferCoefficients& transfer, int twin, std::uint32_t vertex);
  void copy(const TwinTransfers& from, std::uint32_t source, std::uint32_t vertex);
  void setMean(std::uint32_t a, std::uint32_t b, std::uint32_t vertex);

  // Between vertex a here and b there: the root of the twins' inner product, zero where noise makes that
  // negative.
  double difference(std::uint32_t a, const TwinTransfers& there, std::uint32_t b) const;

 private:
  std::span<float> of(std::uint32_t vertex, int twin);
  std::span<const float> of(std::uint32_t vertex, int twin) const;

  std::size_t coefficients_;
  double scale_;
  std::vector<float> values_;  // [vertex][twin][coefficient]
  std::vector<bool> known_;
};

}  // namespace shprt
