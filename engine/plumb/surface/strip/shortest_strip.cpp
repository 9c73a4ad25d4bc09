// Shortest paths by windows: the continuous Dijkstra method, with a straight-line bound.
//
// All straight lines that leave one source through the same sequence of sides reach an interval of
// the last side, a window. Windows are spread over faces from the least bound on, so that a window
// whose bound is not less than the length of a known path is never spread. The idea is that of J.
// S. B. Mitchell, D. M. Mount and C. H. Papadimitriou, The discrete geodesic problem, SIAM Journal
// on Computing 16 (1987). Windows may overlap here; a window is dropped if a path through an end of
// its side is shorter everywhere in it, as by S.-Q. Xin and G.-J. Wang, Improving Chen and Han's
// algorithm on the discrete geodesic problem, ACM Transactions on Graphics 28 (2009).
//
// The bound of a window is the length of the shortest way from its source through its interval to
// the end point, straight through space behind the side. No path on the surface is shorter, so the
// search is an A* search. Shortest paths bend only at vertices with an angle of at least a full
// turn, and at the border; other vertices get a distance, but make no windows.
//
// Invariants: seats and windows are only appended, and each of them refers to earlier seats and
// windows. So following a path back ends at the start. Rounded lengths choose a strip, never a
// topology.
// Tested by tests/surface/shortest_strip_test.cpp, which tries all strips of small meshes.
#include "plumb/surface/strip/shortest_strip.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "plumb/predicates/arithmetic/vectors.h"
#include "plumb/predicates/error.h"

namespace plumb {
namespace {

using layout::cross;
using layout::dot;
using layout::length;
using layout::operator-;

constexpr double kShorterPath = 1 - 0x1p-40;
constexpr double kLonger = 1 + 0x1p-40;
constexpr std::uint64_t kWindowBytes = 128;  // The memory of a window with its entry in the heap.
constexpr std::size_t kWindowsPerCharge = 1024;

/// Returns the point where the line from `source` through (x, 0) meets the line from p to q. The
/// result is the part of the way from p to q, between 0 and 1.
double part_hit(Point2 source, double x, Point2 p, Point2 q) {
  const Point2 along = Point2{x, 0} - source;
  const double across = cross(q - p, along);
  return across == 0 ? 0 : std::clamp(cross(source - p, along) / across, 0.0, 1.0);
}

/// Returns the distance of a point of space from the line through a and b, and the place of its
/// foot on the line, as the distance from a towards b. Requires that a and b differ.
Point2 beside_line(const Point3& a, const Point3& b, const Point3& p) {
  const Point3 along{b.x - a.x, b.y - a.y, b.z - a.z}, to{p.x - a.x, p.y - a.y, p.z - a.z};
  const double side = std::sqrt(dot(along, along));
  const double foot = dot(along, to) / side;
  const Point3 normal = cross(along, to);
  return {foot, std::sqrt(dot(normal, normal)) / side};
}

}  // namespace

ShortestStripFinder::ShortestStripFinder(const SurfaceMesh& mesh, std::span<const Point3> positions)
    : mesh_(mesh), positions_(positions), reached_(mesh.vertex_count()) {}

std::optional<FaceStrip> ShortestStripFinder::find(const StripEnd& from, const StripEnd& to,
                                                   double bound, Context& context) {
  ++round_;
  windows_.clear();
  seats_.clear();
  heap_.clear();
  from_ = &from;
  to_ = &to;
  const bool is_vertex = to.table->place(to.point) == SurfacePlace::Vertex;
  goal_ = is_vertex ? to.table->vertex(to.point) : VertexId();
  best_ = bound * kShorterPath;
  arrival_ = {};
  MemoryCharge memory(context);
  std::size_t charged = 0;
  start();
  while (!heap_.empty()) {
    if (windows_.size() + seats_.size() >= charged) {
      memory.add(kWindowBytes * kWindowsPerCharge, "windows of shortest paths");
      charged += kWindowsPerCharge;
    }
    context.checkpoint("trace", 0, 1);
    std::pop_heap(heap_.begin(), heap_.end(), [](const Entry& a, const Entry& b) {
      return a.bound != b.bound ? a.bound > b.bound : a.index > b.index;
    });
    const Entry next = heap_.back();
    heap_.pop_back();
    if (next.bound >= best_) break;
    if (next.is_seat) {
      spread_seat(next.index);
    } else {
      spread_window(next.index);
    }
  }
  if (arrival_.window == kNone && arrival_.seat == kNone) return {};
  return collected();
}

// ---------------------------------------------------------------- spreading

void ShortestStripFinder::start() {
  seats_.push_back({VertexId(), 0, kNone, kNone, FaceId()});
  for (const FaceId f : faces_at(*from_->table, from_->point)) {
    const FaceCorners corners = laid_out(mesh_, positions_, f, 0);
    const std::array<double, 3> weights = weights_in(*from_->table, from_->point, f);
    const Point2 source = layout::combined(corners, weights);
    for (std::size_t k = 0; k < 3; ++k) {
      const double side = length(corners[(k + 1) % 3] - corners[k]);
      // The start lies on side k if the weight of the opposite corner is zero.
      if (weights[(k + 2) % 3] != 0) {
        add_window(SurfaceMesh::halfedge(f, k), corners, 0, side, source, 0, kNone);
      }
      if (weights[k] == 1) continue;
      offer(mesh_.corner(f, k), {mesh_.corner(f, k), length(corners[k] - source), kNone, 0, f});
    }
  }
}

void ShortestStripFinder::spread_window(std::uint32_t index) {
  const Window w = windows_[index];
  const FaceId f = SurfaceMesh::face(w.into);
  const std::size_t k = SurfaceMesh::side(w.into);
  const FaceCorners corners = laid_out(mesh_, positions_, f, k);
  const Point2 right = corners[(k + 1) % 3], apex = corners[(k + 2) % 3];
  const double before = seats_[w.seat].distance;
  if (to_->lies_in(f)) {
    const Point2 goal = layout::combined(corners, weights_in(*to_->table, to_->point, f));
    const double height = goal.y - w.source.y;
    const double x = height > 0 ? w.source.x - w.source.y / height * (goal.x - w.source.x) : goal.x;
    const double slack = 0x1p-40 * right.x;
    if (x >= w.begin - slack && x <= w.end + slack) {
      arrive(before + length(goal - w.source), {index, kNone, FaceId()});
    }
  }
  const Point2 to_apex = apex - w.source;
  const bool is_left_of_all = cross(Point2{w.begin, 0} - w.source, to_apex) > 0;
  const bool is_right_of_all = cross(Point2{w.end, 0} - w.source, to_apex) < 0;
  if (!is_left_of_all && !is_right_of_all) {
    const VertexId v = mesh_.corner(f, (k + 2) % 3);
    offer(v, {v, before + length(to_apex), index, w.seat, FaceId()});
  }
  // For the side on the right, the distance is measured from the apex; for the other side, from the
  // origin of w.into.
  if (!is_right_of_all) {
    const double side = length(apex - right);
    const double begin = is_left_of_all ? side * (1 - part_hit(w.source, w.begin, right, apex)) : 0;
    const double end = side * (1 - part_hit(w.source, w.end, right, apex));
    add_window(SurfaceMesh::next(w.into), corners, begin, end, w.source, w.seat, index);
  }
  if (!is_left_of_all) {
    const double side = length(apex);
    const double begin = side * part_hit(w.source, w.begin, {}, apex);
    const double end = is_right_of_all ? side * part_hit(w.source, w.end, {}, apex) : side;
    add_window(SurfaceMesh::prev(w.into), corners, begin, end, w.source, w.seat, index);
  }
}

void ShortestStripFinder::spread_seat(std::uint32_t index) {
  const Seat seat = seats_[index];
  if (seat.distance > best_of(seat.vertex)) return;  // A shorter path was found meanwhile.
  for_halfedges_from(mesh_, seat.vertex, [&](HalfedgeId h) {
    const FaceId f = SurfaceMesh::face(h);
    const std::size_t k = SurfaceMesh::side(h);
    const FaceCorners corners = laid_out(mesh_, positions_, f, k);
    if (to_->lies_in(f)) {
      const Point2 goal = layout::combined(corners, weights_in(*to_->table, to_->point, f));
      arrive(seat.distance + length(goal), {kNone, index, f});
    }
    for (const std::size_t i : {(k + 1) % 3, (k + 2) % 3}) {
      const VertexId v = mesh_.corner(f, i);
      offer(v, {v, seat.distance + length(corners[i]), kNone, index, f});
    }
    const double side = length(corners[(k + 2) % 3] - corners[(k + 1) % 3]);
    add_window(SurfaceMesh::next(h), corners, 0, side, corners[k], index, kNone);
  });
}

/// Adds the window behind the side `exit` of a face that is laid out, unless it is empty, at the
/// border, or cannot contain a point of a path shorter than the best.
void ShortestStripFinder::add_window(HalfedgeId exit, const FaceCorners& corners, double begin,
                                     double end, Point2 source, std::uint32_t seat,
                                     std::uint32_t before) {
  const HalfedgeId into = mesh_.twin(exit);
  if (!into.is_valid() || !(begin < end)) return;
  const std::size_t k = SurfaceMesh::side(exit);
  const Point2 origin = corners[(k + 1) % 3], along = corners[k] - origin;
  const double side = length(along);
  const Point2 to_source = source - origin;
  const Point2 seen{dot(along, to_source) / side, cross(along, to_source) / side};
  if (!(seen.y < 0)) return;
  const Window window{into, begin, end, seen, seat, before};
  if (is_dominated(window, side)) return;
  const double bound = bound_of(window, side);
  if (!(bound < best_)) return;
  windows_.push_back(window);
  push({bound, static_cast<std::uint32_t>(windows_.size() - 1), false});
}

/// Whether a path through an end of the side is shorter than the window at every point of it.
bool ShortestStripFinder::is_dominated(const Window& w, double side) const {
  const double before = seats_[w.seat].distance;
  const double at_begin = before + length(Point2{w.begin, 0} - w.source);
  const double at_end = before + length(Point2{w.end, 0} - w.source);
  return at_end > (best_of(mesh_.origin(w.into)) + w.end) * kLonger ||
         at_begin > (best_of(mesh_.target(w.into)) + side - w.begin) * kLonger;
}

/// Returns the length of the shortest way from the start through the window to the end point, if
/// the way behind the window may leave the surface. The end point is rotated about the side into
/// the plane of the window. There, the shortest way is straight, or bends at an end of the
/// interval.
double ShortestStripFinder::bound_of(const Window& w, double side) const {
  const Point2 goal = beside_line(positions_[mesh_.origin(w.into).value()],
                                  positions_[mesh_.target(w.into).value()], to_->at);
  const double height = goal.y - w.source.y;
  const double straight = w.source.x - w.source.y / height * (goal.x - w.source.x);
  const double x = std::clamp(straight, std::max(0.0, w.begin), std::min(side, w.end));
  return seats_[w.seat].distance + length(Point2{x, 0} - w.source) + length(goal - Point2{x, 0});
}

/// Stores a path to a vertex if it is the shortest so far.
void ShortestStripFinder::offer(VertexId v, const Seat& seat) {
  if (!(seat.distance < best_of(v))) return;
  reached_[v] = {round_, seat.distance};
  const auto index = static_cast<std::uint32_t>(seats_.size());
  seats_.push_back(seat);
  if (v == goal_) arrive(seat.distance, {kNone, index, FaceId()});
  const Point3& at = positions_[v.value()];
  const double bound =
      seat.distance + std::hypot(at.x - to_->at.x, at.y - to_->at.y, at.z - to_->at.z);
  if (bound < best_ && can_bend(v)) push({bound, index, true});
}

void ShortestStripFinder::arrive(double length, const Arrival& arrival) {
  if (!(length < best_)) return;
  best_ = length;
  arrival_ = arrival;
}

void ShortestStripFinder::push(const Entry& entry) {
  heap_.push_back(entry);
  std::push_heap(heap_.begin(), heap_.end(), [](const Entry& a, const Entry& b) {
    return a.bound != b.bound ? a.bound > b.bound : a.index > b.index;
  });
}

double ShortestStripFinder::best_of(VertexId v) const {
  const Reached& reached = reached_[v];
  return reached.round == round_ ? reached.distance : std::numeric_limits<double>::infinity();
}

/// Whether a shortest path may bend at the vertex. This is possible if the vertex lies at the
/// border, or if its angle is at least a full turn, up to rounding.
bool ShortestStripFinder::can_bend(VertexId v) const {
  constexpr double kNearlyFull = 2 * std::numbers::pi - 1e-9;
  double angle = 0;
  bool is_border = false;
  for_halfedges_from(mesh_, v, [&](HalfedgeId h) {
    angle += corner_angle(mesh_, positions_, h);
    is_border = is_border || mesh_.is_border(h) || mesh_.is_border(SurfaceMesh::prev(h));
  });
  return is_border || angle >= kNearlyFull;
}

// ---------------------------------------------------------------- collecting

/// Returns the steps of the best path from the start to the end.
std::vector<ShortestStripFinder::Step> ShortestStripFinder::steps() const {
  std::vector<Step> steps;
  std::uint32_t seat = arrival_.seat, window = arrival_.window;
  if (window == kNone && arrival_.face.is_valid()) {
    steps.push_back({HalfedgeId(), arrival_.face, seats_[seat].vertex});
  }
  for (;;) {
    if (window == kNone) {
      if (seat == 0) break;
      const Seat& reached = seats_[seat];
      window = reached.window;
      seat = reached.seat;
      if (window != kNone) continue;
      steps.push_back({HalfedgeId(), reached.face, seats_[seat].vertex});
    } else {
      const Window& w = windows_[window];
      const HalfedgeId door = mesh_.twin(w.into);
      steps.push_back({door, FaceId(), VertexId()});
      window = w.before;
      seat = w.seat;
      if (window == kNone) {
        steps.push_back({HalfedgeId(), SurfaceMesh::face(door), seats_[seat].vertex});
      }
    }
  }
  std::ranges::reverse(steps);
  return steps;
}

FaceStrip ShortestStripFinder::collected() const {
  FaceStrip strip;
  FaceId here;
  for (const Step& step : steps()) {
    if (step.door.is_valid()) {
      strip.doors.push_back(step.door);
      here = SurfaceMesh::face(mesh_.twin(step.door));
      continue;
    }
    if (!here.is_valid()) {
      strip.first = here = step.face;
      continue;
    }
    std::size_t k = 0;
    while (mesh_.corner(here, k) != step.around) ++k;
    const HalfedgeId h = SurfaceMesh::halfedge(here, k);
    auto doors = doors_around(mesh_, h, step.face, true);
    if (!doors) doors = doors_around(mesh_, h, step.face, false);
    PLUMB_CHECK(doors.has_value());
    strip.doors.insert(strip.doors.end(), doors->begin(), doors->end());
    here = step.face;
  }
  return strip;
}

}  // namespace plumb
