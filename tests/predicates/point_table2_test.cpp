// PointTable2 and Crossing2 against Boost cpp_rational.
#include "plumb/predicates/point_table2.h"

#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_int.hpp>
#include <random>

namespace plumb {
namespace {

using Exact = boost::multiprecision::cpp_rational;
struct Oracle {
  Exact x, y;
};

Exact cross(const Oracle& a, const Oracle& b, const Oracle& c, const Oracle& d) {
  return (b.x - a.x) * (d.y - c.y) - (b.y - a.y) * (d.x - c.x);
}
Oracle meet(const Oracle& a, const Oracle& b, const Oracle& c, const Oracle& d) {
  const Exact t = cross(a, c, c, d) / cross(a, b, c, d);
  return {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)};
}
Sign compare(const Oracle& p, const Oracle& q) {
  return p.x != q.x ? sign_of(Exact(p.x - q.x)) : sign_of(Exact(p.y - q.y));
}

struct Points {
  PointTable2 table;
  std::vector<Oracle> oracle;
  void add(int x, int y, int w) {
    table.push_back(Rational(x, w), Rational(y, w));
    oracle.push_back({Exact(x, w), Exact(y, w)});
  }
};

Points random_points(std::mt19937_64& random, int range, int denominators) {
  std::uniform_int_distribution<int> coordinate(-range, range);
  std::uniform_int_distribution<int> denominator(1, denominators);
  Points p;
  for (int i = 0; i < 8; ++i) p.add(coordinate(random), coordinate(random), denominator(random));
  return p;
}

void check_all(const Points& p) {
  const auto& o = p.oracle;
  EXPECT_EQ(compare_xy(p.table, 0, 1), compare(o[0], o[1]));
  EXPECT_EQ(orient2d(p.table, 0, 1, 2), sign_of(cross(o[0], o[1], o[0], o[2])));
  const Exact first = cross(o[0], o[1], o[2], o[3]);
  const Exact second = cross(o[4], o[5], o[6], o[7]);
  EXPECT_EQ(cross_sign(p.table, 0, 1, 2, 3), sign_of(first));
  if (first == 0 || second == 0) return;
  const Oracle m = meet(o[0], o[1], o[2], o[3]);
  const Oracle n = meet(o[4], o[5], o[6], o[7]);
  const Crossing2 c = make_crossing(p.table, 0, 1, 2, 3);
  const Crossing2 d = make_crossing(p.table, 4, 5, 6, 7);
  EXPECT_EQ(compare_xy(p.table, c, d), compare(m, n));
  EXPECT_EQ(compare_xy(p.table, c, 4), compare(m, o[4]));
  EXPECT_EQ(orient2d(p.table, 4, 5, c), sign_of(cross(o[4], o[5], o[4], m)));
  EXPECT_EQ(exact(p.table, c).x.str(), m.x.str());
  EXPECT_EQ(exact(p.table, c).y.str(), m.y.str());
}

TEST(PointTable2, SmallIntegersAndFractions) {
  std::mt19937_64 random(20250101);
  for (int round = 0; round < 2000; ++round) {
    check_all(random_points(random, 3, 1));
    check_all(random_points(random, 4, 3));
    check_all(random_points(random, 1 << 30, 1 << 30));
  }
}

}  // namespace
}  // namespace plumb
