// The table of commands. To add one: a file NAME_command.cpp with a factory, and a row in
// commands.cpp.
#pragma once

#include <CLI/CLI.hpp>
#include <memory>
#include <span>
#include <string_view>

#include "exit_code.h"
#include "session.h"

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

}  // namespace plumb::cli
