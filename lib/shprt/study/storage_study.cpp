#include "shprt/study/storage_study.h"

#include <fmt/format.h>

#include <cmath>

#include "shprt/coefficients/asset_file.h"
#include "shprt/study/curve_effort.h"
#include "shprt/study/reference.h"
#include "shprt/study/section_parts.h"
#include "shprt/study/study_bake.h"
#include "shprt/study/temporary_folder.h"
#include "shprt/transfer/planned_bake.h"
#include "shprt/transfer/stopwatch.h"

namespace shprt {
namespace {

struct StorageChoice {
  const char* name;
  const char* id;
  WriteAssetOptions options;
};
constexpr StorageChoice kChoices[] = {
    {"float", "float.none", {false, AssetCompression::kNone}},
    {"float, zip", "float.zip", {false, AssetCompression::kZip}},
    {"float, zips", "float.zips", {false, AssetCompression::kZips}},
    {"float, piz", "float.piz", {false, AssetCompression::kPiz}},
    {"half", "half.none", {true, AssetCompression::kNone}},
    {"half, zip", "half.zip", {true, AssetCompression::kZip}},
    {"half, zips", "half.zips", {true, AssetCompression::kZips}},
    {"half, piz", "half.piz", {true, AssetCompression::kPiz}},
};

struct StorageMeasurement {
  double bytesPerVertex = 0, writeSeconds = 0, readSeconds = 0, error = 0;
};

BakeRequest defaultRequest(const StudyRun& run) {
  return followPlan(run.plan, {.degree = run.options.degree,
                               .rays = run.options.rays,
                               .seed = run.options.seed,
                               .error = run.options.error});
}

StorageMeasurement measureStorage(const TransferAsset& asset, const WriteAssetOptions& options) {
  const TemporaryFolder folder;
  const std::filesystem::path file = folder.path() / "asset.prt.exr";
  StorageMeasurement measured;
  measured.writeSeconds = bestSeconds([&] {
    const Stopwatch watch;
    writeAsset(file, asset, options);
    return watch.seconds();
  });
  TransferAsset stored;
  measured.readSeconds = bestSeconds([&] {
    const Stopwatch watch;
    stored = readAsset(file);
    return watch.seconds();
  });
  measured.bytesPerVertex = shareOf(static_cast<double>(std::filesystem::file_size(file)),
                                    static_cast<double>(asset.transfer.vertexCount));
  measured.error = shareOf(rmsDifference(stored.transfer, asset.transfer), rmsNorm(asset.transfer));
  return measured;
}

std::string describe(const std::vector<StorageMeasurement>& measured) {
  std::size_t smallest = 0, smallestExact = 0;
  for (std::size_t i = 0; i < measured.size(); ++i) {
    if (measured[i].bytesPerVertex < measured[smallest].bytesPerVertex) smallest = i;
    if (measured[i].error == 0 && measured[i].bytesPerVertex < measured[smallestExact].bytesPerVertex)
      smallestExact = i;
  }
  const auto say = [&](std::size_t i) {
    const double saved = 1 - measured[i].bytesPerVertex / measured[0].bytesPerVertex;
    const double slower = shareOf(measured[i].writeSeconds, measured[0].writeSeconds);
    return fmt::format(
        "\"{}\": {} bytes per vertex, {:.0f}% less than float without compression, written in {} "
        "times its time, with an error of {}",
        kChoices[i].name, shortNumber(measured[i].bytesPerVertex), 100 * saved, shortNumber(slower),
        shortNumber(measured[i].error));
  };
  std::string text = "Smallest of all is " + say(smallest) + ".";
  if (smallestExact == 0)
    text += " No compression makes floats smaller.";
  else if (smallestExact != smallest)
    text += " Smallest without error is " + say(smallestExact) + ".";
  return text + "\n";
}

StudySection measureSection(StudyRun& run) {
  const BakeRequest request = defaultRequest(run);
  Lazy<TransferAsset> asset([&run] { return bakeForStudy(run, defaultRequest(run)).asset; });
  StudySection section = beginSection("storage", "Error against storage");
  StudyTable table{"storage",
                   "Assets on disk",
                   {"stored as", "bytes per vertex", "write, seconds", "read, seconds", "error"},
                   {}};
  std::vector<StorageMeasurement> all;
  for (const StorageChoice& choice : kChoices) {
    run.announce(std::string("assets as ") + choice.name);
    const std::string key =
        fmt::format("storage: {}, {} of degree {}, {} rays, seed {}, bounces to {}", choice.id, request.model,
                    request.degree, request.rays, request.seed, request.error);
    const std::vector<double> numbers = run.journal.measure(key, [&] {
      const StorageMeasurement measured = measureStorage(asset.get(), choice.options);
      return std::vector{measured.bytesPerVertex, measured.writeSeconds, measured.readSeconds,
                         measured.error};
    });
    const StorageMeasurement& measured =
        all.emplace_back(StorageMeasurement{numbers[0], numbers[1], numbers[2], numbers[3]});
    table.rows.push_back({choice.name, fmt::format("{:.1f}", measured.bytesPerVertex),
                          shortNumber(measured.writeSeconds), shortNumber(measured.readSeconds),
                          shortNumber(measured.error)});
    const std::string name = std::string("storage.") + choice.id;
    section.figures.insert(section.figures.end(), {{name + ".bytesPerVertex", measured.bytesPerVertex},
                                                   {name + ".writeSeconds", measured.writeSeconds},
                                                   {name + ".readSeconds", measured.readSeconds},
                                                   {name + ".error", measured.error}});
  }
  section.text = fmt::format(
      "The {} transfer of degree {} of the default settings, written and read back; bytes of the whole file, "
      "geometry included. Error is the RMS over vertices of the coefficients' error, over that of the "
      "transfer "
      "itself.\n",
      request.model, request.degree);
  section.text += describe(all);
  section.tables.push_back(std::move(table));
  return section;
}

}  // namespace

StudyExperiment storageStudy(const StudyRun&) {
  return {"storage", static_cast<int>(std::size(kChoices)), measureSection};
}

}  // namespace shprt
