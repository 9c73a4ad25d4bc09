// check_rounding() on meshes whose harm is known by construction: what breaks is named, and nothing
// else is; whether a face is flipped is compared with normals in rationals.
#include "plumb/space/rounded_mesh.h"

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <limits>
#include <vector>

#include "generate/meshes.h"
#include "plumb/predicates/rounding.h"
#include "plumb/testing/dice.h"

namespace plumb::rounded_mesh_test {
namespace {

using testing::box_mesh;
using testing::Dice;
using testing::joined;
using testing::make_mesh;
using testing::moved;
using testing::tetrahedron_mesh;

using Faces = std::vector<std::uint32_t>;
using FacePairs = std::vector<RoundingReport::FacePair>;

const Rational kTiny = Rational(1) / (Integer(1) << 200);

PolygonMesh cube() { return box_mesh({0, 0, 0}, {3, 3, 3}); }

/// Vertices from `first` on are truly farther along x than their doubles say.
PolygonMesh shifted_from(PolygonMesh mesh, std::uint32_t first) {
  for (std::uint32_t v = first; v < mesh.points.size(); ++v) {
    const Point3& p = mesh.points[v];
    mesh.exact.emplace_back(v, RationalPoint3{p.x + kTiny, p.y, p.z});
  }
  return mesh;
}

TEST(RoundedMesh, DoublesAreNotLookedAt) {
  const PolygonMesh crossing = joined(cube(), moved(cube(), {1, 1, 1}));
  EXPECT_TRUE(check_rounding(crossing, 100).is_sound());
  EXPECT_EQ(check_rounding(crossing, 100).rounded_vertices, 0U);
  EXPECT_TRUE(check_rounding(PolygonMesh{}, 100).is_sound());
}

TEST(RoundedMesh, VerticesAndFacesThatFallTogetherAreCounted) {
  const PolygonMesh boxes = shifted_from(joined(cube(), moved(cube(), {3, 0, 0})), 8);
  const RoundingReport report = check_rounding(boxes, 100);
  EXPECT_EQ(report.rounded_vertices, 8U);
  EXPECT_EQ(report.vertices_merged, 4U);
  ASSERT_EQ(report.doubled.size(), 1U);
  // The faces that coincide have all their corners on the plane x = 3.
  for (const std::uint32_t f : {report.doubled[0].first, report.doubled[0].second}) {
    for (const std::uint32_t v : boxes.face(f)) EXPECT_EQ(boxes.points[v].x, 3);
  }
  EXPECT_FALSE(report.is_sound());
  EXPECT_TRUE(report.flipped.empty() && report.degenerate.empty());
}

/// Vertices that were split on purpose were equal before, so rounding has not merged them.
TEST(RoundedMesh, VerticesThatWereEqualBeforeAreNotMerged) {
  PolygonMesh boxes = joined(cube(), moved(cube(), {3, 3, 0}));
  for (std::uint32_t v = 0; v < boxes.points.size(); ++v) {
    const Point3& p = boxes.points[v];
    if (p != Point3{3, 3, 0}) continue;
    boxes.exact.emplace_back(v, RationalPoint3{p.x, p.y, p.z - kTiny});
  }
  ASSERT_EQ(boxes.exact.size(), 2U);
  EXPECT_EQ(check_rounding(boxes, 100).vertices_merged, 0U);
}

/// Two boxes half a face apart touch now. A third one far away is neither looked at nor named, but
/// shifts the numbers of faces.
TEST(RoundedMesh, CrossingsAreNamedByFacesOfTheMesh) {
  const PolygonMesh far = joined(moved(cube(), {-90, 0, 0}), cube());
  const PolygonMesh boxes = shifted_from(joined(far, moved(cube(), {3, 1, 1})), 16);
  const RoundingReport report = check_rounding(boxes, 100);
  EXPECT_EQ(report.vertices_merged, 0U);
  EXPECT_GT(report.crossing_count, 1U);
  EXPECT_EQ(report.crossings.size(), report.crossing_count);
  for (const auto& [f, g] : report.crossings) {
    EXPECT_TRUE(f >= 6 && f < 12 && g >= 12) << f << ' ' << g;
  }
  const RoundingReport cut = check_rounding(boxes, 1);
  EXPECT_EQ(cut.crossing_count, report.crossing_count) << "the number is complete";
  EXPECT_EQ(cut.crossings.size(), 1U);
}

TEST(RoundedMesh, FacesWithoutAreaAreNamed) {
  // A vertex next to an edge falls on it.
  PolygonMesh needle = tetrahedron_mesh({0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {0.25, 0.25, 1});
  needle.points[1] = {0.5, 0, 0};
  needle.exact = {{1, {Rational(1) / 2, kTiny, 0}}};
  const RoundingReport report = check_rounding(needle, 100);
  EXPECT_EQ(report.degenerate, Faces{0});
  EXPECT_FALSE(report.is_sound());
  // A flat tetrahedron: its faces overlap, but each has an area.
  const Rational third = Rational(1) / 3;
  PolygonMesh flat = tetrahedron_mesh({0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {0, 0, 0});
  flat.exact = {{3, {third, third, kTiny}}};
  flat.points[3] = {1.0 / 3, 1.0 / 3, 0};
  EXPECT_GT(check_rounding(flat, 100).crossing_count, 0U);
  EXPECT_TRUE(check_rounding(flat, 100).degenerate.empty());
}

RationalPoint3 normal(const std::array<RationalPoint3, 3>& p) {
  const Rational ax = p[1].x - p[0].x, ay = p[1].y - p[0].y, az = p[1].z - p[0].z;
  const Rational bx = p[2].x - p[0].x, by = p[2].y - p[0].y, bz = p[2].z - p[0].z;
  return {ay * bz - az * by, az * bx - ax * bz, ax * by - ay * bx};
}

/// A thin triangle whose corners move by about an ulp, so that it often turns over.
TEST(RoundedMesh, FlippedFacesAreThoseOfReversedNormals) {
  Dice dice(3);
  std::size_t flips = 0, kept = 0;
  for (int round = 0; round < 60; ++round) {
    PolygonMesh mesh =
        make_mesh({{0, 0, 0}, {1, 1 + 0x1p-52, 0}, {1.0 / 3, 1.0 / 3, 0}}, {{0, 1, 2}});
    std::array<RationalPoint3, 3> now, then;
    for (std::uint32_t v = 0; v < 3; ++v) {
      const Point3& p = mesh.points[v];
      now[v] = then[v] = {exact_rational(p.x), exact_rational(p.y), 0};
      if (v == 0) continue;
      const std::int64_t tenths = v == 1 ? dice.between(-14, 4) : dice.between(-9, 9);
      then[v].y += Rational(tenths) / Rational(Integer(10) << (v == 1 ? 52U : 55U));
      mesh.exact.emplace_back(v, then[v]);
    }
    const Rational cosine = normal(now).z * normal(then).z;
    const bool is_flipped = cosine < 0;
    EXPECT_EQ(check_rounding(mesh, 100).flipped, is_flipped ? Faces{0} : Faces{});
    ++(is_flipped ? flips : kept);
  }
  EXPECT_GT(flips, 5U);
  EXPECT_GT(kept, 5U);
}

TEST(RoundedMesh, VerticesBeyondDoublesAreListedAlone) {
  PolygonMesh mesh = shifted_from(joined(cube(), moved(cube(), {3, 0, 0})), 8);
  mesh.points[9].y = std::numeric_limits<double>::infinity();
  mesh.points[12].z = -std::numeric_limits<double>::infinity();
  const RoundingReport report = check_rounding(mesh, 100);
  EXPECT_EQ(report.beyond_doubles, (std::vector<std::uint32_t>{9, 12}));
  EXPECT_EQ(report.rounded_vertices, 8U);
  EXPECT_EQ(report.vertices_merged, 0U) << "nothing else is looked at";
  EXPECT_FALSE(report.is_sound());
}

}  // namespace
}  // namespace plumb::rounded_mesh_test
