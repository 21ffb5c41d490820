// A row of a latitude-longitude picture is first summed against cos and sin of multiples of the longitude,
// and only these few sums meet the Legendre functions of the row. The row is folded before: longitudes phi
// and -phi share their cosines and negate their sines, and in pictures of even width phi and pi - phi share
// both but for a sign that depends on m. Based on: Driscoll and Healy 1994 (separation of variables).

#include "shprt/light/latitude_sums.h"

#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <numbers>

#include "shprt/image/environment.h"
#include "shprt/sh/basis.h"

namespace shprt {
namespace {

using std::numbers::pi;
using Plane = std::vector<double>;

// Sums and differences of what lies opposite in a row; a column in the middle is its own opposite, and has no
// difference.
void fold(const double* row, std::size_t count, double* sums, double* differences) {
  const std::size_t pairs = count / 2;
  for (std::size_t i = 0; i < pairs; ++i) {
    const double a = row[i], b = row[count - 1 - i];
    sums[i] = a + b;
    differences[i] = a - b;
  }
  if (count % 2 != 0) {
    sums[pairs] = row[pairs];
    differences[pairs] = 0;
  }
}

// One row in three colours, in every stage of folding.
struct Row {
  std::array<Plane, 3> radiance;
  // After folding at longitude 0: what cosines and what sines see.
  std::array<Plane, 3> cosinePart, sinePart;
  // After folding those at 90 degrees: what even and what odd m see, [m % 2].
  std::array<std::array<Plane, 3>, 2> forCosines, forSines;

  Row(std::size_t width, std::size_t half, std::size_t columns) {
    for (std::size_t c = 0; c < 3; ++c) {
      radiance[c].resize(width);
      cosinePart[c].resize(half);
      sinePart[c].resize(half);
      for (std::size_t parity = 0; parity < 2; ++parity) {
        forCosines[parity][c].resize(columns);
        forSines[parity][c].resize(columns);
      }
    }
  }
};

// Whether no value of a row needs mending: the case of nearly every row. A float that is neither negative nor
// infinite nor NaN has a clear sign bit and keeps it when its exponent grows by one.
bool isClean(const Vec3f* pixels, std::size_t count) {
  static_assert(sizeof(Vec3f) == 3 * sizeof(float));
  const float* values = &pixels->x;
  std::uint32_t bits = 0;
  for (std::size_t i = 0; i < 3 * count; ++i) {
    const auto value = std::bit_cast<std::uint32_t>(values[i]);
    bits |= value | (value + 0x00800000u);
  }
  return bits >> 31 == 0;
}

// Spreads a row of pixels into colours. Pixels left out are 0.
void spread(const Vec3f* pixels, double solidAngle, bool clampNegative, Row& row, ProbeSums& sums) {
  const std::size_t width = row.radiance[0].size();
  double *red = row.radiance[0].data(), *green = row.radiance[1].data(), *blue = row.radiance[2].data();
  std::size_t used = width;
  if (isClean(pixels, width)) {
    sums.pixels += width;
    for (std::size_t x = 0; x < width; ++x) {
      red[x] = static_cast<double>(pixels[x].x);
      green[x] = static_cast<double>(pixels[x].y);
      blue[x] = static_cast<double>(pixels[x].z);
    }
  } else {
    for (std::size_t x = 0; x < width; ++x) {
      std::array<double, 3> radiance{};
      if (!mendPixel(pixels[x], clampNegative, radiance, sums)) --used;
      red[x] = radiance[0];
      green[x] = radiance[1];
      blue[x] = radiance[2];
    }
  }
  sums.solidAngle += solidAngle * static_cast<double>(used);
  sums.weight += solidAngle * static_cast<double>(used);
}

// Two columns at a time: what every processor can do, so that all give the same bits.
typedef double Pair __attribute__((vector_size(16)));

inline Pair load(const double* from) {
  Pair pair;
  std::memcpy(&pair, from, sizeof pair);
  return pair;
}

// Products of one table with the three colours. Two partial sums each let the additions overlap.
std::array<double, 3> dotProducts(const double* table, const std::array<Plane, 3>& colours,
                                  std::size_t count) {
  const double *a = colours[0].data(), *b = colours[1].data(), *c = colours[2].data();
  Pair a0{}, a1{}, b0{}, b1{}, c0{}, c1{};
  std::size_t i = 0;
  for (; i + 4 <= count; i += 4) {
    const Pair near = load(table + i), far = load(table + i + 2);
    a0 += near * load(a + i);
    a1 += far * load(a + i + 2);
    b0 += near * load(b + i);
    b1 += far * load(b + i + 2);
    c0 += near * load(c + i);
    c1 += far * load(c + i + 2);
  }
  a0 += a1;
  b0 += b1;
  c0 += c1;
  std::array<double, 3> products = {a0[0] + a0[1], b0[0] + b0[1], c0[0] + c0[1]};
  for (; i < count; ++i) {
    products[0] += table[i] * a[i];
    products[1] += table[i] * b[i];
    products[2] += table[i] * c[i];
  }
  return products;
}

double sumOfSquares(const Plane& values) {
  Pair even{}, odd{};
  std::size_t i = 0;
  for (; i + 4 <= values.size(); i += 4) {
    const Pair near = load(&values[i]), far = load(&values[i + 2]);
    even += near * near;
    odd += far * far;
  }
  even += odd;
  double sum = even[0] + even[1];
  for (; i < values.size(); ++i) sum += values[i] * values[i];
  return sum;
}

}  // namespace

LatitudeSums::LatitudeSums(int degree, int width)
    : degree_(degree),
      width_(width),
      half_(static_cast<std::size_t>(width + 1) / 2),
      columns_(width % 2 == 0 ? (half_ + 1) / 2 : half_) {
  cosines_.reserve(static_cast<std::size_t>(degree + 1) * columns_);
  sines_.reserve(cosines_.capacity());
  for (int m = 0; m <= degree; ++m)
    for (std::size_t x = 0; x < columns_; ++x) {
      const double phi = pi * (1 - 2 * (static_cast<double>(x) + 0.5) / width);
      cosines_.push_back(std::cos(m * phi));
      sines_.push_back(std::sin(m * phi));
    }
}

void LatitudeSums::addRows(const Image& image, int begin, int end, bool clampNegative,
                           ProbeSums& sums) const {
  Row row(static_cast<std::size_t>(width_), half_, columns_);
  std::vector<double> basis(static_cast<std::size_t>(coefficientCount(degree_)));
  const bool foldsTwice = width_ % 2 == 0;
  for (int y = begin; y < end; ++y) {
    const double solidAngle =
        pixelFootprint(EnvironmentLayout::kLatitudeLongitude, width_, image.height, 0, y).solidAngle;
    spread(&image.at(0, y), solidAngle, clampNegative, row, sums);
    for (std::size_t c = 0; c < 3; ++c) {
      sums.energy[c] += solidAngle * sumOfSquares(row.radiance[c]);
      Plane &cosinePart = row.cosinePart[c], &sinePart = row.sinePart[c];
      fold(row.radiance[c].data(), row.radiance[c].size(), cosinePart.data(), sinePart.data());
      if (foldsTwice) {
        // cos m(pi - phi) = (-1)^m cos m phi, sin m(pi - phi) = -(-1)^m sin m phi.
        fold(cosinePart.data(), half_, row.forCosines[0][c].data(), row.forCosines[1][c].data());
        fold(sinePart.data(), half_, row.forSines[1][c].data(), row.forSines[0][c].data());
      } else {
        row.forCosines[0][c] = row.forCosines[1][c] = cosinePart;
        row.forSines[0][c] = row.forSines[1][c] = sinePart;
      }
    }
    const double theta = pi * (y + 0.5) / image.height;
    evaluateSh(degree_, {std::sin(theta), 0, std::cos(theta)}, basis);
    for (int m = 0; m <= degree_; ++m) {
      const std::size_t parity = m % 2 == 0 ? 0 : 1, first = static_cast<std::size_t>(m) * columns_;
      const std::array<double, 3> cosine = dotProducts(&cosines_[first], row.forCosines[parity], columns_);
      std::array<double, 3> sine{};
      if (m > 0) sine = dotProducts(&sines_[first], row.forSines[parity], columns_);
      for (int l = m; l <= degree_; ++l) {
        const double weight = solidAngle * basis[static_cast<std::size_t>(shIndex(l, m))];
        auto& plus = sums.coefficients[static_cast<std::size_t>(shIndex(l, m))];
        auto& minus = sums.coefficients[static_cast<std::size_t>(shIndex(l, -m))];
        for (std::size_t c = 0; c < 3; ++c) {
          plus[c] += weight * cosine[c];
          if (m > 0) minus[c] += weight * sine[c];
        }
      }
    }
  }
}

}  // namespace shprt
