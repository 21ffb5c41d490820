#include "shprt/transfer/twin_transfers.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "shprt/transfer/transfer_rows.h"

namespace shprt {

TwinTransfers::TwinTransfers(int degree)
    : coefficients_(static_cast<std::size_t>(coefficientCount(degree))), scale_(1 / unshadowedNorm(degree)) {}

void TwinTransfers::resize(std::size_t vertexCount) {
  values_.resize(2 * coefficients_ * vertexCount);
  known_.resize(vertexCount);
}

void TwinTransfers::store(const TransferCoefficients& transfer, int twin, std::uint32_t vertex) {
  assert(static_cast<std::size_t>(transfer.rows()) == coefficients_);
  const std::span<float> values = of(vertex, twin);
  for (std::size_t i = 0; i < coefficients_; ++i)
    values[i] =
        static_cast<float>(scale_ * static_cast<double>(transfer.row(0, static_cast<int>(i))[vertex]));
  known_[vertex] = true;
}

void TwinTransfers::copy(const TwinTransfers& from, std::uint32_t source, std::uint32_t vertex) {
  for (int twin = 0; twin < 2; ++twin) {
    const std::span<const float> values = from.of(source, twin);
    std::copy(values.begin(), values.end(), of(vertex, twin).begin());
  }
  known_[vertex] = true;
}

void TwinTransfers::setMean(std::uint32_t a, std::uint32_t b, std::uint32_t vertex) {
  for (int twin = 0; twin < 2; ++twin)
    for (std::size_t i = 0; i < coefficients_; ++i)
      of(vertex, twin)[i] = (of(a, twin)[i] + of(b, twin)[i]) / 2;
  known_[vertex] = true;
}

double TwinTransfers::difference(std::uint32_t a, const TwinTransfers& there, std::uint32_t b) const {
  double product = 0;
  for (std::size_t i = 0; i < coefficients_; ++i) {
    double term = 1;
    for (int twin = 0; twin < 2; ++twin)
      term *= static_cast<double>(of(a, twin)[i]) - static_cast<double>(there.of(b, twin)[i]);
    product += term;
  }
  return std::sqrt(std::max(product, 0.0));
}

std::span<float> TwinTransfers::of(std::uint32_t vertex, int twin) {
  return std::span(values_).subspan(
      (2 * std::size_t{vertex} + static_cast<std::size_t>(twin)) * coefficients_, coefficients_);
}

std::span<const float> TwinTransfers::of(std::uint32_t vertex, int twin) const {
  return std::span(values_).subspan(
      (2 * std::size_t{vertex} + static_cast<std::size_t>(twin)) * coefficients_, coefficients_);
}

}  // namespace shprt
