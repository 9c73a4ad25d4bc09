// The vertical and planes that hold it, sectors around edges, and what a wall cuts of facets:
// against dot products, turns in rational numbers and the point set itself.
#include "plumb/convex/wall/wall_section.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <memory>
#include <vector>

#include "generate/mesh_solid.h"
#include "generate/meshes.h"
#include "generate/voxel_mesh.h"
#include "plumb/predicates/point3_signs.h"
#include "plumb/space/nef3.h"

namespace plumb::wall_section_test {

using Vector = std::array<Rational, 3>;

Nef3 box(Point3 low, Point3 high) { return testing::solid(testing::box_mesh(low, high)); }

Rational dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
Vector normal(const PlaneTable& planes, PlaneId p) {
  const IntegerRow row = planes.coefficients(p);
  return {Rational(row[0]), Rational(row[1]), Rational(row[2])};
}
Vector vector(const RationalPoint3& p) { return {p.x, p.y, p.z}; }
/// A step of a thousandth along it.
RationalPoint3 step_from(const Vector& at, const Vector& way) {
  Rational size = 0;
  for (const Rational& x : way) size = std::max(size, x < 0 ? Rational(-x) : x);
  const Rational by = Rational(1, 1000) / size;
  return {at[0] + by * way[0], at[1] + by * way[1], at[2] + by * way[2]};
}

TEST(WallSection, VerticalPlanesAreThoseThatHoldTheDirection) {
  for (const std::array<Integer, 3>& up :
       {std::array<Integer, 3>{0, 0, 1}, {2, -3, 1}, {-5, 0, 2}}) {
    SpaceTables tables;
    Vertical vertical(up, tables);
    const std::size_t axis = vertical.axis();
    const Sign turned = up[axis] < 0 ? Sign::Negative : Sign::Positive;
    const Vector along = {Rational(up[0]), Rational(up[1]), Rational(up[2])};
    for (const Integer& x : up) EXPECT_LE(abs(x), abs(up[axis]));
    EXPECT_EQ(vertical.rise(vertical.level()), Sign::Positive);
    std::vector<PlaneId> planes;
    for (int a = -1; a <= 1; ++a) {
      for (int b = -1; b <= 1; ++b) {
        planes.push_back(tables.planes.intern(a, b, 2.0, 1.0 + a).plane());
        const Vector n = normal(tables.planes, planes.back());
        EXPECT_EQ(vertical.rise(planes.back()), sign_of(dot(n, along).sign()) * turned);
      }
    }
    for (const PlaneId p : planes) {
      for (const PlaneId q : planes) {
        if (p == q) continue;
        const bool is_vertical =
            dot(normal(tables.planes, p), along) == 0 && dot(normal(tables.planes, q), along) == 0;
        EXPECT_EQ(vertical.is_vertical({p, q}), is_vertical);
        if (is_vertical) continue;
        const PlaneId wall = vertical.through({p, q}).plane();
        EXPECT_EQ(vertical.rise(wall), Sign::Zero);
        const Vector line = cross(normal(tables.planes, p), normal(tables.planes, q));
        EXPECT_EQ(dot(normal(tables.planes, wall), line), 0);
        const SpacePoint on = tables.points.add(p, q, vertical.level());
        if (on.is_valid()) {
          EXPECT_EQ(side(tables.points, on, wall), Sign::Zero);
        }
      }
    }
    const SpacePoint x{tables.planes.add_point({1, 2, 3})};
    const PlaneId first = vertical.through(x, PlaneId());
    const PlaneId second = vertical.through(x, first);
    EXPECT_NE(first, second);
    for (const PlaneId wall : {first, second}) {
      EXPECT_EQ(vertical.rise(wall), Sign::Zero);
      EXPECT_EQ(side(tables.points, x, wall), Sign::Zero);
    }
  }
}

/// 0 none, 1 less than half a turn about d, 2 half a turn, 3 more.
int turn(const Vector& d, const Vector& from, const Vector& to) {
  const int s = dot(d, cross(from, to)).sign();
  if (s == 0) return dot(from, to) > 0 ? 0 : 2;
  return s > 0 ? 1 : 3;
}

std::vector<Nef3> sets_with_sectors() {
  const Nef3 cube = box({0, 0, 0}, {4, 4, 4});
  const Nef3 step = cube - box({2, -1, 2}, {5, 5, 5});
  return {cube,
          step,
          step.interior(),
          cube + box({4, 4, 0}, {8, 8, 4}),  // with a common edge
          cube - Nef3::segment({1, 1, 1}, {2, 3, 2}),
          cube - Nef3::facet(std::vector<Point3>{{1, 1, 1}, {3, 1, 1}, {3, 3, 2}, {1, 3, 2}}),
          testing::solid(testing::star_prism(4))};
}

/// Half-planes of the planes of an edge and of two between these: those inside are the ones a step
/// along which is.
TEST(WallSection, SectorsHoldWhatLiesInside) {
  std::size_t held = 0, reflex = 0, resolved = 0;
  for (const Nef3& set : sets_with_sectors()) {
    SpaceComplex c = set.complex();
    const Nef3 inside = set.interior();
    const auto tables = copy(*c.tables);
    c.tables = tables;
    const SectorTest test(c);
    std::vector<Sector> sectors;
    for (std::uint32_t e = 0; e < c.edge_count(); ++e) {
      sectors_of(c, EdgeId(e), sectors);
      const auto [p, q] = c.edge_planes[e];
      const Vector d = cross(normal(c.planes(), p), normal(c.planes(), q));
      const Vector a = vector(exact(c.points(), c.vertex_point[c.origin[2 * e].value()]));
      const Vector b = vector(exact(c.points(), c.vertex_point[c.origin[2 * e + 1].value()]));
      const Vector middle = {(a[0] + b[0]) / 2, (a[1] + b[1]) / 2, (a[2] + b[2]) / 2};
      const auto way = [&](HalfPlane h) {
        Vector v = cross(normal(c.planes(), h.plane), d);
        if (h.sense == Sign::Negative) v = {-v[0], -v[1], -v[2]};
        return v;
      };
      const PlaneId between = tables->planes.intern(Pencil{p, q, 1, 1}).plane();
      const PlaneId beside = tables->planes.intern(Pencil{p, q, -1, 1}).plane();
      for (const PlaneId plane : {p, q, between, beside}) {
        for (const Sign sense : {Sign::Positive, Sign::Negative}) {
          const HalfPlane h{plane, sense};
          const bool is_held =
              std::ranges::any_of(sectors, [&](const Sector& s) { return test.holds(s, h); });
          EXPECT_EQ(is_held, inside.contains(step_from(middle, way(h))));
          held += is_held ? 1 : 0;
          for (const Sector& s : sectors) {
            if (!s.first.is_valid()) continue;
            const Vector first = way(test.of_use(s.first)), second = way(test.of_use(s.second));
            const bool is_resolved =
                test.holds(s, h) && turn(d, first, way(h)) <= 2 && turn(d, way(h), second) <= 2;
            EXPECT_EQ(test.is_resolved_by(s, h), is_resolved);
            resolved += is_resolved ? 1 : 0;
          }
        }
      }
      for (const Sector& s : sectors) {
        EXPECT_EQ(s.edge, EdgeId(e));
        EXPECT_EQ(c.volume_mark[s.volume.value()], 1);
        const bool is_all_around = !s.first.is_valid() || s.first == s.second;
        const bool is_reflex =
            is_all_around || turn(d, way(test.of_use(s.first)), way(test.of_use(s.second))) == 3;
        EXPECT_EQ(test.is_reflex(s), is_reflex);
        reflex += is_reflex ? 1 : 0;
      }
    }
  }
  EXPECT_GT(held, 10U);
  EXPECT_GT(reflex, 10U);
  EXPECT_GT(resolved, 10U);
}

/// Upright planes through solids: over any place in between the set begins and ends at the
/// obstacles.
TEST(WallSection, ObstaclesAreWhereTheSetBeginsAndEnds) {
  std::size_t found = 0;
  for (const Nef3& set : {box({0, 0, 0}, {4, 4, 4}) - box({2, -1, 2}, {5, 5, 5}),
                          box({0, 0, 0}, {6, 6, 6}) - box({2, 2, 2}, {4, 4, 4}),
                          testing::solid(testing::comb_block(2, 2)),
                          testing::solid(testing::icosphere_mesh(1, 4, {3, 3, 3}))}) {
    SpaceComplex c = set.complex();
    const auto tables = copy(*c.tables);
    c.tables = tables;
    Vertical vertical({0, 0, 1}, *tables);
    for (const std::array<double, 3>& line :
         {std::array<double, 3>{0, 1, -1.3}, {1, 0, -3.3}, {2, 1, -7.1}, {1, 1, -5.3}}) {
      const PlaneId wall = tables->planes.intern(line[0], line[1], 0.0, line[2]).plane();
      WallSection section(c, *tables, vertical, wall);
      for (std::uint32_t f = 0; f < c.facet_count(); ++f) section.add(FacetId(f));
      section.add_edges();
      const Vector n = normal(tables->planes, wall);
      const Vector ahead = cross(n, normal(tables->planes, vertical.level()));
      const auto place = [&](const Station& s) {
        return dot(ahead, vector(exact(tables->points, s.point)));
      };
      std::vector<Rational> places;
      for (const Obstacle& o : section.obstacles()) {
        ++found;
        EXPECT_LT(place(o.from), place(o.to));
        EXPECT_EQ(section.ahead(o.to.point, o.from), Sign::Positive);
        EXPECT_EQ(section.ahead(o.from.point, o.to), Sign::Negative);
        for (const Station& s : {o.from, o.to}) {
          EXPECT_EQ(side(tables->points, s.point, wall), Sign::Zero);
          EXPECT_EQ(side(tables->points, s.point, o.plane), Sign::Zero);
          EXPECT_EQ(section.corner(s, o.plane), s.point);
          places.push_back(place(s));
        }
      }
      std::ranges::sort(places);
      for (std::size_t i = 0; i + 1 < places.size(); ++i) {
        if (places[i] == places[i + 1]) continue;
        const Rational at = (places[i] + places[i + 1]) / 2;
        // The point of W there, and heights of the obstacles over it.
        const Rational by = at / dot(ahead, ahead),
                       off = -Rational(tables->planes.coefficients(wall)[3]) / dot(n, n);
        const Vector foot = {by * ahead[0] + off * n[0], by * ahead[1] + off * n[1], 0};
        std::vector<Rational> heights;
        for (const Obstacle& o : section.obstacles()) {
          if (place(o.from) >= at || place(o.to) <= at) continue;
          const IntegerRow row = tables->planes.coefficients(o.plane);
          heights.push_back(-(row[0] * foot[0] + row[1] * foot[1] + row[3]) / row[2]);
        }
        std::ranges::sort(heights);
        EXPECT_EQ(heights.size() % 2, 0U);
        for (std::size_t k = 0; k + 1 < heights.size(); ++k) {
          const RationalPoint3 between{foot[0], foot[1], (heights[k] + heights[k + 1]) / 2};
          EXPECT_EQ(set.contains(between), k % 2 == 0);
        }
      }
    }
  }
  EXPECT_GT(found, 60U);
}

/// Edges in the wall are obstacles of their own, each once; upright ones are none.
TEST(WallSection, EdgesInTheWallAreNoted) {
  const Nef3 cube = box({0, 0, 0}, {4, 4, 4});
  SpaceComplex c = cube.complex();
  const auto tables = copy(*c.tables);
  c.tables = tables;
  Vertical vertical({0, 0, 1}, *tables);
  for (const auto& [line, count] :
       {std::pair(std::array<double, 3>{1, 0, 0}, 2U), {{1, -1, 0}, 0U}, {{0, 1, -4}, 2U}}) {
    const PlaneId wall = tables->planes.intern(line[0], line[1], 0.0, line[2]).plane();
    WallSection section(c, *tables, vertical, wall);
    for (std::uint32_t f = 0; f < c.facet_count(); ++f) section.add(FacetId(f));
    const std::size_t before = section.obstacles().size();
    EXPECT_EQ(before, count == 0 ? 2U : 0U);
    for (std::uint32_t e = 0; e < c.edge_count(); ++e) section.note(EdgeId(e));
    section.add_edges();
    ASSERT_EQ(section.obstacles().size(), before + count);
    if (count == 0) continue;
    const Obstacle &x = section.obstacles()[0], &y = section.obstacles()[1];
    EXPECT_NE(x.owner, y.owner);
    const Rational low = exact(tables->points, x.from.point).z;
    EXPECT_EQ(section.above(x, y), low == 0 ? Sign::Negative : Sign::Positive);
    EXPECT_EQ(section.above(y, x), -section.above(x, y));
    EXPECT_EQ(section.above(x, x), Sign::Zero);
  }
}

}  // namespace plumb::wall_section_test
