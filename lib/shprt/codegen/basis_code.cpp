#include "shprt/codegen/basis_code.h"

#include <cstdlib>
#include <vector>

#include "shprt/codegen/solid_harmonic.h"

namespace shprt {
namespace {

std::string power(const std::string& base, int exponent) {
  return exponent == 1 ? base : base + std::to_string(exponent);
}

std::string monomialName(int zPower, int sPower) {
  return (zPower > 0 ? power("z", zPower) : "") + (sPower > 0 ? power("s", sPower) : "");
}

// Re and Im of (x + iy)^m.
std::string realPart(int m) {
  return m == 1 ? "x" : power("re", m);
}
std::string imaginaryPart(int m) {
  return m == 1 ? "y" : power("im", m);
}

}  // namespace

std::string BasisCode::monomial(int zPower, int sPower) {
  if (monomials_.insert({zPower, sPower}).second) {
    if (zPower > 0 && sPower > 0) {
      monomial(zPower, 0);
      monomial(0, sPower);
    } else if (zPower + sPower > 1) {
      monomial(zPower / 2, sPower / 2);
      monomial(zPower - zPower / 2, sPower - sPower / 2);
    }
  }
  return monomialName(zPower, sPower);
}

std::string BasisCode::polynomial(int l, int m, double factor) {
  const std::vector<double> coefficients = solidHarmonic(l, m);
  std::vector<std::string> terms;
  int sPower = 0;
  for (const double coefficient : coefficients) {
    const int zPower = l - m - 2 * sPower;
    const std::string constant = dialect_.number(factor * coefficient);
    terms.push_back(zPower + sPower == 0 ? constant : constant + " * " + monomial(zPower, sPower));
    ++sPower;
  }
  return joinSum(terms);
}

std::string BasisCode::declareBand(int l, double factor) {
  band_.clear();
  std::string declarations;
  for (int m = 0; m <= l; ++m) {
    const std::string expression = polynomial(l, m, factor);
    if (l > m && l > 1) {
      const std::string name = "h" + std::to_string(l) + "_" + std::to_string(m);
      declarations += dialect_.declareScalar(name, expression);
      band_[m] = name;
    } else {
      band_[m] = expression;
    }
    if (m > largestOrder_) largestOrder_ = m;
  }
  return declarations;
}

std::string BasisCode::value(int m) {
  const std::string& polynomial = band_.at(std::abs(m));
  if (m == 0) return polynomial;
  return polynomial + " * " + (m > 0 ? realPart(m) : imaginaryPart(-m));
}

std::string BasisCode::declarePowers(const std::string& direction) const {
  std::string text;
  if (largestOrder_ > 0) {
    text += dialect_.declareScalar("x", dialect_.component(direction, 0));
    text += dialect_.declareScalar("y", dialect_.component(direction, 1));
  }
  if (monomials_.contains({1, 0})) text += dialect_.declareScalar("z", dialect_.component(direction, 2));
  if (monomials_.contains({0, 1})) text += dialect_.declareScalar("s", "x * x + y * y");
  // Pure powers come before the products of them, small ones first.
  for (const bool mixed : {false, true})
    for (const auto& [zPower, sPower] : monomials_) {
      if (zPower + sPower == 1 || (zPower > 0 && sPower > 0) != mixed) continue;
      const std::string product = mixed ? monomialName(zPower, 0) + " * " + monomialName(0, sPower)
                                        : monomialName(zPower / 2, sPower / 2) + " * " +
                                              monomialName(zPower - zPower / 2, sPower - sPower / 2);
      text += dialect_.declareScalar(monomialName(zPower, sPower), product);
    }
  for (int m = 2; m <= largestOrder_; ++m) {
    text += dialect_.declareScalar(realPart(m), "x * " + realPart(m - 1) + " - y * " + imaginaryPart(m - 1));
    text += dialect_.declareScalar(imaginaryPart(m),
                                   m == 2 ? dialect_.number(2) + " * x * y"
                                          : "x * " + imaginaryPart(m - 1) + " + y * " + realPart(m - 1));
  }
  return text;
}

}  // namespace shprt
