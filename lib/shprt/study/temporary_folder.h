// A new folder among the system's temporary files, which goes away with everything in it.
#pragma once

#include <filesystem>

namespace shprt {

class TemporaryFolder {
 public:
  TemporaryFolder();  // throws Error when it cannot be made
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace shprt
