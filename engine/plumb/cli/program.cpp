// The program finds the command for its arguments, and the exit code for an error.
//
// The command is the first row of the table whose words begin the arguments. For an unknown command
// or option, the message suggests the nearest known word. The distance of words is the optimal
// string alignment distance: insertions, deletions, substitutions, and swaps of neighbours (the
// restricted form of F. J. Damerau, Communications of the ACM 7, 1964). Help and overview are made
// from the same table.
//
// Every error becomes one line on standard error and an exit code; text that comes from files is
// printed without control characters and cut to a bounded length. The path that reports exhausted
// memory allocates nothing.
// Tested by tests/cli/program_test.cpp and tests/cli/help_commands_test.cpp.

#include "plumb/cli/program.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <iterator>
#include <limits>
#include <memory>
#include <new>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "plumb/base/keep_freed_memory.h"
#include "plumb/base/version.h"
#include "plumb/cli/session/command.h"
#include "plumb/cli/session/process.h"
#include "plumb/cli/session/session.h"
#include "plumb/predicates/error.h"

namespace plumb::cli {

/// Returns the entry of `known` that differs from `word` by the fewest insertions, deletions,
/// substitutions and swaps of neighbours. If several entries differ equally, returns the first one.
/// Returns an empty text if even the nearest entry differs by more than a third of the length of
/// `word`, or by more than one if `word` has one or two letters.
std::string nearest(std::string_view word, std::span<const std::string> known);

namespace {

/// Returns the optimal string alignment distance.
std::size_t distance(std::string_view a, std::string_view b) {
  std::vector<std::vector<std::size_t>> d(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
  for (std::size_t i = 0; i <= a.size(); ++i) {
    for (std::size_t j = 0; j <= b.size(); ++j) {
      if (i == 0 || j == 0) {
        d[i][j] = i + j;
        continue;
      }
      const std::size_t change = a[i - 1] == b[j - 1] ? 0 : 1;
      d[i][j] = std::min({d[i - 1][j] + 1, d[i][j - 1] + 1, d[i - 1][j - 1] + change});
      const bool is_swap = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
      if (is_swap) d[i][j] = std::min(d[i][j], d[i - 2][j - 2] + 1);
    }
  }
  return d[a.size()][b.size()];
}

}  // namespace

std::string nearest(std::string_view word, std::span<const std::string> known) {
  // Longer words are not typing errors, and comparing them takes time.
  constexpr std::size_t kLongest = 64;
  if (word.size() > kLongest) return {};
  std::string best;
  std::size_t least = std::max<std::size_t>(word.size() / 3, 1) + 1;
  for (const std::string& candidate : known) {
    const std::size_t d = distance(word, candidate);
    if (d < least) {
      least = d;
      best = candidate;
    }
  }
  return best;
}

namespace {

using Arguments = std::vector<std::string>;

constexpr std::string_view kVersion = PLUMB_VERSION_STRING;

[[noreturn]] void fail_usage(const std::string& message) { throw Error(ErrorCode::Usage, message); }

void print(const std::string& text) {
  Outputs outputs;
  outputs.add("-", [&](std::ostream& out) { out << text; });
  outputs.deliver();
}

std::string padded(std::string text, std::size_t width) {
  text.resize(width, ' ');
  return text;
}

/// The words of a command, and its description.
using Row = std::pair<std::string, std::string_view>;

Row row_of(const Command& command) {
  std::string what(command.name);
  if (!command.arguments.empty()) what.append(1, ' ').append(command.arguments);
  return {std::move(what), command.summary};
}

/// Returns the commands that start with the word `group`.
std::vector<Row> rows_of(std::string_view group) {
  std::vector<Row> rows;
  for (const Command& command : commands()) {
    if (first_word(command.name) == group) rows.push_back(row_of(command));
  }
  return rows;
}

/// Returns all commands; those of a group share a row.
std::vector<Row> all_rows() {
  std::vector<Row> rows;
  std::string_view last_word;
  for (const Command& command : commands()) {
    const std::string_view word = first_word(command.name);
    const auto group = std::find_if(command_groups().begin(), command_groups().end(),
                                    [&](const CommandGroup& g) { return g.word == word; });
    if (group == command_groups().end()) {
      rows.push_back(row_of(command));
    } else if (word != last_word) {
      rows.emplace_back(std::string(word) + " ...", group->summary);
    }
    last_word = word;
  }
  return rows;
}

std::string table(const std::vector<Row>& rows) {
  std::size_t width = 0;
  for (const auto& [what, summary] : rows) width = std::max(width, what.size() + 2);
  std::string text;
  for (const auto& [what, summary] : rows) {
    text += "  " + padded(what, width) + std::string(summary) + '\n';
  }
  return text;
}

/// Returns the example of the first command that starts with the word `group`.
std::string_view example_of(std::string_view group) {
  const auto first = std::find_if(commands().begin(), commands().end(),
                                  [&](const Command& c) { return first_word(c.name) == group; });
  return first->example;
}

/// Returns help for all commands, or for those that start with the word `group`.
std::string overview(std::string_view group = {}) {
  std::string text;
  if (group.empty()) {
    text = "plumb " + std::string(kVersion) +
           " - exact geometry: every decision exact, every result auditable\n\n";
  }
  text += "Usage: plumb COMMAND [ARGUMENTS] [OPTIONS]\n\nCommands:\n";
  text += table(group.empty() ? all_rows() : rows_of(group));
  if (!group.empty()) text += "\nExample:\n  " + std::string(example_of(group)) + '\n';
  text +=
      "\nOptions of every command:\n"
      "  --json  -o OUT  --format NAME  --exact-decimals  --digits N  --threads N  -q\n"
      "  --progress  --timings  --limit-memory MB  --limit-seconds S  --help\n"
      "The file - is stdin or stdout. plumb COMMAND --help says more; plumb --version\n"
      "prints the version.\n"
      "Exit: 0 yes, 1 no, 2 bad input, 3 limit, 4 cancelled, 70 bug in plumb.\n";
  return text;
}

bool is_help(std::string_view word) { return word == "--help" || word == "-h" || word == "help"; }

bool is_group(std::string_view word) {
  return std::any_of(commands().begin(), commands().end(), [&](const Command& command) {
    return command.name != word && first_word(command.name) == word;
  });
}

/// Returns how many of `arguments` spell `name`: all its words, or 0.
std::size_t words_matched(const Arguments& arguments, std::string_view name) {
  std::size_t count = 0;
  while (!name.empty()) {
    const std::string_view word = first_word(name);
    if (count == arguments.size() || arguments[count] != word) return 0;
    name.remove_prefix(std::min(name.size(), word.size() + 1));
    ++count;
  }
  return count;
}

/// Returns the command of this group that is most similar to `second`, or an empty text.
std::string guess_in_group(const std::string& group, const std::string& second) {
  Arguments words;
  for (const Command& command : commands()) {
    if (command.name.starts_with(group + ' ')) {
      words.emplace_back(command.name.substr(group.size() + 1));
    }
  }
  const std::string guess = nearest(second, words);
  return guess.empty() ? guess : group + ' ' + guess;
}

/// Returns the command that is most similar to `first`, alone or with `second`, or an empty text.
std::string guess_command(const std::string& first, const std::string& second) {
  if (is_group(first)) return guess_in_group(first, second);
  Arguments names;
  Arguments last_words;
  for (const Command& command : commands()) {
    names.emplace_back(command.name);
    last_words.emplace_back(command.name.substr(command.name.rfind(' ') + 1));
  }
  if (second.empty()) {
    for (const CommandGroup& group : command_groups()) names.emplace_back(group.word);
  }
  std::string guess = nearest(second.empty() ? first : first + ' ' + second, names);
  if (guess.empty()) guess = nearest(first, names);
  if (!guess.empty()) return guess;
  const std::string word = nearest(first, last_words);
  const auto place = std::find(last_words.begin(), last_words.end(), word);
  return place == last_words.end() ? std::string()
                                   : names[static_cast<std::size_t>(place - last_words.begin())];
}

[[noreturn]] void fail_unknown_command(const Arguments& arguments) {
  std::string given = arguments.front();
  if (given.size() > 1 && given.starts_with('-')) {
    fail_usage("options come after the command, not first as '" + given +
               "'; plumb --help lists both");
  }
  const bool has_second = arguments.size() > 1 && !arguments[1].starts_with('-');
  const std::string second = has_second ? arguments[1] : std::string();
  if (is_group(given) && !has_second) {
    fail_usage("'" + given + "' needs a second word; plumb " + given + " --help lists them");
  }
  const std::string guess = guess_command(given, second);
  if (is_group(given)) given += ' ' + second;
  fail_usage("unknown command '" + given + "'" +
             (guess.empty() ? "; plumb --help lists them" : "; did you mean '" + guess + "'?"));
}

/// Returns CLI11's message, and names the most similar option.
std::string parse_message(const CLI::App& app, const CLI::ParseError& error) {
  std::string message = error.what();
  if (error.get_exit_code() != static_cast<int>(CLI::ExitCodes::ExtrasError)) return message;
  Arguments names;
  for (const CLI::Option* option : app.get_options()) {
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  }
  const std::string given = message.substr(message.find_last_of(' ') + 1);
  const std::string guess = given.starts_with('-') ? nearest(given, names) : std::string();
  return guess.empty() ? message : message + "; did you mean '" + guess + "'?";
}

/// Returns the argument with a digit before its decimal point, because CLI11 accepts "-0.5" as a
/// number, but takes "-.5" for options.
std::string with_digit(std::string argument) {
  const bool starts_with_point =
      argument.size() > 2 && argument.starts_with("-.") && argument[2] >= '0' && argument[2] <= '9';
  return starts_with_point ? argument.insert(1, 1, '0') : argument;
}

ExitCode run_command(const Command& command, Arguments arguments, std::stop_token stop) {
  const std::string name(command.name);
  CommandApp known(command);
  CLI::App& app = known.app;
  std::transform(arguments.begin(), arguments.end(), arguments.begin(), with_digit);
  std::reverse(arguments.begin(), arguments.end());  // CLI11 requires this order.
  try {
    app.parse(std::move(arguments));
  } catch (const CLI::CallForHelp&) {
    print(app.help());
    return ExitCode::Yes;
  } catch (const CLI::ParseError& error) {
    fail_usage(name + ": " + parse_message(app, error) + "\nplumb " + name + " --help says more");
  }
  const std::uint64_t megabytes = known.common.limit_memory_mb;
  if (megabytes > 0) limit_memory(megabytes << 20U, known.common.threads);
  constexpr unsigned kFewThreads = 4;
  if (known.common.threads > 1 && known.common.threads <= kFewThreads) use_one_heap();
  Session session(known.common, std::move(stop));
  const ExitCode code = known.body->run(session);
  session.print_timings();
  return code;
}

ExitCode dispatch(const Arguments& arguments, std::stop_token stop) {
  if (arguments.empty()) fail_usage("a command is missing; plumb --help lists them");
  const std::string& first = arguments.front();
  if (is_help(first)) {
    print(overview());
    return ExitCode::Yes;
  }
  if (first == "--version") {
    print("plumb " + std::string(kVersion) + '\n');
    return ExitCode::Yes;
  }
  for (const Command& command : commands()) {
    const std::size_t words = words_matched(arguments, command.name);
    if (words == 0) continue;
    const auto rest = arguments.begin() + static_cast<std::ptrdiff_t>(words);
    return run_command(command, Arguments(rest, arguments.end()), std::move(stop));
  }
  if (is_group(first) && arguments.size() > 1 && is_help(arguments[1])) {
    print(overview(first));
    return ExitCode::Yes;
  }
  fail_unknown_command(arguments);
}

ExitCode exit_code_of(ErrorCode code) {
  switch (code) {
    case ErrorCode::ResourceLimit:
      return ExitCode::Limit;
    case ErrorCode::Cancelled:
      return ExitCode::Cancelled;
    case ErrorCode::ClosedPipe:
      return ExitCode::ClosedPipe;
    default:
      return ExitCode::BadInput;
  }
}

// Reports of errors: a line for people or, with --json, an object. They allocate no memory, because
// there may be none left.

constexpr std::string_view kOutOfMemory =
    "out of memory (raise --limit-memory, or use a smaller input)";

/// Returns the word for the code in a JSON report (docs/formats.md, "JSON").
std::string_view word_of(ErrorCode code) {
  switch (code) {
    case ErrorCode::CannotOpen:
      return "cannot-open";
    case ErrorCode::CannotWrite:
      return "cannot-write";
    case ErrorCode::NotText:
      return "not-text";
    case ErrorCode::Syntax:
      return "syntax";
    case ErrorCode::NumberOutOfRange:
      return "number-out-of-range";
    case ErrorCode::CountMismatch:
      return "count-mismatch";
    case ErrorCode::BadIndex:
      return "bad-index";
    case ErrorCode::DegenerateFace:
      return "degenerate-face";
    case ErrorCode::UnknownFormat:
      return "unknown-format";
    case ErrorCode::Usage:
      return "usage";
    case ErrorCode::ClosedPipe:
      return "closed-pipe";
    case ErrorCode::BadShape:
      return "bad-shape";
    case ErrorCode::ResourceLimit:
      return "resource-limit";
    case ErrorCode::Cancelled:
      return "cancelled";
    case ErrorCode::NotFinite:
      return "not-finite";
    case ErrorCode::BadArgument:
      return "bad-argument";
  }
  return "internal";
}

/// Returns the advice for the user about a limit that the message of an error names.
std::string_view advice_on(ErrorCode code, std::string_view message) {
  const auto names = [&](std::string_view words) { return message.find(words) != message.npos; };
  if (code == ErrorCode::NumberOutOfRange) {
    return names(" digits") ? " (raise --digits)" : "";
  }
  if (code != ErrorCode::ResourceLimit) return "";
  if (names("time limit")) return " (raise --limit-seconds)";
  if (!names("memory limit")) return "";
  const bool is_granted = process::granted_memory() == std::numeric_limits<std::uint64_t>::max();
  return is_granted ? " (raise --limit-memory)" : " (raise --limit-memory and ulimit -v)";
}

/// A text of bounded length, which may contain text from files.
class BoundedText {
 public:
  explicit BoundedText(std::string_view text) : size_(std::min(text.size(), text_.size())) {
    std::copy_n(text.begin(), size_, text_.begin());
  }
  /// Replaces control characters, apart from line breaks if `keeps_lines`.
  std::string_view without_controls(bool keeps_lines) {
    for (std::size_t begin = 0; begin < size_;) {
      const std::size_t end =
          keeps_lines ? std::min(std::string_view(text_.data(), size_).find('\n', begin), size_)
                      : size_;
      hide_controls(std::span(text_).subspan(begin, end - begin));
      begin = end + 1;
    }
    return {text_.data(), size_};
  }

 private:
  std::array<char, 4096> text_{};
  std::size_t size_;
};

void print_bytes(std::string_view text) { std::fwrite(text.data(), 1, text.size(), stderr); }

/// Prints a text as a string of JSON.
void print_json_string(std::string_view text) {
  BoundedText bounded(text);
  std::fputc('"', stderr);
  for (const char c : bounded.without_controls(true)) {
    if (c == '"' || c == '\\') std::fputc('\\', stderr);
    c == '\n' ? print_bytes("\\n") : static_cast<void>(std::fputc(c, stderr));
  }
  std::fputc('"', stderr);
}

/// Prints a member of an object: a number, or null if it is 0.
void print_json_number(const char* name, std::size_t value) {
  if (value == 0) {
    std::fprintf(stderr, ",\"%s\":null", name);
  } else {
    std::fprintf(stderr, ",\"%s\":%zu", name, value);
  }
}

/// Prints the object that --json promises for an error. A message that is too long is cut.
void print_json_error(std::string_view code, std::string_view message, std::string_view advice,
                      const TextPlace& place) {
  std::array<char, 2048> whole{};
  const std::size_t size = std::min(message.size(), whole.size() - advice.size());
  std::copy(advice.begin(), advice.end(), std::copy_n(message.begin(), size, whole.begin()));
  print_bytes("{\"error\":{\"code\":");
  print_json_string(code);
  print_bytes(",\"message\":");
  print_json_string({whole.data(), size + advice.size()});
  print_bytes(",\"file\":");
  place.file.empty() ? print_bytes("null") : print_json_string(place.file);
  print_json_number("line", place.line);
  print_json_number("column", place.column);
  print_bytes("}}\n");
}

/// Prints a line without control characters.
void print_line(std::string_view text, std::string_view advice) {
  BoundedText bounded(text);
  print_bytes(bounded.without_controls(false));
  print_bytes(advice);
  print_bytes("\n");
}

ExitCode report_refused_memory() {
  if (are_errors_json()) {
    print_json_error(word_of(ErrorCode::ResourceLimit), kOutOfMemory, "", {});
  } else {
    std::fprintf(stderr, "plumb: %s\n", kOutOfMemory.data());
  }
  return ExitCode::Limit;
}

/// If an error has a place, its line begins with "FILE:LINE:COLUMN: ...". Otherwise, its line
/// begins with the name of the program.
ExitCode report(const Error& error) {
  const ExitCode code = exit_code_of(error.code());
  if (code == ExitCode::ClosedPipe) return code;
  const std::string_view advice = advice_on(error.code(), error.message());
  if (are_errors_json()) {
    print_json_error(word_of(error.code()), error.message(), advice, error.place());
  } else if (error.place().file.empty()) {
    std::fprintf(stderr, "plumb: %s%s\n", error.what(), advice.data());
  } else {
    print_line(error.what(), advice);
  }
  return code;
}

ExitCode report(const std::exception& error) {
  constexpr std::string_view kWhatToDo =
      "This is a bug in plumb. Please report it with the input and the command line.";
  if (are_errors_json()) {
    print_json_error("internal", error.what(), ". " + std::string(kWhatToDo), {});
  } else {
    std::fprintf(stderr, "plumb: internal error: %s.\n%s\n", error.what(), kWhatToDo.data());
  }
  return ExitCode::Internal;
}

/// Returns the exit code for the exception that is being handled, and reports it.
ExitCode report_current_exception() {
  try {
    throw;
  } catch (const Error& error) {
    return report(error);
  } catch (const std::bad_alloc&) {
    return report_refused_memory();
  } catch (const std::exception& error) {
    return report(error);
  } catch (...) {
    return report(std::runtime_error("an exception of an unknown type"));
  }
}

/// This function is called if an exception cannot leave a function, for example a destructor of the
/// JSON library. A limit that is exceeded there is reported like any other limit.
[[noreturn]] void on_terminate() {
  if (std::current_exception() == nullptr) std::abort();
  leave(report_current_exception());
}

}  // namespace

ExitCode run_program(const Arguments& arguments, std::stop_token stop) noexcept {
  if (std::find(arguments.begin(), arguments.end(), "--json") != arguments.end()) {
    report_errors_as_json();
  }
  std::set_terminate(on_terminate);
  try {
    return dispatch(arguments, std::move(stop));
  } catch (...) {
    return report_current_exception();
  }
}

}  // namespace plumb::cli

int main(int argc, char** argv) {
  const std::stop_token stop = plumb::cli::prepare_process();
  const std::vector<std::string> arguments(argv + (argc > 0 ? 1 : 0), argv + argc);
  return static_cast<int>(plumb::cli::run_program(arguments, stop));
}
