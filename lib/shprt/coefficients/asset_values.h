// Whether the numbers of an asset make sense, once its parts have the right sizes.
#pragma once

#include <string>

#include "shprt/coefficients/transfer_asset.h"

namespace shprt {

// The first value that is not finite, negative where that means nothing, or an index beyond the vertices, as
// "part NAME ..."; "" when there is none. All parts have the sizes that the transfer's asks for.
std::string problemOfValues(const TransferAsset& asset);

}  // namespace shprt
