// Borders as a graph: corners with their two edges, and edges with the labels at both sides. When a
// corner is removed, one of its edges is prolonged to the far end of the other one, so labels
// stay where they are. Corners that wait are in a heap by the areas of their triangles. A corner
// that is blocked by another corner waits for the removal of that one, so the result does not
// depend on the order in which borders are visited.
//
// The corners in a triangle are found by a k-d tree whose nodes count the corners that are left.
// The tree compares doubles, and corners are doubles, so nothing is missed.
//
// Invariant: the edges meet only in common ends, and no two edges have the same ends. The last
// arrangement would find an edge that breaks this.
//
// Tested by tests/plane/layer_operations_test.cpp.
#include "plumb/plane/layer_simplify.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <queue>
#include <stdexcept>
#include <unordered_set>
#include <utility>
#include <vector>

#include "plumb/plane/layer/corner_tree.h"
#include "plumb/plane/layer/covered_cells.h"
#include "plumb/plane/layer/labelled_layer.h"
#include "plumb/predicates/error.h"

namespace plumb {
namespace {

// Corners, edges, the tree and the heap.
constexpr std::uint64_t kBytesPerBorderCorner = 160;
constexpr std::size_t kCornersPerCheckpoint = 1024;

class BorderGraph {
 public:
  explicit BorderGraph(const LabelledComplex& labelled);

  /// Removes corners until an option forbids the next one.
  void simplify(const LayerSimplifyOptions& options, Context& context);
  LabelledComplex arranged(Context& context) const;
  /// Adds the counts of the corners.
  void count(SimplifiedLayer& result) const;

 private:
  struct Edge {
    std::uint32_t from;  // A corner.
    std::uint32_t to;    // Another corner.
    SideLabels sides;    // The labels at both sides, seen from `from`.
  };
  struct Neighbours {
    std::uint32_t u;
    std::uint32_t w;
  };
  /// A corner that waits. Greater means later.
  struct Waiting {
    double area;
    std::uint32_t corner;
    std::uint32_t version;
    friend bool operator<(const Waiting& a, const Waiting& b) {
      return a.area != b.area ? a.area > b.area : a.corner > b.corner;
    }
  };

  bool is_removable(std::uint32_t v) const { return degree_[v] == 2; }
  std::uint32_t point(std::uint32_t v) const { return complex_.vertex_point[v]; }
  Point2 place(std::uint32_t v) const { return complex_.points.inputs.approx(point(v)); }
  std::uint32_t far_end(std::uint32_t e, std::uint32_t v) const {
    return edges_[e].from == v ? edges_[e].to : edges_[e].from;
  }
  Neighbours neighbours(std::uint32_t v) const {
    return {far_end(edge_[2 * v], v), far_end(edge_[2 * v + 1], v)};
  }
  Sign orientation(std::uint32_t i, std::uint32_t j, std::uint32_t k) const {
    return orient2d(complex_.points.inputs, point(i), point(j), point(k));
  }
  static std::uint64_t key(std::uint32_t u, std::uint32_t w) {
    return std::uint64_t{std::min(u, w)} << 32U | std::max(u, w);
  }
  double area(std::uint32_t v) const;
  bool are_joined(std::uint32_t u, std::uint32_t w) const;
  std::uint32_t corner_in_triangle(std::uint32_t v) const;
  void push(std::uint32_t v, double least);
  void remove(std::uint32_t v, double area);
  void wait_for(std::uint32_t v, std::uint32_t blocking);

  const PlaneComplex& complex_;
  std::vector<Edge> edges_;
  std::vector<std::uint8_t> is_left_;     // For each edge, whether it is left.
  std::vector<std::uint32_t> degree_;     // For each corner; 0 if it was removed.
  std::vector<std::uint32_t> edge_;       // For each removable corner, its two edges.
  std::vector<std::uint32_t> version_;    // Counts the changes of a corner's triangle.
  std::vector<std::uint32_t> waits_;      // For each corner, the last entry that waits for it.
  std::vector<std::uint32_t> waiting_;    // For each entry, the corner that waits.
  std::vector<std::uint32_t> next_;       // For each entry, the entry before it in the same list.
  std::uint32_t free_ = kNone;            // An entry that is not used, which begins a list.
  std::vector<std::uint8_t> is_blocked_;  // For each corner, whether its last triangle was blocked.
  std::unordered_set<std::uint64_t> fixed_edges_;  // Edges between corners that are not removable.
  std::priority_queue<Waiting> heap_;
  CornerTree tree_;
  std::size_t removable_ = 0;
  std::size_t removed_ = 0;
  std::size_t steps_ = 0;  // Corners that were looked at.
};

BorderGraph::BorderGraph(const LabelledComplex& labelled)
    : complex_(labelled.complex),
      is_left_(complex_.edge_count(), 1),
      degree_(complex_.vertex_count(), 0),
      edge_(2 * complex_.vertex_count(), kNone),
      version_(complex_.vertex_count(), 0),
      waits_(complex_.vertex_count(), kNone),
      is_blocked_(complex_.vertex_count(), 0) {
  const Dcel& dcel = complex_.dcel;
  for (std::uint32_t e = 0; e < complex_.edge_count(); ++e) {
    const HalfedgeId h = first_half(EdgeId(e));
    const Edge edge{
        dcel.origin(h).value(),
        dcel.target(h).value(),
        {labelled.label[dcel.face(h).value()], labelled.label[dcel.face(twin(h)).value()]}};
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

bool BorderGraph::are_joined(std::uint32_t u, std::uint32_t w) const {
  for (const auto& [at, other] : {std::pair(u, w), std::pair(w, u)}) {
    if (!is_removable(at)) continue;
    const Neighbours beside = neighbours(at);
    return beside.u == other || beside.w == other;
  }
  return fixed_edges_.count(key(u, w)) != 0;
}

/// Returns a corner that keeps v from being removed: another corner of the closed triangle, or v
/// itself if its neighbours are joined. Returns kNone if there is none.
std::uint32_t BorderGraph::corner_in_triangle(std::uint32_t v) const {
  const auto [u, w] = neighbours(v);
  if (are_joined(u, w)) return v;
  const Sign turn = orientation(u, v, w);
  if (turn == Sign::Zero) return kNone;  // v lies on the segment u w, which is a border already.
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

/// Puts a corner into the heap. Its triangle counts at least as `least`, so that corners leave in
/// ascending order.
void BorderGraph::push(std::uint32_t v, double least) {
  if (!is_removable(v)) return;
  ++version_[v];
  is_blocked_[v] = 0;
  heap_.push({std::max(area(v), least), v, version_[v]});
}

void BorderGraph::simplify(const LayerSimplifyOptions& options, Context& context) {
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
    const std::uint32_t blocking = corner_in_triangle(v);
    if (blocking == kNone) {
      remove(v, first.area);
      continue;
    }
    is_blocked_[v] = 1;
    if (blocking != v) wait_for(v, blocking);
  }
}

/// Puts v into the list of the corners that wait for the removal of a corner.
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

void BorderGraph::remove(std::uint32_t v, double area) {
  const auto [u, w] = neighbours(v);
  const std::uint32_t kept = edge_[2 * v], dropped = edge_[2 * v + 1];
  (edges_[kept].from == v ? edges_[kept].from : edges_[kept].to) = w;
  is_left_[dropped] = 0;
  if (is_removable(w)) (edge_[2 * w] == dropped ? edge_[2 * w] : edge_[2 * w + 1]) = kept;
  if (!is_removable(u) && !is_removable(w)) fixed_edges_.insert(key(u, w));
  degree_[v] = 0;
  ++removed_;
  tree_.remove(v);
  push(u, area);
  push(w, area);
  for (std::uint32_t i = waits_[v]; i != kNone;) {
    // A corner whose triangle has changed meanwhile is in the heap already.
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
      edge = {edge.to, edge.from, {edge.sides.right, edge.sides.left}};
    }
    const std::uint32_t a = point(edge.from), b = point(edge.to);
    curves.push_back({a, b, a, b});
    sides.push_back(edge.sides);
  }
  LabelledComplex result = labelled_arrangement(complex_.points, curves, sides, context);
  if (result.complex.edge_count() != curves.size()) {
    throw std::logic_error("simplified borders cross");
  }
  return result;
}

void BorderGraph::count(SimplifiedLayer& result) const {
  result.corners_before = degree_.size();
  result.corners_after = degree_.size() - removed_;
  result.fixed = degree_.size() - removable_;
  result.blocked =
      static_cast<std::size_t>(std::count(is_blocked_.begin(), is_blocked_.end(), std::uint8_t{1}));
}

}  // namespace

SimplifiedLayer simplify_layer(const Layer& layer, const LayerSimplifyOptions& options,
                               Context& context) {
  if (!(options.tolerance >= 0) || !(options.kept >= 0 && options.kept <= 1)) {
    throw Error(ErrorCode::BadArgument, "the tolerance is an area, and kept lies from 0 to 1");
  }
  const CoveredCells cells(layer, context);
  const RoundedLabels rounded = rounded_labels(cells.complex(), first_features(cells), context);
  MemoryCharge memory(context);
  memory.add(kBytesPerBorderCorner * rounded.labelled.complex.vertex_count(), "the borders");
  BorderGraph borders(rounded.labelled);
  borders.simplify(options, context);
  SimplifiedLayer result;
  borders.count(result);
  result.layer = layer_of_labels(borders.arranged(context), layer.feature_count(), &layer, context);
  result.overlaps =
      count_overlaps(cells, {0, static_cast<std::uint32_t>(layer.feature_count())}, {});
  result.rounding = rounded.rounding;
  return result;
}

}  // namespace plumb
