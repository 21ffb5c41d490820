// Pictures of a relit asset: one, or one for each turn of the light.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "relight_job.h"
#include "shprt/coefficients/transfer_asset.h"
#include "shprt/picture/render.h"

namespace shprt {

// The radiance of every vertex in a frame.
using FrameRadiance = std::function<std::vector<Vec3f>(int frame)>;

// The camera of --camera, or one that frames the positions. Throws UsageError when the specification means
// nothing.
Camera chooseCamera(const RelightOptions& options, std::span<const Vec3f> positions);

// displayExposure is the factor from radiance to display values of .png; 1 for .exr. Throws Error, and
// Interrupted between rows.
void writePictures(const RelightOptions& options, RelightFormat format, const TransferAsset& asset,
                   const FrameRadiance& radiance, const LightSum& lights, float displayExposure);

// What --background can show. Throws UsageError unless exactly one light is an image.
const EnvironmentMap* backgroundMap(const RelightOptions& options, const LightSum& lights);

}  // namespace shprt
