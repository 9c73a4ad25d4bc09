// The exceptions that plumb throws, and the macro by which plumb checks its own invariants.
//
// Bad input, exceeded limits and cancellation throw Error. A negative answer ("open", "not convex",
// "not equal") is a result, never an error. If the system refuses memory, std::bad_alloc reaches
// the caller unchanged. A broken invariant is a bug in plumb. If an invariant is broken,
// PLUMB_CHECK calls the handler that the program installed, and then throws BrokenInvariant. plumb
// never aborts the program.
#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>
#include <string_view>

#pragma GCC visibility push(default)
namespace plumb {

/// The reason for an Error. Every Error has one of these codes. The codes form three ranges of
/// numbers:
///   - 1xx: input text and files;
///   - 2xx: resources and cancellation;
///   - 3xx: geometry that a caller passes.
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
  ClosedPipe = 110,  ///< The reader of the output closed the pipe; no message is needed.
  BadShape = 111,    ///< A ring has too few corners, or records contradict each other.
  ResourceLimit = 200,
  Cancelled = 201,
  NotFinite = 300,
  BadArgument = 301,
};

/// A position in a text input.
struct TextPlace {
  std::string file;        ///< The path or another name of the input.
  std::size_t line = 0;    ///< The line, counted from 1; 0 if unknown.
  std::size_t column = 0;  ///< The column in bytes, counted from 1; 0 if unknown.
};

/// Thrown for bad input, an exceeded limit, or cancellation. what() returns a text to print, in one
/// of the forms "FILE:LINE:COLUMN: message", "FILE: message" and "message".
class Error : public std::runtime_error {
 public:
  /// Constructs an error. The text of what() is composed of the place and the message.
  Error(ErrorCode code, std::string message, TextPlace place = {});

  ErrorCode code() const { return code_; }  ///< Returns the reason as a code.
  /// Returns the message for people, without the position in the text input.
  const std::string& message() const { return message_; }
  /// Returns the position in the text input. The position is empty if the error does not concern a
  /// text input.
  const TextPlace& place() const { return place_; }

 private:
  ErrorCode code_;
  std::string message_;
  TextPlace place_;
};

/// Thrown if plumb finds that one of its own invariants does not hold. A BrokenInvariant always
/// shows a bug in plumb, even for bad input. what() names the condition, its source file and its
/// line. Objects that took part in the failed operation may only be destroyed or assigned to.
class BrokenInvariant : public std::logic_error {
 public:
  using std::logic_error::logic_error;
};

/// A function that is called before BrokenInvariant is thrown. The handler receives the text of the
/// condition that does not hold, and the source file and the line of this condition. A handler may
/// log, throw an exception of its own, or end the process.
using InvariantHandler = void (*)(const char* condition, const char* file, int line);

/// Installs a handler for all threads and returns the previous handler. If the handler is a null
/// pointer, BrokenInvariant is thrown without a call of a handler. The initial handler is a null
/// pointer.
InvariantHandler set_invariant_handler(InvariantHandler handler) noexcept;

namespace detail {
[[noreturn]] void report_broken_invariant(const char* condition, const char* file, int line);
}

}  // namespace plumb
#pragma GCC visibility pop

/// If the condition is false, calls the handler and throws BrokenInvariant. Every build type checks
/// the condition.
#define PLUMB_CHECK(condition)        \
  ((condition) ? static_cast<void>(0) \
               : ::plumb::detail::report_broken_invariant(#condition, __FILE__, __LINE__))
