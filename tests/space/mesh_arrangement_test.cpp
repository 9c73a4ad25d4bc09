// Soups: closed meshes that cross themselves, overlap, are doubled, nested or inside out, against
// the twin that asks for the winding number of every cell of all planes.
#include "plumb/space/mesh/mesh_arrangement.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <utility>

#include "generate/mesh_solid.h"
#include "generate/meshes.h"
#include "generate/space_solids.h"
#include "generate/test_share.h"
#include "oracle/nef3_check.h"
#include "plumb/predicates/error.h"
#include "plumb/space/mesh/mesh_arrangement.h"
#include "plumb/space/query/volumes.h"
#include "plumb/space/space_measure.h"
#include "plumb/testing/dice.h"

namespace plumb::testing::mesh_arrangement_test {
namespace {

constexpr MeshRule kRules[] = {MeshRule::Positive, MeshRule::NonZero, MeshRule::Odd};

void expect_as_twin(MeshLeaf soup, const std::string& name) {
  for (const MeshRule rule : kRules) {
    soup.rule = rule;
    EXPECT_EQ(disagreement(*space_set(soup)), "") << name;
  }
}

// ---------------------------------------------------------------- named soups

struct NamedSoup {
  std::string name;
  MeshLeaf mesh;
};

const MeshLeaf kCube = box({0, 0, 0}, {2, 2, 2});

MeshLeaf turned_tetrahedron(int by) {
  return moved(tetrahedron({0, 0, 0}, {3, 0, 0}, {0, 3, 0}, {0, 0, 3}), {by, 0, 0});
}

/// A quadrilateral that crosses itself, as a prism.
MeshLeaf bow_tie() { return prism({{0, 0, 0}, {4, 4, 0}, {4, 0, 0}, {0, 2, 0}}, 2, 0, 2); }

/// Round a square twice.
MeshLeaf double_ring() {
  return prism(
      {{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {1, 4, 0}, {1, 1, 0}, {3, 1, 0}, {3, 3, 0}, {0, 3, 0}}, 2,
      0, 1);
}

std::vector<NamedSoup> overlapping_soups() {
  const MeshLeaf tetrahedron = turned_tetrahedron(0);
  return {
      {"two overlapping tetrahedra", together(tetrahedron, turned_tetrahedron(1))},
      {"two overlapping cubes", together(kCube, moved(kCube, {1, 1, 1}))},
      {"one of them inside out", together(kCube, inside_out(moved(kCube, {1, 1, 1})))},
      {"both inside out", inside_out(together(kCube, moved(kCube, {1, 1, 1})))},
      {"a cube three times", together(kCube, together(kCube, kCube))},
      {"a cube and its opposite", together(kCube, inside_out(kCube))},
      {"shifted along a facet", together(kCube, moved(kCube, {1, 0, 0}))},
      {"shifted along two", together(kCube, moved(kCube, {1, 1, 0}))},
      {"cross of two bars", together(box({0, 1, 1}, {4, 2, 2}), box({1, 0, 1}, {2, 4, 2}))},
      {"cross of three bars",
       together(together(box({0, 1, 1}, {3, 2, 2}), box({1, 0, 1}, {2, 3, 2})),
                box({1, 1, 0}, {2, 2, 3}))},
      {"tetrahedron through a cube", together(kCube, moved(turned_tetrahedron(0), {1, 1, 1}))},
      {"bow tie", bow_tie()},
      {"bow tie and cube", together(bow_tie(), box({1, 1, 1}, {2, 3, 3}))},
      {"double ring", double_ring()},
  };
}

std::vector<NamedSoup> touching_soups() {
  return {
      {"at a facet", together(kCube, moved(kCube, {2, 0, 0}))},
      {"at an edge", together(kCube, moved(kCube, {2, 2, 0}))},
      {"at a vertex", together(kCube, moved(kCube, {2, 2, 2}))},
      {"a void in a void",
       together(together(box({0, 0, 0}, {5, 5, 5}), inside_out(box({1, 1, 1}, {4, 4, 4}))),
                inside_out(box({2, 2, 2}, {3, 3, 3})))},
      {"a solid in a void",
       together(together(box({0, 0, 0}, {5, 5, 5}), inside_out(box({1, 1, 1}, {4, 4, 4}))),
                box({2, 2, 2}, {3, 3, 3}))},
  };
}

std::vector<NamedSoup> meeting_soups() {
  return {
      {"half a facet", together(kCube, moved(kCube, {2, 1, 0}))},
      {"small facet on a large one",
       together(box({0, 0, 0}, {3, 3, 3}), box({1, 1, 3}, {2, 2, 4}))},
      {"notch by an inside-out box",
       together(box({0, 0, 0}, {3, 3, 3}), inside_out(box({1, 1, 2}, {2, 2, 3})))},
      {"shaft by an inside-out box",
       together(box({0, 0, 0}, {3, 3, 3}), inside_out(box({1, 1, 0}, {2, 2, 3})))},
      {"vertex on a facet", together(box({0, 0, 0}, {3, 3, 3}),
                                     tetrahedron({1, 1, 3}, {1, 2, 5}, {2, 1, 5}, {2, 2, 5}))},
      {"vertex from within", together(box({0, 0, 0}, {3, 3, 3}),
                                      tetrahedron({1, 1, 3}, {1, 2, 1}, {2, 1, 1}, {2, 2, 1}))},
      {"edge on a facet", together(box({0, 0, 0}, {3, 3, 3}),
                                   tetrahedron({1, 1, 3}, {2, 1, 3}, {1, 2, 5}, {2, 2, 5}))},
      {"edge on an edge", together(kCube, box({2, 2, 1}, {3, 3, 4}))},
      {"needles across", together(tetrahedron({0, 0, 0}, {4, 0, 0}, {4, 1, 0}, {4, 0, 1}),
                                  tetrahedron({2, -2, 0}, {2, 2, 0}, {3, 2, 0}, {2, 2, 1}))},
  };
}

TEST(MeshArrangement, OverlappingSoupsAreThoseOfTheTwin) {
  for (const NamedSoup& soup : overlapping_soups()) expect_as_twin(soup.mesh, soup.name);
}

TEST(MeshArrangement, MeetingSoupsAreThoseOfTheTwin) {
  for (const NamedSoup& soup : meeting_soups()) expect_as_twin(soup.mesh, soup.name);
}

PolygonMesh polygons(const MeshLeaf& leaf) {
  PolygonMesh mesh;
  for (const ExactPoint3& p : leaf.points) {
    mesh.points.emplace_back();
    EXPECT_TRUE(as_double(p, mesh.points.back()));
  }
  for (const auto& face : leaf.faces) {
    mesh.add_face(std::vector<std::uint32_t>(face.begin(), face.end()));
  }
  return mesh;
}

TEST(MeshArrangement, TouchingIsNotCrossing) {
  for (const NamedSoup& soup : touching_soups()) {
    expect_as_twin(soup.mesh, soup.name);
    Context context;
    MeshComplex mesh = complex_of_mesh(polygons(soup.mesh), {}, context);
    EXPECT_FALSE(mesh.report.crosses_itself()) << soup.name;
    const std::size_t facets = mesh.complex.facet_count();
    arrange(mesh, context);
    EXPECT_EQ(mesh.complex.facet_count(), facets) << soup.name;
    EXPECT_EQ(facet_jumps(mesh), mesh.jump) << soup.name;
    EXPECT_TRUE(mesh.has_fan.empty()) << soup.name;
  }
}

// ---------------------------------------------------------------- random soups

ExactPoint3 random_point(Dice& dice, int size) {
  const auto x = dice.between(0, size), y = dice.between(0, size);
  const auto z = dice.between(0, size);
  return {x, y, z};
}

MeshLeaf random_box(Dice& dice) {
  while (true) {
    const ExactPoint3 p = random_point(dice, 3);
    const ExactPoint3 q = random_point(dice, 3);
    if (p.x != q.x && p.y != q.y && p.z != q.z) return box(p, q);
  }
}

bool are_flat(const ExactPoint3& a, const ExactPoint3& b, const ExactPoint3& c) {
  return cross(b - a, c - a) == ExactPoint3{};
}

/// Triangles of points anywhere in a closed pattern: most of them cross.
MeshLeaf random_pattern(Dice& dice, std::size_t points,
                        std::vector<std::vector<std::size_t>> faces) {
  while (true) {
    MeshLeaf mesh;
    for (std::size_t i = 0; i < points; ++i) mesh.points.push_back(random_point(dice, 2));
    mesh.faces = faces;
    const auto is_flat = [&](const auto& f) {
      return are_flat(mesh.points[f[0]], mesh.points[f[1]], mesh.points[f[2]]);
    };
    if (std::ranges::none_of(mesh.faces, is_flat)) return mesh;
  }
}

MeshLeaf random_tetrahedron(Dice& dice) {
  return random_pattern(dice, 4, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}});
}

MeshLeaf random_bipyramid(Dice& dice) {
  return random_pattern(dice, 5,
                        {{0, 1, 3}, {1, 2, 3}, {2, 0, 3}, {1, 0, 4}, {2, 1, 4}, {0, 2, 4}});
}

MeshLeaf maybe_inside_out(Dice& dice, MeshLeaf mesh) {
  return dice.below(4) == 0 ? inside_out(std::move(mesh)) : mesh;
}

TEST(MeshArrangement, RandomBoxesAreThoseOfTheTwin) {
  for (std::uint64_t seed = 0; seed < share_of(40) && !HasFailure(); ++seed) {
    Dice dice(seed);
    MeshLeaf soup = random_box(dice);
    const std::size_t more = 1 + seed % 4;
    for (std::size_t i = 0; i < more; ++i) {
      MeshLeaf next = random_box(dice);
      soup = together(std::move(soup), maybe_inside_out(dice, std::move(next)));
    }
    soup.rule = kRules[seed % 3];
    EXPECT_EQ(disagreement(*space_set(soup)), "") << "seed " << seed;
  }
}

TEST(MeshArrangement, RandomSlantedSoupsAreThoseOfTheTwin) {
  for (std::uint64_t seed = 0; seed < share_of(60) && !HasFailure(); ++seed) {
    Dice dice(seed);
    MeshLeaf soup = seed % 2 == 0 ? random_tetrahedron(dice) : random_bipyramid(dice);
    if (seed % 3 != 0) {
      MeshLeaf next = seed % 3 == 1 ? random_tetrahedron(dice) : box({0, 0, 0}, {1, 2, 1});
      soup = together(std::move(soup), maybe_inside_out(dice, std::move(next)));
    }
    soup.rule = kRules[seed / 6 % 3];
    EXPECT_EQ(disagreement(*space_set(soup)), "") << "seed " << seed;
  }
}

// Coordinates that no double holds.
TEST(MeshArrangement, RandomSoupsOfFractionsAreThoseOfTheTwin) {
  for (std::uint64_t seed = 0; seed < 12 && !HasFailure(); ++seed) {
    Dice dice(seed);
    MeshLeaf soup = random_box(dice);
    for (std::size_t i = 0; i < 1 + seed % 2; ++i) {
      MeshLeaf next = seed % 3 == 0 ? random_tetrahedron(dice) : random_box(dice);
      soup = together(std::move(soup), maybe_inside_out(dice, std::move(next)));
    }
    for (ExactPoint3& p : soup.points) p = BigRational(1, 3) * p;
    soup.rule = kRules[seed % 3];
    EXPECT_EQ(disagreement(*space_set(soup)), "") << "seed " << seed;
  }
}

// ---------------------------------------------------------------- laws

struct Turned {
  std::vector<std::uint32_t> faces;
  Nef3 set;
};

Turned turned(const PolygonMesh& mesh) {
  Context context;
  MeshComplex made = complex_of_mesh(mesh, {}, context);
  Turned result;
  result.faces = turn_inside_out(made, context);
  result.set = Nef3::from_mesh_complex(std::move(made), WindingRule::Positive, context);
  return result;
}

Rational volume(const Nef3& set) { return *marked_volume(set.complex()); }

TEST(MeshArrangement, SpheresInOneMeshAreTheirUnion) {
  const PolygonMesh a = icosphere_mesh(2, 1, {0, 0, 0});
  const PolygonMesh b = icosphere_mesh(2, 1, {0.5, 0.25, 0.125});
  const PolygonMesh c = icosphere_mesh(1, 0.75, {-0.5, 0.25, 0.5});
  const PolygonMesh all = joined(joined(a, b), c);
  EXPECT_TRUE(solid(joined(a, b)) == solid(a) + solid(b));
  EXPECT_TRUE(solid(all) == solid(a) + solid(b) + solid(c));
  EXPECT_TRUE(solid(all, WindingRule::NonZero) == solid(all));
  EXPECT_TRUE(solid(all, WindingRule::EvenOdd) ==
              (solid(a) ^ solid(b) ^ solid(c)).regularization());
  EXPECT_TRUE(solid(joined(a, reversed(b))) == (solid(a) - solid(b)).closure());
}

TEST(MeshArrangement, CopiesCountOnce) {
  const PolygonMesh sphere = icosphere_mesh(1, 1, {0, 0, 0});
  PolygonMesh copies = sphere;
  for (int k = 1; k < 4; ++k) {
    copies = joined(copies, k % 2 == 0 ? sphere : fanned(sphere));
    EXPECT_TRUE(solid(copies) == solid(sphere));
    EXPECT_EQ(solid(copies, WindingRule::EvenOdd).is_empty(), k % 2 == 1);
  }
  // The same box, its faces cut otherwise.
  const PolygonMesh box = box_mesh({0, 0, 0}, {2, 1, 1});
  const PolygonMesh two = joined(box_mesh({0, 0, 0}, {1, 1, 1}), box_mesh({1, 0, 0}, {2, 1, 1}));
  EXPECT_TRUE(solid(joined(joined(box, fanned(box)), two)) == solid(box));
  EXPECT_TRUE(solid(joined(joined(box, fanned(box)), reversed(two))) == solid(box));
  EXPECT_TRUE(solid(joined(fanned(box), reversed(two))).is_empty());
}

TEST(MeshArrangement, ShiftedAlongItsFacets) {
  const PolygonMesh bar = box_mesh({0, 0, 0}, {4, 1, 1});
  PolygonMesh row;
  for (int k = 0; k < 5; ++k) row = joined(row, moved(fanned(bar), {1.0 * k, 0, 0}));
  EXPECT_TRUE(solid(row) == solid(box_mesh({0, 0, 0}, {8, 1, 1})));
  // Odd numbers of bars upon each other: [0, 1], [2, 3], [5, 6], [7, 8].
  EXPECT_EQ(volume(solid(row, WindingRule::EvenOdd)), 4);
}

// Faces that meet along parts of edges: no two of them have both ends in common.
TEST(MeshArrangement, EdgesWithVerticesOnThemAreClosed) {
  PolygonMesh mesh = box_mesh({0, 0, 0}, {6, 6, 6});
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    std::vector<std::uint32_t> corners(mesh.face(f).begin(), mesh.face(f).end());
    PolygonMesh apart = mesh;
    apart.face_begin.resize(1);
    apart.corners.clear();
    for (std::size_t g = 0; g < mesh.face_count(); ++g) {
      if (g != f) apart.add_face(mesh.face(g));
    }
    // The face gets a vertex on each edge.
    std::vector<std::uint32_t> with_vertices;
    for (std::size_t i = 0; i < 4; ++i) {
      const Point3 p = mesh.points[corners[i]], q = mesh.points[corners[(i + 1) % 4]];
      with_vertices.push_back(corners[i]);
      with_vertices.push_back(static_cast<std::uint32_t>(apart.points.size()));
      apart.points.push_back({(2 * p.x + q.x) / 3, (2 * p.y + q.y) / 3, (2 * p.z + q.z) / 3});
    }
    apart.add_face(with_vertices);
    EXPECT_TRUE(solid(apart) == solid(mesh));
    EXPECT_TRUE(turned(apart).faces.empty() && turned(apart).set == solid(mesh));
    EXPECT_TRUE(turned(reversed(apart)).set == solid(mesh));
    // A hole is one all the same.
    apart.face_begin.pop_back();
    apart.corners.resize(apart.face_begin.back());
    EXPECT_THROW(solid(apart), Error);
  }
}

// A face cut by a line that its neighbours know nothing of, and one closed by a face without area.
TEST(MeshArrangement, FacesWithoutAreaCloseGaps) {
  const PolygonMesh gap = make_mesh({{0, 0, 0}, {0, 2, 0}, {2, 0, 0}, {0, 0, 2}, {0, 1, 0}},
                                    {{0, 4, 2}, {4, 1, 2}, {1, 0, 3}, {2, 1, 3}, {0, 2, 3}});
  PolygonMesh closed = gap;
  closed.add_face(std::vector<std::uint32_t>{0, 1, 4});
  const Nef3 whole = solid(tetrahedron_mesh({0, 0, 0}, {0, 2, 0}, {2, 0, 0}, {0, 0, 2}));
  EXPECT_EQ(volume(whole), Rational(4) / 3);
  EXPECT_TRUE(solid(gap) == whole && solid(closed) == whole);
  EXPECT_TRUE(turned(reversed(closed)).set == whole);
}

TEST(MeshArrangement, SurfacesAreCutToo) {
  const auto sheet = [](Point3 a, Point3 b, Point3 c) { return make_mesh({a, b, c}, {{0, 1, 2}}); };
  const PolygonMesh one = sheet({0, 0, 0}, {4, 0, 0}, {0, 4, 0});
  const PolygonMesh two = sheet({1, 1, -1}, {1, 1, 2}, {4, 4, 2});
  const PolygonMesh three = sheet({1, 1, 0}, {5, 1, 0}, {1, 5, 0});  // in the plane of the first
  Context context;
  MeshOptions options;
  options.surface = true;
  const auto surface = [&](const PolygonMesh& mesh) {
    return Nef3::from_facets(complex_of_mesh(mesh, options, context), context);
  };
  EXPECT_TRUE(surface(joined(joined(one, two), three)) ==
              surface(one) + surface(two) + surface(three));
  const PolygonMesh a = box_mesh({0, 0, 0}, {2, 2, 2}), b = moved(a, {1, 1, 0});
  EXPECT_TRUE(surface(joined(a, b)) == surface(a) + surface(b));
  EXPECT_THROW(Nef3::from_facets(complex_of_mesh(one, {}, context), context), Error);
}

TEST(MeshArrangement, FacetsComeFromTheirFaces) {
  Context context;
  MeshComplex mesh = complex_of_mesh(
      joined(box_mesh({0, 0, 0}, {2, 2, 2}), box_mesh({1, 0, 0}, {3, 2, 2})), {}, context);
  EXPECT_EQ(mesh.jump.size(), 12U);
  arrange(mesh, context);
  EXPECT_TRUE(mesh.has_fan.empty());
  for (std::uint32_t f = 0; f < mesh.complex.facet_count(); ++f) {
    const auto sheets = mesh.sheets_of(FacetId(f));
    EXPECT_LE(sheets.size(), 2U);
    EXPECT_EQ(mesh.complex.facet_origin[f], sheets[0]);
    for (const std::uint32_t s : sheets) EXPECT_EQ(s / 6, s == sheets[0] && s < 6 ? 0U : 1U);
  }
  // Bottom, top, front and back of both lie upon each other in the middle.
  const std::vector<std::int32_t> jumps = facet_jumps(mesh);
  EXPECT_EQ(std::ranges::count_if(jumps, [](auto j) { return j == 2 || j == -2; }), 4);
  const auto winding = winding_numbers(mesh.complex, jumps);
  EXPECT_EQ(winding.size(), 4U);
  EXPECT_EQ(std::ranges::count(winding, 2), 1);
}

// ---------------------------------------------------------------- inside out

/// The cube [0, 4]^3, each face cut into n x n squares.
PolygonMesh cut_cube(int n) {
  const PolygonMesh cube = box_mesh({0, 0, 0}, {4, 4, 4});
  PolygonMesh mesh;
  for (std::size_t f = 0; f < 6; ++f) {
    const auto corners = cube.face(f);
    const Point3 o = cube.points[corners[0]], p = cube.points[corners[1]],
                 q = cube.points[corners[3]];
    const auto at = [&](int i, int j) {
      const double s = 1.0 * i / n, t = 1.0 * j / n;
      mesh.points.push_back({o.x + s * (p.x - o.x) + t * (q.x - o.x),
                             o.y + s * (p.y - o.y) + t * (q.y - o.y),
                             o.z + s * (p.z - o.z) + t * (q.z - o.z)});
      return static_cast<std::uint32_t>(mesh.points.size() - 1);
    };
    for (int i = 0; i < n * n; ++i) {
      const int x = i % n, y = i / n;
      mesh.add_face(std::array{at(x, y), at(x + 1, y), at(x + 1, y + 1), at(x, y + 1)});
    }
  }
  return mesh;
}

TEST(MeshArrangement, ComponentsInsideOutAreTurned) {
  using Faces = std::vector<std::uint32_t>;
  const PolygonMesh cube = box_mesh({0, 0, 0}, {4, 4, 4});
  const PolygonMesh across = box_mesh({2, 2, 2}, {6, 6, 6});
  const PolygonMesh within = box_mesh({1, 1, 1}, {2, 2, 2});
  const PolygonMesh notch = box_mesh({1, 1, 3}, {2, 2, 4});
  struct Row {
    const char* name;
    PolygonMesh mesh;
    Faces faces;
    Nef3 expected;
  };
  const Row rows[] = {
      {"crossing", joined(cube, reversed(across)), {6}, solid(cube) + solid(across)},
      {"both", reversed(joined(cube, across)), {0, 6}, solid(cube) + solid(across)},
      {"a void is no mistake",
       joined(cube, reversed(within)),
       {},
       solid(joined(cube, reversed(within)))},
      {"nor is a notch", joined(cube, reversed(notch)), {}, solid(joined(cube, reversed(notch)))},
      {"solid and void in it, all inside out",
       reversed(joined(cube, reversed(within))),
       {0},
       solid(cube)},
      {"the same twice, edge on edge", reversed(joined(cube, fanned(cube))), {0}, solid(cube)},
      {"the same twice, no edge in common",
       reversed(joined(cut_cube(2), cut_cube(4))),
       {0, 24},
       solid(cube)},
      {"a void across two solids",
       joined(joined(cube, across), reversed(box_mesh({3, 3, 3}, {5, 5, 5}))),
       {},
       solid(joined(joined(cube, across), reversed(box_mesh({3, 3, 3}, {5, 5, 5}))))},
  };
  for (const Row& row : rows) {
    const Turned got = turned(row.mesh);
    EXPECT_EQ(got.faces, row.faces) << row.name;
    EXPECT_TRUE(got.set == row.expected) << row.name;
  }
}

/// An octahedron whose facets are three triangles each, in one plane.
PolygonMesh split_octahedron() {
  std::vector<Point3> points{{3, 0, 0}, {-3, 0, 0}, {0, 3, 0}, {0, -3, 0}, {0, 0, 3}, {0, 0, -3}};
  std::vector<Face> faces;
  for (std::uint32_t octant = 0; octant < 8; ++octant) {
    const std::uint32_t x = octant & 1U, y = octant >> 1U & 1U, z = octant >> 2U;
    std::array<std::uint32_t, 3> tip{x, 2 + y, 4 + z};
    if ((x + y + z) % 2 == 1) std::swap(tip[0], tip[1]);
    const auto middle = static_cast<std::uint32_t>(points.size());
    points.push_back({x == 0 ? 1. : -1., y == 0 ? 1. : -1., z == 0 ? 1. : -1.});
    for (std::size_t i = 0; i < 3; ++i) faces.push_back({tip[i], tip[(i + 1) % 3], middle});
  }
  return make_mesh(std::move(points), faces);
}

// The volumes of one closed surface, read off its jumps if all its vertices have fans or one ring
// of corners, held against the search for volumes.
TEST(MeshArrangement, OneShellHasTheVolumesOfTheSearch) {
  Context context;
  const PolygonMesh sphere = icosphere_mesh(2, 1, {}), cube = grid_cube_mesh(3, {0, 0, 0});
  const PolygonMesh star = prism_mesh({{0, 0}, {4, 0}, {1, 1}, {0, 4}}, 0, 3);
  int with_fans = 0;
  for (const PolygonMesh& outwards :
       {sphere, split_octahedron(), joined(sphere, sphere), cube, star}) {
    for (const bool is_reversed : {false, true}) {
      for (const bool joins_coplanar : {false, true}) {
        const PolygonMesh mesh = is_reversed ? reversed(outwards) : outwards;
        MeshComplex made = complex_of_mesh(mesh, {.joins_coplanar = joins_coplanar}, context);
        with_fans += std::ranges::count(made.has_fan, 0) == 0 ? 1 : 0;
        SpaceComplex searched = made.complex;
        label_volumes(searched, context);
        arrange(made, context);
        EXPECT_EQ(made.complex.volume_mark, searched.volume_mark);
        EXPECT_EQ(made.complex.facet_volume, searched.facet_volume);
        EXPECT_EQ(made.complex.edge_volume, searched.edge_volume);
        EXPECT_EQ(made.complex.vertex_volume, searched.vertex_volume);
        const auto winding = winding_numbers(made.complex, facet_jumps(made));
        EXPECT_EQ(winding[VolumeId(0)], 0);
        EXPECT_EQ(winding[VolumeId(1)] < 0, is_reversed);
      }
    }
  }
  EXPECT_EQ(with_fans, 16);  // All but the prism, which is not seen to be star-shaped.
}

TEST(MeshArrangement, FacetsOfFractions) {
  const Rational third = Rational(1) / 3;
  const std::vector<RationalPoint3> corners = {
      {third, 0, 0}, {1 + third, 0, 0}, {1 + third, 1, third}, {third, 1, third}};
  const Nef3 facet = Nef3::facet(std::span<const RationalPoint3>(corners));
  EXPECT_EQ(facet.counts().facets, 1U);
  EXPECT_TRUE(facet.contains(RationalPoint3{1, Rational(1) / 2, third / 2}));
  EXPECT_FALSE(facet.contains(RationalPoint3{1, Rational(1) / 2, third}));
  std::vector<RationalPoint3> bent = corners;
  bent[3].z = 0;
  EXPECT_THROW(Nef3::facet(std::span<const RationalPoint3>(bent)), Error);
}

}  // namespace
}  // namespace plumb::testing::mesh_arrangement_test
