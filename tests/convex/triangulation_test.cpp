// Delaunay triangulations: triangles cover exactly what they should, every edge of the set is a
// side, and no circle of a triangle contains a corner that it sees.
#include "plumb/convex/triangulation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <utility>
#include <vector>

#include "generate/plane_program.h"
#include "generate/test_share.h"
#include "oracle/nef2_check.h"
#include "plumb/plane/plane_measure.h"
#include "plumb/predicates/error.h"
#include "plumb/predicates/rational_predicates.h"
#include "plumb/testing/dice.h"

namespace plumb::testing::triangulation_test {
namespace {

using Side = std::pair<std::uint32_t, std::uint32_t>;

Rational twice_area(const PlaneTriangulation& t) {
  Rational sum = 0;
  for (const auto& triangle : t.triangles) {
    const Rational area = twice_polygon_area(t.points, triangle);
    EXPECT_GT(area, 0);
    sum += area;
  }
  return sum;
}

/// The corner opposite each side. A side of two triangles occurs in both directions.
std::map<Side, std::uint32_t> opposite_corners(const PlaneTriangulation& t) {
  std::map<Side, std::uint32_t> result;
  for (const auto& [a, b, c] : t.triangles) {
    for (const auto& [from, to, opposite] :
         {std::array{a, b, c}, std::array{b, c, a}, std::array{c, a, b}}) {
      EXPECT_TRUE(result.emplace(Side(from, to), opposite).second) << "a side occurs twice";
    }
  }
  return result;
}

/// Returns the number of sides that are not locally Delaunay. `may_be` allows this for a side.
template <class MayBe>
std::size_t count_bad_sides(const PlaneTriangulation& t, const MayBe& may_be) {
  const std::map<Side, std::uint32_t> opposite = opposite_corners(t);
  std::size_t bad = 0;
  for (const auto& [side, corner] : opposite) {
    const auto other = opposite.find(Side(side.second, side.first));
    if (other == opposite.end()) continue;
    const Sign sign = incircle(t.points.exact(side.first), t.points.exact(side.second),
                               t.points.exact(corner), t.points.exact(other->second));
    if (sign == Sign::Positive && !may_be(side)) ++bad;
  }
  return bad;
}

PointTable2 random_points(Dice& dice) {
  PointTable2 points;
  const std::uint64_t count = dice.below(14);
  const std::uint64_t kind = dice.below(3);
  for (std::uint64_t i = 0; i < count; ++i) {
    const auto x = static_cast<double>(dice.below(kind == 0 ? 3 : 6));
    const auto y = static_cast<double>(dice.below(kind == 1 ? 1 : 6));
    if (kind == 2) {
      points.push_back(Rational(x) / 3, Rational(y) / 7);
    } else {
      points.push_back({x, y});
    }
  }
  return points;
}

/// Points of a small grid lie on common circles and lines nearly always.
TEST(Triangulation, PointsAreCornersAndCirclesAreEmpty) {
  for (std::uint64_t seed = 0; seed < case_count(300); ++seed) {
    Dice dice(seed);
    const PointTable2 points = random_points(dice);
    const PlaneTriangulation t = delaunay(points);
    std::vector<std::uint8_t> is_corner(points.size(), 0);
    for (const auto& triangle : t.triangles) {
      for (const std::uint32_t corner : triangle) is_corner[corner] = 1;
      for (std::uint32_t p = 0; p < points.size(); ++p) {
        EXPECT_NE(incircle(points.exact(triangle[0]), points.exact(triangle[1]),
                           points.exact(triangle[2]), points.exact(p)),
                  Sign::Positive)
            << "seed " << seed;
      }
    }
    for (std::uint32_t p = 0; p < points.size() && !t.triangles.empty(); ++p) {
      bool is_repeated = false;
      for (std::uint32_t q = 0; q < p; ++q) {
        is_repeated = is_repeated || compare_xy(points, p, q) == Sign::Zero;
      }
      EXPECT_EQ(is_corner[p] != 0, !is_repeated) << "seed " << seed;
    }
    opposite_corners(t);
    twice_area(t);
  }
}

/// Returns twice the area of the convex hull, by brute force: an edge has all points on its left.
Rational twice_hull_area(const PointTable2& points) {
  Rational sum = 0;
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    for (std::uint32_t j = 0; j < points.size(); ++j) {
      bool is_edge = compare_xy(points, i, j) != Sign::Zero;
      for (std::uint32_t k = 0; k < points.size() && is_edge; ++k) {
        const Sign side = orient2d(points, i, j, k);
        const RationalPoint2 a = points.exact(i), b = points.exact(j), c = points.exact(k);
        const Rational along = (c.x - a.x) * (b.x - a.x) + (c.y - a.y) * (b.y - a.y);
        const Rational length = (b.x - a.x) * (b.x - a.x) + (b.y - a.y) * (b.y - a.y);
        is_edge = side == Sign::Positive || (side == Sign::Zero && along >= 0 && along <= length &&
                                             !(compare_xy(points, i, k) == Sign::Zero && k < i) &&
                                             !(compare_xy(points, j, k) == Sign::Zero && k < j));
      }
      if (is_edge) {
        const RationalPoint2 a = points.exact(i), b = points.exact(j);
        sum += a.x * b.y - a.y * b.x;
      }
    }
  }
  return sum;
}

TEST(Triangulation, TrianglesCoverTheHull) {
  for (std::uint64_t seed = 0; seed < case_count(300); ++seed) {
    Dice dice(seed);
    const PointTable2 points = random_points(dice);
    EXPECT_EQ(twice_area(delaunay(points)), twice_hull_area(points)) << "seed " << seed;
  }
}

TEST(Triangulation, SetsAreCoveredAndTheirEdgesAreSides) {
  std::size_t triangles = 0;
  for (std::uint64_t seed = 0; seed < case_count(200); ++seed) {
    Dice dice(seed);
    const auto program = random_program(dice, ProgramValues::Plain, 5);
    const PointTable2 corners = [] {
      PointTable2 table;
      for (const Point2 p : {Point2{-1, -1}, Point2{17, -1}, Point2{17, 17}, Point2{-1, 17}}) {
        table.push_back(p);
      }
      return table;
    }();
    const std::array<std::uint32_t, 4> ring{0, 1, 2, 3};
    const std::array<std::uint32_t, 2> begin{0, 4};
    const Nef2 frame = Nef2::polygons(corners, ring, begin, WindingRule::NonZero, Boundary::Closed);
    const Nef2 set = to_nef(*set_of_program(program, 8)) * frame;
    const PlaneTriangulation t = delaunay(set);
    triangles += t.triangles.size();
    const auto area = set.area();
    ASSERT_TRUE(area.has_value());
    EXPECT_EQ(twice_area(t), 2 * *area) << "seed " << seed;

    // Edges of the set are sides.
    const std::map<Side, std::uint32_t> opposite = opposite_corners(t);
    const auto index_of = [&t](const RationalPoint2& p) {
      std::uint32_t i = 0;
      while (i < t.points.size() && !(t.points.exact(i) == p)) ++i;
      return i;
    };
    const PlaneComplex& complex = set.complex();
    std::vector<Side> edges;
    for (std::size_t e = 0; e < complex.edge_count(); ++e) {
      for (const HalfedgeId h : {HalfedgeId(2 * e), HalfedgeId(2 * e + 1)}) {
        if (!complex.mark(complex.dcel.face(h))) continue;
        const auto at = [&](HalfedgeId from) {
          const VertexId v = complex.dcel.origin(from);
          return index_of(exact(complex.points, complex.vertex_point[v]));
        };
        edges.emplace_back(at(h), at(twin(h)));
        EXPECT_TRUE(opposite.contains(edges.back())) << "seed " << seed;
      }
    }
    const auto is_edge = [&edges](Side side) {
      return std::find(edges.begin(), edges.end(), side) != edges.end();
    };
    EXPECT_EQ(count_bad_sides(t, is_edge), 0U) << "seed " << seed;
  }
  EXPECT_GT(triangles, testing::case_count(200) / 2);
}

TEST(Triangulation, SlitsAndMissingPointsAreCorners) {
  const std::vector<Point2> square{{0, 0}, {4, 0}, {4, 4}, {0, 4}};
  const std::vector<Point2> slit{{1, 1}, {2, 1}};
  const Nef2 set = Nef2::polygon(square) - Nef2::polyline(slit) - Nef2::point(RationalPoint2{3, 3});
  const PlaneTriangulation t = delaunay(set);
  EXPECT_EQ(t.points.size(), 7U);
  EXPECT_EQ(t.triangles.size(), 2 * 7U - 2 - 4);
  EXPECT_EQ(twice_area(t), 32);
}

TEST(Triangulation, UnboundedFacesAreRefused) {
  EXPECT_THROW(static_cast<void>(delaunay(Nef2::whole())), Error);
  EXPECT_TRUE(delaunay(Nef2::empty()).triangles.empty());
  EXPECT_TRUE(delaunay(PointTable2()).triangles.empty());
}

}  // namespace
}  // namespace plumb::testing::triangulation_test
