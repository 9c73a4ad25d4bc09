// The one exception type, and the check that stops the program on a broken invariant.
//
// Bad input, limits and cancellation throw Error. Negative answers ("open", "not convex",
// "not equal") are results, never errors. A broken invariant is a bug: PLUMB_CHECK prints what to
// report and aborts.
#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>
#include <string_view>

#pragma GCC visibility push(default)
namespace plumb {

/// Closed set of reasons, numbered in ranges: 1xx input text and files, 2xx resources and
/// cancellation, 3xx geometry handed in by a caller.
enum class ErrorCode {
  CannotOpen = 100,
  CannotWrite = 101,
  NotText = 102,
  Syntax = 103,
  NumberOutOfRange = 104,
  CountMismatch = 105,
  BadIndex = 106,
  DegenerateFace = 107,
  UnknownFormat = 108,
  Usage = 109,
  ClosedPipe = 110,  ///< the reader of our output went away: end quietly
  BadShape = 111,    ///< a ring that is not closed, records that contradict each other
  ResourceLimit = 200,
  Cancelled = 201,
  NotFinite = 300,
  BadArgument = 301,
};

/// Where in a text input; 1-based, 0 = unknown.
struct TextPlace {
  std::string file;        ///< its path, or what the input is called
  std::size_t line = 0;    ///< 1-based; 0 = unknown
  std::size_t column = 0;  ///< 1-based, in bytes; 0 = unknown
};

/// Bad input, an exhausted limit, or cancellation. what() is ready to print:
/// "FILE:LINE:COLUMN: message", "FILE: message" or "message".
class Error : public std::runtime_error {
 public:
  /// Puts what() together of the message and the place.
  Error(ErrorCode code, std::string message, TextPlace place = {});

  ErrorCode code() const { return code_; }                 ///< The reason; programs decide by it.
  const std::string& message() const { return message_; }  ///< For people; without the place.
  const TextPlace& place() const { return place_; }  ///< Empty where the error is not about a text.

 private:
  ErrorCode code_;
  std::string message_;
  TextPlace place_;
};

namespace detail {
[[noreturn]] void report_broken_invariant(const char* condition, const char* file, int line);
}

}  // namespace plumb
#pragma GCC visibility pop

/// Loud stop on a broken invariant, in every build type.
#define PLUMB_CHECK(condition)        \
  ((condition) ? static_cast<void>(0) \
               : ::plumb::detail::report_broken_invariant(#condition, __FILE__, __LINE__))
