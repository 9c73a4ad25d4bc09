// Distances against an oracle that compares every vertex with every triangle and every edge with
// every edge, by projections instead of linear systems; whether sets meet, a Boolean decides.
#include "plumb/model/distance.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "generate/plane_program.h"
#include "generate/space_program.h"
#include "generate/test_share.h"
#include "oracle/nef3_check.h"
#include "oracle/plane_set.h"
#include "plumb/model/hull.h"
#include "plumb/model/primitives.h"
#include "plumb/model/transform.h"
#include "plumb/predicates/error.h"
#include "plumb/predicates/point3_signs.h"
#include "plumb/predicates/rounding.h"
#include "plumb/space/planar/facet_triangles.h"
#include "plumb/testing/dice.h"

namespace plumb::testing::distance_test {
namespace {

using Vector = RationalPoint3;

Rational dot(const Vector& a, const Vector& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
Rational square(const Vector& v) { return dot(v, v); }
Vector moved(const Vector& p, const Rational& t, const Vector& v) {
  return {p.x + t * v.x, p.y + t * v.y, p.z + t * v.z};
}
Vector cross(const Vector& a, const Vector& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

// ---------------------------------------------------------------- the oracle

using Segment = std::array<Vector, 2>;
using Triangle = std::array<Vector, 3>;

struct Features {
  std::vector<Vector> points;
  std::vector<Segment> segments;
  std::vector<Triangle> triangles;
};

Rational point_segment(const Vector& p, const Segment& s) {
  const Vector d = s[1] - s[0];
  const Rational t = std::clamp(Rational(dot(p - s[0], d) / square(d)), Rational(0), Rational(1));
  return square(p - moved(s[0], t, d));
}

Rational point_triangle(const Vector& p, const Triangle& t) {
  const Vector n = cross(t[1] - t[0], t[2] - t[0]);
  bool is_inside = true;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vector& a = t[i];
    is_inside = is_inside && dot(cross(t[(i + 1) % 3] - a, p - a), n).sign() >= 0;
  }
  const Rational height = dot(p - t[0], n);
  if (is_inside) return height * height / square(n);
  return std::min({point_segment(p, {t[0], t[1]}), point_segment(p, {t[1], t[2]}),
                   point_segment(p, {t[2], t[0]})});
}

Rational segment_segment(const Segment& s, const Segment& t) {
  const Rational ends = std::min({point_segment(s[0], t), point_segment(s[1], t),
                                  point_segment(t[0], s), point_segment(t[1], s)});
  const Vector u = s[1] - s[0], v = t[1] - t[0], w = t[0] - s[0], n = cross(u, v);
  if (square(n) == 0) return ends;
  const Rational x = dot(cross(w, v), n) / square(n), y = dot(cross(w, u), n) / square(n);
  if (x < 0 || x > 1 || y < 0 || y > 1) return ends;
  const Rational height = dot(w, n);
  return std::min(ends, Rational(height * height / square(n)));
}

Features features_of(const Nef3& set) {
  const SpaceComplex& c = set.complex();
  Features f;
  for (const SpacePoint p : c.vertex_point) f.points.push_back(exact(c.points(), p));
  for (std::uint32_t e = 0; e < c.edge_count(); ++e) {
    f.segments.push_back({f.points[c.origin[HalfedgeId(2 * e)].value()],
                          f.points[c.origin[HalfedgeId(2 * e + 1)].value()]});
  }
  FacetTriangles triangles(c);
  for (std::uint32_t i = 0; i < c.facet_count(); ++i) {
    triangles.for_each(FacetId(i), [&f](VertexId u, VertexId v, VertexId w) {
      f.triangles.push_back({f.points[u.value()], f.points[v.value()], f.points[w.value()]});
    });
  }
  return f;
}

Features features_of(const Nef2& set) {
  const PlaneComplex& c = set.complex();
  Features f;
  for (const std::uint32_t p : c.vertex_point) {
    const RationalPoint2 at = exact(c.points, p);
    f.points.push_back({at.x, at.y, 0});
  }
  for (std::uint32_t e = 0; e < c.edge_count(); ++e) {
    const HalfedgeId h = first_half(EdgeId(e));
    f.segments.push_back(
        {f.points[c.dcel.origin(h).value()], f.points[c.dcel.origin(twin(h)).value()]});
  }
  return f;
}

/// Returns the square of the distance of two disjoint closed sets.
Rational least_square(const Features& a, const Features& b) {
  std::optional<Rational> least;
  const auto take = [&least](const Rational& d) {
    if (!least || d < *least) least = d;
  };
  for (const Vector& p : a.points) {
    for (const Vector& q : b.points) take(square(p - q));
    for (const Segment& s : b.segments) take(point_segment(p, s));
    for (const Triangle& t : b.triangles) take(point_triangle(p, t));
  }
  for (const Segment& s : a.segments) {
    for (const Vector& q : b.points) take(point_segment(q, s));
    for (const Segment& t : b.segments) take(segment_segment(s, t));
  }
  for (const Triangle& t : a.triangles) {
    for (const Vector& q : b.points) take(point_triangle(q, t));
  }
  return *least;
}

template <class Set>
Rational oracle(const Set& a, const Set& b) {
  if (!(a.closure() * b.closure()).is_empty()) return 0;
  return least_square(features_of(a), features_of(b));
}

// ---------------------------------------------------------------- the laws

bool has_cell(const Nef3& set, const RationalPoint3& p, const SpaceLocation& cell) {
  const SpaceLocation at = set.locate(p);
  return at.item == cell.item && at.marked == cell.marked;
}
bool has_cell(const Nef2& set, const RationalPoint2& p, const PlaneLocation& cell) {
  return set.locate(p) == cell;
}
Rational square_between(const RationalPoint3& p, const RationalPoint3& q) { return square(p - q); }
Rational square_between(const RationalPoint2& p, const RationalPoint2& q) {
  return (p.x - q.x) * (p.x - q.x) + (p.y - q.y) * (p.y - q.y);
}

/// The points lie in the closures, on the cells, and at the distance that is expected.
template <class Set>
void expect_distance(const Set& a, const Set& b, const Rational& squared) {
  const auto d = distance(a, b);
  EXPECT_EQ(d.squared, squared);
  EXPECT_EQ(square_between(d.at_a, d.at_b), d.squared);
  EXPECT_TRUE(a.closure().contains(d.at_a));
  EXPECT_TRUE(b.closure().contains(d.at_b));
  EXPECT_TRUE(has_cell(a, d.at_a, d.cell_a));
  EXPECT_TRUE(has_cell(b, d.at_b, d.cell_b));
  EXPECT_EQ(distance(b, a).squared, squared);
}

Nef3 box(double x, double y, double z) {
  return Nef3::from_mesh(box_mesh({x, y, z}, Placement::Corner));
}
Nef3 large_box() { return Nef3::from_mesh(box_mesh({2000, 2000, 2000}, Placement::Centred)); }
Nef2 square_of(double side) {
  const std::vector<Point2> corners{{0, 0}, {side, 0}, {side, side}, {0, side}};
  return Nef2::polygon(corners);
}

Rational rational(Dice& dice) { return Rational(dice.between(-40, 40)) / dice.between(1, 7); }

TEST(Distance, OfCubes) {
  const Nef3 cube = box(1, 1, 1);
  expect_distance(cube, cube.translated({3, 0, 0}), 4);
  expect_distance(cube, cube.translated({3, 5, 0}), 4 + 16);
  expect_distance(cube, cube.translated({2, 2, 2}), 3);
  expect_distance(cube.interior(), cube.translated({1, 0, 0}).interior(), 0);
  expect_distance(cube, cube.translated({1, 1, 1}), 0);
  expect_distance(cube, box(3, 3, 3).translated({-1, -1, -1}), 0);
  const Nef3 shell = box(5, 5, 5) - box(3, 3, 3).translated({1, 1, 1}).interior();
  expect_distance(cube.translated({2, 2, 2}), shell, 1);
  const Rational third = Rational(1) / 3;
  expect_distance(cube.translated({third + 1, 0, 0}), cube, third * third);
}

TEST(Distance, ToPoints) {
  const Nef3 cube = box(1, 1, 1);
  EXPECT_EQ(distance(cube, RationalPoint3{Rational(1) / 2, Rational(1) / 2, 3}).squared, 4);
  const DistanceIndex index(cube - Nef3::segment({0, 0, 0}, {1, 1, 1}));
  const SpaceDistance inside = index.to(RationalPoint3{Rational(1) / 2, Rational(1) / 3, 0});
  EXPECT_EQ(inside.squared, 0);
  EXPECT_EQ(inside.cell_a.item.kind(), SpaceItem::Kind::Facet);
  const SpaceDistance removed = index.to(RationalPoint3{0, 0, 0});
  EXPECT_EQ(removed.squared, 0);
  EXPECT_EQ(removed.cell_a.item.kind(), SpaceItem::Kind::Vertex);
  const SpaceDistance edge = index.to(RationalPoint3{-1, -1, Rational(1) / 7});
  EXPECT_EQ(edge.squared, 2);
  EXPECT_EQ(edge.cell_a.item.kind(), SpaceItem::Kind::Edge);
  EXPECT_EQ(distance(square_of(2), RationalPoint2{5, 6}).squared, 9 + 16);
}

TEST(Distance, OfRandomSetsOfSpace) {
  for (std::uint64_t seed = 0; seed < share_of(40); ++seed) {
    SCOPED_TRACE(seed);
    Dice dice(seed);
    const auto random_set = [&dice] {
      return to_nef(*space_set_of_program(random_space_program(dice, ProgramValues::Plain, 4), 9));
    };
    const Nef3 near = box(3, 3, 3), unbounded = random_set(), a = unbounded * near;
    const AffineMap3 map = composed(translation({rational(dice), rational(dice), rational(dice)}),
                                    rotation({1, 2, 3}, static_cast<double>(dice.below(360))));
    const Nef3 b = (random_set() * near).transformed(map);
    if (a.is_empty() || b.is_empty()) continue;
    expect_distance(a, b, oracle(a, b));
    if (unbounded.is_bounded()) continue;
    expect_distance(unbounded, b, oracle(Nef3(unbounded * large_box()), b));
  }
}

TEST(Distance, OfRandomSetsOfThePlane) {
  for (std::uint64_t seed = 0; seed < share_of(400); ++seed) {
    SCOPED_TRACE(seed);
    Dice dice(seed);
    const auto random_set = [&dice] {
      return to_nef(*set_of_program(random_program(dice, ProgramValues::Plain, 4), 5));
    };
    const Nef2 near = square_of(4), unbounded = random_set(), a = unbounded * near;
    AffineMap2 map{.xx = Rational(3) / 5, .xy = Rational(-4) / 5, .x0 = rational(dice)};
    map.yx = -map.xy, map.yy = map.xx, map.y0 = rational(dice);
    const Nef2 b = (random_set() * near).transformed(map);
    if (a.is_empty() || b.is_empty()) continue;
    expect_distance(a, b, oracle(a, b));
    const Nef2 large = square_of(2000).transformed({.x0 = -1000, .y0 = -1000});
    expect_distance(unbounded, b, oracle(Nef2(unbounded * large), b));
  }
}

// Random tetrahedra: their nearest features are of all kinds, and most coordinates of the nearest
// points are no doubles.
TEST(Distance, OfRandomTetrahedra) {
  std::array<int, 16> kinds{};
  for (std::uint64_t seed = 0; seed < share_of(600); ++seed) {
    SCOPED_TRACE(seed);
    Dice dice(seed);
    const auto tetrahedron = [&dice](double shift) {
      std::vector<Point3> corners;
      for (int i = 0; i < 4; ++i) {
        corners.push_back({static_cast<double>(dice.between(0, 9)) + shift,
                           static_cast<double>(dice.between(0, 9)),
                           static_cast<double>(dice.between(0, 9))});
      }
      return convex_hull(std::span<const Point3>(corners));
    };
    const Nef3 a = tetrahedron(0), b = tetrahedron(static_cast<double>(dice.between(3, 9)));
    expect_distance(a, b, oracle(a, b));
    const SpaceDistance d = distance(a, b);
    ++kinds[4 * static_cast<std::size_t>(d.cell_a.item.kind()) +
            static_cast<std::size_t>(d.cell_b.item.kind())];
  }
  const auto count = [&kinds](SpaceItem::Kind a, SpaceItem::Kind b) {
    return kinds[4 * static_cast<std::size_t>(a) + static_cast<std::size_t>(b)];
  };
  using Kind = SpaceItem::Kind;
  EXPECT_GT(count(Kind::Vertex, Kind::Facet) + count(Kind::Facet, Kind::Vertex), 0);
  EXPECT_GT(count(Kind::Edge, Kind::Edge), 0);
  EXPECT_GT(count(Kind::Vertex, Kind::Edge) + count(Kind::Edge, Kind::Vertex), 0);
  EXPECT_GT(count(Kind::Vertex, Kind::Vertex), 0);
}

// Coordinates for which doubles do not help: far from the origin, and too large or too small.
TEST(Distance, OfExtremeCoordinates) {
  const Nef3 cube = box(1, 1, 1);
  const Rational tiny =
      Rational(1) / Rational(Integer(std::string_view("1" + std::string(40, '0'))));
  for (const Rational& scale :
       {Rational(1), Rational(0x1p-600), Rational(0x1p600), Rational(0x1p1000) * 0x1p1000}) {
    const Nef3 a = cube.transformed(scaling({scale, scale, scale}));
    const Rational shift = scale * (Rational(3) + tiny);
    expect_distance(a, a.translated({shift, 0, 0}), scale * scale * (tiny + 2) * (tiny + 2));
    const Nef3 around = a.transformed(scaling({3, 3, 3})).translated({-scale, -scale, -scale});
    expect_distance(a, around, 0);
  }
  const Rational far = Rational(0x1p60);
  expect_distance(cube.translated({far, far, far}), cube.translated({far + 1 + tiny, far, far}),
                  tiny * tiny);
}

// Squares of distances are subnormal here, so doubles bound nothing.
TEST(Distance, OfCoordinatesWhoseSquaresUnderflow) {
  Nef2 points;
  for (const double x : {-2.6895380868769437e-162, -2.667310499382093e-162, 4e-151}) {
    points = points + Nef2::point(RationalPoint2{exact_rational(x), 0});
  }
  const Rational nearest = exact_rational(-2.667310499382093e-162);
  expect_distance(points, Nef2::point(RationalPoint2{0, 0}), nearest * nearest);
}

TEST(Distance, OfHalfSpaces) {
  const Nef3 cube = box(1, 1, 1);
  const Nef3 below = Nef3::half_space({1, 1, 1, 100}, Boundary::Open);
  expect_distance(cube, below, Rational(10000) / 3);
  expect_distance(below.complement(), cube, 0);
  expect_distance(Nef3::whole(), cube, 0);
  const Rational far = Rational(0x1p200);
  expect_distance(Nef3::half_space({1, 0, 0, far}, Boundary::Closed), cube, far * far);
}

TEST(Distance, RefusesEmptyAndUnboundedSets) {
  const Nef3 half = Nef3::half_space({1, 0, 0, 0}, Boundary::Closed);
  EXPECT_THROW(static_cast<void>(distance(Nef3(), box(1, 1, 1))), Error);
  EXPECT_THROW(static_cast<void>(distance(half, half)), Error);
  EXPECT_THROW(DistanceIndex{half}, Error);
  EXPECT_THROW(DistanceIndex{Nef3()}, Error);
  EXPECT_THROW(static_cast<void>(distance(Nef2(), square_of(1))), Error);
}

TEST(RootOf, Squares) {
  EXPECT_EQ(root_of(0), 0);
  EXPECT_EQ(root_of(Rational(9) / 4), 1.5);
  for (const double x : {0.1, 3.0, 1e-300, 1e300, 0x1p-1060}) {
    const Rational exact = exact_rational(x);
    EXPECT_EQ(root_of(exact * exact), x);
  }
  EXPECT_DOUBLE_EQ(root_of(2), std::sqrt(2.0));
  EXPECT_TRUE(std::isinf(root_of(Rational(0x1p1000) * 0x1p1000 * 0x1p1000)));
  EXPECT_THROW(static_cast<void>(root_of(-1)), Error);
}

}  // namespace
}  // namespace plumb::testing::distance_test
