// All three streams are files in memory: nothing can block on a full pipe, and a program that ends before it
// has read its input is no event.
#include "shprt/report/child_process.h"

#include <fmt/format.h>
#include <signal.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <string_view>
#include <thread>

namespace shprt {
namespace {

class MemoryFile {
 public:
  MemoryFile() : descriptor_(::memfd_create("shprt", MFD_CLOEXEC)) {}
  ~MemoryFile() {
    if (descriptor_ >= 0) ::close(descriptor_);
  }
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;

  int descriptor() const { return descriptor_; }
  bool good() const { return descriptor_ >= 0; }

  bool fill(std::string_view text) {
    while (!text.empty()) {
      const ssize_t wrote = ::write(descriptor_, text.data(), text.size());
      if (wrote < 0 && errno == EINTR) continue;
      if (wrote <= 0) return false;
      text.remove_prefix(static_cast<std::size_t>(wrote));
    }
    return ::lseek(descriptor_, 0, SEEK_SET) == 0;
  }
  std::uint64_t bytes() const {
    struct stat status;
    return ::fstat(descriptor_, &status) == 0 ? static_cast<std::uint64_t>(status.st_size) : 0;
  }
  std::string content() const {
    std::string text;
    std::array<char, 1 << 14> block;
    while (text.size() < kMostChildBytes) {
      const ssize_t got = ::pread(descriptor_, block.data(), block.size(), static_cast<off_t>(text.size()));
      if (got < 0 && errno == EINTR) continue;
      if (got <= 0) return text;
      text.append(block.data(), static_cast<std::size_t>(got));
    }
    return text;
  }

 private:
  int descriptor_;
};

// The texts of a list as execve and its kin want them; they must outlive it.
std::vector<char*> pointersTo(std::vector<std::string>& texts) {
  std::vector<char*> pointers;
  for (std::string& text : texts) pointers.push_back(text.data());
  pointers.push_back(nullptr);
  return pointers;
}

std::vector<std::string> environmentInC() {
  std::vector<std::string> variables{"LC_ALL=C"};
  for (char** variable = ::environ; variable && *variable; ++variable)
    if (!std::string_view(*variable).starts_with("LC_ALL=")) variables.emplace_back(*variable);
  return variables;
}

// 0, or the number of the error. The child leads a process group of its own, by which it can be ended with
// all that it starts.
int spawn(std::vector<std::string> command, const std::array<int, 3>& streams, pid_t& child) {
  std::vector<std::string> environment = environmentInC();
  posix_spawn_file_actions_t actions;
  posix_spawnattr_t attributes;
  ::posix_spawn_file_actions_init(&actions);
  ::posix_spawnattr_init(&attributes);
  for (int stream = 0; stream < 3; ++stream)
    ::posix_spawn_file_actions_adddup2(&actions, streams[static_cast<std::size_t>(stream)], stream);
  ::posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP);
  ::posix_spawnattr_setpgroup(&attributes, 0);
  const int error = ::posix_spawnp(&child, command[0].c_str(), &actions, &attributes,
                                   pointersTo(command).data(), pointersTo(environment).data());
  ::posix_spawnattr_destroy(&attributes);
  ::posix_spawn_file_actions_destroy(&actions);
  return error;
}

void end(pid_t child) {
  ::kill(-child, SIGKILL);
  while (::waitpid(child, nullptr, 0) < 0 && errno == EINTR) {
  }
}

// How the child ended: "" when well.
std::string waitFor(pid_t child, std::chrono::milliseconds limit, const MemoryFile& out,
                    const MemoryFile& errors) {
  constexpr std::chrono::milliseconds kPause{2};
  const auto deadline = std::chrono::steady_clock::now() + limit;
  int status = 0;
  for (;;) {
    const pid_t ended = ::waitpid(child, &status, WNOHANG);
    if (ended == child) break;
    if (ended < 0 && errno != EINTR) return std::string("was lost: ") + std::strerror(errno);
    if (std::chrono::steady_clock::now() >= deadline) {
      end(child);
      return fmt::format("took longer than {:g} seconds", std::chrono::duration<double>(limit).count());
    }
    if (out.bytes() + errors.bytes() > kMostChildBytes) {
      end(child);
      return fmt::format("wrote more than {} MB", kMostChildBytes >> 20);
    }
    std::this_thread::sleep_for(kPause);
  }
  if (WIFSIGNALED(status)) return fmt::format("was ended by signal {}", WTERMSIG(status));
  if (WEXITSTATUS(status) != 0) return fmt::format("failed with exit code {}", WEXITSTATUS(status));
  return "";
}

}  // namespace

ChildResult runChild(const std::vector<std::string>& command, const std::string& input,
                     std::chrono::milliseconds limit) {
  ChildResult result;
  MemoryFile in, out, errors;
  if (!in.good() || !out.good() || !errors.good() || !in.fill(input)) {
    result.failure = std::string("cannot be given its input: ") + std::strerror(errno);
    return result;
  }
  pid_t child = 0;
  const int error = spawn(command, {in.descriptor(), out.descriptor(), errors.descriptor()}, child);
  if (error) {
    result.found = error != ENOENT;
    result.failure = std::string("cannot be started: ") + std::strerror(error);
    return result;
  }
  result.failure = waitFor(child, limit, out, errors);
  result.output = out.content();
  result.errors = errors.content();
  return result;
}

}  // namespace shprt
