#include "plumb/plane/complex/plane_rules.h"

#include <algorithm>

namespace plumb {

// ---------------------------------------------------------------- winding numbers

void WindingNumberRule::start(const SweepCurves& curves) {
  for (std::size_t i = 0; i < jump_.size(); ++i) {
    if (curves[SegmentId(i)].a != curves_[i].a) jump_[i] = static_cast<std::int8_t>(-jump_[i]);
  }
}

bool WindingNumberRule::are_all_inside(Label least, Label greatest) const {
  if (rule_ == WindingRule::EvenOdd) return least == greatest && is_inside(least);
  return least > 0 || (rule_ == WindingRule::NonZero && greatest < 0);
}

// An edge of a closed set is marked if it is next to the inside, or if chains run over it equally
// often in both directions. An edge of an open set is marked if, for every order of crossing its
// chains, the winding number is inside at each intermediate step.
bool WindingNumberRule::edge_mark(Label below, Label above, Value value) const {
  const auto [up, down] = value;
  if (boundary_ == Boundary::Closed) return is_inside(below) || is_inside(above) || up == -down;
  return (up != 0 || down != 0) && are_all_inside(below + down, below + up);
}

// ---------------------------------------------------------------- overlays

void turn_sides(std::span<const SweepCurve> given, const SweepCurves& turned,
                std::span<OverlayCurve> sides) {
  for (std::size_t i = 0; i < sides.size(); ++i) {
    if (turned[SegmentId(i)].a != given[i].a) std::swap(sides[i].left, sides[i].right);
  }
}

bool BooleanRule::edge_mark(Label below, Label, const Value& value) const {
  std::array<bool, 2> marks = {marks_[0].face[below[0]] != 0, marks_[1].face[below[1]] != 0};
  mark_passing(value, marks);
  return function_(marks[0], marks[1]);
}

void BooleanRule::mark_passing(const Value& value, std::array<bool, 2>& marks) const {
  for (const SegmentId s : {value.first, value.second}) {
    if (!s.is_valid()) continue;
    const OverlayCurve& from = side(s);
    marks[from.operand] = marks_[from.operand].edge[from.edge.value()] != 0;
  }
}

/// The mark of an operand at a place is the mark of its vertex there. If there is none, it is the
/// mark of the edge through the place, or else the mark of the face.
bool BooleanRule::vertex_mark(const PlaneSurroundings<BooleanRule>& at) const {
  std::array<bool, 2> marks = {marks_[0].face[at.below[0]] != 0, marks_[1].face[at.below[1]] != 0};
  if (!at.event.plain) {
    for (const Value& value : at.incoming) mark_passing(value, marks);
  }
  for (const std::uint32_t p : at.event.points) {
    const std::uint32_t v = vertex_at_[p];
    if (v == kNoVertex) continue;
    const std::size_t operand = (v & kSecondOperand) != 0 ? 1 : 0;
    marks[operand] = marks_[operand].vertex[v & ~kSecondOperand] != 0;
  }
  return function_(marks[0], marks[1]);
}

}  // namespace plumb
