// Checks triangles laid out in the plane against lengths and angles in space, and strips of faces
// against a search over all pairs of neighbours.
#include "plumb/surface/strip/face_strip.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <set>
#include <vector>

#include "generate/surface_scenes.h"
#include "plumb/testing/dice.h"

namespace plumb::face_strip_test {

using testing::Dice;
using testing::MeshPointer;

std::vector<MeshPointer> meshes() {
  return {testing::grid_mesh(4, 3, 5), testing::torus_mesh(6, 5), testing::cylinder_mesh(6, 3)};
}

double distance(const Point3& a, const Point3& b) {
  return std::hypot(a.x - b.x, a.y - b.y, a.z - b.z);
}
double distance(const Point2& a, const Point2& b) { return std::hypot(a.x - b.x, a.y - b.y); }

void expect_lengths(const SurfaceMesh& mesh, const std::vector<Point3>& at, FaceId f,
                    const FaceCorners& corners) {
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    EXPECT_NEAR(distance(corners[i], corners[j]),
                distance(at[mesh.corner(f, i).value()], at[mesh.corner(f, j).value()]), 1e-12);
  }
  const Point2 &a = corners[0], &b = corners[1], &c = corners[2];
  EXPECT_GT((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x), 0);
}

TEST(FaceStrip, PositionsAreScaledByAPowerOfTwoBelowOne) {
  for (const double size : {0x1p-1000, 0.75, 1.0, 3.0, 0x1p1000}) {
    const SurfaceMesh mesh({{size, 0, 0}, {0, -size / 2, 0}, {0, 0, size / 4}}, {{0, 1, 2}});
    const ScaledPositions scaled = scaled_positions(mesh);
    double largest = 0;
    for (std::uint32_t v = 0; v < 3; ++v) {
      const Point3 &p = mesh.point(VertexId(v)), &q = scaled.at[v];
      EXPECT_EQ(std::ldexp(q.x, scaled.exponent), p.x);
      EXPECT_EQ(std::ldexp(q.y, scaled.exponent), p.y);
      EXPECT_EQ(std::ldexp(q.z, scaled.exponent), p.z);
      largest = std::max({largest, std::fabs(q.x), std::fabs(q.y), std::fabs(q.z)});
    }
    EXPECT_TRUE(largest >= 0.5 && largest <= 1);
  }
}

TEST(FaceStrip, FacesLaidOutKeepTheirLengthsSideBySide) {
  for (const MeshPointer& mesh : meshes()) {
    const std::vector<Point3> at = scaled_positions(*mesh).at;
    for (std::uint32_t i = 0; i < 3 * mesh->face_count(); ++i) {
      const HalfedgeId door(i);
      const FaceId f = SurfaceMesh::face(door);
      const std::size_t side = SurfaceMesh::side(door);
      const FaceCorners corners = laid_out(*mesh, at, f, side);
      expect_lengths(*mesh, at, f, corners);
      EXPECT_TRUE(corners[side].x == 0 && corners[side].y == 0);
      EXPECT_TRUE(corners[(side + 1) % 3].x > 0 && corners[(side + 1) % 3].y == 0);
      const HalfedgeId twin = mesh->twin(door);
      if (!twin.is_valid()) continue;
      const FaceId g = SurfaceMesh::face(twin);
      const FaceCorners beyond = laid_out_across(*mesh, at, corners, door);
      expect_lengths(*mesh, at, g, beyond);
      EXPECT_EQ(distance(beyond[SurfaceMesh::side(twin)], corners[(side + 1) % 3]), 0);
      EXPECT_EQ(distance(beyond[(SurfaceMesh::side(twin) + 1) % 3], corners[side]), 0);
    }
  }
}

TEST(FaceStrip, AnglesOfAFaceAddUpToHalfATurn) {
  for (const MeshPointer& mesh : meshes()) {
    const std::vector<Point3> at = scaled_positions(*mesh).at;
    for (std::uint32_t f = 0; f < mesh->face_count(); ++f) {
      double sum = 0;
      for (std::size_t i = 0; i < 3; ++i) {
        const HalfedgeId h = SurfaceMesh::halfedge(FaceId(f), i);
        const double angle = corner_angle(*mesh, at, h);
        const double a = distance(at[mesh->origin(h).value()], at[mesh->target(h).value()]);
        const VertexId third = mesh->origin(SurfaceMesh::prev(h));
        const double b = distance(at[mesh->origin(h).value()], at[third.value()]);
        const double c = distance(at[mesh->target(h).value()], at[third.value()]);
        EXPECT_NEAR(2 * a * b * std::cos(angle), a * a + b * b - c * c, 1e-12);
        sum += angle;
      }
      EXPECT_NEAR(sum, std::numbers::pi, 1e-12);
    }
  }
}

SurfacePointId any_point(SurfacePointTable& points, Dice& dice) {
  const FaceId f(dice.below(points.mesh().face_count()));
  const double u = static_cast<double>(dice.between(0, 4)) / 4;
  return points.add_in_face(f, u, (1 - u) * static_cast<double>(dice.between(0, 2)) / 2);
}

TEST(FaceStrip, PointsLieInFacesWithTheirExactWeights) {
  Dice dice(1);
  for (const MeshPointer& mesh : meshes()) {
    SurfacePointTable points(*mesh);
    for (int round = 0; round < 60; ++round) {
      const SurfacePointId p = any_point(points, dice);
      std::vector<FaceId> faces = faces_at(points, p);
      std::ranges::sort(faces);
      std::vector<FaceId> expected;
      for (std::uint32_t f = 0; f < mesh->face_count(); ++f) {
        if (points.is_in(p, FaceId(f))) expected.emplace_back(f);
      }
      EXPECT_EQ(faces, expected);
      for (const FaceId f : faces) {
        const std::array<double, 3> weights = weights_in(points, p, f);
        const Point2 at = points.approx_in(p, f);
        EXPECT_EQ(weights[1], at.x);
        EXPECT_EQ(weights[2], at.y);
        EXPECT_EQ(weights[0] + weights[1] + weights[2], 1);
      }
    }
  }
}

Point3 centroid(const SurfaceMesh& mesh, const std::vector<Point3>& at, FaceId f) {
  Point3 sum;
  for (std::size_t i = 0; i < 3; ++i) {
    const Point3& p = at[mesh.corner(f, i).value()];
    sum = {sum.x + p.x / 3, sum.y + p.y / 3, sum.z + p.z / 3};
  }
  return sum;
}

/// Faces of a strip, or none if a door does not lead out of the face before it.
std::vector<FaceId> faces_of(const SurfaceMesh& mesh, const FaceStrip& strip) {
  std::vector<FaceId> faces{strip.first};
  for (const HalfedgeId door : strip.doors) {
    if (SurfaceMesh::face(door) != faces.back() || mesh.is_border(door)) return {};
    faces.push_back(SurfaceMesh::face(mesh.twin(door)));
  }
  return faces;
}

double cost_of(const SurfaceMesh& mesh, const std::vector<Point3>& at, const Point3& from,
               const std::vector<FaceId>& faces) {
  double sum = distance(from, centroid(mesh, at, faces[0]));
  for (std::size_t i = 1; i < faces.size(); ++i) {
    sum += distance(centroid(mesh, at, faces[i - 1]), centroid(mesh, at, faces[i]));
  }
  return sum;
}

TEST(FaceStrip, StripsAreShortestByCentroidsAndCutShort) {
  Dice dice(2);
  for (const MeshPointer& mesh : meshes()) {
    const std::vector<Point3> at = scaled_positions(*mesh).at;
    const int exponent = scaled_positions(*mesh).exponent;
    SurfacePointTable points(*mesh);
    StripFinder finder(*mesh, at);
    const auto end = [&](SurfacePointId p) {
      const Point3 q = points.position(p);
      return StripEnd{
          &points,
          p,
          {std::ldexp(q.x, -exponent), std::ldexp(q.y, -exponent), std::ldexp(q.z, -exponent)}};
    };
    for (int round = 0; round < 30; ++round) {
      const StripEnd from = end(any_point(points, dice));
      const StripEnd to = end(any_point(points, dice));
      const auto strip = finder.find(from, to, unlimited_context());
      ASSERT_TRUE(strip.has_value());
      const std::vector<FaceId> faces = faces_of(*mesh, *strip);
      ASSERT_FALSE(faces.empty());
      EXPECT_TRUE(from.lies_in(faces.front()) && to.lies_in(faces.back()));

      std::vector<double> cost(mesh->face_count(), std::numeric_limits<double>::infinity());
      for (const FaceId f : faces_at(points, from.point)) {
        cost[f.value()] = distance(from.at, centroid(*mesh, at, f));
      }
      for (bool improves = true; improves;) {
        improves = false;
        for (std::uint32_t i = 0; i < 3 * mesh->face_count(); ++i) {
          if (mesh->is_border(HalfedgeId(i))) continue;
          const FaceId f(i / 3), g = SurfaceMesh::face(mesh->twin(HalfedgeId(i)));
          const double over =
              cost[f.value()] + distance(centroid(*mesh, at, f), centroid(*mesh, at, g));
          if (over >= cost[g.value()]) continue;
          cost[g.value()] = over;
          improves = true;
        }
      }
      // The search ends in the face of the goal with the least way over its centroid.
      EXPECT_NEAR(cost_of(*mesh, at, from.at, faces), cost[faces.back().value()], 1e-9);
      double last = std::numeric_limits<double>::infinity();
      for (const FaceId f : faces_at(points, to.point)) {
        last = std::min(last, cost[f.value()] + distance(centroid(*mesh, at, f), to.at));
      }
      EXPECT_NEAR(cost[faces.back().value()] + distance(centroid(*mesh, at, faces.back()), to.at),
                  last, 1e-9);

      FaceStrip longer = *strip;  // there and back over each side first
      for (std::uint32_t side = 0; side < 3; ++side) {
        const HalfedgeId door = SurfaceMesh::halfedge(longer.first, side);
        if (mesh->is_border(door)) continue;
        longer.doors.insert(longer.doors.begin(), {door, mesh->twin(door)});
      }
      finder.shorten(longer, from, to);
      const std::vector<FaceId> kept = faces_of(*mesh, longer);
      ASSERT_FALSE(kept.empty());
      EXPECT_EQ(std::set<FaceId>(kept.begin(), kept.end()).size(), kept.size());
      EXPECT_TRUE(from.lies_in(kept.front()) && to.lies_in(kept.back()));
      for (std::size_t i = 1; i < kept.size(); ++i) {
        EXPECT_FALSE(from.lies_in(kept[i]));
        EXPECT_FALSE(to.lies_in(kept[i - 1]));
      }
    }
  }
  const MeshPointer parts[] = {testing::grid_mesh(1, 1), testing::grid_mesh(1, 1)};
  const MeshPointer apart = testing::joined_meshes(parts);
  SurfacePointTable points(*apart);
  const StripEnd from{&points, points.add_in_face(FaceId(0), 0.25, 0.25), {}};
  const StripEnd to{&points, points.add_in_face(FaceId(3), 0.25, 0.25), {}};
  const std::vector<Point3> at = scaled_positions(*apart).at;
  EXPECT_FALSE(StripFinder(*apart, at).find(from, to, unlimited_context()).has_value());
}

/// Both ways around an inner vertex cross all its sides once; at the border one way is open.
TEST(FaceStrip, DoorsAroundAVertexLeadToAFaceEitherWay) {
  for (const MeshPointer& mesh : meshes()) {
    for (std::uint32_t v = 0; v < mesh->vertex_count(); ++v) {
      std::vector<HalfedgeId> leaving;
      bool is_at_border = false;
      for_halfedges_from(*mesh, VertexId(v), [&](HalfedgeId h) {
        EXPECT_EQ(mesh->origin(h).value(), v);
        leaving.push_back(h);
        is_at_border |= mesh->is_border(h) || mesh->is_border(SurfaceMesh::prev(h));
      });
      for (const HalfedgeId from : leaving) {
        for (const HalfedgeId goal : leaving) {
          std::size_t found = 0, crossed = 0;
          for (const bool clockwise : {false, true}) {
            const auto doors = doors_around(*mesh, from, SurfaceMesh::face(goal), clockwise);
            if (!doors) continue;
            ++found;
            crossed += doors->size();
            const auto faces = faces_of(*mesh, {SurfaceMesh::face(from), *doors});
            ASSERT_FALSE(faces.empty());
            EXPECT_EQ(faces.back(), SurfaceMesh::face(goal));
            for (const HalfedgeId door : *doors) {
              EXPECT_EQ((clockwise ? mesh->origin(door) : mesh->target(door)).value(), v);
            }
          }
          EXPECT_EQ(found, from == goal || !is_at_border ? 2U : 1U);
          if (from != goal && !is_at_border) {
            EXPECT_EQ(crossed, leaving.size());
          }
        }
      }
    }
  }
}

}  // namespace plumb::face_strip_test
