// What labels and marks mean: the rules that PlaneBuilder is run with.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "plumb/plane/nef2.h"
#include "plumb/plane/plane_builder.h"

namespace plumb {

/// Polygons by winding number. A label is the winding number of a face.
class WindingNumberRule {
 public:
  using Label = std::int32_t;
  static constexpr bool kKeepsAll = false;
  static constexpr bool kKeepsLabels = false;

  /// `jump` per curve: how much the winding number rises from the right side to the left one, seen
  /// along the curve as given: 1, -1, or 0 for a slit. `is_point` per input point: a chain of its
  /// own, which a closed set contains whatever lies around it.
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
  Label above(Label below, SweepBundle bundle) const {
    for (const SweepIncidence& i : bundle) below += jump_[i.segment.value()];
    return below;
  }
  Label below(Label above, SweepBundle bundle) const {
    for (const SweepIncidence& i : bundle) above -= jump_[i.segment.value()];
    return above;
  }
  bool face_mark(Label winding) const { return is_inside(winding); }
  bool edge_mark(Label below, Label above, SweepBundle bundle) const;
  bool vertex_mark(const PlaneSurroundings<Label>& at) const {
    return boundary_ == Boundary::Open ? at.all_marked : at.any_marked || is_point(at.event);
  }
  void keep_edge(SweepBundle) {}

 private:
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
  std::vector<std::int8_t> jump_;  // after start(): upward
  std::vector<std::uint8_t> is_point_;
  WindingRule rule_;
  Boundary boundary_;
  Label bottom_;
};

/// Where a curve of an overlay comes from. Faces are those of its operand; after start() left is
/// above.
struct OverlayCurve {
  std::uint32_t left;
  std::uint32_t right;
  EdgeId edge;
  std::uint32_t operand;  ///< 0 or 1
};

/// Turns the sides of curves that the sweep runs the other way.
void turn_sides(std::span<const SweepCurve> given, const SweepCurves& turned,
                std::span<OverlayCurve> sides);

/// The label of a place in two subdivisions: a face of each.
using FacePair = std::array<std::uint32_t, 2>;

/// Carries the pair of faces. Base of the rules of overlays.
class OverlayLabels {
 public:
  using Label = FacePair;

  OverlayLabels(std::span<const SweepCurve> curves, std::vector<OverlayCurve> sides, Label bottom)
      : curves_(curves), sides_(std::move(sides)), bottom_(bottom) {}

  void start(const SweepCurves& curves) { turn_sides(curves_, curves, sides_); }
  Label bottom() const { return bottom_; }
  Label above(Label below, SweepBundle bundle) const {
    for (const SweepIncidence& i : bundle) below[side(i).operand] = side(i).left;
    return below;
  }
  Label below(Label above, SweepBundle bundle) const {
    for (const SweepIncidence& i : bundle) above[side(i).operand] = side(i).right;
    return above;
  }

 protected:
  const OverlayCurve& side(const SweepIncidence& i) const { return sides_[i.segment.value()]; }

 private:
  std::span<const SweepCurve> curves_;
  std::vector<OverlayCurve> sides_;
  Label bottom_;
};

/// Marks of an operand, or those of them that a selector lets through.
struct PlaneMarksView {
  std::span<const std::uint8_t> vertex;
  std::span<const std::uint8_t> edge;
  std::span<const std::uint8_t> face;
};

/// A Boolean: the marks of both operands through a function.
class BooleanRule : public OverlayLabels {
 public:
  static constexpr bool kKeepsAll = false;
  static constexpr bool kKeepsLabels = false;
  static constexpr std::uint32_t kNoVertex = 0xffffffff;
  static constexpr std::uint32_t kSecondOperand = std::uint32_t{1} << 31U;

  /// `vertex_at` per point of the scene: vertex of the first operand, of the second with
  /// kSecondOperand set, or kNoVertex.
  BooleanRule(OverlayLabels labels, std::array<PlaneMarksView, 2> marks, MarkFunction f,
              std::vector<std::uint32_t> vertex_at)
      : OverlayLabels(std::move(labels)),
        marks_(marks),
        function_(f),
        vertex_at_(std::move(vertex_at)) {}

  bool face_mark(Label l) const {
    return function_(marks_[0].face[l[0]] != 0, marks_[1].face[l[1]] != 0);
  }
  bool edge_mark(Label below, Label above, SweepBundle bundle) const;
  bool vertex_mark(const PlaneSurroundings<Label>& at) const;
  void keep_edge(SweepBundle) {}

 private:
  void mark_passing(std::span<const SweepIncidence> curves, std::array<bool, 2>& marks) const;

  std::array<PlaneMarksView, 2> marks_;
  MarkFunction function_;
  std::vector<std::uint32_t> vertex_at_;
};

/// Two maps: every piece is kept, and the pairs of regions are asked for.
class MapOverlayRule : public OverlayLabels {
 public:
  static constexpr bool kKeepsAll = true;
  static constexpr bool kKeepsLabels = true;

  explicit MapOverlayRule(OverlayLabels labels) : OverlayLabels(std::move(labels)) {}

  bool face_mark(Label) const { return false; }
  bool edge_mark(Label, Label, SweepBundle) const { return false; }
  bool vertex_mark(const PlaneSurroundings<Label>&) const { return false; }
  void keep_edge(SweepBundle) {}
};

/// An arrangement: every piece is kept, with the curves it came from.
class OriginsRule {
 public:
  using Label = std::uint8_t;
  static constexpr bool kKeepsAll = true;
  static constexpr bool kKeepsLabels = false;

  void start(const SweepCurves&) {}
  Label bottom() const { return 0; }
  Label above(Label below, SweepBundle) const { return below; }
  Label below(Label above, SweepBundle) const { return above; }
  bool face_mark(Label) const { return false; }
  bool edge_mark(Label, Label, SweepBundle) const { return false; }
  bool vertex_mark(const PlaneSurroundings<Label>&) const { return false; }
  void keep_edge(SweepBundle bundle) {
    for (const SweepIncidence& i : bundle) origins.push_back(i.segment);
    origin_begin.push_back(static_cast<std::uint32_t>(origins.size()));
  }

  std::vector<std::uint32_t> origin_begin = {0};
  std::vector<SegmentId> origins;
};

/// Sweeps the scene and builds the complex. `scene.points` is moved into it.
template <class Rule>
PlaneComplex build_complex(PlaneScene& scene, Rule& rule, Context& context,
                           std::vector<typename Rule::Label>* labels = nullptr) {
  PlaneBuilder<Rule> builder(scene, rule, context);
  sweep(scene.points, scene.curves, scene.stops, builder, context);
  return builder.build(std::move(scene.points), labels);
}

}  // namespace plumb
