// The tree of oriented boxes shows every pair of triangles that meet, each once: held against all
// pairs that the self-test of meshes finds to cross, and against pairs that meet by construction.
#include "plumb/space/bounds/oriented_boxes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include "generate/meshes.h"
#include "generate/voxel_mesh.h"
#include "plumb/space/from_mesh.h"
#include "plumb/testing/dice.h"

namespace plumb::oriented_boxes_test {
namespace {

using testing::Dice;

using IndexPair = std::pair<std::uint32_t, std::uint32_t>;
using Triangles = std::vector<OrientedBoxTree::Triangle>;

/// The pairs that the tree shows, ascending; each once.
std::vector<IndexPair> pairs_shown(std::span<const OrientedBoxTree::Triangle> triangles,
                                   std::size_t& steps, std::span<const std::uint32_t> groups = {}) {
  std::vector<IndexPair> shown;
  const OrientedBoxTree tree(triangles, groups);
  tree.for_each_pair_inside(
      [&](std::uint32_t i, std::uint32_t j) { shown.emplace_back(std::minmax(i, j)); },
      [&] { ++steps; });
  std::ranges::sort(shown);
  EXPECT_EQ(std::ranges::adjacent_find(shown), shown.end());
  return shown;
}

Triangles triangles_of(const PolygonMesh& mesh) {
  Triangles triangles;
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    OrientedBoxTree::Triangle t;
    for (std::size_t i = 0; i < 3; ++i) {
      const Point3& p = mesh.points[mesh.face(f)[i]];
      t[i] = {{p.x, p.y, p.z}, 0};
    }
    triangles.push_back(t);
  }
  return triangles;
}

Point3 random_point(Dice& dice, int size, double unit) {
  const auto c = [&] { return unit * static_cast<double>(dice.between(0, size)); };
  const double x = c(), y = c();
  return {x, y, c()};
}

/// Thin triangles in all directions whose longest sides have one of few points for their middle, so
/// that many meet there.
PolygonMesh thin_triangles(Dice& dice, double unit, std::size_t count) {
  PolygonMesh mesh;
  for (std::uint32_t i = 0; i < 3 * count; i += 3) {
    const Point3 p = random_point(dice, 2, 1);
    const Point3 d = random_point(dice, 100, 1);
    const Point3 by = random_point(dice, 3, 0x1p-6);
    const auto add = [&](double x, double y, double z) {
      mesh.points.push_back({unit * x, unit * y, unit * z});
    };
    add(p.x - d.x, p.y - d.y, p.z - d.z);
    add(p.x + d.x, p.y + d.y, p.z + d.z);
    add(p.x + d.x + by.x, p.y + d.y + by.y, p.z + d.z + by.z);
    mesh.add_face(std::array{i, i + 1, i + 2});
  }
  return mesh;
}

std::vector<IndexPair> crossings(const PolygonMesh& mesh) {
  MeshOptions options;
  options.surface = true;
  const MeshComplex made = complex_of_mesh(mesh, options);
  std::vector<IndexPair> pairs;
  for (const auto& [f, g] : made.crossings) {
    pairs.emplace_back(
        std::minmax(made.complex.facet_origin[f.value()], made.complex.facet_origin[g.value()]));
  }
  return pairs;
}

TEST(OrientedBoxes, OfFewTriangles) {
  std::size_t steps = 0;
  EXPECT_TRUE(pairs_shown({}, steps).empty());
  const Triangles same(5, {{{{0, 0, 0}, 0}, {{1, 0, 0}, 0}, {{0, 1, 0}, 0}}});
  EXPECT_TRUE(pairs_shown(std::span(same).first(1), steps).empty());
  EXPECT_EQ(pairs_shown(same, steps).size(), 10U) << "equal triangles all meet";
  const std::vector<std::uint32_t> groups = {1, 1, OrientedBoxTree::kNoGroup, 0,
                                             OrientedBoxTree::kNoGroup};
  EXPECT_EQ(pairs_shown(same, steps, groups).size(), 9U);
  const Triangles points(4, {{{{2, 2, 2}, 0}, {{2, 2, 2}, 0}, {{2, 2, 2}, 0}}});
  EXPECT_EQ(pairs_shown(points, steps).size(), 6U) << "boxes without extent";
}

/// Triangles with exactly one common corner, at all scales: no rounding may part them.
TEST(OrientedBoxes, ShowsThoseThatTouchInAPoint) {
  Dice dice(25);
  std::size_t steps = 0;
  for (const double unit : {1.0, 0.1, 1e-200, 1e150}) {
    PolygonMesh mesh;
    for (std::uint32_t i = 0; i < 90; i += 3) {
      const Point3 a = random_point(dice, 100, unit), b = random_point(dice, 100, unit);
      const Point3 p{0.3 * unit, 0.7 * unit, 0.1 * unit};
      const double side = i % 2 == 0 ? 1 : -1;
      mesh.points.push_back(p);
      mesh.points.push_back({p.x + side * a.x, p.y + side * a.y, p.z + a.z});
      mesh.points.push_back({p.x + side * b.x, p.y + side * b.y, p.z + b.z});
      mesh.add_face(std::array{i, i + 1, i + 2});
    }
    EXPECT_EQ(pairs_shown(triangles_of(mesh), steps).size(), 30U * 29U / 2U);
  }
}

TEST(OrientedBoxes, ShowsAllThatMeet) {
  Dice dice(21);
  std::size_t found = 0, steps = 0;
  for (const double unit : {1.0, 0.1, 1e-200, 1e200, 1e305}) {
    for (const std::size_t count : {2U, 3U, 5U, 40U}) {
      const PolygonMesh mesh = thin_triangles(dice, unit, count);
      const std::vector<IndexPair> shown = pairs_shown(triangles_of(mesh), steps);
      for (const IndexPair& pair : crossings(mesh)) {
        EXPECT_TRUE(std::ranges::binary_search(shown, pair));
        ++found;
      }
    }
  }
  EXPECT_GT(found, 100U);
}

TEST(OrientedBoxes, ShowsAllThatMeetButThoseOfAGroup) {
  Dice dice(23);
  std::size_t found = 0, steps = 0;
  for (const std::uint32_t group_count : {1U, 2U, 5U, 20U}) {
    const PolygonMesh mesh = thin_triangles(dice, 1, 60);
    std::vector<std::uint32_t> groups(mesh.face_count(), OrientedBoxTree::kNoGroup);
    for (std::uint32_t& group : groups) {
      if (dice.below(4) != 0) group = dice.below(group_count);
    }
    const auto is_left_out = [&](const IndexPair& p) {
      return groups[p.first] == groups[p.second] && groups[p.first] != OrientedBoxTree::kNoGroup;
    };
    const std::vector<IndexPair> shown = pairs_shown(triangles_of(mesh), steps, groups);
    EXPECT_TRUE(std::ranges::none_of(shown, is_left_out));
    for (const IndexPair& pair : crossings(mesh)) {
      if (is_left_out(pair)) continue;
      EXPECT_TRUE(std::ranges::binary_search(shown, pair));
      ++found;
    }
  }
  EXPECT_GT(found, 100U);
}

/// A box that says nothing is apart from none.
TEST(OrientedBoxes, ShowsUnknownPoints) {
  Dice dice(22);
  Triangles triangles = triangles_of(thin_triangles(dice, 1, 20));
  triangles[7][1] = {{0, 0, 0}, std::numeric_limits<double>::infinity()};
  std::size_t steps = 0;
  const std::vector<IndexPair> shown = pairs_shown(triangles, steps);
  for (std::uint32_t i = 0; i < triangles.size(); ++i) {
    if (i == 7) continue;
    EXPECT_TRUE(std::ranges::binary_search(shown, IndexPair(std::min(i, 7U), std::max(i, 7U))));
  }
}

/// The walls of a star: their boxes along any axes overlap, but all that meet are neighbours.
TEST(OrientedBoxes, NeedsFewStepsForAStar) {
  std::array<double, 2> each{};
  for (const std::size_t k : {0U, 1U}) {
    const int tips = k == 0 ? 250 : 2000;
    Triangles walls;
    const PolygonMesh star = testing::fanned(testing::star_prism(tips));
    for (const OrientedBoxTree::Triangle& t : triangles_of(star)) {
      if (t[0].mid[2] != t[1].mid[2] || t[1].mid[2] != t[2].mid[2]) walls.push_back(t);
    }
    std::size_t steps = 0;
    pairs_shown(walls, steps);
    each[k] = static_cast<double>(steps) / static_cast<double>(walls.size());
  }
  EXPECT_LT(each[1], 2 * each[0]);  // for 8 times the tips
  EXPECT_LT(each[1], 100);
}

}  // namespace
}  // namespace plumb::oriented_boxes_test
