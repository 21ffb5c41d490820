#include "relight_pictures.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "commands.h"
#include "interrupt.h"
#include "progress_bar.h"
#include "shprt/base/error.h"
#include "shprt/picture/render.h"
#include "shprt/picture/tone_map.h"

namespace shprt {
namespace {

// Dark enough to leave the mesh its contrast, and not black, so that its own black parts show.
constexpr Vec3f kDefaultBackground{0.035f, 0.035f, 0.035f};

// Background colours are given as they shall be seen, so exposure is taken out of them beforehand.
Vec3f plainBackground(const RelightOptions& options, RelightFormat format, float displayExposure) {
  if (options.backgroundColour) return *options.backgroundColour * (1 / displayExposure);
  return format == RelightFormat::kPng ? kDefaultBackground * (1 / displayExposure) : Vec3f{};
}

}  // namespace

Camera chooseCamera(const RelightOptions& options, std::span<const Vec3f> positions) {
  const double aspect = static_cast<double>(options.width) / options.height;
  if (options.camera.empty()) return frameCamera(positions, aspect);
  try {
    return parseCamera(options.camera, positions, aspect);
  } catch (const Error& error) {
    throw UsageError(std::string("--camera: ") + error.what());
  }
}

const EnvironmentMap* backgroundMap(const RelightOptions& options, const LightSum& lights) {
  if (!options.background) return nullptr;
  if (lights.maps.size() != 1) {
    throw UsageError("--background: needs exactly one image among the lights, here are " +
                     std::to_string(lights.maps.size()));
  }
  return &lights.maps.front();
}

void writePictures(const RelightOptions& options, RelightFormat format, const TransferAsset& asset,
                   const FrameRadiance& radiance, const LightSum& lights, float displayExposure) {
  const Camera camera = chooseCamera(options, asset.positions);
  RenderOptions render;
  render.width = options.width;
  render.height = options.height;
  render.samples = options.samples;
  render.environment = backgroundMap(options, lights);
  render.environmentScale = static_cast<float>(std::exp2(options.exposure.value_or(0)));
  render.background = plainBackground(options, format, displayExposure);

  const MeshRenderer renderer(asset.positions, asset.normals, asset.triangles);
  ProgressBar bar("rendering", options.common.quiet);
  const ProgressCallback show = bar.callback();
  const InterruptGuard guard;
  const int frames = frameCount(options);
  for (int frame = 0; frame < frames; ++frame) {
    render.environmentRotation = frameRotation(options, frame).value_or(Mat3{});
    const Image image = renderer.render(camera, radiance(frame), render, [&](ProgressReport report) {
      // One bar for all frames.
      const std::uint64_t raysPerRow = report.rays / std::max<std::uint64_t>(report.done, 1);
      report.done += static_cast<std::uint64_t>(frame) * report.total;
      report.rays = raysPerRow * report.done;
      report.total *= static_cast<std::uint64_t>(frames);
      show(report);
    });
    throwIfInterrupted();
    saveImage(frameFile(options, frame),
              format == RelightFormat::kPng ? encodeSrgb(image, displayExposure) : image);
  }
}

}  // namespace shprt
