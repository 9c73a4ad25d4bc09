// The commands `plumb manual`, `plumb completion` and `plumb self-test`.
//
// The manual page (roff) and the completion script (bash) are written from the same table of
// commands and the same declarations of options as the help, so they cannot disagree with it. Text
// is escaped so that no character of it is a request of roff.
// Tested by tests/cli/help_commands_test.cpp.

#include <array>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "plumb/base/version.h"
#include "plumb/cli/session/command.h"
#include "plumb/cli/session/session.h"
#include "plumb/predicates/environment.h"

namespace plumb::cli {
namespace {

/// Returns the text for roff such that no character of it is a request.
std::string roff(std::string_view text) {
  std::string escaped;
  if (text.starts_with('.') || text.starts_with('\'')) escaped = "\\&";
  for (const char c : text) {
    if (c == '\\') {
      escaped += "\\e";
    } else if (c == '-') {
      escaped += "\\-";
    } else if (c == '\'') {
      escaped += "\\(aq";
    } else if (c == '^') {
      escaped += "\\(ha";
    } else {
      escaped += c;
    }
  }
  return escaped;
}

void add_option(std::string& page, const OptionText& option) {
  page += ".TP\n\\fB" + roff(option.name) + "\\fR";
  if (!option.value.empty()) page += " \\fI" + roff(option.value) + "\\fR";
  page += '\n' + roff(option.text.empty() ? "As above" : option.text) + ".\n";
}

void add_command(std::string& page, const Command& command) {
  page += ".SS plumb " + roff(command.name);
  if (!command.arguments.empty()) page += " " + roff(command.arguments);
  page += '\n' + roff(command.summary) + ".\n";
  const CommandApp known(command);
  for (const OptionText& option : options_of(known.app)) {
    if (!option.is_common && option.name != "-h,--help") add_option(page, option);
  }
  page += ".PP\n.EX\n" + roff(command.example) + "\n.EE\n";
}

std::string manual() {
  std::string page = ".TH PLUMB 1 \"\" \"plumb " PLUMB_VERSION_STRING
                     "\" \"User Commands\"\n.SH NAME\n"
                     "plumb \\- exact geometry: every decision exact, every result auditable\n"
                     ".SH SYNOPSIS\n.B plumb\n.I COMMAND\n[\\fIARGUMENTS\\fR] [\\fIOPTIONS\\fR]\n"
                     ".SH DESCRIPTION\nplumb checks maps, combines sets of the plane and solids, "
                     "cuts them into convex pieces, and draws on mesh surfaces, all without "
                     "rounding. A file named \\- is standard input, or standard output.\n"
                     ".SH COMMANDS\n";
  for (const Command& command : commands()) add_command(page, command);
  page += ".SH OPTIONS OF EVERY COMMAND\n";
  CLI::App every;
  CommonOptions common;
  common.declare(every);
  for (const OptionText& option : options_of(every)) {
    if (option.is_common) add_option(page, option);
  }
  page += ".SH EXIT STATUS\n";
  for (const ExitMeaning& meaning : kExitMeanings) {
    page += ".TP\n" + std::to_string(static_cast<int>(meaning.code)) + '\n' + roff(meaning.text) +
            ".\n";
  }
  return page;
}

class Manual : public CommandBody {
 public:
  void declare(CLI::App&) override {}

  ExitCode run(Session& session) override {
    const std::string page = manual();
    const nlohmann::ordered_json json{{"format", "man"}, {"page", page}};
    session.answer(json.dump(), [&](std::ostream& out) { out << page; });
    return ExitCode::Yes;
  }
};

}  // namespace

std::unique_ptr<CommandBody> make_manual() { return std::make_unique<Manual>(); }

// The completion of commands, options and their words for the shell.

namespace {

constexpr std::string_view kHead = R"(# bash completion for plumb; `plumb completion bash` prints it
_plumb() {
  local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD - 1]}
  local first=${COMP_WORDS[1]-} seconds= options= values=
  COMPREPLY=()
  if ((COMP_CWORD == 1)); then
    mapfile -t COMPREPLY < <(compgen -W "@firsts" -- "$word")
    return
  fi
  case $first in
)";

constexpr std::string_view kMiddle = R"(  esac
  if [[ -n $seconds ]] && ((COMP_CWORD == 2)); then
    mapfile -t COMPREPLY < <(compgen -W "$seconds --help" -- "$word")
    return
  fi
  case "$first${seconds:+ ${COMP_WORDS[2]}}" in
)";

constexpr std::string_view kTail = R"(  esac
  if [[ -n $values ]]; then
    mapfile -t COMPREPLY < <(compgen -W "$values" -- "$word")
  elif [[ $word == -* ]]; then
    mapfile -t COMPREPLY < <(compgen -W "$options" -- "$word")
  else
    compopt -o filenames
    mapfile -t COMPREPLY < <(compgen -f -- "$word")
  fi
}
complete -F _plumb plumb
)";

void add_word(std::string& words, std::string_view word) {
  if (!words.empty()) words += ' ';
  words += word;
}

/// Returns "-o --output" for "-o,--output".
std::string spaced(std::string names) {
  for (char& c : names) c = c == ',' ? ' ' : c;
  return names;
}

/// Returns what can follow the options of a command.
std::string case_of(const Command& command) {
  const CommandApp known(command);
  std::string options;
  std::string values;
  for (const OptionText& option : options_of(known.app)) {
    if (option.is_argument) continue;
    add_word(options, spaced(option.name));
    if (option.choices.empty()) continue;
    values += "      case $before in " + option.name + ") values=\"" +
              CLI::detail::join(option.choices, " ") + "\" ;; esac\n";
  }
  return "    \"" + std::string(command.name) + "\")\n      options=\"" + options + "\"\n" +
         values + "      ;;\n";
}

struct FirstWord {
  std::string_view word;
  std::string seconds;
};

std::vector<FirstWord> first_words() {
  std::vector<FirstWord> words;
  for (const Command& command : commands()) {
    const std::string_view first = first_word(command.name);
    if (words.empty() || words.back().word != first) words.push_back({first, ""});
    if (first != command.name)
      add_word(words.back().seconds, command.name.substr(first.size() + 1));
  }
  return words;
}

std::string bash_completion() {
  std::string firsts;
  std::string groups;
  for (const FirstWord& first : first_words()) {
    add_word(firsts, first.word);
    if (first.seconds.empty()) continue;
    groups += "    " + std::string(first.word) + ") seconds=\"" + first.seconds + "\" ;;\n";
  }
  add_word(firsts, "--help --version");
  std::string script(kHead);
  constexpr std::string_view kPlace = "@firsts";
  script.replace(script.find(kPlace), kPlace.size(), firsts);
  script.append(groups).append(kMiddle);
  for (const Command& command : commands()) script += case_of(command);
  return script.append(kTail);
}

class Completion : public CommandBody {
 public:
  void declare(CLI::App&) override {}

  ExitCode run(Session& session) override {
    const std::string script = bash_completion();
    const nlohmann::ordered_json json{{"shell", "bash"}, {"script", script}};
    session.answer(json.dump(), [&](std::ostream& out) { out << script; });
    return ExitCode::Yes;
  }
};

}  // namespace

std::unique_ptr<CommandBody> make_completion() { return std::make_unique<Completion>(); }

namespace {

void print(std::ostream& stream, const SelfTestReport& report) {
  if (report.ok) stream << "ok: the predicates' requirements hold in this build\n";
  for (const std::string& line : report.failures) stream << "failure: " << line << '\n';
  for (const std::string& line : report.notes) stream << "note: " << line << '\n';
}

class SelfTest : public CommandBody {
 public:
  void declare(CLI::App&) override {}

  ExitCode run(Session& session) override {
    const SelfTestReport report = self_test();
    const nlohmann::ordered_json json{
        {"ok", report.ok}, {"failures", report.failures}, {"notes", report.notes}};
    session.answer(json.dump(), [&](std::ostream& out) { print(out, report); });
    return report.ok ? ExitCode::Yes : ExitCode::No;
  }
};

}  // namespace

std::unique_ptr<CommandBody> make_self_test() { return std::make_unique<SelfTest>(); }

}  // namespace plumb::cli
