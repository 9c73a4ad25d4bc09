// Every error of a reader has a place: for limits that are met where nobody knows one.
#pragma once

#include <string>

#include "plumb/base/error.h"

namespace plumb {

/// For errors that no place in a file can be told of.
struct WholeFile {
  const std::string& name;
  [[noreturn]] void fail(ErrorCode code, const std::string& message) const {
    throw Error(code, message, {name});
  }
};

/// `read()`, where a limit that is met without a place is told at that of `in`: a TextCursor, a
/// BinaryInput or a WholeFile.
template <class Input, class Read>
auto with_place(const Input& in, Read read) {
  try {
    return read();
  } catch (const Error& error) {
    if (error.code() != ErrorCode::ResourceLimit || !error.place().file.empty()) throw;
    in.fail(error.code(), error.message());
  }
}

}  // namespace plumb
