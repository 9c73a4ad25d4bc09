// plumb completion bash: what the shell needs to know to complete commands, options and their words.

#include <array>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "command_app.h"

namespace plumb::cli {
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

/// "-o,--output": "-o --output".
std::string spaced(std::string names) {
  for (char& c : names) c = c == ',' ? ' ' : c;
  return names;
}

/// What can follow the options of a command.
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

}  // namespace plumb::cli
