// What every transport model shares: the unshadowed transfer, and writing a vertex's coefficients to its
// column.
#pragma once

#include <numbers>
#include <span>
#include <vector>

#include "shprt/base/vec.h"
#include "shprt/coefficients/transfer_asset.h"
#include "shprt/scene/scene.h"

namespace shprt {

// Cosine-weighted mean of y_lm over the hemisphere around a normal: (A_l / pi) y_lm(normal). Albedo is not in
// it.
class UnshadowedTransfer {
 public:
  explicit UnshadowedTransfer(int degree);
  // normal of unit length; results holds coefficientCount(degree) entries.
  void evaluate(Vec3d normal, std::span<double> results) const;

 private:
  int degree_;
  std::vector<double> bandFactors_;  // A_l / pi
};

// Coefficient 0 of unshadowed transfer, whatever the normal: y_00 A_0 / pi.
inline constexpr double kUnshadowedMean = std::numbers::inv_sqrtpi / 2;

// 2-norm of the unshadowed transfer, which is that of every normal.
double unshadowedNorm(int degree);

// Whether every albedo is grey, textures included: one channel serves all three then.
bool isGrey(const Scene& scene);

// Zeroed coefficients.
TransferCoefficients makeTransfer(int channels, std::size_t vertexCount, int degree);

// Zeroed coefficients for as many vertices as albedo has; one channel where every albedo is grey, else three.
TransferCoefficients makeTransfer(std::span<const Vec3f> albedo, int degree);

// Writes albedo times transfer (cosine-weighted means, per unit albedo) for one vertex.
void storeTransfer(std::span<const double> transfer, Vec3f albedo, std::size_t vertex,
                   TransferCoefficients& coefficients);

// What each vertex of a receiver sends out by itself, blockers zero.
std::vector<Vec3f> ownEmission(const Scene& scene);

}  // namespace shprt
