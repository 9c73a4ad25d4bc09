#include "plumb/predicates/space/plane_table.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <map>
#include <vector>

#include "float_environment.h"
#include "generate/space_cases.h"
#include "generate/test_share.h"
#include "plumb/predicates/space/plane_exact.h"
#include "space_oracle.h"

namespace plumb::plane_table_test {
namespace {

using oracle::Int;
using oracle::Row;

Row oracle_row(const IntegerRow& row) {
  return {Int(row[0].str()), Int(row[1].str()), Int(row[2].str()), Int(row[3].str())};
}

Row through(const std::vector<Point3>& p, int unit) {
  return oracle::plane_through(oracle::point_row(p[0], unit), oracle::point_row(p[1], unit),
                               oracle::point_row(p[2], unit));
}

/// (a, b, c, d) for points in units of 2^unit, as a plane for points in units of 1.
Row rescaled(Row plane, int unit) {
  if (unit > 0) plane[3] <<= unit;
  for (std::size_t i = 0; i < 3 && unit < 0; ++i) plane[i] <<= -unit;
  return plane;
}

/// The law of interning: valid = a plane; same id = proportional rows; orientation as computed;
/// stored coefficients canonical; row within its errors (checked by the sign tests).
void expect_interned(const cases::Case& c, testing_environment::Setting mode) {
  PlaneTable table;
  std::array<OrientedPlane, 4> single, batch;
  {
    testing_environment::Scope scope(mode);
    std::array<std::array<InputPointId, 3>, 4> triangles;
    const std::size_t first = table.add_points(c.corners).value();
    for (std::size_t i = 0; i < 4; ++i) {
      triangles[i] = {InputPointId(first + 3 * i), InputPointId(first + 3 * i + 1),
                      InputPointId(first + 3 * i + 2)};
      single[i] = table.intern(triangles[i][0], triangles[i][1], triangles[i][2]);
    }
    table.intern_triangles(triangles, batch);
  }
  EXPECT_EQ(single, batch);
  std::array<Row, 4> expected;
  for (std::size_t i = 0; i < 4; ++i) {
    const std::vector<Point3> corners(c.corners.begin() + 3 * static_cast<std::ptrdiff_t>(i),
                                      c.corners.begin() + 3 * static_cast<std::ptrdiff_t>(i) + 3);
    const int unit = oracle::unit_of(corners);
    expected[i] = rescaled(through(corners, unit), unit);
    ASSERT_EQ(single[i].is_valid(), oracle::is_plane(expected[i])) << c.family;
    if (!single[i].is_valid()) continue;
    const Row stored = oracle_row(table.coefficients(single[i].plane()));
    EXPECT_TRUE(oracle::is_proportional(stored, expected[i])) << c.family;
    EXPECT_EQ(stored, oracle::canonical(stored)) << c.family;
    const bool is_canonical = oracle::canonical(expected[i]) == expected[i];
    EXPECT_EQ(single[i].is_opposite(), !is_canonical) << c.family;
    for (std::size_t j = 0; j < i; ++j) {
      if (!single[j].is_valid()) continue;
      EXPECT_EQ(single[i].plane() == single[j].plane(),
                oracle::is_proportional(expected[i], expected[j]))
          << c.family;
    }
  }
}

TEST(PlaneTable, InternsByEqualityOfPlanes) {
  cases::Random random(11);
  const std::uint64_t count = testing::case_count(12000);
  const auto modes = testing_environment::kSettings;
  for (std::uint64_t i = 0; i < count && !HasFailure(); ++i) {
    const cases::Case c = cases::any(random);
    expect_interned(c, modes[i % modes.size()]);
  }
}

/// Any three corners of a polygon, in any order, are one plane; odd orders the opposite one.
TEST(PlaneTable, AnyTripleInAnyOrder) {
  cases::Random random(12);
  for (int round = 0; round < 300; ++round) {
    const Point3 a = cases::grid_point(random, 10, 2), u = cases::grid_point(random, 10, 2),
                 v = cases::grid_point(random, 10, 2);
    using cases::operator+;
    PlaneTable table;
    std::vector<InputPointId> ids;
    for (int k = 0; k < 6; ++k) {
      ids.push_back(table.add_point(a + cases::scaled(u, k) + cases::scaled(v, k * k)));  // convex
    }
    const OrientedPlane plane = table.intern(ids[0], ids[1], ids[2]);
    if (!plane.is_valid()) continue;
    for (std::size_t i = 0; i < 6; ++i) {
      for (std::size_t j = 0; j < 6; ++j) {
        for (std::size_t k = 0; k < 6; ++k) {
          if (i == j || j == k || i == k) {
            EXPECT_FALSE(table.intern(ids[i], ids[j], ids[k]).is_valid());
            continue;
          }
          const bool even = (i < j) + (j < k) + (i < k) == 3 || (i < j) + (j < k) + (i < k) == 1;
          EXPECT_EQ(table.intern(ids[i], ids[j], ids[k]), even ? plane : plane.opposite());
        }
      }
    }
    EXPECT_EQ(table.size(), 1u);
  }
}

TEST(PlaneTable, CoefficientsPointsAndRationalsAgree) {
  cases::Random random(13);
  for (int i = 0; i < 2000; ++i) {
    const cases::Corners c = i % 2 == 0 ? cases::one_point(random) : cases::spread(random);
    PlaneTable table;
    table.add_points(c);
    const OrientedPlane p = table.intern(InputPointId(0), InputPointId(1), InputPointId(2));
    if (!p.is_valid()) continue;
    const IntegerRow row = table.coefficients(p.plane());
    const Rational factor(cases::integer(random, 1, 1000), cases::integer(random, 1, 1000));
    const Rational s = cases::integer(random, 0, 1) == 0 ? factor : Rational(-factor);
    const OrientedPlane q = table.intern(Rational(row[0] * s), Rational(row[1] * s),
                                         Rational(row[2] * s), Rational(row[3] * s));
    EXPECT_EQ(q.plane(), p.plane());
    EXPECT_EQ(q.is_opposite(), s < 0);
    EXPECT_EQ(table.size(), 1u);
  }
}

Integer integer_of(const exact3::LongPlane::Number& x) {
  std::array<std::uint64_t, exact3::LongPlane::kLimbs> limbs;
  for (std::size_t i = 0; i < limbs.size(); ++i) limbs[i] = x.limb(static_cast<int>(i));
  return integer_from_limbs(limbs.data(), limbs.size());
}

/// Returns a number of up to this many bits, often one that fills its limbs, or a multiple of q.
exact3::LongPlane::Number some_number(cases::Random& random, int bits) {
  using Number = exact3::LongPlane::Number;
  const Number q = Number(static_cast<std::int64_t>((std::uint64_t{1} << 61) - 1));
  Number x(cases::integer(random, -4, 4));
  switch (cases::integer(random, 0, 3)) {
    case 0:
      return x;
    case 1:
      return multiply_to<Number::kLimbs>(q, x);
    default:
      break;
  }
  const auto up = static_cast<int>(cases::integer(random, 0, bits - 4));
  x = x << up;
  return cases::integer(random, 0, 1) == 0 ? x : x - Number(1);
}

/// Planes of long integers are those of the same rationals, alone and in blocks.
TEST(PlaneTable, LongCoefficientsAndRationalsAgree) {
  cases::Random random(29);
  std::vector<exact3::LongPlane> planes(700);
  for (exact3::LongPlane& plane : planes) {
    const auto bits = static_cast<int>(cases::integer(random, 5, 760));
    for (auto& x : plane.n) x = some_number(random, bits);
    plane.d = some_number(random, bits);
    if (!plane.d.is_zero()) plane.scale = static_cast<int>(cases::integer(random, -200, 200));
  }
  PlaneTable table;
  std::vector<OrientedPlane> found(planes.size());
  table.intern_coefficients(planes, found);
  for (std::size_t i = 0; i < planes.size(); ++i) {
    const exact3::LongPlane& plane = planes[i];
    const Integer unit = Integer(1)
                         << static_cast<unsigned>(plane.d.is_zero() ? 0 : std::abs(plane.scale));
    const Rational d = plane.d.is_zero() || plane.scale >= 0 ? Rational(integer_of(plane.d) * unit)
                                                             : Rational(integer_of(plane.d), unit);
    const std::size_t size = table.size();
    EXPECT_EQ(found[i],
              table.intern(Rational(integer_of(plane.n[0])), Rational(integer_of(plane.n[1])),
                           Rational(integer_of(plane.n[2])), d));
    EXPECT_EQ(table.size(), size);
    OrientedPlane alone;
    table.intern_coefficients({&plane, 1}, {&alone, 1});
    EXPECT_EQ(alone, found[i]);
    if (!found[i].is_valid()) continue;
    const PlaneRow& row = table.row(found[i].plane());
    const IntegerRow exact = table.coefficients(found[i].plane());
    PlaneTable other;
    EXPECT_EQ(row.n, other
                         .row(other
                                  .intern(Rational(exact[0]), Rational(exact[1]),
                                          Rational(exact[2]), Rational(exact[3]))
                                  .plane())
                         .n);
  }
}

/// Coefficients that are one residue, and a scale of which q is a factor.
TEST(PlaneTable, CollisionsModuloQAreTold) {
  PlaneTable table;
  const Integer q = (Integer(1) << 61) - 1;
  const auto plane = [&](const Integer& a, const Integer& b, const Integer& c, const Integer& d) {
    return table.intern(Rational(a), Rational(b), Rational(c), Rational(d));
  };
  const OrientedPlane unit = table.intern(1.0, 0.0, 0.0, 1.0);
  EXPECT_NE(unit, table.intern(1.0, 0.0, 0.0, 0x1p61));
  EXPECT_NE(unit, table.intern(1.0, 0.0, 0.0, 0x1p-61));
  EXPECT_NE(unit, table.intern(1.0, 0.0, 0.0, 0x1p610));
  EXPECT_NE(unit, plane(1, 0, 0, 1 + 3 * q));
  EXPECT_NE(unit, plane(1, q, 0, 1));
  EXPECT_NE(plane(1, q, 0, 1), plane(1, 0, q, 1));
  EXPECT_NE(unit, plane(1, 0, 0, 1 - q));
  EXPECT_NE(plane(0, 1, 0, 1), plane(0, 1, q, 1));
  EXPECT_NE(plane(0, 0, 1, 1), plane(0, 0, 1, 1 + q));
  const std::size_t planes = table.size();
  EXPECT_EQ(planes, 12u);
  EXPECT_EQ(unit, plane(q, 0, 0, q));
  EXPECT_EQ(unit.opposite(), plane(-q * q, 0, 0, -q * q));
  EXPECT_EQ(plane(1, q, 0, 1), plane(q, q * q, 0, q));
  EXPECT_EQ(table.size(), planes);
}

/// Powers of 2^61 are one residue, and planes through them on the axes one fingerprint.
TEST(PlaneTable, TellsManyPlanesOfOneFingerprint) {
  PlaneTable table;
  constexpr int kMost = 10;
  constexpr std::uint32_t kSteps = 2 * kMost + 1;
  for (int axis = 0; axis < 3; ++axis) {
    for (int i = -kMost; i <= kMost; ++i) {
      const double at = std::ldexp(1.0, 61 * i);
      table.add_point({axis == 0 ? at : 0.0, axis == 1 ? at : 0.0, axis == 2 ? at : 0.0});
    }
  }
  std::vector<std::array<InputPointId, 3>> triangles;
  for (std::uint32_t i = 0; i < kSteps * kSteps * kSteps; ++i) {
    triangles.push_back({InputPointId(i % kSteps), InputPointId(kSteps + i / kSteps % kSteps),
                         InputPointId(2 * kSteps + i / kSteps / kSteps)});
  }
  std::vector<OrientedPlane> planes(triangles.size());
  table.intern_triangles(triangles, planes);
  EXPECT_EQ(table.size(), triangles.size());
  EXPECT_EQ(table.fingerprint(PlaneId(0)), table.fingerprint(PlaneId(triangles.size() - 1)));
  for (std::uint32_t i = 0; i < planes.size(); ++i) ASSERT_EQ(planes[i].plane(), PlaneId(i));

  for (auto& [p, q, r] : triangles) std::swap(p, r);
  std::vector<OrientedPlane> again(triangles.size());
  table.intern_triangles(triangles, again);
  for (std::uint32_t i = 0; i < planes.size(); ++i) ASSERT_EQ(again[i], planes[i].opposite());
  const IntegerRow row = table.coefficients(PlaneId(1234));
  EXPECT_EQ(table.intern(Rational(row[0]), Rational(row[1]), Rational(row[2]), Rational(row[3])),
            planes[1234]);

  PlaneTable copy(table);
  const std::vector<PlaneId> map = copy.merge(table);
  for (std::uint32_t i = 0; i < map.size(); ++i) ASSERT_EQ(map[i], PlaneId(i));
  EXPECT_EQ(copy.size(), table.size());
}

/// Corners whose differences are multiples of q: all residues of the normal are 0. Corners known to
/// be on some planes, of a plane with the fingerprint of another one: on that they are not.
TEST(PlaneTable, WhatIsKnownOfACornerIsOfOnePlane) {
  constexpr double far = 0x1p61;  // as a residue 1
  PlaneTable table;
  const std::vector<Point3> points{{far, 0, 0},
                                   {0, far, 0},
                                   {0, 0, far / 2},  // 0
                                   {far / 2, far / 2, 0},
                                   {0, far / 2, far / 2},
                                   {far / 2, 0, far / 2},  // 3
                                   {1, 0, far / 2},
                                   {0, 1, far / 2},
                                   {1, 1, far / 2},  // 6
                                   {1, 0, 0},
                                   {0, 1, 0},
                                   {0, 0, .5},
                                   {0, 0, far}};  // 9
  table.add_points(points);
  const auto triangle = [](std::uint32_t p, std::uint32_t q, std::uint32_t r) {
    return std::array{InputPointId(p), InputPointId(q), InputPointId(r)};
  };
  const std::vector<std::array<InputPointId, 3>> triangles{
      triangle(3, 4, 5),   triangle(0, 1, 12),  // x + y + z = far
      triangle(6, 7, 8),   triangle(2, 6, 7),   // z = far / 2
      triangle(9, 10, 11),                      // x + y + 2 z = 1
      triangle(0, 1, 2)};                       // x + y + 2 z = far
  std::vector<OrientedPlane> planes(triangles.size());
  table.intern_triangles(triangles, planes);
  EXPECT_EQ(planes[0].plane(), planes[1].plane());
  EXPECT_EQ(planes[2].plane(), planes[3].plane());
  ASSERT_EQ(table.fingerprint(planes[4].plane()), table.fingerprint(planes[5].plane()));
  EXPECT_NE(planes[4].plane(), planes[5].plane());
  EXPECT_EQ(table.size(), 4U);
}

/// Points of a lattice, each on many planes.
TEST(PlaneTable, TrianglesOfALatticeTogetherAreAsOneByOne) {
  std::vector<Point3> points;
  for (int i = 0; i < 64; ++i) points.push_back({i % 4 - 1.25, i / 4 % 4 * .5, i / 16 - 2.});
  std::mt19937_64 random(20261124);
  std::vector<std::array<InputPointId, 3>> triangles(4000);
  for (auto& t : triangles) {
    for (InputPointId& p : t) p = InputPointId(static_cast<std::uint32_t>(random() % 64));
  }
  PlaneTable together, single;
  together.add_points(points);
  single.add_points(points);
  std::vector<OrientedPlane> planes(triangles.size());
  together.intern_triangles(triangles, planes);
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const auto& [p, q, r] = triangles[i];
    EXPECT_EQ(planes[i], single.intern(p, q, r));
  }
  EXPECT_EQ(together.size(), single.size());
}

TEST(PlaneTable, TrianglesWithZeroResidues) {
  PlaneTable table;
  const double big = 0x1p61, q_up = 0x1p61 - 0x1p9;  // both doubles; q itself is none
  const InputPointId o = table.add_point({0, 0, 0});
  // u = (2^61 - 1) (1, 0, 0) as the sum of doubles on both sides of the origin.
  const InputPointId a = table.add_point({-1, 0, 0}), b = table.add_point({big - 2, 0, 0});
  const InputPointId c = table.add_point({q_up, 1, 5});
  const OrientedPlane p = table.intern(a, b, c), r = table.intern(o, b, c);
  ASSERT_TRUE(p.is_valid());
  EXPECT_EQ(p, r);
  EXPECT_FALSE(table.intern(o, a, b).is_valid());
}

TEST(PlaneTable, RefusesWhatIsNoPlane) {
  PlaneTable table;
  EXPECT_FALSE(table.intern(0.0, 0.0, 0.0, 1.0).is_valid());
  EXPECT_FALSE(table.intern(Rational(0), Rational(0), Rational(0), Rational(0)).is_valid());
  EXPECT_EQ(table.size(), 0u);
}

TEST(PlaneTable, TrianglesThatAreNoneHaveNoPlaneWhateverStoodThere) {
  PlaneTable table;
  const InputPointId o = table.add_point({0, 0, 0}), a = table.add_point({1, 2, 3}),
                     b = table.add_point({2, 4, 6}), c = table.add_point({1, 0, 0});
  const std::array<std::array<InputPointId, 3>, 3> triangles = {{{o, a, b}, {o, a, c}, {c, c, a}}};
  std::array<OrientedPlane, 3> planes;
  planes.fill(table.intern(1.0, 1.0, 1.0, 1.0));
  table.intern_triangles(triangles, planes);
  EXPECT_FALSE(planes[0].is_valid());
  EXPECT_EQ(planes[1], table.intern(o, a, c));
  EXPECT_FALSE(planes[2].is_valid());
}

TEST(PlaneTable, PrimitiveIsCanonicalWithGcdOne) {
  PlaneTable table;
  const OrientedPlane p = table.intern(-6.0, 0.0, 9.0, 12.0);
  EXPECT_TRUE(p.is_opposite());
  EXPECT_EQ(table.primitive(p.plane()),
            (IntegerRow{Integer(2), Integer(0), Integer(-3), Integer(-4)}));
  const OrientedPlane half = table.intern(0.5, 0.0, 0.0, 0.75);
  EXPECT_EQ(table.primitive(half.plane()),
            (IntegerRow{Integer(2), Integer(0), Integer(0), Integer(3)}));
}

TEST(PlaneTable, WallsHoldTheLineAndTheDirectionOrPoint) {
  cases::Random random(14);
  for (int i = 0; i < 1000; ++i) {
    const cases::Corners c =
        i % 2 == 0 ? cases::random_points(random) : cases::small_integers(random);
    PlaneTable table;
    table.add_points(c);
    const OrientedPlane p = table.intern(InputPointId(0), InputPointId(1), InputPointId(2));
    const OrientedPlane q = table.intern(InputPointId(3), InputPointId(4), InputPointId(5));
    if (!p.is_valid() || !q.is_valid() || p.plane() == q.plane()) continue;
    const Point3 u = c[7];
    const Row a = oracle_row(table.coefficients(p.plane())),
              b = oracle_row(table.coefficients(q.plane()));
    for (const bool is_point : {false, true}) {
      const Pencil pencil = is_point ? wall_through(table, p.plane(), q.plane(), u)
                                     : wall_along(table, p.plane(), q.plane(), u);
      const std::size_t before = table.size();
      const OrientedPlane wall = table.intern(pencil);
      if (!wall.is_valid()) {
        Row n = a, m = b;
        n[3] = m[3] = 0;
        EXPECT_TRUE(oracle::is_proportional(n, m) || (pencil.c_first == 0 && pencil.c_second == 0));
        continue;
      }
      const Row w = oracle_row(table.coefficients(wall.plane()));
      for (std::size_t k = 0; k < 4; ++k) {  // all 3x3 minors of the three rows vanish
        EXPECT_EQ(oracle::det3(a, b, w, k == 0, k <= 1 ? 2 : 1, k <= 2 ? 3 : 2), 0);
      }
      const int unit = oracle::unit_of({u});
      Row x = oracle::point_row(u, unit);
      x[3] = is_point ? (unit < 0 ? Int(1) << -unit : Int(1)) : Int(0);
      if (unit > 0) {
        for (std::size_t k = 0; k < 3; ++k) x[k] <<= unit;
      }
      EXPECT_EQ(oracle::value_at(w, x), 0);
      const std::array<PlaneId, 2> both = {p.plane(), q.plane()};
      if (table.size() > before) {
        EXPECT_TRUE(table.is_wall_of(wall.plane(), both));
      }
      EXPECT_FALSE(table.is_wall_of(wall.plane(), std::span(both).first(1)));
    }
  }
}

TEST(PlaneTable, MergeMapsPlanesToEqualPlanes) {
  cases::Random random(15);
  for (int round = 0; round < 200; ++round) {
    PlaneTable a, b;
    for (PlaneTable* table : {&a, &b}) {
      const cases::Corners c = cases::small_integers(random);
      table->add_points(c);
      for (std::size_t i = 0; i < 12; i += 3) {
        table->intern(InputPointId(i), InputPointId(i + 1), InputPointId(i + 2));
      }
      table->intern(1.0, 0.0, 0.0, double(cases::integer(random, 0, 2)));
      if (table->size() >= 2) {
        table->intern(wall_along(*table, PlaneId(0), PlaneId(1), {1, 2, 3}));
      }
    }
    const std::size_t before = a.size();
    const std::vector<PlaneId> map = a.merge(b);
    ASSERT_EQ(map.size(), b.size());
    std::map<PlaneId, int> hits;
    for (std::size_t i = 0; i < map.size(); ++i) {
      EXPECT_EQ(a.primitive(map[i]), b.primitive(PlaneId(i)));
      EXPECT_EQ(a.fingerprint(map[i]), b.fingerprint(PlaneId(i)));
      EXPECT_EQ(++hits[map[i]], 1);
    }
    for (std::size_t i = 0; i < a.size(); ++i) {  // nothing twice
      for (std::size_t j = 0; j < i; ++j)
        EXPECT_NE(a.primitive(PlaneId(i)), a.primitive(PlaneId(j)));
    }
    EXPECT_LE(before, a.size());
  }
}

// 2^61 - 1 is the residue 0: these planes have one fingerprint, and nearly all numbers in common.
TEST(PlaneTable, CoefficientsBeforeTheLeadingOneCount) {
  const Rational q((Integer(1) << 61) - 1);
  PlaneTable table;
  const PlaneId upright = table.intern(0.0, 1.0, 0.0, 0.0).plane();
  const PlaneId oblique = table.intern(q, Rational(1), Rational(0), Rational(0)).plane();
  EXPECT_EQ(table.fingerprint(upright), table.fingerprint(oblique));
  EXPECT_NE(upright, oblique);
  PlaneTable reversed;
  const PlaneId first = reversed.intern(q, Rational(1), Rational(0), Rational(0)).plane();
  EXPECT_NE(first, reversed.intern(0.0, 1.0, 0.0, 0.0).plane());
}

TEST(PlaneTable, CopiesOfWallsKnowTheCopiesOfTheirParents) {
  PlaneTable table;
  const PlaneId a = table.intern(1, 0, 0, -1).plane(), b = table.intern(0, 1, 0, -2).plane();
  const PlaneId wall = table.intern(Pencil{a, b, 1, 3}).plane();
  PlaneTable merged;
  for (int i = 1; i < 5; ++i) merged.intern(i, 2, 3, 4);
  const std::vector<PlaneId> map = merged.merge(table);
  const auto parents = merged.parents(map[wall.value()]);
  ASSERT_TRUE(parents.has_value());
  EXPECT_EQ(*parents, (std::array{map[a.value()], map[b.value()]}));
  EXPECT_FALSE(merged.parents(map[a.value()]).has_value());
  // A copy without one of the parents.
  const std::array<PlaneId, 3> some = {PlaneId(0), PlaneId(), PlaneId(1)};
  EXPECT_FALSE(PlaneTable(table, some, {}).parents(PlaneId(1)).has_value());
}

/// Rows of one limb to many, which lie one behind the other in the table.
TEST(PlaneTable, ExplicitRowsOfAnyLengthAreCopied) {
  PlaneTable table;
  for (const int bits : {10, 130, 62, 400, 64, 1}) {
    const Rational long_one((Integer(1) << bits) + 1);
    ASSERT_TRUE(table.intern(long_one, Rational(-3), Rational(5), -long_one).is_valid());
    ASSERT_TRUE(table.intern(Rational(7), long_one, -long_one, Rational(2)).is_valid());
  }
  PlaneTable merged;
  merged.intern(1, 2, 3, 4);
  const std::vector<PlaneId> map = merged.merge(table);
  std::vector<PlaneId> odd_ones;  // of a copy of every second one
  for (std::size_t i = 0; i < table.size(); ++i) {
    odd_ones.push_back(i % 2 == 1 ? PlaneId(i / 2) : PlaneId());
    EXPECT_EQ(merged.primitive(map[i]), table.primitive(PlaneId(i)));
    EXPECT_FALSE(merged.is_frame(map[i]));
  }
  const PlaneTable part(table, odd_ones, {});
  ASSERT_EQ(part.size(), table.size() / 2);
  for (std::size_t i = 0; i < part.size(); ++i) {
    EXPECT_EQ(part.primitive(PlaneId(i)), table.primitive(PlaneId(2 * i + 1)));
  }
}

/// Every second triangle, its corners alone: planes are the same, and nothing else comes along.
TEST(PlaneTable, CopiesOfAPartHoldThatPart) {
  cases::Random random(16);
  for (int round = 0; round < 50; ++round) {
    PlaneTable table;
    std::vector<PlaneId> planes;
    std::vector<Point3> kept;
    std::vector<PlaneId> plane_map;
    std::vector<InputPointId> point_map;
    for (int triangle = 0; triangle < 8; ++triangle) {
      const cases::Corners c = cases::small_integers(random);
      const std::size_t first = table.add_points(std::span(c).first(3)).value();
      const OrientedPlane plane =
          table.intern(InputPointId(first), InputPointId(first + 1), InputPointId(first + 2));
      const bool is_new = plane.is_valid() && plane.plane().value() == plane_map.size();
      const bool is_kept = is_new && triangle % 2 == 0;
      if (is_new) plane_map.push_back(is_kept ? PlaneId(planes.size()) : PlaneId());
      for (std::size_t i = 0; i < 3; ++i) {
        point_map.push_back(is_kept ? InputPointId(kept.size()) : InputPointId());
        if (is_kept) kept.push_back(c[i]);
      }
      if (is_kept) planes.push_back(plane.plane());
    }
    const PlaneTable copy(table, plane_map, point_map);
    EXPECT_TRUE(std::ranges::equal(copy.points(), kept));
    ASSERT_EQ(copy.size(), planes.size());
    for (std::size_t i = 0; i < planes.size(); ++i) {
      EXPECT_EQ(copy.primitive(PlaneId(i)), table.primitive(planes[i]));
      EXPECT_EQ(copy.fingerprint(PlaneId(i)), table.fingerprint(planes[i]));
    }
  }
}

}  // namespace
}  // namespace plumb::plane_table_test
