// Sets that are made of points, segments and facets, held against laws of sets and against exact
// places.
#include "plumb/space/set/nef3_state.h"

#include <gtest/gtest.h>

#include <vector>

#include "generate/meshes.h"
#include "plumb/predicates/error.h"

namespace plumb::nef3_state_test {

TEST(Nef3State, UnitedIsTheUnion) {
  Context context;
  EXPECT_TRUE(united({}, context).is_empty());
  std::vector<Nef3> sets;
  for (int i = 0; i < 5; ++i) {
    sets.push_back(Nef3::from_mesh(testing::box_mesh({1.0 * i, 0, 0}, {i + 1.5, 2, 2})));
    sets.push_back(Nef3::segment({0, i, 5}, {4, i, 5}));
    Nef3 expected;
    for (const Nef3& set : sets) expected += set;
    EXPECT_EQ(united(sets, context), expected);
  }
}

TEST(Nef3State, SegmentsHoldWhatIsBetweenTheirEnds) {
  const RationalPoint3 a{1, 2, 3}, b{Rational(5, 3), 2, -1};
  const Nef3 segment = Nef3::segment(a, b);
  EXPECT_EQ(segment, Nef3::segment(b, a));
  EXPECT_EQ(Nef3::segment(a, a), Nef3::point(a));
  for (int i = -2; i <= 10; ++i) {
    const Rational s(i, 8);
    const RationalPoint3 p{a.x + s * (b.x - a.x), 2, a.z + s * (b.z - a.z)};
    EXPECT_EQ(segment.contains(p), i >= 0 && i <= 8) << i;
    EXPECT_FALSE(segment.contains(RationalPoint3{p.x, Rational(201, 100), p.z}));
  }
}

TEST(Nef3State, RefusesListsThatDoNotFit) {
  const std::vector<RationalPoint3> points{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}};
  using Begin = std::vector<std::uint32_t>;
  for (const Begin& begin : {Begin{}, Begin{1, 3}, Begin{0, 2}, Begin{0, 2, 1, 3}}) {
    EXPECT_THROW(static_cast<void>(Nef3::polylines(points, begin)), Error);
  }
  EXPECT_EQ(Nef3::polylines(points, Begin{0, 1, 3}),
            Nef3::point(points[0]) + Nef3::segment(points[1], points[2]));
  const std::vector<Point3> bow_tie{{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}};
  EXPECT_THROW(static_cast<void>(Nef3::facet(bow_tie)), Error);
}

// A ray along the x axis: an open volume is met where it begins.
TEST(Nef3State, RaysStopAtTheFirstMarkedCell) {
  const Nef3 box = Nef3::from_mesh(testing::box_mesh({1, -1, -1}, {3, 1, 1}));
  for (const Nef3& set : {box, box.interior()}) {
    const auto hit = set.shoot({0, 0, 0}, {2, 0, 0});
    ASSERT_TRUE(hit.has_value());
    EXPECT_EQ(hit->point, (RationalPoint3{1, 0, 0}));
  }
  EXPECT_FALSE(box.shoot({0, 0, 0}, {-1, 0, 0}).has_value());
  EXPECT_FALSE(box.interior().shoot({0, 1, 0}, {1, 0, 0}).has_value());
  EXPECT_TRUE(box.shoot({0, 1, 0}, {1, 0, 0}).has_value());
}

}  // namespace plumb::nef3_state_test
