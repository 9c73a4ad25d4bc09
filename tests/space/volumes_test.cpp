// Volumes and shells of boxes in boxes, held against how many boxes are around a place.
#include "plumb/space/query/volumes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <utility>
#include <vector>

#include "generate/space_scenes.h"
#include "plumb/predicates/point3_signs.h"

namespace plumb::volumes_test {

using testing::rational_point;
using testing::SpaceScene;
using testing::operator+;
using testing::operator*;

constexpr int kStacks = 3, kDepth = 3;

/// Boxes in boxes, in stacks side by side, with a point and an edge within each box.
SpaceScene stacks() {
  SpaceScene scene;
  for (int s = 0; s < kStacks; ++s) {
    for (int i = kDepth - 1; i >= 0; --i) {
      const int low = 4 * i, high = 40 - 4 * i;
      testing::add_box(scene, rational_point(100 * s + low, low, low),
                       rational_point(100 * s + high, high, high));
      scene.add_point(rational_point(100 * s + 20, 20, low + 1));
      scene.add_free_edge(rational_point(100 * s + 20, 20, low + 2),
                          rational_point(100 * s + 21, 20, low + 3));
    }
  }
  return scene;
}

/// The stack and how many of its boxes are around the place, which is on none; (0, 0) outside.
std::pair<int, int> boxes_around(const RationalPoint3& p) {
  for (int s = 0; s < kStacks; ++s) {
    int depth = 0;
    for (int i = 0; i < kDepth; ++i) {
      const auto is_between = [&](const Rational& x) { return x > 4 * i && x < 40 - 4 * i; };
      if (is_between(p.x - 100 * s) && is_between(p.y) && is_between(p.z)) ++depth;
    }
    if (depth > 0) return {s, depth};
  }
  return {0, 0};
}

RationalPoint3 place(const SpaceComplex& c, VertexId v) {
  return exact(c.points(), c.vertex_point[v.value()]);
}

/// Next to the middle of a rectangle.
RationalPoint3 beside(const SpaceComplex& c, FacetId f, bool is_negative_side) {
  const UseId u = c.cycles_of(f)[0], opposite = c.use_next[c.use_next[u.value()].value()];
  const IntegerRow row = c.planes().coefficients(c.facet_plane[f.value()]);
  const RationalPoint3 n{row[0], row[1], row[2]};
  const Rational length = abs(n.x) + abs(n.y) + abs(n.z);  // along an axis
  return Rational(1, 2) * (place(c, c.use_origin(u)) + place(c, c.use_origin(opposite))) +
         Rational((is_negative_side ? -1 : 1) / (2 * length)) * n;
}

TEST(Volumes, AreTheSameForTheSameBoxesAround) {
  Context context;
  const SpaceComplex c = testing::complex_without_volumes(stacks());
  const VolumeLabels labels = find_volumes(c, context);
  EXPECT_EQ(labels.count, 1U + kStacks * kDepth);
  std::map<std::pair<int, int>, VolumeId> known{{{0, 0}, VolumeId(0)}};
  const auto expect_at = [&](const RationalPoint3& p, VolumeId v) {
    ASSERT_LT(v.value(), labels.count);
    EXPECT_EQ(known.try_emplace(boxes_around(p), v).first->second, v);
  };
  for (std::size_t f = 0; f < c.facet_count(); ++f) {
    expect_at(beside(c, FacetId(f), false), labels.facet[f][0]);
    expect_at(beside(c, FacetId(f), true), labels.facet[f][1]);
  }
  EXPECT_EQ(known.size(), labels.count);
  for (std::size_t e = 0; e < c.edge_count(); ++e) {
    ASSERT_EQ(labels.edge[e].is_valid(), !c.edge_use[e].is_valid());
    if (labels.edge[e].is_valid()) expect_at(place(c, c.origin[2 * e]), labels.edge[e]);
  }
  for (std::uint32_t v = 0; v < c.vertex_count(); ++v) {
    ASSERT_EQ(labels.vertex[v].is_valid(), c.star_of(VertexId(v)).empty());
    if (labels.vertex[v].is_valid()) expect_at(place(c, VertexId(v)), labels.vertex[v]);
  }
}

TEST(Volumes, AreNumberedByTheirLeastFacets) {
  Context context;
  const VolumeLabels labels = find_volumes(testing::complex_without_volumes(stacks()), context);
  std::uint32_t most = 0;
  for (const auto& [above, below] : labels.facet) {
    const std::uint32_t lesser = std::min(above, below).value();
    const std::uint32_t greater = std::max(above, below).value();
    EXPECT_LE(lesser, most + 1);
    most = std::max(most, lesser);
    EXPECT_LE(greater, most + 1);
    most = std::max(most, greater);
  }
}

TEST(Volumes, WindingNumbersCountTheBoxesAround) {
  Context context;
  SpaceComplex c = testing::complex_without_volumes(stacks());
  label_volumes(c, context);
  std::vector<std::int32_t> jump(c.facet_count()), expected(c.volume_count());
  for (std::uint32_t f = 0; f < c.facet_count(); ++f) {
    const int above = boxes_around(beside(c, FacetId(f), false)).second;
    const int below = boxes_around(beside(c, FacetId(f), true)).second;
    jump[f] = above - below;
    expected[c.facet_volume[f][0].value()] = above;
    expected[c.facet_volume[f][1].value()] = below;
  }
  EXPECT_EQ(winding_numbers(c, jump), expected);
}

// A shaft joins what is above and below a box: two volumes, and one inside of its shell.
TEST(Volumes, GoThroughAShaft) {
  Context context;
  SpaceScene scene;
  testing::add_frame_box(scene, rational_point(0, 0, 0), rational_point(9, 9, 9));
  const SpaceComplex c = testing::complex_without_volumes(scene);
  const VolumeLabels labels = find_volumes(c, context);
  EXPECT_EQ(labels.count, 2U);
  for (const auto& [above, below] : labels.facet) EXPECT_NE(above, below);
}

// Shells: sides of one box have one, inside and outside apart, and no other box has the same.
TEST(Volumes, ShellsAreSidesOfBoxes) {
  const SpaceComplex c = testing::complex_without_volumes(stacks());
  ShellNodes nodes(c);
  std::map<std::uint32_t, std::pair<std::uint32_t, int>> known;  // the box and how deep it is
  for (std::uint32_t f = 0; f < c.facet_count(); ++f) {
    const int above = boxes_around(beside(c, FacetId(f), false)).second;
    const int below = boxes_around(beside(c, FacetId(f), true)).second;
    for (const bool is_negative_side : {false, true}) {
      const std::pair box(f / 6, is_negative_side ? below : above);
      const std::uint32_t root = nodes.root(ShellNodes::facet_node(FacetId(f), is_negative_side));
      EXPECT_EQ(known.try_emplace(root, box).first->second, box);
    }
  }
  EXPECT_EQ(known.size(), 2U * kStacks * kDepth);
}

}  // namespace plumb::volumes_test
