// Finds the lines of lib/shprt/sh/lobe_directions.cpp: for a degree one sequence whose first 2l+1 members
// serve band l.
//
// Lines d of band l are judged by the Gram matrix G_ij = P_l(d_i . d_j) of their zonal harmonics, which is
// the identity for a perfect set. Gradient descent (Adam, on the sphere) from random starts lowers the sum
// over bands of (tr(G^-1) / (2l+1))^p, which tends to the worst band as p grows; the start with the smallest
// worst condition number wins. Not part of the build:
//   g++ -std=c++20 -O2 tests/sh/generate/lobe_directions.cpp -o /tmp/lobe_directions
//   /tmp/lobe_directions 8 300
// prints the condition number of each band, then the table. The arguments are the degree and the number of
// starts; the tables were made by 2 300, 4 300, 8 300 and 16 60.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <random>
#include <vector>

namespace {

using Line = std::array<double, 3>;
using Lines = std::vector<Line>;
using Matrix = std::vector<double>;

double dot(const Line& a, const Line& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

Line scaled(const Line& a, double factor) {
  return {a[0] * factor, a[1] * factor, a[2] * factor};
}

Line unit(const Line& a) {
  return scaled(a, 1 / std::sqrt(dot(a, a)));
}

struct Legendre {
  double value, derivative;
};

Legendre legendre(int l, double t) {
  double previous = 1, current = t, previousSlope = 0, slope = 1;
  for (int n = 1; n < l; ++n) {
    const double next = ((2 * n + 1) * t * current - n * previous) / (n + 1);
    const double nextSlope = previousSlope + (2 * n + 1) * current;
    previous = current, current = next, previousSlope = slope, slope = nextSlope;
  }
  return {current, slope};
}

// The inverse of a symmetric positive definite matrix by Gauss-Jordan steps in place; false when it is not.
bool invert(Matrix& a, std::size_t n) {
  for (std::size_t k = 0; k < n; ++k) {
    const double pivot = a[k * n + k];
    if (!(pivot > 1e-12)) return false;
    a[k * n + k] = 1;
    for (std::size_t j = 0; j < n; ++j) a[k * n + j] /= pivot;
    for (std::size_t i = 0; i < n; ++i) {
      if (i == k) continue;
      const double factor = a[i * n + k];
      a[i * n + k] = 0;
      for (std::size_t j = 0; j < n; ++j) a[i * n + j] -= factor * a[k * n + j];
    }
  }
  return true;
}

struct Band {
  double score;    // tr(G^-1) / n, infinite where lines coincide
  Lines gradient;  // of the score
};

Band judge(int l, const Lines& lines) {
  const auto n = static_cast<std::size_t>(2 * l + 1);
  Matrix gram(n * n), slope(n * n);
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j) {
      const Legendre p = legendre(l, dot(lines[i], lines[j]));
      gram[i * n + j] = i == j ? 1 : p.value;
      slope[i * n + j] = i == j ? 0 : p.derivative;
    }
  Band band{HUGE_VAL, Lines(n, Line{})};
  if (!invert(gram, n)) return band;
  band.score = 0;
  for (std::size_t i = 0; i < n; ++i) band.score += gram[i * n + i] / static_cast<double>(n);
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j) {
      if (i == j) continue;
      double squared = 0;  // (G^-2)_ij
      for (std::size_t k = 0; k < n; ++k) squared += gram[i * n + k] * gram[k * n + j];
      for (int c = 0; c < 3; ++c)
        band.gradient[i][c] -= 2 * squared * slope[i * n + j] * lines[j][c] / static_cast<double>(n);
    }
  return band;
}

// Lowers log(sum of score^p) / p.
bool descend(int degree, double p, int steps, double rate, Lines& lines) {
  Lines momentum(lines.size(), Line{});
  std::vector<double> scale(lines.size(), 0);
  for (int step = 1; step <= steps; ++step) {
    Lines gradient(lines.size(), Line{});
    std::vector<Band> bands;
    double total = 0;
    for (int l = 1; l <= degree; ++l) {
      bands.push_back(judge(l, lines));
      total += std::pow(bands.back().score, p);
    }
    if (!std::isfinite(total)) return false;
    for (const Band& band : bands) {
      const double share = std::pow(band.score, p - 1) / total;
      for (std::size_t i = 0; i < band.gradient.size(); ++i)
        for (int c = 0; c < 3; ++c) gradient[i][c] += share * band.gradient[i][c];
    }
    const double cooled = rate * (1 - static_cast<double>(step - 1) / steps);
    for (std::size_t i = 0; i < lines.size(); ++i) {
      const double radial = dot(gradient[i], lines[i]);
      for (int c = 0; c < 3; ++c) {
        gradient[i][c] -= radial * lines[i][c];
        momentum[i][c] = 0.9 * momentum[i][c] + 0.1 * gradient[i][c];
      }
      scale[i] = 0.99 * scale[i] + 0.01 * dot(gradient[i], gradient[i]);
      const double length = std::sqrt(scale[i] / (1 - std::pow(0.99, step))) + 1e-12;
      for (int c = 0; c < 3; ++c) lines[i][c] -= cooled / length * momentum[i][c] / (1 - std::pow(0.9, step));
      lines[i] = unit(lines[i]);
    }
  }
  return true;
}

// sqrt of the ratio of the extreme eigenvalues of G, by power iteration on G and on its inverse.
double conditionNumber(int l, const Lines& lines) {
  const auto n = static_cast<std::size_t>(2 * l + 1);
  Matrix gram(n * n);
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j)
      gram[i * n + j] = i == j ? 1 : legendre(l, dot(lines[i], lines[j])).value;
  Matrix inverse = gram;
  if (!invert(inverse, n)) return HUGE_VAL;
  const auto largest = [n](const Matrix& a) {
    std::vector<double> v(n), next(n);
    for (std::size_t i = 0; i < n; ++i) v[i] = 1 + 0.37 * std::sin(1.0 + 7.0 * static_cast<double>(i));
    double norm = 0;
    for (int step = 0; step < 5000; ++step) {
      norm = 0;
      for (std::size_t i = 0; i < n; ++i) {
        next[i] = 0;
        for (std::size_t j = 0; j < n; ++j) next[i] += a[i * n + j] * v[j];
        norm += next[i] * next[i];
      }
      norm = std::sqrt(norm);
      for (std::size_t i = 0; i < n; ++i) v[i] = next[i] / norm;
    }
    return norm;
  };
  return std::sqrt(largest(gram) * largest(inverse));
}

double worstCondition(int degree, const Lines& lines) {
  double worst = 1;
  for (int l = 1; l <= degree; ++l) worst = std::max(worst, conditionNumber(l, lines));
  return worst;
}

// The first line becomes +z, the second has y = 0, all have z >= 0.
void canonicalise(Lines& lines) {
  const Line z = lines[0];
  const double along = dot(lines[1], z);
  Line x{};
  for (int c = 0; c < 3; ++c) x[c] = lines[1][c] - along * z[c];
  x = unit(x);
  const Line y{z[1] * x[2] - z[2] * x[1], z[2] * x[0] - z[0] * x[2], z[0] * x[1] - z[1] * x[0]};
  for (Line& line : lines) {
    line = {dot(line, x), dot(line, y), dot(line, z)};
    if (line[2] < 0) line = scaled(line, -1);
  }
  lines[0] = {0, 0, 1};
}

}  // namespace

int main(int argc, char** argv) {
  const int degree = argc > 1 ? std::atoi(argv[1]) : 8, starts = argc > 2 ? std::atoi(argv[2]) : 24;
  Lines best;
  double bestCondition = HUGE_VAL;
  for (int start = 0; start < starts; ++start) {
    std::mt19937_64 random(static_cast<std::uint64_t>(start) + 1);
    const auto uniform = [&random] { return static_cast<double>(random() >> 11) * 0x1p-53; };
    Lines lines(static_cast<std::size_t>(2 * degree + 1));
    for (Line& line : lines) {
      const double z = uniform(), phi = 6.283185307179586 * uniform(), r = std::sqrt(1 - z * z);
      line = {r * std::cos(phi), r * std::sin(phi), z};
    }
    bool fine = true;
    for (const double p : {0.5, 1.0, 2.0, 4.0, 8.0, 16.0, 32.0})
      fine = fine && descend(degree, p, 1500, p < 1 ? 0.03 : 0.01, lines);
    if (!fine) continue;
    const double condition = worstCondition(degree, lines);
    std::fprintf(stderr, "start %d: worst condition number %.3f\n", start, condition);
    if (condition < bestCondition) bestCondition = condition, best = lines;
  }
  if (best.empty()) return 1;
  canonicalise(best);
  for (int l = 1; l <= degree; ++l) std::printf("// band %d: %.3f\n", l, conditionNumber(l, best));
  for (const Line& line : best) std::printf("{%.12f, %.12f, %.12f},\n", line[0], line[1], line[2]);
  return 0;
}
