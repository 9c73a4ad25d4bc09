#include "plumb/surface/face_strip.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace plumb {
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
  for (HalfedgeId door = visits_[f.value()].door; door.is_valid(); door = visits_[f.value()].door) {
    strip.doors.push_back(door);
    f = SurfaceMesh::face(door);
  }
  std::ranges::reverse(strip.doors);
  strip.first = f;
  return strip;
}

// ---------------------------------------------------------------- cutting short

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
