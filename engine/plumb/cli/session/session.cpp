// The process and its session: signals, limits of memory, common options, outputs.
//
// For the first signal, a signal handler only sets a stop token. For the second signal, and for the
// alarm that rings if no checkpoint is reached in time, it removes temporary files and ends the
// process. Both actions are async-signal-safe. GMP aborts when memory runs out, so its allocators
// are replaced by allocators that report this and end the process. Outputs are delivered in this
// order: files are completed under temporary names, then standard output is written, and then files
// get their names, unless a stop was requested before. No alarm ends the process between these
// steps.
// Tested by tests/cli/program_test.cpp.
#include "plumb/cli/session/session.h"

#include <gmp.h>

#include <algorithm>
#include <atomic>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <limits>
#include <utility>

#include "plumb/base/keep_freed_memory.h"
#include "plumb/cli/session/process.h"
#include "plumb/io/text/files.h"
#include "plumb/predicates/error.h"

namespace plumb::cli {

void leave(ExitCode code) {
  remove_temporary_files();
  process::end_now(static_cast<int>(code));
}

namespace {

std::stop_source& stop_source() {
  static std::stop_source source;
  return source;
}

// The time within which a command must reach its next checkpoint.
constexpr double kGraceSeconds = 0.1;

// While standard output is written and files get their names, a command is not ended by an alarm.
std::atomic<bool> is_delivering = false;
std::atomic<bool> is_json = false;
static_assert(std::atomic<bool>::is_always_lock_free);

/// request_stop() is a single atomic exchange if no stop callback is registered. This program
/// registers none.
extern "C" void on_stop_signal(int) {
  if (!stop_source().request_stop()) leave(ExitCode::Cancelled);
  process::alarm_after(kGraceSeconds);
}

void write_to_stderr(std::string_view text) {
  while (!text.empty()) {
    const auto wrote = ::write(STDERR_FILENO, text.data(), static_cast<unsigned>(text.size()));
    if (wrote <= 0) return;
    text.remove_prefix(static_cast<std::size_t>(wrote));
  }
}

/// Reports an error and ends the process. Calls only functions that a signal handler may call.
[[noreturn]] void leave_with(std::string_view code, std::string_view message, ExitCode exit_code) {
  write_to_stderr(wiping_text());
  write_to_stderr(is_json ? "{\"error\":{\"code\":\"" : "plumb: ");
  if (is_json) {
    write_to_stderr(code);
    write_to_stderr("\",\"message\":\"");
  }
  write_to_stderr(message);
  write_to_stderr(is_json ? "\",\"file\":null,\"line\":null,\"column\":null}}\n" : "\n");
  leave(exit_code);
}

extern "C" void on_alarm(int) {
  if (is_delivering) return process::alarm_after(kGraceSeconds);
  if (stop_source().stop_requested()) leave_with("cancelled", "cancelled", ExitCode::Cancelled);
  leave_with("resource-limit", "the time limit was reached (raise --limit-seconds)",
             ExitCode::Limit);
}

extern "C" void on_abort(int) { leave(ExitCode::Internal); }

// An exception cannot leave GMP: its functions free memory before they ask for more, and keep the
// pointer.
void* require(void* memory) {
  if (memory == nullptr) {
    leave_with("resource-limit", "out of memory (raise --limit-memory, or use a smaller input)",
               ExitCode::Limit);
  }
  return memory;
}

void* gmp_allocate(std::size_t size) { return require(std::malloc(size)); }
void* gmp_reallocate(void* memory, std::size_t, std::size_t size) {
  return require(std::realloc(memory, size));
}
void gmp_free(void* memory, std::size_t) { std::free(memory); }

/// Returns the number of bytes of the character of UTF-8 with this first byte; 0 if there is none.
std::size_t character_bytes(unsigned char first) {
  if (first < 0x80) return 1;
  if (first < 0xc2 || first > 0xf4) return 0;
  return first < 0xe0 ? 2 : first < 0xf0 ? 3 : 4;
}

/// Returns the number of bytes of the character at the start of the text if the character is
/// printable; otherwise 0.
std::size_t printable_bytes(std::span<const char> text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const std::size_t size = character_bytes(byte(0));
  if (size == 0 || size > text.size()) return 0;
  for (std::size_t i = 1; i < size; ++i) {
    if (byte(i) < 0x80 || byte(i) > 0xbf) return 0;
  }
  const bool is_overlong =
      (byte(0) == 0xe0 && byte(1) < 0xa0) || (byte(0) == 0xf0 && byte(1) < 0x90);
  const bool is_no_character =
      (byte(0) == 0xed && byte(1) > 0x9f) || (byte(0) == 0xf4 && byte(1) > 0x8f);
  if (is_overlong || is_no_character) return 0;
  const bool is_control =
      size == 1 ? byte(0) < 0x20 || byte(0) == 0x7f : byte(0) == 0xc2 && byte(1) < 0xa0;
  return is_control ? 0 : size;
}

}  // namespace

void hide_controls(std::span<char> text) {
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t size = printable_bytes(text.subspan(i));
    if (size == 0) text[i] = '?';
    i += std::max<std::size_t>(size, 1);
  }
}

void report_errors_as_json() { is_json = true; }
bool are_errors_json() { return is_json; }

bool is_stop_requested() { return stop_source().stop_requested(); }

std::stop_token prepare_process() {
  stop_source();  // The stop source must exist before a signal handler uses it.
  process::handle(SIGINT, on_stop_signal);
  process::handle(SIGTERM, on_stop_signal);
  process::handle(SIGABRT, on_abort);
  process::handle_alarm(on_alarm);
  process::ignore_failed_writes();
  process::use_bytes_in_standard_streams();
  ::mp_set_memory_functions(gmp_allocate, gmp_reallocate, gmp_free);
  keep_freed_memory();
  use_huge_pages();
  return stop_source().get_token();
}

void limit_memory(std::uint64_t bytes, unsigned threads) {
  constexpr std::uint64_t kLeast = std::uint64_t{2} << 20U, kShare = 20;
  process::limit_growth(std::max(bytes + bytes / kShare, kLeast), threads - 1);
}

namespace {

Limits limits_of(const CommonOptions& options) {
  Limits limits;
  if (options.limit_memory_mb > 0) limits.max_memory_bytes = options.limit_memory_mb << 20U;
  // If the system grants less memory, work that needs more is refused with figures before memory is
  // exhausted.
  limits.max_memory_bytes = std::min(limits.max_memory_bytes, process::granted_memory());
  limits.max_seconds = options.limit_seconds;
  limits.max_number_digits = options.digits;
  limits.max_decimal_exponent = options.digits;
  return limits;
}

bool wants_progress(const CommonOptions& options) {
  return !options.quiet && (options.progress || ::isatty(STDERR_FILENO) == 1);
}

/// Returns an empty text if `text` is a positive number; otherwise the error. (CLI::Range accepts
/// nan.)
std::string require_positive(const std::string& text) {
  double value = 0;
  const bool is_positive = CLI::detail::lexical_cast(text, value) && value > 0;
  return is_positive ? std::string() : "a positive number is needed, not " + text;
}

std::string require_name(const std::string& text) {
  return text.empty() ? "the name of a file is needed, not an empty text" : std::string();
}

void require_no_stop() {
  if (is_stop_requested()) throw Error(ErrorCode::Cancelled, "cancelled");
}

}  // namespace

void CommonOptions::declare(CLI::App& app) {
  // The help of a command has no space for these options, so only the overview and the manual name
  // them. They are declared first, because CLI11 writes an empty line after each group except the
  // last.
  app.add_option("--digits", digits, "Digits of the longest number to read (default 1100)")
      ->check(CLI::Range(16U, 1'000'000U).description(""))
      ->type_name("N")
      ->group(kUnlistedGroup);
  app.add_flag("--timings", timings, "Print the CPU time by phase (standard error)")
      ->group(kUnlistedGroup);
  app.add_flag("--json", json, "One JSON object on standard output")->group(kCommonGroup);
  app.add_option("-o,--output", out, "File to write; - is standard output (--format)")
      ->check(require_name)
      ->type_name("OUT")
      ->group(kCommonGroup);
  app.add_option("--format", format, "Format to write (default: by the extension of OUT)")
      ->type_name("NAME")
      ->group(kCommonGroup);
  app.add_flag("--exact-decimals", exact_decimals, "Read 0.1 as 1/10, not as the nearest double")
      ->group(kCommonGroup);
  app.add_option("--threads", threads, "Threads to use (default 1)")
      ->check(CLI::Range(1U, 1024U).description(""))
      ->type_name("N")
      ->group(kCommonGroup);
  app.add_option("--limit-memory", limit_memory_mb, "Stop (exit 3) beyond MB megabytes")
      ->check(CLI::Range(std::uint64_t{1}, std::uint64_t{1} << 40U).description(""))
      ->type_name("MB")
      ->group(kCommonGroup);
  app.add_option("--limit-seconds", limit_seconds, "Stop (exit 3) after S seconds")
      ->check(require_positive)
      ->type_name("S")
      ->group(kCommonGroup);
  auto* const bar = app.add_flag("--progress", progress, "Show progress on standard error");
  bar->group(kCommonGroup);
  app.add_flag("-q,--quiet", quiet, "No progress and no notes")->excludes(bar)->group(kCommonGroup);
}

void Outputs::add(const std::string& path, Writer writer) {
  if (path != "-") {
    auto file = std::make_unique<OutputFile>(path);
    files_.push_back({std::move(file), std::move(writer)});
    return;
  }
  if (to_stdout_) throw Error(ErrorCode::Usage, "only one output can go to standard output");
  to_stdout_ = std::move(writer);
}

/// While an object of this class exists, and after it has succeeded, no alarm ends the process.
class Delivery {
 public:
  Delivery() { is_delivering = true; }
  ~Delivery() {
    if (std::uncaught_exceptions() > 0) is_delivering = false;
  }
  Delivery(const Delivery&) = delete;
  Delivery& operator=(const Delivery&) = delete;
};

/// Delivers outputs. Writers do not check the Context. Therefore files are not renamed if a stop
/// was requested before all output was written.
void Outputs::deliver(const std::function<void()>& before_stdout) {
  std::vector<std::unique_ptr<OutputFile>> finished;
  for (Pending& pending : files_) {
    require_no_stop();
    pending.writer(pending.file->stream());
    pending.file->finish();
    finished.push_back(std::move(pending.file));
  }
  const Delivery delivery;
  require_no_stop();
  if (to_stdout_) {
    before_stdout();
    DescriptorStream stream(STDOUT_FILENO, "stdout");
    to_stdout_(stream);
    stream.flush();
    if (!finished.empty()) require_no_stop();
  }
  commit_all(finished);
}

Session::Session(const CommonOptions& options, std::stop_token stop)
    : options_(options),
      progress_(wants_progress(options)),
      context_(limits_of(options), std::move(stop),
               progress_.is_shown() ? ProgressCallback(std::ref(progress_)) : ProgressCallback(),
               options.threads),
      watch_(context_) {
  if (options.timings) work_.emplace();
  if (options.limit_seconds > 0) process::alarm_after(options.limit_seconds + kGraceSeconds);
}

Session::~Session() {
  if (!held_back_.empty() && std::uncaught_exceptions() == 0) progress_.print(held_back_);
}

void Session::answer(const std::string& json, const Outputs::Writer& text) {
  outputs_.add(options_.out.empty() ? "-" : options_.out, [&](std::ostream& out) {
    if (options_.json) {
      out << json << '\n';
    } else {
      text(out);
    }
  });
  deliver();
}

void Session::deliver() {
  const WorkPhase phase("writing");
  begin("write");
  outputs_.deliver([this] {
    // Standard output and standard error may be the same terminal.
    if (!process::is_regular_file(STDOUT_FILENO)) progress_.clear();
  });
}

void Session::print_timings() {
  if (!work_) return;
  for (const std::string& line : phase_table(phases_of(work_->finish(), "command"))) print(line);
}

void Session::note(std::string_view text) {
  if (!options_.quiet) print(std::string(text));
}

void Session::warn(const std::string& file, const std::string& text) {
  print(file + ": warning: " + text);
}

void Session::print(std::string line) {
  hide_controls(line);
  if (options_.json) {
    held_back_ += held_back_.empty() ? line : '\n' + line;
  } else {
    progress_.print(line);
  }
}

}  // namespace plumb::cli
