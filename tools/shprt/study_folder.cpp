#include "study_folder.h"

#include <system_error>

#include "commands.h"
#include "output.h"
#include "shprt/base/error.h"
#include "shprt/base/file.h"

namespace shprt {
namespace fs = std::filesystem;

fs::path studyJournalPath(const fs::path& folder) {
  return folder / "study-journal.json";
}

std::vector<fs::path> studyFiles(const fs::path& folder) {
  return {folder / "index.html", folder / "study.json", studyJournalPath(folder)};
}

void checkStudyFolder(const fs::path& folder, const std::vector<fs::path>& inputs) {
  if (folder.empty()) throw UsageError("--output: is empty; name a folder");
  std::error_code ignored;
  if (fs::exists(folder, ignored)) {
    if (!fs::is_directory(folder, ignored))
      throw Error(folder.string(), "is a file, and a study fills a folder",
                  "give another name with --output");
    for (const fs::path& file : studyFiles(folder)) {
      checkNotInput(file.string(), inputs);
      const AtomicFile attempt(file);
    }
    return;
  }
  // The nearest that is there must take what is missing below it.
  fs::path parent = fs::absolute(folder).lexically_normal();
  while (!fs::exists(parent, ignored) && parent.has_relative_path()) parent = parent.parent_path();
  if (!fs::is_directory(parent, ignored))
    throw Error(folder.string(), "cannot be made, " + parent.string() + " is a file",
                "give another name with --output");
  const AtomicFile attempt(parent / "shprt-study.json");
}

void makeStudyFolder(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error)
    throw Error(folder.string(), "cannot be made: " + error.message(), "give another name with --output");
}

}  // namespace shprt
