// Radiance per vertex as text: CSV for spreadsheets, JSON for programs.
#pragma once

#include <span>
#include <string>

#include "shprt/base/vec.h"
#include "shprt/coefficients/transfer_asset.h"

namespace shprt {

// Standard errors are per vertex, as radiance, or empty: then their columns and their array are not there.

// A line x,y,z,nx,ny,nz,r,g,b[,r_error,g_error,b_error], then one per vertex; floats in the shortest form
// that reads back to the same bits.
std::string formatRadianceCsv(const TransferAsset& asset, std::span<const Vec3f> radiance,
                              std::span<const Vec3f> standardErrors);

// {"format":"shprt-radiance","version":1,"vertexCount":n,"positions":[[x,y,z],...],"normals":...,"radiance":[[r,g,b],...]
// [,"standardErrors":[[r,g,b],...]]}
std::string formatRadianceJson(const TransferAsset& asset, std::span<const Vec3f> radiance,
                               std::span<const Vec3f> standardErrors);

}  // namespace shprt
