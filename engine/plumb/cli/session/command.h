// The table of commands, and commands with their options. To add one: a file NAME_command.cpp with
// a factory, and a row in command.cpp.
#pragma once

#include <CLI/CLI.hpp>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "plumb/cli/session/session.h"

namespace plumb::cli {

/// The work of a command. Every run makes a new object.
class CommandBody {
 public:
  virtual ~CommandBody() = default;
  /// Adds the options and arguments that only this command has. The options of every command are
  /// added elsewhere.
  virtual void declare(CLI::App& app) = 0;
  /// Does the work. All its outputs go through session.outputs(). Throws plumb::Error.
  virtual ExitCode run(Session& session) = 0;
};

/// A row of the table.
struct Command {
  std::string_view name;       ///< One or two words: "self-test", "map check".
  std::string_view arguments;  ///< Arguments, such as "FILE".
  std::string_view summary;    ///< One line.
  /// A command line that works when pasted at the root of the repository.
  std::string_view example;
  std::string_view schema;  ///< Schema of what --json prints: docs/schema/NAME.schema.json.
  std::unique_ptr<CommandBody> (*make)();
};

/// Returns the commands in the order of the help.
std::span<const Command> commands();

/// A first word with so many commands that the help shows it in one line; plumb WORD --help lists
/// all.
struct CommandGroup {
  std::string_view word;
  std::string_view summary;
};
std::span<const CommandGroup> command_groups();

// A command with its options in the form of CLI11. They are parsed, and help, manual and completion
// print them.

/// A command that is ready to parse its arguments.
class CommandApp {
 public:
  explicit CommandApp(const Command& command);

  CLI::App app;
  CommonOptions common;
  std::unique_ptr<CommandBody> body;
};

/// Returns "solid" for "solid union".
std::string_view first_word(std::string_view name);

/// The text on an option or argument.
struct OptionText {
  std::string name;                  ///< Its names: "--rule", "-o,--output", "FILE".
  std::string value;                 ///< Its value, such as "OUT"; empty for flags and arguments.
  std::string text;                  ///< One sentence.
  std::vector<std::string> choices;  ///< The words that can follow, if only these can.
  bool is_argument = false;          ///< Whether it has a place instead of a name.
  bool is_common = false;            ///< Whether every command has it.
};
/// Returns the texts of all options and arguments.
std::vector<OptionText> options_of(const CLI::App& app);

/// Adds an option that takes one of a few words, which help and completion list.
CLI::Option* add_choice(CLI::App& app, const std::string& name, std::string& value,
                        const std::vector<std::string>& words, const std::string& text);

}  // namespace plumb::cli
