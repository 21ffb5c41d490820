// Options with strict values: whole words only, within stated bounds, and one line that says so otherwise.
#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include "console.h"
#include "shprt/base/vec.h"
#include "shprt/scene/load_scene.h"

namespace shprt {

// All throw CLI::ValidationError "NAME: 'text' is not ..." while parsing. The values given are the defaults
// shown by --help.
CLI::Option* addInteger(CLI::App& app, const std::string& name, int& value, int minimum, int maximum,
                        const std::string& description);
CLI::Option* addInteger(CLI::App& app, const std::string& name, std::optional<int>& value, int minimum,
                        int maximum, const std::string& description);
CLI::Option* addSeed(CLI::App& app, std::uint64_t& seed);
CLI::Option* addNumber(CLI::App& app, const std::string& name, double& value, double minimum, double maximum,
                       const std::string& description);
CLI::Option* addNumber(CLI::App& app, const std::string& name, std::optional<double>& value, double minimum,
                       double maximum, const std::string& description);
// A whole number or "auto", which leaves value empty.
CLI::Option* addIntegerOrAuto(CLI::App& app, const std::string& name, std::optional<int>& value, int minimum,
                              int maximum, const std::string& description);
// Bytes: a whole number, or one with K, M, G or T for powers of 1024.
CLI::Option* addBytes(CLI::App& app, const std::string& name, std::uint64_t& bytes,
                      const std::string& description);
// "r,g,b" or one number for all three.
CLI::Option* addColour(CLI::App& app, const std::string& name, std::optional<Vec3f>& value, double minimum,
                       double maximum, const std::string& description);
// "WIDTHxHEIGHT".
CLI::Option* addSize(CLI::App& app, const std::string& name, int& width, int& height,
                     const std::string& description);
// A text that `parse` understands or refuses by throwing shprt::Error.
CLI::Option* addParsed(CLI::App& app, const std::string& name, const std::string& typeName,
                       const std::function<void(const std::string&)>& parse, const std::string& description);

struct RotationArgument {
  Mat3 matrix;
  double correction = 0;  // by how much a given matrix was off this one, its nearest rotation
  std::string file;       // that @FILE named; "" for none
};
// Says so when a matrix was mended.
void noteCorrection(const Console& console, const std::optional<RotationArgument>& rotation);
CLI::Option* addRotation(CLI::App& app, std::optional<RotationArgument>& rotation);
CLI::Option* addExposure(CLI::App& app, std::optional<double>& exposure, const std::string& description);
CLI::Option* addDegree(CLI::App& app, int& degree);

CLI::Option* addRays(CLI::App& app, int& rays);
// How a scene or mesh is read.
void addLoadingOptions(CLI::App& app, LoadSceneOptions& loading);

struct CommonOptions {
  bool quiet = false;
  std::string jsonFile;  // "" for none, "-" for standard output
};
void addCommonOptions(CLI::App& app, CommonOptions& common);
CLI::Option* addThreads(CLI::App& app, int& threads);

}  // namespace shprt
