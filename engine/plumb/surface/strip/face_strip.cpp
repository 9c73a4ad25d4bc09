// Layouts of faces in the plane and strips of faces.
//
// A triangle is laid out from two placed corners and the three lengths and products of its sides in
// space, so layouts need no angles; positions are scaled by a power of two beforehand, so no
// product overflows. StripFinder runs A* over the dual graph with distances between centroids (P.
// E. Hart, N. J. Nilsson, B. Raphael, IEEE Transactions on Systems Science and Cybernetics 4,
// 1968). The straight distance to the goal never exceeds the distance along centroids, so the strip
// is the shortest by this measure. Visits carry the number of their round, so nothing is cleared
// between searches.
// Tested by tests/surface/trace_test.cpp.
#include "plumb/surface/strip/face_strip.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "plumb/predicates/arithmetic/vectors.h"

namespace plumb {
namespace {

Point3 operator-(const Point3& a, const Point3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
double length(const Point3& a) { return std::sqrt(dot(a, a)); }

/// Returns the third corner of a triangle, to the right of the line from a to b.
Point2 third_corner(std::span<const Point3> positions, Point2 a, Point2 b, VertexId va, VertexId vb,
                    VertexId vc) {
  const Point3 along = positions[vb.value()] - positions[va.value()];
  const Point3 to = positions[vc.value()] - positions[va.value()];
  const double square = dot(along, along);
  if (square == 0) return {a.x + length(to), a.y};
  const double s = dot(along, to) / square, h = length(cross(along, to)) / square;
  const double x = b.x - a.x, y = b.y - a.y;
  return {a.x + s * x + h * y, a.y + s * y - h * x};
}

}  // namespace

ScaledPositions scaled_positions(const SurfaceMesh& mesh) {
  double largest = 0;
  for (std::uint32_t v = 0; v < mesh.vertex_count(); ++v) {
    const Point3& p = mesh.point(VertexId(v));
    largest = std::max({largest, std::fabs(p.x), std::fabs(p.y), std::fabs(p.z)});
  }
  ScaledPositions scaled;
  std::frexp(largest, &scaled.exponent);
  scaled.at.reserve(mesh.vertex_count());
  for (std::uint32_t v = 0; v < mesh.vertex_count(); ++v) {
    const Point3& p = mesh.point(VertexId(v));
    scaled.at.push_back({std::ldexp(p.x, -scaled.exponent), std::ldexp(p.y, -scaled.exponent),
                         std::ldexp(p.z, -scaled.exponent)});
  }
  return scaled;
}

FaceCorners laid_out(const SurfaceMesh& mesh, std::span<const Point3> positions, FaceId f,
                     std::size_t first) {
  const std::size_t second = (first + 1) % 3, third = (first + 2) % 3;
  const VertexId a = mesh.corner(f, first), b = mesh.corner(f, second), c = mesh.corner(f, third);
  FaceCorners corners;
  corners[second] = {length(positions[b.value()] - positions[a.value()]), 0};
  corners[third] = third_corner(positions, corners[second], corners[first], b, a, c);
  return corners;
}

/// The ends of the door are already placed. In the new face, they have the opposite order, and the
/// third corner lies beyond the door.
FaceCorners laid_out_across(const SurfaceMesh& mesh, std::span<const Point3> positions,
                            const FaceCorners& corners, HalfedgeId door) {
  const std::size_t side = SurfaceMesh::side(door);
  const Point2 right = corners[side], left = corners[(side + 1) % 3];
  const HalfedgeId twin = mesh.twin(door);
  const std::size_t k = SurfaceMesh::side(twin);
  FaceCorners beyond;
  beyond[k] = left;
  beyond[(k + 1) % 3] = right;
  beyond[(k + 2) % 3] = third_corner(positions, right, left, mesh.origin(door), mesh.target(door),
                                     mesh.corner(SurfaceMesh::face(twin), (k + 2) % 3));
  return beyond;
}

double corner_angle(const SurfaceMesh& mesh, std::span<const Point3> positions, HalfedgeId h) {
  const Point3& p = positions[mesh.origin(h).value()];
  const Point3 a = positions[mesh.target(h).value()] - p;
  const Point3 b = positions[mesh.origin(SurfaceMesh::prev(h)).value()] - p;
  return std::atan2(length(cross(a, b)), dot(a, b));
}

std::array<double, 3> weights_in(const SurfacePointTable& table, SurfacePointId p, FaceId f) {
  const Point2 at = table.approx(p);
  if (table.place(p) == SurfacePlace::Face) return {1 - at.x - at.y, at.x, at.y};
  const SurfaceMesh& mesh = table.mesh();
  const bool is_vertex = table.place(p) == SurfacePlace::Vertex;
  const VertexId low = is_vertex ? table.vertex(p) : mesh.lower(table.edge(p));
  const VertexId high = is_vertex ? low : mesh.upper(table.edge(p));
  std::array<double, 3> weights{};
  for (std::size_t k = 0; k < 3; ++k) {
    const VertexId v = mesh.corner(f, k);
    weights[k] = v == low ? 1 - at.x : v == high ? at.x : 0;
  }
  return weights;
}

namespace {

constexpr std::uint32_t kFacesPerCheckpoint = 4096;

double distance(const Point3& a, const Point3& b) {
  return std::hypot(a.x - b.x, a.y - b.y, a.z - b.z);
}

}  // namespace

std::vector<FaceId> faces_at(const SurfacePointTable& points, SurfacePointId p) {
  const SurfaceMesh& mesh = points.mesh();
  std::vector<FaceId> faces;
  switch (points.place(p)) {
    case SurfacePlace::Face:
      return {points.face(p)};
    case SurfacePlace::Edge: {
      const HalfedgeId h = mesh.halfedge(points.edge(p)), t = mesh.twin(h);
      faces.push_back(SurfaceMesh::face(h));
      if (t.is_valid()) faces.push_back(SurfaceMesh::face(t));
      return faces;
    }
    case SurfacePlace::Vertex:
      for_halfedges_from(mesh, points.vertex(p),
                         [&](HalfedgeId h) { faces.push_back(SurfaceMesh::face(h)); });
  }
  return faces;
}

StripFinder::StripFinder(const SurfaceMesh& mesh, std::span<const Point3> positions)
    : mesh_(mesh), positions_(positions), visits_(mesh.face_count()) {}

Point3 StripFinder::centroid(FaceId f) const {
  Point3 sum;
  for (std::uint32_t k = 0; k < 3; ++k) {
    const Point3& p = positions_[mesh_.corner(f, k).value()];
    sum = {sum.x + p.x, sum.y + p.y, sum.z + p.z};
  }
  return {sum.x / 3, sum.y / 3, sum.z / 3};
}

// ---------------------------------------------------------------- over the dual graph

/// Stores the cost of a face if it is lower than the cost so far. The heap may contain older
/// entries of a face, which are skipped when they are reached.
void StripFinder::offer(FaceId f, double cost, HalfedgeId door) {
  Visit& v = visit(f);
  if (v.round == round_ && (v.is_done || v.cost <= cost)) return;
  v = {round_, false, cost, door, 0};
  heap_.push_back({cost + distance(centroid(f), goal_), f});
  std::ranges::push_heap(heap_, is_later);
}

std::optional<FaceStrip> StripFinder::find(const StripEnd& from, const StripEnd& to,
                                           Context& context) {
  ++round_;
  heap_.clear();
  goal_ = to.at;
  for (const FaceId f : faces_at(*from.table, from.point)) {
    offer(f, distance(from.at, centroid(f)), HalfedgeId());
  }
  for (std::uint32_t steps = 0; !heap_.empty(); ++steps) {
    if (steps % kFacesPerCheckpoint == 0) context.checkpoint("trace", 0, 1);
    std::ranges::pop_heap(heap_, is_later);
    const FaceId f = heap_.back().face;
    heap_.pop_back();
    if (std::exchange(visit(f).is_done, true)) continue;
    if (to.lies_in(f)) return collected(f);
    const Point3 here = centroid(f);
    const double cost = visit(f).cost;
    for (std::uint32_t k = 0; k < 3; ++k) {
      const HalfedgeId door = SurfaceMesh::halfedge(f, k), twin = mesh_.twin(door);
      if (!twin.is_valid()) continue;
      const FaceId next = SurfaceMesh::face(twin);
      offer(next, cost + distance(here, centroid(next)), door);
    }
  }
  return {};
}

FaceStrip StripFinder::collected(FaceId last) const {
  FaceStrip strip;
  FaceId f = last;
  for (HalfedgeId door = visits_[f].door; door.is_valid(); door = visits_[f].door) {
    strip.doors.push_back(door);
    f = SurfaceMesh::face(door);
  }
  std::ranges::reverse(strip.doors);
  strip.first = f;
  return strip;
}

// ---------------------------------------------------------------- cutting short

// Keeps the faces from the last face that contains the start to the first face after it that
// contains the end, and jumps from each face to its last place in the strip.
void StripFinder::shorten(FaceStrip& strip, const StripEnd& from, const StripEnd& to) {
  std::vector<FaceId> faces{strip.first};
  for (const HalfedgeId door : strip.doors) faces.push_back(SurfaceMesh::face(mesh_.twin(door)));
  std::size_t begin = faces.size() - 1, end = 0;
  while (begin > 0 && !from.lies_in(faces[begin])) --begin;
  for (end = begin; end + 1 < faces.size() && !to.lies_in(faces[end]);) ++end;
  ++round_;
  for (std::size_t i = begin; i <= end; ++i) {
    visit(faces[i]) = {round_, false, 0, HalfedgeId(), static_cast<std::uint32_t>(i)};
  }
  std::vector<HalfedgeId> kept;
  for (std::size_t i = visit(faces[begin]).last; i < end; i = visit(faces[i + 1]).last) {
    kept.push_back(strip.doors[i]);
  }
  strip.first = faces[begin];
  strip.doors = std::move(kept);
}

std::optional<std::vector<HalfedgeId>> doors_around(const SurfaceMesh& mesh, HalfedgeId from,
                                                    FaceId to, bool clockwise) {
  std::vector<HalfedgeId> doors;
  for (HalfedgeId h = from; SurfaceMesh::face(h) != to;) {
    const HalfedgeId door = clockwise ? h : SurfaceMesh::prev(h), twin = mesh.twin(door);
    if (!twin.is_valid()) return {};
    doors.push_back(door);
    h = clockwise ? SurfaceMesh::next(twin) : twin;
    if (h == from) return {};
  }
  return doors;
}

}  // namespace plumb
