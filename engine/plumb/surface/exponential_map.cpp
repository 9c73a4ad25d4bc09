// Straight lines on a mesh from a centre in a given direction, and the points where they end.
//
// The face at the centre is laid out in the plane, and every further face beside the previous face
// (strip/face_strip.h), so within the strip the line is straight in the ordinary sense. Steps: aim,
// which turns an angle at the centre into a first face and a direction; cross, from face to face;
// pass, through a vertex, where the line goes on with half of the full angle to each side, or half
// a turn at the border; land, which names the end by weights in its face. This is the notion of a
// straightest geodesic: K. Polthier and M. Schmies, Straightest geodesics on polyhedral surfaces,
// in Mathematical Visualization, Springer (1998).
//
// Everything is computed in doubles, with coordinates that are scaled to at most 1. In spite of
// rounding, the result is a point of a face of the mesh; only its place is approximate. Invariant
// of a crossing: the line enters and leaves a face by different sides, so it advances by one face
// at each step; the number of faces is limited.
// Tested by tests/surface/exponential_map_test.cpp.
#include "plumb/surface/exponential_map.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>
#include <string>

#include "plumb/base/internal/degrees.h"
#include "plumb/predicates/arithmetic/elementary.h"
#include "plumb/predicates/error.h"
#include "plumb/surface/strip/face_strip.h"

namespace plumb {
namespace {

using layout::combined;
using layout::cross;
using layout::dot;
using layout::length;
using layout::operator-;  // NOLINT(misc-unused-using-decls): it is used

constexpr double kPi = std::numbers::pi;
// So small a part of the way, or of a weight, counts as nothing.
constexpr double kClose = 0x1p-40;
// In radians. If an angle differs from a half turn by at most this amount, it counts as a half
// turn.
constexpr double kFlat = 1e-9;
constexpr std::uint64_t kFacesPerCheckpoint = 4096;
constexpr std::uint64_t kMostRounds = 4;
constexpr std::uint64_t kSomeFaces = 1U << 16U;

[[noreturn]] void fail_far(std::uint64_t most_faces) {
  throw Error(ErrorCode::ResourceLimit,
              "so far from the centre that a straight line there would cross more than " +
                  std::to_string(most_faces) + " triangles");
}

Point2 turned(Point2 p, Point2 by) { return {p.x * by.x - p.y * by.y, p.x * by.y + p.y * by.x}; }

}  // namespace

/// The rest of a line, in one face.
struct ExponentialMap::Line {
  FaceId face;
  FaceCorners corners;
  Point2 from;
  Point2 along;
  /// The side by which it entered the face; kInside in its first face.
  std::size_t entry = kInside;
  std::size_t start = kInside;  ///< The corner it starts in, or kInside.

  /// Returns the side of corner k: above zero to the left of the line.
  double side_of(std::size_t k) const { return cross(along, corners[k % 3] - from); }
  /// Returns how far along the line a point lies, as a part of it. Squares are avoided: those of
  /// short lines underflow to zero.
  double part_at(Point2 at) const {
    const double size = length(along);
    return dot({along.x / size, along.y / size}, at - from) / size;
  }
};

ExponentialMap::ExponentialMap(const SurfacePointTable& points, SurfacePointId centre, FaceId face,
                               double angle)
    : mesh_(points.mesh()),
      positions_(scaled_positions(mesh_)),
      face_(face),
      weights_(weights_in(points, centre, face)) {
  PLUMB_CHECK(points.is_in(centre, face));
  if (points.place(centre) == SurfacePlace::Vertex) {
    corner_ = static_cast<std::size_t>(std::ranges::find(weights_, 1.) - weights_.begin());
    const HalfedgeId h = SurfaceMesh::halfedge(face, corner_);
    fan_ = fan_of(mesh_.origin(h));
    angle_before_ = fan_.angle_before(h);
  }
  const Point2 turn = unit_vector(angle);
  x_axis_ = turn;
  if (!mesh_.is_flipped(face)) return;
  const Point2 side = laid_out(mesh_, positions_.at, face, 0)[2];
  const double size = length(side);
  if (size > 0) x_axis_ = turned({side.x / size, side.y / size}, turn);
}

ExponentialMap::Fan ExponentialMap::fan_of(VertexId v) const {
  Fan fan;
  for_halfedges_from(mesh_, v, [&](HalfedgeId h) {
    fan.halfedges.push_back(h);
    fan.angles.push_back(fan.angles.back() + corner_angle(mesh_, positions_.at, h));
    fan.is_at_border =
        fan.is_at_border || mesh_.is_border(h) || mesh_.is_border(SurfaceMesh::prev(h));
  });
  return fan;
}

double ExponentialMap::Fan::angle_before(HalfedgeId h) const {
  return angles[static_cast<std::size_t>(std::ranges::find(halfedges, h) - halfedges.begin())];
}

// ---------------------------------------------------------------- 1. aim

/// Returns the line that leaves the vertex of a fan at an angle. `angle` is measured from the first
/// half-edge of the fan, counter-clockwise, and taken modulo the full angle if there is one.
/// Returns no value if the angle is beyond the border.
std::optional<ExponentialMap::Line> ExponentialMap::aim_from_vertex(const Fan& fan, double angle,
                                                                    double length) const {
  const double full = fan.full_angle();
  if (!(full > 0)) return {};
  if (fan.is_at_border) {
    if (angle < -kFlat || angle > full + kFlat) return {};
  } else {
    angle -= std::floor(angle / full) * full;
  }
  // The first corner that ends at the angle or after it; the last one if rounding leaves none.
  const auto ends = std::span(fan.angles).subspan(1);
  const auto end = std::lower_bound(ends.begin(), ends.end() - 1, angle);
  const auto k = static_cast<std::size_t>(end - ends.begin());
  const double turn = std::clamp(angle, fan.angles[k], *end) - fan.angles[k];
  Line line;
  line.face = SurfaceMesh::face(fan.halfedges[k]);
  line.start = SurfaceMesh::side(fan.halfedges[k]);
  line.corners = laid_out(mesh_, positions_.at, line.face, line.start);
  const Point2 unit = direction_at(turn);
  line.along = {length * unit.x, length * unit.y};
  return line;
}

ExponentialMap::Line ExponentialMap::aim_from_inside(Point2 along) const {
  Line line;
  line.face = face_;
  line.corners = laid_out(mesh_, positions_.at, face_, 0);
  line.from = combined(line.corners, weights_);
  line.along = along;
  return line;
}

/// Returns the line from a centre that is a vertex. Without a border angles are stretched so that
/// the full angle is a full turn; at the border they are kept, in either sense of turning.
std::optional<ExponentialMap::Line> ExponentialMap::aim_from_corner(Point2 along) const {
  const FaceCorners corners = laid_out(mesh_, positions_.at, face_, 0);
  const Point2 side = corners[(corner_ + 1) % 3] - corners[corner_];
  const double turn = arc_tangent(cross(side, along), dot(side, along));
  const double size = length(along);
  if (!fan_.is_at_border) {
    return aim_from_vertex(fan_, angle_before_ + turn / (2 * kPi) * fan_.full_angle(), size);
  }
  const std::optional<Line> line = aim_from_vertex(fan_, angle_before_ + turn, size);
  return line ? line
              : aim_from_vertex(fan_, angle_before_ + turn + (turn < 0 ? 2 : -2) * kPi, size);
}

std::optional<ExponentialMap::Line> ExponentialMap::aim(Point2 offset,
                                                        std::uint64_t most_faces) const {
  constexpr double kLongestSide = 4;  // Coordinates are at most 1.
  const Point2 along = turned(
      {std::ldexp(offset.x, -positions_.exponent), std::ldexp(offset.y, -positions_.exponent)},
      x_axis_);
  if (!(length(along) <= kLongestSide * static_cast<double>(most_faces))) fail_far(most_faces);
  if (corner_ == kInside || along == Point2{}) return aim_from_inside(along);
  return aim_from_corner(along);
}

// ---------------------------------------------------------------- 2. cross, 3. pass

/// Whether the line continues across a vertex as across a side. This is the case if the angle
/// around the vertex is a full turn. A line along a side in its first face does not count, because
/// nothing determines its way out.
bool ExponentialMap::is_flat(const Line& line, std::size_t corner, const Fan& fan) {
  const double next = line.side_of(corner + 1), prev = line.side_of(corner + 2);
  if (line.entry == kInside && !((next < 0 && prev > 0) || (next > 0 && prev < 0))) return false;
  return !fan.is_at_border && std::fabs(fan.full_angle() - 2 * kPi) < kFlat;
}

/// Returns a corner that the line meets, within rounding.
std::optional<std::size_t> ExponentialMap::vertex_ahead(const Line& line) const {
  for (std::size_t k = 0; k < 3; ++k) {
    const bool is_new = line.entry == kInside ? k != line.start : k == (line.entry + 2) % 3;
    const Point2 to = line.corners[k] - line.from;
    const double ahead = dot(line.along, to);
    if (is_new && ahead > 0 && std::fabs(cross(line.along, to)) <= kClose * ahead) return k;
  }
  return {};
}

/// Returns the side by which the line leaves the face, or kInside if the face has no area that
/// determines it. The first end of that side is not to the left of the line, and the second one is.
std::size_t ExponentialMap::way_out(const Line& line) {
  if (line.entry != kInside) {
    return (line.entry + (line.side_of(line.entry + 2) > 0 ? 1 : 2)) % 3;
  }
  if (line.start != kInside) return (line.start + 1) % 3;
  std::size_t farthest = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    if (line.side_of(k) <= 0 && line.side_of(k + 1) > 0) return k;
    if (std::fabs(line.side_of(k)) > std::fabs(line.side_of(farthest))) farthest = k;
  }
  // Because of rounding, a line along the side on which it starts may miss the face. It continues
  // behind that side.
  return line.side_of(farthest) == 0 ? kInside : (farthest + 1) % 3;
}

/// Returns where the line crosses the side that it leaves by, as a part of the way along the line.
/// The point is always on the side. If the line is nearly parallel to the side, it may be any point
/// of the side.
double ExponentialMap::part_at_side(const Line& line, std::size_t side) {
  const Point2 &a = line.corners[side], &b = line.corners[(side + 1) % 3];
  const double right = -line.side_of(side), left = line.side_of(side + 1);
  const double t = right + left > 0 ? std::clamp(right / (right + left), 0., 1.) : 0;
  return line.part_at({a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)});
}

/// Returns the line that begins at a corner, with `part` of the line behind it.
std::optional<ExponentialMap::Line> ExponentialMap::beyond_vertex(const Line& line,
                                                                  std::size_t corner, double part,
                                                                  const Fan& fan) const {
  const HalfedgeId h = SurfaceMesh::halfedge(line.face, corner);
  const Point2 at = line.corners[corner], side = line.corners[(corner + 1) % 3] - at;
  const Point2 back{-line.along.x, -line.along.y};
  const double wedge = corner_angle(mesh_, positions_.at, h);
  const double back_angle = std::clamp(arc_tangent(cross(side, back), dot(side, back)), 0., wedge);
  const double angle = fan.angle_before(h) + back_angle, left = (1 - part) * length(line.along);
  if (!fan.is_at_border) return aim_from_vertex(fan, angle + fan.full_angle() / 2, left);
  const std::optional<Line> next = aim_from_vertex(fan, angle + kPi, left);
  return next ? next : aim_from_vertex(fan, angle - kPi, left);
}

// ---------------------------------------------------------------- 4. land

SurfacePointId ExponentialMap::land(const Line& line, SurfacePointTable& points) const {
  const Point2 to{line.from.x + line.along.x, line.from.y + line.along.y};
  std::array<double, 3> weights{};
  double sum = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const Point2 &a = line.corners[(k + 1) % 3], &b = line.corners[(k + 2) % 3];
    weights[k] = std::max(cross(a - to, b - to), 0.);
    sum += weights[k];
  }
  if (sum > 0) {
    for (double& w : weights) w = w < kClose * sum ? 0 : w / sum;
  } else {  // The face has no area, so its nearest corner is used.
    const auto nearest = std::ranges::min_element(
        line.corners, {}, [&](const Point2& corner) { return length(corner - to); });
    weights[static_cast<std::size_t>(nearest - line.corners.begin())] = 1;
  }
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t next = (k + 1) % 3;
    if (weights[(k + 2) % 3] > 0) continue;
    const HalfedgeId h = SurfaceMesh::halfedge(line.face, k);
    if (weights[next] == 0) return points.add_vertex(mesh_.origin(h));
    if (weights[k] == 0) return points.add_vertex(mesh_.target(h));
    // Both t and 1 - t are doubles, so signs are cheap.
    const double part = 1 - weights[k] / (weights[k] + weights[next]);
    return points.add_on_edge(mesh_.edge(h), mesh_.is_upward(h) ? part : 1 - part);
  }
  return points.add_in_face(line.face, weights[1], weights[2]);
}

std::optional<SurfacePointId> ExponentialMap::add(Point2 offset, SurfacePointTable& points,
                                                  Context& context) const {
  const std::uint64_t most = kSomeFaces + kMostRounds * mesh_.face_count();
  std::optional<Line> line = aim(offset, most);
  for (std::uint64_t faces = 0; line; ++faces) {
    if (faces % kFacesPerCheckpoint == 0) context.checkpoint("draw", faces, most);
    if (faces > most) fail_far(most);
    if (const auto corner = vertex_ahead(*line)) {
      const Fan fan = fan_of(mesh_.corner(line->face, *corner));
      if (!is_flat(*line, *corner, fan)) {
        const double part = line->part_at(line->corners[*corner]);
        if (part >= 1 - kClose) return land(*line, points);
        line = beyond_vertex(*line, *corner, part, fan);
        continue;
      }
    }
    const std::size_t side = way_out(*line);
    if (side == kInside) return land(*line, points);
    const double part = part_at_side(*line, side);
    const HalfedgeId door = SurfaceMesh::halfedge(line->face, side);
    const bool is_last = mesh_.is_border(door);
    if (!(part < (is_last ? 1 - kClose : 1))) return land(*line, points);
    if (is_last) return {};
    line->corners = laid_out_across(mesh_, positions_.at, line->corners, door);
    line->face = SurfaceMesh::face(mesh_.twin(door));
    line->entry = SurfaceMesh::side(mesh_.twin(door));
    line->start = kInside;
  }
  return {};
}

}  // namespace plumb
