// What a rung may leave to the next one. A filter that is too careful, or a narrow rung that passes
// on what it could hold, gives no wrong sign; it is only slow, and no test of signs sees it.
// Filters must decide what is far from degenerate, at every scale within their gates; Small and
// Exact what their contracts name.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>

#include "plumb/predicates/input_predicates.h"
#include "plumb/predicates/plane_signs.h"
#include "plumb/predicates/point3_signs.h"
#include "plumb/predicates/point_table2.h"
#include "plumb/predicates/space/plane_row.h"
#include "plumb/predicates/space/point3_table.h"
#include "predicate_oracle.h"

namespace plumb::test::rung_reach_test {
namespace {

/// Points near given ones, times 2^scale.
class Moved {
 public:
  Moved(std::uint64_t seed, int scale) : random_(seed), scale_(scale) {}

  double unit() const { return std::ldexp(1, scale_); }

  double operator()(double v) {
    return std::ldexp(v + std::uniform_real_distribution<double>(-0.05, 0.05)(random_), scale_);
  }
  Point2 operator()(const Point2& p) {
    const double x = (*this)(p.x);
    return {x, (*this)(p.y)};
  }
  Point3 operator()(const Point3& p) {
    const double x = (*this)(p.x);
    const double y = (*this)(p.y);
    return {x, y, (*this)(p.z)};
  }

 private:
  std::mt19937_64 random_;
  int scale_;
};

template <class Check>
void at_scales(int least, int greatest, const Check& check) {
  for (const int scale :
       {least, least + 1, least / 2, -1, 0, 1, greatest / 2, greatest - 1, greatest}) {
    SCOPED_TRACE("scale 2^" + std::to_string(scale));
    for (std::uint64_t seed = 0; seed < 20; ++seed) check(Moved(seed, scale));
  }
}

TEST(Filters, DecideInputPointsUpToTheirGates) {
  at_scales(-335, 337, [](Moved m) {
    const Point2 a = m(Point2{0, 0}), b = m(Point2{1, 0}), c = m(Point2{0, 1});
    EXPECT_EQ(rung::orient2d_filter(a, b, c), FilteredSign::Positive);
    EXPECT_EQ(rung::cross_sign_filter(a, b, a, c), FilteredSign::Positive);
    PointTable2 t;
    for (const Point2& p : {a, b}) t.push_back(p);
    EXPECT_EQ(rung::compare_xy_filter(t, 0, 1), FilteredSign::Negative);
    EXPECT_EQ(rung::compare_xy_filter(t, 1, 0), FilteredSign::Positive);
  });
  at_scales(-203, 198, [](Moved m) {
    EXPECT_EQ(rung::orient3d_filter(m(Point3{1, 0, 0}), m(Point3{0, 1, 0}), m(Point3{0, 0, 1}),
                                    m(Point3{})),
              FilteredSign::Positive);
  });
  at_scales(-143, 141, [](Moved m) {
    EXPECT_EQ(
        rung::incircle_filter(m(Point2{1, 0}), m(Point2{0, 1}), m(Point2{-1, 0}), m(Point2{0, 0})),
        FilteredSign::Positive);
  });
  at_scales(-110, 109, [](Moved m) {
    EXPECT_NE(rung::insphere_filter(m(Point3{1, 0, 0}), m(Point3{0, 1, 0}), m(Point3{0, 0, 1}),
                                    m(Point3{-1, 0, 0}), m(Point3{})),
              FilteredSign::Unsure);
  });
}

TEST(Filters, DecideFractions) {
  at_scales(-295, 300, [](Moved m) {
    PointTable2 t;
    for (const Point2 p : {Point2{0, 0}, Point2{1, 0}, Point2{0, 1}}) {
      const Point2 q = m(p);
      t.push_back(Rational(q.x) / 3, Rational(q.y) / 3);
    }
    EXPECT_EQ(rung::orient2d_filter(t, 0, 1, 2), FilteredSign::Positive);
    EXPECT_EQ(rung::cross_sign_filter(t, 0, 1, 0, 2), FilteredSign::Positive);
  });
}

/// Bounds of a crossing of lines that meet at a right angle: a few units in the last place.
TEST(Filters, BoundCrossingsClosely) {
  at_scales(-250, 199, [](Moved m) {
    PointTable2 t;
    for (const Point2 p : {Point2{0.3, 0.3}, Point2{0.7, 0.7}, Point2{0.3, 0.7}, Point2{0.7, 0.3},
                           Point2{0.25, -0.5}}) {
      t.push_back(m(p));
    }
    const Crossing2 p = make_crossing(t, 0, 1, 2, 3), q = make_crossing(t, 0, 4, 2, 3);
    EXPECT_LE(p.radius, 0x1p-45 * m.unit());
    EXPECT_EQ(rung::compare_xy_filter(t, p, 4), FilteredSign::Positive);
    EXPECT_EQ(rung::compare_xy_filter(p, q), FilteredSign::Positive);
    EXPECT_EQ(rung::orient2d_filter(t, 2, 4, p), FilteredSign::Positive);
  });
}

struct Corner {
  PlaneTable planes;
  std::array<PlaneId, 4> sides{};
  explicit Corner(Moved& m) {
    const auto o = planes.add_point(m(Point3{0.1, 0.1, 0.1})),
               x = planes.add_point(m(Point3{1, 0, 0}));
    const auto y = planes.add_point(m(Point3{0, 1, 0})), z = planes.add_point(m(Point3{0, 0, 1}));
    sides = {planes.intern(o, x, y).plane(), planes.intern(o, y, z).plane(),
             planes.intern(o, z, x).plane(), planes.intern(x, y, z).plane()};
  }
};

TEST(Filters, DecidePlanesAndBoundThemClosely) {
  at_scales(-290, 299, [](Moved m) {
    const FastRow row = fast_row(m(Point3{1, 0, 0}), m(Point3{0, 1, 0}), m(Point3{0, 0, 1}));
    ASSERT_TRUE(row.is_good);
    EXPECT_LE(row.row.normal_error, 0x1p-46F);
    if (m.unit() > 0x1p-70 && m.unit() < 0x1p80) {  // within those of floats
      EXPECT_LE(row.row.offset_error, 0x1p-44 * m.unit());
    }
  });
  at_scales(-70, 90, [](Moved m) {
    const Corner c(m);
    const auto row = [&](std::size_t i) { return c.planes.row(c.sides[i]); };
    EXPECT_NE(rung::det3_filter(row(0), row(1), row(2)), FilteredSign::Unsure);
    EXPECT_NE(rung::det4_filter(row(0), row(1), row(2), row(3)), FilteredSign::Unsure);
    EXPECT_NE(rung::minor_filter(row(0), row(1), 0), FilteredSign::Unsure);
  });
}

TEST(Filters, DecidePointsOfSpaceAndBoundThemClosely) {
  at_scales(-70, 90, [](Moved m) {
    Corner c(m);
    const auto a = c.planes.add_point(m(Point3{-1, -1, -1})),
               b = c.planes.add_point(m(Point3{1, 1, 1}));
    Point3Table points(c.planes);
    const SpacePoint meeting = points.add(c.sides[0], c.sides[1], c.sides[2]);
    const SpacePoint stab = points.add(a, b, c.sides[3]);
    for (const SpacePoint x : {meeting, stab}) EXPECT_LE(points.box(x).radius, 0x1p-38 * m.unit());
    EXPECT_NE(rung::side_filter(points.box(meeting), c.planes.row(c.sides[3])),
              FilteredSign::Unsure);
    EXPECT_NE(rung::side_filter(points.box(stab), c.planes.row(c.sides[0])), FilteredSign::Unsure);
    EXPECT_EQ(rung::compare_axis_filter(points.box(stab), points.box(meeting), 0),
              FilteredSign::Positive);
  });
}

/// Integers below 2^bits, on the grid of whole numbers and as wide as that.
template <class Next>
Point2 wide2(Next& next) {
  const double x = next();
  return {x, next()};
}
template <class Next>
Point3 wide3(Next& next) {
  const double x = next();
  const double y = next();
  return {x, y, next()};
}

/// "Unsure exactly when the coordinates need more than 125 bits" (input_predicates.h).
TEST(Rungs, ExactDecidesExactlyWhatFits) {
  for (const int bits : {3, 20, 21, 30, 31, 60, 61, 62, 63, 90, 124, 125, 126, 127, 200}) {
    SCOPED_TRACE(bits);
    std::mt19937_64 random(20261122);
    bool top = false;
    // Odd small numbers and full-width ones in turn: the common grid is that of whole numbers.
    const auto next = [&] {
      top = !top;
      const double low = static_cast<double>(random() % 3) * 2 + 1;
      return top ? low : std::ldexp(1, bits - 1) + (bits < 50 ? low - 1 : 0);
    };
    const bool fits = bits <= 125;
    for (int i = 0; i < 20; ++i) {
      const Point2 a = wide2(next), b{a.y, a.x}, c = wide2(next), d{c.y, c.x};
      EXPECT_EQ(is_decided(rung::orient2d_exact(a, b, c)), fits);
      EXPECT_EQ(is_decided(rung::cross_sign_exact(a, b, c, d)), fits);
      EXPECT_EQ(is_decided(rung::incircle_exact(a, b, c, d)), fits);
      const Point3 p{a.x, a.y, a.x}, q{b.x, b.y, b.x}, r{c.x, c.y, c.y}, s = wide3(next),
                                                                         t = wide3(next);
      EXPECT_EQ(is_decided(rung::orient3d_exact(p, q, r, s)), fits);
      EXPECT_EQ(is_decided(rung::insphere_exact(p, q, r, s, t)), fits);
    }
  }
}

/// At every scale, where integers are made of doubles and where they are not; coplanar points,
/// nearly coplanar ones and others.
TEST(Rungs, ExactIsTheSameOnAKnownGrid) {
  std::mt19937_64 random(20261124);
  for (const int scale : {-1074, -1001, -1000, -999, -500, 0, 7, 900, 963}) {
    for (const int bits : {1, 20, 50, 59, 60, 61, 70, 100}) {
      if (scale + bits > 1020) continue;
      SCOPED_TRACE(::testing::Message() << scale << ' ' << bits);
      const auto next = [&] {
        const int up =
            std::max(0, bits - 52);  // the lowest of 53 bits is on the grid, now and then
        const std::uint64_t top = random() >> (64 - std::min(bits, 52));
        const double v = std::ldexp(static_cast<double>(top), random() % 2 == 0 ? up : 0);
        return std::ldexp(random() % 2 == 0 ? v : -v, scale);
      };
      for (int i = 0; i < 60; ++i) {
        const Point3 a = wide3(next), b = wide3(next), c = wide3(next);
        Point3 d =
            i % 3 == 0 ? wide3(next) : Point3{a.x + b.x - c.x, a.y + b.y - c.y, a.z + b.z - c.z};
        if (i % 3 == 2) d.z += std::ldexp(1, scale);
        Grid grid{a.x, a.y, a.z, b.x, b.y, b.z, c.x, c.y, c.z};
        grid.add(Grid{d.x, d.y, d.z});
        EXPECT_EQ(rung::orient3d_exact(grid, a, b, c, d), rung::orient3d_exact(a, b, c, d));
      }
    }
  }
}

TEST(Rungs, SmallDecidesSmallIntegers) {
  std::mt19937_64 random(20261122);
  const auto next = [&] { return static_cast<double>(random() % 201) - 100; };
  for (int i = 0; i < 200; ++i) {
    const Point2 a = wide2(next), b = wide2(next), c = wide2(next), d = wide2(next);
    EXPECT_TRUE(is_decided(rung::orient2d_small(a, b, c)));
    EXPECT_TRUE(is_decided(rung::cross_sign_small(a, b, c, d)));
    EXPECT_TRUE(is_decided(rung::incircle_small(a, b, c, d)));
    const Point3 p = wide3(next), q = wide3(next), r = wide3(next), s = wide3(next),
                 t = wide3(next);
    EXPECT_TRUE(is_decided(rung::orient3d_small(p, q, r, s)));
    EXPECT_TRUE(is_decided(rung::insphere_small(p, q, r, s, t)));
  }
  // At the limits: coordinates below 2^51, a permanent of 2^52 (2^26 2^26), and one unit beyond.
  const double far = 0x1p51 - 1;
  EXPECT_TRUE(is_decided(rung::orient2d_small({far, 1}, {far - 1, 0}, {far, 0})));
  EXPECT_FALSE(is_decided(rung::orient2d_small({0x1p52, 1}, {0x1p52 - 1, 0}, {0x1p52, 0})));
  EXPECT_TRUE(is_decided(rung::orient2d_small({0x1p26, 0}, {0, 0x1p26}, {0, 0})));
  EXPECT_FALSE(is_decided(rung::orient2d_small({0x1p26 + 1, 0}, {0, 0x1p26}, {0, 0})));
}

TEST(Rungs, ExactDecidesCrossingsThatFit) {
  for (const int bits : {3, 60, 62, 63, 125, 126, 127, 128}) {
    SCOPED_TRACE(bits);
    const double w = std::ldexp(1, bits - 1);
    PointTable2 t;
    for (const Point2 p : {Point2{1, 1}, Point2{w, w}, Point2{1, w}, Point2{w, 1}, Point2{w, 3}})
      t.push_back(p);
    const Crossing2 p = make_crossing(t, 0, 1, 2, 3), q = make_crossing(t, 0, 4, 2, 3);
    const bool fits = bits <= 126;
    EXPECT_EQ(is_decided(rung::compare_xy_exact(t, p, 4)), fits);
    EXPECT_EQ(is_decided(rung::compare_xy_exact(t, p, q)), fits);
    EXPECT_EQ(is_decided(rung::orient2d_exact(t, 2, 4, p)), fits);
  }
}

}  // namespace
}  // namespace plumb::test::rung_reach_test
