// Sets of the sphere on cases a person can check; what is refused; maps of other tables.
#include "plumb/sphere/nef_sphere.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <limits>

#include "generate/sphere_families.h"
#include "generate/sphere_program.h"
#include "generate/test_share.h"
#include "plumb/predicates/error.h"
#include "plumb/sphere/overlay/sphere_overlay.h"

namespace plumb::testing::nef_sphere_test {
namespace {

const SphereVector kX{1, 0, 0}, kY{0, 1, 0}, kZ{0, 0, 1};

NefSphere closed_half(const SphereVector& n) { return NefSphere::half_sphere(n, Boundary::Closed); }
NefSphere open_half(const SphereVector& n) { return NefSphere::half_sphere(n, Boundary::Open); }

struct Counts {
  std::size_t points, arcs, faces;
  friend bool operator==(const Counts&, const Counts&) = default;
};
Counts counts(const NefSphere& set) {
  return {set.map().point_count(), set.map().arc_count(), set.map().face_count()};
}
std::ostream& operator<<(std::ostream& out, const Counts& c) {
  return out << c.points << " points, " << c.arcs << " arcs, " << c.faces << " faces";
}

ErrorCode code_of(const std::function<void()>& work) {
  try {
    work();
  } catch (const Error& e) {
    return e.code();
  }
  return ErrorCode::Usage;
}

// ---------------------------------------------------------------- what sets look like

TEST(NefSphere, OfAnOctantHasThreeOfEach) {
  const std::vector<SphereVector> xyz{kX, kY, kZ};
  const NefSphere octant = NefSphere::convex(xyz, Boundary::Closed);
  EXPECT_EQ(counts(octant), (Counts{3, 3, 2}));
  EXPECT_TRUE(NefSphere::polygon(xyz, Boundary::Closed) == octant);
  EXPECT_TRUE(octant.contains({1, 1, 1}) && octant.contains(kX) && octant.contains({0, 2, 3}));
  EXPECT_FALSE(octant.contains({-1, 5, 5}) || octant.contains({0, -1, 0}));
  const std::vector<SphereVector> back{kZ, kY, kX};
  EXPECT_TRUE(NefSphere::polygon(back, Boundary::Open) == !octant);

  const NefSphere rest = open_half(kZ) - octant;
  const auto hit = rest.shoot({1, 1, 1}, {1, -1, 1});
  ASSERT_TRUE(hit.has_value());
  EXPECT_EQ(hit->point, SphereVector(1, 0, 1));
  EXPECT_EQ(hit->location.cell.kind(), SphereCell::Kind::Face);
}

struct CountCase {
  const char* name;
  NefSphere set;
  Counts expected;
};

TEST(NefSphere, HasTheItemsOfItsMinimalForm) {
  const NefSphere cross = NefSphere::circle(kX) + NefSphere::circle(kY);
  const NefSphere poles = NefSphere::points(std::vector{kZ, kZ.opposite()});
  const NefSphere slit = NefSphere::arc(kX, kY);
  const CountCase cases[] = {
      {"empty", NefSphere(), {0, 0, 1}},
      {"sphere", NefSphere::whole(), {0, 0, 1}},
      {"half", closed_half(kZ), {0, 1, 2}},
      {"circle", NefSphere::circle(kZ), {0, 1, 2}},
      {"circle from two halves", closed_half(kZ) * closed_half(kZ.opposite()), {0, 1, 2}},
      {"circle from an arc round", NefSphere::arc(kX, kX, kZ), {0, 1, 2}},
      {"circle without a point", NefSphere::circle(kZ) - NefSphere::point(kX), {1, 1, 2}},
      {"two circles", cross, {2, 4, 4}},
      {"points where they cross", NefSphere::circle(kX) * NefSphere::circle(kY), {2, 0, 1}},
      {"lune", closed_half(kX) * closed_half(kY), {2, 2, 2}},
      {"two opposite lunes", (closed_half(kX) ^ closed_half(kY)), {2, 4, 4}},
      {"slit", slit, {2, 1, 1}},
      {"long arc", NefSphere::arc(kY, kX, kZ), {2, 1, 1}},
      {"slit and the rest of its circle", slit + NefSphere::arc(kY, kX, kZ), {0, 1, 2}},
      {"circle with points on both sides", NefSphere::circle(kZ) + poles, {2, 1, 2}},
      {"half with its pole missing", open_half(kZ) - poles, {1, 1, 2}},
      {"five points",
       NefSphere::points(
           std::vector{kX, kY, kZ, SphereVector{1, 1, 1}, SphereVector{2, 2, 2}, kX.opposite()}),
       {5, 0, 1}},
      {"half less a slit on its border", closed_half(kZ) - slit, {2, 2, 2}},
  };
  for (const CountCase& c : cases) {
    EXPECT_EQ(counts(c.set), c.expected) << c.name;
    EXPECT_FALSE(c.set.audit().has_value()) << c.name;
    EXPECT_TRUE(c.set == !!c.set && (c.set ^ c.set).is_empty()) << c.name;
  }
}

TEST(NefSphere, KeepsFacesApartThatIslandsLieIn) {
  // Two triangles around opposite directions; a circle between them; a hole in one.
  const auto triangle = [](double z, double size) {
    const std::vector<SphereVector> corners{{size, 0, z}, {-size, size, z}, {-size, -size, z}};
    return NefSphere::polygon(corners, Boundary::Closed);
  };
  const NefSphere ring = triangle(1, 0.5) - triangle(1, 0.1);
  const NefSphere south = !NefSphere::polygon(
      std::vector<SphereVector>{{0.5, 0, -1}, {-0.5, 0.5, -1}, {-0.5, -0.5, -1}}, Boundary::Open);
  const NefSphere all = ring + NefSphere::circle(kZ) + south + NefSphere::point({0.6, 0, -1});
  EXPECT_EQ(counts(ring), (Counts{6, 6, 3}));
  EXPECT_FALSE(all.audit().has_value());
  EXPECT_FALSE(all.contains(kZ));
  const SphereLocation inside = all.locate(kZ);
  const SphereFaceBoundary boundary = face_boundary(all.map(), inside.cell.index());
  EXPECT_EQ(boundary.half_arcs.size(), 1U);
  const SphereLocation between = all.locate({1, 0, 0.1});
  EXPECT_EQ(face_boundary(all.map(), between.cell.index()).half_arcs.size(), 2U);
  EXPECT_NE(between.cell, inside.cell);
}

// ---------------------------------------------------------------- what is refused

TEST(NefSphere, RefusesWhatIsNoDirectionOrChain) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(code_of([&] { (void)SphereVector(1, nan, 0); }), ErrorCode::NotFinite);
  EXPECT_EQ(code_of([] {
              NefSphere::half_sphere({0, 0, 0}, Boundary::Open);
            }),
            ErrorCode::BadArgument);
  EXPECT_EQ(code_of([] { NefSphere::point({0, 0, 0}); }), ErrorCode::BadArgument);
  EXPECT_EQ(code_of([] { NefSphere::arc(kX, kX.opposite()); }), ErrorCode::BadArgument);
  EXPECT_EQ(code_of([] { NefSphere::arc(kX, {1, 1, 1}, kZ); }), ErrorCode::BadArgument);
  EXPECT_EQ(code_of([] { (void)NefSphere::whole().shoot(kX, kX); }), ErrorCode::BadArgument);
  EXPECT_EQ(code_of([] { NefSphere::empty().with_marks({}); }), ErrorCode::BadArgument);
  const std::vector<SphereVector> there_and_back{kX, kY};
  EXPECT_EQ(code_of([&] { NefSphere::polygon(there_and_back, Boundary::Closed); }),
            ErrorCode::BadArgument);
  const std::vector<SphereVector> eight{{1, 1, 1}, {-1, -1, 1}, {1, -1, 1}, {-1, 1, 1}};
  EXPECT_EQ(code_of([&] { NefSphere::polygon(eight, Boundary::Closed); }), ErrorCode::BadArgument);
  const std::vector<SphereVector> twice{kX, kY, kZ, kX, {1, -1, 1}};
  EXPECT_EQ(code_of([&] { NefSphere::polygon(twice, Boundary::Closed); }), ErrorCode::BadArgument);
}

TEST(NefSphere, HonoursLimits) {
  Limits limits;
  limits.max_memory_bytes = 10;
  Context context(limits);
  EXPECT_EQ(code_of([&] { (void)boolean_op(closed_half(kX), closed_half(kY), kUnion, context); }),
            ErrorCode::ResourceLimit);
  std::stop_source stop;
  stop.request_stop();
  Context stopped({}, stop.get_token());
  EXPECT_EQ(code_of([&] { (void)boolean_op(closed_half(kX), closed_half(kY), kUnion, stopped); }),
            ErrorCode::Cancelled);
}

/// Memory is charged for what meets, not for all that might.
TEST(NefSphere, LargeOverlaysAreChargedForWhatTheyDo) {
  const NefSphere a = testing::crown(2000, 0, -0.5, 0.5), b = testing::crown(2000, 0.5, -0.5, 0.5);
  const auto united = [&](std::uint64_t megabytes) {
    Limits limits;
    limits.max_memory_bytes = megabytes << 20U;
    Context context(limits);
    return boolean_op(a, b, kUnion, context);
  };
  EXPECT_TRUE(united(16) == a + b) << "4000 items each";
  EXPECT_EQ(code_of([&] { (void)united(4); }), ErrorCode::ResourceLimit) << "2000 crossings";
}

// ---------------------------------------------------------------- maps

TEST(NefSphere, TakesTheMapOfAnyPointOfSpace) {
  PlaneTable planes;  // x = 3 and y = 5, through (3, 5, 0)
  const PlaneId p = planes.intern(2.0, 0.0, 0.0, -6.0).plane();
  const PlaneId q = planes.intern(0.0, 1.0, 0.0, -5.0).plane();
  SphereMap map;
  map.circle = {p};
  map.arc_mark = {kBeyond};
  map.origin = {kNone, kNone};
  map.next = {0, 1};
  map.face = {0, 1};
  map.face_mark = {1, kBeyond};
  map.centre_mark = 1;
  EXPECT_TRUE(NefSphere::from_complex({std::make_shared<const PlaneTable>(planes), map}) ==
              open_half(kX));
  map.circle = {q};
  map.arc_mark = {1};
  EXPECT_TRUE(NefSphere::from_complex({std::make_shared<const PlaneTable>(planes), map}) ==
              closed_half(kY));
  map.next = {1, 0};
  EXPECT_EQ(code_of([&] {
              NefSphere::from_complex({std::make_shared<const PlaneTable>(planes), map});
            }),
            ErrorCode::BadArgument);
}

SphereMap with_centre(SphereMap map, Mark mark) {
  map.centre_mark = mark;
  return map;
}

TEST(SphereMap, IsClassifiedByWhatItLooksLike) {
  const auto kind = [](const NefSphere& set, Mark centre) {
    return classify(set.planes(), with_centre(set.map(), centre));
  };
  EXPECT_EQ(kind(NefSphere::whole(), 1), PyramidKind::Volume);
  EXPECT_EQ(kind(NefSphere::whole(), 0), PyramidKind::Vertex);
  EXPECT_EQ(kind(closed_half(kX), 1), PyramidKind::Facet);
  EXPECT_EQ(kind(closed_half(kX), 0), PyramidKind::Vertex);
  EXPECT_EQ(kind(closed_half(kX) * closed_half(kY), 1), PyramidKind::Edge);
  EXPECT_EQ(kind(closed_half(kX) ^ closed_half(kY), 0), PyramidKind::Edge);
  const NefSphere line = NefSphere::points(std::vector{kZ, kZ.opposite()});
  EXPECT_EQ(kind(line, 1), PyramidKind::Edge);
  EXPECT_EQ(kind(line, 0), PyramidKind::Vertex);
  EXPECT_EQ(kind(NefSphere::points(std::vector{kZ, kX}), 1), PyramidKind::Vertex);
  EXPECT_EQ(kind(line + NefSphere::circle(kZ), 1), PyramidKind::Vertex);
  const NefSphere flap =
      NefSphere::region(std::vector<SphereSide>{{kZ, kX}, {kZ.opposite(), kX}}, Boundary::Closed);
  EXPECT_EQ(kind(flap, 1), PyramidKind::Facet);  // straight on: a half-sphere
  const NefSphere half_plane =
      NefSphere::circle(kX) * closed_half(kY) - NefSphere::points(std::vector{kY});
  EXPECT_EQ(kind(half_plane, 1), PyramidKind::Vertex);
  EXPECT_EQ(kind(NefSphere::circle(kX) * closed_half(kY), 1), PyramidKind::Edge);
}

// ---------------------------------------------------------------- large maps

TEST(NefSphere, OfManyArcsObeysTheLaws) {
  const std::size_t n = 400;
  const NefSphere a = crown(n, 0, 0.5, 1.5);
  const NefSphere b = crown(n, 0.37, 0.6, 1.4);
  const NefSphere inner = crown(n, 0.2, 3, 4);
  EXPECT_EQ(counts(a), (Counts{n, n, 2}));
  const NefSphere both = a ^ b;
  // Zigzags of n edges, one shifted by less than an edge, cross n times.
  EXPECT_EQ(both.map().point_count(), 3 * n);
  EXPECT_EQ(both.map().arc_count(), 4 * n);
  EXPECT_EQ(both.map().face_count(), n + 2);
  EXPECT_FALSE(both.audit().has_value());
  EXPECT_TRUE((a - b) + (a * b) == a);
  EXPECT_TRUE((!a * !b) == !(a + b));
  EXPECT_TRUE(inner.is_subset_of(a) && inner != a && (a - inner) + inner == a);
  EXPECT_EQ(counts(a - inner), (Counts{2 * n, 2 * n, 3}));
  EXPECT_TRUE((a ^ a).is_empty());
}

// ---------------------------------------------------------------- any bytes, shrunk when they fail

TEST(NefSphere, OfAnyProgramIsTheTwins) {
  const bool holds = rc::check("programs agree", [](const std::vector<std::uint8_t>& bytes) {
    RC_ASSERT(disagreement_on_sphere(bytes, 6) == "");
  });
  EXPECT_TRUE(holds);
}

}  // namespace
}  // namespace plumb::testing::nef_sphere_test
