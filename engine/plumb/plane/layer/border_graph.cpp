// Corners in a triangle are found by a k-d tree whose nodes count the remaining corners. The tree
// compares doubles, and corners are doubles, so no corner is missed.
//
// An edge has a bound for its distance from the borders that it stands for (drift). Removing a
// corner adds the distance of this corner from the new edge, so the sum bounds the distance in both
// directions, by the triangle inequality.
//
// If edges broke the invariant of the graph, the last arrangement would find them.
//
// Tested by tests/plane/layer_operations_test.cpp and tests/plane/plane_simplify_test.cpp.
#include "plumb/plane/layer/border_graph.h"

#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

#include "plumb/plane/rounding/labelled_edges.h"
#include "plumb/predicates/error.h"

namespace plumb {
namespace {

// The memory of corners, edges, the tree and the heap.
constexpr std::uint64_t kBytesPerBorderCorner = 168;
constexpr std::size_t kCornersPerCheckpoint = 1024;

void require_in_range(const LayerSimplifyOptions& options) {
  const bool is_in_range = options.tolerance >= 0 && options.within >= 0 && options.kept >= 0 &&
                           options.kept <= 1;  // The comparison is false for NaNs.
  if (is_in_range) return;
  throw Error(ErrorCode::BadArgument,
              "the tolerance is an area, `within` is a distance, and kept lies from 0 to 1");
}

}  // namespace

BorderGraph::BorderGraph(const LabelledComplex& labelled, Context& context)
    : complex_(labelled.complex),
      memory_(context),
      is_left_(complex_.edge_count(), 1),
      degree_(complex_.vertex_count(), 0),
      edge_(2 * complex_.vertex_count(), kNone),
      version_(complex_.vertex_count(), 0),
      waits_(complex_.vertex_count(), kNone),
      is_blocked_(complex_.vertex_count(), 0) {
  memory_.add(kBytesPerBorderCorner * complex_.vertex_count(), "the borders");
  const Dcel& dcel = complex_.dcel;
  for (std::uint32_t e = 0; e < complex_.edge_count(); ++e) {
    const HalfedgeId h = first_half(EdgeId(e));
    const Edge edge{
        dcel.origin(h).value(),
        dcel.target(h).value(),
        {labelled.label[dcel.face(h).value()], labelled.label[dcel.face(twin(h)).value()]},
        0};
    edges_.push_back(edge);
    for (const std::uint32_t v : {edge.from, edge.to}) {
      if (degree_[v] < 2) edge_[2 * v + degree_[v]] = e;
      ++degree_[v];
    }
  }
  for (const Edge& edge : edges_) {
    if (!is_removable(edge.from) && !is_removable(edge.to)) {
      fixed_edges_.insert(key(edge.from, edge.to));
    }
  }
  std::vector<Point2> places;
  for (std::uint32_t v = 0; v < degree_.size(); ++v) {
    places.push_back(place(v));
    if (is_removable(v)) ++removable_;
  }
  tree_ = CornerTree(std::move(places));
}

/// Returns the area of the triangle of a corner and its neighbours; infinity if doubles overflow.
double BorderGraph::area(std::uint32_t v) const {
  const auto [u, w] = neighbours(v);
  const Point2 a = place(u), b = place(v), c = place(w);
  const double area = std::fabs((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x)) / 2;
  return std::isnan(area) ? std::numeric_limits<double>::infinity() : area;
}

/// Returns a bound for the distance between the edge that replaces the edges at v, and the borders
/// that these edges stand for. The edge is as far from its predecessors as v is from it: seen along
/// the edge, the two of them cover it, and no point of them is farther from it than v.
double BorderGraph::drift_without(std::uint32_t v) const {
  const auto [u, w] = neighbours(v);
  const Point2 a = place(u), b = place(v), c = place(w);
  const double x = c.x - a.x, y = c.y - a.y, px = b.x - a.x, py = b.y - a.y;
  const double length = std::hypot(x, y);
  const double along = (px * x + py * y) / length;
  const double to_a = std::hypot(px, py), to_c = std::hypot(b.x - c.x, b.y - c.y);
  const double off = along <= 0        ? to_a
                     : along >= length ? to_c
                                       : std::fabs(x * py - y * px) / length;
  // The slack exceeds the rounding errors in this function.
  const double slack = 0x1p-48 * (to_a + to_c);
  const double before = std::max(edges_[edge_[2 * v]].drift, edges_[edge_[2 * v + 1]].drift);
  const double drift = sum_above(before, sum_above(off, slack));
  return std::isnan(drift) ? std::numeric_limits<double>::infinity() : drift;
}

bool BorderGraph::are_joined(std::uint32_t u, std::uint32_t w) const {
  for (const auto& [at, other] : {std::pair(u, w), std::pair(w, u)}) {
    if (!is_removable(at)) continue;
    const Neighbours beside = neighbours(at);
    return beside.u == other || beside.w == other;
  }
  return fixed_edges_.count(key(u, w)) != 0;
}

/// Returns a corner that prevents the removal of v: another corner of the closed triangle, or v
/// itself if its neighbours are joined by an edge. Returns kNone if there is none.
std::uint32_t BorderGraph::corner_in_triangle(std::uint32_t v) const {
  const auto [u, w] = neighbours(v);
  if (are_joined(u, w)) return v;
  const Sign turn = orientation(u, v, w);
  // The vertex v lies on the segment u w, which is already a border.
  if (turn == Sign::Zero) return kNone;
  const auto is_inside = [&, i = u, k = w](std::uint32_t x) {
    if (x == i || x == v || x == k) return false;
    for (const auto& [a, b] : {std::pair(i, v), std::pair(v, k), std::pair(k, i)}) {
      const Sign side = orientation(a, b, x);
      if (side != Sign::Zero && side != turn) return false;
    }
    return true;
  };
  const bool is_left_turn = turn == Sign::Positive;
  return tree_.find_in_triangle(place(is_left_turn ? u : w), place(v), place(is_left_turn ? w : u),
                                is_inside);
}

/// Adds a corner to the heap. Its triangle counts as at least `least`, so that corners leave the
/// heap in ascending order.
void BorderGraph::push(std::uint32_t v, double least) {
  if (!is_removable(v)) return;
  ++version_[v];
  is_blocked_[v] = 0;
  heap_.push({std::max(area(v), least), v, version_[v]});
}

void BorderGraph::simplify(const LayerSimplifyOptions& options, Context& context) {
  require_in_range(options);
  for (std::uint32_t v = 0; v < degree_.size(); ++v) push(v, 0);
  const auto kept =
      static_cast<std::size_t>(std::ceil(options.kept * static_cast<double>(removable_)));
  while (!heap_.empty() && removable_ - removed_ > kept) {
    const Waiting first = heap_.top();
    if (first.area > options.tolerance) break;
    heap_.pop();
    const std::uint32_t v = first.corner;
    if (degree_[v] == 0 || first.version != version_[v]) continue;
    if (steps_++ % kCornersPerCheckpoint == 0) {
      context.checkpoint("simplify", removed_, removable_ - kept);
    }
    const double drift = drift_without(v);
    if (drift > options.within) continue;
    const std::uint32_t blocking = corner_in_triangle(v);
    if (blocking == kNone) {
      remove(v, first.area, drift);
      continue;
    }
    is_blocked_[v] = 1;
    if (blocking != v) wait_for(v, blocking);
  }
}

/// Adds v to the list of the corners that wait for the removal of another corner.
void BorderGraph::wait_for(std::uint32_t v, std::uint32_t blocking) {
  if (free_ == kNone) {
    free_ = static_cast<std::uint32_t>(next_.size());
    waiting_.push_back(v);
    next_.push_back(kNone);
  }
  const std::uint32_t entry = std::exchange(free_, next_[free_]);
  waiting_[entry] = v;
  next_[entry] = std::exchange(waits_[blocking], entry);
}

void BorderGraph::remove(std::uint32_t v, double area, double drift) {
  const auto [u, w] = neighbours(v);
  const std::uint32_t kept = edge_[2 * v], dropped = edge_[2 * v + 1];
  (edges_[kept].from == v ? edges_[kept].from : edges_[kept].to) = w;
  edges_[kept].drift = drift;
  drift_ = std::max(drift_, drift);
  is_left_[dropped] = 0;
  if (is_removable(w)) (edge_[2 * w] == dropped ? edge_[2 * w] : edge_[2 * w + 1]) = kept;
  if (!is_removable(u) && !is_removable(w)) fixed_edges_.insert(key(u, w));
  degree_[v] = 0;
  ++removed_;
  tree_.remove(v);
  push(u, area);
  push(w, area);
  for (std::uint32_t i = waits_[v]; i != kNone;) {
    // If the triangle of a corner has changed meanwhile, the heap already contains the corner
    // again.
    if (is_blocked_[waiting_[i]] != 0) push(waiting_[i], area);
    const std::uint32_t next = std::exchange(next_[i], free_);
    free_ = i;
    i = next;
  }
}

LabelledComplex BorderGraph::arranged(Context& context) const {
  std::vector<SweepCurve> curves;
  std::vector<SideLabels> sides;
  for (std::size_t e = 0; e < edges_.size(); ++e) {
    if (is_left_[e] == 0) continue;
    Edge edge = edges_[e];
    // Vertices are numbered in lexicographic order.
    if (edge.from > edge.to) {
      edge = {edge.to, edge.from, {edge.sides.right, edge.sides.left}, edge.drift};
    }
    const std::uint32_t a = point(edge.from), b = point(edge.to);
    curves.push_back({a, b, a, b});
    sides.push_back(edge.sides);
  }
  std::vector<std::uint32_t> isolated;
  for (std::uint32_t v = 0; v < degree_.size(); ++v) {
    if (complex_.dcel.is_isolated(VertexId(v))) isolated.push_back(point(v));
  }
  LabelledComplex result = labelled_arrangement(complex_.points, curves, sides, isolated, context);
  if (result.complex.edge_count() != curves.size()) {
    throw std::logic_error("simplified borders cross");
  }
  return result;
}

BorderCounts BorderGraph::counts() const {
  return {
      degree_.size(), degree_.size() - removed_, degree_.size() - removable_,
      static_cast<std::size_t>(std::count(is_blocked_.begin(), is_blocked_.end(), std::uint8_t{1})),
      drift_};
}

}  // namespace plumb
