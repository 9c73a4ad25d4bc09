// Points of space as a table has them: their definitions against Cramer's rule, and their boxes
// against exact coordinates, whatever the floating-point mode.
#include "plumb/predicates/space/point3_table.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <random>
#include <vector>

#include "float_environment.h"
#include "generate/space_cases.h"
#include "plumb/predicates/point3_signs.h"
#include "plumb/predicates/rounding.h"

namespace plumb::point3_table_test {

std::array<Rational, 3> coordinates(const RationalPoint3& p) { return {p.x, p.y, p.z}; }
double largest(const PointBox& box) {
  return std::max({std::fabs(box.mid[0]), std::fabs(box.mid[1]), std::fabs(box.mid[2])});
}
/// A point of the frame has an infinite radius.
bool is_finite(const PointBox& box) { return box.radius < std::numeric_limits<double>::infinity(); }
bool holds(const PointBox& box, const RationalPoint3& at) {
  const std::array<Rational, 3> x = coordinates(at);
  for (std::size_t i = 0; i < 3; ++i) {
    const Rational off = x[i] - exact_rational(box.mid[i]);
    if (off > exact_rational(box.radius) || -off > exact_rational(box.radius)) return false;
  }
  return true;
}

PlaneId id_of(OrientedPlane plane) { return plane.is_valid() ? plane.plane() : PlaneId(); }

/// a x + b y + c z + d = 0, if that is a plane.
PlaneId plane(PlaneTable& table, double a, double b, double c, double d) {
  return id_of(table.intern(a, b, c, d));
}

TEST(Point3Table, SpacePointsAreInputOrConstructedOrNone) {
  EXPECT_FALSE(SpacePoint().is_valid());
  for (const std::uint32_t i : {0U, 1U, 0x7ffffffeU}) {
    const SpacePoint input{InputPointId(i)}, made = SpacePoint::constructed(i);
    EXPECT_TRUE(input.is_valid() && input.is_input());
    EXPECT_EQ(input.input(), InputPointId(i));
    EXPECT_TRUE(made.is_valid() && !made.is_input());
    EXPECT_EQ(made.index(), i);
    EXPECT_NE(input, made);
  }
}

TEST(Point3Table, SourcesHaveThePlanesThatDefineThem) {
  const PointSource of_planes(PlaneId(3), PlaneId(5), PlaneId(8));
  const PointSource of_line(InputPointId(3), InputPointId(5), PlaneId(8));
  for (const std::uint32_t p : {0U, 3U, 5U, 8U}) {
    EXPECT_EQ(of_planes.has_plane(PlaneId(p)), p != 0);
    EXPECT_EQ(of_line.has_plane(PlaneId(p)), p == 8);
  }
  const auto plane = [](PlaneId p) { return PlaneId(p.value() + 100); };
  const auto input = [](InputPointId p) { return InputPointId(p.value() + 1000); };
  const PointSource planes = of_planes.mapped(plane, input), line = of_line.mapped(plane, input);
  ASSERT_EQ(planes.plane_count(), 3U);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(planes.plane(i), plane(of_planes.plane(i)));
  ASSERT_EQ(line.plane_count(), 1U);
  EXPECT_EQ(line.plane(0), PlaneId(108));
  EXPECT_EQ(line.end(0), InputPointId(1003));
  EXPECT_EQ(line.end(1), InputPointId(1005));
}

/// All planes with coefficients -1, 0 and 1 against their determinants, and lines along the axes.
TEST(Point3Table, RefusesPlanesAndLinesWithoutOneCommonPoint) {
  PlaneTable table;
  std::vector<std::array<int, 3>> normals;
  std::vector<PlaneId> planes;
  for (int a = -1; a <= 1; ++a) {
    for (int b = -1; b <= 1; ++b) {
      for (int c = 0; c <= 1; ++c) {
        if (a == 0 && b == 0 && c == 0) continue;
        normals.push_back({a, b, c});
        planes.push_back(plane(table, a, b, c, a + 2 * b - 3));
      }
    }
  }
  Point3Table points(table);
  std::size_t made = 0;
  for (std::size_t i = 0; i < planes.size(); ++i) {
    for (std::size_t j = 0; j < planes.size(); ++j) {
      const std::size_t k = (i + 2 * j + 5) % planes.size();
      const auto &p = normals[i], &q = normals[j], &r = normals[k];
      const int det = p[0] * (q[1] * r[2] - q[2] * r[1]) - p[1] * (q[0] * r[2] - q[2] * r[0]) +
                      p[2] * (q[0] * r[1] - q[1] * r[0]);
      EXPECT_EQ(points.add(planes[i], planes[j], planes[k]).is_valid(), det != 0);
      made += det != 0 ? 1 : 0;
      EXPECT_EQ(points.size(), made);
    }
  }
  const InputPointId o = table.add_point({3, 0, 0}), p = table.add_point({3, 2, 0});
  for (std::size_t i = 0; i < planes.size(); ++i) {
    EXPECT_EQ(points.add(o, p, planes[i]).is_valid(), normals[i][1] != 0);
  }
}

/// In any floating-point mode, also where planes are all but parallel; and none is wide.
TEST(Point3Table, BoxesHoldTheirPoints) {
  cases::Random random(22);
  std::size_t used = 0, nearest = 0;
  for (std::size_t i = 0; i < 600 && !::testing::Test::HasFailure(); ++i) {
    const cases::Case c = cases::any(random);
    std::optional<PlaneTable> table;
    std::optional<Point3Table> points;
    std::array<SpacePoint, 2> ids;
    {
      const testing_environment::Scope scope(testing_environment::kSettings[i % 8]);
      table.emplace();
      table->add_points(c.corners);
      std::array<PlaneId, 4> p;
      for (std::uint32_t k = 0; k < 4; ++k) {
        p[k] = id_of(
            table->intern(InputPointId(3 * k), InputPointId(3 * k + 1), InputPointId(3 * k + 2)));
      }
      if (std::ranges::any_of(p, [](PlaneId id) { return !id.is_valid(); })) continue;
      points.emplace(*table);
      ids = {points->add(p[0], p[1], p[2]), points->add(InputPointId(0), InputPointId(4), p[3])};
    }
    for (const SpacePoint x : ids) {
      if (!x.is_valid()) continue;
      const PointBox box = points->box(x);
      if (!is_finite(box)) continue;
      ++used;
      const RationalPoint3 at = exact(*points, x);
      EXPECT_TRUE(holds(box, at)) << c.family;
      EXPECT_LE(box.radius, kDirectionError * largest(box) + 0x1p-889) << c.family;
      if (!points->is_nearest(x)) continue;
      ++nearest;
      for (std::size_t k = 0; k < 3; ++k) {
        EXPECT_EQ(box.mid[k], nearest_double(coordinates(at)[k])) << c.family;
      }
    }
  }
  EXPECT_GT(used, 500U);
  EXPECT_GT(nearest, 20U);
}

/// Of a point P0 + u R the box tells u, with its signs, and the near box P0.
TEST(Point3Table, BoxesOfTheFrameTellDirections) {
  PlaneTable table;
  const auto frame = table.intern_frame();
  std::mt19937_64 random(5);
  Point3Table points(table);
  std::size_t told = 0;
  for (int round = 0; round < 200; ++round) {
    const auto any = [&] { return static_cast<double>(static_cast<int>(random() % 7) - 3); };
    const PlaneId p = plane(table, any(), any(), any(), any());
    const PlaneId q = plane(table, any(), any(), any(), any());
    const PlaneId far = frame[random() % 6], other = frame[random() % 6];
    const InputPointId a = table.add_point({any(), any(), any()});
    const InputPointId b = table.add_point({any(), any(), any()});
    if (!p.is_valid() || !q.is_valid()) continue;
    for (const SpacePoint x :
         {points.add(far, p, q), points.add(p, other, far), points.add(a, b, far)}) {
      if (!x.is_valid()) continue;
      EXPECT_TRUE(points.depends_on_frame(x));
      const FramedPoint3 parts = exact_parts(points, x);
      const PointBox box = points.box(x), near = points.near_box(x);
      EXPECT_FALSE(is_finite(box));
      if (is_finite(near)) {
        EXPECT_TRUE(holds(near, parts.finite));
      }
      if (!is_far(box)) continue;
      ++told;
      EXPECT_TRUE(holds({box.mid, kDirectionError * largest(box)}, parts.infinite));
      for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_EQ(sign_of(box.mid[i]), sign_of(coordinates(parts.infinite)[i].sign()));
      }
    }
    const SpacePoint near = points.add(a, b, p);
    if (!near.is_valid()) continue;
    EXPECT_FALSE(points.depends_on_frame(near) || points.depends_on_frame(SpacePoint(a)));
    EXPECT_EQ(points.near_box(near).mid, points.box(near).mid);
  }
  EXPECT_GT(told, 200U);
}

TEST(Point3Table, MergedPointsKeepTheirBoxesUnderOtherNames) {
  PlaneTable ours, theirs;
  ours.add_points(std::vector<Point3>{{9, 9, 9}, {8, 7, 6}});
  plane(ours, 5, 1, 2, 3);
  const InputPointId a = theirs.add_point({0, 0, 0}), b = theirs.add_point({1, 2, 5});
  const PlaneId x = plane(theirs, 1, 0, 0, -0.1), y = plane(theirs, 0, 3, 0, -1);
  const PlaneId z = plane(theirs, 0, 0, 1, -0.7);
  Point3Table points(ours), others(theirs);
  const SpacePoint first = points.add({SpacePoint(a).input(), b, PlaneId(0)}, {{1, 2, 3}, 7});
  const std::array<SpacePoint, 3> given = {others.add(x, y, z), others.add(a, b, z),
                                           others.add({x, z, y}, {{4, 5, 6}, 8}, true)};
  const std::vector<PlaneId> map = ours.merge(theirs);
  ASSERT_EQ(points.merge(others, map, 2), 1U);
  ASSERT_EQ(points.size(), 4U);
  EXPECT_EQ(points.box(first).radius, 7);
  for (std::size_t i = 0; i < 3; ++i) {
    const SpacePoint here = SpacePoint::constructed(given[i].index() + 1);
    EXPECT_EQ(exact(points, here), exact(others, given[i]));
    EXPECT_EQ(points.box(here).mid, others.box(given[i]).mid);
    EXPECT_EQ(points.box(here).radius, others.box(given[i]).radius);
    EXPECT_EQ(points.is_nearest(here), others.is_nearest(given[i]));
  }
  EXPECT_TRUE(points.is_nearest(SpacePoint::constructed(3)));
  EXPECT_EQ(points.box(SpacePoint(InputPointId(1))).mid, (std::array<double, 3>{8, 7, 6}));
}

}  // namespace plumb::point3_table_test
