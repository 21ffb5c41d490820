#include "light_arguments.h"

#include <fmt/core.h>

#include <utility>

#include "commands.h"
#include "console.h"
#include "file_kind.h"
#include "shprt/base/error.h"
#include "shprt/light/light_list.h"
#include "shprt/sh/basis.h"

namespace shprt {
namespace {

std::vector<std::string> mendingNotes(const ProbeProjection& projection, bool clampNegative) {
  std::vector<std::string> notes;
  if (projection.nonFinitePixels > 0) {
    notes.push_back(countOf(projection.nonFinitePixels, "pixel is", "pixels are") +
                    " NaN or infinite: left out, the others stand for their solid angle");
  }
  if (projection.negativePixels > 0) {
    notes.push_back(countOf(projection.negativePixels, "pixel has", "pixels have") + " negative values, " +
                    (clampNegative ? "taken as 0" : "used as they are; --clamp-negative makes them 0"));
  }
  return notes;
}

LoadedLight loadImageLight(const std::string& path, const LightOptions& options) {
  if (options.degree > kMaximumBakeDegree) {
    throw UsageError(
        fmt::format("--degree: {} is not from 0 to {}, and {} is an image; lists of directional and "
                    "constant lights go to {}",
                    options.degree, kMaximumBakeDegree, path, kMaximumLightDegree));
  }
  LoadedLight loaded;
  loaded.map = loadEnvironment(path, options.layout);
  loaded.projection = projectProbe(
      *loaded.map,
      {.degree = options.degree, .clampNegative = options.clampNegative, .strict = options.strict});
  loaded.sources = loaded.map->sources;
  loaded.light = std::move(loaded.projection->light);
  loaded.notes.push_back(std::string("layout ") + layoutName(loaded.map->layout) + ", " +
                         loaded.map->layoutReason);
  loaded.notes.insert(loaded.notes.end(), loaded.map->notes.begin(), loaded.map->notes.end());
  const std::vector<std::string> mended = mendingNotes(*loaded.projection, options.clampNegative);
  loaded.notes.insert(loaded.notes.end(), mended.begin(), mended.end());
  return loaded;
}

}  // namespace

LoadedLight loadLight(const std::string& path, const LightOptions& options) {
  const FileKind kind = fileKind(path);
  if (kind == FileKind::kImage) return loadImageLight(path, options);
  if (options.layout) throw UsageError("--layout: " + path + " is no image");
  LoadedLight loaded;
  if (kind == FileKind::kLight) {
    loaded.light = readLight(path);
  } else if (kind == FileKind::kLightList) {
    ProjectedList list = projectLightList(path, options.degree, options.strict);
    loaded.light = std::move(list.light);
    loaded.notes = std::move(list.notes);
    loaded.sources = std::move(list.sources);
  } else {
    throw Error(path, std::string("is ") + kindName(kind) + ", not a light",
                "give a light file, a list of lights or an image");
  }
  return loaded;
}

std::vector<LightCoefficients> loadPlanLights(const Console& console, const std::vector<std::string>& paths,
                                              std::optional<EnvironmentLayout> layout,
                                              std::vector<std::filesystem::path>& sources) {
  constexpr int kDegree = 16;
  std::vector<LightCoefficients> lights;
  for (const std::string& path : paths) {
    LoadedLight light = loadLight(path, {.degree = kDegree, .layout = layout});
    for (const std::string& note : light.notes) console.note(path + ": " + note);
    sources.insert(sources.end(), light.sources.begin(), light.sources.end());
    lights.push_back(std::move(light.light));
  }
  return lights;
}

CLI::Option* addLayout(CLI::App& app, std::optional<EnvironmentLayout>& layout) {
  const auto parse = [&layout](const std::string& text) {
    layout = text == "auto" ? std::nullopt : std::optional(parseLayout(text));
  };
  return addParsed(
             app, "--layout", "NAME", parse,
             "How an image covers the sphere: auto | latlong | angular | mirrored-ball | vertical-cross | "
             "horizontal-cross | faces | strip | exr-cube")
      ->default_str("auto");
}

}  // namespace shprt
