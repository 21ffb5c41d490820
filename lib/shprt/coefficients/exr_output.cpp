#include "shprt/coefficients/exr_output.h"

#include <cerrno>
#include <cstring>
#include <string>

#include "shprt/base/error.h"

namespace shprt {

ExrOutput::ExrOutput(const std::filesystem::path& path, const std::filesystem::path& name)
    : Imf::OStream(name.c_str()), name_(name), file_(std::fopen(path.c_str(), "wb")) {
  if (!file_) throw Error(name.string(), std::string("cannot be written: ") + std::strerror(errno));
}

ExrOutput::~ExrOutput() {
  if (file_) std::fclose(file_);
}

void ExrOutput::fail() {
  if (!error_) error_ = errno ? errno : EIO;
  throw Error(name_.string(), std::string("cannot be written: ") + std::strerror(error_));
}

void ExrOutput::write(const char bytes[], int count) {
  errno = 0;
  if (std::fwrite(bytes, 1, static_cast<std::size_t>(count), file_) != static_cast<std::size_t>(count))
    fail();
}

std::uint64_t ExrOutput::tellp() {
  const long position = std::ftell(file_);
  if (position < 0) fail();
  return static_cast<std::uint64_t>(position);
}

void ExrOutput::seekp(std::uint64_t position) {
  errno = 0;
  if (std::fseek(file_, static_cast<long>(position), SEEK_SET) != 0) fail();
}

void ExrOutput::close() {
  errno = 0;
  const bool failedBefore = std::ferror(file_) != 0;
  const bool closed = std::fclose(file_) == 0;
  file_ = nullptr;
  if (error_ || failedBefore || !closed) fail();
}

}  // namespace shprt
