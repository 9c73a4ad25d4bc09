// Points of space in integers of every width, against Cramer's rule in rational numbers. Corners
// have coordinates on the limits of the widths.
#include "plumb/predicates/space/point3_exact.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <set>
#include <vector>

#include "plumb/predicates/rational_point.h"
#include "testing/plumb/testing/dice.h"

namespace plumb::point3_exact_test {

using exact3::BigPlane;
using exact3::FixedPlane;
using exact3::Medium;
using exact3::Narrow;
using exact3::Part;
using exact3::PointOf;
using exact3::PointOperand;
using exact3::Wide;

using Vector3 = std::array<Rational, 3>;
/// n.x + d = 0
using Row = std::array<Rational, 4>;

Rational dot(const Row& row, const Vector3& v) {
  return row[0] * v[0] + row[1] * v[1] + row[2] * v[2];
}
Vector3 cross(const Row& a, const Row& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
Vector3 sum(const Vector3& a, const Vector3& b, const Rational& factor) {
  return {a[0] + factor * b[0], a[1] + factor * b[1], a[2] + factor * b[2]};
}
Vector3 vector(const Point3& p) { return {Rational(p.x), Rational(p.y), Rational(p.z)}; }

/// The coefficients, with a number in place of R for planes of the frame.
Row row_of(const PlaneTable& table, PlaneId p, int size = 1) {
  const IntegerRow row = table.coefficients(p);
  const Rational d = Rational(row[3]) * (table.is_frame(p) ? size : 1);
  return {Rational(row[0]), Rational(row[1]), Rational(row[2]), d};
}

/// The point of a source; none: its planes have none or many in common.
std::optional<Vector3> meeting(const PlaneTable& table, const PointSource& source, int size = 1) {
  const Row p = row_of(table, source.plane(0), size);
  if (source.is_line()) {
    const Vector3 a = vector(table.point(source.end(0))), b = vector(table.point(source.end(1)));
    const Rational at_a = dot(p, a) + p[3], at_b = dot(p, b) + p[3];
    if (at_a == at_b) return {};
    return sum(a, sum(b, a, -1), at_a / (at_a - at_b));
  }
  const Row q = row_of(table, source.plane(1), size), r = row_of(table, source.plane(2), size);
  const Rational w = dot(r, cross(p, q));
  if (w == 0) return {};
  Vector3 at = {0, 0, 0};
  at = sum(at, cross(q, r), -p[3] / w);
  at = sum(at, cross(r, p), -q[3] / w);
  return sum(at, cross(p, q), -r[3] / w);
}

Integer whole(const Integer& x) { return x; }
template <int L>
Integer whole(const Fixed<L>& x) {
  std::array<std::uint64_t, L> limbs;
  for (int i = 0; i < L; ++i) limbs[static_cast<std::size_t>(i)] = x.limb(i);
  return integer_from_limbs(limbs.data(), L);
}

template <class Plane>
Vector3 value_of(const PointOf<Plane>& p) {
  const Rational unit =
      p.scale >= 0 ? Rational(Integer(1) << p.scale) : Rational(1, Integer(1) << -p.scale);
  const Rational by = unit / Rational(whole(p.w));
  return {Rational(whole(p.x[0])) * by, Rational(whole(p.x[1])) * by, Rational(whole(p.x[2])) * by};
}

/// Planes through triples of points with coordinates of so many bits, all on the grid of unit 1.
struct Scene {
  PlaneTable table;
  std::vector<PlaneId> planes;
  Point3Table points{table};

  Scene(testing::Dice& dice, int bits) {
    const double top = std::ldexp(1, bits) - std::ldexp(1, bits - std::min(bits, 53));
    const auto coordinate = [&] {
      const double size[] = {0, 1, 3, top, std::ldexp(1, bits - 1)};
      return (dice.below(2) == 0 ? 1 : -1) * size[dice.below(5)];
    };
    for (int i = 0; i < 4; ++i) {
      const InputPointId p = table.add_point({1, coordinate(), top});
      table.add_point({coordinate(), -1, coordinate()});
      table.add_point({-top, coordinate(), 1});
      const auto id = [p](std::uint32_t k) { return InputPointId(p.value() + k); };
      const OrientedPlane plane = table.intern(p, id(1), id(2));
      planes.push_back(plane.is_valid() ? plane.plane() : PlaneId());
    }
  }
  bool is_good() const {
    return std::ranges::all_of(planes, [](PlaneId p) { return p.is_valid(); });
  }
  std::vector<PointSource> sources() const {
    std::vector<PointSource> all;
    for (std::uint32_t i = 0; i < 4; ++i) {
      all.push_back({planes[i], planes[(i + 1) % 4], planes[(i + 2) % 4]});
      all.push_back({InputPointId(3 * i), InputPointId((3 * i + 4) % 12), planes[(i + 2) % 4]});
    }
    return all;
  }
};

/// What a width that takes the operands has to say of them.
template <class Plane>
void check_width(const Scene& s) {
  const std::vector<PointSource> sources = s.sources();
  std::vector<PointOf<Plane>> found;
  std::vector<Vector3> expected;
  for (const PointSource& source : sources) {
    const std::optional<Vector3> at = meeting(s.table, source);
    if (!at) continue;
    PointOf<Plane> point;
    const PointOperand operand = exact3::operand(s.points, source);
    ASSERT_TRUE(exact3::load_point<Plane>(operand, Part::Finite, point));
    EXPECT_EQ(value_of<Plane>(point), *at);
    const IntegerRow row = exact3::integer_row(operand);
    for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(Rational(row[i], row[3]), (*at)[i]);
    found.push_back(point);
    expected.push_back(*at);
  }
  for (std::size_t i = 0; i < found.size(); ++i) {
    for (const PlaneId p : s.planes) {
      const Row row = row_of(s.table, p);
      const auto plane = exact3::load_as<Plane>(exact3::operand(s.table, p), Part::Finite);
      EXPECT_EQ(exact3::side_sign<Plane>(found[i], plane),
                filtered(sign_of((dot(row, expected[i]) + row[3]).sign())));
    }
    const std::size_t j = (i + 1) % found.size();
    for (std::size_t axis = 0; axis < 3; ++axis) {
      EXPECT_EQ(exact3::axis_order<Plane>(found[i], found[j], axis),
                filtered(sign_of(expected[i][axis].compare(expected[j][axis]))));
    }
  }
}

TEST(Point3Exact, WidthsOfBits) {
  const std::array<int, 4> most = {29, 61, 125, 2098};
  for (int width = 0; width < 4; ++width) {
    EXPECT_EQ(exact3::width_of_bits(most[static_cast<std::size_t>(width)]), width);
    if (width < 3) {
      EXPECT_EQ(exact3::width_of_bits(most[static_cast<std::size_t>(width)] + 1), width + 1);
    }
  }
  EXPECT_EQ(exact3::width_of_bits(0), 0);
}

TEST(Point3Exact, EveryWidthThatTakesAPointHasIt) {
  testing::Dice dice(1);
  for (const int bits : {2, 29, 30, 61, 62, 125, 126}) {
    for (int round = 0; round < 12; ++round) {
      const Scene s(dice, bits);
      if (!s.is_good()) continue;
      EXPECT_EQ(exact3::operand(s.points, s.sources()[0]).width, exact3::width_of_bits(bits));
      if (bits <= 29) check_width<FixedPlane<Narrow>>(s);
      if (bits <= 61) check_width<FixedPlane<Medium>>(s);
      if (bits <= 125) check_width<FixedPlane<Wide>>(s);
      check_width<BigPlane>(s);
    }
  }
}

/// Linear in R: the parts, with any number in place of it.
TEST(Point3Exact, PartsAddUpToThePointForAnyCube) {
  testing::Dice dice(2);
  for (unsigned round = 0; round < 30; ++round) {
    Scene s(dice, 20);
    if (!s.is_good()) continue;
    const auto frame = s.table.intern_frame();
    const PlaneId far = frame[dice.below(6)], other = frame[(dice.below(2) + 2 * round) % 6];
    for (const PointSource& source :
         {PointSource(far, s.planes[0], s.planes[1]), PointSource(far, other, s.planes[1]),
          PointSource(InputPointId(0), InputPointId(4), far)}) {
      const PointOperand operand = exact3::operand(s.points, source);
      EXPECT_TRUE(exact3::has_frame(operand));
      if (!meeting(s.table, source)) continue;
      PointOf<FixedPlane<Medium>> finite, infinite;
      ASSERT_TRUE(exact3::load_point<FixedPlane<Medium>>(operand, Part::Finite, finite));
      ASSERT_TRUE(exact3::load_point<FixedPlane<Medium>>(operand, Part::Infinite, infinite));
      for (const int size : {0, 1, 1000}) {
        EXPECT_EQ(
            sum(value_of<FixedPlane<Medium>>(finite), value_of<FixedPlane<Medium>>(infinite), size),
            *meeting(s.table, source, size));
      }
    }
    EXPECT_FALSE(exact3::has_frame(exact3::operand(s.points, s.sources()[0])));
  }
}

/// Two planes through two common points, in any order, and a third one.
TEST(Point3Exact, TwoPlanesThroughAnEdgeAndAThirdAreALine) {
  PlaneTable table;
  table.add_points(std::vector<Point3>{
      {0, 0, 0}, {1, 2, 3}, {4, 0, 1}, {0, 5, 1}, {7, 7, 2}, {1, 1, 9}, {-3, 2, 5}});
  const auto plane = [&](std::uint32_t i, std::uint32_t j, std::uint32_t k) {
    return table.intern(InputPointId(i), InputPointId(j), InputPointId(k)).plane();
  };
  std::array<PlaneId, 3> planes = {plane(0, 1, 2), plane(3, 1, 0), plane(4, 5, 6)};
  for (int turn = 0; turn < 3; ++turn) {
    std::rotate(planes.begin(), planes.begin() + 1, planes.end());
    const PointSource given(planes[0], planes[1], planes[2]);
    const PointSource line = exact3::as_line(table, given);
    ASSERT_TRUE(line.is_line());
    EXPECT_EQ(meeting(table, line), meeting(table, given));
  }
  const PlaneId far = table.intern_frame()[0];
  const PlaneId level = table.intern(0.0, 0.0, 1.0, -1.0).plane();
  const PlaneId wall = table.intern(1.0, 0.0, 0.0, -1.0).plane();
  for (const PointSource& source : {PointSource(plane(0, 1, 2), plane(0, 1, 3), far),
                                    PointSource(plane(0, 1, 2), plane(0, 3, 4), plane(1, 4, 5)),
                                    PointSource(level, wall, plane(0, 1, 2))}) {
    EXPECT_FALSE(exact3::as_line(table, source).is_line());
  }
  const PointSource with_level(plane(0, 1, 2), level, plane(0, 1, 3));
  EXPECT_TRUE(exact3::as_line(table, with_level).is_line());
}

/// However they are made; and of different points they differ.
TEST(Point3Exact, PrimitiveFingerprintsAreThoseOfPoints) {
  PlaneTable table;
  Point3Table points(table);
  std::set<std::uint64_t> seen;
  for (const double x : {-1.0, 0.0, 0.75}) {
    for (const double y : {0.0, 1.0}) {
      for (const double z : {0.0, 3.0}) {
        const InputPointId p = table.add_point({x, y, z}), q = table.add_point({x, y, z + 8});
        const PlaneId a = table.intern(1.0, 0.0, 0.0, -x).plane();
        const PlaneId b = table.intern(0.0, 4.0, 0.0, -4 * y).plane();
        const PlaneId c = table.intern(1.0, 1.0, 1.0, -x - y - z).plane();
        const Fingerprint input =
            exact3::primitive_fingerprint(exact3::operand(points, SpacePoint(p)));
        for (const PointSource& s : {PointSource(a, b, c), PointSource(c, b, a),
                                     PointSource(p, q, c), PointSource(q, p, c)}) {
          EXPECT_EQ(exact3::primitive_fingerprint(exact3::operand(points, s)), input);
        }
        EXPECT_TRUE(seen.insert(input).second);
      }
    }
  }
}

/// From the width of the operands upwards; whoever decides is counted, and it alone.
TEST(Point3Exact, TheLadderClimbsFromTheWidthOfTheOperands) {
  const std::array<Rung, 4> rungs = {Rung::Small, Rung::Exact, Rung::Exact, Rung::Big};
  for (int width = 0; width < 4; ++width) {
    for (int decides = width; decides < 4; ++decides) {
      std::vector<int> asked;
      std::vector<Rung> counted;
      const auto question = [&]<class Plane>() {
        int here = 3;
        if constexpr (std::is_same_v<Plane, FixedPlane<Narrow>>) here = 0;
        if constexpr (std::is_same_v<Plane, FixedPlane<Medium>>) here = 1;
        if constexpr (std::is_same_v<Plane, FixedPlane<Wide>>) here = 2;
        asked.push_back(here);
        return here == decides ? FilteredSign::Negative : FilteredSign::Unsure;
      };
      EXPECT_EQ(exact3::point_ladder(width, question, [&](Rung r) { counted.push_back(r); }),
                Sign::Negative);
      std::vector<int> expected;
      for (int i = width; i <= decides; ++i) expected.push_back(i);
      EXPECT_EQ(asked, expected);
      EXPECT_EQ(counted, std::vector<Rung>{rungs[static_cast<std::size_t>(decides)]});
    }
  }
}

}  // namespace plumb::point3_exact_test
