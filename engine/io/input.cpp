#include "plumb/io/input.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

#include "plumb/base/error.h"

namespace plumb {
namespace {

constexpr std::size_t kChunk = std::size_t{1} << 20;

[[noreturn]] void fail(const std::string& path) {
  throw Error(ErrorCode::CannotOpen, std::strerror(errno), {input_name(path)});
}

/// Calls `attempt` until it is not interrupted by a signal; signals are how runs are cancelled.
template <class Attempt>
auto uninterrupted(Context& context, Attempt attempt) {
  for (;;) {
    const auto result = attempt();
    if (result >= 0 || errno != EINTR) return result;
    context.checkpoint("load", 0, 0);
  }
}

class InputFile {
 public:
  InputFile(const std::string& path, Context& context)
      : fd_(STDIN_FILENO), path_(path), context_(context) {
    if (path == "-") return;
    fd_ = uninterrupted(context_, [&] { return ::open(path.c_str(), O_RDONLY | O_CLOEXEC); });
    if (fd_ < 0) fail(path_);
  }
  ~InputFile() {
    if (fd_ != STDIN_FILENO) ::close(fd_);
  }
  InputFile(const InputFile&) = delete;
  InputFile& operator=(const InputFile&) = delete;

  /// The size if the system knows it: a hint, never trusted.
  std::size_t expected_size() const {
    struct stat status {};
    if (::fstat(fd_, &status) != 0 || !S_ISREG(status.st_mode)) return 0;
    return static_cast<std::size_t>(status.st_size);
  }

  /// Waits until something can be read: in slices, so that limits and stops count meanwhile. (A
  /// signal that arrives just before a read would not interrupt it.)
  void wait() const {
    constexpr int kSliceMilliseconds = 50;
    pollfd request{fd_, POLLIN, 0};
    do {
      context_.checkpoint("load", 0, 1);
    } while (::poll(&request, 1, kSliceMilliseconds) <= 0);
  }

  /// 0 at the end.
  std::size_t read(char* to, std::size_t most) const {
    wait();
    const ssize_t got = uninterrupted(context_, [&] { return ::read(fd_, to, most); });
    if (got < 0) fail(path_);
    return static_cast<std::size_t>(got);
  }

 private:
  int fd_;
  const std::string& path_;
  Context& context_;
};

/// Grows `bytes` to `size`, charged first.
void grow(std::string& bytes, std::size_t size, const std::string& name, Context& context) {
  context.charge_memory(size - bytes.size(), name);
  bytes.resize(size);
}

}  // namespace

std::string input_name(const std::string& path) { return path == "-" ? "stdin" : path; }

std::string read_input(const std::string& path, Context& context) {
  const InputFile file(path, context);
  const std::string name = input_name(path);
  std::string bytes;
  std::size_t used = 0;
  // One byte more than expected, so that an ordinary file ends without growing again.
  grow(bytes, file.expected_size() + 1, name, context);
  while (const std::size_t got = file.read(bytes.data() + used, bytes.size() - used)) {
    used += got;
    if (used == bytes.size()) grow(bytes, used + std::max(kChunk, used / 2), name, context);
    context.checkpoint("load", used, std::max(used, file.expected_size()));
  }
  context.release_memory(bytes.size() - used);
  bytes.resize(used);
  return bytes;
}

}  // namespace plumb
