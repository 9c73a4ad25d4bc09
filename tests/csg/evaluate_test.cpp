// Trees against the oracle of unit cells: solids that are unions of cells of a grid are sets of
// bits, and maps permute axes and shift.
#include "plumb/csg/evaluate.h"

#include <gtest/gtest.h>

#include <array>
#include <bitset>
#include <cmath>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "plumb/convex/minkowski.h"
#include "plumb/model/hull.h"
#include "plumb/predicates/error.h"
#include "plumb/space/canonical.h"
#include "tree_builder.h"

namespace plumb::testing::csg_evaluate_test {
namespace {

constexpr int kSide = 5;
using Cells = std::bitset<kSide * kSide * kSide>;

std::size_t cell(int x, int y, int z) {
  return static_cast<std::size_t>((x * kSide + y) * kSide + z);
}

/// A random tree with the cells that it should have; no cells where it is nothing at all.
class RandomTree {
 public:
  explicit RandomTree(std::uint32_t seed) : random_(seed) {}

  std::optional<Cells> add(int depth) {
    const int choice = depth == 0 ? 0 : at_most(7);
    if (choice < 2) return add_box();
    if (choice == 7) return add_turned(depth);
    static constexpr std::array kKinds{CsgKind::Union, CsgKind::Group, CsgKind::Difference,
                                       CsgKind::Intersection, CsgKind::Difference};
    return add_boolean(kKinds[static_cast<std::size_t>(choice - 2)], depth);
  }
  CsgTree take() { return builder_.take(); }

 private:
  int at_most(int most) { return static_cast<int>(random_() % static_cast<unsigned>(most + 1)); }

  std::optional<Cells> add_box() {
    std::array<int, 3> low{}, high{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      low[axis] = at_most(kSide - 1);
      high[axis] = low[axis] + 1 + at_most(kSide - 1 - low[axis]);
    }
    builder_.shift(low[0], low[1], low[2]);
    builder_.cube(high[0] - low[0], high[1] - low[1], high[2] - low[2]);
    builder_.close();
    Cells cells;
    for (int x = low[0]; x < high[0]; ++x) {
      for (int y = low[1]; y < high[1]; ++y) {
        for (int z = low[2]; z < high[2]; ++z) cells.set(cell(x, y, z));
      }
    }
    return cells;
  }

  /// Adds a map that exchanges x and y and reverses z.
  std::optional<Cells> add_turned(int depth) {
    builder_.open(CsgKind::Multmatrix, {0, 1, 0, 0, 1, 0, 0, 0, 0, 0, -1, kSide});
    const std::optional<Cells> inner = add(depth - 1);
    builder_.close();
    if (!inner) return {};
    Cells cells;
    for (int x = 0; x < kSide; ++x) {
      for (int y = 0; y < kSide; ++y) {
        for (int z = 0; z < kSide; ++z) {
          cells[cell(y, x, kSide - 1 - z)] = (*inner)[cell(x, y, z)];
        }
      }
    }
    return cells;
  }

  std::optional<Cells> add_boolean(CsgKind kind, int depth) {
    builder_.open(kind);
    const int children = at_most(4);
    std::optional<Cells> value;
    bool is_empty = false;
    bool has_any = false;
    for (int i = 0; i < children; ++i) {
      const std::optional<Cells> child = add(depth - 1);
      has_any = has_any || child;
      const bool is_first = i == 0;
      if (!child) {
        is_empty =
            is_empty || kind == CsgKind::Intersection || (kind == CsgKind::Difference && is_first);
      } else if (!value) {
        value = *child;
      } else if (kind == CsgKind::Difference) {
        *value &= ~*child;
      } else if (kind == CsgKind::Intersection) {
        *value &= *child;
      } else {
        *value |= *child;
      }
    }
    builder_.close();
    if (!has_any) return {};
    return is_empty ? Cells() : value;
  }

  std::mt19937 random_;
  TreeBuilder builder_;
};

void expect_cells(const Nef3& solid, const Cells& cells) {
  ASSERT_EQ(solid.volume(), Rational(static_cast<std::int64_t>(cells.count())));
  for (int x = 0; x < kSide; ++x) {
    for (int y = 0; y < kSide; ++y) {
      for (int z = 0; z < kSide; ++z) {
        const bool is_in = solid.contains(Point3{x + 0.5, y + 0.5, z + 0.5});
        ASSERT_EQ(is_in, cells[cell(x, y, z)]) << x << ' ' << y << ' ' << z;
      }
    }
  }
}

TEST(CsgEvaluate, RandomTreesAreTheirCells) {
  for (std::uint32_t seed = 0; seed < 200; ++seed) {
    SCOPED_TRACE(seed);
    RandomTree random(seed);
    const Cells cells = random.add(4).value_or(Cells());
    const CsgResult result = evaluate(random.take());
    ASSERT_NO_FATAL_FAILURE(expect_cells(result.solid, cells));
    EXPECT_EQ(result.solid, result.solid.regularization());
    EXPECT_EQ(result.solid.audit(), std::nullopt);
  }
}

TEST(CsgEvaluate, EqualSubtreesAreEvaluatedOnce) {
  TreeBuilder builder;
  for (int i = 0; i < 3; ++i) {
    builder.shift(10 * i, 0, 0);
    builder.open(CsgKind::Difference);
    builder.cube(3, 3, 3);
    builder.cube(1, 1, 1);
    builder.close();
    builder.close();
  }
  const CsgTree tree = builder.take();
  const CsgResult result = evaluate(tree);
  EXPECT_EQ(result.solid.volume(), Rational(78));
  int computed = 0, shared = 0;
  for (std::uint32_t i = 0; i < tree.nodes.size(); ++i) {
    if (tree.nodes[i].kind != CsgKind::Difference) continue;
    computed += result.nodes[i].work == CsgWork::Computed ? 1 : 0;
    shared += result.nodes[i].work == CsgWork::Shared ? 1 : 0;
  }
  EXPECT_EQ(computed, 1);
  EXPECT_EQ(shared, 2);
}

TEST(CsgEvaluate, MapsAreExact) {
  // A third is no double, so the image of 3 is not 1, and not any double.
  TreeBuilder builder;
  builder.open(CsgKind::Multmatrix, {1. / 3, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0});
  builder.open(CsgKind::Multmatrix, {0.1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0});
  builder.cube(3, 1, 1);
  builder.close();
  builder.close();
  const Rational expected = Rational(1. / 3) * Rational(0.1) * Rational(3);
  EXPECT_EQ(evaluate(builder.take()).solid.volume(), expected);
}

TEST(CsgEvaluate, SingularMapsGiveNothingWithANote) {
  TreeBuilder builder;
  builder.open(CsgKind::Multmatrix, {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0});
  builder.cube(1, 1, 1);
  builder.close();
  const CsgResult result = evaluate(builder.take());
  EXPECT_TRUE(result.solid.is_empty());
  ASSERT_EQ(result.notes.size(), 1U);
  EXPECT_EQ(result.notes[0], "1:1: multmatrix: the matrix is singular, so it gives nothing");
}

TEST(CsgEvaluate, ShapesAmongSolidsAreLeftOut) {
  TreeBuilder builder;
  builder.open(CsgKind::Union);
  builder.cube(1, 1, 1);
  builder.leaf(CsgKind::Square, {2, 2, 0});
  builder.leaf(CsgKind::Square, {3, 3, 0});
  builder.close();
  const CsgResult result = evaluate(builder.take());
  EXPECT_EQ(result.dimension, CsgDimension::Space);
  EXPECT_EQ(result.solid.volume(), Rational(1));
  ASSERT_EQ(result.notes.size(), 1U);
  EXPECT_NE(result.notes[0].find("(and 1 more)"), std::string::npos) << result.notes[0];
}

TEST(CsgEvaluate, HullsTakeThePartsOfUnions) {
  TreeBuilder builder;
  builder.open(CsgKind::Hull);
  builder.open(CsgKind::Group);
  builder.cube(1, 1, 1);
  builder.shift(3, 0, 0);
  builder.open(CsgKind::Difference);  // Stays a difference below the union.
  builder.cube(2, 1, 1);
  builder.shift(1, 0, 0);
  builder.cube(2, 2, 2);
  builder.close();
  builder.close();
  builder.close();
  builder.close();
  builder.close();
  const CsgTree tree = builder.take();
  const CsgResult result = evaluate(tree);
  EXPECT_EQ(result.solid.volume(), Rational(4));
  EXPECT_TRUE(result.solid.is_convex());
}

TEST(CsgEvaluate, SumsHavePlaneAndSpace) {
  TreeBuilder solid;
  solid.open(CsgKind::Minkowski);
  solid.cube(2, 1, 1);
  solid.cube(1, 1, 3);
  solid.close();
  EXPECT_EQ(evaluate(solid.take()).solid.volume(), Rational(3 * 2 * 4));
  TreeBuilder shape;
  shape.open(CsgKind::Minkowski);
  shape.leaf(CsgKind::Square, {2, 1, 0});
  shape.leaf(CsgKind::Square, {1, 4, 0});
  shape.close();
  const CsgResult result = evaluate(shape.take());
  EXPECT_EQ(result.dimension, CsgDimension::Plane);
  EXPECT_EQ(result.shape.area(), Rational(3 * 5));
}

TEST(CsgEvaluate, SumsOfManySetsDoNotDependOnTheirOrder) {
  // An L, a cube, and a tetrahedron.
  const auto sum_of = [](const std::vector<int>& order) {
    TreeBuilder builder;
    builder.open(CsgKind::Minkowski);
    for (const int part : order) {
      if (part == 0) {
        builder.open(CsgKind::Difference);
        builder.cube(3, 3, 1);
        builder.cube(2, 2, 1);
        builder.close();
      } else if (part == 1) {
        builder.cube(1, 1, 0.5);
      } else {
        builder.leaf(CsgKind::Polyhedron, {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1},
                     {4, 3, 3, 3, 3, 0, 1, 2, 0, 3, 1, 1, 3, 2, 2, 3, 0});
      }
    }
    builder.close();
    return evaluate(builder.take()).solid;
  };
  const Nef3 expected = sum_of({0, 1, 2});
  EXPECT_FALSE(expected.is_convex());
  for (const std::vector<int>& order :
       {std::vector{0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}}) {
    EXPECT_EQ(sum_of(order), expected);
  }
  EXPECT_EQ(sum_of({1, 2}), minkowski_sum(sum_of({1}), sum_of({2})));
}

TEST(CsgEvaluate, AHullOfHullsIsOneHull) {
  TreeBuilder builder;
  constexpr int kDepth = 100'000;
  for (int i = 0; i < kDepth; ++i) builder.open(CsgKind::Hull);
  builder.cube(1, 1, 1);
  builder.shift(0, 0, 4);
  builder.cube(1, 1, 1);
  for (int i = 0; i <= kDepth; ++i) builder.close();
  const CsgResult result = evaluate(builder.take());
  EXPECT_EQ(result.solid.volume(), Rational(5));
  EXPECT_EQ(result.nodes[1].work, CsgWork::Computed);
  EXPECT_EQ(result.nodes[2].work, CsgWork::Rewritten);
}

TEST(CsgEvaluate, ResizeKeepsAxesOfSizeZero) {
  const auto volume = [](const std::vector<double>& numbers) {
    TreeBuilder builder;
    builder.open(CsgKind::Resize, numbers);
    builder.cube(2, 3, 4);
    builder.close();
    return evaluate(builder.take()).solid.volume();
  };
  EXPECT_EQ(volume({6, 0, 0, 0, 0, 0}), Rational(6 * 3 * 4));
  EXPECT_EQ(volume({6, 0, 0, 0, 1, 0}), Rational(6 * 9 * 4));
  EXPECT_EQ(volume({6, 1, 0, 1, 1, 1}), Rational(6 * 1 * 12));
}

TEST(CsgEvaluate, OffsetsExtrusionsAndProjectionsFollowEachOther) {
  TreeBuilder builder;
  builder.open(CsgKind::LinearExtrude, {2, 0, 0, 0, 1, 1, 0, 12, 2});
  builder.open(CsgKind::Projection, {0});
  builder.open(CsgKind::LinearExtrude, {5, 1, 0, 0, 1, 1, 0, 12, 2});
  builder.open(CsgKind::Offset, {1, 1, 0, 12, 2});
  builder.leaf(CsgKind::Square, {2, 3, 0});
  for (int i = 0; i < 4; ++i) builder.close();
  EXPECT_EQ(evaluate(builder.take()).solid.volume(), Rational(4 * 5 * 2));
}

TEST(CsgEvaluate, PolygonsAreInsideOddNumbersOfPaths) {
  TreeBuilder builder;
  builder.leaf(CsgKind::Polygon, {0, 0, 4, 0, 4, 4, 0, 4, 1, 1, 3, 1, 3, 3, 1, 3},
               {2, 4, 4, 0, 1, 2, 3, 4, 5, 6, 7});
  EXPECT_EQ(evaluate(builder.take()).shape.area(), Rational(12));
}

TEST(CsgEvaluate, ErrorsHaveThePlaceOfTheNode) {
  TreeBuilder builder;
  builder.open(CsgKind::Union);
  builder.leaf(CsgKind::Polyhedron, {0, 0, 0, 1, 0, 0, 0, 1, 0}, {1, 3, 0, 1, 2});
  builder.close();
  const CsgTree tree = builder.take();
  try {
    static_cast<void>(evaluate(tree));
    FAIL() << "an open mesh is no solid";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::BadShape);
    EXPECT_EQ(error.place().line, 2U);
    EXPECT_EQ(error.message().find("polyhedron: "), 0U) << error.message();
  }
}

TEST(CsgEvaluate, ProgressNamesNodes) {
  TreeBuilder builder;
  builder.open(CsgKind::Hull);
  builder.cube(1, 1, 1);
  builder.close();
  const CsgTree tree = builder.take();
  std::vector<std::string> phases;
  Context context({}, {}, [&](std::string_view phase, std::uint64_t, std::uint64_t) {
    phases.emplace_back(phase);
  });
  static_cast<void>(evaluate(tree, context));
  EXPECT_NE(std::find(phases.begin(), phases.end(), "hull at line 1"), phases.end());
}

TEST(CsgEvaluate, AnEmptyTreeIsNothing) {
  const CsgResult result = evaluate(CsgTree());
  EXPECT_EQ(result.dimension, CsgDimension::Nothing);
  EXPECT_TRUE(result.solid.is_empty());
  EXPECT_TRUE(result.shape.is_empty());
}

TEST(CsgEvaluate, DepthHasNoLimit) {
  TreeBuilder builder;
  for (int i = 0; i < 200000; ++i) {
    builder.open(i % 3 == 0   ? CsgKind::Multmatrix
                 : i % 3 == 1 ? CsgKind::Group
                              : CsgKind::Union,
                 i % 3 == 0 ? std::vector<double>{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 1}
                            : std::vector<double>());
  }
  builder.cube(1, 1, 1);
  for (int i = 0; i < 200000; ++i) builder.close();
  const CsgResult result = evaluate(builder.take());
  EXPECT_TRUE(result.solid.contains(Point3{0.5, 0.5, 66667.5}));
}

}  // namespace
}  // namespace plumb::testing::csg_evaluate_test
