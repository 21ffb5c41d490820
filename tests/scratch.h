// Files that a test writes: each test has a folder of its own, because ctest runs them side by side.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

namespace shprt::test {

inline std::string scratch(const std::string& name) {
  const testing::TestInfo& test = *testing::UnitTest::GetInstance()->current_test_info();
  const std::filesystem::path folder = std::filesystem::path(SHPRT_TEST_OUTPUT_DIR) /
                                       (std::string(test.test_suite_name()) + "." + test.name());
  std::filesystem::create_directories(folder);
  return (folder / name).string();
}

inline std::string writeScratch(const std::string& name, const std::string& bytes) {
  const std::string path = scratch(name);
  std::ofstream(path, std::ios::binary) << bytes;
  return path;
}

}  // namespace shprt::test
