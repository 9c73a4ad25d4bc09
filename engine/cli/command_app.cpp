#include "command_app.h"

namespace plumb::cli {

CommandApp::CommandApp(const Command& command)
    : app(std::string(command.summary), "plumb " + std::string(command.name)),
      body(command.make()) {
  std::string footer = "Example:\n  " + std::string(command.example);
  footer += "\n\nJSON: docs/schema/" + std::string(command.schema) + ".schema.json";
  app.footer(footer);
  body->declare(app);
  common.declare(app);
}

std::string_view first_word(std::string_view name) { return name.substr(0, name.find(' ')); }

std::vector<OptionText> options_of(const CLI::App& app) {
  std::vector<OptionText> texts;
  for (const CLI::Option* option : app.get_options()) {
    OptionText text;
    text.is_argument = option->get_positional();
    text.name = option->get_name(text.is_argument, !text.is_argument);
    text.text = option->get_description();
    text.is_common = option->get_group() == kCommonGroup;
    const bool takes_value = !text.is_argument && option->get_expected_max() > 0;
    if (takes_value) text.value = option->get_type_name();
    if (text.value.find('|') != std::string::npos) {
      text.choices = CLI::detail::split(text.value, '|');
    }
    texts.push_back(std::move(text));
  }
  return texts;
}

CLI::Option* add_choice(CLI::App& app, const std::string& name, std::string& value,
                        const std::vector<std::string>& words, const std::string& text) {
  return app.add_option(name, value, text)
      ->type_name(CLI::detail::join(words, "|"))
      ->check(CLI::IsMember(words).description(""));
}

}  // namespace plumb::cli
