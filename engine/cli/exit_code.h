// What the program's exit status means (docs/formats.md, "Exit codes").
#pragma once

#include <array>
#include <string_view>

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

/// For the manual.
struct ExitMeaning {
  ExitCode code;
  std::string_view text;
};
inline constexpr std::array kExitMeanings{
    ExitMeaning{ExitCode::Yes, "Done; valid; true"},
    ExitMeaning{ExitCode::No, "A clean negative answer: a defective map, a failed audit"},
    ExitMeaning{ExitCode::BadInput, "Bad input or usage"},
    ExitMeaning{ExitCode::Limit, "A limit was hit, or memory ran out"},
    ExitMeaning{ExitCode::Cancelled, "Cancelled by SIGINT or SIGTERM"},
    ExitMeaning{ExitCode::Internal, "A bug in plumb; the message says what to report"},
    ExitMeaning{ExitCode::ClosedPipe, "The reader of the output closed the pipe"},
};

}  // namespace plumb::cli
