#include "plumb/io/svg/svg_style.h"

#include <algorithm>
#include <charconv>
#include <system_error>
#include <utility>

namespace plumb {
namespace {

constexpr std::string_view kCssBlanks = " \t\r\n\f";

/// Takes a part from the front of `text`, up to the next `end`, and drops this character.
std::string_view take_part(std::string_view& text, char end) {
  const std::string_view part = text.substr(0, text.find(end));
  text.remove_prefix(std::min(part.size() + 1, text.size()));
  return part;
}

/// Appends the ASCII character for a reference of XML at the front of `text`, and drops the
/// reference. Returns false if there is none.
bool take_reference(std::string_view& text, std::string& kept) {
  constexpr std::size_t kLongest = 12;
  constexpr std::array<std::pair<std::string_view, char>, 5> kNamed{
      {{"gt", '>'}, {"lt", '<'}, {"amp", '&'}, {"quot", '"'}, {"apos", '\''}}};
  const std::size_t end = text.substr(0, kLongest).find(';');
  if (end == text.npos) return false;
  const std::string_view name = text.substr(1, end - 1);
  unsigned code = 0;
  if (name.starts_with('#')) {
    const int base = name.starts_with("#x") ? 16 : 10;
    const char* const last = name.data() + name.size();
    const auto [read, error] =
        std::from_chars(name.data() + (base == 16 ? 2 : 1), last, code, base);
    if (error != std::errc() || read != last) return false;
  } else {
    const auto* const found =
        std::ranges::find(kNamed, name, &std::pair<std::string_view, char>::first);
    if (found != kNamed.end()) code = static_cast<unsigned char>(found->second);
  }
  if (code == 0 || code >= 0x80) return false;
  kept += static_cast<char>(code);
  text.remove_prefix(end + 1);
  return true;
}

/// Returns a style sheet without comments of CSS and XML, without the marks of CDATA sections, and
/// with the characters in place of references outside of such sections.
std::string without_comments(std::string_view text) {
  struct Mark {
    std::string_view begin, end;
  };
  constexpr std::array<Mark, 4> kMarks{
      {{"/*", "*/"}, {"<!--", "-->"}, {"<![CDATA[", ""}, {"]]>", ""}}};
  std::string kept;
  kept.reserve(text.size());
  bool is_literal = false;  // Whether a CDATA section is open.
  while (!text.empty()) {
    if (!is_literal && text.front() == '&' && take_reference(text, kept)) continue;
    if (text.starts_with("<![CDATA[")) is_literal = true;
    if (text.starts_with("]]>")) is_literal = false;
    const auto* const mark =
        std::ranges::find_if(kMarks, [&](const Mark& m) { return text.starts_with(m.begin); });
    if (mark == kMarks.end()) {
      kept += text.front();
      text.remove_prefix(1);
      continue;
    }
    text.remove_prefix(mark->begin.size());
    const std::size_t end = text.find(mark->end);
    text.remove_prefix(end == text.npos ? text.size() : end + mark->end.size());
  }
  return kept;
}

/// Takes a block from the front of `text`, which begins behind its '{', and drops its '}'. A block
/// that is not closed ends with the text.
std::string_view take_block(std::string_view& text) {
  std::size_t depth = 1, i = 0;
  for (; i < text.size(); ++i) {
    if (text[i] == '{') ++depth;
    if (text[i] == '}' && --depth == 0) break;
  }
  const std::string_view block = text.substr(0, i);
  text.remove_prefix(std::min(i + 1, text.size()));
  return block;
}

bool is_name(std::string_view text) {
  constexpr std::string_view kLetters =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-";
  return !text.empty() && std::ranges::all_of(text, [&](char c) {
    return static_cast<unsigned char>(c) >= 0x80 || kLetters.find(c) != kLetters.npos;
  });
}

/// How special a selector of one element is: 1 for an element, 2 for a class, 4 for an id, and the
/// sum for an element with one of them. Returns -1 for other selectors.
int weight_of(std::string_view selector) {
  if (selector == "*") return 0;
  const std::size_t mark = selector.find_first_of(".#");
  if (mark == selector.npos) return is_name(selector) ? 1 : -1;
  const std::string_view element = selector.substr(0, mark);
  if (!is_name(selector.substr(mark + 1)) || !(element.empty() || is_name(element))) return -1;
  return (selector[mark] == '#' ? 4 : 2) + (element.empty() ? 0 : 1);
}

}  // namespace

std::string_view trimmed_value(std::string_view text) {
  text.remove_prefix(std::min(text.find_first_not_of(kCssBlanks), text.size()));
  return text.substr(0, text.find_last_not_of(kCssBlanks) + 1);
}

bool is_css_word(std::string_view text, std::string_view lower_case) {
  return std::ranges::equal(text, lower_case, [](char a, char b) {
    return (a >= 'A' && a <= 'Z' ? static_cast<char>(a - 'A' + 'a') : a) == b;
  });
}

SvgDeclaration svg_declaration(std::string_view list, std::string_view name) {
  SvgDeclaration found;
  while (!list.empty()) {
    std::string_view declaration = take_part(list, ';');
    if (declaration.find(':') == declaration.npos) continue;
    if (!is_css_word(trimmed_value(take_part(declaration, ':')), name)) continue;
    const std::size_t mark = declaration.find('!');
    const bool is_important = mark != declaration.npos &&
                              is_css_word(trimmed_value(declaration.substr(mark + 1)), "important");
    if (found.is_important && !is_important) continue;
    found = {trimmed_value(declaration.substr(0, mark)), is_important};
  }
  return found;
}

void SvgStyleSheet::add(std::string_view text, Context& context) {
  context.charge_memory(text.size(), "the drawing");
  std::string_view rest = texts_.emplace_back(without_comments(text));
  while (!rest.empty()) {
    context.check_limits("read");
    const std::size_t end = std::min(rest.find_first_of("{;"), rest.size());
    const std::string_view head = trimmed_value(rest.substr(0, end));
    const bool has_block = rest.substr(end).starts_with('{');
    rest.remove_prefix(std::min(end + 1, rest.size()));
    if (has_block) add_rule(head, take_block(rest), context);
  }
}

void SvgStyleSheet::add_rule(std::string_view selectors, std::string_view list, Context& context) {
  ++rule_count_;
  if (selectors.starts_with('@')) {
    // The rules in it apply to some media only. Whether they set a property is read from the text.
    for (const std::string_view property : kSvgProperties) {
      if (list.find(property) != list.npos) not_applied_.emplace(property, selectors);
    }
    return;
  }
  std::array<SvgDeclaration, kSvgProperties.size()> declarations;
  for (std::size_t p = 0; p < declarations.size(); ++p) {
    declarations[p] = svg_declaration(list, kSvgProperties[p]);
  }
  if (std::ranges::all_of(declarations, [](const auto& d) { return d.value.empty(); })) return;
  while (!selectors.empty()) {
    context.check_limits("read");
    add_selector(trimmed_value(take_part(selectors, ',')), declarations, context);
  }
}

void SvgStyleSheet::add_selector(std::string_view selector,
                                 const std::array<SvgDeclaration, kSvgProperties.size()>& set,
                                 Context& context) {
  constexpr std::uint64_t kRuleBytes = sizeof(Declarations) + 96;  // A node of the map.
  constexpr unsigned kImportant = 62, kWeight = 56;
  if (selector.starts_with("*.") || selector.starts_with("*#")) selector.remove_prefix(1);
  const int weight = weight_of(selector);
  if (weight < 0) {
    for (std::size_t p = 0; p < set.size(); ++p) {
      if (!set[p].value.empty()) not_applied_.emplace(kSvgProperties[p], selector);
    }
    return;
  }
  const auto [rule, is_new] = rules_.try_emplace(selector);
  if (is_new) context.charge_memory(kRuleBytes, "the drawing");
  for (std::size_t p = 0; p < set.size(); ++p) {
    take_better(rule->second[p],
                {set[p], (std::uint64_t{set[p].is_important} << kImportant) |
                             (static_cast<std::uint64_t>(weight) << kWeight) | rule_count_});
  }
}

void SvgStyleSheet::take_better(Ranked& best, const Ranked& other) {
  if (!other.declaration.value.empty() && other.rank >= best.rank) best = other;
}

SvgDeclaration SvgStyleSheet::value(std::string_view property, const Element& element) const {
  const auto* const found = std::ranges::find(kSvgProperties, property);
  if (found == kSvgProperties.end() || is_empty()) return {};
  const auto p = static_cast<std::size_t>(found - kSvgProperties.begin());
  Ranked best;
  const auto look_up = [&](std::string_view selector) {
    const auto rule = rules_.find(selector);
    if (rule != rules_.end()) take_better(best, rule->second[p]);
  };
  std::string selector;
  const auto look_up_marked = [&](char mark, std::string_view name) {
    selector.assign(element.name).append(1, mark).append(name);
    look_up(selector);
    look_up(std::string_view(selector).substr(element.name.size()));
  };
  look_up("*");
  look_up(element.name);
  for (std::string_view rest = trimmed_value(element.classes); !rest.empty();
       rest = trimmed_value(rest)) {
    const std::string_view name = rest.substr(0, rest.find_first_of(kCssBlanks));
    rest.remove_prefix(name.size());
    look_up_marked('.', name);
  }
  if (!element.id.empty()) look_up_marked('#', element.id);
  return best.declaration;
}

}  // namespace plumb
