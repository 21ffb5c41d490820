// Gives an asset standard errors that are known: the same for every vertex, channel and band of the transfer,
// and for every colour of the emission, where it has any. For the scripts of this folder.
// Usage: add_errors IN.prt.exr OUT.prt.exr OF_TRANSFER [OF_EMISSION]
#include <cstdio>
#include <exception>
#include <string>
#include <vector>

#include "shprt/coefficients/asset_file.h"

namespace {

void addErrors(const std::vector<std::string>& arguments) {
  shprt::TransferAsset asset = shprt::readAsset(arguments.at(0));
  const shprt::TransferCoefficients& transfer = asset.transfer;
  asset.error = {.degree = transfer.degree,
                 .channels = transfer.channels,
                 .vertexCount = transfer.vertexCount,
                 .values = {}};
  asset.error.values.assign(
      static_cast<std::size_t>(asset.error.channels * asset.error.bands()) * transfer.vertexCount,
      std::stof(arguments.at(2)));
  if (arguments.size() > 3) {
    const float ofEmission = std::stof(arguments[3]);
    asset.emissionError.assign(asset.emission.size(), {ofEmission, ofEmission, ofEmission});
  }
  asset.metadata.samplingError = 0.0625;
  asset.metadata.verticesByRays = {{32, 1}, {64, transfer.vertexCount - 1}};
  shprt::writeAsset(arguments.at(1), asset);
}

}  // namespace

int main(int count, char** values) {
  try {
    addErrors({values + 1, values + count});
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "add_errors: %s\n", error.what());
    return 2;
  }
}
