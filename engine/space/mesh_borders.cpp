#include "plumb/space/mesh_borders.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <map>
#include <utility>

#include "plumb/base/box_tree.h"
#include "plumb/predicates/input_predicates.h"
#include "plumb/predicates/point3_signs.h"
#include "plumb/predicates/rational_predicates.h"
#include "plumb/space/space_boxes.h"

namespace plumb {
namespace {

using VertexPair = std::array<std::uint32_t, 2>;

/// How often edges are run through from the lesser to the greater end, less how often back; not 0.
using Surplus = std::map<VertexPair, std::int32_t>;

void add(std::uint32_t from, std::uint32_t to, std::int32_t times, Surplus& surplus) {
  std::int32_t& sum = surplus[{std::min(from, to), std::max(from, to)}];
  sum += from < to ? times : -times;
}

void drop_balanced(Surplus& surplus) {
  std::erase_if(surplus, [](const auto& s) { return s.second == 0; });
}

Surplus imbalances(const MeshFacets& facets, const MeshLinks& links) {
  Surplus surplus;
  for (std::size_t e = 0; e < links.edge_count(); ++e) {
    std::int32_t sum = 0;
    for (const std::uint32_t u : links.uses_of(e)) {
      const std::int32_t times = -facets.jump[links.facet[u]];  // in the canonical direction
      sum += links.is_forward(facets, u) ? times : -times;
    }
    if (sum != 0) surplus[links.end[e]] += sum;
  }
  for (const VertexPair& e : facets.loose) add(e[0], e[1], 1, surplus);
  drop_balanced(surplus);
  return surplus;
}

// ---------------------------------------------------------------- edges with vertices on them

class EdgeSplitter {
 public:
  EdgeSplitter(std::span<const SpacePoint> points, const Point3Table& table)
      : points_(points), table_(table) {}

  /// The edges cut at all ends of edges that lie on them.
  Surplus split(const Surplus& edges) {
    for (const auto& [edge, times] : edges) ends_.insert(ends_.end(), edge.begin(), edge.end());
    std::sort(ends_.begin(), ends_.end());
    ends_.erase(std::unique(ends_.begin(), ends_.end()), ends_.end());
    std::vector<Box3> boxes;
    for (const std::uint32_t v : ends_) boxes.push_back(box_of(table_, points_[v]));
    const BoxTree tree(boxes);
    Surplus pieces;
    for (const auto& [edge, times] : edges) {
      gather_inner(edge, tree);
      std::uint32_t from = edge[0];
      for (const std::uint32_t v : inner_) {
        add(from, v, times, pieces);
        from = v;
      }
      add(from, edge[1], times, pieces);
    }
    drop_balanced(pieces);
    return pieces;
  }

 private:
  /// Vertices inside the edge, from its first end to its second.
  void gather_inner(const VertexPair& edge, const BoxTree& tree) {
    inner_.clear();
    Box3 box = box_of(table_, points_[edge[0]]);
    box.add(box_of(table_, points_[edge[1]]));
    const std::size_t axis = axis_of(edge);
    const Sign along = compare(edge[0], edge[1], axis);
    tree.for_each_meeting(box, [&](std::uint32_t i) {
      const std::uint32_t v = ends_[i];
      const bool is_between =
          compare(edge[0], v, axis) == along && compare(v, edge[1], axis) == along;
      if (is_between && are_collinear(edge[0], edge[1], v)) inner_.push_back(v);
    });
    std::sort(inner_.begin(), inner_.end(),
              [&](std::uint32_t v, std::uint32_t w) { return compare(v, w, axis) == along; });
  }

  /// An axis in which the ends differ: they are different points.
  std::size_t axis_of(const VertexPair& edge) const {
    std::size_t axis = 0;
    while (axis < 2 && compare(edge[0], edge[1], axis) == Sign::Zero) ++axis;
    return axis;
  }
  Sign compare(std::uint32_t v, std::uint32_t w, std::size_t axis) const {
    return compare_axis(table_, points_[v], points_[w], axis);
  }

  /// Seen along each axis.
  bool are_collinear(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
    const std::array<SpacePoint, 3> p{points_[a], points_[b], points_[c]};
    if (std::ranges::all_of(p, &SpacePoint::is_input)) {
      const PlaneTable& planes = table_.planes();
      return are_collinear(planes.point(p[0].input()), planes.point(p[1].input()),
                           planes.point(p[2].input()));
    }
    return are_collinear(exact(table_, p[0]), exact(table_, p[1]), exact(table_, p[2]));
  }
  static bool are_collinear(const Point3& a, const Point3& b, const Point3& c) {
    return orient2d(Point2{a.x, a.y}, Point2{b.x, b.y}, Point2{c.x, c.y}) == Sign::Zero &&
           orient2d(Point2{a.y, a.z}, Point2{b.y, b.z}, Point2{c.y, c.z}) == Sign::Zero &&
           orient2d(Point2{a.z, a.x}, Point2{b.z, b.x}, Point2{c.z, c.x}) == Sign::Zero;
  }
  static bool are_collinear(const RationalPoint3& a, const RationalPoint3& b,
                            const RationalPoint3& c) {
    using P = RationalPoint2;
    return orient2d(P{a.x, a.y}, P{b.x, b.y}, P{c.x, c.y}) == Sign::Zero &&
           orient2d(P{a.y, a.z}, P{b.y, b.z}, P{c.y, c.z}) == Sign::Zero &&
           orient2d(P{a.z, a.x}, P{b.z, b.x}, P{c.z, c.x}) == Sign::Zero;
  }

  std::span<const SpacePoint> points_;
  const Point3Table& table_;
  std::vector<std::uint32_t> ends_;   // ascending
  std::vector<std::uint32_t> inner_;  // of the edge at hand
};

// ---------------------------------------------------------------- chains

/// Walks directed edges, as many into every vertex as out of it, and cuts loops off the walk.
class ChainWalker {
 public:
  void add(std::uint32_t from, std::uint32_t to) { targets_[from].push_back(to); }

  std::vector<std::vector<std::uint32_t>> chains() {
    for (auto& [start, targets] : targets_) {
      while (!targets.empty()) walk(start);
    }
    return std::move(chains_);
  }

 private:
  /// Ends where it started, there being as many ways out as in.
  void walk(std::uint32_t start) {
    path_ = {start};
    place_ = {{start, 0}};
    do {
      std::vector<std::uint32_t>& ways = targets_[path_.back()];
      const std::uint32_t to = ways.back();
      ways.pop_back();
      const auto [seen, is_new] = place_.try_emplace(to, path_.size());
      if (is_new) {
        path_.push_back(to);
      } else {
        cut_loop(seen->second);
      }
    } while (path_.size() > 1);
  }

  void cut_loop(std::size_t from) {
    const auto begin = path_.begin() + static_cast<std::ptrdiff_t>(from);
    chains_.emplace_back(begin, path_.end());
    for (std::size_t i = from + 1; i < path_.size(); ++i) place_.erase(path_[i]);
    path_.resize(from + 1);
  }

  std::map<std::uint32_t, std::vector<std::uint32_t>> targets_;
  std::vector<std::uint32_t> path_;
  std::map<std::uint32_t, std::size_t> place_;
  std::vector<std::vector<std::uint32_t>> chains_;
};

}  // namespace

std::vector<std::vector<std::uint32_t>> trace_borders(const MeshFacets& facets,
                                                      const MeshLinks& links,
                                                      std::span<const SpacePoint> points,
                                                      const Point3Table& table) {
  Surplus surplus = imbalances(facets, links);
  if (!surplus.empty()) surplus = EdgeSplitter(points, table).split(surplus);
  ChainWalker walker;
  for (const auto& [edge, times] : surplus) {
    const bool is_up = times < 0;  // run downward too often
    for (std::int32_t i = 0; i < std::abs(times); ++i) {
      walker.add(edge[is_up ? 0 : 1], edge[is_up ? 1 : 0]);
    }
  }
  return walker.chains();
}

}  // namespace plumb
