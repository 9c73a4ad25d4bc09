// Runs the program as a user does: its own process, its standard streams in files.
#pragma once

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <string>
#include <vector>

namespace plumb::testing {

namespace fs = std::filesystem;

inline std::string read_file(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

inline void write_file(const fs::path& path, const std::string& bytes) {
  std::ofstream(path, std::ios::binary) << bytes;
}

/// A directory of its own, gone with the object.
class ScratchDirectory {
 public:
  ScratchDirectory() {
    std::string pattern = (fs::temp_directory_path() / "plumb-test-XXXXXX").string();
    path_ = ::mkdtemp(pattern.data());
  }
  ~ScratchDirectory() { fs::remove_all(path_); }
  ScratchDirectory(const ScratchDirectory&) = delete;
  ScratchDirectory& operator=(const ScratchDirectory&) = delete;

  fs::path operator/(const std::string& name) const { return path_ / name; }
  std::vector<std::string> files() const {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(path_))
      names.push_back(entry.path().filename());
    std::sort(names.begin(), names.end());
    return names;
  }

 private:
  fs::path path_;
};

struct RunResult {
  int code = -1;  ///< exit status, or -signal
  std::string out;
  std::string err;
  double user_seconds = 0;
  double megabytes = 0;  ///< peak resident memory
};

struct RunOptions {
  std::string in = "/dev/null";
  std::string out;  ///< a path; empty: into RunResult::out
  std::function<void(pid_t)> meanwhile = [](pid_t) {};
};

inline void redirect(int stream, const std::string& path, int flags) {
  const int fd = ::open(path.c_str(), flags, 0600);
  if (fd < 0 || ::dup2(fd, stream) < 0) ::_exit(99);
  ::close(fd);
}

[[noreturn]] inline void become_program(const std::vector<std::string>& arguments,
                                        const std::string& in, const std::string& out,
                                        const std::string& err) {
  redirect(STDIN_FILENO, in, O_RDWR);
  redirect(STDOUT_FILENO, out, O_WRONLY | O_CREAT);
  redirect(STDERR_FILENO, err, O_WRONLY | O_CREAT);
  std::vector<char*> argv{const_cast<char*>(PLUMB_PROGRAM)};
  for (const std::string& argument : arguments) argv.push_back(const_cast<char*>(argument.c_str()));
  argv.push_back(nullptr);
  ::execv(PLUMB_PROGRAM, argv.data());
  ::_exit(99);
}

inline RunResult run(const std::vector<std::string>& arguments, const RunOptions& options = {}) {
  const ScratchDirectory scratch;
  const std::string out = options.out.empty() ? (scratch / "out").string() : options.out;
  const std::string err = (scratch / "err").string();
  const pid_t child = ::fork();
  if (child == 0) become_program(arguments, options.in, out, err);
  options.meanwhile(child);
  int status = 0;
  rusage usage{};
  ::wait4(child, &status, 0, &usage);
  RunResult result;
  result.code = WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
  if (options.out.empty()) result.out = read_file(out);
  result.err = read_file(err);
  result.user_seconds = static_cast<double>(usage.ru_utime.tv_sec) +
                        static_cast<double>(usage.ru_utime.tv_usec) * 1e-6;
  result.megabytes = static_cast<double>(usage.ru_maxrss) / 1024;
  return result;
}

}  // namespace plumb::testing
