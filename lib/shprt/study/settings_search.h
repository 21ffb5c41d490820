// The cheapest settings for an error, predicted from what each source of error costs by itself.
//
// Sources are taken as independent: their errors add in squares. So each is measured alone, and all
// combinations are a matter of arithmetic; who searches bakes only the winner, and sees how right that was.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "shprt/coefficients/asset_file.h"
#include "shprt/study/bake_settings.h"

namespace shprt {

// What a setting of the rays leaves uncertain, and what it takes.
struct RayCost {
  double setting = 0;  // rays per vertex, or the error that is asked for (requestForError)
  double error = 0;
  double seconds = 0;  // with light that bounces
};

// What is simulated.
struct EffectsCost {
  std::string model;
  std::optional<int> bounces = {};  // as BakeRequest
  double error = 0;                 // by what is left out
  double secondsFactor = 1;         // of RayCost::seconds; 0 where no rays are traced
};

struct DegreeCost {
  int degree = 0;
  double error = 0;  // by what the bands beyond would do
};

struct StorageCost {
  WriteAssetOptions storage;
  double error = 0;
  double bytes = 0, seconds = 0;  // per coefficient of a vertex
};

struct ErrorCosts {
  std::vector<EffectsCost> effects;
  std::vector<DegreeCost> degrees;
  std::vector<RayCost> rays, adaptive;  // errors falling; adaptive may be empty
  std::vector<StorageCost> storage;
};

// Which of two is cheaper: by seconds, and where those agree to about a quarter or 10 ms, which is no reason
// to carry a larger asset, by bytes. Use as std::pair's order.
std::pair<long, double> priceOf(double seconds, double bytes);

struct PredictedSettings {
  BakeSettings settings;
  double error = 0, seconds = 0;
};

// The cheapest with a predicted error of at most `error`; nothing where none is that good. Rays are
// interpolated between those measured, never beyond; what the settings do not fix is as in `defaults`.
std::optional<PredictedSettings> cheapestSettings(const ErrorCosts& costs, double error,
                                                  const BakeRequest& defaults);

// The settings with the least predicted error, whatever they take.
PredictedSettings finestSettings(const ErrorCosts& costs, const BakeRequest& defaults);

}  // namespace shprt
