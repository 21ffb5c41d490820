#include "shprt/report/compare.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <nlohmann/json.hpp>

#include "shprt/sh/basis.h"

namespace shprt {
namespace {

// |a - b|; NaN agrees with nothing, an infinity only with itself.
double errorBetween(double a, double b) {
  return a == b ? 0 : std::abs(a - b);
}

class Tally {
 public:
  explicit Tally(const Tolerance& tolerance) : tolerance_(tolerance) {}

  void add(double a, double b) {
    ++differences_.compared;
    referenceSquares_ += static_cast<long double>(a) * a;
    const double error = errorBetween(a, b);
    if (error == 0) return;
    const double allowed = tolerance_.absolute + tolerance_.relative * std::max(std::abs(a), std::abs(b));
    // Relative to an infinity everything would be within tolerance.
    if (!std::isfinite(error) || error > allowed) ++differences_.beyond;
    if (!(error <= differences_.maximumError) && !std::isnan(differences_.maximumError))
      differences_.maximumError = error;
    squares_ += static_cast<long double>(error) * error;
  }

  Differences result() const {
    Differences result = differences_;
    if (result.compared > 0) {
      result.rmsError = rootOfMean(squares_);
      result.rmsReference = rootOfMean(referenceSquares_);
    }
    return result;
  }

 private:
  double rootOfMean(long double squares) const {
    return static_cast<double>(std::sqrt(squares / static_cast<long double>(differences_.compared)));
  }

  Tolerance tolerance_;
  Differences differences_;
  // The squares of large doubles are beyond double.
  long double squares_ = 0, referenceSquares_ = 0;
};

void comparePart(Comparison& comparison, const char* name, std::size_t count, const Tolerance& tolerance,
                 const std::function<std::pair<double, double>(std::size_t)>& values) {
  Tally tally(tolerance);
  for (std::size_t i = 0; i < count; ++i) {
    const auto [a, b] = values(i);
    tally.add(a, b);
  }
  const Differences differences = tally.result();
  if (differences.beyond == 0) return;
  comparison.differingParts.push_back(
      fmt::format("{}: {} of {} values beyond tolerance, largest difference {:.3g}", name, differences.beyond,
                  differences.compared, differences.maximumError));
}

double component(const Vec3f& v, std::size_t i) {
  return static_cast<double>(i == 0 ? v.x : i == 1 ? v.y : v.z);
}

void compareVectors(Comparison& comparison, const char* name, const std::vector<Vec3f>& a,
                    const std::vector<Vec3f>& b, const Tolerance& tolerance) {
  comparePart(comparison, name, 3 * a.size(), tolerance, [&](std::size_t i) {
    return std::pair(component(a[i / 3], i % 3), component(b[i / 3], i % 3));
  });
}

// Standard errors, as parts beside the transfer. Of the same degree; one channel stands for three.
void compareErrors(Comparison& comparison, const TransferAsset& a, const TransferAsset& b,
                   const Tolerance& tolerance) {
  if (a.error.empty() != b.error.empty()) {
    comparison.differingParts.push_back("error: only one of them has any");
  } else if (!a.error.empty()) {
    const int channels = std::max(a.error.channels, b.error.channels);
    const std::size_t perChannel = static_cast<std::size_t>(a.error.bands()) * a.error.vertexCount;
    const auto value = [&](const TransferError& error, std::size_t i) {
      return static_cast<double>(error.values[error.channels == 1 ? i % perChannel : i]);
    };
    comparePart(comparison, "error", static_cast<std::size_t>(channels) * perChannel, tolerance,
                [&](std::size_t i) { return std::pair(value(a.error, i), value(b.error, i)); });
  }
  if (a.emissionError.size() != b.emissionError.size()) {
    comparison.differingParts.push_back("emissionError: only one of them has any");
  } else {
    compareVectors(comparison, "emissionError", a.emissionError, b.emissionError, tolerance);
  }
}

}  // namespace

Comparison notComparable(const std::string& why) {
  Comparison comparison;
  comparison.comparable = false;
  comparison.whyNot = why;
  return comparison;
}

Comparison compareAssets(const TransferAsset& a, const TransferAsset& b, const Tolerance& tolerance) {
  if (a.transfer.vertexCount != b.transfer.vertexCount) {
    return notComparable(
        fmt::format("they have {} and {} vertices", a.transfer.vertexCount, b.transfer.vertexCount));
  }
  if (a.transfer.degree != b.transfer.degree)
    return notComparable(fmt::format("they have degrees {} and {}", a.transfer.degree, b.transfer.degree));
  Comparison comparison;
  const std::size_t vertices = a.transfer.vertexCount;
  // One channel stands for three equal ones.
  const int channels = std::max(a.transfer.channels, b.transfer.channels);
  Tally total(tolerance);
  std::vector<double> squares(vertices), largest(vertices);
  std::vector<int> largestAt(vertices);
  for (int l = 0; l <= a.transfer.degree; ++l) {
    Tally band(tolerance);
    for (int i = shIndex(l, -l); i <= shIndex(l, l); ++i)
      for (int channel = 0; channel < channels; ++channel) {
        const float* rowA = a.transfer.row(a.transfer.channels == 1 ? 0 : channel, i);
        const float* rowB = b.transfer.row(b.transfer.channels == 1 ? 0 : channel, i);
        for (std::size_t v = 0; v < vertices; ++v) {
          const double valueA = static_cast<double>(rowA[v]), valueB = static_cast<double>(rowB[v]),
                       error = errorBetween(valueA, valueB);
          total.add(valueA, valueB);
          band.add(valueA, valueB);
          // NaN has no place in an order; as the worst error it comes first.
          const double ranked = std::isnan(error) ? HUGE_VAL : error;
          squares[v] += ranked * ranked;
          if (ranked > largest[v]) largest[v] = ranked, largestAt[v] = i;
        }
      }
    comparison.perDegree.push_back(band.result());
  }
  comparison.total = total.result();

  std::vector<std::size_t> order(vertices);
  for (std::size_t v = 0; v < vertices; ++v) order[v] = v;
  const std::size_t shown = std::min<std::size_t>(5, vertices);
  std::partial_sort(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(shown), order.end(),
                    [&](std::size_t x, std::size_t y) {
                      return squares[x] != squares[y] ? squares[x] > squares[y] : x < y;
                    });
  for (std::size_t k = 0; k < shown && squares[order[k]] > 0; ++k) {
    comparison.worst.push_back({order[k], std::sqrt(squares[order[k]]), largestAt[order[k]]});
  }

  compareVectors(comparison, "positions", a.positions, b.positions, tolerance);
  compareVectors(comparison, "normals", a.normals, b.normals, tolerance);
  compareVectors(comparison, "albedo", a.albedo, b.albedo, tolerance);
  if (a.emission.size() != b.emission.size()) {
    comparison.differingParts.push_back("emission: only one of them has any");
  } else {
    compareVectors(comparison, "emission", a.emission, b.emission, tolerance);
  }
  compareErrors(comparison, a, b, tolerance);
  if (a.textureCoordinates.size() != b.textureCoordinates.size()) {
    comparison.differingParts.push_back("textureCoordinates: only one of them has any");
  } else {
    comparePart(
        comparison, "textureCoordinates", 2 * a.textureCoordinates.size(), tolerance, [&](std::size_t i) {
          const Vec2f ta = a.textureCoordinates[i / 2], tb = b.textureCoordinates[i / 2];
          return i % 2 == 0 ? std::pair<double, double>(ta.x, tb.x) : std::pair<double, double>(ta.y, tb.y);
        });
  }
  if (a.triangles.size() != b.triangles.size()) {
    comparison.differingParts.push_back(
        fmt::format("triangles: {} and {}", a.triangles.size(), b.triangles.size()));
  } else if (a.triangles != b.triangles) {
    comparison.differingParts.push_back("triangles: other corners");
  }
  return comparison;
}

Comparison compareLights(const LightCoefficients& a, const LightCoefficients& b, const Tolerance& tolerance) {
  if (a.degree != b.degree)
    return notComparable(fmt::format("they have degrees {} and {}", a.degree, b.degree));
  Comparison comparison;
  Tally total(tolerance);
  for (int l = 0; l <= a.degree; ++l) {
    Tally band(tolerance);
    for (int i = shIndex(l, -l); i <= shIndex(l, l); ++i)
      for (std::size_t colour = 0; colour < 3; ++colour) {
        const double valueA = a.coefficients[static_cast<std::size_t>(i)][colour],
                     valueB = b.coefficients[static_cast<std::size_t>(i)][colour];
        total.add(valueA, valueB);
        band.add(valueA, valueB);
      }
    comparison.perDegree.push_back(band.result());
  }
  comparison.total = total.result();
  return comparison;
}

Comparison compareImages(const Image& a, const Image& b, const Tolerance& tolerance) {
  if (a.width != b.width || a.height != b.height) {
    return notComparable(
        fmt::format("they are {} x {} and {} x {} pixels", a.width, a.height, b.width, b.height));
  }
  Comparison comparison;
  Tally total(tolerance);
  for (std::size_t i = 0; i < 3 * a.pixels.size(); ++i)
    total.add(component(a.pixels[i / 3], i % 3), component(b.pixels[i / 3], i % 3));
  comparison.total = total.result();
  return comparison;
}

std::string formatComparison(const Comparison& comparison, const std::string& nameA,
                             const std::string& nameB) {
  if (!comparison.comparable)
    return fmt::format("{} and {} cannot be compared: {}", nameA, nameB, comparison.whyNot);
  const auto relative = [](const Differences& d) {
    return d.rmsReference > 0 ? d.rmsError / d.rmsReference : d.rmsError > 0 ? HUGE_VAL : 0;
  };
  const Differences& total = comparison.total;
  std::string text = fmt::format(
      "values            {} compared, {} beyond tolerance\nlargest error     {:.4g}\nRMS error         "
      "{:.4g} ({:.4g} of the RMS of {})\n",
      total.compared, total.beyond, total.maximumError, total.rmsError, relative(total), nameA);
  if (total.maximumError > 0 || total.beyond > 0) {
    if (!comparison.perDegree.empty()) {
      text += "degree       largest           RMS      relative        beyond\n";
      for (std::size_t l = 0; l < comparison.perDegree.size(); ++l) {
        const Differences& band = comparison.perDegree[l];
        text += fmt::format("{:>6}  {:>12.4g}  {:>12.4g}  {:>12.4g}  {:>12}\n", l, band.maximumError,
                            band.rmsError, relative(band), band.beyond);
      }
    }
    for (const WorstVertex& worst : comparison.worst) {
      text += fmt::format("worst vertex      {}: error {:.4g}, most in coefficient {} (degree {})\n",
                          worst.vertex, worst.error, worst.coefficient, bandOf(worst.coefficient));
    }
  }
  for (const std::string& part : comparison.differingParts) text += "part              " + part + "\n";
  return text + fmt::format("{}: {} and {}", comparison.equal() ? "equal within tolerance" : "DIFFERENT",
                            nameA, nameB);
}

std::string comparisonToJson(const Comparison& comparison, const std::string& nameA,
                             const std::string& nameB) {
  using Json = nlohmann::ordered_json;
  const auto describe = [](const Differences& d) {
    return Json{{"compared", d.compared},
                {"beyond", d.beyond},
                {"maximumError", d.maximumError},
                {"rmsError", d.rmsError},
                {"rmsReference", d.rmsReference}};
  };
  Json json = {
      {"a", nameA}, {"b", nameB}, {"comparable", comparison.comparable}, {"equal", comparison.equal()}};
  if (!comparison.comparable) {
    json["whyNot"] = comparison.whyNot;
  } else {
    json["total"] = describe(comparison.total);
    json["perDegree"] = Json::array();
    for (const Differences& band : comparison.perDegree) json["perDegree"].push_back(describe(band));
    json["worst"] = Json::array();
    for (const WorstVertex& worst : comparison.worst)
      json["worst"].push_back(
          {{"vertex", worst.vertex}, {"error", worst.error}, {"coefficient", worst.coefficient}});
    json["differingParts"] = comparison.differingParts;
  }
  return json.dump(2, ' ', false, Json::error_handler_t::replace);
}

}  // namespace shprt
