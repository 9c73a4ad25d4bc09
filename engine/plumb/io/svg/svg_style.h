// Style sheets of drawings, as far as they decide what belongs to a shape.
//
// A style sheet is a list of rules: selectors, and declarations for the elements that they select.
// Three properties matter to a set: display, visibility and fill-rule. Selectors of one element are
// applied: `*`, an element, a class or an id, and an element with a class or an id, such as
// `path.outer`. Drawing programs rarely write others. A rule with another selector, or in an
// at-rule such as @media, is not applied; its selector is kept for a note if the rule sets one of
// the three properties. Format: W3C, Cascading Style Sheets Level 2, sections 4 to 6.
//
// Rules that select the same elements are merged while they are read: of two declarations, the
// important one decides, then that of the more special selector, then the later one. The value for
// an element is therefore found by one look-up for each of its names, however many rules there are.
//
// Tested by tests/io/svg_style_test.cpp.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <string>
#include <string_view>

#include "plumb/base/context.h"

namespace plumb {

/// The properties of elements that decide which points belong to a shape.
inline constexpr std::array<std::string_view, 3> kSvgProperties{"display", "visibility",
                                                                "fill-rule"};

/// Returns a text without the blanks at its ends.
std::string_view trimmed_value(std::string_view text);

/// Whether two words of CSS are equal; capitals do not count.
bool is_css_word(std::string_view text, std::string_view lower_case);

/// A declaration that decides the value of a property.
struct SvgDeclaration {
  std::string_view value;  ///< Empty if no declaration applies.
  bool is_important = false;
};

/// Returns the last of the declarations `name: value` in a list separated by semicolons; an
/// important one decides before others.
SvgDeclaration svg_declaration(std::string_view list, std::string_view name);

/// The rules of all style sheets of a drawing.
class SvgStyleSheet {
 public:
  /// What rules select an element by.
  struct Element {
    std::string_view name;     ///< Without a prefix.
    std::string_view id;       ///< Empty if it has none.
    std::string_view classes;  ///< Names separated by blanks.
  };

  /// Appends the rules of `text`, the content of an element `style`. Its memory stays charged to
  /// `context`. Cost: O(bytes log rules).
  void add(std::string_view text, Context& context);
  /// Returns the declaration of a property, one of kSvgProperties, that applies to an element.
  /// Cost: O(bytes of the classes, and log rules for each of them).
  SvgDeclaration value(std::string_view property, const Element& element) const;

  bool is_empty() const { return rules_.empty(); }
  /// Returns a selector for each property that a rule sets although it is not applied.
  const std::map<std::string_view, std::string_view>& not_applied() const { return not_applied_; }

 private:
  /// A declaration, and what decides between several ones: the larger rank does.
  struct Ranked {
    SvgDeclaration declaration;
    std::uint64_t rank = 0;
  };
  using Declarations = std::array<Ranked, kSvgProperties.size()>;

  void add_rule(std::string_view selectors, std::string_view list, Context& context);
  void add_selector(std::string_view selector,
                    const std::array<SvgDeclaration, kSvgProperties.size()>& set, Context& context);
  static void take_better(Ranked& best, const Ranked& other);

  std::deque<std::string> texts_;  // Without comments; all views below lie in them.
  // By selector: "*", "path", ".outer", "#a", "path.outer", "path#a".
  std::map<std::string_view, Declarations, std::less<>> rules_;
  std::map<std::string_view, std::string_view> not_applied_;
  std::uint64_t rule_count_ = 0;
};

}  // namespace plumb
