// plumb manual: the manual page, written from the same table as the help.

#include <nlohmann/json.hpp>
#include <string>

#include "command_app.h"
#include "exit_code.h"
#include "plumb/base/version.h"

namespace plumb::cli {
namespace {

/// As text of roff: no character of it is a request.
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

}  // namespace plumb::cli
