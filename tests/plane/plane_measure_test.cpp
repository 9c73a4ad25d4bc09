// Areas and rings of faces against counting the cells of a grid, against sums over the corners of
// rings, and against what holds of the areas of all sets.
#include "plumb/plane/plane_measure.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <vector>

#include "plumb/plane/nef2.h"
#include "plumb/testing/dice.h"

namespace plumb::plane_measure_test {

constexpr int kSide = 5;

/// About half of the cells of a grid, minus some slits and points: faces touch themselves in
/// vertices, have holes, and have edges with themselves on both sides.
Nef2 random_cells(testing::Dice& dice, std::vector<bool>& is_chosen) {
  PointTable2 points;
  std::vector<std::uint32_t> corners, begin{0};
  is_chosen.assign(kSide * kSide, false);
  const auto add = [&](double x, double y) {
    corners.push_back(static_cast<std::uint32_t>(points.size()));
    points.push_back(Point2{x, y});
  };
  for (int i = 0; i < kSide * kSide; ++i) {
    if (dice.below(2) == 0) continue;
    is_chosen[static_cast<std::size_t>(i)] = true;
    const double x = i % kSide, y = i / kSide;
    for (const Point2 p : {Point2{x, y}, {x + 1, y}, {x + 1, y + 1}, {x, y + 1}}) add(p.x, p.y);
    begin.push_back(static_cast<std::uint32_t>(corners.size()));
  }
  Nef2 set = Nef2::polygons(points, corners, begin, WindingRule::NonZero, Boundary::Closed);
  for (int i = 0; i < 3; ++i) {
    const auto any = [&] { return static_cast<double>(dice.between(0, 4 * kSide)) / 4; };
    const std::vector<Point2> slit{{any(), any()}, {any(), any()}};
    set = (set - Nef2::polyline(slit)) ^ Nef2::point({Rational(any()), Rational(any())});
  }
  return set;
}

std::size_t as_index(VertexId v) { return v.value(); }

/// Twice the signed area of a ring.
Rational shoelace(const PlaneComplex& c, const std::vector<VertexId>& ring) {
  Rational twice = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const RationalPoint2 p = exact(c.points, c.vertex_point[as_index(ring[i])]);
    const RationalPoint2 q = exact(c.points, c.vertex_point[as_index(ring[(i + 1) % ring.size()])]);
    twice += p.x * q.y - p.y * q.x;
  }
  return twice;
}

TEST(PlaneMeasure, AreasOfFacesAreThoseOfTheirCells) {
  testing::Dice dice(1);
  for (int round = 0; round < 40; ++round) {
    std::vector<bool> is_chosen;
    const Nef2 set = random_cells(dice, is_chosen);
    const PlaneComplex& c = set.complex();
    EXPECT_EQ(marked_area(c), Rational(std::ranges::count(is_chosen, true)));
    Rational marked = 0, bounded = 0;
    for (std::size_t f = 0; f < c.face_count(); ++f) {
      const auto area = face_area(c, FaceId(f));
      ASSERT_EQ(area.has_value(), f != 0);
      if (!area) continue;
      EXPECT_GT(*area, Rational(0));
      bounded += *area;
      if (c.mark(FaceId(f))) marked += *area;
    }
    EXPECT_EQ(marked, *marked_area(c));
    // What no cell of the grid can reach from outside over unchosen ones lies in bounded faces.
    std::set<int> outside;
    const auto is_free = [&](int x, int y) {
      return x < 0 || y < 0 || x >= kSide || y >= kSide ||
             !is_chosen[static_cast<std::size_t>(y * kSide + x)];
    };
    std::vector<int> todo{-1};  // cells (x, y) with -1 <= x, y <= kSide as 100 (y + 1) + x
    while (!todo.empty()) {
      const int x = (todo.back() + 1) % 100 - 1, y = (todo.back() + 1) / 100 - 1;
      todo.pop_back();
      if (x < -1 || y < -1 || x > kSide || y > kSide || !is_free(x, y)) continue;
      if (!outside.insert(100 * (y + 1) + x).second) continue;
      for (const int step : {-1, 1, -100, 100}) todo.push_back(100 * (y + 1) + x + step);
    }
    EXPECT_EQ(bounded, Rational((kSide + 2) * (kSide + 2) - static_cast<int>(outside.size())));
  }
}

TEST(PlaneMeasure, RingsAreSimpleAndBoundTheirFace) {
  testing::Dice dice(2);
  for (int round = 0; round < 40; ++round) {
    std::vector<bool> is_chosen;
    const Nef2 set = random_cells(dice, is_chosen);
    const PlaneComplex& c = set.complex();
    for (std::size_t i = 1; i < c.face_count(); ++i) {
      const FaceId f(i);
      std::multiset<std::pair<std::size_t, std::size_t>> border, found;
      for (std::size_t h = 0; h < c.dcel.halfedge_count(); ++h) {
        const HalfedgeId half(h);
        if (c.dcel.face(half) != f || c.dcel.face(twin(half)) == f) continue;
        border.insert({as_index(c.dcel.origin(half)), as_index(c.dcel.target(half))});
      }
      Rational twice = 0;
      bool is_hole = false;
      for (const auto& ring : face_rings(c, f)) {
        EXPECT_EQ(std::set<VertexId>(ring.begin(), ring.end()).size(), ring.size());
        const Rational area = shoelace(c, ring);
        EXPECT_NE(area, Rational(0));
        EXPECT_FALSE(is_hole && area > 0) << "outer rings come first";
        is_hole = area < 0;
        twice += area;
        for (std::size_t k = 0; k < ring.size(); ++k) {
          found.insert({as_index(ring[k]), as_index(ring[(k + 1) % ring.size()])});
        }
      }
      EXPECT_EQ(found, border);
      EXPECT_EQ(twice / 2, face_area(c, f));
    }
  }
}

/// Vertices are crossings here: coordinates are long fractions.
TEST(PlaneMeasure, AreasAddUpAndAreCarriedByMaps) {
  testing::Dice dice(3);
  const AffineMap2 map{Rational(1) / 3, 2, 5, Rational(-7) / 2, 1, -1};
  const Rational factor = Rational(1) / 3 + 7;  // its determinant
  for (int round = 0; round < 25; ++round) {
    std::vector<Nef2> sets;
    for (int k = 0; k < 2; ++k) {
      std::vector<Point2> corners(3);
      for (Point2& p : corners) {
        p = {static_cast<double>(dice.between(-9, 9)), static_cast<double>(dice.between(-9, 9))};
      }
      sets.push_back(Nef2::polygon(corners));
      const double twice = (corners[1].x - corners[0].x) * (corners[2].y - corners[0].y) -
                           (corners[1].y - corners[0].y) * (corners[2].x - corners[0].x);
      EXPECT_EQ(marked_area(sets.back().complex()), abs(Rational(twice)) / 2);
    }
    const auto area = [](const Nef2& set) { return marked_area(set.complex()).value(); };
    const Nef2 both = sets[0] * sets[1], either = sets[0] + sets[1];
    EXPECT_EQ(area(sets[0]) + area(sets[1]), area(both) + area(either));
    EXPECT_EQ(area(sets[0] ^ sets[1]), area(either) - area(both));
    EXPECT_EQ(area(either.transformed(map)), factor * area(either));
  }
}

TEST(PlaneMeasure, UnboundedFacesHaveNoArea) {
  const auto line = [](int ax, int ay, int bx, int by) {
    return Line2{RationalPoint2{ax, ay}, RationalPoint2{bx, by}};
  };
  const Nef2 lines = Nef2::line(line(0, 0, 1, 0)) + Nef2::line(line(0, 0, 0, 1)) +
                     Nef2::line(line(2, 0, 0, 2)) + Nef2::ray(line(5, 5, 5, 6), Boundary::Closed);
  const PlaneComplex& c = lines.complex();
  ASSERT_EQ(c.face_count(), 7U);
  std::size_t unbounded = 0;
  for (std::size_t f = 0; f < c.face_count(); ++f) {
    EXPECT_EQ(face_area(c, FaceId(f)).has_value(), !is_unbounded(c, FaceId(f)));
    unbounded += is_unbounded(c, FaceId(f)) ? 1 : 0;
    if (!is_unbounded(c, FaceId(f))) {
      EXPECT_EQ(face_area(c, FaceId(f)), Rational(2));
    }
  }
  EXPECT_EQ(unbounded, 6U);
  EXPECT_EQ(marked_area(c), Rational(0));
  EXPECT_FALSE(marked_area((!lines).complex()).has_value());
  EXPECT_EQ(marked_area(Nef2().complex()), Rational(0));
  EXPECT_FALSE(marked_area(Nef2::whole().complex()).has_value());
}

}  // namespace plumb::plane_measure_test
