// Families of solids in special positions, judged by what must hold whatever the position: volumes
// of union and intersection add up, differences are what they are defined to be, points belong to a
// result as they belong to its operands, and every result passes its audit. Where operands touch,
// what they share is compared with a set that is known.

#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "generate/meshes.h"
#include "plumb/plane/nef2.h"
#include "plumb/predicates/point3_signs.h"
#include "plumb/space/nef3.h"
#include "plumb/space/space_audit.h"
#include "plumb/space/space_measure.h"

namespace plumb::testing::degenerate_families_test {
namespace {

/// Whatever way its faces turn.
Nef3 solid(const PolygonMesh& mesh) {
  Context context;
  return Nef3::from_mesh(mesh, {.rule = WindingRule::NonZero}, context);
}

Nef3 box(Point3 low, Point3 high) { return solid(box_mesh(low, high)); }

Rational volume(const Nef3& set) { return marked_volume(set.complex()).value(); }

void expect_sound(const Nef3& set, const std::string& name) {
  const std::optional<SpaceFlaw> flaw = audit(set.complex(), AuditForm::Minimal);
  EXPECT_FALSE(flaw) << name << ": " << flaw->invariant << " at " << flaw->place;
}

/// Vertices and midpoints of edges of a set: where something changes. About `most` of them.
void add_probes(const Nef3& set, std::size_t most, std::vector<RationalPoint3>& probes) {
  const SpaceComplex& c = set.complex();
  const auto at = [&](VertexId v) { return exact(c.points(), c.vertex_point[v.value()]); };
  const Rational half = Rational(1) / 2;
  for (std::size_t e = 0; e < c.edge_count(); e += 1 + c.edge_count() / most) {
    const RationalPoint3 p = at(c.origin[2 * e]);
    const RationalPoint3 q = at(c.origin[2 * e + 1]);
    probes.push_back(p);
    probes.push_back({(p.x + q.x) * half, (p.y + q.y) * half, (p.z + q.z) * half});
  }
}

struct Booleans {
  Nef3 both;
  Nef3 common;
  Nef3 left;
  Nef3 right;
  Nef3 either;
};

void expect_membership(const Nef3& a, const Nef3& b, const Booleans& r) {
  std::vector<RationalPoint3> probes;
  for (const Nef3* set : {&a, &b, &r.either}) add_probes(*set, 12, probes);
  for (const RationalPoint3& p : probes) {
    const bool in_a = a.contains(p);
    const bool in_b = b.contains(p);
    EXPECT_EQ(r.both.contains(p), in_a || in_b);
    EXPECT_EQ(r.common.contains(p), in_a && in_b);
    EXPECT_EQ(r.left.contains(p), in_a && !in_b);
    EXPECT_EQ(r.right.contains(p), in_b && !in_a);
    EXPECT_EQ(r.either.contains(p), in_a != in_b);
  }
}

/// Bounded sets: everything that must hold between them.
void expect_laws(const std::string& name, const Nef3& a, const Nef3& b) {
  SCOPED_TRACE(name);
  const Booleans r{a + b, a * b, a - b, b - a, a ^ b};
  expect_sound(r.both, "union");
  expect_sound(r.common, "intersection");
  expect_sound(r.left, "difference");
  expect_sound(r.right, "other difference");
  expect_sound(r.either, "symmetric difference");
  const Rational common = volume(r.common);
  EXPECT_EQ(volume(a) + volume(b), volume(r.both) + common);
  EXPECT_EQ(volume(r.left), volume(a) - common);
  EXPECT_EQ(volume(r.right), volume(b) - common);
  EXPECT_EQ(volume(r.either), volume(r.both) - common);
  EXPECT_TRUE(r.left == a * !b);
  EXPECT_TRUE(r.either == r.left + r.right);
  EXPECT_TRUE(r.both == r.either + r.common);
  expect_membership(a, b, r);
}

AffineMap3 shift(const RationalPoint3& by) {
  return {{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}, {by.x, by.y, by.z}};
}

AffineMap3 linear(const std::array<std::array<Rational, 3>, 3>& matrix) {
  return {matrix, {Rational(0), Rational(0), Rational(0)}};
}

/// No plane stays parallel to an axis.
Nef3 sheared(const Nef3& set) {
  return set.transformed(linear({{{1, 2, -1}, {Rational(1) / 3, 1, 1}, {1, Rational(-2) / 7, 2}}}));
}

// ---------------------------------------------------------------- the same twice

TEST(DegenerateFamilies, IdenticalOperands) {
  const Nef3 plate = box({0, 0, 0}, {3, 3, 1}) - box({1, 1, -1}, {2, 2, 2});
  const Nef3 two = sheared(plate) + sheared(plate).transformed(shift({9, 0, 0}));
  for (const Nef3& a : {solid(icosphere_mesh(1, 1, {0.1, 0.2, 0.3})), plate, two}) {
    EXPECT_TRUE((a - a).is_empty() && (a ^ a).is_empty() && a + a == a && a * a == a);
    expect_laws("with itself", a, a);
    expect_laws("with its interior", a, a.interior());
    expect_laws("with its boundary", a, a.boundary());
    EXPECT_TRUE(a.closure() - a.interior() == a.boundary());
  }
}

// ---------------------------------------------------------------- touching

struct Touching {
  std::string name;
  Nef3 other;
  Nef3 shared;
};

/// What touches the tetrahedron (0,0,0) (3,0,1) (1,3,1) (1,1,4): its images in a facet, an edge, a
/// vertex.
std::vector<Touching> touching_images(const Nef3& a) {
  const AffineMap3 mirror = linear({{{1, 0, 0}, {0, 1, 0}, {0, 0, -1}}});
  const Nef3 flat = solid(tetrahedron_mesh({0, 0, 0}, {0, 3, 0}, {3, 0, 0}, {1, 1, 2}));
  const AffineMap3 half_turn = linear({{{-1, 0, 0}, {0, -1, 0}, {0, 0, 1}}});
  const Nef3 upright = solid(tetrahedron_mesh({0, 0, 0}, {0, 0, 3}, {2, 0, 1}, {1, 2, 1}));
  const AffineMap3 through = linear({{{-1, 0, 0}, {0, -1, 0}, {0, 0, -1}}});
  return {{"at a vertex", a.transformed(through), Nef3::point({0, 0, 0})},
          {"at a facet", flat.transformed(mirror),
           Nef3::facet(std::array{Point3{0, 0, 0}, Point3{3, 0, 0}, Point3{0, 3, 0}})},
          {"along an edge", upright.transformed(half_turn), Nef3::segment({0, 0, 0}, {0, 0, 3})}};
}

TEST(DegenerateFamilies, Touching) {
  const Nef3 any = solid(tetrahedron_mesh({0, 0, 0}, {1, 3, 1}, {3, 0, 1}, {1, 1, 4}));
  const Nef3 flat = solid(tetrahedron_mesh({0, 0, 0}, {0, 3, 0}, {3, 0, 0}, {1, 1, 2}));
  const Nef3 upright = solid(tetrahedron_mesh({0, 0, 0}, {0, 0, 3}, {2, 0, 1}, {1, 2, 1}));
  const std::vector<Touching> images = touching_images(any);
  const std::array firsts{any, flat, upright};
  for (std::size_t i = 0; i < images.size(); ++i) {
    const Nef3& a = firsts[i];
    const auto& [name, b, shared] = images[i];
    EXPECT_TRUE(a * b == shared) << name;
    expect_laws(name, a, b);
    expect_laws(name + ", sheared", sheared(a), sheared(b));
    expect_laws(name + ", one of them open", a, b.interior());
    EXPECT_TRUE((a * b.interior()).is_empty());
    EXPECT_TRUE((a.interior() + b.interior()).closure() == a + b);
  }
}

// ---------------------------------------------------------------- coplanar facets

using Polygon = std::vector<Point2>;

struct Overlap {
  const char* name;
  Polygon other;
};

const Polygon kBase{{0, 0}, {6, 0}, {6, 6}, {0, 6}};

/// How a polygon can lie to a square: what they share is nothing, a point, a segment or a polygon,
/// at a vertex, inside an edge, or inside.
const std::vector<Overlap>& overlaps() {
  static const std::vector<Overlap> all = {
      {"apart", {{8, 0}, {9, 0}, {9, 1}}},
      {"vertex at vertex", {{6, 6}, {8, 7}, {7, 8}}},
      {"vertex inside an edge", {{6, 3}, {8, 2}, {8, 4}}},
      {"an edge in part of an edge", {{6, 2}, {8, 2}, {8, 4}, {6, 4}}},
      {"an edge along an edge and beyond", {{6, 3}, {8, 3}, {8, 9}, {6, 9}}},
      {"an edge from a vertex", {{6, 0}, {8, 0}, {8, 4}, {6, 4}}},
      {"the same edge", {{6, 0}, {9, 0}, {9, 6}, {6, 6}}},
      {"a corner cut off", {{3, -3}, {9, 3}, {9, -3}}},
      {"through a vertex only", {{6, 0}, {9, -1}, {9, 1}}},
      {"a vertex inside", {{3, 3}, {9, 2}, {9, 4}}},
      {"through two edges", {{-1, 2}, {7, 2}, {7, 4}, {-1, 4}}},
      {"a star", {{3, -2}, {8, 3}, {3, 8}, {-2, 3}}},
      {"inscribed", {{3, 0}, {6, 3}, {3, 6}, {0, 3}}},
      {"circumscribed", {{3, -3}, {9, 3}, {3, 9}, {-3, 3}}},
      {"inside", {{1, 1}, {5, 2}, {2, 5}}},
      {"inside, at a vertex", {{0, 0}, {5, 2}, {2, 5}}},
      {"inside, along an edge", {{1, 0}, {5, 0}, {2, 5}}},
      {"inside, two edges shared", {{0, 0}, {4, 0}, {4, 4}, {0, 4}}},
      {"half of it", {{0, 0}, {6, 0}, {6, 6}}},
      {"the same", kBase},
      {"around it", {{-1, -1}, {7, -1}, {7, 7}, {-1, 7}}},
      {"around it, an edge shared", {{0, -1}, {7, -1}, {7, 7}, {0, 7}}},
      {"not convex, two pieces shared", {{5, 1}, {9, 1}, {9, 5}, {5, 5}, {8, 3}}},
      {"a notch that fits", {{6, -1}, {8, -1}, {8, 7}, {-1, 7}, {-1, 6}, {6, 6}}},
  };
  return all;
}

/// What two prisms on both sides of z = 0 share is what their bases share: the plane's engine
/// knows.
void expect_shared_base(const Nef3& shared, const Overlap& overlap) {
  const Nef2 bases = Nef2::polygon(kBase) * Nef2::polygon(overlap.other);
  const PlaneComplex& plane = bases.complex();
  const SpaceCounts counts = shared.counts();
  EXPECT_EQ(counts.vertices, plane.vertex_count()) << overlap.name;
  EXPECT_EQ(counts.edges, plane.edge_count()) << overlap.name;
  EXPECT_EQ(counts.facets, plane.face_count() - 1) << overlap.name;
  EXPECT_EQ(counts.volumes, 1U) << overlap.name;
  EXPECT_DOUBLE_EQ(surface_area(shared.complex()).value(), 0) << "of volumes alone";
}

TEST(DegenerateFamilies, CoplanarFacets) {
  const Nef3 a = solid(prism_mesh(kBase, 0, 2));
  for (const Overlap& overlap : overlaps()) {
    const Nef3 below = solid(prism_mesh(overlap.other, -1, 0));
    const Nef3 beside = solid(prism_mesh(overlap.other, 0, 1));
    expect_shared_base(a * below, overlap);
    expect_laws(std::string(overlap.name) + ", on both sides", a, below);
    expect_laws(std::string(overlap.name) + ", on one side", a, beside);
    expect_laws(std::string(overlap.name) + ", sheared", sheared(a), sheared(below));
  }
}

// ---------------------------------------------------------------- grids

std::vector<Nef3> cubes(int n, bool is_checkered) {
  std::vector<Nef3> all;
  for (int i = 0; i < n * n * n; ++i) {
    const int x = i % n;
    const int y = i / n % n;
    const int z = i / (n * n);
    if (is_checkered && (x + y + z) % 2 != 0) continue;
    const double d = 1;
    all.push_back(box({x * d, y * d, z * d}, {x + d, y + d, z + d}));
  }
  return all;
}

TEST(DegenerateFamilies, GridsOfCubes) {
  constexpr int kSide = 4;
  Context context;
  const Nef3 whole = box({0, 0, 0}, {kSide, kSide, kSide});
  const std::vector<Nef3> grid = cubes(kSide, false);
  EXPECT_TRUE(union_of(grid, context) == whole);
  std::vector<Nef3> open;
  for (const Nef3& cube : grid) open.push_back(cube.interior());
  const Nef3 inner = union_of(open, context);
  EXPECT_EQ(inner.counts().marked_volumes, grid.size());
  EXPECT_TRUE(inner.closure() == whole);
  expect_laws("cubes without their walls", whole, inner);
}

TEST(DegenerateFamilies, Checkerboards) {
  constexpr int kSide = 4;
  Context context;
  const Nef3 black = union_of(cubes(kSide, true), context);
  const Nef3 whole = box({0, 0, 0}, {kSide, kSide, kSide});
  EXPECT_EQ(volume(black), Rational(kSide * kSide * kSide / 2));
  EXPECT_EQ(black.counts().marked_volumes, std::size_t{kSide * kSide * kSide / 2});
  EXPECT_FALSE(black.is_simple());
  const AffineMap3 mirror{{{{-1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}, {kSide, 0, 0}};
  const Nef3 white = black.transformed(mirror);
  EXPECT_TRUE(black + white == whole);
  EXPECT_TRUE((black.interior() * white).is_empty());
  expect_laws("black and white", black, white);
  constexpr std::size_t kInner = std::size_t{kSide - 2} * (kSide - 2) * (kSide - 2);
  EXPECT_EQ((black * white).counts().volumes, kInner + 1) << "walls close inner cubes alone";
}

// ---------------------------------------------------------------- slid, turned a little

TEST(DegenerateFamilies, SlidAlongAFace) {
  const Polygon ell{{0, 0}, {4, 0}, {4, 1}, {1, 1}, {1, 3}, {0, 3}};
  const Nef3 column = solid(prism_mesh(ell, 0, 8));
  const Rational area = 6;
  for (const int sevenths : {1, 3, 7, 55, 56, 57}) {
    const Rational by = Rational(sevenths) / 7;
    const Nef3 slid = column.transformed(shift({0, 0, by}));
    const Rational rest = by < 8 ? by : Rational(8);
    EXPECT_EQ(volume(column - slid), area * rest);
    expect_laws("slid by " + std::to_string(sevenths) + "/7", column, slid);
    expect_laws("slid and sheared", sheared(column), sheared(slid));
  }
}

TEST(DegenerateFamilies, TurnedByTheLeastBit) {
  const PolygonMesh sphere = icosphere_mesh(1, 1, {0.25, -0.5, 1});
  for (const double angle : {1e-12, 1e-15}) {
    expect_laws("turned", solid(sphere), solid(turned(sphere, angle)));
  }
}

// ---------------------------------------------------------------- needles, incidences

/// Long and thin, from near `from` to near `to`.
Nef3 needle(Point3 from, Point3 to) {
  constexpr double kThick = 0x1p-30;
  return solid(tetrahedron_mesh(from, {from.x + kThick, from.y + kThick, from.z}, to,
                                {to.x, to.y, to.z + kThick}));
}

TEST(DegenerateFamilies, Needles) {
  std::vector<Nef3> bundle;
  for (int i = 0; i < 12; ++i) {
    const double x = std::ldexp(i, -31);
    bundle.push_back(needle({-1e6, x, 0}, {1e6, -x, x}));
  }
  Context context;
  const Nef3 all = union_of(bundle, context);
  expect_sound(all, "bundle");
  expect_laws("a needle and the others", bundle[5], all);
  expect_laws("across", all, needle({0, -1e6, 0}, {0, 1e6, 0}));
  expect_laws("from the same point", needle({0, 0, 0}, {1e6, 1, 1}),
              needle({0, 0, 0}, {1e6, 1, 2}));
}

TEST(DegenerateFamilies, VertexOnEdgeOnFacet) {
  const Nef3 table = box({-4, -4, -1}, {4, 4, 0});
  const Nef3 ridge = solid(tetrahedron_mesh({-2, 0, 0}, {0, 1, 2}, {2, 0, 0}, {0, -1, 2}));
  const Nef3 tip = solid(tetrahedron_mesh({0, 0, 0}, {1, 3, -3}, {-1, 3, -3}, {0, 3, 3}));
  EXPECT_TRUE(table * ridge == Nef3::segment({-2, 0, 0}, {2, 0, 0}));
  EXPECT_TRUE(ridge * tip * table == Nef3::point({0, 0, 0}));
  const std::array sets{table, ridge, tip};
  for (std::size_t i = 0; i < 3; ++i) {
    const Nef3& a = sets[i];
    const Nef3& b = sets[(i + 1) % 3];
    const Nef3& c = sets[(i + 2) % 3];
    expect_laws("two and one", a + b, c);
    expect_laws("a difference and one", a - b, c);
    expect_laws("two and an open one", a ^ b, c.interior());
    EXPECT_TRUE((a + b) + c == a + (b + c));
  }
}

// ---------------------------------------------------------------- voids, many facets, far numbers

// Pages around one edge; facets pierce it and all of them.
TEST(DegenerateFamilies, BooksWithPiercedSpines) {
  Context context;
  std::vector<Nef3> pages;
  for (const auto& [x, y] :
       {std::pair{8., 1.}, {5., 6.}, {-1., 7.}, {-7., 3.}, {-6., -5.}, {0., -9.}, {6., -4.}}) {
    pages.push_back(
        solid(tetrahedron_mesh({0, 0, -4}, {0, 0, 4}, {x, y, 0}, {x - y / 64, y + x / 64, 0})));
    const Nef3 book = union_of(pages, context);
    expect_laws("a slab", book, box({-12, -12, -1}, {12, 12, 1}));
    expect_laws("a slanted slab", sheared(book), box({-40, -40, -1}, {40, 40, 1}));
  }
}

Nef3 octahedron(double r) {
  const std::vector<Point3> points{{r, 0, 0},  {0, r, 0}, {-r, 0, 0},
                                   {0, -r, 0}, {0, 0, r}, {0, 0, -r}};
  std::vector<Face> faces;
  for (std::uint32_t i = 0; i < 4; ++i) {
    faces.push_back({i, (i + 1) % 4, 4U});
    faces.push_back({(i + 1) % 4, i, 5U});
  }
  return solid(make_mesh(points, faces));
}

/// Cubes and octahedra, each inscribed in the next: shells touch in six or eight points.
TEST(DegenerateFamilies, VoidsInVoids) {
  constexpr std::size_t kDepth = 9;
  Nef3 nested;
  Rational filled = 0;
  double r = 1;
  for (std::size_t i = 0; i < kDepth; ++i) {
    if (i % 2 != 0) r *= 3;
    const Nef3 next = i % 2 == 0 ? box({-r, -r, -r}, {r, r, r}) : octahedron(r);
    filled = volume(next) - filled;
    nested = next - nested;
    expect_sound(nested, "depth " + std::to_string(i));
  }
  EXPECT_EQ(volume(nested), filled);
  EXPECT_EQ(nested.counts().volumes, kDepth + 1);
  EXPECT_EQ(nested.counts().marked_volumes, (kDepth + 1) / 2);
  expect_laws("cut across all shells", nested, box({0, 0, 0}, {200, 200, 200}));
  expect_laws("what fills a void", nested, octahedron(27));
}

/// A pyramid over a polygon of n corners on a circle, with its apex at the origin.
Nef3 cone(std::uint32_t n, double height, double turn) {
  std::vector<Point3> points{{0, 0, 0}};
  std::vector<Face> faces;
  Face base;
  for (std::uint32_t i = 0; i < n; ++i) {
    const double angle = 2 * 3.14159265358979 * (i + turn) / n;
    points.push_back({std::cos(angle), std::sin(angle), height});
    base.push_back(i + 1);
    faces.push_back({0U, (i + 1) % n + 1, i + 1});
  }
  faces.push_back(base);
  return solid(make_mesh(std::move(points), faces));
}

TEST(DegenerateFamilies, ThousandFacetsAtAVertex) {
  const Nef3 up = cone(500, 1, 0);
  const Nef3 down = cone(500, -1, 0.25);
  const Nef3 turned = cone(500, 1, 0.5);
  EXPECT_TRUE(up * down == Nef3::point({0, 0, 0}));
  EXPECT_EQ((up + down).counts().vertices, 1001U);
  EXPECT_EQ((up + down).counts().marked_volumes, 2U);
  const Nef3 common = up * turned;
  expect_sound(common, "crossing all around");
  EXPECT_EQ(volume(up) + volume(turned), volume(common) + volume(up + turned));
  EXPECT_EQ(common.counts().facets, 1001U);
}

/// Directions (x, y, 1), no two alike.
std::vector<RationalPoint3> rays(int count) {
  std::vector<RationalPoint3> ends;
  for (int i = 0; i < count; ++i) ends.push_back({i % 32 - 16, i / 32 - 16, 1});
  return ends;
}

TEST(DegenerateFamilies, ThousandFreeEdgesAtAVertex) {
  Context context;
  std::vector<RationalPoint3> points;
  std::vector<std::uint32_t> begin{0};
  for (const RationalPoint3& end : rays(1000)) {
    points.insert(points.end(), {{0, 0, 0}, end});
    begin.push_back(static_cast<std::uint32_t>(points.size()));
  }
  const Nef3 star = Nef3::polylines(points, begin, context);
  expect_sound(star, "a star of segments");
  EXPECT_EQ(star.counts().vertices, 1001U);
  EXPECT_EQ(star.counts().edges, 1000U);
  EXPECT_TRUE(star.interior().is_empty());
  // Segments end in the roof of the cone; those within are swallowed but for those on its surface.
  const Nef3 up = cone(40, 1, 0);
  expect_sound(star + up, "a star of segments and a cone");
  EXPECT_TRUE((star + up) - up == star - up);
  EXPECT_TRUE((star - up) + (star * up) == star);
}

TEST(DegenerateFamilies, HundredsOfTipsAtAVertex) {
  Context context;
  std::vector<Nef3> tips;
  for (const RationalPoint3& end : rays(250)) {
    const double x = 4 * end.x.convert_to<double>(), y = 4 * end.y.convert_to<double>();
    tips.push_back(solid(tetrahedron_mesh({0, 0, 0}, {x, y, 4}, {x + 1, y, 4}, {x, y + 1, 4})));
  }
  const Nef3 all = union_of(tips, context);
  expect_sound(all, "tips");
  EXPECT_EQ(all.counts().vertices, 751U);
  EXPECT_EQ(all.counts().marked_volumes, 250U);
  EXPECT_EQ(volume(all), 250 * volume(tips.front()));
  EXPECT_TRUE(all.interior().closure() == all);
}

TEST(DegenerateFamilies, FarAndNearNumbersTogether) {
  const double far = 1e300;
  const double near = 1e-300;
  const Nef3 giant = solid(
      tetrahedron_mesh({-far, -far, -far}, {0, far, -far}, {far, -far, near}, {near, near, far}));
  const Nef3 sliver = box({-far, -near, -near}, {far, near, near});
  const Nef3 thread = needle({-far, near, 0}, {far, 1, near});
  expect_laws("a giant and a sliver", giant, sliver);
  expect_laws("a giant and a thread", giant, thread);
  expect_laws("a sliver and a thread", sliver, thread);
  expect_laws("slivers across", sliver, box({-near, -far, -near}, {near, far, near}));
}

}  // namespace
}  // namespace plumb::testing::degenerate_families_test
