// Laws of tables: whatever is copied, merged or compacted answers every question as before.
#include "plumb/space/complex/space_tables.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <memory>
#include <string>
#include <vector>

#include "generate/space_cases.h"
#include "plumb/predicates/plane_signs.h"
#include "plumb/predicates/point3_signs.h"

namespace plumb::space_tables_test {
namespace {

/// Tables with the planes and points that questions are asked about.
struct World {
  std::shared_ptr<SpaceTables> tables = std::make_shared<SpaceTables>();
  std::vector<PlaneId> planes;
  std::vector<SpacePoint> points;
  std::string family;

  /// The same planes and points under a map of ids.
  template <class Map>
  World image(std::shared_ptr<SpaceTables> in, const Map& map) const {
    World result{std::move(in), {}, {}, family};
    for (const PlaneId p : planes) result.planes.push_back(map(p));
    for (const SpacePoint x : points) result.points.push_back(map(x));
    return result;
  }
};

void add_valid(World& world, OrientedPlane p) {
  if (p.is_valid()) world.planes.push_back(p.plane());
}
void add_valid(World& world, SpacePoint p) {
  if (p.is_valid()) world.points.push_back(p);
}

/// Planes through corners, of coefficients, a wall; points of every kind, some of them equal.
World make_world(cases::Random& random, const cases::Case& c) {
  World world;
  world.family = c.family;
  PlaneTable& planes = world.tables->planes;
  Point3Table& points = world.tables->points;
  const auto first = planes.add_points(c.corners).value();
  const auto corner = [&](std::size_t i) { return InputPointId(first + i); };
  for (std::size_t i = 0; i < 12; i += 3) {
    add_valid(world, planes.intern(corner(i), corner(i + 1), corner(i + 2)));
  }
  add_valid(world, planes.intern(1, 0, 0, cases::integer(random, -1, 1)));
  add_valid(world, planes.intern(Rational(1), 2, 3, Rational(cases::integer(random, -1, 1), 3)));
  if (world.planes.size() >= 2) {
    add_valid(world,
              planes.intern(wall_along(planes, world.planes[0], world.planes[1], {1, 2, 3})));
  }
  for (const std::size_t i : {std::size_t{0}, std::size_t{5}})
    add_valid(world, SpacePoint(corner(i)));
  const std::size_t n = world.planes.size();
  for (std::size_t i = 0; i < n; ++i) {
    const std::array<PlaneId, 3> p = {world.planes[i], world.planes[(i + 1) % n],
                                      world.planes[(i + 2) % n]};
    add_valid(world, points.add(p[0], p[1], p[2]));
    if (i % 2 == 0) add_valid(world, points.add(corner(i), corner(11 - i), p[0]));
  }
  return world;
}

/// Every answer about the world's planes and points. (What is known by identity alone is none: it
/// depends on the definition a plane had first.)
std::vector<std::uint64_t> answers(const World& world) {
  std::vector<std::uint64_t> all;
  const auto note = [&](Sign s) {
    all.push_back(static_cast<std::uint64_t>(static_cast<int>(s) + 1));
  };
  const Point3Table& points = world.tables->points;
  const PlaneTable& planes = world.tables->planes;
  for (const SpacePoint x : world.points) {
    all.push_back(fingerprint(points, x));
    for (const PlaneId p : world.planes) note(side(points, x, p));
    for (const SpacePoint y : world.points) {
      note(compare_xyz(points, x, y));
      all.push_back(equal(points, x, y) ? 1 : 0);
    }
  }
  for (const PlaneId p : world.planes) {
    all.push_back(planes.fingerprint(p));
    for (const PlaneId q : world.planes) {
      all.push_back(p == q ? 1 : 0);
      note(minor_sign(planes, p, q, 1));
      note(det4_sign(planes, p, q, world.planes[0], world.planes.back()));
    }
  }
  return all;
}

TEST(SpaceTables, StartWithTheAxisPlanes) {
  SpaceTables tables;
  EXPECT_EQ(tables.planes.intern(2, 0, 0, 0).plane(), kPlaneX);
  EXPECT_EQ(tables.planes.intern(0, -2, 0, 0), OrientedPlane(kPlaneY, true));
  EXPECT_EQ(tables.planes.intern(0, 0, 2, 0).plane(), kPlaneZ);
}

TEST(SpaceTables, ACopyAnswersAlikeAndLivesAlone) {
  cases::Random random(31);
  for (int i = 0; i < 500; ++i) {
    const World world = make_world(random, cases::any(random));
    const std::size_t planes = world.tables->planes.size();
    const std::size_t points = world.tables->points.size();
    World other = world;
    other.tables = copy(*world.tables);
    EXPECT_EQ(answers(world), answers(other)) << world.family;
    // The copy finds the planes it was given, and what it adds is its own.
    EXPECT_EQ(other.tables->planes.intern(3, 0, 0, 0).plane(), kPlaneX);
    const PlaneId fresh = other.tables->planes.intern(1, 7, 11, 13).plane();
    EXPECT_EQ(fresh, PlaneId(planes));
    EXPECT_TRUE(other.tables->points.add(fresh, kPlaneX, kPlaneY).is_valid());
    EXPECT_EQ(world.tables->planes.size(), planes);
    EXPECT_EQ(world.tables->points.size(), points);
  }
}

/// Two worlds that share some of their planes.
std::array<World, 2> two_worlds(cases::Random& random) {
  const cases::Case a = cases::any(random);
  cases::Case b = cases::any(random);
  const auto shared = 3 * cases::integer(random, 0, 4);
  std::copy_n(a.corners.rbegin(), shared, b.corners.begin());  // the other way round
  return {make_world(random, a), make_world(random, b)};
}

TEST(SpaceTables, MergingChangesNoAnswer) {
  cases::Random random(32);
  for (int i = 0; i < 500 && !HasFailure(); ++i) {
    const auto [a, b] = two_worlds(random);
    const auto a_before = answers(a), b_before = answers(b);
    const TableMap map = merge(*a.tables, *b.tables);
    const World image = b.image(a.tables, map);
    EXPECT_EQ(answers(a), a_before) << a.family;
    EXPECT_EQ(answers(image), b_before) << b.family;
    EXPECT_EQ(map(kPlaneX), kPlaneX);
    EXPECT_EQ(map(kPlaneZ), kPlaneZ);
    for (std::size_t j = 0; j < b.planes.size(); ++j) {
      const IntegerRow row = b.tables->planes.primitive(b.planes[j]);
      EXPECT_EQ(a.tables->planes.primitive(image.planes[j]), row);
      for (const PlaneId p : a.planes) {
        EXPECT_EQ(p == image.planes[j], a.tables->planes.primitive(p) == row) << b.family;
      }
    }
    for (std::size_t j = 0; j < b.points.size(); ++j) {
      const RationalPoint3 at = exact(b.tables->points, b.points[j]);
      for (const SpacePoint x : a.points) {
        EXPECT_EQ(equal(a.tables->points, x, image.points[j]), exact(a.tables->points, x) == at)
            << a.family << " and " << b.family;
      }
    }
  }
}

TEST(SpaceTables, CompactingChangesNoAnswer) {
  cases::Random random(33);
  for (int i = 0; i < 500 && !HasFailure(); ++i) {
    auto [world, rest] = two_worlds(random);
    merge(*world.tables, *rest.tables);
    // Without the last planes: those that no kept point needs are dropped.
    world.planes.resize(world.planes.size() -
                        static_cast<std::size_t>(cases::integer(random, 0, 2)));
    std::shuffle(world.points.begin(), world.points.end(), random);
    world.points.resize(world.points.size() / 2);
    const CompactedTables small = compacted(*world.tables, world.planes, world.points);
    const World image = world.image(small.tables, small);
    const SpaceTables& tables = *small.tables;
    EXPECT_LE(tables.planes.size(), world.tables->planes.size());
    EXPECT_EQ(small(kPlaneY), kPlaneY);
    ASSERT_EQ(image.points.size(), world.points.size());
    for (std::size_t j = 0; j < world.points.size(); ++j) {
      EXPECT_EQ(exact(tables.points, image.points[j]),
                exact(world.tables->points, world.points[j]));
      EXPECT_EQ(fingerprint(tables.points, image.points[j]),
                fingerprint(world.tables->points, world.points[j]));
      for (std::size_t k = 0; k < world.planes.size(); ++k) {
        EXPECT_EQ(side(tables.points, image.points[j], image.planes[k]),
                  side(world.tables->points, world.points[j], world.planes[k]))
            << world.family;
      }
    }
    // Every plane is found again where it is.
    World again = image;
    const TableMap map = merge(*again.tables, *world.tables);
    for (std::size_t k = 0; k < world.planes.size(); ++k) {
      EXPECT_EQ(map(world.planes[k]), image.planes[k]) << world.family;
    }
  }
}

/// Some planes of the frame and points on them.
void add_frame(World& world, cases::Random& random) {
  PlaneTable& planes = world.tables->planes;
  const std::size_t ordinary = world.planes.size();
  for (const PlaneId p : planes.intern_frame()) {
    if (cases::integer(random, 0, 2) != 0) world.planes.push_back(p);
  }
  for (std::size_t i = ordinary; i < world.planes.size(); ++i) {
    const PlaneId p = world.planes[i], q = world.planes[i - 1], r = world.planes[i - 2];
    add_valid(world, world.tables->points.add(p, q, r));
    add_valid(world, world.tables->points.add(p, world.planes[i % ordinary], kPlaneY));
    add_valid(world, world.tables->points.add(InputPointId(i % 11 + 1), InputPointId(0), p));
  }
}

TEST(SpaceTables, TheFrameIsTheSameInAllTables) {
  cases::Random random(34);
  for (int i = 0; i < 200 && !HasFailure(); ++i) {
    auto [a, b] = two_worlds(random);
    add_frame(b, random);
    if (i % 2 == 0) add_frame(a, random);
    const auto before = answers(b);
    const TableMap map = merge(*a.tables, *b.tables);
    const World merged = b.image(a.tables, map);
    EXPECT_EQ(answers(merged), before) << b.family;
    const CompactedTables small = compacted(*a.tables, merged.planes, merged.points);
    EXPECT_EQ(answers(merged.image(small.tables, small)), before) << b.family;
    for (std::size_t j = 0; j < 6; ++j) {
      EXPECT_EQ(map(b.tables->planes.frame()[j]), a.tables->planes.frame()[j]);
      EXPECT_EQ(small(a.tables->planes.frame()[j]), small.tables->planes.frame()[j]);
    }
  }
}

TEST(SpaceTables, CompactingKeepsJustWhatIsNeeded) {
  SpaceTables tables;
  const InputPointId unused = tables.planes.add_point({9, 9, 9});
  const std::array<Point3, 3> corners = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  const std::size_t first = tables.planes.add_points(corners).value();
  const PlaneId slope =
      tables.planes.intern(InputPointId(first), InputPointId(first + 1), InputPointId(first + 2))
          .plane();
  const PlaneId dropped = tables.planes.intern(5, 6, 7, 8).plane();
  const PlaneId cut = tables.planes.intern(1, -1, 0, 0).plane();
  tables.points.add(dropped, cut, kPlaneX);
  const SpacePoint x = tables.points.add(slope, cut, kPlaneZ);
  const std::array<SpacePoint, 1> points = {x};
  const CompactedTables small = compacted(tables, {}, points);
  EXPECT_EQ(small.tables->planes.size(), 5u);
  EXPECT_EQ(small.tables->planes.points().size(), 3u);
  EXPECT_EQ(small.tables->points.size(), 1u);
  EXPECT_FALSE(small(dropped).is_valid());
  EXPECT_FALSE(small(SpacePoint(unused)).is_valid());
  EXPECT_EQ(exact(small.tables->points, small(x)),
            (RationalPoint3{Rational(1, 2), Rational(1, 2), 0}));
}

TEST(SpaceTables, AddsPointsWithAnyExactCoordinates) {
  SpaceTables tables;
  const RationalPoint3 doubles = {Rational(1, 4), -3, 0};
  const RationalPoint3 fractions = {Rational(1, 3), Rational(-3), Rational(0)};
  const RationalPoint3 huge = {Rational(Integer(1) << 5000), Rational(1, Integer(1) << 3000), 2};
  const std::size_t planes = tables.planes.size();
  EXPECT_TRUE(add_point(tables, doubles).is_input());
  EXPECT_EQ(tables.planes.size(), planes);
  for (const RationalPoint3& at : {doubles, fractions, huge}) {
    const SpacePoint x = add_point(tables, at);
    ASSERT_TRUE(x.is_valid());
    EXPECT_EQ(exact(tables.points, x), at);
    EXPECT_TRUE(equal(tables.points, x, add_point(tables, at)));
  }
}

}  // namespace
}  // namespace plumb::space_tables_test
