// How two coefficient files, light files or pictures differ: what CI golden comparison asks.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "shprt/coefficients/light_coefficients.h"
#include "shprt/coefficients/transfer_asset.h"
#include "shprt/image/image.h"

namespace shprt {

struct Tolerance {
  double relative = 0;
  double absolute = 0;  // values a, b agree when |a - b| <= absolute + relative * max(|a|, |b|)
};

struct Differences {
  std::uint64_t compared = 0;
  std::uint64_t beyond = 0;  // values that do not agree
  double maximumError = 0;   // |a - b|
  double rmsError = 0;
  double rmsReference = 0;  // of A
};

struct WorstVertex {
  std::uint64_t vertex = 0;
  double error = 0;     // 2-norm over its coefficients and channels
  int coefficient = 0;  // of the largest single error
};

struct Comparison {
  bool comparable = true;
  std::string whyNot;  // one line
  Differences total;
  std::vector<Differences> perDegree;       // coefficient and light files
  std::vector<WorstVertex> worst;           // coefficient files, up to 5, worst first
  std::vector<std::string> differingParts;  // assets: parts beside the transfer that differ ("positions: 3
                                            // values beyond tolerance, max 1e-3")
  bool equal() const { return comparable && total.beyond == 0 && differingParts.empty(); }
};

// The answer for files that have no common measure. why is one line.
Comparison notComparable(const std::string& why);

Comparison compareAssets(const TransferAsset& a, const TransferAsset& b, const Tolerance& tolerance);
Comparison compareLights(const LightCoefficients& a, const LightCoefficients& b, const Tolerance& tolerance);
Comparison compareImages(const Image& a, const Image& b, const Tolerance& tolerance);

// The comparison as text for people and as a JSON object.
std::string formatComparison(const Comparison& comparison, const std::string& nameA,
                             const std::string& nameB);
std::string comparisonToJson(const Comparison& comparison, const std::string& nameA,
                             const std::string& nameB);

}  // namespace shprt
