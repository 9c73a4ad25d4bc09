// The self-test of meshes held against clipping in rationals, and the meshes that people have.
#include "plumb/space/mesh/mesh_crossings.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <optional>
#include <string>

#include "generate/meshes.h"
#include "generate/voxel_mesh.h"
#include "oracle/facet_contacts.h"
#include "plumb/predicates/point3_signs.h"
#include "plumb/space/audit/audit_parts.h"
#include "plumb/space/bounds/packed_boxes.h"
#include "plumb/space/from_mesh.h"
#include "plumb/testing/dice.h"

namespace plumb::testing::mesh_crossings_test {
namespace {

using FacetPair = std::pair<FacetId, FacetId>;

MeshComplex made(const PolygonMesh& mesh) {
  Context context;
  MeshOptions options;
  options.surface = true;
  return complex_of_mesh(mesh, options, context);
}

FacetPolygon polygon_of(const SpaceComplex& complex, FacetId f) {
  FacetPolygon polygon;
  const UseId first = complex.cycles_of(f)[0];
  UseId u = first;
  do {
    polygon.push_back(exact(complex.points(), complex.vertex_point[complex.use_origin(u).value()]));
    u = complex.use_next[u.value()];
  } while (u != first);
  return polygon;
}

std::vector<FacetPair> brute_force(const SpaceComplex& complex) {
  std::vector<FacetPolygon> polygons;
  for (std::size_t f = 0; f < complex.facet_count(); ++f) {
    polygons.push_back(polygon_of(complex, FacetId(f)));
  }
  std::vector<FacetPair> pairs;
  for (std::size_t f = 0; f < polygons.size(); ++f) {
    for (std::size_t g = f + 1; g < polygons.size(); ++g) {
      if (meet_elsewhere(polygons[f], polygons[g])) pairs.emplace_back(f, g);
    }
  }
  return pairs;
}

void expect_as_brute_force(const PolygonMesh& mesh) {
  const MeshComplex complex = made(mesh);
  Context context;
  const auto found = find_mesh_crossings(complex.complex, complex.has_fan, context);
  EXPECT_EQ(found, brute_force(complex.complex));
  EXPECT_EQ(complex.report.crossing_count, found.size());
}

Point3 random_point(Dice& dice, int size, double unit) {
  const auto c = [&] { return unit * static_cast<double>(dice.between(0, size)); };
  return {c(), c(), c()};
}

PolygonMesh random_triangles(Dice& dice, int size, double unit, std::size_t count) {
  PolygonMesh mesh;
  for (std::uint32_t i = 0; i < 3 * count; i += 3) {
    for (int k = 0; k < 3; ++k) mesh.points.push_back(random_point(dice, size, unit));
    mesh.add_face(std::array{i, i + 1, i + 2});
  }
  return mesh;
}

// Few places, so that most contacts are degenerate; units that no double holds make points that are
// nearly on planes.
TEST(MeshCrossings, TrianglesAsBruteForce) {
  Dice dice(11);
  for (const int size : {1, 2, 3, 6}) {
    for (const double unit : {1.0, 0.1, 1e200 / 3}) {
      for (int round = 0; round < 20; ++round) {
        SCOPED_TRACE(std::to_string(size) + " " + std::to_string(unit) + " " +
                     std::to_string(round));
        expect_as_brute_force(random_triangles(dice, size, unit, 14));
      }
    }
  }
}

TEST(MeshCrossings, TrianglesWithFractionsAsBruteForce) {
  Dice dice(12);
  for (int round = 0; round < 60; ++round) {
    PolygonMesh mesh = random_triangles(dice, 2, 1, 10);
    for (std::uint32_t i = 0; i < mesh.points.size(); ++i) {
      const Point3& p = mesh.points[i];
      const Rational third = Rational(1) / 3;
      if (round % 2 == 0 || p.x < 2) {
        mesh.exact.emplace_back(i, RationalPoint3{p.x * third, p.y + third, p.z * third});
      }
    }
    expect_as_brute_force(mesh);
  }
}

TEST(MeshCrossings, BoxesAsBruteForce) {
  Dice dice(13);
  for (int round = 0; round < 25; ++round) {
    PolygonMesh mesh;
    for (int i = 0; i < 4; ++i) {
      Point3 low = random_point(dice, 2, 1), high = low;
      high.x += static_cast<double>(dice.between(1, 2));
      high.y += static_cast<double>(dice.between(1, 2));
      high.z += static_cast<double>(dice.between(1, 2));
      const PolygonMesh box = box_mesh(low, high);
      mesh = joined(mesh, i == 3 ? fanned(box) : box);
    }
    expect_as_brute_force(mesh);
  }
}

/// Triangles from the first point to the sides of the ring that the others are.
PolygonMesh star(std::vector<Point3> points) {
  std::vector<Face> faces;
  const auto n = static_cast<std::uint32_t>(points.size());
  for (std::uint32_t i = 1; i < n; ++i) faces.push_back({0, i, i + 1 < n ? i + 1 : 1});
  return make_mesh(std::move(points), faces);
}

// Around a vertex triangles lie side by side, fold back, stand on edge, go around twice or not at
// all.
TEST(MeshCrossings, StarsAsBruteForce) {
  Dice dice(14);
  for (int round = 0; round < 400; ++round) {
    const std::size_t n = 3 + static_cast<std::size_t>(round) % 5;
    std::vector<Point3> points{{1, 1, 1}};
    while (points.size() <= n) {
      const Point3 p = random_point(dice, 2, 1);
      if (!std::ranges::count(points, p)) points.push_back(p);
    }
    SCOPED_TRACE(round);
    expect_as_brute_force(star(points));
  }
}

/// The invariant that the steps of the audit find broken, given those vertices with a fan.
std::string flaw_of(const SpaceComplex& complex, std::span<const std::uint8_t> has_fan) {
  Context context;
  std::optional<SpaceFlaw> flaw = audit_places(complex, has_fan, context);
  if (!flaw) flaw = audit_cycles(complex, context);
  if (!flaw) flaw = audit_meeting(complex, has_fan, context);
  return flaw ? flaw->invariant : "";
}

/// A polygon that is seen from the origin, in a plane, and a point joined to its sides. The point
/// may see the polygon from above, from beside or through itself.
PolygonMesh pyramid(Dice& dice, std::size_t corners, bool is_closed) {
  std::vector<Point3> points;
  const double slope = static_cast<double>(dice.between(-1, 1));
  while (points.size() < corners) {
    const auto x = static_cast<double>(dice.between(-3, 3)),
               y = static_cast<double>(dice.between(-3, 3));
    const auto is_in_line = [&](const Point3& p) {
      return p.x * y == p.y * x && p.x * x + p.y * y >= 0;
    };
    const bool is_new = (x != 0 || y != 0) && std::ranges::none_of(points, is_in_line);
    if (is_new) points.push_back({x, y, slope * x + y});
  }
  std::ranges::sort(points, {}, [](const Point3& p) { return std::atan2(p.y, p.x); });
  const auto n = static_cast<std::uint32_t>(corners);
  std::vector<Face> faces(is_closed ? 1 : 0);
  for (std::uint32_t i = 0; i < n; ++i) {
    faces.push_back({n, i, (i + 1) % n});
    if (is_closed) faces[0].push_back(n - 1 - i);
  }
  points.push_back({static_cast<double>(dice.between(-4, 4)),
                    static_cast<double>(dice.between(-4, 4)),
                    static_cast<double>(dice.between(-4, 4))});
  return make_mesh(std::move(points), faces);
}

// Around corners of polygons, reflex ones too, and around points with fractions, which are
// constructed: fans hide no crossing from the test of meshes nor from the audit. (The brute force
// knows convex facets alone.)
TEST(MeshCrossings, FansOfPyramidsHideNothing) {
  Dice dice(15);
  std::size_t fans = 0, crossing = 0;
  constexpr int kRounds = 600;
  for (int round = 0; round < kRounds; ++round) {
    SCOPED_TRACE(round);
    const std::size_t corners = 3 + static_cast<std::size_t>(round) % 5;
    PolygonMesh mesh = pyramid(dice, corners, round % 4 != 0);
    const Rational third = Rational(1) / 3;
    for (std::uint32_t i = 0; i < mesh.points.size() && round % 2 == 0; ++i) {
      const Point3& p = mesh.points[i];
      mesh.exact.emplace_back(i, RationalPoint3{p.x * third, p.y * third, p.z * third});
    }
    if (corners == 3) expect_as_brute_force(mesh);
    const MeshComplex read = made(mesh);
    const std::vector<std::uint8_t> none(read.has_fan.size());
    Context context;
    EXPECT_EQ(read.crossings, find_mesh_crossings(read.complex, none, context));
    const bool crosses = read.report.crosses_itself();
    EXPECT_EQ(!flaw_of(read.complex, none).empty(), crosses) << flaw_of(read.complex, none);
    EXPECT_EQ(!flaw_of(read.complex, read.has_fan).empty(), crosses)
        << flaw_of(read.complex, read.has_fan);
    fans += static_cast<std::size_t>(std::ranges::count(read.has_fan, 1));
    crossing += crosses ? 1 : 0;
  }
  EXPECT_GT(fans, kRounds / 2);
  EXPECT_GT(crossing, kRounds / 10);
}

// Every step turns left, as in a fan, but they go around twice.
TEST(MeshCrossings, AStarThatGoesAroundTwiceIsNoFan) {
  const std::vector<Point3> ring{{4, 0, 0}, {-3, 2, 1}, {1, -4, 2}, {1, 4, 3}, {-3, -2, 4}};
  std::vector<Point3> points{{0, 0, -5}};
  points.insert(points.end(), ring.begin(), ring.end());
  EXPECT_TRUE(made(star(points)).report.crosses_itself());
  expect_as_brute_force(star(points));
}

// The reflex corner of a polygon goes nearly around the first point, triangles above it a little
// more than that.
TEST(MeshCrossings, APolygonAndTrianglesThatGoAroundTwiceAreNoFan) {
  const PolygonMesh mesh =
      make_mesh({{0, 0, 0},
                 {0, 2, 0},
                 {-3, 2, 0},
                 {-3, -3, 0},
                 {3, -3, 0},
                 {3, 2, 0},
                 {1, 2, 0},
                 {-1, 1, 1},
                 {-1, -1, 2},
                 {1, -1, 2},
                 {2, 2, 1}},
                {{0, 1, 2, 3, 4, 5, 6}, {0, 6, 7}, {0, 7, 8}, {0, 8, 9}, {0, 9, 10}, {0, 10, 1}});
  const MeshComplex read = made(mesh);
  EXPECT_TRUE(read.report.crosses_itself());
  EXPECT_NE(flaw_of(read.complex, read.has_fan), "");
}

// Two spheres that cross, in an order without any sense: the order is a matter of speed only.
TEST(MeshCrossings, AnyOrderGivesTheSamePairs) {
  const PolygonMesh spheres =
      joined(icosphere_mesh(3, 1, {}), icosphere_mesh(3, 1, {0.25, 0.125, 0.5}));
  PolygonMesh mesh;
  mesh.points = spheres.points;
  const std::size_t n = spheres.face_count();
  for (std::size_t f = 0; f < n; ++f) {
    const auto face = spheres.face(f * 769 % n);
    mesh.add_face(Face(face.begin(), face.end()));
  }
  const MeshComplex read = made(mesh);
  Context context;
  const auto any = find_mesh_crossings(read.complex, read.has_fan, context, BoxOrder::Any);
  EXPECT_GT(any.size(), 100U);
  EXPECT_EQ(any, find_mesh_crossings(read.complex, read.has_fan, context, BoxOrder::Kept));
}

// ---------------------------------------------------------------- packed boxes

Box3 random_box(Dice& dice, double unit) {
  Box3 box;
  for (std::size_t i = 0; i < 3; ++i) {
    box.low[i] = unit * static_cast<double>(dice.between(-50, 50));
    box.high[i] = box.low[i] + unit * static_cast<double>(dice.between(1, 20));
  }
  return box;
}

// Those that meet, each once; few others. One of the boxes may reach as far as all.
TEST(PackedBoxTree, FindsThePairsThatMeet) {
  Dice dice(15);
  for (const double unit : {1.0, 0.1, 1e-200, 1e250}) {
    for (const std::size_t n : {0U, 1U, 2U, 3U, 4U, 5U, 8U, 9U, 17U, 100U, 257U}) {
      SCOPED_TRACE(std::to_string(unit) + " " + std::to_string(n));
      std::vector<Box3> boxes;
      for (std::size_t i = 0; i < n; ++i) boxes.push_back(random_box(dice, unit));
      if (n % 3 == 2) {
        for (std::size_t i = 1; i < n; ++i) boxes[0].add(boxes[i]);
      }
      const PackedBoxTree tree(boxes);
      ASSERT_TRUE(tree.fits());
      std::vector<std::pair<std::uint32_t, std::uint32_t>> found;
      const auto note = [&](std::uint32_t i, std::uint32_t j) {
        found.emplace_back(std::min(i, j), std::max(i, j));
      };
      EXPECT_TRUE(tree.for_each_pair_inside(note, [] { return true; }));
      std::ranges::sort(found);
      EXPECT_EQ(std::ranges::adjacent_find(found), found.end());
      std::size_t meeting = 0;
      for (std::uint32_t i = 0; i < n; ++i) {
        for (std::uint32_t j = i + 1; j < n; ++j) {
          if (!boxes[i].meets(boxes[j])) continue;
          ++meeting;
          EXPECT_TRUE(std::ranges::binary_search(found, std::pair(i, j)));
        }
      }
      EXPECT_LE(found.size(), meeting + n);
    }
  }
}

// Boxes of triangles hold what boxes of doubles hold, whatever order the tree has.
TEST(PackedBoxTree, TakesTrianglesByTheirCorners) {
  Dice dice(19);
  for (const std::size_t n : {0U, 1U, 8U, 9U, 100U, 257U}) {
    std::vector<Point3> points(n);
    const auto coordinate = [&] { return 0.1 * static_cast<double>(dice.between(-50, 50)); };
    for (Point3& p : points) {
      p.x = coordinate();
      p.y = coordinate();
      p.z = coordinate();
    }
    std::vector<std::array<std::uint32_t, 3>> corners(n);
    std::vector<Box3> boxes(n);
    for (std::uint32_t t = 0; t < n; ++t) {
      corners[t] = {t, dice.below(static_cast<std::uint32_t>(n)),
                    dice.below(static_cast<std::uint32_t>(n))};
      for (const std::uint32_t c : corners[t]) {
        const std::array at{points[c].x, points[c].y, points[c].z};
        boxes[t].add({at, at});
      }
    }
    for (const BoxOrder order : {BoxOrder::Any, BoxOrder::Kept}) {
      const PackedBoxTree tree(points, corners, order);
      ASSERT_TRUE(tree.fits());
      std::vector<std::pair<std::uint32_t, std::uint32_t>> found;
      const auto note = [&](std::uint32_t i, std::uint32_t j) {
        found.emplace_back(std::min(i, j), std::max(i, j));
      };
      EXPECT_TRUE(tree.for_each_pair_inside(note, [] { return true; }));
      std::ranges::sort(found);
      EXPECT_EQ(std::ranges::adjacent_find(found), found.end());
      std::size_t meeting = 0;
      for (std::uint32_t i = 0; i < n; ++i) {
        for (std::uint32_t j = i + 1; j < n; ++j) {
          if (!boxes[i].meets(boxes[j])) continue;
          ++meeting;
          EXPECT_TRUE(std::ranges::binary_search(found, std::pair(i, j)));
        }
      }
      EXPECT_LE(found.size(), meeting + n);
    }
  }
}

// The query may be partly or wholly outside the boxes.
TEST(PackedBoxTree, FindsTheBoxesThatMeetAQuery) {
  Dice dice(18);
  std::size_t meeting = 0, others = 0;
  for (const std::size_t n : {0U, 1U, 5U, 8U, 9U, 100U, 257U}) {
    std::vector<Box3> boxes;
    for (std::size_t i = 0; i < n; ++i) boxes.push_back(random_box(dice, 0.1));
    const PackedBoxTree tree(boxes);
    ASSERT_TRUE(tree.fits());
    for (int query = 0; query < 100; ++query) {
      const Box3 box = random_box(dice, query % 2 == 0 ? 0.1 : 0.3);
      std::vector<std::uint32_t> found;
      tree.for_each_meeting(box, [&](std::uint32_t i) { found.push_back(i); });
      std::ranges::sort(found);
      EXPECT_EQ(std::ranges::adjacent_find(found), found.end());
      for (std::uint32_t i = 0; i < n; ++i) {
        const bool is_found = std::ranges::binary_search(found, i);
        if (boxes[i].meets(box)) {
          ++meeting;
          EXPECT_TRUE(is_found) << n << ' ' << query << ' ' << i;
        } else {
          others += is_found ? 1 : 0;
        }
      }
    }
  }
  EXPECT_GT(meeting, 100U);
  EXPECT_LT(others, meeting);
}

TEST(PackedBoxTree, LeavesManyScalesToOthers) {
  Dice dice(16);
  std::vector<Box3> boxes;
  for (int i = 0; i < 100; ++i) boxes.push_back(random_box(dice, 1e-9));
  EXPECT_TRUE(PackedBoxTree(boxes).fits());
  boxes.push_back(random_box(dice, 1e9));
  EXPECT_FALSE(PackedBoxTree(boxes).fits());
  boxes.back().high[1] = Box3::kInfinity;
  EXPECT_FALSE(PackedBoxTree(boxes).fits());
  boxes.assign(100, Box3{{1, 2, 3}, {1, 2, 3}});
  EXPECT_FALSE(PackedBoxTree(boxes).fits());
}

// All within some cells of the grid by which they are sorted, though not of the one that they are
// compared on.
TEST(PackedBoxTree, LeavesWhatItCannotSortToOthers) {
  Dice dice(17);
  std::vector<Box3> boxes;
  for (int i = 0; i < 6000; ++i) boxes.push_back(random_box(dice, 1));
  EXPECT_TRUE(PackedBoxTree(boxes).fits());
  boxes.push_back({{1e5, 1e5, 1e5}, {1e5 + 1, 1e5 + 1, 1e5 + 1}});
  EXPECT_FALSE(PackedBoxTree(boxes).fits());
}

TEST(PackedBoxTree, StopsWhenItIsTold) {
  Dice dice(18);
  std::vector<Box3> boxes;
  for (int i = 0; i < 300; ++i) boxes.push_back(random_box(dice, 1));
  const PackedBoxTree tree(boxes);
  for (const std::size_t most : {0U, 1U, 10U, 100U, 150U}) {
    std::size_t asked = 0, visited = 0;
    const auto count = [&](std::uint32_t, std::uint32_t) { ++visited; };
    EXPECT_FALSE(tree.for_each_pair_inside(count, [&] { return asked++ < most; }));
    EXPECT_EQ(asked, most + 1);
    EXPECT_LE(visited, most);
  }
}

TEST(MeshCrossings, StarsWithManyTips) {
  // So many that many lie in one cell of a coarse grid. By boxes alone this would take minutes.
  EXPECT_FALSE(made(star_prism(16000)).report.crosses_itself());
  PolygonMesh star = star_prism(1500);
  star.points[0].z += 3;  // a tip below comes through what is above it
  const MeshComplex bent = made(star);
  EXPECT_TRUE(bent.report.crosses_itself());
  EXPECT_LT(bent.report.crossing_count, 20U);
}

// Many triangles around a vertex, and of one facet: by all pairs of them this would take minutes.
TEST(MeshCrossings, ManyTrianglesAtAVertex) {
  EXPECT_FALSE(made(cone_mesh(20000, 1)).report.crosses_itself());
  EXPECT_FALSE(made(cone_mesh(5000, 1e-6)).report.crosses_itself());
  EXPECT_FALSE(made(comb_prism(1500)).report.crosses_itself());
  PolygonMesh cone = cone_mesh(3000, 1);
  cone.points[7] = {-2, 0.01, 0.25};  // a fold through the other side
  const MeshComplex folded = made(cone);
  EXPECT_GT(folded.report.crossing_count, 10U);
  EXPECT_LT(folded.report.crossing_count, 4000U);
}

/// Triangles between some directions from two points.
PolygonMesh pencil(Dice& dice, std::size_t count) {
  PolygonMesh mesh;
  while (mesh.face_count() < count) {
    const auto first = static_cast<std::uint32_t>(mesh.points.size());
    const double side = dice.below(5) == 0 ? 5 : 0;
    mesh.points.push_back({side, 0, 0});
    for (int i = 0; i < 2; ++i) {
      const Point3 d = random_point(dice, 6, 1);
      mesh.points.push_back({side + d.x - 3, d.y - 3, d.z - 3});
    }
    mesh.add_face(std::array{first, first + 1, first + 2});
  }
  return mesh;
}

TEST(MeshCrossings, ManyTrianglesAtAVertexAsBruteForce) {
  Dice dice(19);
  expect_as_brute_force(pencil(dice, 200));
}

// Small spheres far apart: the other tree.
TEST(MeshCrossings, OfManyScales) {
  PolygonMesh mesh =
      joined(icosphere_mesh(1, 1e-12, {0, 0, 0}), icosphere_mesh(1, 1e-12, {1e-12, 0, 0}));
  mesh = joined(mesh, icosphere_mesh(1, 1, {1e6, 0, 0}));
  EXPECT_TRUE(made(mesh).report.crosses_itself());
  expect_as_brute_force(mesh);
}

// Sheets much closer than the cells of the small boxes, above one another: each seems to meet all.
// Tests of all pairs would take this test very long.
TEST(MeshCrossings, OfManyCloseSheetsInLessThanQuadraticTime) {
  constexpr std::uint32_t kSheets = 10000;
  PolygonMesh mesh;
  const auto add = [&mesh](double x, double y, double z) {
    const auto first = static_cast<std::uint32_t>(mesh.points.size());
    mesh.points.insert(mesh.points.end(), {{x, y, z}, {x + 1, y, z}, {x, y + 1, z}});
    mesh.add_face(std::array{first, first + 1, first + 2});
  };
  for (std::uint32_t i = 0; i < kSheets; ++i) {
    add(i % 16 / 64.0, i / 16 % 16 / 64.0, 1e-9 * i);
  }
  add(0, 0, 1000);
  EXPECT_EQ(made(mesh).report.crossing_count, 0U);
  mesh.points.insert(mesh.points.end(), {{0.3, 0.3, -1}, {0.4, 0.3, -1}, {0.3, 0.3, 1}});
  const auto last = static_cast<std::uint32_t>(mesh.points.size());
  mesh.add_face(std::array{last - 3, last - 2, last - 1});
  EXPECT_EQ(made(mesh).report.crossing_count, kSheets);
}

// ---------------------------------------------------------------- meshes

struct Case {
  const char* name;
  PolygonMesh mesh;
  bool is_clean;
};

TEST(MeshCrossings, MeshesThatPeopleHave) {
  const PolygonMesh cube = box_mesh({0, 0, 0}, {3, 3, 3});
  const std::vector<Point2> c_shape = {{0, 0}, {3, 0}, {3, 1}, {1, 1},
                                       {1, 2}, {3, 2}, {3, 3}, {0, 3}};
  const PolygonMesh tetrahedron = tetrahedron_mesh({0, 0, 0}, {0, 4, 0}, {4, 0, 0}, {0, 0, 4});
  const std::vector<Case> cases = {
      {"a cube", cube, true},
      {"in triangles", fanned(cube), true},
      {"nested", joined(cube, reversed(box_mesh({1, 1, 1}, {2, 2, 2}))), true},
      {"apart", joined(cube, moved(cube, {4, 0, 0})), true},
      {"doubled: one facet each", joined(cube, cube), true},
      {"a common face", joined(cube, moved(cube, {3, 0, 0})), true},
      {"a common edge", joined(cube, moved(cube, {3, 3, 0})), true},
      {"a common corner", joined(cube, moved(cube, {3, 3, 3})), true},
      {"half a common face", joined(cube, moved(cube, {3, 1, 0})), false},
      {"half a common edge", joined(cube, moved(cube, {3, 3, 1})), false},
      {"doubled with another diagonal", joined(cube, fanned(cube)), false},
      {"two overlapping tetrahedra", joined(tetrahedron, moved(tetrahedron, {1, 1, 1})), false},
      {"a corner on a face", joined(cube, moved(tetrahedron, {1, 1, 3})), false},
      {"a corner in a notch",
       joined(prism_mesh(c_shape, 0, 3), box_mesh({2, 1.25, 1}, {4, 1.75, 2})), true},
      {"a tongue through a wall",
       joined(prism_mesh(c_shape, 0, 3), box_mesh({0.5, 1.25, 1}, {4, 1.75, 2})), false},
      {"touching in the notch",
       joined(prism_mesh(c_shape, 0, 3), box_mesh({1, 1.25, 1}, {4, 1.75, 2})), false},
      {"a sphere", icosphere_mesh(3, 0.1, {0.1, 0.1, 0.1}), true},
      {"two spheres",
       joined(icosphere_mesh(2, 1, {0, 0, 0}), icosphere_mesh(2, 1, {0.1, 0.1, 0.1})), false},
  };
  for (const Case& c : cases) {
    const MeshReport report = made(c.mesh).report;
    EXPECT_EQ(report.crosses_itself(), !c.is_clean) << c.name;
    EXPECT_TRUE(report.is_closed()) << c.name;
  }
}

// A vertex in the middle of a neighbour's edge.
TEST(MeshCrossings, TJunctionsAreFound) {
  PolygonMesh mesh = tetrahedron_mesh({0, 0, 0}, {0, 2, 0}, {2, 0, 0}, {0, 0, 2});
  mesh.points.push_back({0, 1, 0});
  const PolygonMesh split =
      make_mesh(mesh.points, {{0, 4, 2}, {4, 1, 2}, {1, 0, 3}, {2, 1, 3}, {0, 2, 3}, {0, 1, 4}});
  const MeshReport report = made(split).report;
  EXPECT_TRUE(report.is_closed());
  EXPECT_EQ(report.crossings, (std::vector<MeshReport::FacePair>{{0, 2}, {1, 2}}));
}

// A diagonal of one quad is a side of the other's triangles: they share two vertices and no edge.
TEST(MeshCrossings, ADiagonalIsNoEdge) {
  const PolygonMesh mesh = make_mesh({{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}, {1, 1, 3}},
                                     {{0, 1, 2, 3}, {0, 2, 4}, {1, 3, 4}});
  EXPECT_EQ(made(mesh).report.crossings,
            (std::vector<MeshReport::FacePair>{{0, 1}, {0, 2}, {1, 2}}));
}

TEST(MeshCrossings, ListsAreCutCountsAreNot) {
  Context context;
  MeshOptions options;
  options.max_listed = 3;
  const PolygonMesh mesh =
      joined(icosphere_mesh(1, 1, {0, 0, 0}), icosphere_mesh(1, 1, {0.1, 0, 0}));
  const MeshReport report = complex_of_mesh(mesh, options, context).report;
  EXPECT_EQ(report.crossings.size(), 3U);
  EXPECT_GT(report.crossing_count, 3U);
}

}  // namespace
}  // namespace plumb::testing::mesh_crossings_test
