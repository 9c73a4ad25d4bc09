// Every sign about planes and constructed points, every rung of it, in every floating-point
// environment, against cpp_int.
#include "plumb/predicates/point3_signs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <iostream>
#include <optional>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "fixed_rungs.h"
#include "float_environment.h"
#include "generate/space_cases.h"
#include "generate/test_share.h"
#include "plumb/predicates/plane_signs.h"
#include "plumb/predicates/rounding.h"
#include "plumb/predicates/space/point3_table.h"
#include "plumb/predicates/space/rounded_point3.h"
#include "space_oracle.h"

namespace plumb::point3_signs_test {
namespace {

using fixed_rungs::Fixed3;
using oracle::Int;
using oracle::Row;
using oracle::sgn;

constexpr auto kModes = testing_environment::kSettings;

/// The answers of all rungs of one question; they are taken in the changed environment and judged
/// outside of it.
struct Answers {
  const char* question;
  FilteredSign filter = FilteredSign::Unsure;
  Fixed3 fixed = {FilteredSign::Unsure, FilteredSign::Unsure, FilteredSign::Unsure};
  Sign big = Sign::Zero;
  Sign ladder = Sign::Zero;
};

/// What the rungs said, over the whole run: filters must decide, and so must every width.
struct Shares {
  std::uint64_t signs = 0, filter = 0;
  std::array<std::uint64_t, 3> fixed = {};
};

std::string text(const cases::Case& c) {
  std::string s = c.family;
  char buffer[100];
  for (const Point3& p : c.corners) {
    std::snprintf(buffer, sizeof buffer, " (%a %a %a)", p.x, p.y, p.z);
    s += buffer;
  }
  return s;
}

bool agree(const Answers& a, int expected, const cases::Case& c, Shares& shares) {
  ++shares.signs;
  const auto sign = static_cast<Sign>(expected);
  bool right = a.big == sign && a.ladder == sign;
  right &= !is_decided(a.filter) || decided(a.filter) == sign;
  shares.filter += is_decided(a.filter) ? 1 : 0;
  for (std::size_t i = 0; i < 3; ++i) {
    right &= !is_decided(a.fixed[i]) || decided(a.fixed[i]) == sign;
    shares.fixed[i] += is_decided(a.fixed[i]) ? 1 : 0;
  }
  EXPECT_TRUE(right) << a.question << ": expected " << expected << ", ladder "
                     << static_cast<int>(a.ladder) << ", big " << static_cast<int>(a.big)
                     << ", filter " << static_cast<int>(a.filter) << "; " << text(c);
  return right;
}

Answers det3_answers(const PlaneTable& t, PlaneId p, PlaneId q, PlaneId r) {
  return {"det3", rung::det3_filter(t.row(p), t.row(q), t.row(r)), fixed_rungs::det3(t, p, q, r),
          rung::det3_big(t, p, q, r), det3_sign(t, p, q, r)};
}

Answers det4_answers(const PlaneTable& t, PlaneId p, PlaneId q, PlaneId r, PlaneId s) {
  return {"det4", rung::det4_filter(t.row(p), t.row(q), t.row(r), t.row(s)),
          fixed_rungs::det4(t, p, q, r, s), rung::det4_big(t, p, q, r, s),
          det4_sign(t, p, q, r, s)};
}

Answers minor_answers(const PlaneTable& t, PlaneId p, PlaneId q, std::size_t axis) {
  return {"minor", rung::minor_filter(t.row(p), t.row(q), axis), fixed_rungs::minor(t, p, q, axis),
          rung::minor_big(t, p, q, axis), minor_sign(t, p, q, axis)};
}

Answers side_answers(const Point3Table& t, SpacePoint x, PlaneId p) {
  return {"side", rung::side_filter(t.box(x), t.planes().row(p)), fixed_rungs::side(t, x, p),
          rung::side_big(t, x, p), side(t, x, p)};
}

Answers axis_answers(const Point3Table& t, SpacePoint x, SpacePoint y, std::size_t axis) {
  return {"compare_axis", rung::compare_axis_filter(t.box(x), t.box(y), axis),
          fixed_rungs::compare_axis(t, x, y, axis), rung::compare_axis_big(t, x, y, axis),
          compare_axis(t, x, y, axis)};
}

/// A case with its planes and points, here and in the oracle (on the grid of all corners).
struct World {
  explicit World(const cases::Case& c)
      : unit(oracle::unit_of({c.corners.begin(), c.corners.end()})) {
    for (std::size_t i = 0; i < 12; ++i) corner[i] = oracle::point_row(c.corners[i], unit);
    for (std::size_t i = 0; i < 4; ++i) {
      row[i] = oracle::canonical(
          oracle::plane_through(corner[3 * i], corner[3 * i + 1], corner[3 * i + 2]));
    }
  }
  int unit;
  std::array<Row, 12> corner;
  std::array<Row, 4> row;
};

struct Built {
  explicit Built(const cases::Case& c) {
    table.add_points(c.corners);
    for (std::size_t i = 0; i < 4; ++i) {
      plane[i] =
          table.intern(InputPointId(3 * i), InputPointId(3 * i + 1), InputPointId(3 * i + 2));
    }
  }
  bool has_all_planes() const {
    return std::all_of(plane.begin(), plane.end(), [](OrientedPlane p) { return p.is_valid(); });
  }
  PlaneId id(std::size_t i) const { return plane[i].plane(); }
  PlaneTable table;
  std::array<OrientedPlane, 4> plane;
};

/// The signs about planes. The rows here and in the oracle are both canonical, so equal up to a
/// positive factor.
bool check_planes(const cases::Case& c, const World& w, const Built& b,
                  testing_environment::Setting mode, std::size_t axis, Shares& shares) {
  std::array<Answers, 3> got;
  Sign order, turn, swapped;
  {
    testing_environment::Scope scope(mode);
    got = {det3_answers(b.table, b.id(0), b.id(1), b.id(2)),
           det4_answers(b.table, b.id(0), b.id(1), b.id(2), b.id(3)),
           minor_answers(b.table, b.id(0), b.id(1), axis)};
    order = order_along_line(b.table, b.id(0), b.id(1), b.id(2), b.id(3));
    swapped = order_along_line(b.table, b.id(1), b.id(0), b.id(2), b.id(3));
    turn = turn_about_line(b.table, b.id(0), b.id(1), b.id(1), b.id(2));
  }
  const Int d012 = oracle::det3(w.row[0], w.row[1], w.row[2]);
  const Int d013 = oracle::det3(w.row[0], w.row[1], w.row[3]);
  const Row &p = w.row[0], &q = w.row[1], &r = w.row[2];
  const std::size_t next = (axis + 1) % 3, last = (axis + 2) % 3;
  const Int minor = p[next] * q[last] - p[last] * q[next];
  bool right = agree(got[0], sgn(d012), c, shares);
  right &= agree(got[1], sgn(oracle::det4(w.row[0], w.row[1], w.row[2], w.row[3])), c, shares);
  right &= agree(got[2], sgn(minor), c, shares);
  if (d012 != 0 && d013 != 0) {  // (Y - X) . (n_p x n_q) by coordinates
    const Row x = oracle::common_point(p, q, r), y = oracle::common_point(p, q, w.row[3]);
    Int along = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
      along += (y[i] * x[3] - x[i] * y[3]) * (p[j] * q[k] - p[k] * q[j]);
    }
    const int expected = sgn(along) * sgn(x[3]) * sgn(y[3]);
    right &= static_cast<int>(order) == expected && static_cast<int>(swapped) == -expected;
    EXPECT_TRUE(right) << "order along line " << text(c);
  }
  if (d012 == 0) {  // dependent normals: a common direction
    int expected = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
      const int d = sgn(Int(p[j] * q[k] - p[k] * q[j]));
      if (d != 0) expected = d * sgn(Int(q[j] * r[k] - q[k] * r[j]));
    }
    right &= static_cast<int>(turn) == expected;
    EXPECT_TRUE(right) << "turn about line " << text(c);
  }
  return right;
}

struct Points {
  SpacePoint three, other, line, input;
};

/// The signs about points: p q r, p q s, the line of two corners through s, and a corner.
bool check_points(const cases::Case& c, const World& w, const Built& b,
                  testing_environment::Setting mode, std::size_t axis, Shares& shares) {
  Point3Table points(b.table);
  Points x;
  std::vector<SpacePoint> ids;
  std::vector<std::pair<Answers, std::array<std::size_t, 2>>> sides, orders;
  std::vector<bool> equals;
  std::vector<Sign> along;
  {
    testing_environment::Scope scope(mode);
    x = {points.add(b.id(0), b.id(1), b.id(2)), points.add(b.id(0), b.id(1), b.id(3)),
         points.add(InputPointId(0), InputPointId(4), b.id(3)), SpacePoint(InputPointId(7))};
    ids = {x.three, x.other, x.line, x.input};
    for (std::size_t i = 0; i < 4; ++i) {
      if (!ids[i].is_valid()) continue;
      sides.push_back({side_answers(points, ids[i], b.id(3 - i)), {i, 3 - i}});
      for (std::size_t j = 0; j < i; ++j) {
        if (!ids[j].is_valid()) continue;
        orders.push_back({axis_answers(points, ids[i], ids[j], axis), {i, j}});
        equals.push_back(equal(points, ids[i], ids[j]));
      }
    }
    if (x.three.is_valid() && x.other.is_valid()) {
      along = {order_along_line(points, b.id(0), b.id(1), x.three, x.other),
               order_along_line(b.table, b.id(0), b.id(1), b.id(2), b.id(3))};
    }
  }
  const std::array<Row, 4> rows = {oracle::common_point(w.row[0], w.row[1], w.row[2]),
                                   oracle::common_point(w.row[0], w.row[1], w.row[3]),
                                   oracle::line_point(w.corner[0], w.corner[4], w.row[3]),
                                   w.corner[7]};
  bool right = true;
  for (std::size_t i = 0; i < 4; ++i) right &= ids[i].is_valid() == (rows[i][3] != 0);
  EXPECT_TRUE(right) << "existence of a point " << text(c);
  if (!right) return false;
  for (const auto& [answers, at] : sides) {
    right &= agree(answers, oracle::side(w.row[at[1]], rows[at[0]]), c, shares);
  }
  for (std::size_t n = 0; n < orders.size(); ++n) {
    const auto& [answers, at] = orders[n];
    right &= agree(answers, oracle::compare_axis(rows[at[0]], rows[at[1]], axis), c, shares);
    const bool same = oracle::is_proportional(rows[at[0]], rows[at[1]]);
    right &= equals[n] == same;
    EXPECT_EQ(equals[n], same) << text(c);
    if (same) {
      right &= fingerprint(points, ids[at[0]]) == fingerprint(points, ids[at[1]]);
      EXPECT_TRUE(right) << "fingerprints of equal points " << text(c);
    }
  }
  if (along.size() == 2) {
    right &= along[0] == along[1];
    EXPECT_EQ(along[0], along[1]) << text(c);
  }
  return right;
}

TEST(Point3Signs, AgreeWithIntegersOnAdversarialFamilies) {
  cases::Random random(21);
  const std::uint64_t count = testing::case_count(8000);
  Shares shares;
  std::uint64_t wrong = 0, used = 0;
  for (std::uint64_t i = 0; i < count && wrong < 10; ++i) {
    const cases::Case c = cases::any(random);
    const testing_environment::Setting mode = kModes[i % kModes.size()];
    const World world(c);
    std::optional<Built> built;
    {
      testing_environment::Scope scope(mode);
      built.emplace(c);
    }
    if (!built->has_all_planes()) continue;
    ++used;
    const bool right = check_planes(c, world, *built, mode, i % 3, shares) &&
                       check_points(c, world, *built, mode, i % 3, shares);
    wrong += right ? 0 : 1;
  }
  std::cout << used << " cases, " << shares.signs << " signs, " << wrong
            << " wrong; decided by filter " << shares.filter << ", narrow " << shares.fixed[0]
            << ", medium " << shares.fixed[1] << ", wide " << shares.fixed[2] << "\n";
  EXPECT_GT(used, count / 3);
  EXPECT_GT(shares.filter, shares.signs / 10);
  for (const std::uint64_t n : shares.fixed) EXPECT_GT(n, shares.signs / 20);
}

/// Each coordinate is the double nearest to it; exact where all three are doubles.
TEST(RoundedPoint3, IsNearestInEachCoordinate) {
  cases::Random random(23);
  std::size_t exact_ones = 0, others = 0, told_in_fixed = 0;
  for (std::uint64_t i = 0; i < 2000; ++i) {
    const cases::Case c = cases::any(random);
    const Built built(c);
    if (!built.has_all_planes()) continue;
    Point3Table points(built.table);
    const SpacePoint x = points.add(built.id(0), built.id(1), built.id(2));
    if (!x.is_valid()) continue;
    const RationalPoint3 at = exact(points, x);
    const RoundedPoint3 near = rounded(points, x);
    EXPECT_EQ(near.at.x, nearest_double(at.x)) << text(c);
    EXPECT_EQ(near.at.y, nearest_double(at.y)) << text(c);
    EXPECT_EQ(near.at.z, nearest_double(at.z)) << text(c);
    const auto is_double = [](const Rational& coordinate, double d) {
      return std::isfinite(d) && exact_rational(d) == coordinate;
    };
    const bool is_exact =
        is_double(at.x, near.at.x) && is_double(at.y, near.at.y) && is_double(at.z, near.at.z);
    EXPECT_EQ(near.is_exact, is_exact) << text(c);
    ++(is_exact ? exact_ones : others);
    const auto in_fixed = rung::rounded_fixed(points, x);
    if (!in_fixed) continue;
    ++told_in_fixed;
    EXPECT_EQ(in_fixed->at, near.at) << text(c);
    EXPECT_EQ(in_fixed->is_exact, near.is_exact) << text(c);
  }
  EXPECT_GT(exact_ones, 50U);
  EXPECT_GT(others, 50U);
  EXPECT_GT(told_in_fixed, 50U);
}

TEST(Point3Signs, IdentityNeedsNoArithmetic) {
  PlaneTable table;
  const OrientedPlane x = table.intern(1.0, 0.0, 0.0, -1.0), y = table.intern(0.0, 1.0, 0.0, -1.0),
                      z = table.intern(0.0, 0.0, 1.0, -1.0), t = table.intern(1.0, 1.0, 1.0, -3.0),
                      u = table.intern(1.0, 1.0, 1.0, -4.0);
  const OrientedPlane wall = table.intern(wall_along(table, x.plane(), y.plane(), {3, 5, 1}));
  const OrientedPlane other = table.intern(wall_along(table, x.plane(), t.plane(), {3, 5, 1}));
  Point3Table points(table);
  const SpacePoint one = points.add(x.plane(), y.plane(), z.plane());
  for (const OrientedPlane p : {x, y, z, wall}) EXPECT_TRUE(is_known_on(points, one, p.plane()));
  const std::array<PlaneId, 2> with_t = {t.plane(), x.plane()};
  EXPECT_FALSE(is_known_on(points, one, t.plane()));
  EXPECT_TRUE(is_known_on(points, one, t.plane(), with_t));
  EXPECT_TRUE(is_known_on(points, one, other.plane(), with_t));
  EXPECT_EQ(side(points, one, t.plane()), Sign::Zero);
  EXPECT_EQ(side(points, one, other.plane()), Sign::Zero);
  EXPECT_EQ(side(points, one, u.plane()), Sign::Negative);
  EXPECT_EQ(exact(points, one), (RationalPoint3{1, 1, 1}));
}

/// Many at once: more than a block of them, input points and constructed ones.
TEST(Point3Signs, FingerprintsOfManyAreThoseOfEach) {
  constexpr double kOne = 0x1p61;  // for fingerprints
  PlaneTable table;
  std::vector<SpacePoint> ids;
  for (int i = 0; i < 600; ++i) {
    ids.emplace_back(table.add_point({1.0 * (i % 7), 0.5 * i, i % 3 == 0 ? kOne : 1}));
  }
  Point3Table points(table);
  const PlaneId x = table.intern(1.0, 0.0, 0.0, 0.0).plane(),
                y = table.intern(0.0, 1.0, 0.0, 0.0).plane();
  for (int i = 0; i < 9; ++i) {
    ids.push_back(points.add(x, y, table.intern(0.0, 0.0, 1.0 + i, 3.0).plane()));
  }
  std::vector<Fingerprint> each;
  for (const SpacePoint p : ids) each.push_back(fingerprint(points, p));
  EXPECT_EQ(fingerprints(points, ids), each);
  EXPECT_TRUE(fingerprints(points, {}).empty());
}

// Far along any axis, either way: |x| e is more than the value there.
TEST(Point3Signs, FilterCountsTheErrorOfEachNormalCoordinate) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (const double far : {0x1p20, -0x1p20}) {
      for (const double other : {0.0, 0x1p10, -0x1p10}) {
        PointBox x{{other, other, other}, 0};
        x.mid[axis] = far;
        for (const double d : {0.75, -0.75}) {
          PlaneRow row{{0, 0, 0}, d, 0x1p-20F, 0};
          EXPECT_EQ(rung::side_filter(x, row), FilteredSign::Unsure);
          row.normal_error = 0x1p-21F;
          EXPECT_EQ(rung::side_filter(x, row),
                    d > 0 ? FilteredSign::Positive : FilteredSign::Negative);
        }
      }
    }
  }
}

// Their boxes are the origin with a radius: coordinates below 2^-900 are rounded away.
TEST(Point3Signs, PointsNextToTheOriginAreNotIt) {
  PlaneTable table;
  const std::array<PlaneId, 3> walls = {table.intern(1.0, 0.0, 0.0, 0.0).plane(),
                                        table.intern(0.0, 1.0, 0.0, 0.0).plane(),
                                        table.intern(0.0, 0.0, 1.0, 0.0).plane()};
  const SpacePoint origin(table.add_point({0, 0, 0}));
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (const double at : {0x1p-950, -0x1p-950}) {
      std::array<double, 3> n{};
      n[axis] = 1;
      const PlaneId beside = table.intern(n[0], n[1], n[2], -at).plane();
      Point3Table points(table);
      const SpacePoint p = points.add(walls[(axis + 1) % 3], walls[(axis + 2) % 3], beside);
      const SpacePoint o = points.add(walls[0], walls[1], walls[2]);
      const Sign sign = at > 0 ? Sign::Positive : Sign::Negative;
      EXPECT_EQ(compare_axis(points, p, o, axis), sign);
      EXPECT_EQ(compare_axis(points, p, origin, axis), sign);
      EXPECT_FALSE(equal(points, p, o));
      EXPECT_TRUE(equal(points, o, origin));
    }
  }
}

TEST(Point3Signs, ParallelPlanesHaveNoOrder) {
  PlaneTable table;
  const PlaneId low = table.intern(0.0, 0.0, 1.0, 0.0).plane(),
                high = table.intern(0.0, 0.0, 1.0, -1.0).plane();
  const SpacePoint a(table.add_point({0, 0, 0})), b(table.add_point({1, 0, 0}));
  const Point3Table points(table);
  EXPECT_EQ(order_along_line(points, low, high, a, b), Sign::Zero);
  EXPECT_EQ(order_along_line(points, low, low, a, b), Sign::Zero);
}

/// A point is the same however it is made: its fingerprint too, and the order is a total one.
TEST(Point3Signs, EqualPointsOfAllKinds) {
  PlaneTable table;
  const InputPointId at = table.add_point({0.5, 0.25, -2}), above = table.add_point({0.5, 0.25, 4}),
                     below = table.add_point({0.5, 0.25, -9});
  const PlaneId x = table.intern(2.0, 0.0, 0.0, -1.0).plane(),
                y = table.intern(0.0, 4.0, 0.0, -1.0).plane(),
                z = table.intern(0.0, 0.0, 1.0, 2.0).plane();
  Point3Table points(table);
  const std::array<SpacePoint, 3> same = {SpacePoint(at), points.add(x, y, z),
                                          points.add(above, below, z)};
  for (const SpacePoint a : same) {
    for (const SpacePoint b : same) {
      EXPECT_TRUE(equal(points, a, b));
      EXPECT_EQ(compare_xyz(points, a, b), Sign::Zero);
      EXPECT_EQ(fingerprint(points, a), fingerprint(points, b));
    }
    EXPECT_EQ(fingerprints(points, same), std::vector<Fingerprint>(3, fingerprint(points, a)));
    EXPECT_FALSE(equal(points, a, SpacePoint(above)));
    EXPECT_EQ(compare_xyz(points, a, SpacePoint(above)), Sign::Negative);
    EXPECT_EQ(compare_xyz(points, SpacePoint(above), a), Sign::Positive);
  }
  EXPECT_FALSE(points.add(x, y, x).is_valid());
  EXPECT_FALSE(points.add(above, below, x).is_valid());
  EXPECT_FALSE(points.add(x, x, y).is_valid());
}

/// Coordinates that definitions show are compared without exact arithmetic. Planes across an axis
/// come from coefficients, long or short, or from corners; the other planes are inclined, so that
/// boxes do not decide equal coordinates.
TEST(Point3Signs, CoordinatesThatDefinitionsShow) {
  PlaneTable table;
  const std::array<double, 5> heights = {0, 0.1, -3, 0x1p-60, 0.1 + 0x1p-56};
  std::vector<PlaneId> across;
  for (const double z : heights) {
    across.push_back(table.intern(0.0, 0.0, 3.0, -z).plane());
    across.push_back(table.intern(0.0, 0.0, 1.0, -z).plane());
    const InputPointId p = table.add_point({0.3, 0.1, z}), q = table.add_point({5, 0.7, z}),
                       r = table.add_point({0.9, 7, z});
    across.push_back(table.intern(p, q, r).plane());
  }
  std::mt19937_64 random(1);
  const auto inclined = [&] {
    const auto number = [&] { return static_cast<double>(random() % 2001) / 1000 - 1.0003; };
    return table.intern(number(), number(), number() / 8, number()).plane();
  };
  Point3Table points(table);
  std::vector<SpacePoint> all;
  for (int i = 0; i < 3; ++i) {
    for (const PlaneId z : across) {
      const PlaneId p = inclined(), q = inclined();
      all.push_back(points.add(p, q, z));
    }
  }
  for (std::uint32_t i = 0; i < table.points().size(); i += 3) all.emplace_back(InputPointId(i));
  int equal_pairs = 0;
  for (const SpacePoint a : all) {
    for (const SpacePoint b : all) {
      ASSERT_TRUE(a.is_valid() && b.is_valid());
      const RationalPoint3 at = exact(points, a), to = exact(points, b);
      EXPECT_EQ(compare_axis(points, a, b, 0), sign_of(at.x.compare(to.x)));
      EXPECT_EQ(compare_axis(points, a, b, 2), sign_of(at.z.compare(to.z)));
      equal_pairs += a != b && at.z == to.z ? 1 : 0;
    }
  }
  EXPECT_GT(equal_pairs, 200);
}

}  // namespace
}  // namespace plumb::point3_signs_test
