// At a vertex of the arrangement, each ring of a polygon comes in along one edge and goes out along
// another one; both together are a pass. A curve that runs through the vertex is a pass, too. In
// the order of the edges around the vertex, the passes of rings that only touch are nested like
// brackets. If they are not nested, rings cross there.
//
// If two curves of a polygon lie on an edge, the passes at its ends do not have an order. Such
// edges are overlaps of the polygon with itself. They are joined to connected parts, and passes are
// not looked at there.
//
// Only vertices with four or more edges can be crossings, so coverages cost one visit of each edge.
//
// Tested by tests/plane/self_crossings_test.cpp.
#include "plumb/plane/layer/self_crossings.h"

#include <algorithm>
#include <tuple>
#include <utility>

#include "plumb/base/internal/union_find.h"

namespace plumb {
namespace {

constexpr std::size_t kCurvesOfCheckpoint = 4096;

/// A curve of a polygon at an edge that leaves a vertex.
struct Spoke {
  std::uint32_t polygon;
  std::uint32_t place;  // The number of the edge around the vertex.
  SegmentId curve;
};

class CrossingFinder {
 public:
  CrossingFinder(const CoveredCells& cells, const Layer& layer, Context& context)
      : cells_(cells), complex_(cells.complex()), layer_(layer), context_(context) {}

  std::vector<SelfCrossing> find() {
    find_overlaps();
    for (std::size_t v = 0; v < complex_.vertex_count(); ++v) {
      if (v % kFacesPerCheckpoint == 0) {
        context_.checkpoint("crossings of the layer", v, complex_.vertex_count());
      }
      visit(VertexId(v));
    }
    std::stable_sort(
        found_.begin(), found_.end(),
        [](const SelfCrossing& a, const SelfCrossing& b) { return a.polygon < b.polygon; });
    return std::move(found_);
  }

 private:
  /// Counts curves at edges, and checks the limits from time to time.
  void watch(std::size_t curves) {
    curves_ += curves;
    if (curves_ < kCurvesOfCheckpoint) return;
    context_.checkpoint("crossings of the layer", 0, 0);
    curves_ = 0;
  }
  void find_overlaps();
  void visit(VertexId v);
  bool has_crossing(VertexId v, std::span<const Spoke> spokes);
  bool begins_at(SegmentId curve, VertexId v) const;
  std::uint32_t partner(VertexId v, std::span<const Spoke> spokes, std::size_t i) const;

  const CoveredCells& cells_;
  const PlaneComplex& complex_;
  const Layer& layer_;
  Context& context_;
  std::size_t curves_ = 0;  // The number of curves since the last checkpoint.
  std::vector<SelfCrossing> found_;
  std::vector<SegmentId> origins_;
  std::vector<Spoke> spokes_;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> passes_;
  std::vector<std::uint32_t> open_;
};

/// Finds the connected parts of edges on which two curves of a polygon lie.
void CrossingFinder::find_overlaps() {
  struct End {
    std::uint32_t polygon, vertex, edge;  // The edge is counted with the overlaps.
  };
  std::vector<End> ends;
  std::uint32_t count = 0;
  std::vector<std::uint32_t> polygons;
  for (std::size_t e = 0; e < complex_.edge_count(); ++e) {
    cells_.get_origins(EdgeId(e), origins_);
    watch(origins_.size());
    if (origins_.size() < 2) continue;
    polygons.clear();
    for (const SegmentId s : origins_) {
      if (cells_.is_of_polygon(s)) polygons.push_back(cells_.polygon(s));
    }
    std::sort(polygons.begin(), polygons.end());
    for (std::size_t i = 1; i < polygons.size(); ++i) {
      const bool is_second = polygons[i] == polygons[i - 1];
      const bool is_third = is_second && i > 1 && polygons[i] == polygons[i - 2];
      if (!is_second || is_third) continue;
      const HalfedgeId h = first_half(EdgeId(e));
      for (const VertexId v : {complex_.dcel.origin(h), complex_.dcel.target(h)}) {
        ends.push_back({polygons[i], v.value(), count});
      }
      ++count;
    }
  }
  std::sort(ends.begin(), ends.end(), [](const End& a, const End& b) {
    return std::tie(a.polygon, a.vertex, a.edge) < std::tie(b.polygon, b.vertex, b.edge);
  });
  UnionFind parts(count);
  for (std::size_t i = 1; i < ends.size(); ++i) {
    const bool is_joined =
        ends[i].polygon == ends[i - 1].polygon && ends[i].vertex == ends[i - 1].vertex;
    if (is_joined) parts.unite(ends[i].edge, ends[i - 1].edge);
  }
  std::vector<std::uint8_t> is_told(count, 0);
  for (const End& end : ends) {
    if (std::exchange(is_told[parts.root(end.edge)], 1) != 0) continue;
    found_.push_back({end.polygon, VertexId(end.vertex)});
  }
}

/// Finds the polygons whose rings cross at a vertex.
void CrossingFinder::visit(VertexId v) {
  if (complex_.dcel.is_isolated(v)) return;
  std::uint32_t edges = 0;
  for ([[maybe_unused]] const HalfedgeId h : complex_.dcel.around(v)) ++edges;
  if (edges < 4) return;
  spokes_.clear();
  std::uint32_t place = 0;
  for (const HalfedgeId h : complex_.dcel.around(v)) {
    cells_.get_origins(edge_of(h), origins_);
    watch(origins_.size());
    for (const SegmentId s : origins_) {
      if (cells_.is_of_polygon(s)) spokes_.push_back({cells_.polygon(s), place, s});
    }
    ++place;
  }
  std::sort(spokes_.begin(), spokes_.end(), [](const Spoke& a, const Spoke& b) {
    return a.polygon != b.polygon ? a.polygon < b.polygon : a.curve.value() < b.curve.value();
  });
  for (std::size_t begin = 0; begin < spokes_.size();) {
    std::size_t end = begin;
    while (end < spokes_.size() && spokes_[end].polygon == spokes_[begin].polygon) ++end;
    const std::span<const Spoke> own(spokes_.data() + begin, end - begin);
    watch(own.size());
    if (own.size() >= 4 && has_crossing(v, own)) found_.push_back({own.front().polygon, v});
    begin = end;
  }
}

/// Whether passes of a polygon cross at a vertex. Requires spokes in the order of the curves.
bool CrossingFinder::has_crossing(VertexId v, std::span<const Spoke> spokes) {
  passes_.clear();  // For each spoke, its place and the place of its partner.
  for (std::size_t i = 0; i < spokes.size(); ++i) {
    passes_.emplace_back(spokes[i].place, partner(v, spokes, i));
  }
  std::sort(passes_.begin(), passes_.end());
  for (std::size_t i = 1; i < passes_.size(); ++i) {
    if (passes_[i].first == passes_[i - 1].first) return false;  // The edge is an overlap.
  }
  open_.clear();
  for (const auto& [here, there] : passes_) {
    if (there > here) {
      open_.push_back(here);
    } else if (there == here || open_.empty() || open_.back() != there) {
      return true;
    } else {
      open_.pop_back();
    }
  }
  return false;
}

/// Whether a curve that ends at a vertex begins there.
bool CrossingFinder::begins_at(SegmentId curve, VertexId v) const {
  const std::uint32_t corner = cells_.curve(curve).from;
  const std::uint32_t point = complex_.vertex_point[v];
  return layer_.points.exact(corner) == exact(complex_.points, point);
}

/// Returns the place of the other spoke of the pass of a spoke.
std::uint32_t CrossingFinder::partner(VertexId v, std::span<const Spoke> spokes,
                                      std::size_t i) const {
  const SegmentId curve = spokes[i].curve;
  if (i > 0 && spokes[i - 1].curve == curve) return spokes[i - 1].place;
  if (i + 1 < spokes.size() && spokes[i + 1].curve == curve) return spokes[i + 1].place;
  // The curve ends here. Its neighbour in the ring is the next curve at this vertex, because curves
  // of length zero have no edges.
  const CoveredCells::CurveRange ring = cells_.ring_of(curve);
  const bool goes_out = begins_at(curve, v);
  const std::uint32_t count = ring.end - ring.begin;
  for (std::uint32_t step = 1; step < count; ++step) {
    const std::uint32_t at = curve.value() - ring.begin;
    const SegmentId other(ring.begin + (at + (goes_out ? count - step : step)) % count);
    const auto found =
        std::lower_bound(spokes.begin(), spokes.end(), other.value(),
                         [](const Spoke& s, std::uint32_t c) { return s.curve.value() < c; });
    if (found != spokes.end() && found->curve == other) return found->place;
  }
  return spokes[i].place;
}

}  // namespace

std::vector<SelfCrossing> self_crossings(const CoveredCells& cells, const Layer& layer,
                                         Context& context) {
  return CrossingFinder(cells, layer, context).find();
}

}  // namespace plumb
