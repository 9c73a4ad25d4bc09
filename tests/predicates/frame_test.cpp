// Planes and points of the frame against the same with a concrete R = 2^4000, which is beyond
// everything that the small and medium numbers here can make.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <iostream>
#include <string>
#include <vector>

#include "fixed_rungs.h"
#include "generate/space_cases.h"
#include "generate/test_share.h"
#include "plumb/predicates/plane_signs.h"
#include "plumb/predicates/point3_signs.h"
#include "plumb/predicates/space/point3_table.h"
#include "space_oracle.h"

namespace plumb::frame_test {
namespace {

using cases::integer;
using cases::Random;
using oracle::Int;
using oracle::Row;
using oracle::sgn;

const Int kR = Int(1) << 4000;

/// Planes and points, here and in the oracle. Coordinates and offsets of the oracle are in units of
/// 2^-kUnit.
constexpr int kUnit = 60;

struct World {
  World() = default;
  World(const World&) = delete;
  World& operator=(const World&) = delete;

  PlaneTable table;
  Point3Table points{table};
  std::vector<PlaneId> planes;
  std::vector<SpacePoint> ids;
  std::vector<Row> rows;         ///< of planes, canonical
  std::vector<Row> coordinates;  ///< of ids

  void add_plane(OrientedPlane p, const Row& row) {
    if (!p.is_valid()) return;
    planes.push_back(p.plane());
    rows.push_back(oracle::canonical(row));
  }
  void add_plane(double a, double b, double c, double d) {
    add_plane(table.intern(a, b, c, d),
              {oracle::to_int(a, -kUnit), oracle::to_int(b, -kUnit), oracle::to_int(c, -kUnit),
               oracle::to_int(d, -kUnit) << kUnit});
  }
  void add_frame() {
    const std::array<PlaneId, 6> frame = table.intern_frame();
    for (std::size_t i = 0; i < 6; ++i) {
      Row row = {0, 0, 0, i % 2 == 0 ? kR : -kR};
      row[i / 2] = 1;
      add_plane({frame[i], false}, row);
    }
  }
  /// c_q p - c_p q of two planes of the cube.
  void add_far_plane(std::size_t p, std::size_t q, int c_p, int c_q) {
    Row row;
    for (std::size_t i = 0; i < 4; ++i) row[i] = c_q * rows[p][i] - c_p * rows[q][i];
    add_plane(table.intern(Pencil{planes[p], planes[q], c_p, c_q}), row);
  }
  /// Its existence is part of the law.
  void add_point(std::size_t p, std::size_t q, std::size_t r) {
    const Row at = oracle::common_point(rows[p], rows[q], rows[r]);
    const SpacePoint x = points.add(planes[p], planes[q], planes[r]);
    ASSERT_EQ(x.is_valid(), at[3] != 0);
    if (x.is_valid()) push(x, at);
  }
  void add_point(const Point3& a, const Point3& b, std::size_t p) {
    const Row at =
        oracle::line_point(oracle::point_row(a, -kUnit), oracle::point_row(b, -kUnit), rows[p]);
    const InputPointId first = table.add_points(std::array<Point3, 2>{a, b});
    const SpacePoint x = points.add(first, InputPointId(first.value() + 1), planes[p]);
    ASSERT_EQ(x.is_valid(), at[3] != 0);
    if (x.is_valid()) push(x, at);
    push(SpacePoint(first), oracle::point_row(a, -kUnit));
  }
  void push(SpacePoint x, const Row& at) {
    ids.push_back(x);
    coordinates.push_back(at);
  }
};

struct Numbers {
  const char* name;
  double (*coordinate)(Random&);
};

/// From a few values, so that parallel and equal planes abound, to what needs every width.
constexpr std::array<Numbers, 5> kNumbers = {{
    {"units", [](Random& r) { return double(integer(r, -1, 1)); }},
    {"small", [](Random& r) { return double(integer(r, -4, 4)); }},
    // Directions closer to each other than the filters can tell, and not quite so close.
    {"close",
     [](Random& r) {
       const double units = integer(r, -1, 1), by = integer(r, -2, 2);
       return units + std::ldexp(by, integer(r, -36, -24));
     }},
    {"mantissas",
     [](Random& r) { return std::ldexp(double(integer(r, -(1 << 30), 1 << 30)), -29); }},
    {"spread",
     [](Random& r) {
       return std::ldexp(double(integer(r, -(1 << 30), 1 << 30)), integer(r, -60, 40));
     }},
}};

void add_ordinary_planes(World& world, Random& r, const Numbers& n) {
  const auto x = [&] { return n.coordinate(r); };
  world.add_plane(1, -1, 0, 0);  // x = y, x = y + 1: through edges of the frame, and beside
  world.add_plane(1, -1, 0, -1);
  world.add_plane(0, 0, 1, x());
  for (int i = 0; i < 4; ++i) world.add_plane(x(), x(), x(), x());
  const double a = x(), b = x(), c = x();  // parallel
  for (int i = 0; i < 2; ++i) world.add_plane(a, b, c, x());
}

void fill(World& world, Random& r, const Numbers& n) {
  world.add_frame();
  add_ordinary_planes(world, r, n);
  world.add_far_plane(1, 3, 2, 1);
  world.add_far_plane(0, 5, -3, 1);
  const int last = static_cast<int>(world.planes.size()) - 1;
  const auto any = [&](int from) { return static_cast<std::size_t>(integer(r, from, last)); };
  const auto frame = [&] { return static_cast<std::size_t>(integer(r, 0, 5)); };
  for (int i = 0; i < 3; ++i) {
    world.add_point(frame(), any(0), any(0));
    world.add_point(frame(), any(6), any(6));
    world.add_point(frame(), frame(), any(6));
    const Point3 a{n.coordinate(r), n.coordinate(r), n.coordinate(r)};
    const Point3 b{n.coordinate(r), n.coordinate(r), n.coordinate(r)};
    world.add_point(a, b, i == 0 ? any(6) : frame());
  }
  world.add_point(any(6), any(6), any(6));
  world.add_point(0, 2, 4);
}

/// Every rung that decides gives the expected sign, and mpz and the ladder do.
struct Judge {
  std::uint64_t signs = 0, zeros = 0, far = 0, narrow = 0, medium = 0, wide = 0;

  void operator()(const char* what, int expected, const std::array<FilteredSign, 2>& filters,
                  const std::array<FilteredSign, 3>& fixed, Sign big, Sign ladder) {
    ++signs;
    zeros += expected == 0 ? 1 : 0;
    const auto right = [&](FilteredSign s) {
      return !is_decided(s) || static_cast<int>(decided(s)) == expected;
    };
    for (const FilteredSign s : filters) EXPECT_TRUE(right(s)) << what << " filter";
    for (const FilteredSign s : fixed) EXPECT_TRUE(right(s)) << what << " fixed";
    EXPECT_EQ(static_cast<int>(big), expected) << what << " big";
    EXPECT_EQ(static_cast<int>(ladder), expected) << what;
    far += is_decided(filters[1]) ? 1 : 0;
    narrow += is_decided(fixed[0]) ? 1 : 0;
    medium += is_decided(fixed[1]) ? 1 : 0;
    wide += is_decided(fixed[2]) ? 1 : 0;
  }
};

void check_planes(const World& w, Random& r, Judge& judge) {
  const PlaneTable& t = w.table;
  const int last = static_cast<int>(w.planes.size()) - 1;
  for (int i = 0; i < 40; ++i) {
    std::array<std::size_t, 4> at;
    for (std::size_t& k : at) k = static_cast<std::size_t>(integer(r, 0, last));
    std::array<PlaneId, 4> p;
    for (std::size_t k = 0; k < 4; ++k) p[k] = w.planes[at[k]];
    const Row &a = w.rows[at[0]], &b = w.rows[at[1]], &c = w.rows[at[2]], &d = w.rows[at[3]];
    judge("det4", sgn(oracle::det4(a, b, c, d)),
          {rung::det4_filter(t.row(p[0]), t.row(p[1]), t.row(p[2]), t.row(p[3])),
           rung::far_det4_filter(t, p[0], p[1], p[2], p[3])},
          fixed_rungs::det4(t, p[0], p[1], p[2], p[3]), rung::det4_big(t, p[0], p[1], p[2], p[3]),
          det4_sign(t, p[0], p[1], p[2], p[3]));
    judge("det3", sgn(oracle::det3(a, b, c)),
          {rung::det3_filter(t.row(p[0]), t.row(p[1]), t.row(p[2])), FilteredSign::Unsure},
          fixed_rungs::det3(t, p[0], p[1], p[2]), rung::det3_big(t, p[0], p[1], p[2]),
          det3_sign(t, p[0], p[1], p[2]));
  }
}

void check_sides(const World& w, Judge& judge) {
  const Point3Table& t = w.points;
  for (std::size_t i = 0; i < w.ids.size(); ++i) {
    for (std::size_t j = 0; j < w.planes.size(); ++j) {
      const SpacePoint x = w.ids[i];
      const PlaneId p = w.planes[j];
      judge("side", oracle::side(w.rows[j], w.coordinates[i]),
            {rung::side_filter(t.box(x), w.table.row(p)), rung::far_side_filter(t, x, p)},
            fixed_rungs::side(t, x, p), rung::side_big(t, x, p), side(t, x, p));
    }
  }
}

/// P0 of P0 + u R is in the box around it.
void check_near_boxes(const World& w) {
  for (const SpacePoint x : w.ids) {
    const PointBox box = w.points.near_box(x);
    if (!std::isfinite(box.radius)) continue;
    const RationalPoint3 at = exact_parts(w.points, x).finite;
    const std::array<Rational, 3> coordinates = {at.x, at.y, at.z};
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_LE(abs(Rational(coordinates[i] - Rational(box.mid[i]))), Rational(box.radius));
    }
  }
}

void check_orders(const World& w, Judge& judge) {
  const Point3Table& t = w.points;
  for (std::size_t i = 0; i < w.ids.size(); ++i) {
    for (std::size_t j = 0; j < w.ids.size(); ++j) {
      const SpacePoint x = w.ids[i], y = w.ids[j];
      const Row &a = w.coordinates[i], &b = w.coordinates[j];
      const std::size_t axis = (i + j) % 3;
      judge("compare_axis", oracle::compare_axis(a, b, axis),
            {rung::compare_axis_filter(t.box(x), t.box(y), axis),
             rung::far_compare_axis_filter(t, x, y, axis)},
            fixed_rungs::compare_axis(t, x, y, axis), rung::compare_axis_big(t, x, y, axis),
            compare_axis(t, x, y, axis));
      int order = 0;
      for (std::size_t k = 0; k < 3 && order == 0; ++k) order = oracle::compare_axis(a, b, k);
      EXPECT_EQ(static_cast<int>(compare_xyz(t, x, y)), order);
      EXPECT_EQ(equal(t, x, y), order == 0);
      EXPECT_EQ(fingerprint(t, x) == fingerprint(t, y), order == 0);
    }
  }
}

/// (y - x) . (n_p x n_q) for the points of every line of two planes.
void check_lines(const World& w, Random& r) {
  const int last = static_cast<int>(w.planes.size()) - 1;
  for (int i = 0; i < 40; ++i) {
    const auto p = static_cast<std::size_t>(integer(r, 0, last));
    const auto q = static_cast<std::size_t>(integer(r, 0, last));
    const Row &a = w.rows[p], &b = w.rows[q];
    const Row direction = {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2],
                           a[0] * b[1] - a[1] * b[0], 0};
    if (direction[0] == 0 && direction[1] == 0 && direction[2] == 0) continue;
    std::vector<std::size_t> on;
    for (std::size_t k = 0; k < w.ids.size(); ++k) {
      if (oracle::side(a, w.coordinates[k]) == 0 && oracle::side(b, w.coordinates[k]) == 0) {
        on.push_back(k);
      }
    }
    for (const std::size_t x : on) {
      for (const std::size_t y : on) {
        const Row &u = w.coordinates[x], &v = w.coordinates[y];
        Int along = 0;
        for (std::size_t k = 0; k < 3; ++k) along += direction[k] * (v[k] * u[3] - u[k] * v[3]);
        EXPECT_EQ(static_cast<int>(
                      order_along_line(w.points, w.planes[p], w.planes[q], w.ids[x], w.ids[y])),
                  sgn(along) * sgn(u[3]) * sgn(v[3]));
      }
    }
  }
}

class Frame : public ::testing::TestWithParam<std::size_t> {};

TEST_P(Frame, AnswersLikeAHugeNumber) {
  const Numbers& numbers = kNumbers[GetParam()];
  Random random(41);
  Judge judge;
  const std::uint64_t count = testing::case_count(60);
  for (std::uint64_t i = 0; i < count && !HasFailure(); ++i) {
    World world;
    fill(world, random, numbers);
    check_planes(world, random, judge);
    check_sides(world, judge);
    check_near_boxes(world);
    check_orders(world, judge);
    check_lines(world, random);
  }
  std::cout << judge.signs << " signs, " << judge.zeros << " zero; far filters decide " << judge.far
            << ", narrow " << judge.narrow << ", medium " << judge.medium << ", wide " << judge.wide
            << "\n";
  EXPECT_GT(judge.zeros, judge.signs / 20);
  EXPECT_GT(judge.wide, judge.signs / 4);
  EXPECT_GT(judge.far, judge.signs / 4);
}

TEST(FramePlanes, AreSixAndTheSameInEveryTable) {
  PlaneTable a, b;
  EXPECT_FALSE(a.frame()[0].is_valid());
  const PlaneId plain = a.intern(1.0, 0.0, 0.0, 1.0).plane();
  const std::array<PlaneId, 6> in_a = a.intern_frame();
  EXPECT_EQ(a.intern_frame(), in_a);
  EXPECT_EQ(a.frame(), in_a);
  EXPECT_EQ(a.size(), 7u);
  EXPECT_FALSE(a.is_frame(plain));
  const std::array<PlaneId, 6> in_b = b.intern_frame();
  for (std::size_t i = 0; i < 6; ++i) {
    EXPECT_TRUE(a.is_frame(in_a[i]));
    EXPECT_EQ(a.source(in_a[i]).frame_index(), i);
    EXPECT_EQ(a.fingerprint(in_a[i]), b.fingerprint(in_b[i]));
  }
  const std::vector<PlaneId> map = b.merge(a);
  for (std::size_t i = 0; i < 6; ++i) EXPECT_EQ(map[in_a[i].value()], in_b[i]);
  EXPECT_EQ(b.size(), 7u);
  PlaneTable c;
  const std::vector<PlaneId> to_c = c.merge(a);
  for (std::size_t i = 0; i < 6; ++i) EXPECT_EQ(to_c[in_a[i].value()], c.frame()[i]);
  EXPECT_EQ(PlaneTable(c).frame(), c.frame());
}

/// A direction too small for boxes still beats any number.
TEST(FramePoints, FollowTheLeastDirection) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    PlaneTable table;
    const PlaneId far = table.intern_frame()[2 * ((axis + 1) % 3) + 1];
    std::array<double, 3> flat{}, sloping{};
    flat[(axis + 2) % 3] = 1;
    sloping[axis] = 1;
    sloping[(axis + 1) % 3] = 0x1p-950;
    const PlaneId p = table.intern(flat[0], flat[1], flat[2], 0).plane();
    const PlaneId q = table.intern(sloping[0], sloping[1], sloping[2], -5).plane();
    const SpacePoint origin(table.add_point({0, 0, 0}));
    Point3Table points(table);
    const SpacePoint x = points.add(far, p, q);  // 5 - 2^-950 R along the axis
    EXPECT_EQ(compare_axis(points, x, origin, axis), Sign::Negative);
    EXPECT_NE(rung::far_compare_axis_filter(points, x, origin, axis), FilteredSign::Positive);
  }
}

/// A plane is one plane, whatever pencil it comes from; far planes have one fingerprint in all
/// tables.
TEST(FramePlanes, AreKnownByPencilsToo) {
  PlaneTable table, other;
  const std::array<PlaneId, 6> frame = table.intern_frame(), there = other.intern_frame();
  const auto sign = [](const OrientedPlane& p) { return p.is_opposite() ? -1 : 1; };
  for (std::size_t i = 0; i < 6; ++i) {
    for (std::size_t j = 0; j < 6; ++j) {
      if (i == j) continue;
      const OrientedPlane same = table.intern(Pencil{frame[i], frame[j], 0, 3});
      const OrientedPlane turned = table.intern(Pencil{frame[i], frame[j], 0, -2});
      EXPECT_EQ(same.plane(), frame[i]);
      EXPECT_EQ(turned.plane(), frame[i]);
      EXPECT_NE(sign(same), sign(turned));
      if (i / 2 == j / 2) continue;
      // a + s b - 2 R through an edge of the cube and a - s b through the origin: the sum is 2 a -
      // 2 R.
      const int s = i % 2 == j % 2 ? 1 : -1;
      std::array<double, 3> n{};
      n[i / 2] = 1;
      n[j / 2] = -s;
      const OrientedPlane edge = table.intern(Pencil{frame[i], frame[j], -s, 1});
      const OrientedPlane origin = table.intern(n[0], n[1], n[2], 0);
      const Pencil sum{edge.plane(), origin.plane(), -sign(edge) * sign(origin), 1};
      EXPECT_EQ(table.intern(sum).plane(), frame[i]);
      EXPECT_EQ(other.fingerprint(other.intern(Pencil{there[j], there[i], -4 * s, 4}).plane()),
                table.fingerprint(edge.plane()));
    }
  }
}

/// No number is R, not even the one that stands for it in fingerprints.
TEST(FramePlanes, EqualNoOtherPlane) {
  PlaneTable table;
  const std::array<PlaneId, 6> frame = table.intern_frame();
  for (const int sign : {-1, 1}) {
    const Rational r(sign * Integer(kFrameResidue.value()));
    const PlaneId p = table.intern(0, 1, 0, r).plane();
    EXPECT_EQ(table.fingerprint(p), table.fingerprint(frame[sign < 0 ? 3 : 2]));
    EXPECT_FALSE(table.is_frame(p));
    EXPECT_EQ(table.intern(0, 2, 0, Rational(2 * r)).plane(), p);
    EXPECT_FALSE(table.intern(0, 0, 0, r).is_valid());
  }
  EXPECT_EQ(table.intern_frame(), frame);
}

/// Equal points of two tables whose residues vanish in the first: all normals there are multiples
/// of q, or q divides a common factor.
TEST(FramePlanes, FingerprintsOfPointsWithZeroResidues) {
  const Integer q = (Integer(1) << 61) - 1;
  const auto point = [](const Integer& scale) {
    PlaneTable table;
    const PlaneId y = table.intern(0, Rational(scale), 0, Rational(scale)).plane();
    const PlaneId z = table.intern(0, 0, 1, Rational(5)).plane();
    Point3Table points(table);
    return fingerprint(points, points.add(table.intern_frame()[1], y, z));
  };
  EXPECT_EQ(point(1), point(q));
}

INSTANTIATE_TEST_SUITE_P(Families, Frame, ::testing::Range(std::size_t{0}, kNumbers.size()),
                         [](const auto& i) { return std::string(kNumbers[i.param].name); });

}  // namespace
}  // namespace plumb::frame_test
