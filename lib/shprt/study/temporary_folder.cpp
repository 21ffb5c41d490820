#include "shprt/study/temporary_folder.h"

#include <random>
#include <system_error>

#include "shprt/base/error.h"

namespace shprt {

TemporaryFolder::TemporaryFolder() {
  std::error_code failure;
  const std::filesystem::path parent = std::filesystem::temp_directory_path(failure);
  // Names only have to be new: no result depends on them.
  std::random_device device;
  for (int attempt = 0; !failure && attempt < 16; ++attempt) {
    path_ = parent / ("shprt-study-" + std::to_string(device()));
    if (std::filesystem::create_directory(path_, failure)) return;
  }
  throw Error(parent.string(), "holds no new folder for temporary files: " + failure.message(),
              "set TMPDIR to a folder that can be written");
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

}  // namespace shprt
