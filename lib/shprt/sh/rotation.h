// Rotation of functions given by spherical-harmonic coefficients: (R f)(u) = f(R^-1 u), so a light turns with
// R. Matrices act on column vectors; angles are in radians unless a text form says otherwise. The inverse is
// the rotation of the transposed matrix, "first B, then A" that of A * B.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "shprt/base/vec.h"

namespace shprt {

// The largest degree of a rotation: beyond, entries of the quarter turn leave the range of double.
inline constexpr int kMaximumRotationDegree = 2000;

struct CosineSine {
  double c = 1, s = 0;
};

// One rotation of any degree, applied band by band: R = Rz(alpha) Ry(beta) Rz(gamma), where the turn about y
// is a turn about z between two fixed exchanges of y and z (rotation_swap.h). Error and orthogonality defect
// stay below 1e-14 to degree 200 at every rotation, gimbal lock and half turns included; turns about z touch
// nothing but the pairs (m, -m), and the identity changes no bit.
class ShRotation {
 public:
  // Throws Error when matrix is no rotation (see nearestRotation), or degree is outside [0,
  // kMaximumRotationDegree].
  ShRotation(int degree, const Mat3& matrix);

  int degree() const { return degree_; }
  // The rotation in use: the given matrix, or the nearest one to it.
  const Mat3& matrix() const { return matrix_; }
  // By how much it differs from the given matrix, as NearestRotation::correction.
  double correction() const { return correction_; }
  // Rotates coefficient sets in place, each of coefficientCount(degree()) entries. A set costs O(degree^3).
  // To degree 128 the fixed matrices are kept for all rotations to come (at most 7 MB); above, each call
  // builds them band by band, at less than the cost of applying them.
  void apply(std::span<const std::span<double>> sets) const;
  void apply(std::span<double> set) const;
  // The same for band l <= degree() alone: each of the bands has the 2l+1 entries m = -l..l.
  void applyToBand(int l, std::span<const std::span<double>> bands) const;

 private:
  int degree_;
  double correction_ = 0;
  Mat3 matrix_;
};

// The Wigner matrix D of band l in row-major order, (2l+1)^2 entries, rows and columns m = -l..l: y_l(R u) =
// D y_l(u), and the rotated function has the coefficients D a. D of a product is the product, D of the
// transpose the transpose. Throws Error as ShRotation does. Costs O(l^3).
std::vector<double> wignerMatrix(int l, const Mat3& rotation);

// Rotates many coefficient sets by one rotation: coefficient i of set k is from[i * stride + k], as in a
// plane of TransferCoefficients, and goes to to[i * stride + k]; k < setCount <= stride. from and to must not
// overlap. Floats with a rounding error near 1e-7 sqrt(2l+1) of a band's norm; any alignment; one thread
// (callers may split the sets: results do not depend on it). O(degree^3) per set by dense matrices, meant for
// the degrees of assets.
void rotateMany(const ShRotation& rotation, const float* from, float* to, std::size_t setCount,
                std::size_t stride);

struct NearestRotation {
  Mat3 rotation;
  double correction = 0;  // largest change of an entry; 0 for a matrix that is a rotation to rounding
};

// The orthonormal matrix nearest to one that is a rotation up to rounding. Throws Error when the matrix is
// not: entries that are not finite, a reflection, or columns off orthonormality by more than 2e-3 (scale,
// shear).
NearestRotation nearestRotation(const Mat3& matrix);

// The rotation of a quaternion of any finite length but zero. Throws Error for the others.
Mat3 rotationFromQuaternion(double w, double x, double y, double z);

// Rz(alpha) Ry(beta) Rz(gamma), for finite angles in radians; throws Error for others.
Mat3 rotationFromEulerZyz(double alpha, double beta, double gamma);

// A rotation from a text, as --rotate takes it everywhere: "axis:x,y,z,degrees", "quat:w,x,y,z",
// "euler:zyz,a,b,c" (degrees; R = Rz(a) Ry(b) Rz(c)), "matrix:" with nine numbers in rows, or "@FILE" naming
// a file that holds one of these. Multiples of 90 degrees about an axis give exact entries. The correction
// tells how far a given matrix was from a rotation, and is 0 for the other forms. Throws Error that shows the
// forms.
NearestRotation parseNearestRotation(const std::string& specification);
// The same for callers who do not report the correction.
Mat3 parseRotation(const std::string& specification);

}  // namespace shprt
