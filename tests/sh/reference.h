// The golden values of shared/reference, for the tests of this room.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

namespace shprt::test {

inline bool haveReference() {
  return std::filesystem::exists(SHPRT_SHARED_DIR "/reference/sh_eval.json");
}

inline nlohmann::json readReference(const std::string& name) {
  return nlohmann::json::parse(std::ifstream(SHPRT_SHARED_DIR "/reference/" + name));
}

}  // namespace shprt::test

#define SHPRT_NEEDS_REFERENCE() \
  if (!shprt::test::haveReference()) GTEST_SKIP() << "SKIPPED: no reference values in " SHPRT_SHARED_DIR
