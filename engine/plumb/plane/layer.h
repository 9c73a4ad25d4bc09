// Layers of features, and the repair of layers. A layer is a list of features, such as countries. A
// feature has an id, properties and polygons. A coverage is a layer whose features do not overlap.
// Features of a coverage may touch each other.
//
// The function repair_layer() finds the regions in which features overlap, and the gaps between
// features. It gives each of these regions to one feature, and returns a coverage whose vertices
// are doubles.
//
// Main flow of repair_layer():
//  1. CoveredCells      arranges the rings of all features exactly. Each face of the arrangement
//                       gets the list of the features that cover it. A polygon covers the points
//                       that its rings enclose by the even-odd rule.
//  2. LayerRegions      joins neighbouring faces with the same list to regions. A region that
//                       several features cover is an overlap. A bounded region that no feature
//                       covers is a gap or a hole. A point at which a ring crosses itself, as in a
//                       bow tie, is a crossing. A hole that does not lie in its polygon is a
//                       nesting.
//  3. RegionOwners      gives each overlap and each gap to one feature
//     A narrow channel or notch between features is also a gap. Such a gap is open to the outside
//     or into a hole. Bridges across such gaps (layer/open_gaps.h) are arranged together with the
//     rings, and steps 1 to 3 are done again.
//  4. layer_of_labels   keeps the edges between different owners, rounds their vertices together
//                       (plane_rounding.h), and traces the polygons of each feature
//
// Exactness: the arrangement, the lists of features and the areas are exact. Widths of regions and
// lengths of borders are computed in doubles. They decide only whether a region is a gap or a hole,
// and which feature gets the region. The region itself is exact.
//
// Cost: O((n + k) log n + s) for n corners and k crossings, where s is the sum of the lengths of
// all lists of features.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "plumb/base/context.h"
#include "plumb/plane/plane_rounding.h"
#include "plumb/predicates/point_table2.h"
#include "plumb/predicates/rational.h"

#pragma GCC visibility push(default)
namespace plumb {

/// Features with polygons in flat arrays. A ring is closed: an edge joins its last corner to its
/// first corner. The first corner is not repeated. The first ring of a polygon is its outer ring.
struct Layer {
  PointTable2 points;                       ///< Corners of all rings.
  std::vector<std::uint32_t> ring_corners;  ///< Corners of all rings, as indices into `points`.
  /// For each ring, the offset of its first corner. The last entry is the number of corners.
  std::vector<std::uint32_t> ring_begin = {0};
  /// For each polygon, its first ring. The last entry is the number of rings.
  std::vector<std::uint32_t> polygon_begin = {0};
  /// For each feature, its first polygon. The last entry is the number of polygons.
  std::vector<std::uint32_t> feature_begin = {0};
  std::string json;  ///< The ids and properties of all features as JSON texts, end to end.
  /// Offsets in `json`: the id of feature f begins at json_begin[2 f], and its properties begin at
  /// json_begin[2 f + 1]. The last entry is the size of `json`.
  std::vector<std::uint64_t> json_begin = {0};
  /// The name of the coordinate reference system, or an empty text. Computations ignore it. A
  /// result has the name of its operand; if there are several, that of the first one with a name.
  std::string crs;

  std::size_t feature_count() const { return feature_begin.size() - 1; }  ///< Number of features.
  std::size_t polygon_count() const { return polygon_begin.size() - 1; }  ///< Number of polygons.
  std::size_t ring_count() const { return ring_begin.size() - 1; }        ///< Number of rings.
  /// Returns the corners of ring `r` as indices into `points`.
  std::span<const std::uint32_t> ring(std::size_t r) const {
    return {ring_corners.data() + ring_begin[r], ring_corners.data() + ring_begin[r + 1]};
  }
  /// Returns the id of feature `f` as a JSON text, such as "FR" including the quotes. Returns an
  /// empty text if the feature has no id.
  std::string_view id(std::size_t f) const { return json_text(2 * f); }
  /// Returns the properties of feature `f` as a JSON text. Returns an empty text if the feature has
  /// no properties.
  std::string_view properties(std::size_t f) const { return json_text(2 * f + 1); }

  /// Ends a ring. The ring consists of the corners that were appended after the previous ring
  /// ended.
  void end_ring() { ring_begin.push_back(static_cast<std::uint32_t>(ring_corners.size())); }
  /// Ends a polygon. The polygon consists of the rings that ended after the previous polygon ended.
  void end_polygon() { polygon_begin.push_back(static_cast<std::uint32_t>(ring_count())); }
  /// Ends a feature. The feature consists of the polygons that ended after the previous feature
  /// ended. `id` and `properties` are JSON texts.
  void end_feature(std::string_view id, std::string_view properties) {
    feature_begin.push_back(static_cast<std::uint32_t>(polygon_count()));
    for (const std::string_view text : {id, properties}) {
      json += text;
      json_begin.push_back(json.size());
    }
  }

 private:
  std::string_view json_text(std::size_t i) const {
    return std::string_view(json).substr(json_begin[i], json_begin[i + 1] - json_begin[i]);
  }
};

/// How the owner of an overlap or a gap is selected. The candidates for an overlap are the features
/// that cover it. The candidates for a gap are the features along its boundary. If several
/// candidates are equally good, the candidate that comes first in the layer is selected.
enum class OwnerRule : std::uint8_t {
  LongestBorder,  ///< The candidate that has the longest common border with the region.
  Largest,        ///< The candidate with the largest area.
  Smallest,       ///< The candidate with the smallest area.
  First,          ///< The candidate of the least rank (LayerRepairOptions::rank).
};

/// A preference between two features.
struct OwnerPreference {
  std::uint32_t winner;  ///< The feature that gets regions for which both are candidates.
  std::uint32_t loser;   ///< The other feature.
};

/// Options of repair_layer().
struct LayerRepairOptions {
  OwnerRule rule = OwnerRule::LongestBorder;  ///< The rule by which owners of regions are selected.
  /// An enclosed region that no feature covers is a gap if its width is less than this value.
  /// Otherwise it is a hole, such as a lake, and stays as it is. Let D be the diagonal of the
  /// bounding box of the layer. If there is no value, the bound for the width of a gap is D
  /// / 10000. In this case, a region that is narrower than the bound is nevertheless a hole if it
  /// looks like a small lake. A region looks like a small lake if it meets three conditions:
  ///   - At most two features lie along its boundary.
  ///   - It is less than about 100 times as long as it is wide: 4 A / p^2 >= 1/100 for its area A
  ///     and its perimeter p.
  ///   - Its width is at least 1e-9 D. Gaps that come from rounding of coordinates are narrower.
  std::optional<double> gaps_below = {};
  /// Whether gaps that open to the outside or into a hole are found. They are not found if a
  /// coordinate exceeds 1e75, because doubles cannot measure such gaps. Such a gap is cut off at
  /// its mouths, which are segments between different features. A mouth is shorter than the bound
  /// `gaps_below`. The gap is narrower than this bound, its border along features is at least twice
  /// as long as its mouths, and at least two features lie along it. If `gaps_below` has no value,
  /// there is a further condition: a gap is at least 100 times as long as it is wide, or narrower
  /// than 1e-9 of the diagonal.
  bool open_gaps = true;
  /// For each feature, its rank under OwnerRule::First. If the list is empty, features rank in the
  /// order of the layer.
  std::vector<std::uint32_t> rank = {};
  /// Preferences that come before the rule: a candidate that loses against another candidate is
  /// left out. But if every candidate loses, no candidate is left out.
  std::vector<OwnerPreference> preferences = {};
  /// The largest number of rounds of a repair. A filled open gap may leave a smaller open gap at
  /// its mouth, so a layer with open gaps is repaired again. Usually two or three rounds are
  /// enough, but no bound is proved.
  std::uint32_t most_rounds = 32;
};

/// The kinds of regions that a report lists.
enum class LayerRegionKind : std::uint8_t {
  Overlap,  ///< Several features cover the region.
  Gap,      ///< No feature covers the region, and it is narrow (LayerRepairOptions::gaps_below).
  Hole,     ///< No feature covers the region, and it is wide. A hole is not a defect.
  /// The rings of a polygon cross themselves or each other at a point, or lie on each other along
  /// edges. The region is a point or these edges, so its area and its width are 0.
  Crossing,
  /// A ring of a polygon is listed as a hole, but lies outside of the outer ring or in a hole.
  /// By the even-odd rule, the polygon covers what the ring encloses. The region is a corner of the
  /// ring, so its area and its width are 0.
  Nesting,
};

/// Returns "overlap", "gap", "hole", "crossing" or "nesting": the name of a kind in files, pictures
/// and bindings.
constexpr const char* name_of(LayerRegionKind kind) {
  if (kind == LayerRegionKind::Overlap) return "overlap";
  if (kind == LayerRegionKind::Crossing) return "crossing";
  if (kind == LayerRegionKind::Nesting) return "nesting";
  return kind == LayerRegionKind::Gap ? "gap" : "hole";
}

/// A region of a report: a gap, a hole, a connected region in which the same features overlap, a
/// crossing or a nesting. If several polygons of one feature overlap and no other feature covers
/// the region, the region is an overlap of one feature.
struct LayerRegion {
  /// The value of `owner` for a region that belongs to no feature.
  static constexpr std::uint32_t kNobody = std::numeric_limits<std::uint32_t>::max();

  LayerRegionKind kind;          ///< The kind of the region.
  Rational area;                 ///< The exact area.
  double width;                  ///< Twice the area, divided by the perimeter.
  std::uint32_t features_begin;  ///< First entry in LayerReport::features.
  std::uint32_t features_end;    ///< The entry after the last entry in LayerReport::features.
  /// The feature that gets the region; kNobody for a hole, a crossing or a nesting.
  std::uint32_t owner;
  bool is_open = false;  ///< Whether the region is a gap that opens to the outside or into a hole.
  /// The point of a crossing, or a point of its edges, or a corner of the ring of a nesting, as the
  /// nearest doubles.
  std::optional<Point2> at = {};
};

/// The regions that check_layer() or repair_layer() found, and the changes that repair_layer()
/// made.
struct LayerReport {
  std::vector<LayerRegion> regions;  ///< Overlaps, gaps and holes, then crossings and nestings.
  /// The features of all regions, end to end. features_of() returns the features of one region. The
  /// features of an overlap are the features that cover it. The features of a gap or a hole are the
  /// features along its boundary. The features of a region are in ascending order.
  std::vector<std::uint32_t> features;
  /// The polygons of the regions, rounded to doubles. Feature k of `shapes` is regions[k], and has
  /// no id and no properties. It has no polygons if the region is a crossing or a nesting, or if
  /// rounding leaves nothing of the region.
  Layer shapes;
  double gaps_below = 0;  ///< The bound that was used for the widths of gaps.
  /// The features that have polygons, but no area after the repair. Either the repair took their
  /// whole area, or their rings enclose none by the even-odd rule, as a ring that runs twice round.
  std::vector<std::uint32_t> emptied;
  PlaneRoundingReport rounding;  ///< The changes that rounding has caused.
  /// Whether the repair ended although open gaps were left. This happens in two cases: after
  /// LayerRepairOptions::most_rounds rounds, or if everything that a round filled vanished when it
  /// was rounded to doubles.
  bool is_stopped = false;

  /// Returns the features of a region.
  std::span<const std::uint32_t> features_of(const LayerRegion& region) const {
    return {features.data() + region.features_begin, features.data() + region.features_end};
  }
  /// Returns the number of regions of a kind. O(regions).
  std::size_t count(LayerRegionKind kind) const;
  /// Whether the layer has overlaps, gaps, crossings or nestings.
  bool has_defects() const;
};

/// A repaired layer.
struct RepairedLayer {
  /// The features with their ids and properties, in the order of the input. Polygons are valid,
  /// their vertices are doubles, and features meet only in common edges and vertices.
  Layer layer;
  LayerReport report;  ///< The regions that were found, and the changes that were made.
};

/// Returns the overlaps, gaps, holes, crossings and nestings of a layer. The layer is not changed,
/// so no region has an owner, and `options.rule` has no effect. Only the corners of
/// LayerReport::shapes are rounded. Throws as repair_layer() does.
LayerReport check_layer(const Layer& layer, const LayerRepairOptions& options = {},
                        Context& context = unlimited_context());

/// Returns the layer without overlaps and gaps, and a report. The owners of overlaps and gaps are
/// selected by options.rule, with one exception. If overlaps cover a feature completely, these
/// overlaps are given to this feature. Otherwise the feature could vanish. It can still vanish if
/// several features are equal. If an open gap was filled, the result is repaired again until
/// nothing is left to do (LayerReport::is_stopped), and the report lists all regions.
/// Throws Error{BadArgument} if ranks or preferences do not match the features. Throws
/// Error{NumberOutOfRange} if coordinates are too large to be rounded. Also throws the errors of
/// the Context.
RepairedLayer repair_layer(const Layer& layer, const LayerRepairOptions& options = {},
                           Context& context = unlimited_context());

}  // namespace plumb
#pragma GCC visibility pop
