#include "shprt/coefficients/basis_name.h"

namespace shprt {

void checkBasis(const JsonObject& file) {
  const JsonObject basis = file.object("basis");
  const nlohmann::json& phase = basis.field("condonShortley");
  if (basis.text("convention") != kBasisConvention || !phase.is_boolean() || phase.get<bool>() ||
      basis.text("index") != kBasisIndex) {
    file.fail("basis",
              "is another convention than real-orthonormal without Condon-Shortley phase, index l(l+1)+m",
              "convert the file first");
  }
}

}  // namespace shprt
