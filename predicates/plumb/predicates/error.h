// The exceptions that plumb throws, and the check of its own invariants.
//
// Bad input, exceeded limits and cancellation throw Error. Negative answers ("open", "not convex",
// "not equal") are results, never errors. std::bad_alloc passes through unchanged when the system
// refuses memory. A broken invariant is a bug in plumb: PLUMB_CHECK calls the handler that the host
// installed, then throws BrokenInvariant. The host is never aborted.
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

/// Thrown when plumb finds that one of its own invariants does not hold: a bug in plumb, whatever
/// the input. what() names the condition and its place in the sources. Objects that took part in
/// the failed operation may only be destroyed or assigned to.
class BrokenInvariant : public std::logic_error {
 public:
  using std::logic_error::logic_error;
};

/// Called with the condition that does not hold and its place in the sources, before
/// BrokenInvariant is thrown. A handler may log, throw an exception of its own, or end the process.
using InvariantHandler = void (*)(const char* condition, const char* file, int line);

/// Installs a handler for all threads and returns the previous one. A null pointer, the initial
/// value, means that BrokenInvariant is thrown at once.
InvariantHandler set_invariant_handler(InvariantHandler handler) noexcept;

namespace detail {
[[noreturn]] void report_broken_invariant(const char* condition, const char* file, int line);
}

}  // namespace plumb
#pragma GCC visibility pop

/// Reports a broken invariant, in every build type, as described at BrokenInvariant.
#define PLUMB_CHECK(condition)        \
  ((condition) ? static_cast<void>(0) \
               : ::plumb::detail::report_broken_invariant(#condition, __FILE__, __LINE__))
