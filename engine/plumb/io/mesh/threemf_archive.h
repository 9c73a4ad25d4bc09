// ZIP archives in memory, if plumb is built with libzip and expat.
//
// Without the libraries, every function throws Error{UnknownFormat} that names their packages. An
// archive is hostile input: nothing is written to a disk, names are only looked up inside the
// archive, and an entry is decompressed block by block. All errors are thrown without a place.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <iosfwd>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "plumb/base/context.h"

namespace plumb {

/// Whether plumb is built with libzip and expat.
bool has_threemf();

/// An archive that is read.
class ZipArchive {
 public:
  /// Keeps `bytes` and `context`, which must outlive it. Charges the directory. Throws
  /// Error{UnknownFormat} if the bytes are no ZIP archive, and the errors of the Context.
  ZipArchive(std::string_view bytes, Context& context);
  ~ZipArchive();
  ZipArchive(const ZipArchive&) = delete;
  ZipArchive& operator=(const ZipArchive&) = delete;

  /// Returns the names of all entries, as the archive states them.
  [[nodiscard]] std::vector<std::string> names() const;
  /// Returns the entry with this name, else one whose name differs in capital letters only.
  [[nodiscard]] std::optional<std::uint64_t> find(const std::string& name) const;
  /// Decompresses an entry and calls `take` for each block. Throws Error{Syntax} if the data are
  /// damaged, Error{UnknownFormat} if they are encrypted or compressed in an unknown way,
  /// Error{ResourceLimit} if the entries read so far are more than 64 MiB and 256 times as large as
  /// the archive; the errors of the Context and the exceptions of `take`.
  void read(std::uint64_t entry, const std::function<void(std::string_view)>& take);

 private:
  struct Handle;
  std::unique_ptr<Handle> handle_;
};

/// An entry that is written.
struct ZipEntry {
  std::string name;       ///< The path in the archive.
  std::string_view data;  ///< The contents.
};

/// Writes an archive. Equal entries give equal bytes: the archive states no time of writing. Throws
/// Error{CannotWrite} if the library fails. Exceptions of `out` reach the caller.
void write_zip(std::ostream& out, std::span<const ZipEntry> entries);

}  // namespace plumb
