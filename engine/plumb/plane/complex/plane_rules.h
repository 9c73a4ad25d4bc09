// The rules with which PlaneBuilder is run: the meaning of labels and marks for polygons, Booleans,
// overlays of maps and arrangements. plane_builder.h lists the members of a rule;
// docs/design/sweep.md, Labels carried upward, has a table of them.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "plumb/base/marks.h"
#include "plumb/plane/arrangement.h"
#include "plumb/plane/complex/plane_builder.h"
#include "plumb/plane/plane_complex.h"
#include "plumb/predicates/error.h"

namespace plumb {

/// The rule of polygons. A label is the winding number of a face; the value of a bundle is how much
/// its curves raise it and lower it on the way upward.
class WindingNumberRule {
 public:
  using Label = std::int32_t;
  struct Value {
    Label up = 0;
    Label down = 0;
  };
  static constexpr bool kKeepsAll = false;
  static constexpr bool kKeepsLabels = false;

  /// `jump` says for each curve by how much the winding number rises from its right side to its
  /// left, seen along the curve as given: 1, -1, or 0 for a slit. For each input point, `is_point`
  /// states whether the point is a chain of its own. A closed set contains such a point in any
  /// case.
  WindingNumberRule(std::span<const SweepCurve> curves, std::vector<std::int8_t> jump,
                    std::vector<std::uint8_t> is_point, WindingRule rule, Boundary boundary,
                    Label bottom = 0)
      : curves_(curves),
        jump_(std::move(jump)),
        is_point_(std::move(is_point)),
        rule_(rule),
        boundary_(boundary),
        bottom_(bottom) {}

  void start(const SweepCurves& curves);
  Label bottom() const { return bottom_; }
  void begin_change() const {}
  void join(Value& value, SegmentId s) const { change(value, jump_[s], 1); }
  void leave(Value& value, SegmentId s) const { change(value, jump_[s], -1); }
  Label above(Label below, Value value) const { return below + value.up + value.down; }
  Label below(Label above, Value value) const { return above - value.up - value.down; }
  bool face_mark(Label winding) const { return is_inside(winding); }
  bool edge_mark(Label below, Label above, Value value) const;
  bool vertex_mark(const PlaneSurroundings<WindingNumberRule>& at) const {
    return boundary_ == Boundary::Open ? at.all_marked : at.any_marked || is_point(at.event);
  }
  void keep_edge(Value) {}

 private:
  static void change(Value& value, Label jump, Label by) {
    (jump > 0 ? value.up : value.down) += by * jump;
  }
  bool is_inside(Label w) const {
    if (rule_ == WindingRule::EvenOdd) return (w & 1) != 0;
    return rule_ == WindingRule::Positive ? w > 0 : w != 0;
  }
  bool are_all_inside(Label least, Label greatest) const;
  bool is_point(const SweepEvent& event) const {
    return std::any_of(event.points.begin(), event.points.end(),
                       [this](std::uint32_t p) { return is_point_[p] != 0; });
  }

  std::span<const SweepCurve> curves_;
  IdVector<SegmentId, std::int8_t> jump_;  // After start() the jump on the way upward.
  std::vector<std::uint8_t> is_point_;
  WindingRule rule_;
  Boundary boundary_;
  Label bottom_;
};

/// The curves of a bundle of at most two.
struct BundlePair {
  SegmentId first;
  SegmentId second;

  void join(SegmentId s) {
    PLUMB_CHECK(!second.is_valid());
    (first.is_valid() ? second : first) = s;
  }
  void leave(SegmentId s) {
    if (s == first) first = second;
    second = SegmentId();
  }
};

/// Where a curve of an overlay comes from. After start() the left side is the upper one.
struct OverlayCurve {
  std::uint32_t left;     ///< The face of the operand to the left.
  std::uint32_t right;    ///< The face of the operand to the right.
  EdgeId edge;            ///< The edge of the operand.
  std::uint32_t operand;  ///< The operand, 0 or 1.
};

/// Exchanges the sides of curves that the sweep runs the other way.
void turn_sides(std::span<const SweepCurve> given, const SweepCurves& turned,
                std::span<OverlayCurve> sides);

/// The label of a place in two subdivisions: a face of each.
using FacePair = std::array<std::uint32_t, 2>;

/// The base of the rules of overlays, which carries the pair of faces upward. Edges of one operand
/// do not overlap, so a bundle has at most one curve of each.
class OverlayLabels {
 public:
  using Label = FacePair;
  using Value = BundlePair;

  OverlayLabels(std::span<const SweepCurve> curves, std::vector<OverlayCurve> sides, Label bottom)
      : curves_(curves), sides_(std::move(sides)), bottom_(bottom) {}

  void start(const SweepCurves& curves) { turn_sides(curves_, curves, sides_); }
  Label bottom() const { return bottom_; }
  void begin_change() const {}
  void join(Value& value, SegmentId s) const { value.join(s); }
  void leave(Value& value, SegmentId s) const { value.leave(s); }
  Label above(Label below, const Value& value) const {
    for (const SegmentId s : {value.first, value.second}) {
      if (s.is_valid()) below[side(s).operand] = side(s).left;
    }
    return below;
  }
  Label below(Label above, const Value& value) const {
    for (const SegmentId s : {value.first, value.second}) {
      if (s.is_valid()) above[side(s).operand] = side(s).right;
    }
    return above;
  }

 protected:
  const OverlayCurve& side(SegmentId s) const { return sides_[s]; }

 private:
  std::span<const SweepCurve> curves_;
  IdVector<SegmentId, OverlayCurve> sides_;
  Label bottom_;
};

/// The marks of an operand. If there is a selector, only the marks of the cells that it accepts.
struct PlaneMarksView {
  std::span<const std::uint8_t> vertex;
  std::span<const std::uint8_t> edge;
  std::span<const std::uint8_t> face;
};

/// The rule of a Boolean: a function of the marks of both operands.
class BooleanRule : public OverlayLabels {
 public:
  static constexpr bool kKeepsAll = false;
  static constexpr bool kKeepsLabels = false;
  static constexpr std::uint32_t kNoVertex = 0xffffffff;
  static constexpr std::uint32_t kSecondOperand = std::uint32_t{1} << 31U;

  /// For each point of the scene, `vertex_at` contains the vertex of the first operand at this
  /// point, or the vertex of the second operand with kSecondOperand added, or kNoVertex.
  BooleanRule(OverlayLabels labels, std::array<PlaneMarksView, 2> marks, MarkFunction f,
              std::vector<std::uint32_t> vertex_at)
      : OverlayLabels(std::move(labels)),
        marks_(marks),
        function_(f),
        vertex_at_(std::move(vertex_at)) {}

  bool face_mark(Label l) const {
    return function_(marks_[0].face[l[0]] != 0, marks_[1].face[l[1]] != 0);
  }
  bool edge_mark(Label below, Label above, const Value& value) const;
  bool vertex_mark(const PlaneSurroundings<BooleanRule>& at) const;
  void keep_edge(const Value&) {}

 private:
  void mark_passing(const Value& value, std::array<bool, 2>& marks) const;

  std::array<PlaneMarksView, 2> marks_;
  MarkFunction function_;
  std::vector<std::uint32_t> vertex_at_;
};

/// The rule of the overlay of two maps: every piece is kept, and the pairs of regions are returned.
class MapOverlayRule : public OverlayLabels {
 public:
  static constexpr bool kKeepsAll = true;
  static constexpr bool kKeepsLabels = true;

  explicit MapOverlayRule(OverlayLabels labels) : OverlayLabels(std::move(labels)) {}

  bool face_mark(Label) const { return false; }
  bool edge_mark(Label, Label, const Value&) const { return false; }
  bool vertex_mark(const PlaneSurroundings<MapOverlayRule>&) const { return false; }
  void keep_edge(const Value&) {}
};

/// The rule of an arrangement: every piece is kept, with the curves that it is part of.
class OriginsRule {
 public:
  using Label = std::uint8_t;
  using Value = SegmentSets::Set;
  static constexpr bool kKeepsAll = true;
  static constexpr bool kKeepsLabels = false;

  /// `name` has for each curve its id in the sets; if it is empty, that is its number.
  OriginsRule(std::size_t curve_count, std::vector<SegmentId> name, Context& context)
      : sets(curve_count), name_(std::move(name)), memory_(context) {}

  void start(const SweepCurves&) {}
  Label bottom() const { return 0; }
  void begin_change() { sets.begin_change(); }
  void join(Value& value, SegmentId s) { value = charged(sets.with(value, name(s))); }
  void leave(Value& value, SegmentId s) { value = charged(sets.without(value, name(s))); }
  Label above(Label below, Value) const { return below; }
  Label below(Label above, Value) const { return above; }
  bool face_mark(Label) const { return false; }
  bool edge_mark(Label, Label, Value) const { return false; }
  bool vertex_mark(const PlaneSurroundings<OriginsRule>&) const { return false; }
  void keep_edge(Value value) { origins.push_back(value); }

  SegmentSets sets;
  std::vector<SegmentSets::Set> origins;  ///< The set of curves of each edge.

 private:
  SegmentId name(SegmentId s) const { return name_.empty() ? s : name_[s]; }
  Value charged(Value value) {
    if (sets.node_count() >= charged_ + kNodesPerCharge) {
      memory_.add((sets.node_count() - charged_) * SegmentSets::kBytesPerNode, "overlaps");
      charged_ = sets.node_count();
    }
    return value;
  }

  static constexpr std::size_t kNodesPerCharge = 4096;
  IdVector<SegmentId, SegmentId> name_;
  MemoryCharge memory_;
  std::size_t charged_ = 0;
};

static_assert(PlaneRule<WindingNumberRule> && PlaneRule<BooleanRule> && PlaneRule<MapOverlayRule> &&
              PlaneRule<OriginsRule>);

/// Sweeps the scene and returns the complex, into which `scene.points` is moved.
template <PlaneRule Rule>
PlaneComplex build_complex(SweepInput& scene, Rule& rule, Context& context,
                           std::vector<typename Rule::Label>* labels = nullptr) {
  PlaneBuilder<Rule> builder(scene, rule, context);
  sweep(scene.points, scene.curves, scene.stops, builder, context);
  return builder.build(std::move(scene.points), labels);
}

}  // namespace plumb
