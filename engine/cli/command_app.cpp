#include "command_app.h"

#include <memory>
#include <sstream>
#include <utility>

namespace plumb::cli {
namespace {

constexpr std::size_t kScreen = 80;        // columns
constexpr std::size_t kDescriptions = 30;  // where they begin

/// `text` in lines of at most `width` characters, broken between words.
std::string wrapped(const std::string& text, std::size_t width) {
  std::istringstream words(text);
  std::string lines;
  std::size_t used = 0;
  for (std::string word; words >> word;) {
    const bool fits = used + 1 + word.size() <= width;
    if (used > 0) lines += fits ? ' ' : '\n';
    used = used > 0 && fits ? used + 1 + word.size() : word.size();
    lines += word;
  }
  return lines;
}

/// CLI11's help on a screen of 80 columns, without what it says of how options exclude each other.
class Formatter : public CLI::Formatter {
 public:
  Formatter() {
    column_width(kDescriptions);
    label("Positionals", "Arguments");
  }

  std::string make_option_desc(const CLI::Option* option) const override {
    return wrapped(option->get_description(), kScreen - kDescriptions);
  }

  std::string make_option_opts(const CLI::Option* option) const override {
    if (option->get_positional()) return {};
    std::string text;
    if (!option->get_type_name().empty()) text += ' ' + option->get_type_name();
    if (option->get_required()) text += " REQUIRED";
    return text;
  }

  /// make_groups() ends all groups but the last with an empty line, and here they begin with one.
  std::string make_group(std::string group, bool is_positional,
                         std::vector<const CLI::Option*> options) const override {
    const bool is_last = group == kCommonGroup;
    return CLI::Formatter::make_group(std::move(group), is_positional, std::move(options))
        .substr(is_last ? 1 : 0);
  }
};

}  // namespace

CommandApp::CommandApp(const Command& command)
    : app(std::string(command.summary), "plumb " + std::string(command.name)),
      body(command.make()) {
  std::string footer = "Example:\n  " + std::string(command.example);
  footer += "\n\nJSON: docs/schema/" + std::string(command.schema) + ".schema.json";
  app.footer(footer);
  app.formatter(std::make_shared<Formatter>());
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
