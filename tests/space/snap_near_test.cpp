// snap_near() on meshes whose near parts are known by construction, and its laws on random ones.
#include "plumb/space/mesh/snap_near.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include "generate/meshes.h"
#include "generate/test_share.h"
#include "plumb/predicates/strong_id.h"
#include "plumb/testing/dice.h"

namespace plumb::snap_near_test {
namespace {

using testing::Dice;
using testing::fanned;
using testing::icosphere_mesh;
using testing::make_mesh;

using Pairs = std::vector<std::pair<std::uint32_t, std::uint32_t>>;

ChangedMesh snap_all(const PolygonMesh& mesh, double width, const Pairs& pairs = {}) {
  return snap_near(mesh, std::vector<std::uint8_t>(mesh.face_count(), 1), pairs, width);
}

/// Whether each directed edge occurs as often as its reverse.
bool is_closed(const PolygonMesh& mesh) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    const auto face = mesh.face(f);
    std::uint32_t from = face.back();
    for (const std::uint32_t to : face) {
      from < to ? ++edges[{from, to}] : --edges[{to, from}];
      from = to;
    }
  }
  return std::ranges::all_of(edges, [](const auto& e) { return e.second == 0; });
}

/// Two tetrahedra over a common edge 0 1, with vertex 4 near the middle of it.
PolygonMesh with_vertex_near_edge(double height) {
  return make_mesh({{0, 0, 0}, {2, 0, 0}, {1, 1, 0}, {1, 0, 1}, {1, -height, 0}},
                   {{0, 1, 2}, {0, 4, 1}, {0, 2, 3}, {2, 1, 3}, {4, 0, 3}, {1, 4, 3}});
}

TEST(SnapNear, NothingNearChangesNothing) {
  EXPECT_TRUE(snap_all(icosphere_mesh(2, 1, {0, 0, 0}), 0x1p-20).changed.empty());
  EXPECT_TRUE(snap_all(with_vertex_near_edge(0.5), 0x1p-20).changed.empty());
}

TEST(SnapNear, ATriangleAsFlatAsTheWidthVanishes) {
  const PolygonMesh mesh = with_vertex_near_edge(0x1p-22);
  ASSERT_TRUE(is_closed(mesh));
  const ChangedMesh snapped = snap_all(mesh, 0x1p-20);
  EXPECT_TRUE(is_closed(snapped.mesh));
  EXPECT_EQ(snapped.mesh.face_count(), 6U);  // Triangle 0 is cut in two, triangle 1 is gone.
  EXPECT_EQ(std::ranges::count(snapped.origin, 1U), 0);
  EXPECT_EQ(std::ranges::count(snapped.origin, 0U), 2);
  EXPECT_EQ(snapped.changed, (std::vector<std::uint8_t>{1, 1, 0, 0, 0, 0}));
  EXPECT_NEAR(snapped.largest_move, 0x1p-22, 0x1p-40);
}

TEST(SnapNear, AVertexOfAPairBecomesACornerInsideTheOtherTriangle) {
  PolygonMesh mesh = testing::joined(
      fanned(testing::box_mesh({0, 0, 0}, {4, 4, 4})),
      testing::tetrahedron_mesh({1, 1, 5}, {2, 1, 5}, {1, 2, 5}, {1, 0.5, 4 + 0x1p-30}));
  std::uint32_t below = kNone;  // The triangle of the box under the tip.
  for (std::uint32_t f = 0; f < 12; ++f) {
    const auto t = mesh.face(f);
    const auto is_at = [&](double x, double y) {
      return std::ranges::any_of(t, [&](std::uint32_t v) {
        return mesh.points[v].x == x && mesh.points[v].y == y && mesh.points[v].z == 4;
      });
    };
    const bool is_top = std::ranges::all_of(t, [&](auto v) { return mesh.points[v].z == 4; });
    if (is_top && is_at(4, 0)) below = f;
  }
  ASSERT_NE(below, kNone);
  const ChangedMesh snapped =
      snap_near(mesh, std::vector<std::uint8_t>(16, 0), Pairs{{below, 13}}, 0x1p-20);
  EXPECT_TRUE(is_closed(snapped.mesh));
  EXPECT_EQ(std::ranges::count(snapped.origin, below), 3);
}

/// Of 4,000 vertices near one edge some are inserted, and the others wait for a later round.
TEST(SnapNear, OneEdgeTakesFewVerticesAtOnce) {
  constexpr std::uint32_t kCount = 4000;
  PolygonMesh mesh = testing::tetrahedron_mesh({0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {0, 0, 1});
  Pairs pairs;
  for (std::uint32_t i = 0; i < kCount; ++i) {
    const double x = (i + 1.0) / (kCount + 1);
    const auto tip = static_cast<std::uint32_t>(mesh.points.size());
    mesh.points.insert(mesh.points.end(),
                       {{x, -0x1p-40, 0}, {x, -1, 0}, {x + 0x1p-20, -1, 0}, {x, -1, -1}});
    const auto first = static_cast<std::uint32_t>(mesh.face_count());
    for (const testing::Face& f : {testing::Face{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}}) {
      mesh.add_face(std::array{tip + f[0], tip + f[1], tip + f[2]});
    }
    for (std::uint32_t f = 0; f < 4; ++f) pairs.emplace_back(f, first);
  }
  ASSERT_TRUE(is_closed(mesh));
  const ChangedMesh snapped =
      snap_near(mesh, std::vector<std::uint8_t>(mesh.face_count(), 0), pairs, 0x1p-30);
  EXPECT_TRUE(is_closed(snapped.mesh));
  const auto parts = std::ranges::count_if(snapped.origin, [](std::uint32_t f) { return f < 4; });
  EXPECT_GT(parts, 20);
  EXPECT_LT(parts, 100);
}

/// Points on a line are near each other's edges in every way; widths from none to all.
TEST(SnapNear, MeshesStayClosedWhateverIsNear) {
  const std::uint64_t cases = testing::share_of(2000);
  for (std::uint64_t i = 0; i < cases; ++i) {
    SCOPED_TRACE(i);
    Dice dice(i);
    PolygonMesh mesh = icosphere_mesh(1, 1, {0, 0, 0});
    for (Point3& p : mesh.points) {
      if (dice.below(2) == 0) p.y = p.z = std::ldexp(static_cast<double>(dice.between(-9, 9)), -30);
    }
    std::vector<std::uint8_t> is_damaged;
    for (std::size_t f = 0; f < mesh.face_count(); ++f) {
      is_damaged.push_back(static_cast<std::uint8_t>(dice.below(2)));
    }
    Pairs pairs;
    for (int k = 0; k < 20; ++k) {
      pairs.emplace_back(dice.below(mesh.face_count()), dice.below(mesh.face_count()));
    }
    std::erase_if(pairs, [](const auto& p) { return p.first == p.second; });
    const double width = std::ldexp(1, -static_cast<int>(dice.between(0, 35)));
    const ChangedMesh snapped = snap_near(mesh, is_damaged, pairs, width);
    if (snapped.changed.empty()) continue;
    EXPECT_TRUE(is_closed(snapped.mesh));
    EXPECT_EQ(snapped.origin.size(), snapped.mesh.face_count());
    for (std::size_t f = 0; f < snapped.mesh.face_count(); ++f) {
      const auto t = snapped.mesh.face(f);
      EXPECT_TRUE(t.size() == 3 && t[0] != t[1] && t[1] != t[2] && t[2] != t[0]);
      if (snapped.changed[snapped.origin[f]] == 0) {
        EXPECT_TRUE(std::ranges::equal(t, mesh.face(snapped.origin[f])));
      }
    }
  }
}

}  // namespace
}  // namespace plumb::snap_near_test
