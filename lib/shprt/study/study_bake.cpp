#include "shprt/study/study_bake.h"

#include <algorithm>
#include <filesystem>
#include <utility>

#include "shprt/base/file.h"
#include "shprt/base/version.h"
#include "shprt/coefficients/select_vertices.h"
#include "shprt/relight/relight.h"
#include "shprt/study/reference.h"
#include "shprt/transfer/stopwatch.h"

namespace shprt {
StudyBake bakeForStudy(const StudyRun& run, const BakeRequest& request) {
  const Scene& scene = run.prepared.scene;
  const Stopwatch watch;
  Bake bake = bakeRequested(run.prepared, request, run.progress);
  StudyBake result;
  result.seconds = watch.seconds();
  if (bake.statistics.rays > 0) result.seconds += run.prepared.buildSeconds;
  result.sampling = std::move(bake.statistics.sampling);
  TransferAsset asset;
  asset.transfer = std::move(bake.transfer);
  asset.emission = std::move(bake.emission);
  asset.positions = scene.mesh.positions;
  asset.normals = scene.mesh.normals;
  asset.albedo = scene.albedo;
  asset.textureCoordinates = scene.mesh.textureCoordinates;
  asset.triangles = scene.mesh.triangles;
  asset.metadata.toolVersion = kVersion;
  asset.metadata.model = request.model;
  result.asset = selectVertices(std::move(asset), receiverVertices(scene));
  return result;
}

StoredAsset storeAndRead(const TransferAsset& asset, const WriteAssetOptions& options) {
  const AtomicFile file(std::filesystem::temp_directory_path() / "shprt-study.prt.exr");
  StoredAsset stored;
  const Stopwatch watch;
  writeAsset(file.path(), asset, options);
  stored.seconds = watch.seconds();
  stored.bytes = std::filesystem::file_size(file.path());
  stored.asset = readAsset(file.path());
  return stored;
}

double relightSeconds(const TransferAsset& asset, const LightCoefficients* light) {
  constexpr int kLeast = 3, kMost = 100;
  constexpr double kEnough = 0.05;
  LightCoefficients any;
  if (!light) {
    any.degree = asset.transfer.degree;
    any.coefficients.resize(static_cast<std::size_t>(coefficientCount(any.degree)), {1, 1, 1});
    light = &any;
  }
  const Stopwatch all;
  double least = 0;
  for (int go = 0; go < kMost && (go < kLeast || all.seconds() < kEnough); ++go) {
    const Stopwatch watch;
    relight(asset, *light, 1);
    const double seconds = watch.seconds();
    least = go == 0 ? seconds : std::min(least, seconds);
  }
  return least;
}

}  // namespace shprt
