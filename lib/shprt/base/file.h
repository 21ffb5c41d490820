// Files as the project treats them: read whole, written beside the target and renamed into place.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace shprt {

// The whole content of a file. Throws Error when it is missing, no regular file, unreadable, or larger than
// maximumBytes.
std::string readFile(const std::filesystem::path& path, std::uint64_t maximumBytes = std::uint64_t{1} << 40);

// At most `count` bytes from the beginning of a file, to see what it is; empty when it cannot be read.
std::string readFirstBytes(const std::filesystem::path& path, std::size_t count);

// Whether bytes begin like a git-LFS pointer, which stands where `git lfs pull` has not brought the file
// itself.
bool isLfsPointer(std::string_view bytes);

// SHA-256 of a file's content in lower-case hexadecimal, as `sha256sum` prints it, read block by block.
// Throws Error when the file cannot be read.
std::string sha256OfFile(const std::filesystem::path& path);

// An output file that appears under its name only when complete: write to path(), then commit(). Without
// commit() the destructor removes what was written, and an older file of that name stays as it was. A target
// that exists and is no regular file (/dev/stdout, a pipe) is written directly.
class AtomicFile {
 public:
  // Throws Error when the folder is missing or cannot be written, or when the target is a directory.
  explicit AtomicFile(const std::filesystem::path& target);
  ~AtomicFile();
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;

  // Where to write; ends like the target, so that writers that go by the suffix work.
  const std::filesystem::path& path() const { return temporary_; }
  // Renames path() to the target. Throws Error when that fails.
  void commit();

 private:
  std::filesystem::path target_;
  std::filesystem::path temporary_;
  bool direct_ = false;
  bool committed_ = false;
};

// Removes what unfinished AtomicFiles have written so far. Async-signal-safe: for handlers that end the
// process.
void removeTemporaryFiles() noexcept;

// Writes bytes to the target through AtomicFile. Throws Error on any failure (no space left, no permission).
void writeFile(const std::filesystem::path& target, std::string_view bytes);

}  // namespace shprt
