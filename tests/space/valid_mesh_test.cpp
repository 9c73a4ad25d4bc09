// valid_mesh() on sets that rounding damages: the result is judged by the reader, which must find
// nothing to say of it, and by exact distances from the boundary of the set.
#include "plumb/space/valid_mesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "generate/mesh_solid.h"
#include "generate/meshes.h"
#include "generate/test_share.h"
#include "plumb/predicates/rounding.h"
#include "plumb/testing/dice.h"

namespace plumb::valid_mesh_test {
namespace {

using testing::box_mesh;
using testing::Dice;
using testing::icosphere_mesh;
using testing::moved;
using testing::solid;
using testing::tetrahedron_mesh;
using testing::turned;

using Vector = std::array<Rational, 3>;

Vector minus(const Vector& a, const Vector& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
Rational dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Vector along(const Vector& a, const Vector& d, const Rational& t) {
  return {a[0] + t * d[0], a[1] + t * d[1], a[2] + t * d[2]};
}

/// Returns the squared distance from p to the segment between a and b.
Rational squared_distance(const Vector& p, const Vector& a, const Vector& b) {
  const Vector d = minus(b, a);
  Rational t = dot(minus(p, a), d) / dot(d, d);
  t = std::clamp(t, Rational(0), Rational(1));
  const Vector gap = minus(p, along(a, d, t));
  return dot(gap, gap);
}

/// Returns the squared distance from p to a triangle.
Rational squared_distance(const Vector& p, const std::array<Vector, 3>& t) {
  const Vector u = minus(t[1], t[0]), v = minus(t[2], t[0]), w = minus(p, t[0]);
  const Rational uu = dot(u, u), uv = dot(u, v), vv = dot(v, v), wu = dot(w, u), wv = dot(w, v);
  const Rational det = uu * vv - uv * uv;
  const Rational a = (wu * vv - wv * uv) / det, b = (wv * uu - wu * uv) / det;
  if (a.sign() >= 0 && b.sign() >= 0 && a + b <= 1) {
    const Vector gap = minus(p, along(along(t[0], u, a), v, b));
    return dot(gap, gap);
  }
  return std::min({squared_distance(p, t[0], t[1]), squared_distance(p, t[1], t[2]),
                   squared_distance(p, t[2], t[0])});
}

Vector exact_place(const PolygonMesh& mesh, std::uint32_t v) {
  const auto found =
      std::ranges::lower_bound(mesh.exact, v, {}, [](const auto& e) { return e.first; });
  if (found != mesh.exact.end() && found->first == v) {
    return {found->second.x, found->second.y, found->second.z};
  }
  const Point3& p = mesh.points[v];
  return {exact_rational(p.x), exact_rational(p.y), exact_rational(p.z)};
}

/// Whether every vertex of the mesh is at most as far from the boundary of the set as is claimed.
bool is_near(const ValidMesh& valid, const Nef3& set) {
  const MeshOfComplex exact =
      mesh_of_complex(set.complex(), {.faces = MeshFaces::Triangles, .keeps_exact = true});
  const Rational bound = exact_rational(valid.repair.largest_move);
  for (std::uint32_t v = 0; v < valid.made.mesh.points.size(); ++v) {
    const Vector p = exact_place(valid.made.mesh, v);
    bool is_close = false;
    for (std::size_t f = 0; f < exact.mesh.face_count() && !is_close; ++f) {
      const auto face = exact.mesh.face(f);
      const std::array<Vector, 3> corners = {exact_place(exact.mesh, face[0]),
                                             exact_place(exact.mesh, face[1]),
                                             exact_place(exact.mesh, face[2])};
      is_close = squared_distance(p, corners) <= bound * bound;
    }
    if (!is_close) return false;
  }
  return true;
}

/// What a reader of the mesh has to say of it; empty if nothing.
std::string flaw_of(const PolygonMesh& mesh) {
  const MeshReport report = complex_of_mesh(mesh).report;
  if (!mesh.exact.empty()) return "exact coordinates";
  if (!report.is_closed()) return "open";
  if (report.crosses_itself()) return "crosses itself";
  if (!report.degenerate.empty() || !report.trimmed.empty()) return "faces without area";
  if (!report.doubled.empty()) return "doubled faces";
  if (!report.not_planar.empty() || !report.not_simple.empty()) return "faces that are not flat";
  if (report.vertices_merged > 0) return "equal vertices";
  return "";
}

/// Checks the promises for one set; returns the valid mesh.
ValidMesh checked(const Nef3& set, CoordinateType type, MeshFaces faces) {
  ValidMesh valid = valid_mesh(set, {.faces = faces}, type);
  EXPECT_EQ(flaw_of(valid.made.mesh), "");
  EXPECT_EQ(valid.made.facet.size(), valid.made.mesh.face_count());
  for (const Point3& p : valid.made.mesh.points) {
    for (const double c : {p.x, p.y, p.z}) EXPECT_EQ(c, nearest_coordinate(c, type));
  }
  EXPECT_TRUE(is_near(valid, set));
  // What is read from it and written again stays as it is.
  const Nef3 read = Nef3::from_mesh(valid.made.mesh, {.rule = WindingRule::Positive});
  const ValidMesh again = valid_mesh(read, {.faces = faces}, type);
  EXPECT_EQ(again.repair.rounds, 0U);
  EXPECT_EQ(again.repair.rounded_vertices, 0U);
  EXPECT_TRUE(Nef3::from_mesh(again.made.mesh) == read);
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

/// A set of random boxes and tetrahedra that are nearly in the same places.
Nef3 near_degenerate_set(Dice& dice) {
  const auto corner = [&] {
    const auto coordinate = [&] {
      const double about = static_cast<double>(dice.between(0, 3));
      return about + std::ldexp(static_cast<double>(dice.between(-2, 2)), -52);
    };
    return Point3{coordinate(), coordinate(), coordinate()};
  };
  Nef3 set;
  for (int i = 0; i < 3; ++i) {
    PolygonMesh mesh;
    if (dice.below(2) == 0) {
      mesh = turned(box_mesh(corner(), {4, 4, 4}),
                    std::ldexp(1, -static_cast<int>(dice.between(2, 52))));
    } else {
      mesh = tetrahedron_mesh(corner(), corner(), corner(), corner());
    }
    Nef3 next;
    try {
      next = Nef3::from_mesh(mesh);
    } catch (const Error&) {
      continue;
    }
    const int operation = static_cast<int>(dice.below(3));
    set = i == 0 || operation == 0 ? set + next : operation == 1 ? set - next : set ^ next;
  }
  return set.regularization();
}

TEST(ValidMesh, RandomSetsAreValidNearAndStill) {
  const auto cases = static_cast<int>(testing::share_of(400));
  std::uint64_t repaired = 0;
  for (int i = 0; i < cases && !HasFailure(); ++i) {
    SCOPED_TRACE(i);
    Dice dice(static_cast<std::uint64_t>(i));
    const Nef3 set = near_degenerate_set(dice);
    const auto type = i % 2 == 0 ? CoordinateType::Double : CoordinateType::Float;
    const auto faces = i % 3 == 0 ? MeshFaces::PlanarPolygons : MeshFaces::Triangles;
    repaired += checked(set, type, faces).repair.rounds > 0 ? 1 : 0;
  }
  EXPECT_GT(repaired, static_cast<std::uint64_t>(cases / 20));  // The scenes are hard.
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
  EXPECT_EQ(flaw_of(one.made.mesh), "");
  for (const int exponent : {900, -800}) {
    const ValidMesh other = made_at(exponent);
    EXPECT_EQ(scaled(other.made.mesh, -exponent).points, one.made.mesh.points);
    EXPECT_EQ(other.made.mesh.corners, one.made.mesh.corners);
    EXPECT_EQ(other.repair.rounds, one.repair.rounds);
    EXPECT_EQ(std::ldexp(other.repair.largest_move, -exponent), one.repair.largest_move);
  }
}

/// Three operations in a row, each on what was written before, stay valid.
TEST(ValidMesh, ChainsOfOperationsStayValid) {
  Nef3 set = solid(box_mesh({-1, -1, -1}, {1, 1, 1}));
  for (int step = 1; step <= 6; ++step) {
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
