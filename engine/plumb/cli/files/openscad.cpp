// Runs openscad with its output in a pipe. No shell reads the name of the model.
// Tested by tests/cli/csg_command_test.cpp.
#include "plumb/cli/files/openscad.h"

#include <array>
#include <string>
#include <utility>

#include "plumb/io/text/files.h"
#include "plumb/predicates/error.h"

#ifndef _WIN32
#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>

extern char** environ;  // NOLINT(readability-redundant-declaration): POSIX does not declare it.
#endif

namespace plumb::cli {
namespace {

[[noreturn]] void fail_without_openscad(const std::string& path) {
  throw Error(ErrorCode::UnknownFormat,
              "a .scad model needs the program openscad, which is not installed here; elsewhere, "
              "openscad -o model.csg writes a flat model, which plumb reads by itself",
              {.file = input_name(path)});
}

#ifndef _WIN32

constexpr int kMillisecondsBetweenCheckpoints = 50;

/// A process whose standard output is read. It is ended and waited for at the end of its scope.
class Child {
 public:
  explicit Child(const std::array<const char*, 6>& command) {
    std::array<int, 2> ends{};
    if (pipe(ends.data()) != 0) return;
    output_ = ends[0];
    fcntl(ends[0], F_SETFD, FD_CLOEXEC);
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, ends[1], STDOUT_FILENO);
    posix_spawn_file_actions_addclose(&actions, ends[1]);
    std::array<char*, 6> words{};
    for (std::size_t i = 0; i < words.size(); ++i) words[i] = const_cast<char*>(command[i]);
    const int failed = posix_spawnp(&id_, words[0], &actions, nullptr, words.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    close(ends[1]);
    if (failed != 0) id_ = -1;
  }
  ~Child() {
    if (output_ >= 0) close(output_);
    if (id_ > 0) kill(id_, SIGKILL);
    wait();
  }
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;

  bool is_started() const { return id_ > 0; }
  int output() const { return output_; }
  /// Waits for the end, and returns the exit status; -1 if there is none.
  int wait() {
    int status = -1;
    if (id_ > 0) {
      while (waitpid(id_, &status, 0) < 0 && errno == EINTR) {
      }
      id_ = -1;
    }
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }

 private:
  pid_t id_ = -1;
  int output_ = -1;
};

/// Reads all output. The memory of the text stays charged to the context.
std::string read_all(int file, Context& context) {
  std::string text;
  std::array<char, 65536> block{};
  for (;;) {
    pollfd waiting{file, POLLIN, 0};
    if (poll(&waiting, 1, kMillisecondsBetweenCheckpoints) <= 0) {
      context.checkpoint("openscad", 0, 0);
      continue;
    }
    const ssize_t count = read(file, block.data(), block.size());
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return text;
    context.charge_memory(static_cast<std::uint64_t>(count), "a model");
    text.append(block.data(), static_cast<std::size_t>(count));
  }
}

#endif

}  // namespace

std::string flat_model_of(const std::string& path, Context& context) {
#ifdef _WIN32
  static_cast<void>(context);
  fail_without_openscad(path);
#else
  // A name that begins with a dash would be an option.
  const std::string model = path.starts_with('-') ? "./" + path : path;
  Child openscad({"openscad", "-o", "-", "--export-format=csg", model.c_str(), nullptr});
  if (!openscad.is_started()) fail_without_openscad(path);
  std::string text = read_all(openscad.output(), context);
  const int status = openscad.wait();
  if (status == 127) fail_without_openscad(path);  // Where only the child finds out.
  if (status != 0) {
    throw Error(ErrorCode::Syntax, "openscad cannot read this model; its own messages say why",
                {.file = input_name(path)});
  }
  return text;
#endif
}

}  // namespace plumb::cli
