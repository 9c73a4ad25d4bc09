// Borders as a graph from which corners are removed (layer_simplify.h, plane_simplify.h).
//
// The graph has corners with their two edges, and edges with the labels at both sides. When a
// corner is removed, one of its edges is prolonged to the far end of the other one, so labels stay
// where they are. Corners that wait are in a heap by the areas of their triangles. A corner that is
// blocked by another corner waits for the removal of that one, so the result does not depend on the
// order in which borders are visited.
//
// Invariant: the edges meet only in common ends, and no two edges have the same ends.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <queue>
#include <unordered_set>
#include <vector>

#include "plumb/base/context.h"
#include "plumb/plane/layer/corner_tree.h"
#include "plumb/plane/layer/labelled_layer.h"
#include "plumb/plane/layer_simplify.h"

namespace plumb {

/// Counts of the corners of borders.
struct BorderCounts {
  std::size_t before = 0;   ///< Corners before; a common corner counts once.
  std::size_t after = 0;    ///< Corners that are left.
  std::size_t fixed = 0;    ///< Corners at which not exactly two edges meet.
  std::size_t blocked = 0;  ///< Removable corners that protect other corners or a ring.
  double moved = 0;         ///< Bound for the distance between the borders before and after.
};

/// The borders between faces, and other edges.
class BorderGraph {
 public:
  /// Makes the graph of all edges. `labelled` must outlive the graph, and all its vertices are at
  /// doubles.
  BorderGraph(const LabelledComplex& labelled, Context& context);

  /// Removes corners until an option forbids the next one. Throws Error{BadArgument} if an option
  /// is out of its range.
  void simplify(const LayerSimplifyOptions& options, Context& context);
  /// Returns the arrangement of the borders that are left, with their labels, and with the isolated
  /// vertices.
  LabelledComplex arranged(Context& context) const;
  /// Returns the counts of the corners.
  BorderCounts counts() const;

 private:
  struct Edge {
    std::uint32_t from;  // A corner.
    std::uint32_t to;    // Another corner.
    SideLabels sides;    // The labels at both sides, seen from `from`.
    double drift;        // Bound for the distance from the borders that the edge stands for.
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
  double drift_without(std::uint32_t v) const;
  bool are_joined(std::uint32_t u, std::uint32_t w) const;
  std::uint32_t corner_in_triangle(std::uint32_t v) const;
  void push(std::uint32_t v, double least);
  void remove(std::uint32_t v, double area, double drift);
  void wait_for(std::uint32_t v, std::uint32_t blocking);

  const PlaneComplex& complex_;
  MemoryCharge memory_;
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
  double drift_ = 0;       // The greatest drift of an edge.
};

}  // namespace plumb
