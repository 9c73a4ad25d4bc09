// The lists of features follow from the list of face 0, which is empty. Across an edge, the list
// changes by the polygons that have an odd number of curves on the edge. The dual graph of an
// arrangement is connected, so one search visits all faces.
//
// A polygon covers exactly one side of an edge on which it has one curve. If its rings are nested
// as they should be, this is the inner side of the outer ring and the outer side of a hole. A hole
// that lies outside of the outer ring, or in another hole, has the polygon on its inner side
// instead.
//
// Tested by tests/plane/layer_test.cpp, which compares with cells of a grid, and by
// tests/plane/misplaced_holes_test.cpp.
#include "plumb/plane/layer/covered_cells.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "plumb/base/internal/union_find.h"
#include "plumb/predicates/plane/plane_points.h"

namespace plumb {
namespace {

// The memory of curves, faces, lists and labels. The arrangements charge their own memory
// separately.
constexpr std::uint64_t kBytesPerLayerCorner = 120;

}  // namespace

CoveredCells::CoveredCells(const Layer& layer, const Bridges& bridges, Context& context)
    : context_(context),
      memory_(context),
      corner_points_(layer.points),
      has_bridges_(!bridges.segments.empty()) {
  arrange_rings(layer, bridges);
  find_misplaced_holes(layer);
  name_features(layer);
}

CoveredCells::CoveredCells(const Layer& layer, Context& context)
    : context_(context), memory_(context), corner_points_(layer.points), has_bridges_(false) {
  arrange_rings(layer, Bridges());
  name_features(layer);
}

/// Arranges rings and bridges, and makes the lists of the polygons that cover each face.
void CoveredCells::arrange_rings(const Layer& layer, const Bridges& bridges) {
  const std::size_t curves = layer.ring_corners.size() + bridges.segments.size();
  memory_.add(kBytesPerLayerCorner * curves, "the cells of a layer");
  add_curves(layer);
  const auto offset = static_cast<std::uint32_t>(layer.points.size());
  for (const SweepSegment& s : bridges.segments) {
    curves_.push_back({offset + s.from, offset + s.to});
  }
  polygon_.resize(curves_.size(), kNoPolygon);
  PointTable2 points = layer.points;
  points.append(bridges.points);
  arrangement_ = arrange(std::move(points), curves_, context_);
  visit_faces();
}

bool CoveredCells::is_same_cover(FaceId f, FaceId g) const {
  const FeatureList a = features(f), b = features(g);
  return std::equal(a.begin(), a.end(), b.begin(), b.end());
}

bool CoveredCells::is_open_bridge(EdgeId e) const {
  if (!has_bridges_) return false;
  const HalfedgeId h = first_half(e);
  if (!features(complex().dcel.face(h)).empty()) return false;
  if (!features(complex().dcel.face(twin(h))).empty()) return false;
  const std::vector<SegmentId> origins = arrangement_.origins_of(e);
  return std::none_of(origins.begin(), origins.end(),
                      [this](SegmentId s) { return is_of_polygon(s); });
}

std::vector<std::uint8_t> CoveredCells::corners() const {
  if (!has_bridges_) return {};
  std::vector<std::uint8_t> is_corner(complex().vertex_count(), 0);
  std::vector<SegmentId> origins;
  for (std::size_t e = 0; e < complex().edge_count(); ++e) {
    origins.clear();
    arrangement_.origin_sets.append(arrangement_.origins[e], origins);
    const HalfedgeId h = first_half(EdgeId(e));
    for (const VertexId v : {complex().dcel.origin(h), complex().dcel.target(h)}) {
      const std::uint32_t point = complex().vertex_point[v];
      if (point >= complex().points.inputs.size()) continue;  // The vertex is a crossing.
      const Point2 at = approx(complex().points, point);
      for (const SegmentId s : origins) {
        if (!is_of_polygon(s)) break;
        const SweepSegment curve = curves_[s.value()];
        const Point2 p = corner_points_.approx(curve.from), q = corner_points_.approx(curve.to);
        if ((p.x == at.x && p.y == at.y) || (q.x == at.x && q.y == at.y)) is_corner[v.value()] = 1;
      }
    }
  }
  return is_corner;
}

void CoveredCells::add_curves(const Layer& layer) {
  for (std::uint32_t p = 0; p < layer.polygon_count(); ++p) {
    for (std::size_t r = layer.polygon_begin[p]; r < layer.polygon_begin[p + 1]; ++r) {
      const FeatureList ring = layer.ring(r);
      ring_begin_.push_back(static_cast<std::uint32_t>(curves_.size()));
      for (std::size_t i = 0; i < ring.size(); ++i) {
        const std::uint32_t next = ring[i + 1 < ring.size() ? i + 1 : 0];
        if (ring[i] == next) continue;
        curves_.push_back({ring[i], next});
        polygon_.push_back(p);
      }
    }
  }
  ring_begin_.push_back(static_cast<std::uint32_t>(curves_.size()));
}

CoveredCells::CurveRange CoveredCells::ring_of(SegmentId s) const {
  const auto end = std::upper_bound(ring_begin_.begin(), ring_begin_.end(), s.value());
  return {*std::prev(end), *end};
}

/// Visits all faces, from face 0 across edges.
void CoveredCells::visit_faces() {
  const Dcel& dcel = complex().dcel;
  const std::size_t faces = complex().face_count();
  // The half-edges, sorted by their faces.
  std::vector<std::uint32_t> begin(faces + 1, 0), halves(2 * complex().edge_count());
  for (std::size_t h = 0; h < halves.size(); ++h) ++begin[dcel.face(HalfedgeId(h)).value() + 1];
  for (std::size_t f = 0; f < faces; ++f) begin[f + 1] += begin[f];
  std::vector<std::uint32_t> end(begin.begin(), begin.end() - 1);
  for (std::size_t h = 0; h < halves.size(); ++h) {
    halves[end[dcel.face(HalfedgeId(h)).value()]++] = static_cast<std::uint32_t>(h);
  }
  first_.assign(faces, 0);
  last_.assign(faces, 0);
  std::vector<std::uint8_t> is_known(faces, 0);
  std::vector<FaceId> queue{FaceId(0)};
  is_known[0] = 1;
  for (std::size_t i = 0; i < queue.size(); ++i) {
    if (i % kFacesPerCheckpoint == 0) context_.checkpoint("cells of the layer", i, faces);
    const FaceId from = queue[i];
    for (std::size_t k = begin[from.value()]; k < begin[from.value() + 1]; ++k) {
      const HalfedgeId h(halves[k]);
      const FaceId to = dcel.face(twin(h));
      if (is_known[to.value()] != 0) continue;
      is_known[to.value()] = 1;
      enter(from, to, edge_of(h));
      queue.push_back(to);
    }
  }
}

/// Makes the list of a face. It is the list of its neighbour, changed by the polygons of the edge.
void CoveredCells::enter(FaceId from, FaceId to, EdgeId across) {
  origins_.clear();
  arrangement_.origin_sets.append(arrangement_.origins[across.value()], origins_);
  // Bridges are the last curves, and origins ascend.
  while (!origins_.empty() && !is_of_polygon(origins_.back())) origins_.pop_back();
  const std::size_t size = last_[from] - first_[from] + origins_.size();
  memory_.add(size * sizeof(std::uint32_t), "the cells of a layer");
  const std::size_t begin = lists_.size();
  lists_.insert(lists_.end(), size, 0);
  std::copy_n(lists_.begin() + static_cast<std::ptrdiff_t>(first_[from]),
              last_[from] - first_[from], lists_.begin() + static_cast<std::ptrdiff_t>(begin));
  std::size_t at = begin + (last_[from] - first_[from]);
  for (const SegmentId s : origins_) lists_[at++] = polygon_[s.value()];
  const auto list = lists_.begin() + static_cast<std::ptrdiff_t>(begin);
  std::sort(list, lists_.end());
  // If a polygon occurs an even number of times, it does not cover the face.
  auto kept = list;
  for (auto i = list; i != lists_.end();) {
    const auto next = std::upper_bound(i, lists_.end(), *i);
    if ((next - i) % 2 != 0) *kept++ = *i;
    i = next;
  }
  lists_.erase(kept, lists_.end());
  first_[to] = begin;
  last_[to] = lists_.size();
}

/// Returns the ring of a curve. O(log(rings)).
std::uint32_t CoveredCells::ring_index(SegmentId s) const {
  const auto end = std::upper_bound(ring_begin_.begin(), ring_begin_.end(), s.value());
  return static_cast<std::uint32_t>(end - ring_begin_.begin() - 1);
}

/// Whether the polygon of a curve covers the inner side of an edge on which the curve lies. `turn`
/// is the sense in which the ring of the curve runs.
bool CoveredCells::covers_inner_side(SegmentId curve, EdgeId e, Sign turn) const {
  // The first half of an edge runs from left to right.
  const SweepSegment& ends = curves_[curve.value()];
  const bool runs_right = compare_xy(corner_points_, ends.from, ends.to) == Sign::Negative;
  const bool is_left = runs_right == (turn == Sign::Positive);
  const FaceId inner = complex().dcel.face(is_left ? first_half(e) : twin(first_half(e)));
  const FeatureList polygons = features(inner);  // Not yet replaced by features.
  return std::binary_search(polygons.begin(), polygons.end(), polygon(curve));
}

/// Finds misplaced holes. Requires that lists contain polygons.
void CoveredCells::find_misplaced_holes(const Layer& layer) {
  if (layer.ring_count() == layer.polygon_count()) return;
  struct Hole {
    Sign turn = Sign::Zero;
    bool is_seen = false;      // Whether an edge was looked at.
    bool is_misplaced = true;  // Whether all these edges are as those of an outer ring.
  };
  std::vector<Hole> holes(layer.ring_count());
  std::size_t work = 0;
  for (std::uint32_t e = 0; e < complex().edge_count(); ++e) {
    get_origins(EdgeId(e), origins_);
    for (std::size_t i = 0; i < origins_.size() && is_of_polygon(origins_[i]); ++i) {
      if (work++ % kFacesPerCheckpoint == 0) {
        context_.checkpoint("holes of the layer", e, complex().edge_count());
      }
      const std::uint32_t p = polygon(origins_[i]);
      // Curves ascend, and curves of the outer ring are the first ones of a polygon.
      if (origins_[i].value() < ring_begin_[layer.polygon_begin[p] + 1]) continue;
      const auto is_of_p = [&](SegmentId s) { return is_of_polygon(s) && polygon(s) == p; };
      if (i > 0 && is_of_p(origins_[i - 1])) continue;
      if (i + 1 < origins_.size() && is_of_p(origins_[i + 1])) continue;
      const std::uint32_t r = ring_index(origins_[i]);
      Hole& hole = holes[r];
      if (!hole.is_misplaced) continue;
      if (!hole.is_seen) hole.turn = polygon_area_sign(corner_points_, layer.ring(r));
      hole.is_seen = true;
      hole.is_misplaced =
          hole.turn != Sign::Zero && covers_inner_side(origins_[i], EdgeId(e), hole.turn);
    }
  }
  for (std::uint32_t r = 0; r < holes.size(); ++r) {
    if (holes[r].is_seen && holes[r].is_misplaced) misplaced_holes_.push_back(r);
  }
}

/// Replaces polygons by their features, each once, and marks the faces where a feature occurs
/// twice.
void CoveredCells::name_features(const Layer& layer) {
  std::vector<std::uint32_t> feature(layer.polygon_count());
  for (std::uint32_t f = 0; f < layer.feature_count(); ++f) {
    std::fill(feature.begin() + layer.feature_begin[f],
              feature.begin() + layer.feature_begin[f + 1], f);
  }
  for (std::uint32_t& entry : lists_) entry = feature[entry];
  for (std::size_t f = 0; f < first_.size(); ++f) {
    const auto begin = lists_.begin() + static_cast<std::ptrdiff_t>(first_[f]);
    const auto end = lists_.begin() + static_cast<std::ptrdiff_t>(last_[f]);
    const auto kept = std::unique(begin, end);
    if (kept != end) {
      is_doubled_.resize(first_.size(), 0);
      is_doubled_[f] = 1;
    }
    last_[f] = first_[f] + static_cast<std::size_t>(kept - begin);
  }
}

std::vector<std::uint32_t> first_features(const CoveredCells& cells) {
  std::vector<std::uint32_t> first(cells.complex().face_count(), LayerRegion::kNobody);
  for (std::size_t f = 0; f < first.size(); ++f) {
    const FeatureList features = cells.features(FaceId(f));
    if (!features.empty()) first[f] = features.front();
  }
  return first;
}

std::size_t count_overlaps(const CoveredCells& cells, FeatureRange range,
                           std::span<const std::uint32_t> class_of) {
  const auto features = [&](FaceId f) {
    const FeatureList all = cells.features(f);
    const auto begin = std::lower_bound(all.begin(), all.end(), range.begin);
    return FeatureList(begin, std::lower_bound(begin, all.end(), range.end));
  };
  const PlaneComplex& complex = cells.complex();
  UnionFind regions(complex.face_count());
  for (std::size_t e = 0; e < complex.edge_count(); ++e) {
    const HalfedgeId h = first_half(EdgeId(e));
    const FaceId f = complex.dcel.face(h), g = complex.dcel.face(twin(h));
    const FeatureList a = features(f), b = features(g);
    if (std::equal(a.begin(), a.end(), b.begin(), b.end())) regions.unite(f.value(), g.value());
  }
  std::size_t count = 0;
  for (std::uint32_t f = 0; f < complex.face_count(); ++f) {
    const FeatureList covering = features(FaceId(f));
    const bool is_overlap =
        class_of.empty() ? covering.size() > 1
                         : std::any_of(covering.begin(), covering.end(), [&](std::uint32_t i) {
                             return class_of[i] != class_of[covering.front()];
                           });
    if (is_overlap && regions.root(f) == f) ++count;
  }
  return count;
}

}  // namespace plumb
