#include "shprt/base/file.h"

#include <fcntl.h>
#include <openssl/evp.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <memory>
#include <system_error>
#include <vector>

#include "shprt/base/error.h"

namespace shprt {
namespace {

namespace fs = std::filesystem;

struct FileCloser {
  void operator()(std::FILE* file) const { std::fclose(file); }
};
using FilePointer = std::unique_ptr<std::FILE, FileCloser>;

std::string systemMessage() {
  return std::strerror(errno);
}

// The names of temporary files that are under way, where a signal handler can read them. More than fit are
// not removed by it.
std::array<std::atomic<const char*>, 16> temporaries{};

void enlist(const char* name) {
  for (auto& slot : temporaries) {
    const char* none = nullptr;
    if (slot.compare_exchange_strong(none, name)) return;
  }
}

void delist(const char* name) {
  for (auto& slot : temporaries) {
    const char* own = name;
    if (slot.compare_exchange_strong(own, nullptr)) return;
  }
}

// The file that a link names, through links to links; it need not exist.
fs::path followLinks(fs::path path) {
  constexpr int kMostLinks = 40;  // as Linux has it
  std::error_code error;
  for (int link = 0; link < kMostLinks; ++link) {
    if (!fs::is_symlink(fs::symlink_status(path, error))) return path;
    path = path.parent_path() / fs::read_symlink(path, error);
  }
  throw Error(path.string(), "is a link that leads back to itself", "give another output file");
}

}  // namespace

std::string readFile(const fs::path& path, std::uint64_t maximumBytes) {
  std::error_code ignored;
  const fs::file_status status = fs::status(path, ignored);
  if (status.type() == fs::file_type::not_found) {
    throw Error(path.string(), "no such file", "check the path");
  }
  if (fs::is_directory(status)) throw Error(path.string(), "is a directory", "give a file");
  if (!fs::is_regular_file(status))
    throw Error(path.string(), "is a pipe or device", "save its content to a file first");
  const FilePointer file(std::fopen(path.c_str(), "rb"));
  if (!file) throw Error(path.string(), "cannot be opened: " + systemMessage());
  std::string bytes;
  const std::uint64_t size = fs::file_size(path, ignored);
  if (!ignored && size > maximumBytes) {
    throw Error(path.string(),
                "has " + std::to_string(size) + " bytes, more than this kind of file may have");
  }
  if (!ignored) bytes.reserve(size);
  std::array<char, 1 << 16> buffer;
  while (const std::size_t got = std::fread(buffer.data(), 1, buffer.size(), file.get())) {
    bytes.append(buffer.data(), got);
    if (bytes.size() > maximumBytes) {
      throw Error(path.string(), "is larger than this kind of file may be");
    }
  }
  if (std::ferror(file.get())) throw Error(path.string(), "cannot be read: " + systemMessage());
  return bytes;
}

std::string readFirstBytes(const fs::path& path, std::size_t count) {
  const FilePointer file(std::fopen(path.c_str(), "rb"));
  if (!file) return {};
  std::string bytes(count, '\0');
  bytes.resize(std::fread(bytes.data(), 1, count, file.get()));
  return bytes;
}

bool isLfsPointer(std::string_view bytes) {
  return bytes.starts_with("version https://git-lfs");
}

std::string sha256OfFile(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) throw Error(path.string(), "cannot be opened", "check its permissions");
  const std::unique_ptr<EVP_MD_CTX, decltype(&EVP_MD_CTX_free)> context(EVP_MD_CTX_new(), EVP_MD_CTX_free);
  EVP_DigestInit_ex(context.get(), EVP_sha256(), nullptr);
  std::vector<char> block(std::size_t{1} << 16);
  while (file.read(block.data(), static_cast<std::streamsize>(block.size())) || file.gcount() > 0)
    EVP_DigestUpdate(context.get(), block.data(), static_cast<std::size_t>(file.gcount()));
  if (file.bad()) throw Error(path.string(), "cannot be read");
  std::array<unsigned char, EVP_MAX_MD_SIZE> digest{};
  unsigned int size = 0;
  EVP_DigestFinal_ex(context.get(), digest.data(), &size);
  std::string text;
  for (unsigned int i = 0; i < size; ++i) {
    constexpr char kDigits[] = "0123456789abcdef";
    text += kDigits[digest[i] >> 4];
    text += kDigits[digest[i] & 15];
  }
  return text;
}

AtomicFile::AtomicFile(const fs::path& target) : target_(target) {
  std::error_code error;
  if (target.filename().empty()) throw Error(target.string(), "names no file", "give an output file");
  const fs::file_status status = fs::status(target, error);
  if (fs::is_directory(status)) throw Error(target.string(), "is a directory", "give an output file");
  if (fs::exists(status) && !fs::is_regular_file(status)) {
    direct_ = true;
    temporary_ = target;
    return;
  }
  // A link is followed, so that the file it names is replaced and not the link.
  target_ = followLinks(target);
  const fs::path folder = target_.has_parent_path() ? target_.parent_path() : fs::path(".");
  if (!fs::is_directory(folder, error)) {
    throw Error(target.string(), "the folder " + folder.string() + " does not exist", "create it first");
  }
  // A unique name beside the target; created here, so that an unwritable folder is found before the work is
  // done.
  static int counter = 0;
  constexpr std::size_t kLongestStem = 200;  // whole names have at most 255 characters
  temporary_ =
      folder / ("." + target_.stem().string().substr(0, kLongestStem) + "." + std::to_string(::getpid()) +
                "-" + std::to_string(counter++) + target_.extension().string());
  const int descriptor = ::open(temporary_.c_str(), O_CREAT | O_EXCL | O_WRONLY | O_CLOEXEC, 0666);
  if (descriptor < 0) throw Error(target.string(), "cannot be written: " + systemMessage());
  ::close(descriptor);
  enlist(temporary_.c_str());
}

AtomicFile::~AtomicFile() {
  if (direct_) return;
  std::error_code ignored;
  if (!committed_) fs::remove(temporary_, ignored);
  delist(temporary_.c_str());
}

void AtomicFile::commit() {
  if (!direct_) {
    std::error_code error;
    fs::rename(temporary_, target_, error);
    if (error) throw Error(target_.string(), "cannot be written: " + error.message());
  }
  committed_ = true;
}

void removeTemporaryFiles() noexcept {
  for (const auto& slot : temporaries) {
    if (const char* name = slot.load()) ::unlink(name);
  }
}

void writeFile(const fs::path& target, std::string_view bytes) {
  AtomicFile output(target);
  std::FILE* file = std::fopen(output.path().c_str(), "wb");
  if (!file) throw Error(target.string(), "cannot be written: " + systemMessage());
  errno = 0;
  bool good = std::fwrite(bytes.data(), 1, bytes.size(), file) == bytes.size();
  const int failure = errno;
  good = std::fclose(file) == 0 && good;
  if (!good) {
    if (failure) errno = failure;
    throw Error(target.string(), "cannot be written: " + systemMessage());
  }
  output.commit();
}

}  // namespace shprt
