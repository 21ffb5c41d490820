// Zonal functions, those that depend on one angle only, by their band factors.
//
// A kernel k(cos theta) has the factors h_l = 2 pi * integral_{-1}^1 k(t) P_l(t) dt. They mean, exactly:
//   - the function u -> k(u . n) has the coefficients h_l y_lm(n), for every unit axis n;
//   - the convolution (f * k)(n) = integral of f(u) k(u . n) over the sphere has the coefficients h_l f_lm;
//   - k(t) = sum over l of (2l+1)/(4 pi) h_l P_l(t).
// h_0 is the integral of k over the sphere. The lobes below are normalised to h_0 = 1, so that convolving
// with them keeps the mean; the clamped cosine alone keeps its integral, pi. All functions return the factors
// l = 0..degree, for any degree >= 0.
#pragma once

#include <span>
#include <vector>

#include "shprt/base/vec.h"

namespace shprt {

// Band factors A_l = 2 pi * integral_0^1 t P_l(t) dt of the clamped cosine, l = 0..degree: pi, 2pi/3, pi/4,
// 0, -pi/24, ... Convolution with the clamped cosine multiplies band l by A_l. Based on: Ramamoorthi and
// Hanrahan 2001, eq. 8.
std::vector<double> clampedCosineFactors(int degree);

// Phong lobe, k(t) = (s+1)/(2 pi) max(0, t)^s for any real exponent s >= 0: the hemisphere at 0, the clamped
// cosine over pi at 1. Error at most (l+1) 3e-16 relative. Throws Error when exponent is negative or not
// finite.
std::vector<double> phongLobeFactors(int degree, double exponent);

// Power lobe over the whole sphere, k(t) = (s+1)/(4 pi) ((1+t)/2)^s for any real exponent s >= 0; a whole s
// has no bands beyond s. Error at most (l+1) 5e-16 relative. Throws Error when exponent is negative or not
// finite.
std::vector<double> powerLobeFactors(int degree, double exponent);

// Phase function of Henyey and Greenstein, k(t) = (1-g^2)/(4 pi (1+g^2-2gt)^(3/2)), -1 < g < 1: h_l = g^l.
// Error at most l 2e-16 relative. Throws Error when g is out of range.
std::vector<double> henyeyGreensteinFactors(int degree, double g);

// coefficients[l(l+1)+m] = factors[l] y_lm(axis): the zonal function about the unit vector axis. The degree
// is factors.size() - 1; coefficients has (degree+1)^2 entries.
void zonalCoefficients(Vec3d axis, std::span<const double> factors, std::span<double> coefficients);

// Multiplies band l of coefficients by factors[l]; coefficients has factors.size()^2 entries.
void convolve(std::span<double> coefficients, std::span<const double> factors);

// The kernel of these factors at cosTheta in [-1, 1]: sum over l of (2l+1)/(4 pi) factors[l] P_l(cosTheta).
double evaluateZonal(std::span<const double> factors, double cosTheta);

}  // namespace shprt
