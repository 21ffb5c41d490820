// Rotation of functions given by spherical-harmonic coefficients: (R f)(u) = f(R^-1 u), so a light turns with
// R.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "shprt/base/vec.h"

namespace shprt {

// One rotation of any degree, applied band by band: R = Rz(alpha) Ry(beta) Rz(gamma), see rotation.cpp. Error
// and orthogonality defect stay near 1e-14 to degree 200 at every rotation, gimbal lock and half turns
// included.
class ShRotation {
 public:
  // Throws Error when matrix is no rotation (see nearestRotation).
  ShRotation(int degree, const Mat3& matrix);

  int degree() const { return degree_; }
  // Rotates coefficient sets in place, each of coefficientCount(degree()) entries. Costs O(degree^3), most of
  // it once for all sets.
  void apply(std::span<const std::span<double>> sets) const;
  void apply(std::span<double> set) const { apply(std::span(&set, 1)); }

 private:
  int degree_;
  double alpha_, beta_, gamma_;
};

struct NearestRotation {
  Mat3 rotation;
  double correction = 0;  // largest change of an entry
};

// The orthonormal matrix nearest to one that is a rotation up to rounding. Throws Error when the matrix is
// not: entries that are not finite, a reflection, or columns off orthonormality by more than 2e-3 (scale,
// shear).
NearestRotation nearestRotation(const Mat3& matrix);

// A rotation matrix from a text, as --rotate takes it everywhere: "axis:x,y,z,degrees", "quat:w,x,y,z",
// "euler:zyz,a,b,c" (degrees; R = Rz(a) Ry(b) Rz(c)), "matrix:" with nine numbers in rows, or "@FILE" naming
// a file that holds one of these. Multiples of 90 degrees about an axis give exact entries. Throws Error that
// shows the forms.
Mat3 parseRotation(const std::string& specification);

}  // namespace shprt
