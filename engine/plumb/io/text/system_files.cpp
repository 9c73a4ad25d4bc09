#include "plumb/io/text/system_files.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include "plumb/io/text/file_names.h"
#ifdef _WIN32
#include <io.h>
#include <windows.h>
#else
#include <poll.h>
#endif

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <system_error>

namespace plumb::system_files {

#ifdef _WIN32

int open_input(const std::string& path) {
  return ::open(path.c_str(), O_RDONLY | O_BINARY | O_NOINHERIT);
}

bool wait_for_input(int /*descriptor*/, int /*milliseconds*/) { return true; }

int open_device(const std::string& path) {
  return ::open(path.c_str(), O_WRONLY | O_BINARY | O_NOINHERIT);
}

int create_temporary(std::string& name) { return ::mkstemp(name.data()); }

void give_permissions(int /*descriptor*/, const std::string& /*model*/) {}

bool synchronize(int descriptor) { return ::_commit(descriptor) == 0; }

bool replace_file(const std::string& from, const std::string& to) {
  constexpr DWORD kHow = MOVEFILE_REPLACE_EXISTING | MOVEFILE_WRITE_THROUGH;
  if (::MoveFileExA(from.c_str(), to.c_str(), kHow) != 0) return true;
  const DWORD error = ::GetLastError();
  errno = error == ERROR_FILE_NOT_FOUND || error == ERROR_PATH_NOT_FOUND ? ENOENT : EACCES;
  return false;
}

std::string resolve_links(const std::string& path) {
  std::error_code error;
  if (!std::filesystem::is_symlink(path_of(path), error)) return path;
  const std::filesystem::path real = std::filesystem::canonical(path_of(path), error);
  return error ? path : file_name_of(real);
}

#else

int open_input(const std::string& path) {
  return ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
}

bool wait_for_input(int descriptor, int milliseconds) {
  pollfd request{descriptor, POLLIN, 0};
  return ::poll(&request, 1, milliseconds) > 0;
}

int open_device(const std::string& path) {
  const int descriptor = ::open(path.c_str(), O_WRONLY | O_CLOEXEC | O_NONBLOCK);
  if (descriptor < 0 || ::fcntl(descriptor, F_SETFL, O_WRONLY) == 0) return descriptor;
  const int error = errno;
  ::close(descriptor);
  errno = error;
  return -1;
}

int create_temporary(std::string& name) { return ::mkostemp(name.data(), O_CLOEXEC); }

namespace {

/// Returns the permissions of a new file of this process.
mode_t new_file_mode() {
  const mode_t mask = ::umask(0);
  ::umask(mask);
  return 0666 & ~mask;
}

}  // namespace

void give_permissions(int descriptor, const std::string& model) {
  struct stat status {};
  const bool exists = ::stat(model.c_str(), &status) == 0;
  ::fchmod(descriptor, exists ? status.st_mode & 07777U : new_file_mode());
}

bool synchronize(int descriptor) { return ::fsync(descriptor) == 0; }

bool replace_file(const std::string& from, const std::string& to) {
  return std::rename(from.c_str(), to.c_str()) == 0;
}

std::string resolve_links(const std::string& path) {
  namespace fs = std::filesystem;
  const std::unique_ptr<char, decltype(&std::free)> real(::realpath(path.c_str(), nullptr),
                                                         &std::free);
  if (real) return real.get();
  // A link may lead to a file that does not exist yet. The system follows at most 40 links.
  constexpr int kMostLinks = 40;
  fs::path target = path;
  std::error_code error;
  for (int i = 0; i < kMostLinks && fs::is_symlink(target, error); ++i) {
    const fs::path next = fs::read_symlink(target, error);
    if (error) return path;
    target = target.parent_path() / next;  // An absolute path replaces the folder.
  }
  return target.string();
}

#endif

}  // namespace plumb::system_files
