// Repair of layers: cells, regions, owners, polygons.
//
// All features are arranged exactly (layer/covered_cells.h), so every question about overlaps and
// gaps is a question about the faces of the arrangement, and about the lists of the features that
// cover them. Regions are united from faces, and owners are selected for them. The result is made
// of the owners of faces as labels (layer/labelled_layer.h).
//
// Gaps that are open depend on the owners of overlaps, so a layer is arranged first without bridges
// and, if there are bridges, once more with them. A filled gap may leave another gap at its mouth,
// but each time a shorter border remains.
//
// Tested by tests/plane/layer_test.cpp and open_gaps_test.cpp, which compare with cells of a grid.

#include "plumb/plane/layer.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "plumb/base/internal/union_find.h"
#include "plumb/plane/layer/covered_cells.h"
#include "plumb/plane/layer/labelled_layer.h"
#include "plumb/plane/layer/open_gaps.h"
#include "plumb/plane/layer/self_crossings.h"
#include "plumb/plane/plane_measure.h"
#include "plumb/predicates/arithmetic/rational_sum.h"
#include "plumb/predicates/error.h"
#include "plumb/predicates/rounding.h"

namespace plumb {
namespace {

constexpr std::uint32_t kNobody = LayerRegion::kNobody;
constexpr double kGapsPerDiagonal = 1e-4;
// The bounds that distinguish gaps from small lakes (LayerRepair::is_gap).
constexpr double kSlender = 1.0 / 100;
constexpr double kRoundingPerDiagonal = 1e-9;
constexpr std::size_t kCornerNeighbours = 3;

using Numbers = FeatureList;

// Up to this coordinate, products of four lengths are finite doubles, as crossings and areas
// require. Layers with larger coordinates are measured in larger units.
constexpr double kMostMeasured = 1e75;
constexpr double kLargeUnit = 0x1p520;

// ---------------------------------------------------------------- regions and their owners

/// A piece of the boundary of a region, with the feature on its other side.
struct BorderPiece {
  std::uint32_t region;
  std::uint32_t feature;
  double length;
};

/// Adds up the lengths of the pieces with the same region and the same feature. Sorts the pieces.
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
  LayerRepair(const Layer& layer, const LayerRepairOptions& options, const Bridges& bridges,
              Context& context)
      : layer_(layer),
        options_(options),
        context_(context),
        cells_(layer, bridges, context),
        complex_(cells_.complex()),
        owner_(complex_.face_count(), kNobody),
        region_(complex_.face_count(), kNobody),
        preferences_(options.preferences) {
    std::sort(preferences_.begin(), preferences_.end(), is_before);
    find();
  }

  /// Returns segments across gaps that are open. Requires that there were no bridges.
  Bridges bridges() const {
    if (!options_.open_gaps || unit_ != 1) return {};
    return open_gap_bridges(complex_, owner_, report_.gaps_below, context_);
  }

  RepairedLayer repair() {
    const RoundedLabels owned = rounded_labels(complex_, owner_, context_, cells_.corners());
    Layer result = layer_of_labels(owned.labelled, layer_.feature_count(), &layer_, context_);
    report_.rounding = owned.rounding;
    make_shapes();
    find_emptied(result);
    return {std::move(result), std::move(report_)};
  }

  bool has_defects() const { return report_.has_defects(); }

  LayerReport check() {
    make_shapes();
    for (LayerRegion& region : report_.regions) region.owner = kNobody;
    return std::move(report_);
  }

 private:
  FaceId left(std::size_t e) const { return complex_.dcel.face(first_half(EdgeId(e))); }
  FaceId right(std::size_t e) const { return complex_.dcel.face(twin(first_half(EdgeId(e)))); }
  /// Whether several polygons of one feature cover a face, and no other feature does.
  bool is_own_overlap(FaceId f) const {
    return cells_.is_doubled(f) && cells_.features(f).size() == 1;
  }
  bool is_uncovered(const LayerRegion& region) const {
    return region.kind != LayerRegionKind::Overlap;
  }
  void find();
  void make_shapes();
  void find_regions();
  void measure_regions();
  void measure_features();
  bool is_gap(const LayerRegion& region, std::size_t neighbours) const;
  double unit() const;
  double diagonal() const;
  Point2 measured(VertexId v) const;
  double length_of(EdgeId e) const;
  double measured_area(const Rational& area) const;
  OpenGapRule open_gap_rule() const;
  std::vector<BorderPiece> borders(bool of_overlaps) const;
  void own_overlaps();
  void own_gaps();
  static bool is_before(const OwnerPreference& a, const OwnerPreference& b) {
    return a.loser != b.loser ? a.loser < b.loser : a.winner < b.winner;
  }
  bool is_beaten(std::uint32_t feature, Numbers candidates) const;
  Numbers unbeaten(Numbers candidates, std::vector<std::uint32_t>& kept) const;
  std::uint32_t select(Numbers candidates, std::span<const BorderPiece> borders) const;
  double worth(std::uint32_t feature, std::span<const BorderPiece> borders) const;
  void find_crossings();
  void find_nestings();
  void add_place(LayerRegionKind kind, std::uint32_t polygon, Point2 at);
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
  double unit_ = 1;                     // The unit of lengths, 1 or kLargeUnit.
  double diagonal_ = 0;                 // The diagonal of the bounding box, in units.
  std::vector<OwnerPreference> preferences_;  // Sorted by losers.
  LayerReport report_;
};

/// Finds all regions, and selects their owners.
void LayerRepair::find() {
  unit_ = unit();
  diagonal_ = diagonal();
  report_.gaps_below =
      options_.gaps_below ? *options_.gaps_below : kGapsPerDiagonal * diagonal_ * unit_;
  find_regions();
  measure_regions();
  measure_features();
  own_overlaps();
  own_gaps();
  find_crossings();
  find_nestings();
}

/// Returns the number of the list that contains an item. Requires that the item is in a list.
std::uint32_t list_of(const std::vector<std::uint32_t>& begin, std::uint32_t item) {
  const auto after = std::upper_bound(begin.begin(), begin.end(), item);
  return static_cast<std::uint32_t>(after - begin.begin() - 1);
}

/// Appends a defect of a polygon at a point.
void LayerRepair::add_place(LayerRegionKind kind, std::uint32_t polygon, Point2 at) {
  const auto begin = static_cast<std::uint32_t>(report_.features.size());
  report_.features.push_back(list_of(layer_.feature_begin, polygon));
  report_.regions.push_back({kind, 0, 0, begin, begin + 1, kNobody, false, at});
}

/// Appends the places at which polygons cross themselves.
void LayerRepair::find_crossings() {
  for (const SelfCrossing& crossing : self_crossings(cells_, layer_, context_)) {
    const RationalPoint2 p = exact(complex_.points, complex_.vertex_point[crossing.vertex]);
    add_place(LayerRegionKind::Crossing, crossing.polygon,
              {nearest_double(p.x), nearest_double(p.y)});
  }
}

/// Appends the holes that do not lie in their polygons.
void LayerRepair::find_nestings() {
  for (const std::uint32_t r : cells_.misplaced_holes()) {
    add_place(LayerRegionKind::Nesting, list_of(layer_.polygon_begin, r),
              layer_.points.approx(layer_.ring(r).front()));
  }
}

void LayerRepair::make_shapes() {
  const RoundedLabels shapes = rounded_labels(complex_, region_, context_, cells_.corners());
  report_.shapes = layer_of_labels(shapes.labelled, report_.regions.size(), nullptr, context_);
}

/// Numbers the regions of faces that are not covered by exactly one polygon. Face 0 belongs to no
/// region.
void LayerRepair::find_regions() {
  UnionFind classes(complex_.face_count());
  for (std::size_t e = 0; e < complex_.edge_count(); ++e) {
    if (!cells_.is_same_cover(left(e), right(e)) || cells_.is_open_bridge(EdgeId(e))) continue;
    if (is_own_overlap(left(e)) != is_own_overlap(right(e))) continue;
    classes.unite(left(e).value(), right(e).value());
  }
  std::vector<std::uint8_t> is_open_gap;
  if (cells_.has_bridges()) {
    is_open_gap = join_open_cells(cells_, classes, open_gap_rule(), context_);
  }
  for (std::uint32_t f = 0; f < complex_.face_count(); ++f) {
    const Numbers features = cells_.features(FaceId(f));
    if (features.size() == 1) owner_[f] = features.front();
    const std::uint32_t root = classes.root(f);
    if ((features.size() == 1 && !is_own_overlap(FaceId(f))) || root == 0) continue;
    if (root == f) {
      region_[f] = static_cast<std::uint32_t>(report_.regions.size());
      const auto begin = static_cast<std::uint32_t>(report_.features.size());
      report_.features.insert(report_.features.end(), features.begin(), features.end());
      const auto end = static_cast<std::uint32_t>(report_.features.size());
      report_.regions.push_back(
          {features.empty() ? LayerRegionKind::Hole : LayerRegionKind::Overlap, 0, 0, begin, end,
           kNobody, !is_open_gap.empty() && is_open_gap[f] != 0});
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
    const double length = length_of(EdgeId(e));
    if (l != kNobody) perimeter[l] += length;
    if (r != kNobody) perimeter[r] += length;
  }
  for (std::size_t i = 0; i < report_.regions.size(); ++i) {
    LayerRegion& region = report_.regions[i];
    region.area = area[i].total();
    region.width = 2 * measured_area(region.area) / perimeter[i] * unit_;
  }
}

/// Computes the areas of features in square units, as sums of the areas of their faces.
void LayerRepair::measure_features() {
  std::vector<double> of_face(complex_.face_count(), 0);
  for (std::size_t e = 0; e < complex_.edge_count(); ++e) {
    const HalfedgeId h = first_half(EdgeId(e));
    const Point2 p = measured(complex_.dcel.origin(h)), q = measured(complex_.dcel.target(h));
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

/// Returns the unit in which lengths and areas of the layer are finite doubles.
double LayerRepair::unit() const {
  const bool is_large =
      std::any_of(layer_.ring_corners.begin(), layer_.ring_corners.end(), [this](std::uint32_t i) {
        const Point2 p = layer_.points.approx(i);
        return std::fabs(p.x) > kMostMeasured || std::fabs(p.y) > kMostMeasured;
      });
  return is_large ? kLargeUnit : 1;
}

/// Returns the place of a vertex in units. Filters do not approximate large crossings, so these are
/// rounded from the exact point.
Point2 LayerRepair::measured(VertexId v) const {
  const std::uint32_t point = complex_.vertex_point[v];
  if (unit_ == 1) return approx(complex_.points, point);
  const RationalPoint2 p = exact(complex_.points, point);
  return {nearest_double(p.x) / unit_, nearest_double(p.y) / unit_};
}

double LayerRepair::length_of(EdgeId e) const {
  const HalfedgeId h = first_half(e);
  const Point2 p = measured(complex_.dcel.origin(h)), q = measured(complex_.dcel.target(h));
  return std::hypot(q.x - p.x, q.y - p.y);
}

double LayerRepair::measured_area(const Rational& area) const {
  if (unit_ == 1) return nearest_double(area);
  const Rational unit = exact_rational(unit_);
  return nearest_double(area / (unit * unit));
}

double LayerRepair::diagonal() const {
  if (layer_.ring_corners.empty()) return 0;
  Point2 low = layer_.points.approx(layer_.ring_corners.front()), high = low;
  for (const std::uint32_t i : layer_.ring_corners) {
    const Point2 p = layer_.points.approx(i);
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  return std::hypot(high.x / unit_ - low.x / unit_, high.y / unit_ - low.y / unit_);
}

OpenGapRule LayerRepair::open_gap_rule() const {
  return {report_.gaps_below, kSlender, kRoundingPerDiagonal * diagonal_ * unit_,
          !options_.gaps_below};
}

/// Whether a region that no feature covers is a gap. If the caller has no bound, a narrow region is
/// a hole if it looks like a small lake: it is neither long nor between three or more features.
/// 4 A / p^2, for the area A and the perimeter p, is about the width of a long strip divided by its
/// length. Of 121 narrow lakes in layers of Natural Earth, the least value is 1/78.
bool LayerRepair::is_gap(const LayerRegion& region, std::size_t neighbours) const {
  if (!(region.width < report_.gaps_below)) return false;
  if (options_.gaps_below || neighbours >= kCornerNeighbours) return true;
  const double width = region.width / unit_;
  const double slenderness = width * width / measured_area(region.area);
  return slenderness < kSlender || width < kRoundingPerDiagonal * diagonal_;
}

/// Returns the borders between regions of one sort and faces that have owners.
std::vector<BorderPiece> LayerRepair::borders(bool of_overlaps) const {
  std::vector<BorderPiece> pieces;
  const auto add = [&](FaceId inside, FaceId outside, std::size_t e) {
    const std::uint32_t region = region_[inside.value()], owner = owner_[outside.value()];
    if (region == kNobody || owner == kNobody || region == region_[outside.value()]) return;
    if (is_uncovered(report_.regions[region]) == of_overlaps) return;
    pieces.push_back({region, owner, length_of(EdgeId(e))});
  };
  for (std::size_t e = 0; e < complex_.edge_count(); ++e) {
    add(left(e), right(e), e);
    add(right(e), left(e), e);
  }
  unite_pieces(pieces);
  return pieces;
}

/// Returns how strongly a feature claims a region. The feature with the greatest value is selected.
/// Requires borders that are sorted by feature.
double LayerRepair::worth(std::uint32_t feature, std::span<const BorderPiece> borders) const {
  if (options_.rule == OwnerRule::First) {
    return options_.rank.empty() ? 0 : -static_cast<double>(options_.rank[feature]);
  }
  if (options_.rule == OwnerRule::Largest) return area_[feature];
  if (options_.rule == OwnerRule::Smallest) return -area_[feature];
  const auto piece =
      std::lower_bound(borders.begin(), borders.end(), feature,
                       [](const BorderPiece& b, std::uint32_t f) { return b.feature < f; });
  return piece == borders.end() || piece->feature != feature ? 0 : piece->length;
}

/// Whether a candidate loses against another candidate. Candidates ascend.
bool LayerRepair::is_beaten(std::uint32_t feature, Numbers candidates) const {
  auto next = std::lower_bound(preferences_.begin(), preferences_.end(),
                               OwnerPreference{0, feature}, is_before);
  for (; next != preferences_.end() && next->loser == feature; ++next) {
    if (std::binary_search(candidates.begin(), candidates.end(), next->winner)) return true;
  }
  return false;
}

/// Returns the candidates that do not lose against any other candidate, or all candidates if each
/// loses.
Numbers LayerRepair::unbeaten(Numbers candidates, std::vector<std::uint32_t>& kept) const {
  if (preferences_.empty()) return candidates;
  std::copy_if(candidates.begin(), candidates.end(), std::back_inserter(kept),
               [&](std::uint32_t f) { return !is_beaten(f, candidates); });
  return kept.empty() ? candidates : Numbers(kept);
}

/// Returns the best candidate. If several are equal, returns the first one. Candidates ascend.
std::uint32_t LayerRepair::select(Numbers all, std::span<const BorderPiece> borders) const {
  std::vector<std::uint32_t> kept;
  const Numbers candidates = unbeaten(all, kept);
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

/// Distinguishes gaps from holes, assigns gaps to their neighbours, and names the neighbours of
/// both.
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
                    if (!region.is_open && !is_gap(region, around.size())) return;
                    region.kind = LayerRegionKind::Gap;
                    region.owner = select(report_.features_of(region), around);
                  });
  for (std::size_t f = 0; f < owner_.size(); ++f) {
    if (region_[f] != kNobody) owner_[f] = report_.regions[region_[f]].owner;
  }
}

void LayerRepair::find_emptied(const Layer& result) {
  const auto has_polygons = [](const Layer& layer, std::uint32_t f) {
    return layer.feature_begin[f] != layer.feature_begin[f + 1];
  };
  for (std::uint32_t f = 0; f < layer_.feature_count(); ++f) {
    if (has_polygons(layer_, f) && !has_polygons(result, f)) report_.emptied.push_back(f);
  }
}

/// Calls visit(repair) with the regions of a layer, including gaps that are open.
template <class Visit>
auto with_regions(const Layer& layer, const LayerRepairOptions& options, Context& context,
                  const Visit& visit) {
  Bridges bridges;
  {
    LayerRepair enclosed(layer, options, bridges, context);
    bridges = enclosed.bridges();
    if (bridges.segments.empty()) return visit(enclosed);
  }
  LayerRepair all(layer, options, bridges, context);
  return visit(all);
}

RepairedLayer repaired_once(const Layer& layer, const LayerRepairOptions& options,
                            Context& context) {
  return with_regions(layer, options, context, [](LayerRepair& repair) { return repair.repair(); });
}

/// Repairs a layer in which an open gap was filled. Returns nothing if there is nothing left to
/// repair.
std::optional<RepairedLayer> repaired_again(const Layer& layer, const LayerRepairOptions& options,
                                            Context& context) {
  return with_regions(layer, options, context, [](LayerRepair& repair) {
    return repair.has_defects() ? std::optional(repair.repair()) : std::nullopt;
  });
}

/// Appends feature f of another layer with its points, without its id and its properties.
void append_feature(Layer& layer, const Layer& other, std::size_t f) {
  for (std::size_t p = other.feature_begin[f]; p < other.feature_begin[f + 1]; ++p) {
    for (std::size_t r = other.polygon_begin[p]; r < other.polygon_begin[p + 1]; ++r) {
      for (const std::uint32_t corner : other.ring(r)) {
        layer.ring_corners.push_back(static_cast<std::uint32_t>(layer.points.size()));
        layer.points.push_back(other.points.approx(corner));
      }
      layer.end_ring();
    }
    layer.end_polygon();
  }
  layer.end_feature("", "");
}

/// Appends the changes of a later repair.
void append_changes(LayerReport& report, const LayerReport& later) {
  for (std::size_t i = 0; i < later.regions.size(); ++i) {
    LayerRegion region = later.regions[i];
    if (region.kind == LayerRegionKind::Hole) continue;
    const FeatureList features = later.features_of(region);
    region.features_begin = static_cast<std::uint32_t>(report.features.size());
    report.features.insert(report.features.end(), features.begin(), features.end());
    region.features_end = static_cast<std::uint32_t>(report.features.size());
    report.regions.push_back(region);
    append_feature(report.shapes, later.shapes, i);
  }
  report.emptied.insert(report.emptied.end(), later.emptied.begin(), later.emptied.end());
  std::sort(report.emptied.begin(), report.emptied.end());
  PlaneRoundingReport& all = report.rounding;
  const PlaneRoundingReport& more = later.rounding;
  all.vertices_moved += more.vertices_moved;
  all.vertices_merged += more.vertices_merged;
  all.edges_bent += more.edges_bent;
  all.edges_folded += more.edges_folded;
  all.collapsed += more.collapsed;
  all.largest_move += more.largest_move;
  all.largest_ulp = std::max(all.largest_ulp, more.largest_ulp);
}

void require_options(const Layer& layer, const LayerRepairOptions& options) {
  const std::size_t count = layer.feature_count();
  if (!options.rank.empty() && options.rank.size() != count) {
    throw Error(ErrorCode::BadArgument, "each feature needs a rank");
  }
  for (const OwnerPreference& p : options.preferences) {
    if (p.winner < count && p.loser < count && p.winner != p.loser) continue;
    throw Error(ErrorCode::BadArgument, "a preference needs two different features");
  }
}

/// Whether two layers of doubles have the same polygons in the same order.
bool have_same_polygons(const Layer& a, const Layer& b) {
  const auto is_same_corner = [&](std::uint32_t i, std::uint32_t j) {
    const Point2 p = a.points.approx(i), q = b.points.approx(j);
    return p.x == q.x && p.y == q.y;
  };
  return a.ring_begin == b.ring_begin && a.polygon_begin == b.polygon_begin &&
         a.feature_begin == b.feature_begin &&
         std::equal(a.ring_corners.begin(), a.ring_corners.end(), b.ring_corners.begin(),
                    b.ring_corners.end(), is_same_corner);
}

bool has_open_gaps(const LayerReport& report) {
  return std::any_of(report.regions.begin(), report.regions.end(),
                     [](const LayerRegion& region) { return region.is_open; });
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

LayerReport check_layer(const Layer& layer, const LayerRepairOptions& options, Context& context) {
  require_options(layer, options);
  return with_regions(layer, options, context, [](LayerRepair& repair) { return repair.check(); });
}

RepairedLayer repair_layer(const Layer& layer, const LayerRepairOptions& options,
                           Context& context) {
  require_options(layer, options);
  RepairedLayer repaired = repaired_once(layer, options, context);
  if (!has_open_gaps(repaired.report)) return repaired;
  LayerRepairOptions later = options;
  for (std::uint32_t round = 1;; ++round) {
    // The last round leaves open gaps unchanged, so no further round is needed.
    const bool is_last = round >= options.most_rounds;
    later.open_gaps = !is_last;
    std::optional<RepairedLayer> again = repaired_again(repaired.layer, later, context);
    if (again && have_same_polygons(again->layer, repaired.layer)) {
      // The fillings vanish when they are rounded. They would vanish in every further round, too.
      repaired.report.is_stopped = true;
      return repaired;
    }
    if (again) {
      repaired.layer = std::move(again->layer);
      append_changes(repaired.report, again->report);
    }
    repaired.report.is_stopped = is_last;
    if (is_last || !again) return repaired;
  }
}

}  // namespace plumb
