// The folder of a study: what may be written there, and what is.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace shprt {

// index.html, study.json and the journal in it.
std::vector<std::filesystem::path> studyFiles(const std::filesystem::path& folder);
std::filesystem::path studyJournalPath(const std::filesystem::path& folder);

// Throws Error when no study can be written to that folder: something else has its name, it cannot be made or
// written, one of the files is a folder, or is an input. Leaves nothing behind.
void checkStudyFolder(const std::filesystem::path& folder, const std::vector<std::filesystem::path>& inputs);

// Makes the folder where it is missing. Throws Error when that fails.
void makeStudyFolder(const std::filesystem::path& folder);

}  // namespace shprt
