// valid_mesh() on sets that rounding damages: the result is judged by brute force
// (oracle/valid_mesh_check.h).
#include "plumb/space/valid_mesh.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <span>

#include "generate/mesh_solid.h"
#include "generate/meshes.h"
#include "generate/near_solids.h"
#include "generate/test_share.h"
#include "oracle/valid_mesh_check.h"
#include "plumb/testing/dice.h"

namespace plumb::valid_mesh_test {
namespace {

using testing::box_mesh;
using testing::Dice;
using testing::fanned;
using testing::icosphere_mesh;
using testing::moved;
using testing::solid;
using testing::turned;

/// Returns a mesh turned about the x axis, in doubles.
PolygonMesh turned_about_x(PolygonMesh mesh, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  for (Point3& p : mesh.points) p = {p.x, c * p.y - s * p.z, s * p.y + c * p.z};
  return mesh;
}

/// Checks the promises for one set; returns the valid mesh.
ValidMesh checked(const Nef3& set, CoordinateType type, MeshFaces faces) {
  ValidMesh valid;
  EXPECT_EQ(testing::valid_mesh_disagreement(set, type, faces, &valid), "");
  return valid;
}

TEST(ValidMesh, MeshesOfDoublesStayAsTheyAre) {
  const Nef3 set = solid(box_mesh({0, 0, 0}, {3, 2, 1})) - solid(box_mesh({1, 1, 0}, {2, 3, 1}));
  const ValidMesh valid = checked(set, CoordinateType::Double, MeshFaces::PlanarPolygons);
  const MeshOfComplex nearest = mesh_of_complex(set.complex());
  EXPECT_EQ(valid.made.mesh.points, nearest.mesh.points);
  EXPECT_EQ(valid.made.mesh.corners, nearest.mesh.corners);
  EXPECT_EQ(valid.made.facet, nearest.facet);
  EXPECT_EQ(valid.repair.largest_move, 0);
  EXPECT_FALSE(valid.repair.changes_topology);
}

/// A box with a hole that is narrower than the floats at its place; a plate that is thinner; two
/// boxes whose gap is narrower.
TEST(ValidMesh, WhatCollapsesIsTold) {
  const Point3 far{500000, 4500000, 0};
  const Nef3 block = solid(moved(box_mesh({0, 0, 0}, {10, 10, 10}), far));
  const Nef3 hole = solid(moved(box_mesh({5, 5, -1}, {5.015625, 5.015625, 11}), far));
  const ValidMesh filled =
      checked((block - hole).regularization(), CoordinateType::Float, MeshFaces::Triangles);
  EXPECT_TRUE(filled.repair.changes_topology);
  EXPECT_TRUE(Nef3::from_mesh(filled.made.mesh) == block);
  const ValidMesh plate = checked(solid(box_mesh({1e6, 0, 0}, {1e6 + 0x1p-6, 1, 1})),
                                  CoordinateType::Float, MeshFaces::Triangles);
  EXPECT_TRUE(plate.repair.changes_topology);
  EXPECT_EQ(plate.made.mesh.face_count(), 0U);
  const Nef3 boxes =
      solid(box_mesh({0, 0, 0}, {1, 1, 1})) + solid(box_mesh({1 + 0x1p-30, 0, 0}, {2, 1, 1}));
  const ValidMesh closed = checked(boxes, CoordinateType::Float, MeshFaces::Triangles);
  EXPECT_TRUE(closed.repair.changes_topology);
  EXPECT_TRUE(Nef3::from_mesh(closed.made.mesh) == solid(box_mesh({0, 0, 0}, {2, 1, 1})));
  EXPECT_FALSE(
      checked(boxes, CoordinateType::Double, MeshFaces::Triangles).repair.changes_topology);
}

/// PLUMB_CASES=100000 makes it run for an hour.
TEST(ValidMesh, RandomSetsAreValidNearAndStill) {
  const std::uint64_t cases = testing::case_count(60);
  for (std::uint64_t i = 0; i < cases && !HasFailure(); ++i) {
    Dice dice(i);
    const auto program = testing::random_near_solids(dice, 3);
    EXPECT_EQ(testing::valid_mesh_of_program_disagreement(program), "") << "scene " << i;
  }
}

/// The random scenes are hard: many need a repair.
TEST(ValidMesh, RandomSetsNeedRepairs) {
  std::uint64_t repaired = 0;
  for (std::uint64_t i = 0; i < 50; ++i) {
    Dice dice(i);
    const auto program = testing::random_near_solids(dice, 3);
    Nef3 set;
    for (std::size_t k = 0; k < program.size(); k += testing::kNearSolidRecord) {
      set =
          testing::apply_near_solid(set, std::span(program).subspan(k, testing::kNearSolidRecord));
    }
    repaired += valid_mesh(set).repair.rounds > 0 ? 1 : 0;
  }
  EXPECT_GT(repaired, 5U);
}

/// Returns the mesh with all coordinates multiplied by 2^exponent.
PolygonMesh scaled(PolygonMesh mesh, int exponent) {
  for (Point3& p : mesh.points) {
    p = {std::ldexp(p.x, exponent), std::ldexp(p.y, exponent), std::ldexp(p.z, exponent)};
  }
  return mesh;
}

/// Scaling by a power of two scales the result, as long as all numbers have all their digits.
TEST(ValidMesh, ScaleDoesNotMatter) {
  const auto made_at = [](int exponent) {
    Nef3 set = solid(scaled(box_mesh({-1, -1, -1}, {1, 1, 1}), exponent));
    for (int step = 1; step <= 6; ++step) {
      set = set + solid(scaled(turned(box_mesh({-1, -1, -1}, {1, 1, 1}), 0.1 * step), exponent));
      set = Nef3::from_mesh(valid_mesh(set).made.mesh);
    }
    return valid_mesh(set - solid(scaled(icosphere_mesh(1, 1.2, {0.1, 0.2, 0.3}), exponent)));
  };
  const ValidMesh one = made_at(0);
  EXPECT_EQ(testing::invalid_mesh(one.made.mesh, CoordinateType::Double), "");
  for (const int exponent : {900, -800}) {
    const ValidMesh other = made_at(exponent);
    EXPECT_EQ(scaled(other.made.mesh, -exponent).points, one.made.mesh.points);
    EXPECT_EQ(other.made.mesh.corners, one.made.mesh.corners);
    EXPECT_EQ(other.repair.rounds, one.repair.rounds);
    EXPECT_EQ(std::ldexp(other.repair.largest_move, -exponent), one.repair.largest_move);
  }
}

/// Unions of turned cubes in a row, each with what was written before. Exact unions keep facets
/// whole; a written one has triangles, but the number of vertices must not grow beyond theirs.
TEST(ValidMesh, ChainsOfUnionsStaySmall) {
  for (const auto type : {CoordinateType::Double, CoordinateType::Float}) {
    Nef3 exact = solid(box_mesh({-1, -1, -1}, {1, 1, 1})), written = exact;
    for (int step = 1; step <= 7; ++step) {
      const PolygonMesh about_z = turned(box_mesh({-1, -1, -1}, {1, 1, 1}), 0.13 * step);
      const Nef3 next = solid(fanned(turned_about_x(about_z, 0.17 * step)));
      exact = exact + next;
      const ValidMesh valid = valid_mesh(written + next, {}, type);
      EXPECT_LE(valid.made.mesh.points.size(), exact.complex().vertex_count()) << step;
      EXPECT_LT(valid.repair.largest_move, type == CoordinateType::Double ? 0x1p-45 : 0x1p-16);
      written = solid(valid.made.mesh);
    }
    const ValidMesh last = valid_mesh(written, {}, type);
    EXPECT_EQ(testing::invalid_mesh(last.made.mesh, type), "");
    EXPECT_GT(last.made.mesh.points.size(), 400U);
  }
}

/// The same operations on small solids, with all promises checked at each step.
TEST(ValidMesh, ChainsOfOperationsStayValid) {
  Nef3 set = solid(box_mesh({-1, -1, -1}, {1, 1, 1}));
  for (int step = 1; step <= 4; ++step) {
    const Nef3 next = solid(turned(box_mesh({-1, -1, -1}, {1, 1, 1}), 0.1 * step));
    const ValidMesh valid = checked(set + next, CoordinateType::Double, MeshFaces::PlanarPolygons);
    set = Nef3::from_mesh(valid.made.mesh);
  }
}

TEST(ValidMesh, UnboundedSetsAndLargeNumbersAreRefused) {
  EXPECT_TRUE(valid_mesh(Nef3::whole()).made.report.is_unbounded);
  const Nef3 huge = solid(box_mesh({0, 0, 0}, {1e39, 1, 1}));
  EXPECT_THROW(static_cast<void>(valid_mesh(huge, {}, CoordinateType::Float)), Error);
  EXPECT_EQ(valid_mesh(huge).repair.rounds, 0U);
}

TEST(ValidMesh, FloatsRoundToTheNearest) {
  EXPECT_EQ(nearest_coordinate(1 + 0x1p-30, CoordinateType::Float), 1);
  EXPECT_EQ(nearest_coordinate(3.40282347e38, CoordinateType::Float), 0x1.fffffep127);
  EXPECT_THROW(nearest_coordinate(0x1.ffffffp127, CoordinateType::Float), Error);
  EXPECT_THROW(nearest_coordinate(HUGE_VAL, CoordinateType::Double), Error);
}

}  // namespace
}  // namespace plumb::valid_mesh_test
