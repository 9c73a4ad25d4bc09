// A command with its options as CLI11 knows them: what is parsed, and what help, manual and completion say.
#pragma once

#include <CLI/CLI.hpp>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "command.h"
#include "session.h"

namespace plumb::cli {

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
