// Runs openscad with its output in a pipe. The name of the model is not passed to a shell.
//
// openscad is the leader of a group of processes. The whole group is ended when the command
// continues, fails, or is ended at a checkpoint, by an alarm or by a second signal. The id of the
// group is valid until the process has waited for its leader, so waiting is the last step.
// Checkpoints are reached while the process waits for the pipe and for the end of openscad. Tested
// by tests/cli/csg_command_test.cpp.
#include "plumb/cli/files/openscad.h"

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <utility>

#include "plumb/cli/session/process.h"
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

/// The settings for posix_spawn(): standard input is empty, standard output is a pipe, the process
/// leads a group, and signals have their default actions.
class SpawnSettings {
 public:
  SpawnSettings(int output, const sigset_t& blocked) {
    posix_spawn_file_actions_init(&actions_);
    posix_spawn_file_actions_addopen(&actions_, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_adddup2(&actions_, output, STDOUT_FILENO);
    posix_spawnattr_init(&attributes_);
    posix_spawnattr_setpgroup(&attributes_, 0);
    posix_spawnattr_setsigmask(&attributes_, &blocked);
    // Signals that this process ignores are set to their default actions. All other signals get
    // their default actions in any case.
    sigset_t ignored;
    sigemptyset(&ignored);
    sigaddset(&ignored, SIGPIPE);
    sigaddset(&ignored, SIGXFSZ);
    posix_spawnattr_setsigdefault(&attributes_, &ignored);
    posix_spawnattr_setflags(
        &attributes_, POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF);
  }
  ~SpawnSettings() {
    posix_spawn_file_actions_destroy(&actions_);
    posix_spawnattr_destroy(&attributes_);
  }
  SpawnSettings(const SpawnSettings&) = delete;
  SpawnSettings& operator=(const SpawnSettings&) = delete;

  const posix_spawn_file_actions_t* actions() const { return &actions_; }
  const posix_spawnattr_t* attributes() const { return &attributes_; }

 private:
  posix_spawn_file_actions_t actions_;
  posix_spawnattr_t attributes_;
};

/// A process whose standard output is read. At the end of the scope, this process and all processes
/// that it started are ended.
class Child {
 public:
  explicit Child(const std::array<const char*, 6>& command) {
    std::array<int, 2> ends{};
    if (pipe(ends.data()) != 0) return;
    output_ = ends[0];
    for (const int end : ends) fcntl(end, F_SETFD, FD_CLOEXEC);
    std::array<char*, 6> words{};
    for (std::size_t i = 0; i < words.size(); ++i) words[i] = const_cast<char*>(command[i]);
    {
      // Signals are blocked, so a signal that ends the program also ends the group.
      const process::BlockedSignals blocked;
      const SpawnSettings settings(ends[1], blocked.before());
      const int failed = posix_spawnp(&id_, words[0], settings.actions(), settings.attributes(),
                                      words.data(), environ);
      if (failed != 0) id_ = -1;
      if (failed == 0) group_.emplace(id_);
    }
    close(ends[1]);
  }
  ~Child() {
    if (output_ >= 0) close(output_);
    group_.reset();
    if (id_ > 0) wait_for_end();
  }
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;

  bool is_started() const { return id_ > 0; }
  int output() const { return output_; }

  /// Waits for the end, and returns the exit status; -1 if there is none.
  int wait(Context& context) {
    for (int milliseconds = 1; !has_ended();) {
      context.checkpoint("openscad", 0, 0);
      poll(nullptr, 0, milliseconds);
      milliseconds = std::min(2 * milliseconds, kMillisecondsBetweenCheckpoints);
    }
    group_.reset();
    const int status = wait_for_end();
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }

 private:
  /// Whether the process has ended. Its id remains valid.
  bool has_ended() const {
    siginfo_t state{};
    const int result = waitid(P_PID, static_cast<id_t>(id_), &state, WEXITED | WNOHANG | WNOWAIT);
    return result == 0 ? state.si_pid == id_ : errno != EINTR;
  }
  /// Waits for the process, which has ended or has been killed, and returns its exit status.
  int wait_for_end() {
    int status = -1;
    while (waitpid(id_, &status, 0) < 0 && errno == EINTR) {
    }
    id_ = -1;
    return status;
  }

  pid_t id_ = -1;
  int output_ = -1;
  std::optional<process::EndsWithProcess> group_;
};

/// Reads all output. The memory of the text stays charged to the context.
std::string read_all(int file, Context& context) {
  std::string text;
  std::array<char, 65536> block{};
  for (;;) {
    context.checkpoint("openscad", text.size(), 0);
    pollfd waiting{file, POLLIN, 0};
    if (poll(&waiting, 1, kMillisecondsBetweenCheckpoints) <= 0) continue;
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
  // A name that begins with a dash would be taken for an option.
  const std::string model = path.starts_with('-') ? "./" + path : path;
  Child openscad({"openscad", "-o", "-", "--export-format=csg", model.c_str(), nullptr});
  if (!openscad.is_started()) fail_without_openscad(path);
  std::string text = read_all(openscad.output(), context);
  const int status = openscad.wait(context);
  // On some systems, only the child process detects that there is no openscad.
  if (status == 127) fail_without_openscad(path);
  if (status != 0) {
    throw Error(ErrorCode::Syntax, "openscad cannot read this model; its own messages say why",
                {.file = input_name(path)});
  }
  return text;
#endif
}

}  // namespace plumb::cli
