// The limits of the fixed widths: a rung answers exactly when its operands fit (plane_exact.h,
// (L)), and rightly for the largest that do.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "fixed_rungs.h"
#include "generate/space_cases.h"
#include "plumb/predicates/plane_signs.h"
#include "plumb/predicates/point3_signs.h"
#include "plumb/predicates/space/point3_table.h"
#include "space_oracle.h"

namespace plumb::plane_exact_test {
namespace {

using cases::integer;
using cases::Random;
using fixed_rungs::Fixed3;
using oracle::Int;
using oracle::Row;
using oracle::sgn;

/// What a width holds, in limbs and in bits of coordinates.
struct Width {
  const char* name;
  int normal, offset, bits;
  int normal_bits() const { return 64 * normal - 3; }
  int offset_bits() const { return 64 * offset - 2; }
};
constexpr std::array<Width, 3> kWidths = {
    {{"narrow", 1, 2, 29}, {"medium", 2, 3, 61}, {"wide", 4, 6, 125}}};

void expect_right(const char* what, const Fixed3& rungs, Sign big, int expected) {
  for (std::size_t w = 0; w < 3; ++w) {
    if (is_decided(rungs[w])) {
      EXPECT_EQ(static_cast<int>(decided(rungs[w])), expected) << what << " " << kWidths[w].name;
    }
  }
  EXPECT_EQ(static_cast<int>(big), expected) << what;
}

/// From the width `least` on all must have answered; none below.
void expect_reach(const char* what, const Fixed3& rungs, std::size_t least) {
  for (std::size_t w = 0; w < 3; ++w) {
    EXPECT_EQ(is_decided(rungs[w]), w >= least) << what << " " << kWidths[w].name;
  }
}

struct World {
  PlaneTable table;
  Point3Table points{table};
  std::vector<PlaneId> planes;
  std::vector<Row> rows;  // canonical, on the unit 1

  /// a x + b y + c z + d 2^scale = 0
  void add(const Row& row, int scale) {
    const auto rational = [](const Int& x) { return Rational(Integer(x.str())); };
    Rational unit = Integer(1) << static_cast<unsigned>(std::abs(scale));
    if (scale < 0) unit = 1 / unit;
    const OrientedPlane p = table.intern(rational(row[0]), rational(row[1]), rational(row[2]),
                                         Rational(rational(row[3]) * unit));
    Row whole = row;
    if (scale > 0) whole[3] <<= scale;
    for (std::size_t i = 0; i < 3 && scale < 0; ++i) whole[i] <<= -scale;
    add(p, whole);
  }
  void add(OrientedPlane p, const Row& row) {
    ASSERT_TRUE(p.is_valid());
    planes.push_back(p.plane());
    rows.push_back(oracle::canonical(row));
  }
  std::array<PlaneId, 4> ids() const { return {planes[0], planes[1], planes[2], planes[3]}; }
};

/// An odd integer of exactly so many bits: the largest, the least, or any. (Common powers of two
/// would be taken out.)
Int of_bits(Random& r, int bits) {
  const Int top = Int(1) << (bits - 1);
  Int x = top + 1;
  if (integer(r, 0, 3) != 0) x = 2 * top - 1;
  if (bits > 40 && integer(r, 0, 3) == 0) x -= Int(integer(r, 0, 1 << 30)) << 1;
  if (bits == 1) x = 1;
  return integer(r, 0, 1) == 0 ? x : Int(-x);
}

Row row_of_bits(Random& r, int normal_bits, int offset_bits) {
  return {of_bits(r, normal_bits), of_bits(r, normal_bits), of_bits(r, normal_bits),
          of_bits(r, offset_bits)};
}

void check_all(const World& w, std::size_t det3_least, std::size_t det4_least) {
  const auto& r = w.rows;
  const auto p = w.ids();
  const Fixed3 det4 = fixed_rungs::det4(w.table, p[0], p[1], p[2], p[3]);
  const Fixed3 det3 = fixed_rungs::det3(w.table, p[0], p[1], p[2]);
  expect_right("det4", det4,
               rung::det4_big(w.table, w.planes[0], w.planes[1], w.planes[2], w.planes[3]),
               sgn(oracle::det4(r[0], r[1], r[2], r[3])));
  expect_right("det3", det3, rung::det3_big(w.table, w.planes[0], w.planes[1], w.planes[2]),
               sgn(oracle::det3(r[0], r[1], r[2])));
  expect_reach("det4", det4, det4_least);
  expect_reach("det3", det3, det3_least);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::size_t j = (axis + 1) % 3, k = (axis + 2) % 3;
    expect_right("minor", fixed_rungs::minor(w.table, p[0], p[1], axis),
                 rung::minor_big(w.table, w.planes[0], w.planes[1], axis),
                 sgn(Int(r[0][j] * r[1][k] - r[0][k] * r[1][j])));
  }
}

/// Points of three planes, and their sides and orders.
void check_points(World& w, Random& random, std::size_t least) {
  const std::array<SpacePoint, 2> x = {w.points.add(w.planes[0], w.planes[1], w.planes[2]),
                                       w.points.add(w.planes[3], w.planes[1], w.planes[2])};
  if (!x[0].is_valid() || !x[1].is_valid()) return;
  const Row p = oracle::common_point(w.rows[0], w.rows[1], w.rows[2]);
  const Row q = oracle::common_point(w.rows[3], w.rows[1], w.rows[2]);
  const Fixed3 side = fixed_rungs::side(w.points, x[0], w.planes[3]);
  expect_right("side", side, rung::side_big(w.points, x[0], w.planes[3]),
               oracle::side(w.rows[3], p));
  expect_reach("side", side, least);
  const auto axis = static_cast<std::size_t>(integer(random, 0, 2));
  const Fixed3 order = fixed_rungs::compare_axis(w.points, x[0], x[1], axis);
  expect_right("order", order, rung::compare_axis_big(w.points, x[0], x[1], axis),
               oracle::compare_axis(p, q, axis));
  expect_reach("order", order, least);
}

TEST(PlaneWidths, HoldCoefficientsUpToTheirLimits) {
  Random random(71);
  for (std::size_t w = 0; w < 3; ++w) {
    for (int more_normal = -1; more_normal <= 1; ++more_normal) {
      for (int more_offset = -1; more_offset <= 1; ++more_offset) {
        SCOPED_TRACE(std::string(kWidths[w].name) + " " + std::to_string(more_normal) + " " +
                     std::to_string(more_offset));
        const std::size_t least = more_normal > 0 || more_offset > 0 ? w + 1 : w;
        for (int i = 0; i < 40; ++i) {
          World world;
          for (int k = 0; k < 4; ++k) {
            world.add(row_of_bits(random, kWidths[w].normal_bits() + more_normal,
                                  kWidths[w].offset_bits() + more_offset),
                      0);
          }
          check_all(world, least, least);
          check_points(world, random, least);
        }
      }
    }
  }
}

/// One plane that does not fit is enough, whichever it is.
TEST(PlaneWidths, AreThoseOfTheWidestPlane) {
  Random random(72);
  for (std::size_t w = 0; w < 3; ++w) {
    for (int wide = 0; wide < 4; ++wide) {
      World world;
      for (int k = 0; k < 4; ++k) {
        world.add(row_of_bits(random, k == wide ? kWidths[w].normal_bits() + 1 : 20, 20), 0);
      }
      check_all(world, wide < 3 ? w + 1 : 0, w + 1);
    }
  }
}

/// Offsets are brought to the least scale of all.
TEST(PlaneWidths, HoldOffsetsOnACommonScale) {
  Random random(73);
  for (std::size_t w = 0; w < 3; ++w) {
    for (int more = -2; more <= 2; ++more) {
      for (int i = 0; i < 20; ++i) {
        SCOPED_TRACE(std::string(kWidths[w].name) + " " + std::to_string(more));
        const int low = integer(random, -90, 90), bits = integer(random, 2, 30);
        World world;
        world.add(row_of_bits(random, 20, bits), low + kWidths[w].offset_bits() + more - bits);
        world.add(row_of_bits(random, 20, 20), low);
        world.add(row_of_bits(random, 20, 20), low + 1);
        Row through_origin = row_of_bits(random, 20, 20);
        through_origin[3] = 0;
        world.add(through_origin, 0);
        check_all(world, more > 0 ? w + 1 : w, more > 0 ? w + 1 : w);
      }
    }
  }
}

/// Coordinates below 2^bits: 1, the largest and the least of full width, with few bits of their
/// own.
double coordinate(Random& r, int bits) {
  const int low = std::max(bits - 53, 0);
  const double values[] = {1, std::ldexp(1, bits - 1), std::ldexp(1, bits) - std::ldexp(1, low),
                           std::ldexp(1, bits) - std::ldexp(integer(r, 1, 1000), low)};
  const double x = values[integer(r, 0, 3)];
  return integer(r, 0, 1) == 0 ? x : -x;
}
Point3 full_point(Random& r, int bits) {
  const double x = coordinate(r, bits), y = coordinate(r, bits);
  return {x, y, coordinate(r, bits)};
}
/// On the grid of whole numbers and as wide as that.
Point3 spanning_point(Random& r, int bits) {
  const double x = coordinate(r, bits);
  return {x, integer(r, 0, 1) == 0 ? 1.0 : -1.0,
          std::ldexp(1, bits) - std::ldexp(1, std::max(bits - 53, 0))};
}

struct Input {
  InputPointId id;
  Row row;
};
Input add_input(World& w, const Point3& p) {
  return {w.table.add_point(p), oracle::point_row(p, 0)};
}

void add_triangle(World& w, Random& r, int bits) {
  for (;;) {
    const Input a = add_input(w, spanning_point(r, bits)), b = add_input(w, full_point(r, bits)),
                c = add_input(w, full_point(r, bits));
    const Row row = oracle::plane_through(a.row, b.row, c.row);
    if (oracle::is_plane(row)) return w.add(w.table.intern(a.id, b.id, c.id), row);
  }
}

/// Input points and points on lines, with planes through corners of the same width.
void check_inputs(World& w, Random& random, int bits, std::size_t least) {
  const Input a = add_input(w, spanning_point(random, bits)),
              b = add_input(w, full_point(random, bits)),
              c = add_input(w, spanning_point(random, bits));
  const SpacePoint input(c.id), line = w.points.add(a.id, b.id, w.planes[0]);
  const auto check = [&](SpacePoint x, const Row& at) {
    const Fixed3 side = fixed_rungs::side(w.points, x, w.planes[1]);
    expect_right("side", side, rung::side_big(w.points, x, w.planes[1]),
                 oracle::side(w.rows[1], at));
    expect_reach("side", side, least);
    const auto axis = static_cast<std::size_t>(integer(random, 0, 2));
    const Fixed3 order = fixed_rungs::compare_axis(w.points, x, input, axis);
    expect_right("order", order, rung::compare_axis_big(w.points, x, input, axis),
                 oracle::compare_axis(at, c.row, axis));
    expect_reach("order", order, least);
  };
  check(input, c.row);
  if (line.is_valid()) check(line, oracle::line_point(a.row, b.row, w.rows[0]));
}

TEST(PlaneWidths, HoldCornersUpToTheirLimits) {
  Random random(74);
  for (std::size_t w = 0; w < 3; ++w) {
    for (int more = -1; more <= 1; ++more) {
      const int bits = kWidths[w].bits + more;
      SCOPED_TRACE(bits);
      const std::size_t least = more > 0 ? w + 1 : w;
      for (int i = 0; i < 60; ++i) {
        World world;
        for (int k = 0; k < 4; ++k) add_triangle(world, random, bits);
        check_all(world, least, least);
        check_points(world, random, least);
        check_inputs(world, random, bits, least);
      }
    }
  }
}

/// Coordinates on scales so far apart that a shift all but breaks the width, or does.
TEST(PlaneWidths, NoWrongAnswerWhereScalesBreak) {
  Random random(75);
  for (std::size_t w = 0; w < 3; ++w) {
    const int numerator_bits = 64 * (kWidths[w].offset + 2 * kWidths[w].normal);
    for (int shift = -numerator_bits - 12; shift <= numerator_bits + 12; ++shift) {
      SCOPED_TRACE(std::string(kWidths[w].name) + " " + std::to_string(shift));
      World world;
      for (int k = 0; k < 6; ++k) world.add(row_of_bits(random, 8, 8), k < 3 ? 0 : shift);
      const std::array<SpacePoint, 2> x = {
          world.points.add(world.planes[0], world.planes[1], world.planes[2]),
          world.points.add(world.planes[3], world.planes[4], world.planes[5])};
      const std::array<Row, 2> at = {
          oracle::common_point(world.rows[0], world.rows[1], world.rows[2]),
          oracle::common_point(world.rows[3], world.rows[4], world.rows[5])};
      if (!x[0].is_valid() || !x[1].is_valid()) continue;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        expect_right("order", fixed_rungs::compare_axis(world.points, x[0], x[1], axis),
                     rung::compare_axis_big(world.points, x[0], x[1], axis),
                     oracle::compare_axis(at[0], at[1], axis));
      }
      for (const std::size_t k : {0u, 1u}) {
        const PlaneId plane = world.planes[3 - 3 * k];
        expect_right("side", fixed_rungs::side(world.points, x[k], plane),
                     rung::side_big(world.points, x[k], plane),
                     oracle::side(world.rows[3 - 3 * k], at[k]));
      }
    }
  }
}

}  // namespace
}  // namespace plumb::plane_exact_test
