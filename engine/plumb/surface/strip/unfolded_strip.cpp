// The shortest path in a strip of faces laid out in the plane, and exact crossings of flat runs.
//
// The path is found by the funnel algorithm (D. T. Lee and F. P. Preparata, Euclidean shortest
// paths in the presence of rectilinear barriers, Networks 14, 1984): from an apex the doors seen so
// far form a wedge between a left and a right ray, and where one ray would cross the other the path
// bends at a vertex, which becomes the next apex. A bend with less than half a turn on its other
// side can be shortened by leading the strip around there (turns()).
//
// Everything is in doubles, with one exception: if all faces of a run between two bends lie in one
// plane and face the same way, by exact predicates, flat_run() computes the crossings in rationals,
// from areas in a coordinate plane. So lines that coincide on a flat part of a mesh coincide
// exactly.
// Tested by tests/surface/trace_test.cpp.
#include "plumb/surface/strip/unfolded_strip.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "plumb/predicates/input_predicates.h"
#include "plumb/predicates/rounding.h"

namespace plumb {
namespace {

constexpr std::size_t kDoors = 1024;  // This is the number of doors between checkpoints.

/// The plane of a face, seen along a coordinate axis that is not parallel to it.
class FlatView {
 public:
  FlatView(const SurfaceMesh& mesh, FaceId f) : mesh_(mesh), corners_(corners(f)) {
    for (dropped_ = 0; dropped_ < 3 && turn(f) == Sign::Zero;) ++dropped_;
    if (dropped_ < 3) turn_ = turn(f);
  }

  bool is_valid() const { return dropped_ < 3; }
  /// Whether a face that shares a side with a face in this plane lies in the plane, too, and faces
  /// the same way.
  bool has(FaceId f) const {
    for (const Point3& p : corners(f)) {
      if (orient3d(corners_[0], corners_[1], corners_[2], p) != Sign::Zero) return false;
    }
    return turn(f) == turn_;
  }
  RationalPoint2 at(VertexId v) const {
    const Point2 p = seen(mesh_.point(v));
    return {exact_rational(p.x), exact_rational(p.y)};
  }
  RationalPoint2 at(const SurfacePointTable& points, SurfacePointId p, FaceId f) const {
    const RationalPoint2 w = points.exact_in(p, f);
    const RationalPoint2 a = at(mesh_.corner(f, 0)), b = at(mesh_.corner(f, 1)),
                         c = at(mesh_.corner(f, 2));
    return {a.x + w.x * (b.x - a.x) + w.y * (c.x - a.x),
            a.y + w.x * (b.y - a.y) + w.y * (c.y - a.y)};
  }

 private:
  std::array<Point3, 3> corners(FaceId f) const {
    return {mesh_.point(mesh_.corner(f, 0)), mesh_.point(mesh_.corner(f, 1)),
            mesh_.point(mesh_.corner(f, 2))};
  }
  Point2 seen(const Point3& p) const {
    return dropped_ == 0 ? Point2{p.y, p.z} : dropped_ == 1 ? Point2{p.z, p.x} : Point2{p.x, p.y};
  }
  Sign turn(FaceId f) const {
    const std::array<Point3, 3> c = corners(f);
    return orient2d(seen(c[0]), seen(c[1]), seen(c[2]));
  }

  const SurfaceMesh& mesh_;
  std::array<Point3, 3> corners_;
  int dropped_ = 0;  // The coordinate that is dropped, or 3 if the face has no area.
  Sign turn_ = Sign::Zero;
};

/// Returns twice the signed area of the triangle a, a + along, p.
Rational area(const RationalPoint2& a, const RationalPoint2& along, const RationalPoint2& p) {
  return along.x * (p.y - a.y) - along.y * (p.x - a.x);
}

}  // namespace

std::optional<std::vector<Rational>> flat_run(const SurfacePointTable& points,
                                              std::span<const HalfedgeId> doors,
                                              const FlatRunEnd& from, const FlatRunEnd& to,
                                              Context& context) {
  const SurfaceMesh& mesh = points.mesh();
  if (doors.empty()) return {};
  const FaceId first = SurfaceMesh::face(doors.front());
  const FaceId last = SurfaceMesh::face(mesh.twin(doors.back()));
  const FlatView view(mesh, first);
  if (!view.is_valid()) return {};
  for (const HalfedgeId door : doors) {
    if (!view.has(SurfaceMesh::face(mesh.twin(door)))) return {};
  }
  const auto end_at = [&](const FlatRunEnd& end, FaceId f) {
    return end.vertex.is_valid() ? view.at(end.vertex) : view.at(points, end.point, f);
  };
  const RationalPoint2 a = end_at(from, first), b = end_at(to, last);
  const RationalPoint2 along{b.x - a.x, b.y - a.y};
  std::vector<Rational> parts;
  parts.reserve(doors.size());
  for (const HalfedgeId door : doors) {
    if (parts.size() % kDoors == 0) context.checkpoint("trace", parts.size(), doors.size());
    const Rational origin = area(a, along, view.at(mesh.origin(door)));
    const Rational target = area(a, along, view.at(mesh.target(door)));
    if (origin * target >= 0) return {};
    parts.push_back(origin / (origin - target));
  }
  return parts;
}

namespace {

using layout::combined;
using layout::cross;
using layout::dot;
using layout::length;
using layout::operator-;  // NOLINT(misc-unused-using-decls): it is used

// A path passes through a vertex if it is closer than this part of the length of the side.
constexpr double kClose = 0x1p-40;
// In radians. If the angle of a bend is less than a half turn by at most this amount, the bend
// stays.
constexpr double kFlat = 1e-9;

double angle(Point2 a, Point2 b) { return std::fabs(std::atan2(cross(a, b), dot(a, b))); }

}  // namespace

UnfoldedStrip::UnfoldedStrip(const SurfaceMesh& mesh, std::span<const Point3> positions,
                             const FaceStrip& strip, const StripEnd& from, const StripEnd& to)
    : mesh_(mesh), positions_(positions), strip_(strip) {
  lay_out(from, to);
  pull();
}

// ---------------------------------------------------------------- laying out

/// Places the faces one after the other. Stores the left and the right end of each door, as seen
/// along the strip.
void UnfoldedStrip::lay_out(const StripEnd& from, const StripEnd& to) {
  FaceId f = strip_.first;
  FaceCorners corners = laid_out(mesh_, positions_, f, 0);
  StripStop start, end;
  start.at = combined(corners, weights_in(*from.table, from.point, f));
  for (const HalfedgeId door : strip_.doors) {
    const std::size_t side = SurfaceMesh::side(door);
    right_.push_back(corners[side]);
    left_.push_back(corners[(side + 1) % 3]);
    corners = laid_out_across(mesh_, positions_, corners, door);
    f = SurfaceMesh::face(mesh_.twin(door));
  }
  end.at = combined(corners, weights_in(*to.table, to.point, f));
  end.door = end.first = end.last = static_cast<std::uint32_t>(strip_.doors.size());
  bends_ = {start, end};
}

// ---------------------------------------------------------------- the funnel

/// A vertex lies in all consecutive doors that have it as an end, and in the faces between them.
StripStop UnfoldedStrip::vertex_stop(std::size_t door, bool is_left) const {
  StripStop stop;
  stop.at = is_left ? left_[door] : right_[door];
  stop.vertex = is_left ? left_vertex(door) : right_vertex(door);
  stop.is_left = is_left;
  std::size_t first = door, last = door;
  while (first > 0 && has(first - 1, stop.vertex)) --first;
  while (last + 1 < right_.size() && has(last + 1, stop.vertex)) ++last;
  stop.door = static_cast<std::uint32_t>(door);
  stop.first = static_cast<std::uint32_t>(first);
  stop.last = static_cast<std::uint32_t>(last + 1);
  return stop;
}

/// Shortens the path. The funnel is the region that is visible from the apex, between a left and a
/// right ray. If one ray would cross the other, the path bends, and the search continues from
/// there.
void UnfoldedStrip::pull() {
  const StripStop end = bends_.back();
  bends_.pop_back();
  const std::size_t doors = right_.size();
  Point2 apex = bends_.front().at, left = apex, right = apex;
  std::size_t left_door = 0, right_door = 0;
  const auto bend = [&](std::size_t& i, std::size_t door, bool is_left) {
    bends_.push_back(vertex_stop(door, is_left));
    apex = left = right = bends_.back().at;
    left_door = right_door = i = door;
  };
  for (std::size_t i = 0; i <= doors; ++i) {
    const Point2 r = i < doors ? right_[i] : end.at, l = i < doors ? left_[i] : end.at;
    if (right == apex || cross(right - apex, r - apex) >= 0) {
      if (right != apex && left != apex && cross(left - apex, r - apex) > 0) {
        bend(i, left_door, true);
        continue;
      }
      right = r;
      right_door = i;
    }
    if (left == apex || cross(left - apex, l - apex) <= 0) {
      if (left != apex && right != apex && cross(right - apex, l - apex) < 0) {
        bend(i, right_door, false);
        continue;
      }
      left = l;
      left_door = i;
    }
  }
  bends_.push_back(end);
}

double UnfoldedStrip::path_length() const {
  double sum = 0;
  for (std::size_t i = 1; i < bends_.size(); ++i) sum += length(bends_[i].at - bends_[i - 1].at);
  return sum;
}

// ---------------------------------------------------------------- turns

/// Returns the faces in which the path arrives at a bend and leaves it.
std::array<std::uint32_t, 2> UnfoldedStrip::faces_at(std::size_t i) const {
  const StripStop& v = bends_[i];
  return {std::clamp(bends_[i - 1].first, v.first, v.last),
          std::clamp(bends_[i + 1].first, v.first, v.last)};
}

/// Returns the angle at a bend on the side of the strip, from the part of the path before the bend
/// to the part after it.
double UnfoldedStrip::strip_angle(std::size_t i) const {
  const StripStop &a = bends_[i - 1], &v = bends_[i], &b = bends_[i + 1];
  const auto [first, last] = faces_at(i);
  const auto other = [&](std::size_t door) {
    return (left_vertex(door) == v.vertex ? right_[door] : left_[door]) - v.at;
  };
  double sum = angle(a.at - v.at, other(first));
  for (std::size_t d = first; d + 1 < last; ++d) sum += angle(other(d), other(d + 1));
  return sum + angle(other(last - 1), b.at - v.at);
}

double UnfoldedStrip::full_angle(VertexId v) const {
  double sum = 0;
  for_halfedges_from(mesh_, v, [&](HalfedgeId h) {
    if (mesh_.is_border(h) || mesh_.is_border(SurfaceMesh::prev(h))) {
      sum = std::numeric_limits<double>::infinity();
    }
    sum += corner_angle(mesh_, positions_, h);
  });
  return sum;
}

std::vector<StripTurn> UnfoldedStrip::turns() const {
  std::vector<StripTurn> turns;
  for (std::size_t i = 1; i + 1 < bends_.size(); ++i) {
    const auto [first, last] = faces_at(i);
    if (last <= first) continue;
    const StripStop& v = bends_[i];
    const double gain = std::numbers::pi - (full_angle(v.vertex) - strip_angle(i));
    if (gain > kFlat) turns.push_back({v.vertex, first, last, v.is_left, gain});
  }
  return turns;
}

// ---------------------------------------------------------------- stops

double UnfoldedStrip::part_on(std::size_t door, Point2 a, Point2 b) const {
  const double right = cross(b - a, right_[door] - a), left = cross(b - a, left_[door] - a);
  return left > right ? std::clamp(-right / (left - right), 0., 1.) : 0;
}

std::uint32_t UnfoldedStrip::first_vertex_door(const StripStop& a, const StripStop& b) const {
  std::uint32_t door = a.last;
  for (; door < b.first; ++door) {
    const double part = part_on(door, a.at, b.at);
    if (part < kClose || part > 1 - kClose) break;
  }
  return door;
}

/// Appends the stops after a up to b, including b. A part of the path along a mesh line passes
/// through all vertices of the line. They may be many, so there is no recursion.
void UnfoldedStrip::add_stops(const StripStop& a, const StripStop& b,
                              std::vector<StripStop>& stops) const {
  std::vector<StripStop> ahead{b};
  for (StripStop at = a; !ahead.empty();) {
    const StripStop to = ahead.back();
    const std::uint32_t close = first_vertex_door(at, to);
    if (close < to.first) {
      ahead.push_back(vertex_stop(close, part_on(close, at.at, to.at) > .5));
      continue;
    }
    for (std::uint32_t door = at.last; door < to.first; ++door) {
      const double part = part_on(door, at.at, to.at);
      const Point2 &r = right_[door], &l = left_[door];
      stops.push_back({{r.x + part * (l.x - r.x), r.y + part * (l.y - r.y)},
                       VertexId(),
                       door,
                       part,
                       door,
                       door + 1,
                       false});
    }
    stops.push_back(to);
    ahead.pop_back();
    at = to;
  }
}

std::vector<StripStop> UnfoldedStrip::stops() const {
  std::vector<StripStop> stops{bends_.front()};
  for (std::size_t i = 1; i < bends_.size(); ++i) add_stops(bends_[i - 1], bends_[i], stops);
  return stops;
}

}  // namespace plumb
