// The table of commands. To add one: a file NAME_command.cpp with a factory, and a row in
// command.cpp.
#pragma once

#include <CLI/CLI.hpp>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "plumb/cli/session/session.h"

namespace plumb::cli {

/// What a command does. Made anew for every run.
class CommandBody {
 public:
  virtual ~CommandBody() = default;
  /// Adds its own options and arguments; those of every command are added besides.
  virtual void declare(CLI::App& app) = 0;
  /// Does the work. Whatever it prints goes through session.outputs(). Throws plumb::Error.
  virtual ExitCode run(Session& session) = 0;
};

struct Command {
  std::string_view name;       ///< one or two words: "self-test", "map check"
  std::string_view arguments;  ///< "FILE"
  std::string_view summary;    ///< one line
  std::string_view example;    ///< works when pasted at the root of the repository
  std::string_view schema;     ///< of what --json prints: docs/schema/NAME.schema.json
  std::unique_ptr<CommandBody> (*make)();
};

/// In the order of the help.
std::span<const Command> commands();

/// A first word of so many commands that the help shows it in one line; plumb WORD --help has all.
struct CommandGroup {
  std::string_view word;
  std::string_view summary;
};
std::span<const CommandGroup> command_groups();

// A command with its options as CLI11 knows them: what is parsed, and what help, manual and
// completion say.

class CommandApp {
 public:
  explicit CommandApp(const Command& command);

  CLI::App app;
  CommonOptions common;
  std::unique_ptr<CommandBody> body;
};

/// "solid" of "solid union".
std::string_view first_word(std::string_view name);

/// An option or argument, as one reads about it.
struct OptionText {
  std::string name;                  ///< "--rule", "-o,--output", "FILE"
  std::string value;                 ///< "OUT"; empty for flags and arguments
  std::string text;                  ///< one sentence
  std::vector<std::string> choices;  ///< if only these words can follow
  bool is_argument = false;          ///< has a place instead of a name
  bool is_common = false;            ///< every command has it
};
std::vector<OptionText> options_of(const CLI::App& app);

/// An option that takes one of a few words, which help and completion list.
CLI::Option* add_choice(CLI::App& app, const std::string& name, std::string& value,
                        const std::vector<std::string>& words, const std::string& text);

}  // namespace plumb::cli
