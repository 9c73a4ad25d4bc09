// What the program's exit status means (docs/formats.md, "Exit codes").
#pragma once

#include <CLI/CLI.hpp>
#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <ostream>
#include <stop_token>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "plumb/base/context.h"
#include "plumb/cli/session/progress.h"
#include "plumb/io/text/files.h"

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

// What the process promises its surroundings: signals, memory, exit status.

/// Call once, before anything else.
///   SIGINT, SIGTERM   the first requests a stop of the returned token; the second ends the process
///                     with 4 at once, temporary files removed. Also where they were ignored: a
///                     shell ignores SIGINT for what it starts in the background
///   SIGPIPE, SIGXFSZ  ignored: a failed write says so (closed pipe, file too large)
///   SIGABRT           a broken invariant, reported already: temporary files removed, exit 70
///   malloc            keeps what is freed
///   GMP               throws std::bad_alloc when memory runs out, instead of aborting
std::stop_token prepare_process();

/// Has a signal asked for a stop? For work that has no Context.
bool is_stop_requested();

/// A safety net under the accounts of Context: the address space may grow by `bytes` and a little
/// more; allocations beyond throw std::bad_alloc.
void limit_address_space(std::uint64_t bytes);

// What every command is given: the options all commands take, the context, messages, outputs.

/// The group of the options that every command has, in its help.
inline constexpr const char* kCommonGroup = "Options of every command";

struct CommonOptions {
  bool json = false;
  std::string out;     ///< empty: standard output
  std::string format;  ///< empty: by the extension of `out`
  unsigned threads = 1;
  bool progress = false;
  bool quiet = false;
  std::uint64_t limit_memory_mb = 0;  ///< 0: none
  double limit_seconds = 0;           ///< 0: none
  bool exact_decimals = false;

  void declare(CLI::App& app);
};

/// Files and standard output of one command, all or nothing: files are opened before the work,
/// completed under temporary names, then standard output is written, then the files get their
/// names.
class Outputs {
 public:
  using Writer = std::function<void(std::ostream&)>;

  /// Opens `path` now ("-" is standard output, once); `writer` runs in deliver().
  void add(const std::string& path, Writer writer);
  /// `before_stdout` is called before anything goes to standard output.
  void deliver(const std::function<void()>& before_stdout = [] {});

 private:
  struct Pending {
    std::unique_ptr<OutputFile> file;
    Writer writer;
  };
  std::vector<Pending> files_;
  Writer to_stdout_;
};

/// Control characters, which names in files may hold, are told as '?': nothing that a file says
/// gives orders to a terminal.
constexpr bool is_control(char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; }

class Session {
 public:
  Session(const CommonOptions& options, std::stop_token stop);

  const CommonOptions& options() const { return options_; }
  Context& context() { return context_; }
  Outputs& outputs() { return outputs_; }

  /// The answer of a command that has no other output, to -o or standard output: `text`, or with
  /// --json the object `json`.
  void answer(const std::string& json, const Outputs::Writer& text);

  /// A line on standard error, unless --quiet, without control characters.
  void note(std::string_view text);

  /// What the command will do, for the progress bar; begin() says when each stage begins
  /// (progress.h).
  void expect(ProgressStages stages) { progress_.expect(std::move(stages)); }
  void begin(std::string_view stage) { progress_.begin(stage); }
  /// Writes all outputs: the stage "write".
  void deliver();

 private:
  CommonOptions options_;
  ProgressBar progress_;
  Context context_;
  Outputs outputs_;
};

}  // namespace plumb::cli
