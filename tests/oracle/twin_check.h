// What the comparisons of an engine with its twin in rationals have in common, in the plane and in
// space.
#pragma once

#include <string>

#include "oracle/cell_marks.h"

namespace plumb::testing {

inline void expect(bool right, const std::string& what) {
  if (!right) throw what;
}

inline void expect_same(bool engine, bool twin, const std::string& what) {
  if (engine == twin) return;
  const auto word = [](bool b) { return b ? "yes" : "no"; };
  throw what + ": engine " + word(engine) + ", twin " + word(twin);
}

/// What the checks throw, as they throw it (std::string), or "".
template <class Checks>
std::string first_difference(const Checks& checks) {
  try {
    checks();
  } catch (const std::string& difference) {
    return difference;
  }
  return "";
}

/// The unary operators, on both.
template <class Cells, class Sets>
void check_operators(const Cells& cells, const Sets& sets) {
  for (int i = static_cast<int>(SetOperator::Complement);
       i <= static_cast<int>(SetOperator::Regularization); ++i) {
    const auto op = static_cast<SetOperator>(i);
    const Sets result{apply(op, sets.engine, decltype(sets.engine)()),
                      apply(op, cells, sets.twin, CellMarks())};
    const std::string wrong = difference(cells, result);
    expect(wrong.empty(), name_of(op) + ": " + wrong);
  }
}

/// Makes both from an expression and looks at what every node of it gives.
template <class Operation, class Sets, class Set, class Cells>
class TreeCheck {
 public:
  TreeCheck(const Set& root, const Cells& cells) : root_(root), cells_(cells) {}

  std::string run() const {
    return first_difference([this] {
      const Sets sets = build(root_);
      expect_none(deep_difference(cells_, sets), root_);
    });
  }

 private:
  static void expect_none(const std::string& wrong, const Set& set) {
    expect(wrong.empty(), wrong + "\nin " + to_text(set));
  }

  Sets build(const Set& set) const {
    const auto* operation = std::get_if<Operation>(&set.node);
    Sets sets = operation ? build(*operation) : Sets{to_nef(set), marks_of(set, cells_)};
    expect_none(difference(cells_, sets), set);
    return sets;
  }

  Sets build(const Operation& o) const {
    const Sets first = build(*o.first);
    const Sets second = o.second ? build(*o.second) : Sets{};
    return {apply(o.op, first.engine, second.engine), apply(o.op, cells_, first.twin, second.twin)};
  }

  const Set& root_;
  const Cells& cells_;
};

}  // namespace plumb::testing
