// The locator of sets of the sphere against their own location and shooting, which look at
// everything.
#include "plumb/sphere/sphere_locator.h"

#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "generate/sphere_families.h"
#include "generate/sphere_program.h"
#include "plumb/predicates/error.h"
#include "plumb/sphere/nef_sphere.h"

namespace plumb::testing::sphere_locator_test {
namespace {

const SphereVector kX{1, 0, 0}, kY{0, 1, 0}, kZ{0, 0, 1};

void expect_located_alike(const NefSphere& set, const std::vector<SphereVector>& directions) {
  SphereLocator locator(set);
  for (std::size_t i = 0; i < directions.size(); ++i) {
    const SphereVector& u = directions[i];
    EXPECT_EQ(locator.locate(u), set.locate(u)) << i;
    EXPECT_EQ(locator.contains(u), set.contains(u)) << i;
    const SphereVector& v = directions[(i + 1) % directions.size()];
    if (cross(u, v).is_zero()) continue;
    const auto expect_hit = [&](const std::optional<SphereHit>& a,
                                const std::optional<SphereHit>& b) {
      ASSERT_EQ(a.has_value(), b.has_value()) << i;
      if (!a) return;
      EXPECT_EQ(a->location, b->location) << i;
      EXPECT_TRUE(is_same_direction(a->point, b->point)) << i;
    };
    expect_hit(locator.shoot(u, v), set.shoot(u, v));
    expect_hit(locator.shoot_to_boundary(u, v), set.shoot_to_boundary(u, v));
  }
}

TEST(SphereLocator, TakesSetsOfFewThings) {
  std::vector<SphereVector> directions = any_directions(20, 3);
  for (const SphereVector& axis : {kX, kY, kZ}) {
    directions.push_back(axis);
    directions.push_back(axis.opposite());
  }
  directions.insert(directions.end(), {{1, 1, 0}, {1, 0, 1}, {0, 1, -1}, {-1, -1, -1}});
  const NefSphere points = NefSphere::points(std::vector{kX, kZ.opposite(), SphereVector{1, 1, 1}});
  const NefSphere loop = NefSphere::circle({1, 2, 0});
  expect_located_alike(NefSphere::empty(), directions);
  expect_located_alike(NefSphere::whole(), directions);
  expect_located_alike(points, directions);
  expect_located_alike(!points, directions);
  expect_located_alike(loop, directions);
  expect_located_alike(loop + points, directions);
  expect_located_alike(NefSphere::half_sphere(kZ, Boundary::Open), directions);
  // From a point to itself, and longer than a half-circle.
  expect_located_alike(loop - NefSphere::point(kZ), directions);
  expect_located_alike(NefSphere::arc(kX, {1, -1, 0}, kZ), directions);
}

// Far from a small set most circles meet nothing.
TEST(SphereLocator, GoesTheOtherWayWhenACircleMeetsNothing) {
  const double e = 1e-6;
  const NefSphere grain = NefSphere::polygon(
      std::vector<SphereVector>{{1, 1, 1}, {1 + e, 1, 1}, {1, 1 + e, 1}}, Boundary::Closed);
  expect_located_alike(grain, any_directions(40, 5));
  expect_located_alike(!grain, any_directions(40, 6));
}

// Nearly parallel planes name what doubles cannot tell apart.
TEST(SphereLocator, TellsWhatIsCloserThanDoubles) {
  const double e = 0x1p-600;
  std::vector<SphereVector> directions{{1, 0, 0},  {1, e, 0},  {1, 0, e},        {1, e, e},
                                       {1, -e, e}, {1, e, -e}, {1, 2 * e, e},    {e, 1, 1},
                                       {-1, e, 0}, {e, e, 1},  {1, e / 2, e / 4}};
  const NefSphere grain = NefSphere::polygon(
      std::vector<SphereVector>{{1, 0, 0}, {1, e, 0}, {1, 0, e}}, Boundary::Open);
  expect_located_alike(grain, directions);
  expect_located_alike(grain + NefSphere::half_sphere({e, 1, 0}, Boundary::Open), directions);
  expect_located_alike(NefSphere::arc({1, 0, 0}, {1, e, e}) + grain, directions);
}

TEST(SphereLocator, RefusesWhatIsNoDirectionAndGoesOn) {
  SphereLocator locator(NefSphere::half_sphere(kZ, Boundary::Closed));
  EXPECT_THROW((void)locator.locate({0, 0, 0}), Error);
  EXPECT_THROW((void)locator.shoot(kX, kX.opposite()), Error);
  SphereLocator moved(std::move(locator));
  EXPECT_TRUE(moved.contains(kZ));
  EXPECT_TRUE(moved.has_on_boundary(kX));
  for (const SphereVector& u : any_directions(500, 7)) {  // more planes than are kept
    EXPECT_EQ(moved.contains(u), u.z >= 0);
  }
}

TEST(SphereLocator, AsksFewOfManyThings) {
  const auto asked_of = [](const NefSphere& set) {
    SphereLocator locator(set);
    const std::vector<SphereVector> directions = any_directions(300, 8);
    for (std::size_t i = 0; i + 1 < directions.size(); i += 2) {
      (void)locator.locate(directions[i]);
      (void)locator.shoot(directions[i], directions[i + 1]);
      (void)locator.shoot_to_boundary(directions[i], directions[i + 1]);
    }
    return static_cast<double>(locator.asked()) / 450;
  };
  const auto expect_few = [&](const char* name, const NefSphere& small, const NefSphere& large) {
    SCOPED_TRACE(name);
    const double few = asked_of(small);
    const double many = asked_of(large);
    RecordProperty(std::string(name) + "_small", std::to_string(few));
    RecordProperty(std::string(name) + "_large", std::to_string(many));
    const double growth =
        static_cast<double>(large.map().arc_count()) / static_cast<double>(small.map().arc_count());
    EXPECT_LT(many, few * std::pow(growth, 0.3));
  };
  EXPECT_FALSE(scattered_triangles(300).audit().has_value());
  expect_located_alike(scattered_triangles(300), any_directions(60, 9));
  expect_few("triangles", scattered_triangles(333), scattered_triangles(33333));
  expect_located_alike(crown(400, 0, 0.5, 1.5), any_directions(60, 10));
  expect_few("crown", crown(200, 0, 0.5, 1.5), crown(6000, 0, 0.5, 1.5));
}

}  // namespace
}  // namespace plumb::testing::sphere_locator_test
