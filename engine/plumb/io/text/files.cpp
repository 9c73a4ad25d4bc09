// Input files read whole, and output files written atomically.
//
// Input is read until its end, even if the system reports another size. Memory is charged before it
// grows. Waiting for a pipe is divided into short waits, so that limits and cancellation take
// effect in between. Output goes to a temporary file in the same folder, is synchronised, and
// renamed over its final name, which POSIX makes atomic: readers see the old file or the new one.
// Names of temporary files are also kept in a fixed array of atomics, where a signal handler can
// unlink them without taking locks or allocating. Tested by tests/io/files_test.cpp.
#include "plumb/io/text/files.h"

#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <climits>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <optional>
#include <utility>

#include "plumb/io/text/file_names.h"
#include "plumb/io/text/input_cursors.h"
#include "plumb/io/text/system_files.h"
#include "plumb/predicates/error.h"

namespace plumb {
namespace {

constexpr std::size_t kChunk = std::size_t{1} << 20;

#ifdef _WIN32
using IoSize = unsigned int;
#else
using IoSize = std::size_t;
#endif
// Larger blocks are read and written in parts.
constexpr std::size_t kMostAtOnce = std::size_t{1} << 30;

[[noreturn]] void fail(const std::string& path) {
  throw Error(ErrorCode::CannotOpen, std::strerror(errno), {input_name(path)});
}

/// Repeats `attempt` until it is not interrupted by a signal. The context is checked after each
/// signal, because signals cancel runs.
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
    // The call does not wait for a program that writes to a named pipe, because wait() does.
    fd_ = uninterrupted(context_, [&] { return system_files::open_input(path); });
    if (fd_ < 0) fail(path_);
    is_regular_ = regular_size().has_value();
  }
  ~InputFile() {
    if (fd_ != STDIN_FILENO) ::close(fd_);
  }
  InputFile(const InputFile&) = delete;
  InputFile& operator=(const InputFile&) = delete;

  /// Returns the size if the system knows it. The size is only a hint.
  std::size_t expected_size() const { return regular_size().value_or(0); }

  /// Waits until bytes can be read. The wait is divided into slices, so that limits and
  /// cancellation take effect in between. (A signal that arrives just before a read would not
  /// interrupt it.) A regular file can always be read. It is not asked, because Emscripten's poll()
  /// fails for files of Node.
  void wait() const {
    constexpr int kSliceMilliseconds = 50;
    do {
      context_.checkpoint("load", 0, 1);
    } while (!is_regular_ && !system_files::wait_for_input(fd_, kSliceMilliseconds));
  }

  /// Reads some bytes. Returns 0 at the end.
  std::size_t read(char* to, std::size_t most) const {
    for (;;) {
      wait();
      const auto part = static_cast<IoSize>(std::min(most, kMostAtOnce));
      const auto got = uninterrupted(context_, [&] { return ::read(fd_, to, part); });
      if (got >= 0) return static_cast<std::size_t>(got);
      if (errno != EAGAIN) fail(path_);
    }
  }

 private:
  /// Returns the size of a regular file, or nothing for a pipe or a device.
  std::optional<std::size_t> regular_size() const {
    struct stat status {};
    if (::fstat(fd_, &status) != 0 || !S_ISREG(status.st_mode)) return std::nullopt;
    return static_cast<std::size_t>(status.st_size);
  }

  int fd_;
  bool is_regular_ = false;  // Standard input always needs the wait.
  const std::string& path_;
  Context& context_;
};

/// Grows `bytes` to `size`. The memory is charged first.
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
  // One byte more than expected is read, so that an ordinary file ends without growing again.
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

bool lies_below(const std::string& folder, const std::string& file) {
  namespace fs = std::filesystem;
  std::error_code error;
  const fs::path base = fs::canonical(path_of(folder.empty() ? "." : folder), error);
  if (error) return false;
  // A relative path whose first part does not exist would remain relative.
  const fs::path place = fs::weakly_canonical(fs::absolute(path_of(file), error), error);
  return !error &&
         std::mismatch(base.begin(), base.end(), place.begin(), place.end()).first == base.end();
}

std::string named_file(const std::string& input, const std::string& name, NamedFiles named_files) {
  namespace fs = std::filesystem;
  const fs::path folder = input == "-" ? fs::path() : path_of(input).parent_path();
  const std::string file = file_name_of(folder / path_of(name));
  const auto refuse = [&](const char* why) {
    throw Error(ErrorCode::CannotOpen, plumb::quoted(name) + why, {input_name(input)});
  };
  if (named_files == NamedFiles::Below && !lies_below(file_name_of(folder), file)) {
    refuse(" does not lie in the folder of the file that names it, nor below");
  }
  std::error_code error;
  const fs::file_status status = fs::status(path_of(file), error);
  if (!error && fs::exists(status) && !fs::is_regular_file(status)) refuse(" is no ordinary file");
  return file == "-" ? "./-" : file;
}

namespace {

[[noreturn]] void fail_write(const std::string& name) {
  const ErrorCode code = errno == EPIPE ? ErrorCode::ClosedPipe : ErrorCode::CannotWrite;
  throw Error(code, std::strerror(errno), {name});
}

/// The names of temporary files, in memory that a signal handler may access. If the list is full,
/// the handler does not know a name, which has no other effect.
class TemporaryNames {
 public:
  void add(const char* name) {
    for (std::atomic<const char*>& slot : names_) {
      const char* none = nullptr;
      if (slot.compare_exchange_strong(none, name)) return;
    }
  }
  void remove(const char* name) {
    for (std::atomic<const char*>& slot : names_) {
      const char* expected = name;
      if (slot.compare_exchange_strong(expected, nullptr)) return;
    }
  }
  void remove_all(int (*remove)(const char*)) const noexcept {
    for (const std::atomic<const char*>& slot : names_) {
      if (const char* name = slot.load()) remove(name);
    }
  }

 private:
  std::array<std::atomic<const char*>, 16> names_{};
};

TemporaryNames temporary_names;
TemporaryNames made_directories;  // The innermost folder is first.

}  // namespace

DescriptorBuffer::DescriptorBuffer(int descriptor, std::string name)
    : descriptor_(descriptor),
      name_(std::move(name)),
      block_(std::make_unique_for_overwrite<char[]>(kBlock)) {
  setp(block_.get(), block_.get() + kBlock);
}

void DescriptorBuffer::write_all(const char* text, std::size_t size) {
  while (size > 0) {
    const auto part = static_cast<IoSize>(std::min(size, kMostAtOnce));
    const auto wrote = ::write(descriptor_, text, part);
    if (wrote < 0 && errno == EINTR) continue;
    if (wrote < 0) fail_write(name_);
    text += wrote;
    size -= static_cast<std::size_t>(wrote);
  }
}

void DescriptorBuffer::write_block() {
  const auto size = static_cast<std::size_t>(pptr() - pbase());
  // The buffer is reset before writing, so that no byte is written twice if writing fails.
  setp(block_.get(), block_.get() + kBlock);
  write_all(block_.get(), size);
}

DescriptorBuffer::int_type DescriptorBuffer::overflow(int_type c) {
  write_block();
  if (!traits_type::eq_int_type(c, traits_type::eof())) {
    *pptr() = traits_type::to_char_type(c);
    pbump(1);
  }
  return traits_type::not_eof(c);
}

std::streamsize DescriptorBuffer::xsputn(const char* text, std::streamsize size) {
  if (size > epptr() - pptr()) write_block();
  if (size >= static_cast<std::streamsize>(kBlock)) {
    write_all(text, static_cast<std::size_t>(size));
  } else {
    std::memcpy(pptr(), text, static_cast<std::size_t>(size));
    pbump(static_cast<int>(size));
  }
  return size;
}

int DescriptorBuffer::sync() {
  write_block();
  return 0;
}

DescriptorStream::DescriptorStream(int descriptor, std::string name)
    : std::ostream(nullptr), buffer_(descriptor, std::move(name)) {
  rdbuf(&buffer_);
  exceptions(std::ios::badbit);  // Throws the exception of the buffer again.
}

OutputFile::OutputFile(const std::string& path)
    : path_(path), target_(system_files::resolve_links(path)) {
  struct stat status {};
  const bool exists = ::stat(target_.c_str(), &status) == 0;
  if (!exists && errno != ENOENT) fail();  // The name is too long, or links form a circle.
  if (exists && S_ISDIR(status.st_mode)) {
    errno = EISDIR;
    fail();
  }
  is_direct_ = exists && !S_ISREG(status.st_mode);
  if (is_direct_) {
    open_directly();
  } else {
    if (exists && ::access(target_.c_str(), W_OK) != 0) fail();
    open_temporary();
  }
  stream_ = std::make_unique<DescriptorStream>(descriptor_, path_);
}

OutputFile::~OutputFile() {
  close();
  if (temporary_.empty()) return;
  ::unlink(temporary_.c_str());
  temporary_names.remove(temporary_.c_str());
}

/// Opens a device or a pipe. If no program reads a named pipe, the pipe is refused; the function
/// does not wait.
void OutputFile::open_directly() {
  descriptor_ = system_files::open_device(target_);
  if (descriptor_ < 0 && errno == ENXIO) {
    throw Error(ErrorCode::CannotWrite, "no program reads this pipe", {path_});
  }
  if (descriptor_ < 0) fail();
}

void OutputFile::open_temporary() {
  const std::filesystem::path target = path_of(target_);
  // The longest name that file systems accept has 255 bytes, and a temporary name has 8 more.
  constexpr std::size_t kMost = 255, kMore = 8;
  std::string name = ".";
  name += file_name_of(target.filename()).substr(0, kMost - kMore);
  name += ".XXXXXX";
  temporary_ = file_name_of(target.parent_path() / "") + name;
  descriptor_ = system_files::create_temporary(temporary_);
  if (descriptor_ < 0) {
    temporary_.clear();
    fail();
  }
  temporary_names.add(temporary_.c_str());
  system_files::give_permissions(descriptor_, target_);
}

void OutputFile::fail() const {
  throw Error(ErrorCode::CannotWrite, std::strerror(errno), {path_});
}

void OutputFile::close() {
  if (descriptor_ >= 0) ::close(descriptor_);
  descriptor_ = -1;
}

void OutputFile::finish() {
  stream_->flush();
  // Pipes and devices cannot be synchronised, which is not an error.
  if (!is_direct_ && !system_files::synchronize(descriptor_)) fail();
  const int descriptor = std::exchange(descriptor_, -1);
  if (::close(descriptor) != 0) fail();
}

void OutputFile::commit() {
  if (is_direct_) return;
  if (!system_files::replace_file(temporary_, target_)) fail();
  temporary_names.remove(temporary_.c_str());
  temporary_.clear();
}

void OutputFile::withdraw() noexcept {
  if (!is_direct_) ::unlink(target_.c_str());
}

void commit_all(std::span<const std::unique_ptr<OutputFile>> files) {
  for (std::size_t i = 0; i < files.size(); ++i) {
    try {
      files[i]->commit();
    } catch (...) {
      for (std::size_t k = 0; k < i; ++k) files[k]->withdraw();
      throw;
    }
  }
}

void remove_temporary_files() noexcept {
  temporary_names.remove_all(::unlink);
  made_directories.remove_all(::rmdir);  // The call fails for folders that are not empty.
}

OutputDirectory::OutputDirectory(const std::filesystem::path& path) {
  std::error_code failed;
  std::filesystem::path at;
  for (const std::filesystem::path& step : path) {
    at /= step;
    if (step.empty() || std::filesystem::is_directory(at, failed)) continue;
    if (!std::filesystem::create_directory(at, failed)) {
      if (!failed) failed = std::make_error_code(std::errc::not_a_directory);
      remove_made();
      throw Error(ErrorCode::CannotWrite, file_name_of(path) + ": " + failed.message());
    }
    made_.insert(made_.begin(), file_name_of(at));
  }
  for (const std::string& made : made_) made_directories.add(made.c_str());
}

OutputDirectory::~OutputDirectory() {
  remove_made();
  keep();
}

void OutputDirectory::keep() {
  for (const std::string& made : made_) made_directories.remove(made.c_str());
  made_.clear();
}

void OutputDirectory::remove_made() {
  for (const std::string& made : made_) {
    std::error_code not_empty;
    if (!std::filesystem::remove(path_of(made), not_empty)) return;
  }
}

}  // namespace plumb
