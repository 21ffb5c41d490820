// What a study has measured so far, on disk, so that one that was interrupted goes on where it was.
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace shprt {

class StudyJournal {
 public:
  // Takes up the journal at `path` if it was kept for the same fingerprint (of tool version, scene, lights
  // and options, say by their hash); else begins a new one, and replaces what is there with the first
  // measurement. A damaged file counts as none. An empty path keeps nothing on disk.
  StudyJournal(std::filesystem::path path, std::string fingerprint);

  // The numbers kept under `key`; where there are none, those that `run` returns, which are kept (written
  // atomically) before this returns. Bits survive. Throws Error when the file cannot be written.
  std::vector<double> measure(const std::string& key, const std::function<std::vector<double>()>& run);

  // How often a measurement did not have to be made again.
  std::size_t reused() const { return reused_; }
  // Measurements asked for so far that an earlier run had made.
  std::size_t fromBefore() const { return fromBefore_.size(); }

 private:
  void write() const;

  std::filesystem::path path_;
  std::string fingerprint_;
  std::map<std::string, std::vector<double>> kept_;
  std::set<std::string> before_, fromBefore_;  // keys that were on disk; those of them that were asked for
  std::size_t reused_ = 0;
};

}  // namespace shprt
