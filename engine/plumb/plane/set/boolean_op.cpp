// Booleans and affine maps of sets of the plane.
//
// The edges of both operands become curves of one scene, and one sweep builds the minimal complex
// of the result: BooleanRule carries the pair of faces upward and applies the function to their
// marks (docs/design/sweep.md, Lemmas 2 and 3). Crossings keep the lines of input points that
// define them, so a Boolean of results needs no larger numbers than a Boolean of inputs.
//
// An affine map moves the input points and sweeps again, as the order of everything may change. The
// face at the bottom, from which labels start, is then found from the mapped unbounded curves.
//
// Tested by tests/plane/nef2_test.cpp, tests/plane/nef2_property_test.cpp and
// tests/plane/overlay_cases_test.cpp.

#include "plumb/plane/set/boolean_op.h"

#include <array>
#include <utility>

#include "plumb/plane/nef2.h"
#include "plumb/predicates/error.h"

namespace plumb {
namespace {

/// Appends crossings. The input points of their lines get new indices.
void append_crossings(const PlanePoints& from, const std::vector<std::uint32_t>& to,
                      PlanePoints& points) {
  for (Crossing2 c : from.crossings) {
    c.a = to[c.a];
    c.b = to[c.b];
    c.c = to[c.c];
    c.d = to[c.d];
    points.crossings.push_back(c);
  }
}

/// Appends the edges of a complex as curves, and notes its vertices.
void append_complex(const PlaneComplex& complex, const std::vector<std::uint32_t>& to,
                    std::uint32_t operand, JoinedInput& joined) {
  const std::uint32_t flag = operand == 0 ? 0 : BooleanRule::kSecondOperand;
  const auto point = [&](VertexId v) {
    return complex.is_at_infinity(v) ? SweepCurve::kUnbounded : to[complex.vertex_point[v]];
  };
  for (std::uint32_t i = 0; i < complex.vertex_count(); ++i) {
    const VertexId v(i);
    joined.vertex_at[point(v)] = i | flag;
    if (complex.dcel.is_isolated(v)) joined.scene.stops.push_back(point(v));
  }
  for (std::size_t i = 0; i < complex.edge_count(); ++i) {
    const HalfedgeId h = first_half(EdgeId(i));
    const PlaneLine& line = complex.line[i];
    joined.scene.curves.push_back(
        {point(complex.dcel.origin(h)), point(complex.dcel.target(h)), to[line.a], to[line.b]});
    joined.sides.push_back(
        {complex.dcel.face(h).value(), complex.dcel.face(twin(h)).value(), EdgeId(i), operand});
  }
}

}  // namespace

JoinedPoints join_points(std::span<const PlaneComplex* const> complexes) {
  JoinedPoints joined;
  joined.to.resize(complexes.size());
  for (std::size_t k = 0; k < complexes.size(); ++k) {
    const PointTable2& inputs = complexes[k]->points.inputs;
    for (std::size_t i = 0; i < inputs.size(); ++i) {
      joined.to[k].push_back(static_cast<std::uint32_t>(joined.points.inputs.size() + i));
    }
    joined.points.inputs.append(inputs);
  }
  for (std::size_t k = 0; k < complexes.size(); ++k) {
    const PlanePoints& points = complexes[k]->points;
    const std::size_t first = joined.points.size();
    for (std::size_t i = 0; i < points.crossings.size(); ++i) {
      joined.to[k].push_back(static_cast<std::uint32_t>(first + i));
    }
    append_crossings(points, joined.to[k], joined.points);
  }
  return joined;
}

JoinedInput join_inputs(std::span<const PlaneComplex* const> complexes) {
  JoinedPoints points = join_points(complexes);
  JoinedInput joined;
  joined.vertex_at.assign(points.points.size(), BooleanRule::kNoVertex);
  std::size_t edges = 0;
  for (const PlaneComplex* c : complexes) edges += c->edge_count();
  joined.scene.curves.reserve(edges);
  joined.sides.reserve(edges);
  for (std::size_t k = 0; k < complexes.size(); ++k) {
    append_complex(*complexes[k], points.to[k], static_cast<std::uint32_t>(k), joined);
  }
  joined.scene.points = std::move(points.points);
  return joined;
}

// Nef2: operations of several sets, and affine maps.

namespace {

PlaneMarksView view(const PlaneMarks& marks) { return {marks.vertex, marks.edge, marks.face}; }

/// Sweeps the scene and returns the set. `bottom` is the pair of faces at (-infinity, -infinity).
Nef2 build(JoinedInput joined, std::array<PlaneMarksView, 2> marks, MarkFunction f, FacePair bottom,
           Context& context) {
  BooleanRule rule(OverlayLabels(joined.scene.curves, std::move(joined.sides), bottom), marks, f,
                   std::move(joined.vertex_at));
  return Nef2::from_minimal_unchecked(build_complex(joined.scene, rule, context));
}

template <class Id>
void select(const std::function<bool(Id)>& accepts, std::vector<std::uint8_t>& marks) {
  if (!accepts) return;
  for (std::size_t i = 0; i < marks.size(); ++i) {
    if (marks[i] != 0 && !accepts(Id(i))) marks[i] = 0;
  }
}

/// Returns the marks of the cells that a selector accepts. All other cells count as not marked.
PlaneMarks selected(const Nef2& set, const PlaneSelector& selector) {
  PlaneMarks marks = set.complex().marks;
  select(selector.vertex, marks.vertex);
  select(selector.edge, marks.edge);
  select(selector.face, marks.face);
  return marks;
}

Nef2 combine_marked(const Nef2& a, const PlaneMarks& marks_a, const Nef2& b,
                    const PlaneMarks& marks_b, MarkFunction f, Context& context) {
  const std::array<const PlaneComplex*, 2> complexes = {&a.complex(), &b.complex()};
  JoinedInput joined = join_inputs(complexes);
  context.checkpoint("sweep", 0, 0);
  return build(std::move(joined), {view(marks_a), view(marks_b)}, f, {0, 0}, context);
}

/// Combines the sets in a balanced tree. Requires at least one.
Nef2 fold(std::span<const Nef2> sets, MarkFunction f, Context& context) {
  if (sets.size() == 1) return sets.front();
  const std::size_t half = sets.size() / 2;
  return boolean_op(fold(sets.first(half), f, context), fold(sets.subspan(half), f, context), f,
                    context);
}

// ---------------------------------------------------------------- affine maps

RationalPoint2 apply(const AffineMap2& m, const RationalPoint2& p) {
  return {m.xx * p.x + m.xy * p.y + m.x0, m.yx * p.x + m.yy * p.y + m.y0};
}

/// Maps the input points. Crossings keep their lines, and get new boxes.
PlanePoints mapped_points(const PlanePoints& points, const AffineMap2& map, Context& context) {
  constexpr std::size_t kPointsPerCheckpoint = 1024;
  PlanePoints mapped;
  std::size_t done = 0;
  const auto watch = [&] {
    if (done++ % kPointsPerCheckpoint == 0) {
      context.checkpoint("map points", done, points.inputs.size() + points.crossings.size());
    }
  };
  for (std::uint32_t i = 0; i < points.inputs.size(); ++i) {
    watch();
    const RationalPoint2 p = apply(map, points.inputs.exact(i));
    mapped.inputs.push_back(p.x, p.y);
  }
  for (const Crossing2& c : points.crossings) {
    watch();
    mapped.crossings.push_back(make_crossing(mapped.inputs, c.a, c.b, c.c, c.d));
  }
  return mapped;
}

// Finds the face that reaches down to (-infinity, -infinity) from the unbounded curves. It is to
// the right of the lowest curve from the left. If there is none, it is to the left of the first
// vertical curve from below; otherwise to the right of the lowest curve to the right; otherwise to
// the left of the first vertical curve upward.
class BottomFace {
 public:
  explicit BottomFace(const JoinedInput& joined)
      : sides_(joined.sides), curves_(joined.scene.points, joined.scene.curves, {}) {
    turn_sides(joined.scene.curves, curves_, sides_);
  }

  std::uint32_t find() const {
    std::uint32_t best_kind = 4;
    SegmentId best;
    for (std::size_t i = 0; i < sides_.size(); ++i) {
      const SegmentId s(i);
      const std::uint32_t k = kind(s);
      if (k < best_kind || (k < 4 && k == best_kind && precedes(s, best, k))) {
        best_kind = k;
        best = s;
      }
    }
    if (!best.is_valid()) return 0;
    const OverlayCurve& side = sides_[best];
    return best_kind % 2 == 0 ? side.right : side.left;
  }

 private:
  std::uint32_t kind(SegmentId s) const {
    const auto& c = curves_[s];
    if (c.has_left() && c.has_right()) return 4;
    const std::uint32_t vertical = curves_.is_vertical(s) ? 1 : 0;
    return (c.has_left() ? 2 : 0) + vertical;
  }
  bool precedes(SegmentId s, SegmentId t, std::uint32_t kind) const {
    if (kind % 2 == 1) {
      return compare_x(curves_.points(), curves_[s].a, curves_[t].a) == Sign::Negative;
    }
    const Sign left = curves_.order_at_left_infinity(s, t);
    if (kind == 0) return left == Sign::Positive;
    const Sign steeper = curves_.direction_order(s, t);
    return (steeper != Sign::Zero ? steeper : left) == Sign::Positive;
  }

  IdVector<SegmentId, OverlayCurve> sides_;
  SweepCurves curves_;
};

}  // namespace

Nef2 boolean_op(const Nef2& a, const Nef2& b, MarkFunction f, Context& context) {
  return combine_marked(a, a.complex().marks, b, b.complex().marks, f, context);
}

Nef2 boolean_op(const Nef2& a, const PlaneSelector& select_a, const Nef2& b,
                const PlaneSelector& select_b, MarkFunction f, Context& context) {
  return combine_marked(a, selected(a, select_a), b, selected(b, select_b), f, context);
}

Nef2 union_of(std::span<const Nef2> sets, Context& context) {
  return sets.empty() ? Nef2::empty() : fold(sets, kUnion, context);
}

Nef2 intersection_of(std::span<const Nef2> sets, Context& context) {
  return sets.empty() ? Nef2::whole() : fold(sets, kIntersection, context);
}

Nef2 difference_of(const Nef2& a, std::span<const Nef2> others, Context& context) {
  return boolean_op(a, union_of(others, context), kDifference, context);
}

Nef2 operator+(const Nef2& a, const Nef2& b) { return boolean_op(a, b, kUnion); }
Nef2 operator*(const Nef2& a, const Nef2& b) { return boolean_op(a, b, kIntersection); }
Nef2 operator-(const Nef2& a, const Nef2& b) { return boolean_op(a, b, kDifference); }
Nef2 operator^(const Nef2& a, const Nef2& b) { return boolean_op(a, b, kSymmetricDifference); }

Nef2 Nef2::transformed(const AffineMap2& map, Context& context) const {
  const Rational determinant = map.xx * map.yy - map.xy * map.yx;
  if (determinant == 0) {
    throw Error(ErrorCode::BadArgument, "the affine map has determinant 0: it has no inverse");
  }
  const std::array<const PlaneComplex*, 1> complexes = {&complex()};
  JoinedInput joined = join_inputs(complexes);
  joined.scene.points = mapped_points(joined.scene.points, map, context);
  if (determinant < 0) {
    for (OverlayCurve& side : joined.sides) std::swap(side.left, side.right);
  }
  const FacePair bottom = {BottomFace(joined).find(), 0};
  const PlaneMarksView marks = view(complex().marks);
  return build(std::move(joined), {marks, marks}, MarkFunction{false, true, false, true}, bottom,
               context);
}

}  // namespace plumb
