// The trapezoids of arrangements of segments, rays and lines of a small grid, many of them
// vertical: every invariant of walls and neighbours, and areas that add up to those of the faces.
#include "plumb/plane/query/plane_trapezoids.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <set>
#include <vector>

#include "plane/random_complex.h"
#include "plumb/plane/plane_measure.h"
#include "plumb/testing/dice.h"

namespace plumb::plane_trapezoids_test {

using testing::random_complex;

namespace {

struct Scene {
  PlaneComplex complex;
  PlaneLocator locator{complex};
  PlaneTrapezoids trapezoids{complex, locator};

  explicit Scene(testing::Dice& dice) : complex(random_complex(dice)) {}
  Scene(const Scene&) = delete;
  Scene& operator=(const Scene&) = delete;

  VertexId left(EdgeId e) const { return complex.dcel.origin(first_half(e)); }
  VertexId right(EdgeId e) const { return complex.dcel.target(first_half(e)); }
  bool starts_at(EdgeId e, VertexId v) const { return e.is_valid() && left(e) == v; }
  bool ends_at(EdgeId e, VertexId v) const { return e.is_valid() && right(e) == v; }
  bool is_frame(VertexId v) const { return complex.is_at_infinity(v); }
  bool is_low(VertexId v) const { return is_frame(v) && trapezoids.is_low(v); }
  bool is_high(VertexId v) const { return is_frame(v) && !trapezoids.is_low(v); }
  bool is_upright(EdgeId e) const {
    const PlaneLine& l = complex.line[e.value()];
    return complex.points.inputs.approx(l.a).x == complex.points.inputs.approx(l.b).x;
  }
  Rational height(EdgeId e, const Rational& x) const {
    const PlaneLine& l = complex.line[e.value()];
    const RationalPoint2 a = complex.points.inputs.exact(l.a);
    const RationalPoint2 b = complex.points.inputs.exact(l.b);
    return a.y + (x - a.x) * (b.y - a.y) / (b.x - a.x);
  }
  Rational x_of(VertexId v) const {
    return exact(complex.points, complex.vertex_point[v.value()]).x;
  }
  /// The invalid edge, and then all.
  std::vector<EdgeId> edges() const {
    std::vector<EdgeId> all{EdgeId()};
    for (std::size_t e = 0; e < complex.edge_count(); ++e) all.emplace_back(e);
    return all;
  }
};

}  // namespace

TEST(PlaneTrapezoids, AreListedOnceAlongEachSide) {
  testing::Dice dice(1);
  for (int round = 0; round < 200; ++round) {
    const Scene s(dice);
    std::set<TrapezoidId> above, below;
    std::size_t expected = 1;  // then one more for each edge, and for each wall
    std::set<VertexId> walls;
    for (const EdgeId e : s.edges()) {
      for (const TrapezoidId t : s.trapezoids.above(e)) {
        EXPECT_EQ(s.trapezoids[t].bottom, e);
        EXPECT_TRUE(above.insert(t).second);
      }
      for (const TrapezoidId t : s.trapezoids.below(e)) {
        EXPECT_EQ(s.trapezoids[t].top, e);
        EXPECT_TRUE(below.insert(t).second);
      }
      if (!e.is_valid()) continue;
      ++expected;
      for (const VertexId v : {s.left(e), s.right(e)}) {
        if (!s.is_frame(v)) continue;
        EXPECT_EQ(s.trapezoids.vertical_edge(v), e);
        if (s.is_upright(e)) walls.insert(v);
        if (s.is_upright(e)) {
          EXPECT_EQ(s.is_low(v), v == s.left(e));
        }
      }
    }
    expected += walls.size() + s.complex.vertex_count();
    EXPECT_EQ(above.size(), expected);
    EXPECT_EQ(above, below);
  }
}

TEST(PlaneTrapezoids, FollowEachOtherAlongEdges) {
  testing::Dice dice(2);
  for (int round = 0; round < 200; ++round) {
    const Scene s(dice);
    for (const EdgeId e : s.edges()) {
      // The walls at the ends; there are none at infinity but of vertical edges.
      const auto wall = [&](bool at_left) {
        if (!e.is_valid()) return VertexId();
        const VertexId v = at_left ? s.left(e) : s.right(e);
        return s.is_frame(v) && !s.is_upright(e) ? VertexId() : v;
      };
      for (const auto& list : {s.trapezoids.above(e), s.trapezoids.below(e)}) {
        ASSERT_FALSE(list.empty());
        EXPECT_EQ(s.trapezoids[list.front()].left, wall(true));
        EXPECT_EQ(s.trapezoids[list.back()].right, wall(false));
        for (std::size_t i = 0; i + 1 < list.size(); ++i) {
          EXPECT_TRUE(s.trapezoids[list[i]].right.is_valid());
          EXPECT_EQ(s.trapezoids[list[i]].right, s.trapezoids[list[i + 1]].left);
        }
      }
    }
  }
}

/// Parts of walls join what has one bottom, or one top, and are there unless an edge ends at the
/// wall's vertex or the wall goes one way only.
TEST(PlaneTrapezoids, KnowTheirNeighboursBehindWalls) {
  testing::Dice dice(3);
  for (int round = 0; round < 200; ++round) {
    const Scene s(dice);
    for (const EdgeId e : s.edges()) {
      for (const TrapezoidId id : s.trapezoids.above(e)) {
        const PlaneTrapezoid& t = s.trapezoids[id];
        const VertexId l = t.left, r = t.right;
        EXPECT_EQ(t.left_lower.is_valid(),
                  l.is_valid() && !s.is_low(l) && !s.starts_at(t.bottom, l));
        EXPECT_EQ(t.left_upper.is_valid(), l.is_valid() && !s.is_high(l) && !s.starts_at(t.top, l));
        EXPECT_EQ(t.right_lower.is_valid(),
                  r.is_valid() && !s.is_low(r) && !s.ends_at(t.bottom, r));
        EXPECT_EQ(t.right_upper.is_valid(), r.is_valid() && !s.is_high(r) && !s.ends_at(t.top, r));
        if (t.right_lower.is_valid()) {
          const PlaneTrapezoid& n = s.trapezoids[t.right_lower];
          EXPECT_TRUE(n.left_lower == id && n.left == r && n.bottom == t.bottom);
        }
        if (t.right_upper.is_valid()) {
          const PlaneTrapezoid& n = s.trapezoids[t.right_upper];
          EXPECT_TRUE(n.left_upper == id && n.left == r && n.top == t.top);
        }
      }
    }
  }
}

TEST(PlaneTrapezoids, FillTheirFaces) {
  testing::Dice dice(4);
  for (int round = 0; round < 100; ++round) {
    const Scene s(dice);
    std::vector<Rational> area(s.complex.face_count());
    for (const EdgeId e : s.edges()) {
      if (!e.is_valid()) continue;
      const FaceId f = s.complex.dcel.face(first_half(e));
      for (const TrapezoidId id : s.trapezoids.above(e)) {
        const PlaneTrapezoid& t = s.trapezoids[id];
        if (t.top.is_valid()) {
          EXPECT_EQ(s.complex.dcel.face(twin(first_half(t.top))), f);
        }
        if (is_unbounded(s.complex, f)) continue;
        ASSERT_TRUE(t.top.is_valid() && t.left.is_valid() && t.right.is_valid());
        const Rational from = s.x_of(t.left), to = s.x_of(t.right);
        EXPECT_LE(from, to);
        if (from == to) continue;
        const Rational left = s.height(t.top, from) - s.height(e, from);
        const Rational right = s.height(t.top, to) - s.height(e, to);
        EXPECT_TRUE(left >= 0 && right >= 0 && left + right > 0);
        area[f.value()] += (to - from) * (left + right) / 2;
      }
    }
    for (std::size_t f = 0; f < area.size(); ++f) {
      const auto expected = face_area(s.complex, FaceId(f));
      if (expected) {
        EXPECT_EQ(area[f], *expected);
      }
    }
  }
}

TEST(PlaneTrapezoids, AreFoundBetweenTheEdgesOfAVertex) {
  testing::Dice dice(5);
  for (int round = 0; round < 200; ++round) {
    const Scene s(dice);
    for (std::size_t i = 0; i < s.complex.vertex_count(); ++i) {
      const VertexId v(i);
      for (const bool is_right : {true, false}) {
        const auto list = is_right ? s.trapezoids.outgoing(v) : s.trapezoids.incoming(v);
        std::set<EdgeId> expected;
        for (const EdgeId e : s.edges()) {
          if (e.is_valid() && (is_right ? s.left(e) : s.right(e)) == v) expected.insert(e);
        }
        EXPECT_EQ(std::set<EdgeId>(list.begin(), list.end()), expected);
        ASSERT_EQ(list.size(), expected.size());
        for (std::size_t k = 0; k + 1 < list.size(); ++k) {  // bottom to top
          const PlaneLine &a = s.complex.line[list[k].value()],
                          &b = s.complex.line[list[k + 1].value()];
          EXPECT_EQ(cross_sign(s.complex.points.inputs, a.a, a.b, b.a, b.b),
                    is_right ? Sign::Positive : Sign::Negative);
        }
        for (std::size_t k = 0; k <= list.size(); ++k) {
          const PlaneTrapezoid& t =
              s.trapezoids[is_right ? s.trapezoids.right_of(v, k) : s.trapezoids.left_of(v, k)];
          EXPECT_EQ(is_right ? t.left : t.right, v);
          if (k > 0) {
            EXPECT_EQ(t.bottom, list[k - 1]);
          }
          if (k < list.size()) {
            EXPECT_EQ(t.top, list[k]);
          }
        }
      }
    }
  }
}

}  // namespace plumb::plane_trapezoids_test
