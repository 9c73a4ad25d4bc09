// Whole input files in memory, and output files that are complete or absent.
#pragma once

#include <filesystem>
#include <memory>
#include <ostream>
#include <span>
#include <streambuf>
#include <string>
#include <vector>

#include "plumb/base/context.h"
#include "plumb/io/read_options.h"

namespace plumb {

/// Returns the bytes of the file `path`, or of standard input if `path` is "-". The memory is
/// charged to `context` before it is allocated and stays charged; release it with the string.
/// Throws Error{CannotOpen} with the system's reason ("FILE: reason"), and Error{ResourceLimit}.
std::string read_input(const std::string& path, Context& context);

/// Whether a file that another file names lies in a folder or below it, after symbolic links have
/// been resolved. `folder` may be empty, which is the current folder. A file that does not exist
/// lies where its name leads.
bool lies_below(const std::string& folder, const std::string& file);
/// Returns the path of a file that the file `input` names, relative to the folder of `input`.
/// Throws Error{CannotOpen}, whose text names `input` and quotes nothing but the name, if the file
/// lies outside of this folder and `named_files` does not allow that, or if it is not an ordinary
/// file.
std::string named_file(const std::string& input, const std::string& name, NamedFiles named_files);

/// Returns the name of `path` in messages: `path` itself, or "stdin" for "-".
std::string input_name(const std::string& path);

// Output that is complete or absent.
//  1. open    OutputFile file("out.svg") opens a temporary file beside it: bad paths fail before
//             work
//  2. write   file.stream() << ... is buffered; a failed write throws at once
//  3. finish  file.finish() puts all bytes on the disk, still under the temporary name
//  4. commit  file.commit() renames the file to its final name
// Without commit() the destructor removes the temporary file. Several files that belong together
// are all finished before the first is committed (commit_all()). What is no ordinary file
// (/dev/null, a pipe) is written directly; a symbolic link is followed.

/// Buffer of a std::ostream over a file descriptor. Failed writes throw Error{CannotWrite} "NAME:
/// reason", or Error{ClosedPipe} if the reader is gone (which requires that SIGPIPE is ignored).
class DescriptorBuffer : public std::streambuf {
 public:
  /// Does not own `descriptor`.
  DescriptorBuffer(int descriptor, std::string name);

 protected:
  int_type overflow(int_type c) override;
  std::streamsize xsputn(const char* text, std::streamsize size) override;
  int sync() override;

 private:
  static constexpr std::size_t kBlock = std::size_t{1} << 16;
  void write_all(const char* text, std::size_t size);
  void write_block();

  int descriptor_;
  std::string name_;
  std::unique_ptr<char[]> block_;
};

/// A stream over a descriptor, which passes on the errors of its buffer.
class DescriptorStream : public std::ostream {
 public:
  DescriptorStream(int descriptor, std::string name);

 private:
  DescriptorBuffer buffer_;
};

/// A file that is written under a temporary name.
class OutputFile {
 public:
  /// Throws Error{CannotWrite} "PATH: reason".
  explicit OutputFile(const std::string& path);
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  const std::string& path() const { return path_; }
  std::ostream& stream() { return *stream_; }

  /// Writes the buffered bytes, and waits until they are on the disk. Requires no earlier finish().
  void finish();
  /// Renames the file to its final name. Requires finish().
  void commit();
  /// Removes a committed file again, unless it was written directly.
  void withdraw() noexcept;

 private:
  void open_directly();
  void open_temporary();
  [[noreturn]] void fail() const;
  void close();

  std::string path_;       // As given, for messages.
  std::string target_;     // With links resolved.
  std::string temporary_;  // Empty for a file that is written directly, and after commit().
  bool is_direct_ = false;
  int descriptor_ = -1;
  std::unique_ptr<DescriptorStream> stream_;
};

/// Commits finished files in order. If one fails, those committed before it are removed, so that no
/// output is left behind.
void commit_all(std::span<const std::unique_ptr<OutputFile>> files);

/// Removes the temporary files of all OutputFile objects that exist, and the empty folders of all
/// OutputDirectory objects that were not kept. For signal handlers that end the process:
/// async-signal-safe.
void remove_temporary_files() noexcept;

/// A folder for output, created with those above it that are missing. Folders that were created and
/// are still empty at the end are removed again, unless they were kept.
class OutputDirectory {
 public:
  /// Throws Error{CannotWrite} "PATH: reason".
  explicit OutputDirectory(const std::filesystem::path& path);
  ~OutputDirectory();
  OutputDirectory(const OutputDirectory&) = delete;
  OutputDirectory& operator=(const OutputDirectory&) = delete;

  void keep();

 private:
  void remove_made();

  std::vector<std::string> made_;  // Folders that were created, the last first.
};

}  // namespace plumb
