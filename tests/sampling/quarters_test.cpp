// What an error estimate may build on: the differences between quarters, and between halves, of a set tell at
// least the error of the whole.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

#include "disc_integrands.h"
#include "shprt/sampling/hemisphere_set.h"

namespace shprt {
namespace {

using test::Average;
using test::DiscIntegrand;

class QuartersOf : public testing::TestWithParam<PointSet> {};
INSTANTIATE_TEST_SUITE_P(Sets, QuartersOf,
                         testing::Values(PointSet::kLattice, PointSet::kSobol, PointSet::kJittered,
                                         PointSet::kRandom),
                         [](const auto& parameter) { return pointSetName(parameter.param); });

struct Spread {
  double error, halves, quarters;  // squared error of the whole, and what differences of parts say it is
};

Spread spreadOf(const HemisphereSet& set, const std::vector<Vec3d>& directions, const DiscIntegrand& f) {
  std::array<double, 4> sums{}, sizes{};
  for (std::size_t i = 0; i < directions.size(); ++i) {
    sums.at(set.quarters()[i]) += f.value(directions[i]);
    ++sizes.at(set.quarters()[i]);
  }
  const double whole = meanOver(directions, f);
  const double a = (sums[0] + sums[1]) / (sizes[0] + sizes[1]);
  const double b = (sums[2] + sums[3]) / (sizes[2] + sizes[3]);
  Spread spread{(whole - f.mean) * (whole - f.mean), (a - b) * (a - b) / 4, 0};
  for (std::size_t q = 0; q < 4; ++q) spread.quarters += std::pow(sums[q] / sizes[q] - whole, 2) / 12;
  return spread;
}

// For independent halves E (A - B)^2 / 4 is the variance of the whole, (var A + var B) / 4, and likewise for
// quarters. Bias of a part and parts that complement each other add to it.
TEST_P(QuartersOf, TheirDifferencesAreAtLeastTheErrorOfTheWhole) {
  for (const int count : {16, 64, 200, 256, 1024}) {
    const auto set = makeHemisphereSet(GetParam(), count, 16);
    const std::vector<DiscIntegrand> integrands = test::discontinuousIntegrands();
    std::vector<Average> quarterExcess(integrands.size()), halfExcess(integrands.size());
    Average totalExcess;
    Spread total{};
    for (std::uint64_t index = 0; index < 800; ++index) {
      const std::vector<Vec3d> directions = test::directionsOf(*set, 6, index);
      double excess = 0;
      for (std::size_t k = 0; k < integrands.size(); ++k) {
        const Spread spread = spreadOf(*set, directions, integrands[k]);
        quarterExcess[k].add(spread.quarters - spread.error);
        halfExcess[k].add(spread.halves - spread.error);
        excess += spread.halves - spread.error;
        total.error += spread.error, total.halves += spread.halves, total.quarters += spread.quarters;
      }
      totalExcess.add(excess);
    }
    for (std::size_t k = 0; k < integrands.size(); ++k) {
      EXPECT_GE(quarterExcess[k].mean(), -5 * quarterExcess[k].standardError())
          << integrands[k].name << ", " << count << " directions";
      if (GetParam() != PointSet::kLattice) {
        EXPECT_GE(halfExcess[k].mean(), -5 * halfExcess[k].standardError())
            << integrands[k].name << ", " << count << " directions";
      }
    }
    EXPECT_GE(totalExcess.mean(), -5 * totalExcess.standardError()) << count << " directions";
    RecordProperty("halves" + std::to_string(count), std::to_string(std::sqrt(total.halves / total.error)));
    RecordProperty("quarters" + std::to_string(count),
                   std::to_string(std::sqrt(total.quarters / total.error)));
  }
}

}  // namespace
}  // namespace shprt
