// The sections of docs/numerics.md: each measures, draws its plots into a folder and returns its text.
#pragma once

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numbers>
#include <string>

namespace shprt::numerics {

// Where plots go, and how the page refers to them.
struct Page {
  std::filesystem::path pictures;
  std::string link;  // from the page to the folder, with a slash at the end
};

std::string evaluationSection(const Page& page);
std::string rotationSection(const Page& page);
std::string zonalSection(const Page& page);

// The natural size of a basis function of band l: errors are stated in it.
inline double bandScale(int l) {
  return std::sqrt((2 * l + 1) / (4 * std::numbers::pi));
}

// An error as plots show it: no lower than `least`, and what is no number as what is infinite.
inline double plottedError(double error, double least) {
  return std::isnan(error) ? HUGE_VAL : std::max(error, least);
}

// A row of a table of promises: what was measured beside what is required, and a word that a reader finds.
std::string promiseRow(const std::string& what, double measured, double required);
inline constexpr const char* kPromiseHead = "| what | measured | required | |\n|---|---|---|---|\n";

}  // namespace shprt::numerics
