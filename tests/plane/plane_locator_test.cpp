// Point location in arrangements of segments, rays and lines of a small grid, many of them vertical
// or concurrent, against all vertices, all edges, and the highest edge below in rationals.
#include "plumb/plane/query/plane_locator.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "plane/random_complex.h"
#include "plumb/plane/arrangement.h"
#include "plumb/testing/dice.h"

namespace plumb::plane_locator_test {

constexpr std::uint32_t kNoEnd = SweepCurve::kUnbounded;

using testing::random_complex;

/// The complex in rationals.
class Cells {
 public:
  explicit Cells(const PlaneComplex& complex) : c_(complex) {
    for (const std::uint32_t p : c_.vertex_point) vertex_.push_back(exact(c_.points, p));
    for (std::size_t e = 0; e < c_.edge_count(); ++e) {
      const HalfedgeId h = first_half(EdgeId(e));
      edge_.push_back({c_.points.inputs.exact(c_.line[e].a), c_.points.inputs.exact(c_.line[e].b),
                       place(c_.dcel.origin(h)), place(c_.dcel.target(h))});
    }
  }
  const std::vector<RationalPoint2>& vertices() const { return vertex_; }
  std::optional<RationalPoint2> place(VertexId v) const {
    if (c_.is_at_infinity(v)) return std::nullopt;
    return vertex_[v.value()];
  }

  PlaneLocation locate(const RationalPoint2& q) const {
    for (std::size_t v = 0; v < vertex_.size(); ++v) {
      if (vertex_[v] == q) return {VertexId(v), {}, {}, c_.mark(VertexId(v))};
    }
    for (std::size_t e = 0; e < edge_.size(); ++e) {
      const Edge& at = edge_[e];
      if (side(at, q) != 0 || (at.from && !less(*at.from, q)) || (at.to && !less(q, *at.to))) {
        continue;
      }
      return {{}, EdgeId(e), {}, c_.mark(EdgeId(e))};
    }
    const EdgeId below = edge_below(q);
    FaceId f(0);
    if (below.is_valid()) {
      f = c_.dcel.face(first_half(below));
    } else if (const EdgeId e = last_upright(q); e.is_valid()) {
      f = c_.dcel.face(twin(first_half(e)));
    }
    return {{}, {}, f, c_.mark(f)};
  }

  /// The highest edge below a place a little right of q, but for those that begin in `ignored`.
  EdgeId edge_below(const RationalPoint2& q, VertexId ignored = VertexId()) const {
    const RationalPoint2 near{q.x + Rational(1) / 1000000, q.y};
    EdgeId best;
    Rational height;
    for (std::size_t e = 0; e < edge_.size(); ++e) {
      const Edge& at = edge_[e];
      if (at.a.x == at.b.x || (at.from && at.from->x > near.x) || (at.to && at.to->x < near.x)) {
        continue;
      }
      if (ignored.is_valid() && c_.dcel.origin(first_half(EdgeId(e))) == ignored) continue;
      const Rational y = at.a.y + (near.x - at.a.x) * (at.b.y - at.a.y) / (at.b.x - at.a.x);
      if (y >= near.y || (best.is_valid() && y <= height)) continue;
      best = EdgeId(e);
      height = y;
    }
    return best;
  }

 private:
  struct Edge {
    RationalPoint2 a, b;
    std::optional<RationalPoint2> from, to;
  };
  static bool less(const RationalPoint2& p, const RationalPoint2& q) {
    return p.x != q.x ? p.x < q.x : p.y < q.y;
  }
  static Rational side(const Edge& e, const RationalPoint2& q) {
    return (e.b.x - e.a.x) * (q.y - e.a.y) - (e.b.y - e.a.y) * (q.x - e.a.x);
  }
  /// The last vertical edge from infinity below that is not right of q.
  EdgeId last_upright(const RationalPoint2& q) const {
    EdgeId last;
    for (std::size_t e = 0; e < edge_.size(); ++e) {
      if (edge_[e].a.x != edge_[e].b.x || edge_[e].from || edge_[e].a.x > q.x) continue;
      if (!last.is_valid() || edge_[e].a.x > edge_[last.value()].a.x) last = EdgeId(e);
    }
    return last;
  }

  const PlaneComplex& c_;
  std::vector<RationalPoint2> vertex_;
  std::vector<Edge> edge_;
};

TEST(PlaneLocator, FindsWhatAllCellsSay) {
  testing::Dice dice(1);
  for (int round = 0; round < 60; ++round) {
    const PlaneComplex complex = random_complex(dice);
    const Cells cells(complex);
    const PlaneLocator locator(complex);
    std::vector<RationalPoint2> places = cells.vertices();
    for (const RationalPoint2& p : cells.vertices()) {  // on the columns of vertices
      places.push_back({p.x, Rational(dice.between(-3, 12)) / 3});
    }
    for (std::size_t i = 0; i + 1 < cells.vertices().size(); ++i) {
      const RationalPoint2 &p = cells.vertices()[i], &q = cells.vertices()[i + 1];
      places.push_back({(p.x + q.x) / 2, (p.y + q.y) / 2});
    }
    for (int i = 0; i < 20; ++i) {
      places.push_back({Rational(dice.between(-2, 8)) / 2, Rational(dice.between(-3, 12)) / 3});
    }
    for (const RationalPoint2& q : places) {
      const PlaneLocation expected = cells.locate(q);
      EXPECT_TRUE(locator.locate(q) == expected) << q.x.str() << ' ' << q.y.str();
      if (!expected.face.is_valid()) continue;
      EXPECT_EQ(locator.edge_below(QueryPoint2(q)), cells.edge_below(q));
    }
  }
}

TEST(PlaneLocator, FindsWhatIsBelowAVertex) {
  testing::Dice dice(2);
  int found = 0;
  for (int round = 0; round < 150; ++round) {
    const PlaneComplex complex = random_complex(dice);
    const Cells cells(complex);
    const PlaneLocator locator(complex);
    for (std::size_t i = 0; i < complex.vertex_count(); ++i) {
      const VertexId v(i);
      bool has_left = false;
      if (!complex.dcel.is_isolated(v)) {
        for (const HalfedgeId h : complex.dcel.around(v)) has_left |= (h.value() & 1U) != 0;
      }
      if (has_left) continue;
      const EdgeId expected = cells.edge_below(cells.vertices()[i], v);
      EXPECT_EQ(locator.edge_below(v), expected);
      found += expected.is_valid() ? 1 : 0;
    }
  }
  EXPECT_GT(found, 20);
}

/// Nothing but upright lines: faces are strips, and columns have no vertices.
TEST(PlaneLocator, TellsStripsApart) {
  PlanePoints points;
  std::vector<SweepCurve> curves;
  for (const int x : {4, 0, 2}) {
    const auto n = static_cast<std::uint32_t>(points.size());
    points.inputs.push_back(Point2{static_cast<double>(x), 0});
    points.inputs.push_back(Point2{static_cast<double>(x), 1});
    curves.push_back({kNoEnd, kNoEnd, n, n + 1});
  }
  const PlaneComplex complex = arrange(points, curves, {}).complex;
  const Cells cells(complex);
  const PlaneLocator locator(complex);
  std::vector<FaceId> strips;
  for (int x = -1; x <= 5; ++x) {
    const PlaneLocation found = locator.locate(Point2{static_cast<double>(x), 7});
    EXPECT_TRUE(found == cells.locate({x, 7}));
    EXPECT_EQ(found.edge.is_valid(), x == 0 || x == 2 || x == 4);
    if (found.face.is_valid()) strips.push_back(found.face);
  }
  std::ranges::sort(strips);
  EXPECT_EQ(strips, (std::vector<FaceId>{FaceId(0), FaceId(1), FaceId(2), FaceId(3)}));
}

}  // namespace plumb::plane_locator_test
