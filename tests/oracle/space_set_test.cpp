// The twin of the sets of space on cases a person can check, and by laws it was not built on.
#include <gtest/gtest.h>

#include <algorithm>

#include "generate/space_program.h"
#include "generate/space_solids.h"
#include "oracle/space_graph.h"

namespace plumb::testing::space_set_test {
namespace {

CellPlane plane(int a, int b, int c, int d) { return plane_of(a, b, c, d); }

std::size_t count(const SpaceCells& cells, int dimension) {
  std::size_t n = 0;
  for (std::size_t c = 0; c < cells.size(); ++c) n += cells[c].dimension == dimension ? 1 : 0;
  return n;
}

// ---------------------------------------------------------------- cells

TEST(SpaceCells, OfFewPlanes) {
  struct Row {
    const char* name;
    std::vector<CellPlane> planes;
    std::array<std::size_t, 4> counts;  // vertices, edges, facets, volumes
  };
  const Row rows[] = {
      {"none", {}, {0, 0, 0, 1}},
      {"one, twice", {plane(1, 2, 3, 4), plane(-2, -4, -6, -8)}, {0, 0, 1, 2}},
      {"parallel", {plane(1, 0, 0, 0), plane(1, 0, 0, -1)}, {0, 0, 2, 3}},
      {"a cross", {plane(1, 0, 0, 0), plane(0, 1, 0, 0)}, {0, 1, 4, 4}},
      {"a prism", {plane(1, 0, 0, 0), plane(0, 1, 0, 0), plane(1, 1, 0, -1)}, {0, 3, 9, 7}},
      {"a book", {plane(1, 0, 0, 0), plane(0, 1, 0, 0), plane(1, 1, 0, 0)}, {0, 1, 6, 6}},
      {"octants", {plane(1, 0, 0, 0), plane(0, 1, 0, 0), plane(0, 0, 1, 0)}, {1, 6, 12, 8}},
      {"tetrahedron",
       {plane(1, 0, 0, 0), plane(0, 1, 0, 0), plane(0, 0, 1, 0), plane(1, 1, 1, -1)},
       {4, 18, 28, 15}},
  };
  for (const Row& row : rows) {
    SCOPED_TRACE(row.name);
    const SpaceCells cells(row.planes);
    for (int d = 0; d < 4; ++d) {
      EXPECT_EQ(count(cells, d), row.counts[static_cast<std::size_t>(d)]) << "dimension " << d;
    }
  }
}

SpaceCells random_cells(std::uint64_t seed) {
  Dice dice(seed);
  std::vector<CellPlane> planes;
  for (std::int64_t i = dice.between(0, 7); i > 0; --i) {
    const auto number = [&] { return BigRational(dice.between(-2, 2)); };
    const ExactPoint3 n{number(), number(), number()};
    if (!(n == ExactPoint3{})) planes.push_back(plane_of(n.x, n.y, n.z, number()));
  }
  return SpaceCells(std::move(planes));
}

// With e_k cells of dimension k, e_0 - e_1 + e_2 - e_3 = -1.
TEST(SpaceCells, AreAllThere) {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    SCOPED_TRACE(seed);
    const SpaceCells cells = random_cells(seed);
    EXPECT_EQ(count(cells, 0) + count(cells, 2) + 1, count(cells, 1) + count(cells, 3));
    for (std::size_t c = 0; c < cells.size(); ++c) EXPECT_EQ(cells.cell_of(cells[c].sample), c);
  }
}

// c lies in the closure of d exactly when every sign of c is that of d or zero.
TEST(SpaceCells, AreLinkedAsTheirSignsSay) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    SCOPED_TRACE(seed);
    const SpaceCells cells = random_cells(seed);
    for (std::size_t c = 0; c < cells.size(); ++c) {
      std::vector<std::size_t> around = cells[c].around;
      std::sort(around.begin(), around.end());
      std::vector<std::size_t> expected;
      for (std::size_t d = 0; d < cells.size(); ++d) {
        const auto &s = cells[c].signs, &t = cells[d].signs;
        if (c != d && (s.positive & ~t.positive) == 0 && (s.negative & ~t.negative) == 0) {
          expected.push_back(d);
        }
      }
      EXPECT_EQ(around, expected);
    }
  }
}

// ---------------------------------------------------------------- sets

struct Judged {
  explicit Judged(const SpaceSetPointer& set, std::vector<CellPlane> planes = {})
      : cells([&] {
          add_planes(*set, planes);
          return SpaceCells(planes);
        }()),
        marks(marks_of(*set, cells)),
        graph(minimal_graph(cells, marks)) {}

  bool contains(const ExactPoint3& p) const { return marks[cells.cell_of(p)]; }

  SpaceCells cells;
  CellMarks marks;
  SpaceGraph graph;
};

using Counts = std::array<std::size_t, 4>;

Counts counts(const SpaceGraph& g) {
  return {g.vertices.size(), g.edges.size(), g.facets.size(), g.volumes.size()};
}
Counts marked(const SpaceGraph& g) {
  const auto number = [](const auto& items) {
    return static_cast<std::size_t>(
        std::count_if(items.begin(), items.end(), [](const auto& item) { return item.mark; }));
  };
  return {number(g.vertices), number(g.edges), number(g.facets), number(g.volumes)};
}

SpaceSetPointer operator+(SpaceSetPointer a, SpaceSetPointer b) {
  return apply(SetOperator::Union, std::move(a), std::move(b));
}
SpaceSetPointer operator*(SpaceSetPointer a, SpaceSetPointer b) {
  return apply(SetOperator::Intersection, std::move(a), std::move(b));
}
SpaceSetPointer operator-(SpaceSetPointer a, SpaceSetPointer b) {
  return apply(SetOperator::Difference, std::move(a), std::move(b));
}
SpaceSetPointer operator!(SpaceSetPointer a) {
  return apply(SetOperator::Complement, std::move(a));
}
SpaceSetPointer solid(const MeshLeaf& mesh) { return space_set(mesh); }
SpaceSetPointer point(const ExactPoint3& p) { return space_set(PointsLeaf{{p}}); }
SpaceSetPointer chain(const Chain3& points) { return space_set(ChainsLeaf{{points}}); }
SpaceSetPointer plane_set(int a, int b, int c, int d) {
  return space_set(PlaneLeaf{plane(a, b, c, d)});
}

MeshLeaf cube_mesh() { return box({0, 0, 0}, {2, 2, 2}); }

struct KnownSet {
  const char* name;
  SpaceSetPointer set;
  Counts all;
  Counts marked;
  std::optional<BigRational> volume;
};

std::vector<KnownSet> known_sets() {
  const SpaceSetPointer cube = solid(cube_mesh());
  const SpaceSetPointer flap = space_set(rectangle({2, 0, 0}, {4, 2, 0}, 2, 1));
  const SpaceSetPointer lower = half_space(0, 0, 1, 0);
  return {
      {"empty", empty_space(), {0, 0, 0, 1}, {0, 0, 0, 0}, 0},
      {"all", !empty_space(), {0, 0, 0, 1}, {0, 0, 0, 1}, {}},
      {"half-space", lower, {0, 0, 1, 2}, {0, 0, 1, 1}, {}},
      {"open half-space", half_space(0, 0, 1, 0, false), {0, 0, 1, 2}, {0, 0, 0, 1}, {}},
      {"plane", lower * half_space(0, 0, -1, 0), {0, 0, 1, 2}, {0, 0, 1, 0}, 0},
      {"wedge", half_space(1, 0, 0, 1) * half_space(0, 0, 1, 1), {0, 1, 2, 2}, {0, 1, 2, 1}, {}},
      {"slab", lower - half_space(0, 0, 1, 2), {0, 0, 2, 3}, {0, 0, 1, 1}, {}},
      {"line", plane_set(1, -1, 0, 0) * plane_set(0, 0, 1, 0), {0, 1, 0, 1}, {0, 1, 0, 0}, 0},
      {"line less a point",
       plane_set(1, -1, 0, 0) * plane_set(0, 0, 1, 0) - point({1, 1, 0}),
       {1, 2, 0, 1},
       {0, 2, 0, 0},
       0},
      {"plane less a point",
       plane_set(0, 0, 1, 0) - point({1, 1, 0}),
       {1, 0, 1, 2},
       {0, 0, 1, 0},
       0},
      {"three planes",
       plane_set(1, 0, 0, 0) + plane_set(0, 1, 0, 0) + plane_set(0, 0, 1, 0),
       {1, 6, 12, 8},
       {1, 6, 12, 0},
       0},
      {"octant",
       half_space(1, 0, 0, 0) * half_space(0, 1, 0, 0) * lower,
       {1, 3, 3, 2},
       {1, 3, 3, 1},
       {}},
      {"cube", cube, {8, 12, 6, 2}, {8, 12, 6, 1}, 8},
      {"all but a cube", !cube, {8, 12, 6, 2}, {0, 0, 0, 1}, {}},
      {"cube less inner point", cube - point({1, 1, 1}), {9, 12, 6, 2}, {8, 12, 6, 1}, 8},
      {"cube less point on a face", cube - point({1, 1, 2}), {9, 12, 6, 2}, {8, 12, 6, 1}, 8},
      {"cube less point on an edge", cube - point({1, 0, 0}), {9, 13, 6, 2}, {8, 13, 6, 1}, 8},
      {"cube less corner", cube - point({0, 0, 0}), {8, 12, 6, 2}, {7, 12, 6, 1}, 8},
      {"cube less a slice", cube - plane_set(0, 0, 1, -1), {12, 20, 11, 3}, {8, 16, 10, 2}, 8},
      {"cube with antenna",
       cube + chain({{1, 1, 2}, {1, 1, 3}}),
       {10, 13, 6, 2},
       {10, 13, 6, 1},
       8},
      {"cube with slanted antenna",
       cube + chain({{1, 1, 0}, {0, 1, 3}}),
       {10, 13, 6, 2},
       {10, 13, 6, 1},
       8},
      {"cube with flap", cube + flap, {12, 18, 8, 2}, {12, 18, 8, 1}, 8},
      {"flap", flap, {4, 4, 1, 1}, {4, 4, 1, 0}, 0},
      {"triangle in the air",
       space_set(PolygonLeaf{{{0, 0, 0}, {3, 1, 0}, {1, 2, 4}}}),
       {3, 3, 1, 1},
       {3, 3, 1, 0},
       0},
      {"cubes at a vertex",
       cube + solid(moved(cube_mesh(), {2, 2, 2})),
       {15, 24, 12, 3},
       {15, 24, 12, 2},
       16},
      {"cubes at an edge",
       cube + solid(moved(cube_mesh(), {2, 2, 0})),
       {14, 23, 12, 3},
       {14, 23, 12, 2},
       16},
      {"cubes at a facet",
       cube + solid(moved(cube_mesh(), {2, 0, 0})),
       {8, 12, 6, 2},
       {8, 12, 6, 1},
       16},
      {"cubes at part of a facet",
       cube + solid(moved(cube_mesh(), {2, 1, 1})),
       {18, 28, 12, 2},
       {18, 28, 12, 1},
       16},
      {"cube in cube",
       solid(together(box({-1, -1, -1}, {4, 4, 4}), inside_out(cube_mesh()))),
       {16, 24, 12, 3},
       {16, 24, 12, 1},
       117},
      {"tetrahedron",
       solid(tetrahedron({0, 0, 0}, {0, 3, 0}, {3, 0, 0}, {0, 0, 3})),
       {4, 6, 4, 2},
       {4, 6, 4, 1},
       BigRational(9, 2)},
      {"prism",
       solid(prism({{0, 0, 0}, {0, 2, 0}, {2, 0, 0}}, 2, 0, 3)),
       {6, 9, 5, 2},
       {6, 9, 5, 1},
       6},
      {"boundary of a cube", apply(SetOperator::Boundary, cube), {8, 12, 6, 2}, {8, 12, 6, 0}, 0},
      {"regular part of a cube with flap",
       apply(SetOperator::Regularization, cube + flap),
       {8, 12, 6, 2},
       {8, 12, 6, 1},
       8},
  };
}

TEST(SpaceSet, KnownSets) {
  for (const KnownSet& row : known_sets()) {
    SCOPED_TRACE(row.name);
    const Judged judged(row.set);
    EXPECT_EQ(counts(judged.graph), row.all);
    EXPECT_EQ(marked(judged.graph), row.marked);
    EXPECT_EQ(volume_of(judged.cells, judged.marks), row.volume);
  }
}

TEST(SpaceSet, MeshesByTheirRule) {
  const MeshLeaf inner = box({0, 0, 0}, {1, 1, 1});
  struct Row {
    const char* name;
    MeshLeaf mesh;
    std::array<BigRational, 3> volume;  // nonzero, odd, positive
  };
  const Row rows[] = {
      {"cube", cube_mesh(), {8, 8, 8}},
      {"inside out", inside_out(cube_mesh()), {8, 8, 0}},
      {"twice", together(cube_mesh(), cube_mesh()), {8, 0, 8}},
      {"once and back", together(cube_mesh(), inside_out(cube_mesh())), {0, 0, 0}},
      {"nested", together(cube_mesh(), inner), {8, 7, 8}},
      {"a void", together(cube_mesh(), inside_out(inner)), {7, 7, 7}},
      {"crossing", together(cube_mesh(), moved(cube_mesh(), {1, 1, 1})), {15, 14, 15}},
  };
  for (Row row : rows) {
    SCOPED_TRACE(row.name);
    for (std::size_t r = 0; r < 3; ++r) {
      row.mesh.rule = static_cast<MeshRule>(r);
      const Judged judged(space_set(row.mesh));
      EXPECT_EQ(volume_of(judged.cells, judged.marks), row.volume[r]) << "rule " << r;
    }
  }
}

TEST(SpaceSet, PlacesOfVertices) {
  const Judged alone(point({1, 2, 3}) + solid(cube_mesh()));
  const Judged inside(plane_set(0, 0, 1, 0) + chain({{1, 1, 0}, {1, 2, 4}}));
  EXPECT_NE(alone.graph.vertices[4].volume, SpaceGraph::kNone);
  EXPECT_EQ(alone.graph.vertices[0].volume, SpaceGraph::kNone);
  ASSERT_EQ(inside.graph.vertices.size(), 2U);
  EXPECT_EQ(inside.graph.vertices[0].facet, 0U);
  EXPECT_EQ(inside.graph.vertices[1].facet, SpaceGraph::kNone);
  EXPECT_TRUE(inside.contains({1, {3, 2}, 2}));
}

// Planes that bound nothing change nothing.
TEST(SpaceSet, IsTheSameOnFinerCells) {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    Dice dice(seed);
    const auto set = space_set_of_program(random_space_program(dice, ProgramValues::Plain, 6), 9);
    SCOPED_TRACE(to_text(*set));
    const Judged plain(set);
    const ExactPoint3 n{dice.between(-1, 1), dice.between(-1, 1), 1};
    const Judged finer(set, {plane_at({1, 1, 1}, n), plane_at({2, 1, 0}, n)});
    EXPECT_EQ(counts(plain.graph), counts(finer.graph));
    EXPECT_EQ(marked(plain.graph), marked(finer.graph));
    EXPECT_EQ(volume_of(plain.cells, plain.marks), volume_of(finer.cells, finer.marks));
    for (std::size_t c = 0; c < finer.cells.size(); ++c) {
      const std::size_t coarse = plain.cells.cell_of(finer.cells[c].sample);
      EXPECT_EQ(finer.graph.element_of[c].dimension, plain.graph.element_of[coarse].dimension);
    }
  }
}

// Two programs and what is between them.
TEST(SpaceSet, HasVolumesThatAddUp) {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    Dice dice(seed);
    const auto any_solid = [&] {
      const auto any_point = [&] {
        return space_program_point(ProgramValues::Plain, static_cast<std::uint8_t>(dice.below(64)));
      };
      ExactPoint3 p = any_point();
      return dice.below(2) == 0
                 ? solid(box(p, p + ExactPoint3{1 + dice.below(3), 1 + dice.below(3), 1}))
                 : solid(tetrahedron(p, p + ExactPoint3{1, 0, 0}, p + ExactPoint3{0, 2, 0},
                                     p + ExactPoint3{dice.below(3), dice.below(3), 3}));
    };
    const SpaceSetPointer a = any_solid();
    const SpaceSetPointer b = any_solid();
    SCOPED_TRACE(to_text(*a) + to_text(*b));
    const SpaceCells cells = cells_of(*(a + b));
    const auto volume = [&](const SpaceSetPointer& s) {
      return *volume_of(cells, marks_of(*s, cells));
    };
    EXPECT_EQ(volume(a + b) + volume(a * b), volume(a) + volume(b));
    EXPECT_EQ(volume(a - b) + volume(a * b), volume(a));
  }
}

TEST(SpacePrograms, OfAnyBytesAreSets) {
  std::size_t with_solids = 0;
  std::size_t with_flat_parts = 0;
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    Dice dice(seed);
    const auto values = static_cast<ProgramValues>(seed % kProgramValues);
    const Judged judged(space_set_of_program(random_space_program(dice, values, 2 + seed % 7), 9));
    with_solids += judged.graph.volumes.size() > 1 ? 1 : 0;
    for (const auto& facet : judged.graph.facets) {
      with_flat_parts += facet.volume[0] == facet.volume[1] ? 1 : 0;
    }
  }
  EXPECT_GT(with_solids, 20U);
  EXPECT_GT(with_flat_parts, 5U);
}

}  // namespace
}  // namespace plumb::testing::space_set_test
