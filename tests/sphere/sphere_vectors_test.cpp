// Checks vectors as planes and directions of a table and back, and the sets to start from against
// the inequalities that define them.
#include "plumb/sphere/set/sphere_vectors.h"

#include <gtest/gtest.h>

#include <array>
#include <limits>
#include <vector>

#include "plumb/predicates/error.h"
#include "plumb/predicates/plane_signs.h"
#include "plumb/testing/dice.h"

namespace plumb::sphere_vectors_test {

using testing::Dice;

SphereVector any_vector(Dice& dice) {
  while (true) {
    const auto any = [&] { return Rational(Rational(dice.between(-2, 2)) / dice.between(1, 3)); };
    const SphereVector v(any(), any(), any());
    if (!v.is_zero()) return v;
  }
}

template <class Work>
ErrorCode refusal(const Work& work) {
  try {
    work();
  } catch (const Error& e) {
    return e.code();
  }
  return ErrorCode::Usage;
}

/// Whether the coordinates are integers without a common prime factor up to 7.
bool is_in_lowest_terms(const SphereVector& v) {
  for (const int prime : {2, 3, 5, 7}) {
    const auto divides = [&](const Rational& x) { return denominator(Rational(x / prime)) == 1; };
    if (divides(v.x) && divides(v.y) && divides(v.z)) return false;
  }
  return denominator(v.x) == 1 && denominator(v.y) == 1 && denominator(v.z) == 1;
}

TEST(SphereVectors, DirectionsComeOutAsTheyWentIn) {
  PlaneTable planes;
  Dice dice(1);
  for (int round = 0; round < 300; ++round) {
    const SphereVector v = any_vector(dice);
    const SphereVector back = exact_direction(planes, intern_direction(planes, v));
    EXPECT_TRUE(is_same_direction(v, back));
    EXPECT_TRUE(is_in_lowest_terms(back));
    const OrientedPlane circle = intern_circle(planes, v);
    const SphereVector normal = exact_normal(planes, circle.plane());
    EXPECT_TRUE(is_same_direction(circle.is_opposite() ? v.opposite() : v, normal));
    EXPECT_TRUE(is_in_lowest_terms(normal));
  }
  const SphereVector zero(0.0, 0.0, 0.0);
  EXPECT_EQ(refusal([&] { intern_direction(planes, zero); }), ErrorCode::BadArgument);
  EXPECT_EQ(refusal([&] { intern_circle(planes, zero); }), ErrorCode::BadArgument);
  const double infinite = std::numeric_limits<double>::infinity();
  EXPECT_EQ(refusal([&] { SphereVector(0, 0, infinite); }), ErrorCode::NotFinite);
}

/// Parallel planes become one circle, and nothing else changes but the offsets.
TEST(SphereVectors, CentredPlanesPassThroughTheCentre) {
  PlaneTable planes;
  const PlaneId a = planes.intern(2.0, 4.0, 0.0, 3.0).plane();
  const PlaneId b = planes.intern(-1.0, -2.0, 0.0, 5.0).plane();
  const PlaneId c = planes.intern(0.0, 1.0, 1.0, -7.0).plane();
  ASSERT_NE(a, b);
  SphereMap map;
  map.circle = {a, b, c};
  map.direction = {{a, c}, {c, b}};
  const SphereMap before = map;
  const auto table = centred(planes, map);
  EXPECT_EQ(map.circle[0], map.circle[1]);
  EXPECT_NE(map.circle[0], map.circle[2]);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(table->coefficients(map.circle[i])[3], 0);
    EXPECT_EQ(exact_normal(*table, map.circle[i]), exact_normal(planes, before.circle[i]));
  }
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(exact_direction(*table, map.direction[i]),
              exact_direction(planes, before.direction[i]));
  }
}

TEST(SphereVectors, HalfSpheresAndCirclesAreSignsOfInnerProducts) {
  Dice dice(2);
  for (int round = 0; round < 100; ++round) {
    const SphereVector n = any_vector(dice);
    const NefSphere open = NefSphere::half_sphere(n, Boundary::Open);
    const NefSphere closed = NefSphere::half_sphere(n, Boundary::Closed);
    const NefSphere circle = NefSphere::circle(n);
    for (int i = 0; i < 5; ++i) {
      const SphereVector u = any_vector(dice);
      EXPECT_EQ(open.contains(u), dot(n, u) > 0);
      EXPECT_EQ(closed.contains(u), dot(n, u) >= 0);
      EXPECT_EQ(circle.contains(u), dot(n, u) == 0);
    }
    const SphereVector on = cross(n, any_vector(dice));
    if (on.is_zero()) continue;
    EXPECT_TRUE(!open.contains(on) && closed.contains(on) && circle.contains(on));
  }
}

TEST(SphereVectors, ArcsRunCounterClockwiseAboutTheirNormals) {
  Dice dice(3);
  for (int round = 0; round < 60; ++round) {
    const SphereVector from = any_vector(dice);
    const SphereVector n = cross(from, any_vector(dice));
    if (n.is_zero()) continue;
    const SphereVector ahead = cross(n, from);
    const std::vector<SphereVector> around{from, ahead, from.opposite(), ahead.opposite()};
    for (std::size_t end = 0; end < 4; ++end) {
      for (const Boundary boundary : {Boundary::Open, Boundary::Closed}) {
        const NefSphere arc = NefSphere::arc(from, around[end], n, boundary);
        for (std::size_t i = 0; i < 4; ++i) {
          const bool is_end = i == 0 || i == end;
          const bool is_inside = end == 0 || i < end;
          EXPECT_EQ(arc.contains(around[i]), is_end ? boundary == Boundary::Closed : is_inside);
        }
        EXPECT_FALSE(arc.contains(n));
      }
    }
  }
  const SphereVector x(1, 0, 0), z(0, 0, 1), off(1, 1, 1);
  EXPECT_EQ(refusal([&] { (void)NefSphere::arc(x, off, z); }), ErrorCode::BadArgument);
  EXPECT_EQ(refusal([&] { (void)NefSphere::arc(x, x.opposite()); }), ErrorCode::BadArgument);
}

/// A triangle is the intersection of the half-spheres to the left of its sides.
TEST(SphereVectors, TrianglesAreIntersectionsOfHalfSpheres) {
  Dice dice(4);
  int made = 0;
  while (made < 40) {
    const std::vector<SphereVector> v{any_vector(dice), any_vector(dice), any_vector(dice)};
    if (dot(cross(v[0], v[1]), v[2]) <= 0) continue;
    ++made;
    for (const Boundary boundary : {Boundary::Open, Boundary::Closed}) {
      const std::vector<SphereVector> normals{cross(v[0], v[1]), cross(v[1], v[2]),
                                              cross(v[2], v[0])};
      EXPECT_TRUE(NefSphere::polygon(v, boundary) == NefSphere::convex(normals, boundary));
    }
  }
  const SphereVector z(0, 0, 1), x(1, 0, 0);
  const std::vector<SphereSide> round{{x, z}};
  EXPECT_TRUE(NefSphere::region(round, Boundary::Closed) ==
              NefSphere::half_sphere(z, Boundary::Closed));
  EXPECT_TRUE(NefSphere::region({}, Boundary::Closed).is_empty());
}

TEST(SphereVectors, EqualDirectionsAreOnePoint) {
  Dice dice(5);
  for (int round = 0; round < 40; ++round) {
    std::vector<SphereVector> given;
    std::size_t different = 0;
    for (std::uint32_t i = dice.below(6); i > 0; --i) {
      const SphereVector v = any_vector(dice);
      bool is_new = true;
      for (const SphereVector& u : given) is_new = is_new && !is_same_direction(u, v);
      if (is_new) ++different;
      given.push_back(v);
      given.emplace_back(Rational(3 * v.x), Rational(3 * v.y), Rational(3 * v.z));
    }
    const NefSphere set = NefSphere::points(given);
    EXPECT_EQ(set.map().point_count(), different);
    for (const SphereVector& v : given) EXPECT_TRUE(set.contains(v));
  }
}

}  // namespace plumb::sphere_vectors_test
