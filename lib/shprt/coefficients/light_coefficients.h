// A distant light as spherical-harmonic coefficients of its radiance, and its JSON file
// (docs/file-formats.md).
#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <vector>

namespace shprt {

struct LightStatistics {
  std::array<double, 3> averageRadiance{};  // c_0 / sqrt(4 pi)
  std::array<double, 3> directionality{};   // |L1| / L0 in the 4-pi-normalised lighting basis: sqrt of band-1
                                            // energy / (c_0 sqrt 3), in [0,1] for non-negative light
  std::array<double, 3> dominantDirection{};      // unit, of the luminance; zero when there is none
  std::vector<std::array<double, 3>> bandEnergy;  // sum over m of c_lm^2
};

struct LightCoefficients {
  int degree = 0;
  std::vector<std::array<double, 3>>
      coefficients;            // coefficientCount(degree) entries of linear Rec.709 r, g, b
  std::string source;          // what it was made from, one line
  std::string statisticsJson;  // a JSON object with whatever the maker measured; "" for none
};

// From the coefficients alone.
LightStatistics measureLight(const LightCoefficients& light);

// Whether the file looks like a light file (a JSON object with "format":"shprt-light"); false for anything
// else.
bool isLightFile(const std::filesystem::path& path);

// Reads and checks a light file. Throws Error naming the field (format, newer version, other convention,
// wrong count, not finite).
LightCoefficients readLight(const std::filesystem::path& path);

// The text of a light file: doubles in shortest form that reads back to the same bits.
// Throws Error unless every coefficient is a finite number and there are as many as the degree asks for: JSON
// cannot hold others.
void requireWritable(const LightCoefficients& light);
std::string formatLight(const LightCoefficients& light);

// Writes formatLight() atomically. Throws Error when a coefficient is not finite or the count is wrong.
void writeLight(const std::filesystem::path& path, const LightCoefficients& light);

}  // namespace shprt
