// Joined complexes against their operands, and Booleans, selections and affine maps against the
// membership of points of a fine grid, which hits vertices, edges and faces of all operands.
#include "plumb/plane/set/boolean_op.h"

#include <gtest/gtest.h>

#include <array>
#include <vector>

#include "plumb/plane/nef2.h"
#include "plumb/predicates/error.h"
#include "plumb/testing/dice.h"

namespace plumb::boolean_op_test {

Boundary any_boundary(testing::Dice& dice) {
  return dice.below(2) == 0 ? Boundary::Open : Boundary::Closed;
}

/// A triangle, a segment, a half-plane, a ray, a line or a point; all corners on a grid.
Nef2 random_leaf(testing::Dice& dice) {
  std::vector<Point2> p(3);
  for (Point2& q : p) {
    q = {static_cast<double>(dice.between(0, 3)), static_cast<double>(dice.between(0, 3))};
  }
  const Line2 line{{Rational(p[0].x), Rational(p[0].y)}, {Rational(p[1].x), Rational(p[1].y)}};
  const std::uint32_t kind = dice.below(6);
  if (kind == 0 || p[0] == p[1]) return Nef2::point(line.a);
  if (kind == 1) return Nef2::polyline(p);
  if (kind == 2) return Nef2::half_plane(line, any_boundary(dice));
  if (kind == 3) return Nef2::ray(line, any_boundary(dice));
  if (kind == 4) return Nef2::line(line);
  return Nef2::polygon(p, any_boundary(dice));
}

Nef2 random_set(testing::Dice& dice) {
  const Nef2 set = (random_leaf(dice) ^ random_leaf(dice)) + random_leaf(dice);
  return dice.below(3) == 0 ? !set : set;
}

std::vector<RationalPoint2> grid() {
  std::vector<RationalPoint2> points;
  for (int x = -2; x <= 14; ++x) {
    for (int y = -2; y <= 14; ++y) points.push_back({Rational(x) / 4, Rational(y) / 4});
  }
  return points;
}

TEST(BooleanOp, JoinedPointsAreThoseOfTheOperands) {
  testing::Dice dice(1);
  for (int round = 0; round < 60; ++round) {
    const Nef2 a = random_set(dice), b = random_set(dice);
    const std::array<const PlaneComplex*, 2> complexes{&a.complex(), &b.complex()};
    const JoinedPoints joined = join_points(complexes);
    std::size_t inputs = 0, all = 0;
    ASSERT_EQ(joined.to.size(), 2U);
    for (std::size_t k = 0; k < 2; ++k) {
      const PlanePoints& points = complexes[k]->points;
      inputs += points.inputs.size();
      all += points.size();
      ASSERT_EQ(joined.to[k].size(), points.size());
      for (std::uint32_t i = 0; i < points.size(); ++i) {
        EXPECT_EQ(exact(joined.points, joined.to[k][i]), exact(points, i));
        EXPECT_EQ(joined.to[k][i] < joined.points.inputs.size(), i < points.inputs.size());
      }
    }
    EXPECT_EQ(joined.points.inputs.size(), inputs);
    EXPECT_EQ(joined.points.size(), all);
  }
}

TEST(BooleanOp, JoinedCurvesAreEdgesWithTheFacesBesideThem) {
  testing::Dice dice(2);
  for (int round = 0; round < 60; ++round) {
    const Nef2 a = random_set(dice), b = random_set(dice);
    const std::array<const PlaneComplex*, 2> complexes{&a.complex(), &b.complex()};
    const std::vector<std::vector<std::uint32_t>> to = join_points(complexes).to;
    const JoinedInput joined = join_inputs(complexes);
    std::vector<std::uint32_t> stops, vertex_at(joined.scene.points.size(), BooleanRule::kNoVertex);
    std::size_t curve = 0;
    for (std::uint32_t k = 0; k < 2; ++k) {
      const PlaneComplex& c = *complexes[k];
      for (std::uint32_t v = 0; v < c.vertex_count(); ++v) {
        const std::uint32_t at = to[k][c.vertex_point[v]];
        vertex_at[at] = k == 0 ? v : v + BooleanRule::kSecondOperand;
        if (c.dcel.is_isolated(VertexId(v))) stops.push_back(at);
      }
      for (std::uint32_t e = 0; e < c.edge_count(); ++e, ++curve) {
        ASSERT_LT(curve, joined.scene.curves.size());
        const HalfedgeId h(2 * e);
        const auto place = [&](VertexId v) {
          return c.is_at_infinity(v) ? SweepCurve::kUnbounded : to[k][c.vertex_point[v.value()]];
        };
        const SweepCurve& found = joined.scene.curves[curve];
        EXPECT_EQ(found.from, place(c.dcel.origin(h)));
        EXPECT_EQ(found.to, place(c.dcel.target(h)));
        EXPECT_TRUE(found.a == to[k][c.line[e].a] && found.b == to[k][c.line[e].b]);
        const OverlayCurve& side = joined.sides[curve];
        EXPECT_EQ(FaceId(side.left), c.dcel.face(h));
        EXPECT_EQ(FaceId(side.right), c.dcel.face(twin(h)));
        EXPECT_TRUE(side.edge == EdgeId(e) && side.operand == k);
      }
    }
    EXPECT_EQ(joined.scene.curves.size(), curve);
    EXPECT_EQ(joined.scene.stops, stops);
    EXPECT_EQ(joined.vertex_at, vertex_at);
  }
}

TEST(BooleanOp, ContainsWhatTheFunctionSays) {
  testing::Dice dice(3);
  const std::vector<RationalPoint2> points = grid();
  for (std::uint32_t bits = 0; bits < 16; ++bits) {
    const MarkFunction f{(bits & 1) != 0, (bits & 2) != 0, (bits & 4) != 0, (bits & 8) != 0};
    const Nef2 a = random_set(dice), b = random_set(dice);
    const Nef2 set = boolean_op(a, b, f);
    EXPECT_FALSE(set.audit().has_value());
    for (const RationalPoint2& p : points) {
      EXPECT_EQ(set.contains(p), f(a.contains(p), b.contains(p)));
    }
  }
}

TEST(BooleanOp, SelectedCellsAloneCountAsMarked) {
  testing::Dice dice(4);
  const std::vector<RationalPoint2> points = grid();
  for (int round = 0; round < 12; ++round) {
    const Nef2 a = random_set(dice), b = random_set(dice);
    const auto is_odd = [](auto id) { return id.value() % 2 == 1; };
    const PlaneSelector odd{is_odd, {}, is_odd}, no_edges{{}, [](EdgeId) { return false; }, {}};
    const Nef2 set = boolean_op(a, odd, b, no_edges, kSymmetricDifference);
    for (const RationalPoint2& p : points) {
      const PlaneLocation in_a = a.locate(p), in_b = b.locate(p);
      const bool is_even = (in_a.vertex.is_valid() && in_a.vertex.value() % 2 == 0) ||
                           (in_a.face.is_valid() && in_a.face.value() % 2 == 0);
      EXPECT_EQ(set.contains(p),
                (in_a.marked && !is_even) != (in_b.marked && !in_b.edge.is_valid()));
    }
  }
}

TEST(BooleanOp, UnionsAndIntersectionsOfMany) {
  testing::Dice dice(5);
  const std::vector<RationalPoint2> points = grid();
  for (std::size_t count = 0; count < 7; ++count) {
    std::vector<Nef2> sets;
    while (sets.size() < count) sets.push_back(random_set(dice));
    const Nef2 any = union_of(sets), all = intersection_of(sets);
    for (const RationalPoint2& p : points) {
      std::size_t in = 0;
      for (const Nef2& set : sets) in += set.contains(p) ? 1 : 0;
      EXPECT_EQ(any.contains(p), in > 0);
      EXPECT_EQ(all.contains(p), in == count);
    }
  }
}

/// Maps that turn, mirror, shear and exchange the axes: what was bottom or left comes to lie
/// anywhere.
TEST(BooleanOp, AffineMapsCarryPoints) {
  testing::Dice dice(6);
  const std::vector<RationalPoint2> points = grid();
  const auto right_of = [](int x, int y, int dx, int dy) {  // closed
    return Nef2::half_plane({{x + dx, y + dy}, {x, y}}, Boundary::Closed);
  };
  const Nef2 wedge = right_of(0, 0, 2, 1) * right_of(2, -1, -2, 1);
  const Nef2 strip = right_of(0, 2, 1, 0) * right_of(1, 1, -1, 0) * right_of(0, 0, 0, 1);
  for (int round = 0; round < 90; ++round) {
    const auto any = [&] { return Rational(dice.between(-2, 2)); };
    const AffineMap2 map{any(), any(), any(), any(), any(), any() / 3};
    const Nef2 set = round % 3 == 0 ? wedge : round % 3 == 1 ? strip : random_set(dice);
    if (map.xx * map.yy == map.xy * map.yx) {
      EXPECT_THROW((void)set.transformed(map), Error);
      continue;
    }
    const Nef2 image = set.transformed(map);
    EXPECT_FALSE(image.audit().has_value());
    for (const RationalPoint2& p : points) {
      const RationalPoint2 q{map.xx * p.x + map.xy * p.y + map.x0,
                             map.yx * p.x + map.yy * p.y + map.y0};
      EXPECT_EQ(image.contains(q), set.contains(p));
    }
  }
}

}  // namespace plumb::boolean_op_test
