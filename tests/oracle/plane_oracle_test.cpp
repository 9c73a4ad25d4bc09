// The twin of the plane's sets on cases a person can check, and by laws it was not built on.
#include <gtest/gtest.h>

#include "oracle/plane_graph.h"
#include "plumb/testing/dice.h"

namespace plumb::testing::plane_oracle_test {
namespace {

CellLine line(int a, int b, int c) { return {a, b, c}; }

std::size_t count(const LineCells& cells, int dimension) {
  std::size_t n = 0;
  for (std::size_t c = 0; c < cells.size(); ++c) n += cells[c].dimension == dimension ? 1 : 0;
  return n;
}

LineCells random_cells(std::uint64_t seed) {
  Dice dice(seed);
  std::vector<CellLine> lines;
  for (std::int64_t i = dice.between(0, 9); i > 0; --i) {
    const ExactPoint p{dice.between(0, 4), dice.between(0, 4)};
    const ExactPoint q{dice.between(0, 4), dice.between(0, 4)};
    if (!(p == q)) lines.push_back(line_through(p, q));
  }
  return LineCells(std::move(lines));
}

TEST(LineCells, OfNoLineIsThePlane) {
  const LineCells cells({});
  ASSERT_EQ(cells.size(), 1U);
  EXPECT_TRUE(cells[0].unbounded);
}

TEST(LineCells, OfATriangle) {
  const LineCells cells({line(1, 0, 0), line(0, 1, 0), line(1, 1, -1), line(-2, -2, 2)});
  EXPECT_EQ(count(cells, 0), 3U);
  EXPECT_EQ(count(cells, 1), 9U);
  EXPECT_EQ(count(cells, 2), 7U);
  for (std::size_t c = 0; c < cells.size(); ++c) {
    if (cells[c].dimension == 2 && !cells[c].unbounded) {
      EXPECT_EQ(cells[c].area, BigRational(1, 2));
    }
  }
}

// Every cell of n lines: V - E + F = 1, and each vertex of degree m adds m - 1 faces to n + 1.
TEST(LineCells, AreAllThere) {
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    SCOPED_TRACE(seed);
    const LineCells cells = random_cells(seed);
    std::size_t faces = cells.lines().size() + 1;
    for (std::size_t c = 0; c < cells.size(); ++c) {
      EXPECT_EQ(cells.cell_of(cells[c].sample), c);
      if (cells[c].dimension == 1) {
        EXPECT_EQ(cells[c].around.size(), 2U);
      }
      if (cells[c].dimension == 0) faces += cells[c].around.size() / 4 - 1;
    }
    EXPECT_EQ(count(cells, 2), faces);
    EXPECT_EQ(count(cells, 0) + count(cells, 2), count(cells, 1) + 1);
    EXPECT_EQ(cells[cells.bottom()].dimension, 2);
  }
}

// ---------------------------------------------------------------- sets

struct Judged {
  LineCells cells;
  CellMarks marks;
  bool contains(int x, int y) const { return marks[cells.cell_of(cell_point({x, y}))]; }
};

Judged judge(const PlaneSetPointer& set, std::vector<CellLine> lines = {}) {
  add_lines(*set, lines);
  LineCells cells(std::move(lines));
  CellMarks marks = marks_of(*set, cells);
  return {std::move(cells), std::move(marks)};
}

Chain square(int low, int high) { return {{low, low}, {high, low}, {high, high}, {low, high}}; }

TEST(PlaneSet, ASquareOpenAndClosed) {
  const Judged closed =
      judge(set_of(SetPolygons{{square(0, 4)}, WindingRule::NonZero, Boundary::Closed}));
  EXPECT_TRUE(closed.contains(2, 2) && closed.contains(0, 0) && closed.contains(4, 2));
  EXPECT_FALSE(closed.contains(5, 2) || closed.contains(-1, 0));
  const Judged open =
      judge(set_of(SetPolygons{{square(0, 4)}, WindingRule::NonZero, Boundary::Open}));
  EXPECT_TRUE(open.contains(2, 2));
  EXPECT_FALSE(open.contains(0, 0) || open.contains(4, 2) || open.contains(5, 2));
  EXPECT_EQ(open.marks, interior_of(open.cells, closed.marks));
  EXPECT_EQ(area_of(closed.cells, closed.marks), BigRational(16));
  EXPECT_EQ(area_of(open.cells, open.marks), BigRational(16));
}

TEST(PlaneSet, WindingRulesTellNestedSquares) {
  const auto area = [](WindingRule rule) {
    const Judged set =
        judge(set_of(SetPolygons{{square(0, 4), square(1, 3)}, rule, Boundary::Open}));
    return area_of(set.cells, set.marks);
  };
  EXPECT_EQ(area(WindingRule::NonZero), BigRational(16));
  EXPECT_EQ(area(WindingRule::Positive), BigRational(16));
  EXPECT_EQ(area(WindingRule::EvenOdd), BigRational(12));
}

TEST(PlaneSet, FlatChainsAreWhatLiesOnThem) {
  const Judged two =
      judge(set_of(SetPolygons{{{{0, 0}, {2, 2}}}, WindingRule::Positive, Boundary::Closed}));
  EXPECT_TRUE(two.contains(0, 0) && two.contains(1, 1));
  EXPECT_FALSE(two.contains(3, 3) || two.contains(1, 0));
  const Judged one = judge(set_of(SetPolygons{{{{1, 1}}}, WindingRule::NonZero, Boundary::Closed}));
  EXPECT_TRUE(one.contains(1, 1));
  EXPECT_FALSE(one.contains(1, 0));
}

// The minimal complex of a set does not depend on lines that have nothing to do with it.
TEST(PlaneGraph, ForgetsLinesThatBoundNothing) {
  const auto set = set_of(SetPolygons{{square(0, 4)}, WindingRule::NonZero, Boundary::Closed});
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    const Judged judged = judge(set, random_cells(seed).lines());
    const PlaneGraph graph = minimal_graph(judged.cells, judged.marks);
    EXPECT_EQ(graph.vertices.size(), 4U);
    EXPECT_EQ(graph.edges.size(), 4U);
    ASSERT_EQ(graph.faces.size(), 2U);
    EXPECT_EQ(area_of(judged.cells, judged.marks), BigRational(16));
  }
}

TEST(PlaneGraph, OfARayHasOneVertexAndOneFace) {
  const Judged judged = judge(set_of(SetRay{{0, 0}, {1, 3}, Boundary::Open}), {line(1, 2, 3)});
  const PlaneGraph graph = minimal_graph(judged.cells, judged.marks);
  ASSERT_EQ(graph.vertices.size(), 1U);
  EXPECT_FALSE(graph.vertices[0].mark);
  ASSERT_EQ(graph.edges.size(), 1U);
  EXPECT_EQ(graph.edges[0].from, 0U);
  EXPECT_EQ(graph.edges[0].to, PlaneGraph::kNone);
  EXPECT_EQ(graph.faces.size(), 1U);
}

// Euler on connected random arrangements of segments of a square's sides and chords.
TEST(PlaneGraph, ArrangementsObeyEuler) {
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    Dice dice(seed);
    CurveScene scene;
    const Chain outline = square(0, 4);
    for (std::size_t i = 0; i < 4; ++i) {
      scene.curves.push_back({outline[i], outline[(i + 1) % 4], outline[i], outline[(i + 1) % 4]});
    }
    for (int i = 0; i < 3; ++i) {
      const ExactPoint p{0, dice.between(0, 4)};
      const ExactPoint q{4, dice.between(0, 4)};
      scene.curves.push_back({p, q, p, q});
    }
    const LineCells cells(lines_of(scene));
    const PlaneGraph graph = arrangement_graph(cells, scene);
    EXPECT_EQ(graph.vertices.size() + graph.faces.size(), graph.edges.size() + 2);
  }
}

}  // namespace
}  // namespace plumb::testing::plane_oracle_test
