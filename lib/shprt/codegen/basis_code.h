// The y_lm of one direction as expressions, with the powers and polynomials they share declared once.
#pragma once

#include <map>
#include <set>
#include <string>
#include <utility>

#include "shprt/codegen/dialect.h"

namespace shprt {

// Collects what a function asks for and prints the declarations of just that.
class BasisCode {
 public:
  explicit BasisCode(const Dialect& dialect) : dialect_(dialect) {}

  // Declarations of what the terms of band l share: the polynomials of m and -m. factor is folded into the
  // constants. Ask for this before value().
  std::string declareBand(int l, double factor);
  // factor * y_lm of the band declared last; safe as a factor of a product.
  std::string value(int m);
  // What goes before all bands: x, y, z of the direction, and the powers that were asked for.
  std::string declarePowers(const std::string& direction) const;
  // Whether anything of the direction was asked for.
  bool usesDirection() const { return !monomials_.empty() || largestOrder_ > 0; }

 private:
  std::string polynomial(int l, int m, double factor);
  std::string monomial(int zPower, int sPower);

  const Dialect& dialect_;
  std::set<std::pair<int, int>> monomials_;  // powers of z and of s, products after their factors
  int largestOrder_ = 0;
  std::map<int, std::string> band_;  // by m >= 0
};

}  // namespace shprt
