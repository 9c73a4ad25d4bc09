#include "plumb/surface/cells/surface_nodes.h"

#include <algorithm>
#include <tuple>

namespace plumb {
namespace {

constexpr std::uint32_t kNone = SurfaceArrangement::kNone;
constexpr const char* kPhase = "slice";
constexpr std::uint64_t kComparisons = 65536;  // a checkpoint

/// An entry of the polygons, to be sorted: place, edge or vertex or face, then parameters.
struct Entry {
  std::uint32_t rank;  ///< of the place
  std::uint32_t item;
  double x;
  std::uint32_t entry;
};

class NodeMaker {
 public:
  NodeMaker(const SurfacePolygons& polygons, Context& context)
      : polygons_(polygons), points_(polygons.points), context_(context) {}

  SurfaceNodes run() {
    gather();
    std::sort(entries_.begin(), entries_.end(),
              [&](const Entry& a, const Entry& b) { return is_before(a, b); });
    context_.checkpoint(kPhase, 1, 2);
    number();
    index_edges();
    index_vertices();
    return std::move(nodes_);
  }

 private:
  void gather() {
    entries_.reserve(polygons_.point.size());
    for (std::uint32_t i = 0; i < polygons_.point.size(); ++i) {
      const SurfacePointId p = polygons_.point[i];
      switch (points_.place(p)) {
        case SurfacePlace::Edge:
          entries_.push_back({0, points_.edge(p).value(), points_.approx(p).x, i});
          break;
        case SurfacePlace::Vertex:
          entries_.push_back({1, points_.vertex(p).value(), 0, i});
          break;
        case SurfacePlace::Face:
          entries_.push_back({2, points_.face(p).value(), points_.approx(p).x, i});
          break;
      }
    }
  }

  /// Rounded parameters are in order unless they are equal.
  Sign compare(const Entry& a, const Entry& b) const {
    if (std::tie(a.rank, a.item, a.x) < std::tie(b.rank, b.item, b.x)) return Sign::Negative;
    if (std::tie(b.rank, b.item, b.x) < std::tie(a.rank, a.item, a.x)) return Sign::Positive;
    const std::uint32_t p = polygons_.point[a.entry].value(), q = polygons_.point[b.entry].value();
    return p == q ? Sign::Zero : compare_xy(points_.parameters(), p, q);
  }
  bool is_before(const Entry& a, const Entry& b) {
    if (++comparisons_ % kComparisons == 0) context_.checkpoint(kPhase, 0, 2);
    const Sign order = compare(a, b);
    return order == Sign::Zero ? a.entry < b.entry : order == Sign::Negative;
  }

  void number() {
    nodes_.of_entry.resize(entries_.size());
    for (std::size_t i = 0; i < entries_.size(); ++i) {
      if (i % kComparisons == 0) context_.checkpoint(kPhase, 1, 2);
      if (i == 0 || compare(entries_[i - 1], entries_[i]) != Sign::Zero) {
        nodes_.point.push_back(polygons_.point[entries_[i].entry]);
      }
      nodes_.of_entry[entries_[i].entry] = NodeId(nodes_.point.size() - 1);
    }
    const auto first_of = [&](SurfacePlace place) {
      const auto is_earlier = [&](SurfacePointId p) {
        return points_.place(p) == SurfacePlace::Edge ||
               (place == SurfacePlace::Face && points_.place(p) == SurfacePlace::Vertex);
      };
      return static_cast<std::uint32_t>(
          std::partition_point(nodes_.point.begin(), nodes_.point.end(), is_earlier) -
          nodes_.point.begin());
    };
    nodes_.vertices_begin = first_of(SurfacePlace::Vertex);
    nodes_.faces_begin = first_of(SurfacePlace::Face);
  }

  void index_edges() {
    nodes_.slot_of_edge.assign(points_.mesh().edge_count(), kNone);
    for (std::uint32_t n = 0; n < nodes_.vertices_begin; ++n) {
      const EdgeId e = points_.edge(nodes_.point[n]);
      if (!nodes_.edges.empty() && nodes_.edges.back() == e) continue;
      nodes_.slot_of_edge[e.value()] = static_cast<std::uint32_t>(nodes_.edges.size());
      nodes_.edges.push_back(e);
      nodes_.edge_begin.push_back(n);
    }
    nodes_.edge_begin.push_back(nodes_.vertices_begin);
  }

  void index_vertices() {
    nodes_.of_vertex.assign(points_.mesh().vertex_count(), NodeId{});
    for (std::uint32_t n = nodes_.vertices_begin; n < nodes_.faces_begin; ++n) {
      nodes_.of_vertex[points_.vertex(nodes_.point[n]).value()] = NodeId(n);
    }
  }

  const SurfacePolygons& polygons_;
  const SurfacePointTable& points_;
  Context& context_;
  std::uint64_t comparisons_ = 0;
  std::vector<Entry> entries_;
  SurfaceNodes nodes_;
};

}  // namespace

SurfaceNodes make_nodes(const SurfacePolygons& polygons, Context& context) {
  return NodeMaker(polygons, context).run();
}

}  // namespace plumb
