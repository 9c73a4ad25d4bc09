// Colours of trees against an oracle of unit squares: each square of the boundary of a result is a
// part of the boundary of some boxes of the tree, and has the colour of one of them.

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <random>
#include <set>
#include <string>
#include <vector>

#include "plumb/csg/evaluate.h"
#include "plumb/predicates/error.h"
#include "plumb/space/mesh_with_attributes.h"
#include "tree_builder.h"

namespace plumb::testing::csg_colors_test {
namespace {

constexpr int kSide = 5;
using Color = std::array<double, 4>;

/// A box of a grid, and the colour that it should have.
struct Box {
  std::array<int, 3> low{}, high{};
  std::optional<Color> color;
};

/// A unit square of the grid: the cell above it along an axis.
struct Square {
  std::array<int, 3> cell{};
  std::size_t axis = 0;
  bool faces_up = false;  // Whether the normal points along the axis.
};

bool holds(const Box& box, const std::array<int, 3>& cell) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (cell[axis] < box.low[axis] || cell[axis] >= box.high[axis]) return false;
  }
  return true;
}

/// Returns whether the square is on the boundary of a box: 0, or 1 with the same normal, or -1.
int side_of(const Box& box, const Square& square) {
  std::array<int, 3> below = square.cell;
  --below[square.axis];
  const bool is_above_in = holds(box, square.cell), is_below_in = holds(box, below);
  if (is_above_in == is_below_in) return 0;
  return is_below_in == square.faces_up ? 1 : -1;
}

/// Returns the unit square that contains the centroid of a triangle.
Square square_of(const PolygonMesh& mesh, std::size_t face) {
  std::array<Point3, 3> p;
  for (std::size_t i = 0; i < 3; ++i) p[i] = mesh.points[mesh.face(face)[i]];
  const std::array<double, 3> u{p[1].x - p[0].x, p[1].y - p[0].y, p[1].z - p[0].z};
  const std::array<double, 3> v{p[2].x - p[0].x, p[2].y - p[0].y, p[2].z - p[0].z};
  Square square;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double normal =
        u[(axis + 1) % 3] * v[(axis + 2) % 3] - u[(axis + 2) % 3] * v[(axis + 1) % 3];
    if (normal != 0) {
      square.axis = axis;
      square.faces_up = normal > 0;
    }
  }
  const std::array<double, 3> sum{p[0].x + p[1].x + p[2].x, p[0].y + p[1].y + p[2].y,
                                  p[0].z + p[1].z + p[2].z};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    square.cell[axis] = static_cast<int>(std::floor(sum[axis] / 3));
  }
  return square;
}

std::optional<Color> color_of_face(const MeshAttributes& attributes, std::size_t face) {
  if (attributes.face_material.empty()) return {};
  const std::uint32_t material = attributes.face_material[face];
  if (material == MeshAttributes::kNone) return {};
  return attributes.materials[material].color;
}

/// A random tree of boxes, with colours at random places.
class RandomColors {
 public:
  RandomColors(std::uint32_t seed, bool only_unions) : random_(seed), only_unions_(only_unions) {}

  void add(int depth, std::optional<Color> color) {
    const int choice = depth == 0 ? 0 : at_most(5);
    if (choice == 0) return add_box(color);
    if (choice == 1) {
      const std::optional<Color> own = some_color();
      builder.open(CsgKind::Color, numbers_of(own));
      add(depth - 1, color ? color : own);
      return builder.close();
    }
    static constexpr std::array kKinds{CsgKind::Union, CsgKind::Group, CsgKind::Difference,
                                       CsgKind::Intersection};
    const auto kind = kKinds[static_cast<std::size_t>(only_unions_ ? choice % 2 : choice - 2)];
    builder.open(kind);
    for (int i = at_most(3); i >= 0; --i) add(depth - 1, color);
    builder.close();
  }

  TreeBuilder builder;
  std::vector<Box> boxes;

 private:
  int at_most(int most) { return static_cast<int>(random_() % static_cast<unsigned>(most + 1)); }

  /// A colour that no other node has, or none.
  std::optional<Color> some_color() {
    if (at_most(3) == 0) return {};
    ++count_;
    return Color{count_ / 256., 0.5, 1, 1};
  }
  std::vector<double> numbers_of(const std::optional<Color>& color) {
    if (color) return {color->begin(), color->end()};
    if (at_most(1) == 0) return {};
    return {-1, -1, -1, 1};
  }

  void add_box(const std::optional<Color>& color) {
    Box box;
    std::array<double, 3> size{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      box.low[axis] = at_most(kSide - 1);
      box.high[axis] = box.low[axis] + 1 + at_most(kSide - 1 - box.low[axis]);
      size[axis] = box.high[axis] - box.low[axis];
    }
    // Each box has a colour of its own unless it is below another one.
    box.color = color ? color : some_color();
    if (!color) builder.open(CsgKind::Color, numbers_of(box.color));
    builder.shift(box.low[0], box.low[1], box.low[2]);
    builder.cube(size[0], size[1], size[2]);
    builder.close();
    if (!color) builder.close();
    boxes.push_back(box);
  }

  std::mt19937 random_;
  bool only_unions_;
  int count_ = 0;
};

TEST(CsgColors, FacesHaveTheColourOfABoxWhoseBoundaryTheyAre) {
  std::size_t colored = 0;
  for (std::uint32_t seed = 0; seed < 150; ++seed) {
    SCOPED_TRACE(seed);
    RandomColors random(seed, false);
    random.add(4, {});
    const CsgResult result = evaluate(random.builder.take());
    const MeshWithAttributes made = mesh_with_attributes(result.solid);
    for (std::size_t f = 0; f < made.mesh.face_count(); ++f) {
      const Square square = square_of(made.mesh, f);
      std::set<std::optional<Color>> possible;
      for (const Box& box : random.boxes) {
        if (side_of(box, square) != 0) possible.insert(box.color);
      }
      const auto color = color_of_face(made.attributes, f);
      ASSERT_TRUE(possible.contains(color)) << f;
      colored += color ? 1 : 0;
    }
  }
  EXPECT_GT(colored, 1000U);
}

TEST(CsgColors, TheFirstOfCoincidentBoxesOfAUnionWins) {
  std::size_t coincident = 0;
  for (std::uint32_t seed = 0; seed < 150; ++seed) {
    SCOPED_TRACE(seed);
    RandomColors random(seed, true);
    random.add(4, {});
    const CsgResult result = evaluate(random.builder.take());
    const MeshWithAttributes made = mesh_with_attributes(result.solid);
    for (std::size_t f = 0; f < made.mesh.face_count(); ++f) {
      const Square square = square_of(made.mesh, f);
      // A box without a colour has no source, so a box with one behind it shows.
      std::optional<Color> expected;
      int count = 0;
      for (const Box& box : random.boxes) {
        if (side_of(box, square) != 1) continue;
        ++count;
        if (!expected) expected = box.color;
      }
      ASSERT_EQ(color_of_face(made.attributes, f), expected) << f;
      coincident += count > 1 ? 1 : 0;
    }
  }
  EXPECT_GT(coincident, 100U);
}

TEST(CsgColors, ColoursChangeNoSet) {
  for (std::uint32_t seed = 0; seed < 100; ++seed) {
    RandomColors random(seed, false);
    random.add(4, {});
    const CsgTree tree = random.builder.take();
    const CsgResult plain = evaluate(tree, {.colors = false});
    EXPECT_EQ(evaluate(tree).solid, plain.solid) << seed;
    EXPECT_TRUE(plain.solid.sources().empty()) << seed;
  }
}

/// Returns the only colour of the faces of a solid.
std::optional<Color> only_color(const Nef3& solid) {
  const MeshWithAttributes made = mesh_with_attributes(solid);
  std::set<std::optional<Color>> colors;
  for (std::size_t f = 0; f < made.mesh.face_count(); ++f) {
    colors.insert(color_of_face(made.attributes, f));
  }
  EXPECT_EQ(colors.size(), 1U);
  return colors.empty() ? std::nullopt : *colors.begin();
}

constexpr Color kGreen{0, 1, 0, 1};
const std::vector<double> kRedNumbers{1, 0, 0, 1}, kGreenNumbers{0, 1, 0, 1};

/// Returns a tree: a green node with a maker of faces with a red cube and a red square.
CsgTree made_of_red(CsgKind kind, const std::vector<double>& numbers, bool is_green) {
  TreeBuilder builder;
  if (is_green) builder.open(CsgKind::Color, kGreenNumbers);
  builder.open(kind, numbers);
  builder.open(CsgKind::Color, kRedNumbers);
  const bool is_extrusion = kind == CsgKind::LinearExtrude || kind == CsgKind::RotateExtrude;
  if (is_extrusion) {
    builder.leaf(CsgKind::Square, {2, 2, 0});
  } else {
    builder.leaf(CsgKind::Sphere, {1, 8, 12, 2});
    builder.cube(3, 1, 1);
  }
  builder.close();
  builder.close();
  if (is_green) builder.close();
  return builder.take();
}

TEST(CsgColors, WhatMakesFacesHasTheColourAboveIt) {
  const std::vector<std::pair<CsgKind, std::vector<double>>> makers{
      {CsgKind::Hull, {}},
      {CsgKind::Minkowski, {}},
      {CsgKind::LinearExtrude, {3, 0, 30, 4, 1, 0.5, 8, 12, 2}},
      {CsgKind::RotateExtrude, {360, 8, 12, 2}}};
  for (const auto& [kind, numbers] : makers) {
    SCOPED_TRACE(std::string(name_of(kind)));
    const CsgResult green = evaluate(made_of_red(kind, numbers, true));
    EXPECT_EQ(only_color(green.solid), kGreen);
    EXPECT_TRUE(green.notes.empty());
    if (kind == CsgKind::Minkowski) continue;  // A sum of one set is this set.
    const CsgResult plain = evaluate(made_of_red(kind, numbers, false));
    EXPECT_EQ(only_color(plain.solid), std::nullopt);
    ASSERT_EQ(plain.notes.size(), 1U);
    EXPECT_NE(plain.notes[0].find("the colours of its children are left out"), std::string::npos);
  }
}

TEST(CsgColors, EqualPartsOfDifferentColoursAreNotTheSame) {
  TreeBuilder builder;
  for (int i = 0; i < 2; ++i) {
    builder.open(CsgKind::Color, {i / 2., 0, 7, 0.25});
    builder.shift(4 * i, 0, 0);
    builder.leaf(CsgKind::Sphere, {1, 6, 12, 2});
    builder.close();
    builder.close();
  }
  const MeshWithAttributes made = mesh_with_attributes(evaluate(builder.take()).solid);
  std::set<std::optional<Color>> left, right;
  for (std::size_t f = 0; f < made.mesh.face_count(); ++f) {
    const double x = made.mesh.points[made.mesh.face(f)[0]].x;
    (x < 2 ? left : right).insert(color_of_face(made.attributes, f));
  }
  EXPECT_EQ(left, (std::set<std::optional<Color>>{Color{0, 0, 1, 0.25}}));
  EXPECT_EQ(right, (std::set<std::optional<Color>>{Color{0.5, 0, 1, 0.25}}));
}

TEST(CsgColors, ColoursOfImportedFilesYieldToThoseOfTheTree) {
  MeshSource box;
  const Nef3 cube = [] {
    TreeBuilder builder;
    builder.cube(1, 1, 1);
    return evaluate(builder.take()).solid;
  }();
  box.mesh = cube.to_polygons().mesh;
  box.attributes.materials = {{"blue", Color{0, 0, 1, 1}, {}}};
  box.attributes.face_material.assign(box.mesh.face_count(), 0);
  box.attributes.face_id.assign(box.mesh.face_count(), 7);
  const Nef3 blue = from_source(std::make_shared<const MeshSource>(box));
  for (const bool is_green : {false, true}) {
    TreeBuilder builder;
    if (is_green) builder.open(CsgKind::Color, kGreenNumbers);
    builder.shift(1, 2, 3);
    builder.leaf(CsgKind::Solid, {}, {0});
    builder.close();
    if (is_green) builder.close();
    CsgTree tree = builder.take();
    tree.solids.push_back(blue);
    const MeshWithAttributes made = mesh_with_attributes(evaluate(tree).solid);
    const Color expected = is_green ? kGreen : Color{0, 0, 1, 1};
    for (std::size_t f = 0; f < made.mesh.face_count(); ++f) {
      EXPECT_EQ(color_of_face(made.attributes, f), expected);
    }
    EXPECT_EQ(made.attributes.face_id, std::vector<std::uint32_t>(made.mesh.face_count(), 7));
  }
}

}  // namespace
}  // namespace plumb::testing::csg_colors_test
