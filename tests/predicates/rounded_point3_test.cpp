// Points rounded to the nearest doubles, against rationals.
#include "plumb/predicates/space/rounded_point3.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cfenv>
#include <cmath>
#include <cstdint>
#include <optional>
#include <random>
#include <utility>
#include <vector>

#include "float_environment.h"
#include "plumb/predicates/plane_signs.h"
#include "plumb/predicates/point3_signs.h"
#include "plumb/predicates/space/point3_exact.h"
#include "plumb/predicates/space/point3_table.h"

namespace plumb::rounded_point3_test {
namespace {

/// What the filter tells is what exact numbers say; of points in general position it tells nearly
/// all, in no rounding mode but one.
TEST(RoundedPoint3, FilterTellsWhatIsClear) {
  std::mt19937_64 random(31);
  std::uniform_real_distribution<double> unit(-1, 1);
  for (const double scale : {1.0, 0x1p-12, 0x1p30, 0x1p58}) {
    std::size_t told = 0;
    for (std::size_t i = 0; i < 300; ++i) {
      PlaneTable table;
      std::array<PlaneId, 3> planes;
      for (PlaneId& plane : planes) {
        std::array<Point3, 3> corners;
        for (Point3& p : corners)
          p = {scale * unit(random), scale * unit(random), scale * unit(random)};
        if (i % 3 == 1 && &plane == planes.data()) corners[1].x = corners[2].x = corners[0].x;
        const InputPointId first = table.add_points(corners);
        plane =
            table.intern(first, InputPointId(first.value() + 1), InputPointId(first.value() + 2))
                .plane();
      }
      Point3Table points(table);
      const SpacePoint x = points.add(planes[0], planes[1], planes[2]);
      ASSERT_TRUE(x.is_valid());
      const RoundedPoint3 exactly = rung::rounded_exact(points, x);
      for (const auto& setting : testing_environment::kSettings) {
        std::optional<RoundedPoint3> clear;
        {
          testing_environment::Scope scope(setting);
          clear = rung::rounded_filter(points, x);
        }
        if (setting.rounding != FE_TONEAREST) {
          EXPECT_FALSE(clear) << setting.name;
          continue;
        }
        if (!clear) continue;
        ++told;
        EXPECT_EQ(clear->at, exactly.at);
        EXPECT_EQ(clear->is_exact, exactly.is_exact);
      }
    }
    EXPECT_GE(told, 2U * 295U) << scale;
  }
}

/// Where planes are all but parallel and the filter knows little: fixed widths tell nearly all, of
/// lines too.
TEST(RoundedPoint3, FixedWidthsTellOfNearlyParallelPlanes) {
  std::mt19937_64 random(32);
  std::uniform_real_distribution<double> unit(-1, 1);
  std::size_t told = 0, all = 0;
  for (std::size_t i = 0; i < 300; ++i) {
    PlaneTable table;
    const auto any = [&] { return Point3{unit(random), unit(random), unit(random)}; };
    const std::array<Point3, 3> corners{any(), any(), any()};
    std::array<PlaneId, 3> planes;
    InputPointId first;
    for (PlaneId& plane : planes) {
      std::array<Point3, 3> turned = corners;
      for (Point3& p : turned) p.z += 1e-12 * unit(random);
      first = table.add_points(turned);
      plane = table.intern(first, InputPointId(first.value() + 1), InputPointId(first.value() + 2))
                  .plane();
    }
    Point3Table points(table);
    for (const SpacePoint x : {points.add(planes[0], planes[1], planes[2]),
                               points.add(first, InputPointId(first.value() + 1), planes[0])}) {
      if (!x.is_valid()) continue;
      ++all;
      const auto clear = rung::rounded_fixed(points, x);
      if (!clear) continue;
      ++told;
      const RoundedPoint3 exactly = rung::rounded_exact(points, x);
      EXPECT_EQ(clear->at, exactly.at);
      EXPECT_FALSE(clear->is_exact);
    }
  }
  EXPECT_GT(all, 590U);
  EXPECT_GE(told, all - 5);
}

/// The point of the planes of two triangles with a common edge and of a third one, which may be
/// nearly parallel to the first.
struct EdgeAndPlane {
  std::array<std::array<Point3, 3>, 3> corners;
  PlaneTable table;
  InputPointId first;
  std::array<PlaneId, 3> planes;

  EdgeAndPlane(std::mt19937_64& random, double scale, double apart, bool is_along_x) {
    std::uniform_real_distribution<double> unit(-1, 1);
    const auto any = [&] {
      return Point3{scale * unit(random), scale * unit(random), scale * unit(random)};
    };
    Point3 a = any(), b = any();
    if (!is_along_x) b.x = a.x;
    corners[0] = {a, b, any()};
    corners[1] = {any(), b, a};
    corners[2] = corners[0];
    for (Point3& p : corners[2]) p.z += scale * apart * unit(random);
    const std::vector<Point3> points{
        a, b, corners[0][2], corners[1][0], corners[2][0], corners[2][1], corners[2][2]};
    first = table.add_points(points);
    planes = {plane(0, 1, 2), plane(3, 1, 0), plane(4, 5, 6)};
  }
  InputPointId point(std::uint32_t i) const { return InputPointId(first.value() + i); }
  PlaneId plane(std::uint32_t i, std::uint32_t j, std::uint32_t k) {
    return table.intern(point(i), point(j), point(k)).plane();
  }
};

/// Boxes that doubles do not give are around the nearest doubles, which rounded() then takes from
/// there: nearly always, in the one rounding mode that allows it.
TEST(RoundedPoint3, OfNearlyParallelPlanesIsKnownFromTheStart) {
  std::mt19937_64 random(35);
  std::size_t nearest = 0, all = 0;
  for (int i = 0; i < 300; ++i) {
    EdgeAndPlane e(random, 1, 1e-12, i % 3 != 0);
    for (const auto& setting : testing_environment::kSettings) {
      Point3Table points(e.table);
      SpacePoint x;
      RoundedPoint3 near;
      {
        testing_environment::Scope scope(setting);
        x = points.add(e.planes[0], e.planes[1], e.planes[2]);
        near = rounded(points, x);
      }
      const RoundedPoint3 exactly = rung::rounded_exact(points, x);
      EXPECT_EQ(near.at, exactly.at);
      EXPECT_EQ(near.is_exact, exactly.is_exact);
      const PointBox box = points.box(x);
      const RationalPoint3 at = exact(points, x);
      for (const auto& [mid, c] :
           {std::pair(box.mid[0], at.x), {box.mid[1], at.y}, {box.mid[2], at.z}}) {
        EXPECT_LE(abs(Rational(c - Rational(mid))), Rational(box.radius));
      }
      if (setting.rounding != FE_TONEAREST) {
        EXPECT_FALSE(points.is_nearest(x)) << setting.name;
        continue;
      }
      ++all;
      if (!points.is_nearest(x)) continue;
      ++nearest;
      EXPECT_EQ((Point3{box.mid[0], box.mid[1], box.mid[2]}), exactly.at) << setting.name;
      Point3Table other(e.table);
      other.add(points.source(x), box);
      EXPECT_FALSE(other.is_nearest(SpacePoint::constructed(0)));
      const std::vector<PlaneId> same = [&] {
        std::vector<PlaneId> ids;
        for (std::uint32_t p = 0; p < e.table.size(); ++p) ids.emplace_back(p);
        return ids;
      }();
      EXPECT_EQ(other.merge(points, same, 0), 1U);
      EXPECT_TRUE(other.is_nearest(SpacePoint::constructed(1)));
    }
  }
  EXPECT_GE(nearest, all - 5);
}

/// Walls at doubles, nearly parallel ones among them: the box is the point.
TEST(RoundedPoint3, OfAPointAtDoublesHasABoxWithoutWidth) {
  PlaneTable table;
  const InputPointId p =
      table.add_points(std::vector<Point3>{{0.1, 0, 0},
                                           {0.1, 1, 0},
                                           {0.1, 0, 1},  // x = 0.1
                                           {0, 0.3, 0},
                                           {1, 0.3, 0},
                                           {0, 0.3, 1},  // y = 0.3
                                           {0, 0, 0.7},
                                           {1, 0, 0.7},
                                           {0.1, 0x1p-40, 0.7}});  // z = 0.7, by a needle
  const auto plane = [&](std::uint32_t i) {
    return table
        .intern(InputPointId(p.value() + i), InputPointId(p.value() + i + 1),
                InputPointId(p.value() + i + 2))
        .plane();
  };
  Point3Table points(table);
  const auto rounded_box = exact3::rounded_on_line(
      table, PointSource(p, InputPointId(p.value() + 1), plane(3)));  // along x = 0.1, z = 0
  ASSERT_TRUE(rounded_box);
  EXPECT_EQ(rounded_box->at, (Point3{0.1, 0.3, 0}));
  EXPECT_TRUE(rounded_box->is_exact);
  const SpacePoint x = points.add(plane(0), plane(3), plane(6));
  const RoundedPoint3 near = rounded(points, x);
  EXPECT_EQ(near.at, (Point3{0.1, 0.3, 0.7}));
  EXPECT_TRUE(near.is_exact);
}

/// Numbers that compare as zero where subnormal ones are flushed, and are not.
TEST(RoundedPoint3, TellsSubnormalNumbersApart) {
  constexpr double t = 0x1p-1074;
  const std::array<std::array<Point3, 3>, 3> level_and_wall{
      {{Point3{0, 0, 0}, {t, t, 1}, {2 * t, 2 * t, 1}},
       {Point3{3, 0, 0}, {1, 1, 0}, {1, 1, 1}},
       {Point3{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}}};
  const std::array<std::array<Point3, 3>, 3> walls{{{Point3{t, 0, 0}, {t, 1, 0}, {t, 0, 1}},
                                                    {Point3{0, 2, 0}, {1, 2, 0}, {0, 2, 1}},
                                                    {Point3{0, 0, 3}, {1, 0, 3}, {0, 1, 3}}}};
  const std::array<std::array<Point3, 3>, 3> tiny{
      {{Point3{t, 0, 0}, {t, t, 0}, {t, 0, t}},
       {Point3{0, 2 * t, 0}, {t, 2 * t, 0}, {0, 2 * t, t}},
       {Point3{0, 0, 3 * t}, {t, 0, 3 * t}, {0, t, 3 * t}}}};
  for (const auto& [corners, expected] :
       {std::pair(level_and_wall, Point3{1, 1, 0}), std::pair(walls, Point3{t, 2, 3}),
        std::pair(tiny, Point3{t, 2 * t, 3 * t})}) {
    PlaneTable table;
    std::array<PlaneId, 3> planes;
    for (std::size_t i = 0; i < 3; ++i) {
      const InputPointId first = table.add_points(corners[i]);
      planes[i] =
          table.intern(first, InputPointId(first.value() + 1), InputPointId(first.value() + 2))
              .plane();
    }
    Point3Table points(table);
    const SpacePoint x = points.add(planes[0], planes[1], planes[2]);
    ASSERT_TRUE(x.is_valid());
    for (const auto& setting : testing_environment::kSettings) {
      RoundedPoint3 near;
      {
        testing_environment::Scope scope(setting);
        near = rounded(points, x);
      }
      EXPECT_EQ(near.at, expected) << setting.name;
      EXPECT_TRUE(near.is_exact) << setting.name;
    }
  }
}

/// The x of a point at or next to a double, or to the middle of two, by 2^-j of their distance.
TEST(RoundedPoint3, NextToTiesAndToDoubles) {
  constexpr double kLow = 0x1p52;  // doubles are 1 apart
  std::size_t clear_ones = 0;
  for (int j = 2; j <= 59; ++j) {
    const double whole = std::ldexp(1.0, j), half = whole / 2;
    for (const double y : {half - 1, half, half + 1, 1.0, whole - 1}) {
      for (const double step : {1.0, 3.0}) {
        PlaneTable table;
        const auto plane = [&table](const std::array<Point3, 3>& corners) {
          const InputPointId first = table.add_points(corners);
          return table
              .intern(first, InputPointId(first.value() + 1), InputPointId(first.value() + 2))
              .plane();
        };
        // x = kLow + step y / whole in the plane y, at z = 0.
        const PlaneId level = plane({Point3{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
        const PlaneId wall = plane({Point3{0, y, 0}, {1, y, 0}, {0, y, 1}});
        const PlaneId slope = plane({Point3{kLow, 0, 0}, {kLow + step, whole, 0}, {kLow, 0, 1}});
        Point3Table points(table);
        const SpacePoint x = points.add(level, wall, slope);
        ASSERT_TRUE(x.is_valid());
        const RoundedPoint3 near = rounded(points, x), exactly = rung::rounded_exact(points, x);
        EXPECT_EQ(near.at, exactly.at) << j << " " << y << " " << step;
        EXPECT_EQ(near.is_exact, exactly.is_exact) << j << " " << y << " " << step;
        const auto in_fixed = rung::rounded_fixed(points, x);
        if (y == half || j <= 40) {
          EXPECT_EQ(in_fixed.has_value(), y != half) << j << " " << y << " " << step;
        }
        if (in_fixed) {
          EXPECT_EQ(in_fixed->at, exactly.at) << j << " " << y << " " << step;
          EXPECT_FALSE(in_fixed->is_exact);
        }
        const bool is_clear = rung::rounded_filter(points, x).has_value();
        if (y == half || j <= 30) {
          EXPECT_EQ(is_clear, y != half) << j << " " << y << " " << step;
        }
        clear_ones += is_clear ? 1 : 0;
      }
    }
  }
  EXPECT_GT(clear_ones, 200U);
}

/// Coordinates that definitions show need no exact arithmetic: on an axis plane, whose equation is
/// stored, and on an edge along an axis of two walls that have one input point in common. If the
/// walls have none, their common coordinates are fractions, and the filter must not take those of a
/// corner.
TEST(RoundedPoint3, FilterKnowsCoordinatesThatDefinitionsShow) {
  std::mt19937_64 random(33);
  std::uniform_real_distribution<double> unit(-1, 1);
  std::size_t told = 0;
  for (std::size_t i = 0; i < 300; ++i) {
    const std::size_t axis = i % 3;
    // Coordinates u and v across the axis, and w along it.
    const auto place = [axis](double u, double v, double w) {
      std::array<double, 3> c{};
      c[axis] = w;
      c[(axis + 1) % 3] = u;
      c[(axis + 2) % 3] = v;
      return Point3{c[0], c[1], c[2]};
    };
    const auto any = [&] { return place(unit(random), unit(random), unit(random)); };
    PlaneTable table;
    const auto plane = [&table](InputPointId a, InputPointId b, InputPointId c) {
      return table.intern(a, b, c).plane();
    };
    const auto point = [&table](const Point3& p) { return table.add_point(p); };
    const double u = unit(random), v = unit(random);
    const auto low = point(place(u, v, -1)), slope_a = point(any()), slope_b = point(any());
    const PlaneId slope = plane(slope_a, slope_b, point(any()));
    const auto wall = [&](InputPointId corner, const Point3& foot) {
      Point3 top = foot;
      (axis == 0 ? top.x : axis == 1 ? top.y : top.z) += 1;
      return plane(corner, point(foot), point(top));
    };
    const PlaneId first = wall(low, any()), second = wall(low, any()),
                  apart = wall(point(any()), any());
    const PlaneId level =
        table.intern(axis == 0 ? 1.0 : 0.0, axis == 1 ? 1.0 : 0.0, axis == 2 ? 1.0 : 0.0, 0.0)
            .plane();
    Point3Table points(table);
    const std::array<std::array<PlaneId, 3>, 4> sources{std::array{first, second, slope},
                                                        {first, slope, level},
                                                        {apart, first, slope},
                                                        {slope, apart, level}};
    for (const auto& [p, q, r] : sources) {
      const SpacePoint x = points.add(p, q, r);
      ASSERT_TRUE(x.is_valid());
      const RoundedPoint3 exactly = rung::rounded_exact(points, x);
      EXPECT_EQ(rounded(points, x).at, exactly.at);
      const auto clear = rung::rounded_filter(points, x);
      if (!clear) continue;
      ++told;
      EXPECT_EQ(clear->at, exactly.at);
      EXPECT_EQ(clear->is_exact, exactly.is_exact);
    }
    // Along the edge of the walls, two coordinates are those of the common corner.
    const SpacePoint x = points.add(first, second, slope), y = points.add(first, second, level);
    EXPECT_EQ(compare_axis(points, x, y, (axis + 1) % 3), Sign::Zero);
    EXPECT_EQ(compare_axis(points, x, y, (axis + 2) % 3), Sign::Zero);
  }
  EXPECT_GE(told, 4U * 290U);
}

TEST(RoundedPoint3, IsExactOnlyIfAllCoordinatesAre) {
  for (std::size_t inexact = 0; inexact < 4; ++inexact) {
    PlaneTable table;
    std::array<PlaneId, 3> planes;
    for (std::size_t i = 0; i < 3; ++i) {
      std::array<Rational, 3> n{0, 0, 0};
      n[i] = i == inexact ? 3 : 4;
      planes[i] = table.intern(n[0], n[1], n[2], Rational(-1)).plane();
    }
    Point3Table points(table);
    const RoundedPoint3 near = rounded(points, points.add(planes[0], planes[1], planes[2]));
    EXPECT_EQ(near.is_exact, inexact == 3);
    EXPECT_EQ(near.at.x, inexact == 0 ? 1.0 / 3 : 0.25);
    EXPECT_EQ(near.at.y, inexact == 1 ? 1.0 / 3 : 0.25);
    EXPECT_EQ(near.at.z, inexact == 2 ? 1.0 / 3 : 0.25);
  }
}

}  // namespace
}  // namespace plumb::rounded_point3_test
