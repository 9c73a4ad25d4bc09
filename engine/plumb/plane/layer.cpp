// Repair of layers: cells, regions, owners, polygons.
//
// All features are arranged exactly, so every question about overlaps and gaps is one about the
// faces of the arrangement and the lists of the features that cover them. Lists follow from the
// list of face 0, which is empty: across an edge, those polygons change that have an odd number of
// curves on the edge. The dual graph of an arrangement is connected, so one search visits all
// faces.
//
// The result is made of labels of faces (owners). Edges between equal labels are left out, and the
// pieces of one curve that remain on both sides of a left-out crossing become one curve again, so
// that rounding does not bend borders at crossings that are no longer there. What is left is
// arranged again, rounded as one subdivision, and read off face by face. Rounding may remove a
// narrow face between two faces with equal labels, so edges between equal labels are left out once
// more. Then neighbouring faces have different labels, and each face is one polygon.
//
// Tested by tests/plane/layer_test.cpp, which compares with cells of a grid.

#include "plumb/plane/layer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "plumb/base/internal/union_find.h"
#include "plumb/plane/arrangement.h"
#include "plumb/plane/plane_measure.h"
#include "plumb/predicates/arithmetic/rational_sum.h"
#include "plumb/predicates/rounding.h"

namespace plumb {
namespace {

constexpr std::uint32_t kNobody = LayerRegion::kNobody;
constexpr std::size_t kFacesPerCheckpoint = 1024;
constexpr double kGapsPerDiagonal = 1e-4;
// Curves, faces, lists and labels; the arrangements charge their own memory besides.
constexpr std::uint64_t kBytesPerLayerCorner = 120;

using Numbers = std::span<const std::uint32_t>;

double length_of(const PlaneComplex& complex, EdgeId e) {
  const Point2 p = approx(complex.points, complex.vertex_point[complex.dcel.origin(first_half(e))]);
  const Point2 q = approx(complex.points, complex.vertex_point[complex.dcel.target(first_half(e))]);
  return std::hypot(q.x - p.x, q.y - p.y);
}

// ---------------------------------------------------------------- cells

/// The arrangement of all rings, with the features that cover each face.
class CoveredCells {
 public:
  CoveredCells(const Layer& layer, Context& context) : context_(context), memory_(context) {
    memory_.add(kBytesPerLayerCorner * layer.ring_corners.size(), "the cells of a layer");
    add_curves(layer);
    arrangement_ = arrange(layer.points, curves_, context);
    visit_faces();
    name_features(layer);
  }

  const PlaneComplex& complex() const { return arrangement_.complex; }
  /// Returns the features that cover a face, in ascending order.
  Numbers features(FaceId f) const { return {lists_.data() + first_[f], lists_.data() + last_[f]}; }

 private:
  void add_curves(const Layer& layer);
  void visit_faces();
  void enter(FaceId from, FaceId to, EdgeId across);
  void name_features(const Layer& layer);

  Context& context_;
  MemoryCharge memory_;
  std::vector<SweepSegment> curves_;
  std::vector<std::uint32_t> polygon_;  // For each curve, its polygon.
  Arrangement arrangement_;
  std::vector<std::uint32_t> lists_;  // Polygons, later features, of all faces.
  IdVector<FaceId, std::size_t> first_, last_;
  std::vector<SegmentId> origins_;
};

void CoveredCells::add_curves(const Layer& layer) {
  for (std::uint32_t p = 0; p < layer.polygon_count(); ++p) {
    for (std::size_t r = layer.polygon_begin[p]; r < layer.polygon_begin[p + 1]; ++r) {
      const Numbers ring = layer.ring(r);
      for (std::size_t i = 0; i < ring.size(); ++i) {
        const std::uint32_t next = ring[i + 1 < ring.size() ? i + 1 : 0];
        if (ring[i] == next) continue;
        curves_.push_back({ring[i], next});
        polygon_.push_back(p);
      }
    }
  }
}

/// Visits all faces, from face 0 across edges.
void CoveredCells::visit_faces() {
  const Dcel& dcel = complex().dcel;
  const std::size_t faces = complex().face_count();
  // Half-edges sorted by their faces.
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

/// Makes the list of a face: that of its neighbour, changed by the polygons of the edge.
void CoveredCells::enter(FaceId from, FaceId to, EdgeId across) {
  origins_.clear();
  arrangement_.origin_sets.append(arrangement_.origins[across.value()], origins_);
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
  // A polygon that occurs an even number of times does not cover the face.
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

/// Replaces polygons by their features, each once.
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
    last_[f] = first_[f] + static_cast<std::size_t>(std::unique(begin, end) - begin);
  }
}

// ---------------------------------------------------------------- polygons of labelled faces

/// The labels at both sides of a curve that is kept.
struct SideLabels {
  std::uint32_t left;
  std::uint32_t right;
};

/// The edges between faces with different labels, as curves.
class LabelBorders {
 public:
  LabelBorders(const PlaneComplex& complex, const std::vector<std::uint32_t>& label)
      : complex_(complex), label_(label), degree_(complex.vertex_count(), 0) {
    for (std::size_t e = 0; e < complex.edge_count(); ++e) count(EdgeId(e));
    // Edges are numbered by their left ends, so the first edge of a chain comes first.
    is_taken_.assign(complex.edge_count(), 0);
    for (std::size_t e = 0; e < complex.edge_count(); ++e) {
      if (is_kept(EdgeId(e)) && is_taken_[e] == 0) add_chain(EdgeId(e));
    }
  }

  const std::vector<SweepCurve>& curves() const { return curves_; }
  const std::vector<SideLabels>& sides() const { return sides_; }

 private:
  std::uint32_t left(EdgeId e) const { return label_[complex_.dcel.face(first_half(e)).value()]; }
  std::uint32_t right(EdgeId e) const {
    return label_[complex_.dcel.face(twin(first_half(e))).value()];
  }
  bool is_kept(EdgeId e) const { return left(e) != right(e); }
  void count(EdgeId e);
  void add_chain(EdgeId first);
  std::optional<EdgeId> continuation(EdgeId e) const;

  const PlaneComplex& complex_;
  const std::vector<std::uint32_t>& label_;
  // For each vertex, the number of kept edges, and the last one that goes to the right.
  std::vector<std::uint32_t> degree_;
  IdVector<VertexId, EdgeId> rightward_ = IdVector<VertexId, EdgeId>(degree_.size());
  std::vector<std::uint8_t> is_taken_;
  std::vector<SweepCurve> curves_;
  std::vector<SideLabels> sides_;
};

void LabelBorders::count(EdgeId e) {
  if (!is_kept(e)) return;
  const HalfedgeId h = first_half(e);
  ++degree_[complex_.dcel.origin(h).value()];
  ++degree_[complex_.dcel.target(h).value()];
  rightward_[complex_.dcel.origin(h)] = e;
}

/// Returns the edge that continues e to the right on the same line, if they meet in a crossing that
/// no other kept edge meets.
std::optional<EdgeId> LabelBorders::continuation(EdgeId e) const {
  const VertexId v = complex_.dcel.target(first_half(e));
  const bool is_crossing = complex_.vertex_point[v] >= complex_.points.inputs.size();
  if (!is_crossing || degree_[v.value()] != 2 || !rightward_[v].is_valid()) return {};
  const EdgeId next = rightward_[v];
  const PlaneLine line = complex_.line[e], other = complex_.line[next];
  const PlanePointsView points(complex_.points);
  const bool is_straight =
      line == other || (orient2d(points, line.a, line.b, other.a) == Sign::Zero &&
                        orient2d(points, line.a, line.b, other.b) == Sign::Zero);
  return is_straight ? std::optional(next) : std::nullopt;
}

void LabelBorders::add_chain(EdgeId first) {
  EdgeId last = first;
  for (;;) {
    is_taken_[last.value()] = 1;
    const std::optional<EdgeId> next = continuation(last);
    if (!next) break;
    last = *next;
  }
  const Dcel& dcel = complex_.dcel;
  const PlaneLine line = complex_.line[first];
  curves_.push_back({complex_.vertex_point[dcel.origin(first_half(first))],
                     complex_.vertex_point[dcel.target(first_half(last))], line.a, line.b});
  sides_.push_back({left(first), right(first)});
}

/// A subdivision with a label for each face.
struct LabelledComplex {
  PlaneComplex complex;
  std::vector<std::uint32_t> label;
};

/// Returns the subdivision without the edges between equal labels.
LabelledComplex without_inner_edges(const PlaneComplex& complex,
                                    const std::vector<std::uint32_t>& label, Context& context) {
  const LabelBorders borders(complex, label);
  Arrangement kept = arrange(complex.points, borders.curves(), {}, context);
  LabelledComplex result{std::move(kept.complex), {}};
  result.label.assign(result.complex.face_count(), kNobody);
  std::vector<SegmentId> origins;
  for (std::size_t e = 0; e < result.complex.edge_count(); ++e) {
    origins.clear();
    kept.origin_sets.append(kept.origins[e], origins);
    const HalfedgeId h = first_half(EdgeId(e));
    const SideLabels sides = borders.sides()[origins.front().value()];
    result.label[result.complex.dcel.face(h).value()] = sides.left;
    result.label[result.complex.dcel.face(twin(h)).value()] = sides.right;
  }
  return result;
}

bool has_inner_edges(const LabelledComplex& labelled) {
  const Dcel& dcel = labelled.complex.dcel;
  for (std::size_t e = 0; e < labelled.complex.edge_count(); ++e) {
    const HalfedgeId h = first_half(EdgeId(e));
    if (labelled.label[dcel.face(h).value()] == labelled.label[dcel.face(twin(h)).value()]) {
      return true;
    }
  }
  return false;
}

/// Appends the rings of a face as a polygon.
void append_polygon(Layer& layer, const PlaneComplex& complex, FaceId f) {
  for (const std::vector<VertexId>& ring : face_rings(complex, f)) {
    for (const VertexId v : ring) layer.ring_corners.push_back(v.value());
    layer.end_ring();
  }
  layer.end_polygon();
}

/// A layer whose feature k consists of the faces with label k.
struct LabelledLayer {
  Layer layer;
  PlaneRoundingReport rounding;
};

/// Returns the layer of the labels of faces. Ids and properties are those of `named`, if any.
LabelledLayer layer_of_labels(const PlaneComplex& complex, const std::vector<std::uint32_t>& label,
                              std::size_t label_count, const Layer* named, Context& context) {
  const LabelledComplex kept = without_inner_edges(complex, label, context);
  RoundedSubdivision rounded = round_to_doubles(kept.complex, context);
  LabelledComplex written{std::move(rounded.complex), {}};
  for (const FaceId f : rounded.exact_face) written.label.push_back(kept.label[f.value()]);
  // If a narrow face vanishes, the faces beside it may have the same label.
  if (has_inner_edges(written)) {
    written = without_inner_edges(written.complex, written.label, context);
  }
  const PlaneComplex& result = written.complex;
  std::vector<std::pair<std::uint32_t, FaceId>> faces;
  for (std::size_t f = 0; f < result.face_count(); ++f) {
    if (written.label[f] != kNobody) faces.push_back({written.label[f], FaceId(f)});
  }
  std::sort(faces.begin(), faces.end(), [](const auto& a, const auto& b) {
    return a.first != b.first ? a.first < b.first : a.second.value() < b.second.value();
  });
  Layer layer;
  layer.points.reserve(result.vertex_count());
  for (const std::uint32_t p : result.vertex_point) {
    layer.points.push_back(result.points.inputs.approx(p));
  }
  auto next = faces.begin();
  for (std::uint32_t l = 0; l < label_count; ++l) {
    if (l % kFacesPerCheckpoint == 0) context.checkpoint("polygons", l, label_count);
    for (; next != faces.end() && next->first == l; ++next) {
      append_polygon(layer, result, next->second);
    }
    layer.end_feature(named == nullptr ? "" : named->id(l),
                      named == nullptr ? "" : named->properties(l));
  }
  return {std::move(layer), rounded.report};
}

// ---------------------------------------------------------------- regions and their owners

/// A piece of the boundary of a region, with the feature on its other side.
struct BorderPiece {
  std::uint32_t region;
  std::uint32_t feature;
  double length;
};

/// Sums up the lengths of the pieces with the same region and feature. Sorts the pieces.
void unite_pieces(std::vector<BorderPiece>& pieces) {
  std::stable_sort(pieces.begin(), pieces.end(), [](const BorderPiece& a, const BorderPiece& b) {
    return a.region != b.region ? a.region < b.region : a.feature < b.feature;
  });
  std::size_t kept = 0;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const bool is_same = kept > 0 && pieces[kept - 1].region == pieces[i].region &&
                         pieces[kept - 1].feature == pieces[i].feature;
    if (is_same) {
      pieces[kept - 1].length += pieces[i].length;
    } else {
      pieces[kept++] = pieces[i];
    }
  }
  pieces.resize(kept);
}

/// Finds overlaps and uncovered regions, and selects their owners.
class LayerRepair {
 public:
  LayerRepair(const Layer& layer, const LayerRepairOptions& options, Context& context)
      : layer_(layer),
        options_(options),
        context_(context),
        cells_(layer, context),
        complex_(cells_.complex()),
        owner_(complex_.face_count(), kNobody),
        region_(complex_.face_count(), kNobody) {}

  RepairedLayer run() {
    find_regions();
    measure_regions();
    measure_features();
    find_gaps();
    own_overlaps();
    own_gaps();
    LabelledLayer result =
        layer_of_labels(complex_, owner_, layer_.feature_count(), &layer_, context_);
    report_.shapes =
        layer_of_labels(complex_, region_, report_.regions.size(), nullptr, context_).layer;
    report_.rounding = result.rounding;
    find_emptied(result.layer);
    return {std::move(result.layer), std::move(report_)};
  }

 private:
  FaceId left(std::size_t e) const { return complex_.dcel.face(first_half(EdgeId(e))); }
  FaceId right(std::size_t e) const { return complex_.dcel.face(twin(first_half(EdgeId(e)))); }
  bool is_same_cover(FaceId f, FaceId g) const {
    const Numbers a = cells_.features(f), b = cells_.features(g);
    return std::equal(a.begin(), a.end(), b.begin(), b.end());
  }
  bool is_uncovered(const LayerRegion& region) const {
    return region.kind != LayerRegionKind::Overlap;
  }
  void find_regions();
  void measure_regions();
  void measure_features();
  void find_gaps();
  double default_gap_width() const;
  std::vector<BorderPiece> borders(bool of_overlaps) const;
  void own_overlaps();
  void own_gaps();
  std::uint32_t select(Numbers candidates, std::span<const BorderPiece> borders) const;
  double worth(std::uint32_t feature, std::span<const BorderPiece> borders) const;
  void find_emptied(const Layer& result);

  const Layer& layer_;
  const LayerRepairOptions& options_;
  Context& context_;
  CoveredCells cells_;
  const PlaneComplex& complex_;
  std::vector<std::uint32_t> owner_;    // For each face, the feature that gets it.
  std::vector<std::uint32_t> region_;   // For each face, its region in the report.
  std::vector<double> area_;            // For each feature, its area.
  std::vector<std::uint8_t> is_alone_;  // For each feature, whether it alone covers some face.
  LayerReport report_;
};

/// Numbers the regions of faces that not exactly one feature covers. Face 0 belongs to none.
void LayerRepair::find_regions() {
  UnionFind classes(complex_.face_count());
  for (std::size_t e = 0; e < complex_.edge_count(); ++e) {
    if (is_same_cover(left(e), right(e))) classes.unite(left(e).value(), right(e).value());
  }
  for (std::uint32_t f = 0; f < complex_.face_count(); ++f) {
    const Numbers features = cells_.features(FaceId(f));
    if (features.size() == 1) owner_[f] = features.front();
    const std::uint32_t root = classes.root(f);
    if (features.size() == 1 || root == 0) continue;
    if (root == f) {
      region_[f] = static_cast<std::uint32_t>(report_.regions.size());
      const auto begin = static_cast<std::uint32_t>(report_.features.size());
      report_.features.insert(report_.features.end(), features.begin(), features.end());
      const auto end = static_cast<std::uint32_t>(report_.features.size());
      report_.regions.push_back(
          {features.empty() ? LayerRegionKind::Hole : LayerRegionKind::Overlap, 0, 0, begin, end,
           kNobody});
    }
    region_[f] = region_[root];
  }
}

/// Computes areas and widths.
void LayerRepair::measure_regions() {
  std::vector<RationalSum> area(report_.regions.size());
  for (std::size_t f = 0; f < complex_.face_count(); ++f) {
    if (f % kFacesPerCheckpoint == 0) context_.checkpoint("areas", f, complex_.face_count());
    if (region_[f] != kNobody) area[region_[f]].add(face_area(complex_, FaceId(f)).value_or(0));
  }
  std::vector<double> perimeter(report_.regions.size(), 0);
  for (std::size_t e = 0; e < complex_.edge_count(); ++e) {
    const std::uint32_t l = region_[left(e).value()], r = region_[right(e).value()];
    if (l == r) continue;
    const double length = length_of(complex_, EdgeId(e));
    if (l != kNobody) perimeter[l] += length;
    if (r != kNobody) perimeter[r] += length;
  }
  for (std::size_t i = 0; i < report_.regions.size(); ++i) {
    LayerRegion& region = report_.regions[i];
    region.area = area[i].total();
    region.width = 2 * nearest_double(region.area) / perimeter[i];
  }
}

/// Computes the areas of features in doubles, as sums of the areas of their faces.
void LayerRepair::measure_features() {
  std::vector<double> of_face(complex_.face_count(), 0);
  for (std::size_t e = 0; e < complex_.edge_count(); ++e) {
    const HalfedgeId h = first_half(EdgeId(e));
    const Point2 p = approx(complex_.points, complex_.vertex_point[complex_.dcel.origin(h)]);
    const Point2 q = approx(complex_.points, complex_.vertex_point[complex_.dcel.target(h)]);
    const double trapezoid = (p.x - q.x) * (p.y + q.y) / 2;
    of_face[left(e).value()] += trapezoid;
    of_face[right(e).value()] -= trapezoid;
  }
  area_.assign(layer_.feature_count(), 0);
  is_alone_.assign(layer_.feature_count(), 0);
  for (std::size_t f = 0; f < complex_.face_count(); ++f) {
    const Numbers features = cells_.features(FaceId(f));
    for (const std::uint32_t feature : features) area_[feature] += of_face[f];
    if (features.size() == 1) is_alone_[features.front()] = 1;
  }
}

double LayerRepair::default_gap_width() const {
  if (complex_.vertex_count() == 0) return 0;
  Point2 low = approx(complex_.points, complex_.vertex_point[0]), high = low;
  for (const std::uint32_t i : complex_.vertex_point) {
    const Point2 p = approx(complex_.points, i);
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  return kGapsPerDiagonal * std::hypot(high.x - low.x, high.y - low.y);
}

void LayerRepair::find_gaps() {
  report_.gaps_below = options_.gaps_below ? *options_.gaps_below : default_gap_width();
  for (LayerRegion& region : report_.regions) {
    if (is_uncovered(region) && region.width < report_.gaps_below) {
      region.kind = LayerRegionKind::Gap;
    }
  }
}

/// Returns the borders between regions of one sort and faces that have owners.
std::vector<BorderPiece> LayerRepair::borders(bool of_overlaps) const {
  std::vector<BorderPiece> pieces;
  const auto add = [&](FaceId inside, FaceId outside, std::size_t e) {
    const std::uint32_t region = region_[inside.value()], owner = owner_[outside.value()];
    if (region == kNobody || owner == kNobody || region == region_[outside.value()]) return;
    if (is_uncovered(report_.regions[region]) == of_overlaps) return;
    pieces.push_back({region, owner, length_of(complex_, EdgeId(e))});
  };
  for (std::size_t e = 0; e < complex_.edge_count(); ++e) {
    add(left(e), right(e), e);
    add(right(e), left(e), e);
  }
  unite_pieces(pieces);
  return pieces;
}

/// Returns how much a feature deserves a region; the greatest value is selected. Requires borders
/// that are sorted by feature.
double LayerRepair::worth(std::uint32_t feature, std::span<const BorderPiece> borders) const {
  if (options_.rule == OwnerRule::First) return 0;
  if (options_.rule == OwnerRule::Largest) return area_[feature];
  if (options_.rule == OwnerRule::Smallest) return -area_[feature];
  const auto piece =
      std::lower_bound(borders.begin(), borders.end(), feature,
                       [](const BorderPiece& b, std::uint32_t f) { return b.feature < f; });
  return piece == borders.end() || piece->feature != feature ? 0 : piece->length;
}

/// Returns the best candidate; the first one if several are equal. Candidates ascend.
std::uint32_t LayerRepair::select(Numbers candidates, std::span<const BorderPiece> borders) const {
  std::uint32_t best = candidates.front();
  double most = worth(best, borders);
  for (const std::uint32_t feature : candidates.subspan(1)) {
    const double value = worth(feature, borders);
    if (!(value > most)) continue;
    best = feature;
    most = value;
  }
  return best;
}

/// Calls visit(region, its borders) for each region of one sort. Requires sorted borders.
template <class Visit>
void for_each_region(std::vector<LayerRegion>& regions, std::span<const BorderPiece> borders,
                     const Visit& visit) {
  std::size_t begin = 0;
  for (std::uint32_t r = 0; r < regions.size(); ++r) {
    std::size_t end = begin;
    while (end < borders.size() && borders[end].region == r) ++end;
    visit(regions[r], borders.subspan(begin, end - begin));
    begin = end;
  }
}

void LayerRepair::own_overlaps() {
  const std::vector<BorderPiece> pieces = borders(true);
  for_each_region(report_.regions, pieces,
                  [&](LayerRegion& region, std::span<const BorderPiece> around) {
                    if (is_uncovered(region)) return;
                    const Numbers all = report_.features_of(region);
                    const auto lost = std::find_if(
                        all.begin(), all.end(), [&](std::uint32_t f) { return is_alone_[f] == 0; });
                    region.owner = lost != all.end() ? *lost : select(all, around);
                  });
  for (std::size_t f = 0; f < owner_.size(); ++f) {
    if (region_[f] != kNobody) owner_[f] = report_.regions[region_[f]].owner;
  }
}

/// Gives gaps to their neighbours, and names the neighbours of gaps and holes.
void LayerRepair::own_gaps() {
  const std::vector<BorderPiece> pieces = borders(false);
  for_each_region(report_.regions, pieces,
                  [&](LayerRegion& region, std::span<const BorderPiece> around) {
                    if (!is_uncovered(region)) return;
                    region.features_begin = static_cast<std::uint32_t>(report_.features.size());
                    for (const BorderPiece& piece : around) {
                      report_.features.push_back(piece.feature);
                    }
                    region.features_end = static_cast<std::uint32_t>(report_.features.size());
                    if (region.kind != LayerRegionKind::Gap) return;
                    region.owner = select(report_.features_of(region), around);
                  });
  for (std::size_t f = 0; f < owner_.size(); ++f) {
    if (region_[f] != kNobody) owner_[f] = report_.regions[region_[f]].owner;
  }
}

void LayerRepair::find_emptied(const Layer& result) {
  std::vector<std::uint8_t> had_area(layer_.feature_count(), 0);
  for (std::size_t f = 0; f < complex_.face_count(); ++f) {
    for (const std::uint32_t feature : cells_.features(FaceId(f))) had_area[feature] = 1;
  }
  for (std::uint32_t f = 0; f < layer_.feature_count(); ++f) {
    const bool has_area = result.feature_begin[f] != result.feature_begin[f + 1];
    if (had_area[f] != 0 && !has_area) report_.emptied.push_back(f);
  }
}

}  // namespace

std::size_t LayerReport::count(LayerRegionKind kind) const {
  return static_cast<std::size_t>(
      std::count_if(regions.begin(), regions.end(),
                    [kind](const LayerRegion& region) { return region.kind == kind; }));
}

bool LayerReport::has_defects() const {
  return std::any_of(regions.begin(), regions.end(), [](const LayerRegion& region) {
    return region.kind != LayerRegionKind::Hole;
  });
}

RepairedLayer repair_layer(const Layer& layer, const LayerRepairOptions& options,
                           Context& context) {
  return LayerRepair(layer, options, context).run();
}

}  // namespace plumb
