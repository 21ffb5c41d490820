// A file that OpenEXR writes to without hiding failures: its own streams swallow what goes wrong while
// closing.
#pragma once

#include <OpenEXR/ImfIO.h>

#include <cstdint>
#include <cstdio>
#include <filesystem>

namespace shprt {

class ExrOutput final : public Imf::OStream {
 public:
  // Throws Error when the file cannot be opened. name is for messages.
  ExrOutput(const std::filesystem::path& path, const std::filesystem::path& name);
  ~ExrOutput() override;

  void write(const char bytes[], int count) override;
  std::uint64_t tellp() override;
  void seekp(std::uint64_t position) override;

  // Closes the file. Throws Error when anything that was written did not arrive.
  void close();

 private:
  [[noreturn]] void fail();

  std::filesystem::path name_;
  std::FILE* file_;
  int error_ = 0;
};

}  // namespace shprt
