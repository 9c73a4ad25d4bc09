// Faces of meshes as facets in planes, held against determinants of integers, and against the law
// that facets, by their jumps, have the boundary of the face that they were made of.
#include "plumb/space/mesh/mesh_facets.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <vector>

#include "generate/meshes.h"
#include "generate/space_scenes.h"
#include "plumb/predicates/point3_signs.h"
#include "plumb/testing/dice.h"

namespace plumb::mesh_facets_test {

using testing::cross;
using testing::Dice;
using testing::dot;
using testing::Face;
using testing::make_mesh;
using testing::operator+;

struct Flattened {
  SpaceTables tables;
  MeshVertices vertices;
  MeshReport report;
  MeshFacets facets;

  explicit Flattened(const PolygonMesh& mesh) {
    Context context;
    vertices = merge_equal_points(mesh, tables);
    facets = flatten_mesh(mesh, vertices, tables, report, context);
  }
  RationalPoint3 place(std::uint32_t v) const { return exact(tables.points, vertices.point[v]); }
  RationalPoint3 normal(std::size_t f) const {
    const IntegerRow row = tables.planes.coefficients(facets.plane[f]);
    return {row[0], row[1], row[2]};
  }
};

using Chain = std::map<std::array<std::uint32_t, 2>, std::int64_t>;

void add_edge(Chain& chain, std::uint32_t from, std::uint32_t to, std::int64_t times) {
  if (from == to) return;
  std::int64_t& sum = chain[{std::min(from, to), std::max(from, to)}];
  sum += from < to ? times : -times;
}

template <class Corners>
void add_boundary(Chain& chain, const Corners& corners, std::int64_t times) {
  for (std::size_t i = 0; i < corners.size(); ++i) {
    add_edge(chain, corners[i], corners[(i + 1) % corners.size()], times);
  }
}

void expect_facets_in_planes(const Flattened& mesh) {
  for (std::size_t f = 0; f < mesh.facets.size(); ++f) {
    const auto corners = mesh.facets.corners(f);
    ASSERT_GE(corners.size(), 3U);
    EXPECT_EQ(corners[0], *std::ranges::min_element(corners));
    RationalPoint3 area{0, 0, 0};
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const RationalPoint3 p = mesh.place(corners[i]);
      area = area + cross(p, mesh.place(corners[(i + 1) % corners.size()]));
      EXPECT_EQ(side(mesh.tables.points, mesh.vertices.point[corners[i]], mesh.facets.plane[f]),
                Sign::Zero);
    }
    EXPECT_GT(dot(area, mesh.normal(f)), 0);
    EXPECT_EQ(std::abs(mesh.facets.jump[f]), 1);
  }
}

// Of few places, so that points are often on a line, as input points and as constructed ones.
TEST(MeshFacets, PlaneThroughThreePointsShowsThemCounterClockwise) {
  Dice dice(51);
  for (int round = 0; round < 300; ++round) {
    std::array<std::array<std::int64_t, 3>, 4> at;
    for (auto& p : at) p = {dice.between(0, 2), dice.between(0, 2), dice.between(0, 2)};
    const auto d = [&](std::size_t i, std::size_t k) { return at[i][k] - at[0][k]; };
    const std::array<std::int64_t, 3> n{d(1, 1) * d(2, 2) - d(1, 2) * d(2, 1),
                                        d(1, 2) * d(2, 0) - d(1, 0) * d(2, 2),
                                        d(1, 0) * d(2, 1) - d(1, 1) * d(2, 0)};
    const std::int64_t above = n[0] * d(3, 0) + n[1] * d(3, 1) + n[2] * d(3, 2);
    for (const int divisor : {1, 3}) {
      SpaceTables tables;
      std::array<SpacePoint, 4> point;
      for (std::size_t i = 0; i < 4; ++i) {
        point[i] = add_point(tables, {Rational(at[i][0], divisor), Rational(at[i][1], divisor),
                                      Rational(at[i][2], divisor)});
      }
      const OrientedPlane plane = plane_through(tables, point[0], point[1], point[2]);
      ASSERT_EQ(plane.is_valid(), n[0] != 0 || n[1] != 0 || n[2] != 0);
      if (!plane.is_valid()) continue;
      EXPECT_EQ(side(tables.points, point[3], plane.plane()) * plane.orientation(), sign_of(above));
    }
  }
}

TEST(MeshFacets, TurningAFaceOverTurnsItsJump) {
  const PolygonMesh box = testing::box_mesh({0, 0, 0}, {1, 2, 3});
  const Flattened out(box), in(testing::reversed(box));
  expect_facets_in_planes(out);
  expect_facets_in_planes(in);
  ASSERT_EQ(out.facets.size(), 6U);
  EXPECT_EQ(out.facets.corner, in.facets.corner);
  for (std::size_t f = 0; f < 6; ++f) {
    EXPECT_EQ(out.facets.jump[f], -in.facets.jump[f]);
    // The box lies to the negative side of an outward facet: there the winding number is higher.
    const RationalPoint3 middle{Rational(1, 2), 1, Rational(3, 2)};
    const RationalPoint3 inward = middle - out.place(out.facets.corners(f)[0]);
    EXPECT_EQ(out.facets.jump[f] > 0, dot(out.normal(f), inward) > 0);
  }
}

// Words of few letters for faces: corners repeat, faces fold back, cross themselves, leave their
// plane and lie on a line. The facets of a face have its boundary all the same.
TEST(MeshFacets, KeepTheBoundaryOfEveryFace) {
  Dice dice(52);
  for (int round = 0; round < 600; ++round) {
    std::vector<Point3> points;
    const std::int64_t height = round % 3 == 0 ? 2 : 0;
    for (int i = 0; i < 7; ++i) {
      points.push_back({static_cast<double>(dice.between(0, 3)),
                        static_cast<double>(dice.between(0, 3)),
                        static_cast<double>(dice.between(0, height))});
    }
    Face face;
    for (int i = 3 + static_cast<int>(dice.below(6)); i > 0; --i) face.push_back(dice.below(7));
    PolygonMesh mesh = make_mesh(points, {face});
    if (round % 4 == 0) mesh.exact = {{3, {Rational(1, 3), Rational(4, 3), 0}}};
    const Flattened flat(mesh);
    expect_facets_in_planes(flat);
    Chain chain;
    Face corners;
    for (const std::uint32_t p : face) corners.push_back(flat.vertices.of_point[p]);
    add_boundary(chain, corners, 1);
    for (std::size_t f = 0; f < flat.facets.size(); ++f) {
      add_boundary(chain, flat.facets.corners(f), flat.facets.jump[f]);
    }
    for (const auto& [from, to] : flat.facets.loose) add_edge(chain, from, to, -1);
    for (const auto& [edge, times] : chain) EXPECT_EQ(times, 0) << round;
  }
}

TEST(MeshFacets, ReportWhatIsChanged) {
  const std::vector<Point3> points{{0, 0, 0}, {2, 0, 0}, {2, 2, 0},
                                   {0, 2, 0}, {4, 0, 0}, {0, 0, 1}};
  const Flattened mesh(make_mesh(points, {{0, 1, 2, 3},        // 0: a square
                                          {0, 2, 1, 3},        // 1: a bow-tie
                                          {1, 2, 3, 5},        // 2: not in a plane
                                          {0, 1, 4},           // 3: on a line
                                          {4, 2, 3, 2, 2, 1},  // 4: a triangle with a spike
                                          {3, 0, 3, 1},        // 5: there and back
                                          {0, 1, 4, 1},        // 6: the same on a line
                                          {5, 0, 1, 1, 5}}));  // 7: corners repeated at the end
  using Faces = std::vector<std::uint32_t>;
  EXPECT_EQ(mesh.report.not_simple, Faces({1}));
  EXPECT_EQ(mesh.report.not_planar, Faces({2}));
  EXPECT_EQ(mesh.report.degenerate, Faces({3, 5, 6}));
  EXPECT_EQ(mesh.report.trimmed, Faces({4, 5, 6, 7}));
  const auto pieces = [&](std::uint32_t face) {
    return std::ranges::count(mesh.facets.origin, face);
  };
  EXPECT_EQ(pieces(0), 1);
  EXPECT_EQ(pieces(2), 2);
  EXPECT_EQ(pieces(4), 1);
  EXPECT_EQ(mesh.facets.loose.size(), 3U);  // of face 3; nothing is left of the others
  EXPECT_TRUE(std::ranges::is_sorted(mesh.facets.origin));
}

// A polygon that starts with corners on a line, and one that has many of them.
TEST(MeshFacets, TakesCornersThatAreOnLines) {
  const std::vector<Point3> points{{0, 0, 5}, {1, 0, 5}, {2, 0, 5},
                                   {3, 0, 5}, {3, 3, 5}, {0, 3, 5}};
  for (std::uint32_t turn = 0; turn < 6; ++turn) {
    Face face;
    for (std::uint32_t i = 0; i < 6; ++i) face.push_back((i + turn) % 6);
    const Flattened mesh(make_mesh(points, {face}));
    expect_facets_in_planes(mesh);
    ASSERT_EQ(mesh.facets.size(), 1U);
    EXPECT_EQ(mesh.facets.corners(0).size(), 6U);
    EXPECT_TRUE(mesh.report.not_simple.empty() && mesh.report.not_planar.empty());
  }
}

}  // namespace plumb::mesh_facets_test
