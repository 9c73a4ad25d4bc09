// Recognizes files of another kind than the reader expects, and states what the file is and what
// the user can do.
//
// A reader that gets a file of another kind fails at the first word. Its message says what it
// expected there, but not that the file is packed, is in UTF-16, or is a STEP model.
// naming_foreign_files() looks at the first bytes of a file that a reader refused. It never decides
// how a file is read, so a file that a reader accepts may begin with anything.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "plumb/predicates/error.h"

namespace plumb {

/// The commands that would read the file that was refused.
enum class FileReaders : std::uint8_t { Solids, PlaneSets };

/// Returns what the file is and what to do, such as "this is a file packed by gzip; unpack it
/// first". `own` are the kinds that the reader reads, in words between blanks, such as " OFF ";
/// these are not named. Returns no value if the first bytes belong to no other known kind. Cost: at
/// most the first 4096 bytes are searched.
/// The advice is for the given readers. If no readers are given, it is for the readers of the kinds
/// that plumb reads.
std::optional<std::string> foreign_kind(std::string_view bytes, std::string_view own,
                                        std::optional<FileReaders> readers = std::nullopt);

/// Whether an error may be due to a file of another kind.
constexpr bool is_of_format(ErrorCode code) {
  return code == ErrorCode::NotText || code == ErrorCode::Syntax ||
         code == ErrorCode::CountMismatch || code == ErrorCode::UnknownFormat;
}

/// Returns `read()`. If it refuses the format of the file, and the file is of another kind, throws
/// Error{UnknownFormat} "FILE: this is ...; ..." in its place.
template <class Read>
auto naming_foreign_files(std::string_view bytes, std::string_view own, const std::string& name,
                          Read read) {
  try {
    return read();
  } catch (const Error& error) {
    if (!is_of_format(error.code()) || error.place().file != name) throw;
    if (const auto kind = foreign_kind(bytes, own)) {
      throw Error(ErrorCode::UnknownFormat, *kind, {name});
    }
    throw;
  }
}

}  // namespace plumb
