// The things that a command receives and that the process guarantees: exit codes, signals and
// memory, common options, outputs, messages.
#pragma once

#include <CLI/CLI.hpp>
#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <ostream>
#include <span>
#include <stop_token>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "plumb/base/arithmetic_watch.h"
#include "plumb/base/context.h"
#include "plumb/base/internal/work_log.h"
#include "plumb/cli/session/progress.h"
#include "plumb/io/text/files.h"

namespace plumb::cli {

/// The exit status of the program (docs/formats.md, "Exit codes").
enum class ExitCode {
  Yes = 0,        ///< Done, valid, or true.
  No = 1,         ///< A clean negative answer.
  BadInput = 2,   ///< Bad input or usage.
  Limit = 3,      ///< A limit was hit.
  Cancelled = 4,  ///< Cancelled by SIGINT or SIGTERM.
  Internal = 70,  ///< A bug in plumb.
  ClosedPipe = 141,
};

/// The meaning of an exit code, for the manual.
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

// What the process guarantees: signals, memory, exit status.

/// Prepares the process and returns the token of its stops. Must be called once, before
/// anything else.
///   SIGINT, SIGTERM   The first requests a stop of the token; the second ends the process with 4
///                     at once, with temporary files removed. This holds even if they were
///                     ignored: a shell ignores SIGINT for what it starts in the background
///   SIGPIPE, SIGXFSZ  Ignored: a failed write reports the reason (closed pipe, file too large)
///   SIGABRT           A broken invariant that has been reported: temporary files are removed, exit
///                     70
///   SIGALRM           No checkpoint was reached within a tenth of a second after a stop or after
///                     the time limit: the process reports it and ends with 4 or 3 at once, with
///                     temporary files removed
///   malloc            Keeps what is freed
///   GMP               When memory runs out, the process reports it and ends with 3 at once, with
///                     temporary files removed
std::stop_token prepare_process();

/// Whether errors are reported as objects of JSON: set once, before the first command.
void report_errors_as_json();
bool are_errors_json();

/// Ends the process at once, with temporary files removed.
[[noreturn]] void leave(ExitCode code);

/// Whether a signal has asked for a stop. For work that has no Context.
bool is_stop_requested();

/// Lets the memory of the process grow by `bytes` and a twentieth, and at least by 2 MB;
/// allocations beyond that throw std::bad_alloc. `threads` is the number of threads that the
/// command may use. The estimates of Context bound each step of a command; this bounds the command.
void limit_memory(std::uint64_t bytes, unsigned threads);

// What every command is given: the options that all commands take, the context, messages, outputs.

/// The group of the options that every command has, in its help.
inline constexpr const char* kCommonGroup = "Options of every command";

/// The group of options that every command has and no help of a command lists. (CLI11 hides the
/// names of options without a group, in messages, too.)
inline constexpr const char* kUnlistedGroup = "Unlisted";

/// The options that every command has.
struct CommonOptions {
  bool json = false;
  std::string out;     ///< Empty for standard output.
  std::string format;  ///< Empty if the extension of `out` decides.
  unsigned threads = 1;
  bool progress = false;
  bool timings = false;
  bool quiet = false;
  std::uint64_t limit_memory_mb = 0;  ///< 0 means none.
  double limit_seconds = 0;           ///< 0 means none.
  bool exact_decimals = false;
  std::uint32_t digits = Limits().max_number_digits;  ///< The limit for one number that is read.

  void declare(CLI::App& app);
};

/// Files and standard output of one command, all or nothing: files are opened before the work and
/// completed under temporary names; then standard output is written; then the files get their
/// names.
class Outputs {
 public:
  using Writer = std::function<void(std::ostream&)>;

  /// Opens `path` now ("-" is standard output, once); `writer` runs in deliver().
  void add(const std::string& path, Writer writer);
  /// Writes everything. `before_stdout` is called before anything goes to standard output.
  void deliver(const std::function<void()>& before_stdout = [] {});

 private:
  struct Pending {
    std::unique_ptr<OutputFile> file;
    Writer writer;
  };
  std::vector<Pending> files_;
  Writer to_stdout_;
};

/// Replaces control characters by '?', so that no file can send commands to a terminal. Control
/// characters are the control characters of ASCII, the characters from U+0080 to U+009F, and bytes
/// that begin or continue no character of UTF-8. Allocates no memory.
void hide_controls(std::span<char> text);

/// The objects with which a command works.
class Session {
 public:
  Session(const CommonOptions& options, std::stop_token stop);
  /// Prints the notes that were held back.
  ~Session();
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;

  const CommonOptions& options() const { return options_; }
  Context& context() { return context_; }
  Outputs& outputs() { return outputs_; }

  /// Writes the answer of a command that has no other output, to -o or standard output: `text`, or
  /// with --json the object `json`.
  void answer(const std::string& json, const Outputs::Writer& text);

  /// Prints a line on standard error, unless --quiet, without control characters.
  void note(std::string_view text);
  /// Prints the line "FILE: warning: TEXT" even with --quiet: the result lacks something that a
  /// file has.
  void warn(const std::string& file, const std::string& text);

  /// Sets the steps of the command, for the progress bar; begin() is called when each stage begins
  /// (progress.h).
  void expect(ProgressStages stages) { progress_.expect(std::move(stages)); }
  void begin(std::string_view stage) { progress_.begin(stage); }
  /// Writes all outputs: the stage "write".
  void deliver();
  /// With --timings, prints the CPU time by phase, measured from the construction on. Called once,
  /// at the end of the command.
  void print_timings();

 private:
  void print(std::string line);

  CommonOptions options_;
  ProgressBar progress_;
  std::string held_back_;  // Notes, with --json: if an error follows, it is printed alone.
  Context context_;
  const ArithmeticWatch watch_;
  std::optional<WorkLog> work_;  // With --timings.
  Outputs outputs_;
};

}  // namespace plumb::cli
