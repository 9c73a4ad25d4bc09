// Checks shortest paths in strips of flat meshes against a search over all lines of sight, and
// straight runs against exact sides of the line.
#include "plumb/surface/strip/unfolded_strip.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <vector>

#include "generate/surface_scenes.h"
#include "plumb/predicates/rounding.h"
#include "plumb/testing/dice.h"

namespace plumb::unfolded_strip_test {

using testing::Dice;
using testing::MeshPointer;

double turn(const Point3& a, const Point3& b, const Point3& p) {
  return (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
}
double distance(const Point3& a, const Point3& b) { return std::hypot(b.x - a.x, b.y - a.y); }

/// A strip of different faces of a flat grid, with a point inside the first and the last one. All
/// coordinates are short, so that signs in doubles are exact.
struct Walk {
  MeshPointer mesh;
  SurfacePointTable points;
  std::vector<Point3> at;
  FaceStrip strip;
  StripEnd from, to;

  Walk(Dice& dice, std::uint64_t shuffle, std::size_t most = 30)
      : mesh(testing::grid_mesh(4, 4, shuffle)), points(*mesh) {
    for (std::uint32_t v = 0; v < mesh->vertex_count(); ++v) {
      at.push_back(mesh->point(VertexId(v)));
    }
    FaceId f(dice.below(mesh->face_count()));
    strip.first = f;
    std::set<FaceId> seen{f};
    from = end(f, dice);
    for (int tries = 0; tries < 40 && strip.doors.size() < most; ++tries) {
      const HalfedgeId door = SurfaceMesh::halfedge(f, dice.below(3));
      if (mesh->is_border(door)) continue;
      const FaceId next = SurfaceMesh::face(mesh->twin(door));
      if (!seen.insert(next).second) continue;
      strip.doors.push_back(door);
      f = next;
    }
    to = end(f, dice);
  }
  StripEnd end(FaceId f, Dice& dice) {
    const double u = static_cast<double>(dice.between(1, 2)) / 4;
    const SurfacePointId p = points.add_in_face(f, u, 0.25);
    return {&points, p, points.position(p)};
  }
  Point3 right(std::size_t door) const { return at[mesh->origin(strip.doors[door]).value()]; }
  Point3 left(std::size_t door) const { return at[mesh->target(strip.doors[door]).value()]; }
  UnfoldedStrip unfolded() const { return {*mesh, at, strip, from, to}; }
  /// Where a stop of the path lies in the plane of the mesh.
  Point3 place(const StripStop& stop, bool is_first, bool is_last) const {
    if (is_first) return from.at;
    if (is_last) return to.at;
    if (stop.vertex.is_valid()) return at[stop.vertex.value()];
    const Point3 r = right(stop.door), l = left(stop.door);
    return {r.x + stop.part * (l.x - r.x), r.y + stop.part * (l.y - r.y), 0};
  }
  std::vector<Point3> places(const std::vector<StripStop>& stops) const {
    std::vector<Point3> result;
    for (std::size_t i = 0; i < stops.size(); ++i) {
      result.push_back(place(stops[i], i == 0, i + 1 == stops.size()));
    }
    return result;
  }
};

bool have_common_point(const Point3& a, const Point3& b, const Point3& c, const Point3& d) {
  const double of_c = turn(a, b, c), of_d = turn(a, b, d);
  const double of_a = turn(c, d, a), of_b = turn(c, d, b);
  if (of_c * of_d > 0 || of_a * of_b > 0) return false;
  return std::max(a.x, b.x) >= std::min(c.x, d.x) && std::max(c.x, d.x) >= std::min(a.x, b.x) &&
         std::max(a.y, b.y) >= std::min(c.y, d.y) && std::max(c.y, d.y) >= std::min(a.y, b.y);
}

/// The length of a shortest path over corners of doors, each step in sight of the one before.
double shortest(const Walk& walk) {
  struct Node {
    Point3 at;
    std::size_t door;
    double cost;
  };
  const std::size_t n = walk.strip.doors.size();
  std::vector<Node> nodes{{walk.from.at, 0, 0}};
  const double infinite = std::numeric_limits<double>::infinity();
  for (std::size_t d = 0; d < n; ++d) {
    nodes.push_back({walk.right(d), d, infinite});
    nodes.push_back({walk.left(d), d, infinite});
  }
  nodes.push_back({walk.to.at, n, infinite});
  for (std::size_t j = 1; j < nodes.size(); ++j) {
    for (std::size_t i = 0; i < j; ++i) {
      bool sees = true;
      for (std::size_t d = i == 0 ? 0 : nodes[i].door + 1; d < nodes[j].door; ++d) {
        sees = sees && have_common_point(nodes[i].at, nodes[j].at, walk.right(d), walk.left(d));
      }
      if (!sees) continue;
      nodes[j].cost = std::min(nodes[j].cost, nodes[i].cost + distance(nodes[i].at, nodes[j].at));
    }
  }
  return nodes.back().cost;
}

TEST(UnfoldedStrip, PathsAreShortestAmongAllLinesOfSight) {
  Dice dice(1);
  int bent = 0;
  for (int round = 0; round < 150; ++round) {
    const Walk walk(dice, static_cast<std::uint64_t>(round));
    const double length = walk.unfolded().path_length();
    EXPECT_NEAR(length, shortest(walk), 1e-9) << round;
    if (length > distance(walk.from.at, walk.to.at) + 1e-9) ++bent;
  }
  EXPECT_GT(bent, 30);
}

TEST(UnfoldedStrip, StopsFollowThePathThroughAllDoors) {
  Dice dice(2);
  for (int round = 0; round < 150; ++round) {
    const Walk walk(dice, static_cast<std::uint64_t>(round));
    const UnfoldedStrip unfolded = walk.unfolded();
    const std::vector<StripStop> stops = unfolded.stops();
    const std::vector<Point3> places = walk.places(stops);
    double length = 0;
    for (std::size_t i = 1; i < stops.size(); ++i) {
      length += distance(places[i - 1], places[i]);
      EXPECT_LE(stops[i - 1].door, stops[i].door);
    }
    EXPECT_NEAR(length, unfolded.path_length(), 1e-9);
    for (std::uint32_t d = 0; d < walk.strip.doors.size(); ++d) {
      EXPECT_TRUE(std::ranges::any_of(stops, [&](const StripStop& s) {
        return s.vertex.is_valid() ? s.first <= d && d < s.last : s.door == d && s.last > d;
      }));
    }
    for (const StripStop& s : stops) {
      if (!s.vertex.is_valid()) continue;
      for (std::uint32_t d = s.first; d < s.last; ++d) {  // all its doors end in it
        const HalfedgeId door = walk.strip.doors[d];
        EXPECT_EQ(s.is_left ? walk.mesh->target(door) : walk.mesh->origin(door), s.vertex);
      }
    }
  }
}

/// In a plane the other side of a bend is less than half a turn by as much as the path bends.
TEST(UnfoldedStrip, TurnsAreTheBendsAtInnerVertices) {
  Dice dice(3);
  std::size_t found = 0;
  for (int round = 0; round < 150; ++round) {
    const Walk walk(dice, static_cast<std::uint64_t>(round));
    const UnfoldedStrip unfolded = walk.unfolded();
    const std::vector<StripStop> stops = unfolded.stops();
    const std::vector<Point3> places = walk.places(stops);
    const std::vector<StripTurn> turns = unfolded.turns();
    std::size_t next = 0;
    for (std::size_t i = 1; i + 1 < stops.size(); ++i) {
      const Point3 &a = places[i - 1], &v = places[i], &b = places[i + 1];
      const double bend = std::fabs(
          std::atan2(turn(a, v, b), (v.x - a.x) * (b.x - v.x) + (v.y - a.y) * (b.y - v.y)));
      const bool is_border = v.x == 0 || v.y == 0 || v.x == 4 || v.y == 4;
      if (!stops[i].vertex.is_valid() || is_border || bend < 1e-6) continue;
      ASSERT_LT(next, turns.size());
      EXPECT_EQ(turns[next].vertex, stops[i].vertex);
      EXPECT_EQ(turns[next].is_left, turn(a, v, b) > 0);
      EXPECT_NEAR(turns[next].gain, bend, 1e-9);
      ++next;
    }
    EXPECT_EQ(next, turns.size());
    found += next;
  }
  EXPECT_GT(found, 20U);
}

TEST(UnfoldedStrip, StraightRunsCrossDoorsOnTheLine) {
  Dice dice(4);
  int straight = 0;
  for (int round = 0; round < 300; ++round) {
    const Walk walk(dice, static_cast<std::uint64_t>(round), 1 + dice.below(4));
    if (walk.strip.doors.empty()) continue;
    FlatRunEnd from{VertexId(), walk.from.point};
    Point3 start = walk.from.at;
    if (round % 3 == 0) {  // from a corner of the first face
      from.vertex = walk.mesh->corner(walk.strip.first, dice.below(3));
      start = walk.at[from.vertex.value()];
    }
    const auto parts = flat_run(walk.points, walk.strip.doors, from, {VertexId(), walk.to.point},
                                unlimited_context());
    bool crosses = true;
    for (std::size_t d = 0; d < walk.strip.doors.size(); ++d) {
      const double right = turn(start, walk.to.at, walk.right(d));
      const double left = turn(start, walk.to.at, walk.left(d));
      crosses = crosses && right * left < 0;
    }
    ASSERT_EQ(parts.has_value(), crosses);
    if (!parts) continue;
    ++straight;
    ASSERT_EQ(parts->size(), walk.strip.doors.size());
    for (std::size_t d = 0; d < parts->size(); ++d) {
      const auto exact = [](double x) { return exact_rational(x); };
      const Point3 r = walk.right(d), l = walk.left(d), &goal = walk.to.at;
      const Rational& part = (*parts)[d];
      const Rational x = exact(r.x) + part * exact(l.x - r.x);
      const Rational y = exact(r.y) + part * exact(l.y - r.y);
      EXPECT_TRUE(part > 0 && part < 1);
      EXPECT_EQ(exact(goal.x - start.x) * (y - exact(start.y)),
                exact(goal.y - start.y) * (x - exact(start.x)));
    }
  }
  EXPECT_GT(straight, 30);
}

/// Faces that leave the plane, or are folded back onto it, are not flat.
TEST(UnfoldedStrip, RunsOverFoldedFacesAreNotFlat) {
  const auto has_run = [](const Point3& fourth) {
    const SurfaceMesh mesh({{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, fourth}, {{0, 1, 2}, {2, 1, 3}});
    SurfacePointTable points(mesh);
    const FlatRunEnd from{VertexId(), points.add_in_face(FaceId(0), 0.25, 0.25)};
    const FlatRunEnd to{VertexId(), points.add_in_face(FaceId(1), 0.25, 0.25)};
    const HalfedgeId doors[] = {SurfaceMesh::halfedge(FaceId(0), 1)};
    EXPECT_FALSE(flat_run(points, {}, from, to, unlimited_context()).has_value());
    return flat_run(points, doors, from, to, unlimited_context()).has_value();
  };
  EXPECT_TRUE(has_run({4, 4, 0}));
  EXPECT_FALSE(has_run({4, 4, 0x1p-1000}));
  EXPECT_FALSE(has_run({0, 0, 0}));
  EXPECT_FALSE(has_run({1, 1, 0}));
}

}  // namespace plumb::unfolded_strip_test
