// Scenes that tests write to files, and what is said about them.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "shprt/base/error.h"
#include "shprt/scene/load_scene.h"
#include "tests/scratch.h"

namespace shprt::test {

// One triangle in the plane z = 0, facing +z; the legs along x and y have these lengths.
inline std::string triangleObj(double x = 1, double y = 1) {
  return "v 0 0 0\nv " + std::to_string(x) + " 0 0\nv 0 " + std::to_string(y) + " 0\nf 1 2 3\n";
}

inline Scene loadText(const std::string& json, const LoadSceneOptions& options = {}) {
  return loadScene(writeScratch("scene.json", json), options);
}

// A scene of the mesh "m.obj" with these further fields: R"("role": "blocker")".
inline std::string oneObject(const std::string& fields) {
  return R"({"objects": [{"file": "m.obj")" + (fields.empty() ? "" : ", " + fields) + "}]}";
}

inline std::string errorOf(const std::string& json) {
  try {
    loadText(json);
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

inline bool hasNote(const Scene& scene, const std::string& fragment) {
  for (const std::string& note : scene.notes) {
    if (note.find(fragment) != std::string::npos) return true;
  }
  return false;
}

}  // namespace shprt::test
