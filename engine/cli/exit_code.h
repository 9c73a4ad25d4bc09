// What the program's exit status means (docs/formats.md, "Exit codes").
#pragma once

namespace plumb::cli {

enum class ExitCode {
  Yes = 0,        ///< done, valid, true
  No = 1,         ///< a clean negative answer
  BadInput = 2,   ///< bad input or usage
  Limit = 3,      ///< a limit was hit
  Cancelled = 4,  ///< by SIGINT or SIGTERM
  Internal = 70,  ///< a bug in plumb
  ClosedPipe = 141,
};

}  // namespace plumb::cli
