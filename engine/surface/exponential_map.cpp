#include "plumb/surface/exponential_map.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "plumb/base/degrees.h"
#include "plumb/base/error.h"
#include "plumb/surface/face_strip.h"

namespace plumb {
namespace {

using namespace layout;

constexpr double kPi = std::numbers::pi;
constexpr double kClose = 0x1p-40;  // of the way there; of a weight
constexpr double kFlat = 1e-9;      // radians: so little is missing to half a turn
constexpr std::uint64_t kFacesPerCheckpoint = 4096;
constexpr std::uint64_t kMostRounds = 4;
constexpr std::uint64_t kSomeFaces = 1U << 16U;

/// Along a side from a to b, where the line from p crosses it, as a part of the way along the line.
double part_at(Point2 p, Point2 along, Point2 a, Point2 b) {
  return cross(a - p, b - a) / cross(along, b - a);
}

[[noreturn]] void fail_far(std::uint64_t most_faces) {
  throw Error(ErrorCode::ResourceLimit,
              "so far from the centre that a straight line there would cross more than " +
                  std::to_string(most_faces) + " triangles");
}

Point2 turned(Point2 p, Point2 by) { return {p.x * by.x - p.y * by.y, p.x * by.y + p.y * by.x}; }

}  // namespace

/// What is left of a line, in one face.
struct ExponentialMap::Line {
  FaceId face;
  FaceCorners corners;
  Point2 from;
  Point2 along;
  std::size_t entry = kInside;  ///< the side it came in by; none in its first face
  std::size_t start = kInside;  ///< the corner it starts in, if it does
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
  }
  const Point2 turn = unit_vector(angle);
  x_axis_ = turn;
  if (!mesh_.is_flipped(face)) return;
  const Point2 side = laid_out(mesh_, positions_.at, face, 0)[2];
  const double size = length(side);
  if (size > 0) x_axis_ = turned({side.x / size, side.y / size}, turn);
}

bool ExponentialMap::is_at_border(VertexId v) const {
  bool found = false;
  for_halfedges_from(mesh_, v, [&](HalfedgeId h) {
    found = found || mesh_.is_border(h) || mesh_.is_border(SurfaceMesh::prev(h));
  });
  return found;
}

double ExponentialMap::full_angle(VertexId v) const {
  double sum = 0;
  for_halfedges_from(mesh_, v, [&](HalfedgeId h) { sum += corner_angle(mesh_, positions_.at, h); });
  return sum;
}

/// Around the origin of h, from the first half-edge there.
double ExponentialMap::angle_before(HalfedgeId h) const {
  double sum = 0;
  bool is_before = true;
  for_halfedges_from(mesh_, mesh_.origin(h), [&](HalfedgeId at) {
    is_before = is_before && at != h;
    if (is_before) sum += corner_angle(mesh_, positions_.at, at);
  });
  return sum;
}

// ---------------------------------------------------------------- 1. aim

/// `angle` is measured from the first half-edge of v, counter-clockwise, and taken modulo the full angle where there is
/// one. None when it is beyond the border.
std::optional<ExponentialMap::Line> ExponentialMap::aim_from_vertex(VertexId v, double angle,
                                                                    double length) const {
  const double full = full_angle(v);
  if (!(full > 0)) return {};
  if (is_at_border(v)) {
    if (angle < -kFlat || angle > full + kFlat) return {};
  } else {
    angle -= std::floor(angle / full) * full;
  }
  HalfedgeId found;
  double rest = std::max(angle, 0.), rest_in = 0;
  for_halfedges_from(mesh_, v, [&](HalfedgeId h) {
    if (found.is_valid() && rest <= 0) return;
    const double here = corner_angle(mesh_, positions_.at, h);
    found = h;
    rest_in = std::min(rest, here);
    rest -= here;
  });
  Line line;
  line.face = SurfaceMesh::face(found);
  line.start = SurfaceMesh::side(found);
  line.corners = laid_out(mesh_, positions_.at, line.face, line.start);
  line.along = {length * std::cos(rest_in), length * std::sin(rest_in)};
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

/// The centre is a vertex.
std::optional<ExponentialMap::Line> ExponentialMap::aim_from_corner(Point2 along) const {
  const FaceCorners corners = laid_out(mesh_, positions_.at, face_, 0);
  const Point2 side = corners[(corner_ + 1) % 3] - corners[corner_];
  const double turn = std::atan2(cross(side, along), dot(side, along));
  const HalfedgeId h = SurfaceMesh::halfedge(face_, corner_);
  const VertexId v = mesh_.origin(h);
  const double before = angle_before(h), size = length(along);
  if (!is_at_border(v)) return aim_from_vertex(v, before + turn / (2 * kPi) * full_angle(v), size);
  const std::optional<Line> line = aim_from_vertex(v, before + turn, size);
  return line ? line : aim_from_vertex(v, before + turn + (turn < 0 ? 2 : -2) * kPi, size);
}

std::optional<ExponentialMap::Line> ExponentialMap::aim(Point2 offset,
                                                        std::uint64_t most_faces) const {
  constexpr double kLongestSide = 4;  // coordinates are at most 1
  const Point2 along = turned(
      {std::ldexp(offset.x, -positions_.exponent), std::ldexp(offset.y, -positions_.exponent)},
      x_axis_);
  if (!(length(along) <= kLongestSide * static_cast<double>(most_faces))) fail_far(most_faces);
  if (corner_ == kInside || along == Point2{}) return aim_from_inside(along);
  return aim_from_corner(along);
}

// ---------------------------------------------------------------- 2. cross, 3. pass

/// The line goes on across it as across a side. (Not so along a side, in its first face: nothing tells the way out.)
bool ExponentialMap::is_flat(const Line& line, std::size_t corner) const {
  const auto side_of = [&](std::size_t k) {
    return cross(line.along, line.corners[k % 3] - line.from);
  };
  const double next = side_of(corner + 1), prev = side_of(corner + 2);
  if (line.entry == kInside && !((next < 0 && prev > 0) || (next > 0 && prev < 0))) return false;
  const VertexId v = mesh_.corner(line.face, corner);
  return !is_at_border(v) && std::fabs(full_angle(v) - 2 * kPi) < kFlat;
}

/// A corner that the line meets, within rounding.
std::optional<std::size_t> ExponentialMap::vertex_ahead(const Line& line) const {
  for (std::size_t k = 0; k < 3; ++k) {
    const bool is_new = line.entry == kInside ? k != line.start : k == (line.entry + 2) % 3;
    const Point2 to = line.corners[k] - line.from;
    const double ahead = dot(line.along, to);
    if (is_new && ahead > 0 && std::fabs(cross(line.along, to)) <= kClose * ahead) return k;
  }
  return {};
}

/// The side by which the line leaves the face; kInside where the face has no area to tell.
std::size_t ExponentialMap::way_out(const Line& line) const {
  const auto side_of = [&](std::size_t k) {
    return cross(line.along, line.corners[k] - line.from);
  };
  if (line.entry != kInside) {
    return (line.entry + (side_of((line.entry + 2) % 3) > 0 ? 1 : 2)) % 3;
  }
  if (line.start != kInside) return (line.start + 1) % 3;
  for (std::size_t k = 0; k < 3; ++k) {
    if (side_of(k) <= 0 && side_of((k + 1) % 3) > 0) return k;
  }
  return kInside;
}

/// From a corner on, with `part` of the line behind it.
std::optional<ExponentialMap::Line> ExponentialMap::beyond_vertex(const Line& line,
                                                                  std::size_t corner,
                                                                  double part) const {
  const HalfedgeId h = SurfaceMesh::halfedge(line.face, corner);
  const VertexId v = mesh_.origin(h);
  const Point2 at = line.corners[corner], side = line.corners[(corner + 1) % 3] - at;
  const Point2 back{-line.along.x, -line.along.y};
  const double wedge = corner_angle(mesh_, positions_.at, h);
  const double back_angle = std::clamp(std::atan2(cross(side, back), dot(side, back)), 0., wedge);
  const double angle = angle_before(h) + back_angle, left = (1 - part) * length(line.along);
  if (!is_at_border(v)) return aim_from_vertex(v, angle + full_angle(v) / 2, left);
  const std::optional<Line> next = aim_from_vertex(v, angle + kPi, left);
  return next ? next : aim_from_vertex(v, angle - kPi, left);
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
  } else {  // a face without area: its nearest corner
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
    // Both t and 1 - t are doubles: that makes signs cheap.
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
    if (const auto corner = vertex_ahead(*line); corner && !is_flat(*line, *corner)) {
      const Point2 to = line->corners[*corner] - line->from;
      const double part = dot(line->along, to) / dot(line->along, line->along);
      if (part >= 1 - kClose) return land(*line, points);
      line = beyond_vertex(*line, *corner, part);
      continue;
    }
    const std::size_t side = way_out(*line);
    if (side == kInside) return land(*line, points);
    const Point2 &a = line->corners[side], &b = line->corners[(side + 1) % 3];
    const double part = part_at(line->from, line->along, a, b);
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
