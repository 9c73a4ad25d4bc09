// Points that are in no table, against planes and points of one: every question by rationals.
#include "plumb/predicates/space/query_point3.h"

#include <gtest/gtest.h>

#include <vector>

#include "float_environment.h"
#include "generate/space_cases.h"
#include "plumb/predicates/rounding.h"

namespace plumb::query_point3_test {
namespace {

using cases::integer;
using cases::Random;

RationalPoint3 rational(const Point3& p) {
  return {exact_rational(p.x), exact_rational(p.y), exact_rational(p.z)};
}

/// A table with planes of every kind, the cube's first, and points of every kind.
struct World {
  PlaneTable table;
  Point3Table points{table};
  std::vector<PlaneId> planes;
  std::vector<SpacePoint> ids;
  std::vector<Point3> corners;

  explicit World(Random& r) {
    const std::array<PlaneId, 6> frame = table.intern_frame();
    planes.assign(frame.begin(), frame.end());
    for (int i = 0; i < 6; ++i) {
      for (int k = 0; k < 3; ++k) corners.push_back(cases::grid_point(r, integer(r, 0, 8), 2));
      const auto first = table.add_points(std::span(corners).last(3)).value();
      add(table.intern(InputPointId(first), InputPointId(first + 1), InputPointId(first + 2)));
      const Point3 n = cases::grid_point(r, 2, 2);
      add(table.intern(n.x, n.y, n.z, integer(r, -3, 3)));
    }
    for (int i = 0; i < 12; ++i) {
      add(points.add(any_plane(r), any_plane(r), any_plane(r)));
      add(points.add(any_input(r), any_input(r), any_plane(r)));
      ids.emplace_back(any_input(r));
    }
  }
  void add(OrientedPlane p) {
    if (p.is_valid()) planes.push_back(p.plane());
  }
  void add(SpacePoint p) {
    if (p.is_valid()) ids.push_back(p);
  }
  PlaneId any_plane(Random& r) const {
    return planes[static_cast<std::size_t>(integer(r, 0, static_cast<int>(planes.size()) - 1))];
  }
  InputPointId any_input(Random& r) const {
    return InputPointId(
        static_cast<std::size_t>(integer(r, 0, static_cast<int>(corners.size()) - 1)));
  }
};

/// On the plane of three corners, or a hair beside it; doubles, or fractions that are none, or
/// beyond all doubles.
std::vector<RationalPoint3> queries(const World& w, Random& r) {
  std::vector<RationalPoint3> result;
  for (std::size_t i = 0; i < w.corners.size(); i += 3) {
    const RationalPoint3 a = rational(w.corners[i]), b = rational(w.corners[i + 1]),
                         c = rational(w.corners[i + 2]);
    const Rational s = Rational(integer(r, -4, 4)) / integer(r, 1, 4), t = integer(r, -2, 2);
    RationalPoint3 p{a.x + s * (b.x - a.x) + t * (c.x - a.x),
                     a.y + s * (b.y - a.y) + t * (c.y - a.y),
                     a.z + s * (b.z - a.z) + t * (c.z - a.z)};
    result.push_back(p);
    p.x += Rational(integer(r, -1, 1)) / (Integer(1) << static_cast<unsigned>(integer(r, 30, 90)));
    result.push_back(p);
    p.z += Rational(integer(r, -1, 1)) * (Integer(1) << 1100);
    result.push_back(p);
  }
  for (const SpacePoint x : w.ids) {
    if (!w.points.depends_on_frame(x)) result.push_back(exact(w.points, x));
  }
  return result;
}

/// The cube lies on the positive side of its planes at -R and on the negative side of those at R,
/// which follow each other.
Sign expected_side(const World& w, const RationalPoint3& q, std::size_t plane) {
  if (plane < 6) return plane % 2 == 0 ? Sign::Positive : Sign::Negative;
  const IntegerRow row = w.table.coefficients(w.planes[plane]);
  return sign_of(Rational(row[0] * q.x + row[1] * q.y + row[2] * q.z + row[3]).sign());
}

Sign expected_order(const World& w, SpacePoint x, const RationalPoint3& q, std::size_t axis) {
  const FramedPoint3 at = exact_parts(w.points, x);
  const Sign far = sign_of(coordinate(at.infinite, axis).sign());
  if (far != Sign::Zero) return far;
  return sign_of(Rational(coordinate(at.finite, axis) - coordinate(q, axis)).sign());
}

void check(const World& w, const QueryPoint3& query, const RationalPoint3& q,
           const testing_environment::Setting& mode) {
  EXPECT_EQ(query.exact(), q);
  for (std::size_t i = 0; i < w.planes.size(); ++i) {
    Sign sign;
    {
      const testing_environment::Scope scope(mode);
      sign = side(w.points, query, w.planes[i]);
    }
    EXPECT_EQ(sign, expected_side(w, q, i)) << mode.name << ", plane " << i;
  }
  for (const SpacePoint x : w.ids) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      Sign sign;
      {
        const testing_environment::Scope scope(mode);
        sign = compare_axis(w.points, x, query, axis);
      }
      EXPECT_EQ(sign, expected_order(w, x, q, axis)) << mode.name << ", axis " << axis;
    }
  }
}

TEST(QueryPoint3, IsWhereTheRationalsSay) {
  Random random(81);
  for (std::size_t round = 0; round < 16 && !HasFailure(); ++round) {
    const auto& mode = testing_environment::kSettings[round % 8];
    const World w(random);
    for (const RationalPoint3& q : queries(w, random)) {
      const QueryPoint3 query(q);
      const Point3 p{query.box().mid[0], query.box().mid[1], query.box().mid[2]};
      EXPECT_EQ(query.is_double(), rational(p) == q);
      check(w, query, q, mode);
      check(w, QueryPoint3(p), rational(p), mode);
      const QueryPoint3 rounded(p);
      EXPECT_EQ(rounded.parts().finite, rational(p));
      EXPECT_EQ(rounded.parts().infinite, (RationalPoint3{0, 0, 0}));
    }
  }
}

/// Those of a table answer as the table does.
TEST(QueryPoint3, OfATableIsThatPoint) {
  Random random(82);
  for (int round = 0; round < 8; ++round) {
    const World w(random);
    for (const SpacePoint p : w.ids) {
      const QueryPoint3 query(w.points, p);
      EXPECT_EQ(query.source(), p);
      EXPECT_EQ(query.parts().finite, exact_parts(w.points, p).finite);
      EXPECT_EQ(query.parts().infinite, exact_parts(w.points, p).infinite);
      for (const PlaneId plane : w.planes) {
        EXPECT_EQ(side(w.points, query, plane), side(w.points, p, plane));
      }
      for (const SpacePoint x : w.ids) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
          EXPECT_EQ(compare_axis(w.points, x, query, axis), compare_axis(w.points, x, p, axis));
        }
      }
    }
  }
}

}  // namespace
}  // namespace plumb::query_point3_test
