// What every command is given: the options all commands take, the context, messages, outputs.
#pragma once

#include <CLI/CLI.hpp>
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
#include "plumb/io/output_file.h"
#include "progress_bar.h"

namespace plumb::cli {

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

/// Control characters, which names in files may hold, are told as '?': nothing that a file says gives orders to a terminal.
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

  /// What the command will do, for the progress bar; begin() says when each stage begins (progress_stages.h).
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
