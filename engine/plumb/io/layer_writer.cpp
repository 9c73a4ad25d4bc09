// Layers as TopoJSON and WKT.
//
// TopoJSON: corners with equal coordinates are one vertex. A vertex is a junction if rings pass it
// between different neighbours; rings are cut there to arcs. All rings that share an edge share the
// whole arc around it, because the vertices inside of an arc have the same neighbours in all rings.
// So the first directed edge of an arc identifies the arc and its direction. A ring without a
// junction is one arc that begins at its least vertex.
//
// Tested by tests/io/layer_io_test.cpp.
#include <algorithm>
#include <cstdint>
#include <numeric>
#include <ostream>
#include <span>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "plumb/io/layer_io.h"
#include "plumb/io/text/text_output.h"

namespace plumb {
namespace {

// The memory of vertices, neighbours, and the table of arcs.
constexpr std::uint64_t kBytesPerArcCorner = 100;
constexpr std::size_t kRingsPerCheckpoint = 256;

/// The arcs of a layer, and the arcs of each ring.
class LayerArcs {
 public:
  LayerArcs(const Layer& layer, Context& context) : layer_(layer), memory_(context) {
    memory_.add(kBytesPerArcCorner * layer.ring_corners.size(), "the arcs of a layer");
    find_vertices();
    find_junctions();
    for (std::size_t r = 0; r < layer.ring_count(); ++r) {
      if (r % kRingsPerCheckpoint == 0) context.checkpoint("arcs", r, layer.ring_count());
      cut_ring(r);
      ring_begin_.push_back(ring_arcs_.size());
    }
  }

  std::size_t arc_count() const { return arc_begin_.size() - 1; }
  std::span<const std::uint32_t> arc(std::size_t i) const {
    return {corners_.data() + arc_begin_[i], corners_.data() + arc_begin_[i + 1]};
  }
  /// Returns the arcs of a ring: i, or -1 - i for arc i from its end to its start.
  std::span<const std::int64_t> arcs_of(std::size_t ring) const {
    return {ring_arcs_.data() + ring_begin_[ring], ring_arcs_.data() + ring_begin_[ring + 1]};
  }

 private:
  static std::uint64_t edge(std::uint32_t from, std::uint32_t to) {
    return std::uint64_t{from} << 32U | to;
  }
  std::uint32_t vertex(std::span<const std::uint32_t> ring, std::size_t i) const {
    return vertex_[ring[i % ring.size()]];
  }
  void find_vertices();
  void find_junctions();
  void cut_ring(std::size_t r);
  void add_arc(std::span<const std::uint32_t> ring, std::size_t begin, std::size_t end);

  const Layer& layer_;
  MemoryCharge memory_;
  std::vector<std::uint32_t> vertex_;  // For each point, the first point with its coordinates.
  std::vector<std::uint8_t> is_junction_;
  std::unordered_map<std::uint64_t, std::int64_t> arc_of_;  // The key is the first directed edge.
  std::vector<std::uint32_t> corners_;
  std::vector<std::size_t> arc_begin_{0};
  std::vector<std::int64_t> ring_arcs_;
  std::vector<std::size_t> ring_begin_{0};
};

void LayerArcs::find_vertices() {
  std::vector<std::uint32_t> order(layer_.points.size());
  std::iota(order.begin(), order.end(), 0U);
  const auto place = [this](std::uint32_t i) {
    const Point2 p = layer_.points.approx(i);
    return std::pair(p.x, p.y);
  };
  std::sort(order.begin(), order.end(), [&](std::uint32_t i, std::uint32_t j) {
    return place(i) != place(j) ? place(i) < place(j) : i < j;
  });
  vertex_.resize(order.size());
  for (std::size_t k = 0; k < order.size(); ++k) {
    const bool is_same = k > 0 && place(order[k - 1]) == place(order[k]);
    vertex_[order[k]] = is_same ? vertex_[order[k - 1]] : order[k];
  }
}

void LayerArcs::find_junctions() {
  constexpr std::uint64_t kUnseen = ~std::uint64_t{0};
  std::vector<std::uint64_t> neighbours(vertex_.size(), kUnseen);
  is_junction_.assign(vertex_.size(), 0);
  for (std::size_t r = 0; r < layer_.ring_count(); ++r) {
    const std::span<const std::uint32_t> ring = layer_.ring(r);
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const std::uint32_t a = vertex(ring, i + ring.size() - 1), b = vertex(ring, i + 1);
      const std::uint64_t beside = edge(std::min(a, b), std::max(a, b));
      std::uint64_t& seen = neighbours[vertex(ring, i)];
      if (seen == kUnseen) seen = beside;
      if (seen != beside) is_junction_[vertex(ring, i)] = 1;
    }
  }
}

void LayerArcs::cut_ring(std::size_t r) {
  const std::span<const std::uint32_t> ring = layer_.ring(r);
  std::size_t start = 0;
  while (start < ring.size() && is_junction_[vertex(ring, start)] == 0) ++start;
  if (start == ring.size()) {
    start = 0;
    for (std::size_t i = 1; i < ring.size(); ++i) {
      if (vertex(ring, i) < vertex(ring, start)) start = i;
    }
    add_arc(ring, start, start + ring.size());
    return;
  }
  std::size_t begin = start;
  for (std::size_t i = start + 1; i <= start + ring.size(); ++i) {
    if (is_junction_[vertex(ring, i)] == 0) continue;
    add_arc(ring, begin, i);
    begin = i;
  }
}

/// Adds the arc of the corners begin, ..., end of a ring, unless the arc is known already.
void LayerArcs::add_arc(std::span<const std::uint32_t> ring, std::size_t begin, std::size_t end) {
  const auto next = static_cast<std::int64_t>(arc_count());
  const std::uint64_t first = edge(vertex(ring, begin), vertex(ring, begin + 1));
  const auto [found, is_new] = arc_of_.try_emplace(first, next);
  ring_arcs_.push_back(found->second);
  if (!is_new) return;
  arc_of_.try_emplace(edge(vertex(ring, end), vertex(ring, end - 1)), -1 - next);
  for (std::size_t i = begin; i <= end; ++i) corners_.push_back(vertex(ring, i));
  arc_begin_.push_back(corners_.size());
}

template <class WriteRing>
void write_polygons(TextOutput& out, const Layer& layer, std::size_t f, const char* const brackets,
                    const WriteRing& write_ring) {
  const char open = brackets[0], close = brackets[1];
  for (std::size_t p = layer.feature_begin[f]; p < layer.feature_begin[f + 1]; ++p) {
    if (p > layer.feature_begin[f]) out << ',';
    out << open;
    for (std::size_t r = layer.polygon_begin[p]; r < layer.polygon_begin[p + 1]; ++r) {
      if (r > layer.polygon_begin[p]) out << ',';
      write_ring(r);
    }
    out << close;
  }
}

void write_number(TextOutput& out, std::int64_t value) {
  if (value < 0) out << '-';
  out << static_cast<std::uint64_t>(value < 0 ? -value : value);
}

void write_topojson_geometry(TextOutput& out, const Layer& layer, const LayerArcs& arcs,
                             std::size_t f) {
  const std::size_t polygons = layer.feature_begin[f + 1] - layer.feature_begin[f];
  out << R"({"type":)"
      << (polygons == 0   ? "null"
          : polygons == 1 ? R"("Polygon")"
                          : R"("MultiPolygon")");
  if (!layer.id(f).empty()) out << R"(,"id":)" << layer.id(f);
  if (!layer.properties(f).empty()) out << R"(,"properties":)" << layer.properties(f);
  if (polygons > 0) {
    out << R"(,"arcs":)" << (polygons > 1 ? "[" : "");
    write_polygons(out, layer, f, "[]", [&](std::size_t r) {
      out << '[';
      bool is_first = true;
      for (const std::int64_t arc : arcs.arcs_of(r)) {
        if (!is_first) out << ',';
        is_first = false;
        write_number(out, arc);
      }
      out << ']';
    });
    if (polygons > 1) out << ']';
  }
  out << '}';
}

}  // namespace

void write_layer_topojson(std::ostream& stream, const Layer& layer, Context& context) {
  const LayerArcs arcs(layer, context);
  TextOutput out(stream, context);
  out << R"({"type":"Topology","objects":{"layer":{"type":"GeometryCollection","geometries":[)"
      << '\n';
  for (std::size_t f = 0; f < layer.feature_count(); ++f) {
    if (f > 0) out << ",\n";
    write_topojson_geometry(out, layer, arcs, f);
  }
  out << "\n]}},\"arcs\":[\n";
  for (std::size_t i = 0; i < arcs.arc_count(); ++i) {
    out << (i == 0 ? "[" : ",\n[");
    bool is_first = true;
    for (const std::uint32_t v : arcs.arc(i)) {
      const Point2 p = layer.points.approx(v);
      out << (is_first ? "[" : ",[") << p.x << ',' << p.y << ']';
      is_first = false;
    }
    out << ']';
  }
  out << "\n]}\n";
  out.flush();
}

void write_layer_wkt(std::ostream& stream, const Layer& layer, Context& context) {
  TextOutput out(stream, context);
  for (std::size_t f = 0; f < layer.feature_count(); ++f) {
    const std::size_t polygons = layer.feature_begin[f + 1] - layer.feature_begin[f];
    out << (polygons == 0 ? "POLYGON EMPTY" : polygons == 1 ? "POLYGON " : "MULTIPOLYGON (");
    write_polygons(out, layer, f, "()", [&](std::size_t r) {
      const std::span<const std::uint32_t> ring = layer.ring(r);
      out << '(';
      for (std::size_t i = 0; i <= ring.size(); ++i) {
        const Point2 p = layer.points.approx(ring[i < ring.size() ? i : 0]);
        out << (i == 0 ? "" : ",") << p.x << ' ' << p.y;
      }
      out << ')';
    });
    out << (polygons > 1 ? ")\n" : "\n");
  }
  out.flush();
}

}  // namespace plumb
