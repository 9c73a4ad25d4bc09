// Style sheets beside the cascade as CSS defines it, evaluated rule by rule.
#include "plumb/io/svg/svg_style.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

#include "plumb/base/context.h"
#include "plumb/testing/dice.h"

namespace plumb {
namespace {

struct Rule {
  std::string element, id, one_class;  // Empty if the selector has none.
  std::string value;
  bool is_important;
};

std::string text_of(const Rule& rule) {
  std::string selector = rule.element;
  if (!rule.id.empty()) selector += '#' + rule.id;
  if (!rule.one_class.empty()) selector += '.' + rule.one_class;
  if (selector.empty()) selector = "*";
  return selector + " { fill:none; display : " + rule.value +
         (rule.is_important ? " ! important" : "") + " }\n";
}

/// The declaration of the last rule with the largest specificity, important ones first.
std::string cascade(const std::vector<Rule>& rules, const std::string& element,
                    const std::string& id, const std::vector<std::string>& classes) {
  using Rank = std::tuple<bool, bool, bool, bool>;
  Rank best{};
  std::string value;
  for (const Rule& rule : rules) {
    const bool has_class = std::ranges::count(classes, rule.one_class) > 0;
    if (!rule.element.empty() && rule.element != element) continue;
    if (!rule.id.empty() && rule.id != id) continue;
    if (!rule.one_class.empty() && !has_class) continue;
    const Rank rank{rule.is_important, !rule.id.empty(), !rule.one_class.empty(),
                    !rule.element.empty()};
    if (rank < best) continue;
    best = rank;
    value = rule.value;
  }
  return value;
}

TEST(SvgStyleSheet, agrees_with_the_cascade) {
  const std::vector<std::string> elements{"rect", "path"}, ids{"", "x", "y"},
      names{"", "a", "b", "cls-1"};
  testing::Dice dice(20261129);
  for (int round = 0; round < 2000; ++round) {
    std::vector<Rule> rules;
    SvgStyleSheet sheet;
    std::string text;
    for (std::uint64_t n = dice.below(8); n-- > 0;) {
      Rule rule{dice.below(2) == 0 ? "" : elements[dice.below(2)], "", "",
                "value" + std::to_string(rules.size()), dice.below(4) == 0};
      (dice.below(2) == 0 ? rule.id : rule.one_class) =
          dice.below(2) == 0 ? ids[dice.below(3)] : "";
      if (rule.id.empty()) rule.one_class = names[dice.below(4)];
      text += text_of(rule);
      rules.push_back(std::move(rule));
      if (dice.below(4) == 0) sheet.add(std::exchange(text, {}), unlimited_context());
    }
    sheet.add(text, unlimited_context());
    const std::string& element = elements[dice.below(2)];
    const std::string& id = ids[dice.below(3)];
    std::vector<std::string> classes;
    std::string joined;
    for (std::uint64_t n = dice.below(3); n-- > 0;) {
      classes.push_back(names[1 + dice.below(3)]);
      joined += ' ' + classes.back();
    }
    EXPECT_EQ(sheet.value("display", {element, id, joined}).value,
              cascade(rules, element, id, classes));
    EXPECT_TRUE(sheet.value("visibility", {element, id, joined}).value.empty());
    EXPECT_TRUE(sheet.not_applied().empty());
  }
}

TEST(SvgStyleSheet, reads_what_programs_write) {
  for (const std::string sheet :
       {".a{fill-rule:evenodd}", "\n .b , .a { fill : red ; fill-rule : evenodd ; }",
        ".a{fill-rule:evenodd", "/* ; .a{ */.a{/* x: y; */fill-rule:evenodd/* } */}",
        "<![CDATA[.a{fill-rule:evenodd}]]>", "@charset \"utf-8\";.a{fill-rule:evenodd}",
        "*.a{fill-rule:evenodd}", "@media print{.a{fill-rule:nonzero}}.a{fill-rule:evenodd}",
        ".a{fill-rule:evenodd}<!-- .a{fill-rule:nonzero} -->",
        ".a{fill-rule:nonzero;fill-rule:evenodd}", ".a{;;clip-rule:nonzero;fill-rule:evenodd;;}",
        ".a{FILL-Rule:nonzero;Fill-Rule:evenodd}",
        ".a{fill-rule:evenodd ! IMPORTANT;fill-rule:nonzero}"}) {
    SvgStyleSheet rules;
    rules.add(sheet, unlimited_context());
    EXPECT_EQ(rules.value("fill-rule", {"path", "", "a"}).value, "evenodd") << sheet;
    EXPECT_TRUE(rules.value("fill-rule", {"path", "a", ""}).value.empty()) << sheet;
  }
  for (const std::string sheet :
       {"", "}", "{", "{}", ";", "@", ".a", ".a{", ".a{display", "@media{", "/*", "<!--",
        "<![CDATA[", ",{display:none}", "a:b{c:d}}{"}) {
    SvgStyleSheet rules;
    rules.add(sheet, unlimited_context());
    EXPECT_TRUE(rules.value("display", {"path", "", "a"}).value.empty()) << sheet;
  }
}

TEST(SvgStyleSheet, names_the_selectors_that_are_not_applied) {
  SvgStyleSheet rules;
  rules.add(
      "g &gt; .x{fill:red} g .a, .b{display:none} a:hover{visibility:hidden} g>.c{fill:red} @media "
      "print{.b{fill-rule:nonzero}}",
      unlimited_context());
  const std::map<std::string_view, std::string_view> expected{
      {"display", "g .a"}, {"visibility", "a:hover"}, {"fill-rule", "@media print"}};
  EXPECT_EQ(rules.not_applied(), expected);
  EXPECT_EQ(rules.value("display", {"rect", "", "b"}).value, "none");
}

}  // namespace
}  // namespace plumb
