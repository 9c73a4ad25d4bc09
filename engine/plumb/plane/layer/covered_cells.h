// The cells of a layer: the exact arrangement of all its rings, with the features that cover each
// face. A polygon covers the points that its rings enclose by the even-odd rule.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "plumb/base/context.h"
#include "plumb/plane/arrangement.h"
#include "plumb/plane/layer.h"
#include "plumb/predicates/sign.h"

namespace plumb {

/// The features that cover a face, in ascending order.
using FeatureList = std::span<const std::uint32_t>;

/// The faces that a checkpoint of a walk over faces stands for.
inline constexpr std::size_t kFacesPerCheckpoint = 1024;

/// Segments that are arranged together with the rings. They do not change which points are covered.
struct Bridges {
  std::vector<SweepSegment> segments;  ///< Segments between `points`.
  PointTable2 points;                  ///< The ends of the segments.
};

/// The arrangement of all rings, with the features that cover each face.
class CoveredCells {
 public:
  /// Arranges the rings and the bridges, and finds misplaced holes. Throws ResourceLimit if a limit
  /// of the Context is exceeded, and Cancelled if a stop is requested. Requires that the layer
  /// outlives the cells.
  CoveredCells(const Layer& layer, const Bridges& bridges, Context& context);
  /// Arranges the rings alone, and does not look for misplaced holes.
  CoveredCells(const Layer& layer, Context& context);

  /// Returns the arrangement. Face 0 is not covered.
  const PlaneComplex& complex() const { return arrangement_.complex; }
  /// Whether the same features cover two faces.
  bool is_same_cover(FaceId f, FaceId g) const;
  /// Whether there are bridges.
  bool has_bridges() const { return has_bridges_; }
  /// Whether an edge belongs to a bridge and lies between faces that no feature covers.
  bool is_open_bridge(EdgeId e) const;
  /// Returns for each vertex whether a ring has a corner there. Returns an empty list, which stands
  /// for all vertices but crossings, if there are no bridges.
  std::vector<std::uint8_t> corners() const;
  /// Returns the features that cover a face, in ascending order.
  FeatureList features(FaceId f) const {
    return {lists_.data() + first_[f], lists_.data() + last_[f]};
  }
  /// Whether several polygons of one feature cover a face.
  bool is_doubled(FaceId f) const { return !is_doubled_.empty() && is_doubled_[f.value()] != 0; }
  /// Returns the misplaced holes, as ascending indices of rings. A ring is a misplaced hole if it
  /// is not the outer ring of its polygon, but the polygon covers the inner side of each of its
  /// edges. Such a ring lies outside of the outer ring, or in another hole. Edges on which the
  /// polygon has several curves are not looked at.
  FeatureList misplaced_holes() const { return misplaced_holes_; }

  /// Sets `origins` to the curves that lie on an edge, in ascending order.
  void get_origins(EdgeId e, std::vector<SegmentId>& origins) const {
    origins.clear();
    arrangement_.origin_sets.append(arrangement_.origins[e.value()], origins);
  }
  /// Whether a curve belongs to a ring and not to a bridge.
  bool is_of_polygon(SegmentId s) const { return polygon_[s.value()] != kNoPolygon; }
  /// Returns the polygon of a curve. Requires is_of_polygon(s).
  std::uint32_t polygon(SegmentId s) const { return polygon_[s.value()]; }
  /// Returns the corners that a curve joins, as indices into the points of the layer. Requires
  /// is_of_polygon(s).
  SweepSegment curve(SegmentId s) const { return curves_[s.value()]; }
  /// The curves begin, ..., end - 1.
  struct CurveRange {
    std::uint32_t begin;
    std::uint32_t end;
  };
  /// Returns the curves of the ring of a curve, in the order of the ring. O(log(rings)).
  CurveRange ring_of(SegmentId s) const;

 private:
  void arrange_rings(const Layer& layer, const Bridges& bridges);
  void add_curves(const Layer& layer);
  void visit_faces();
  void enter(FaceId from, FaceId to, EdgeId across);
  void find_misplaced_holes(const Layer& layer);
  std::uint32_t ring_index(SegmentId s) const;
  bool covers_inner_side(SegmentId curve, EdgeId e, Sign turn) const;
  void name_features(const Layer& layer);

  static constexpr std::uint32_t kNoPolygon = std::numeric_limits<std::uint32_t>::max();

  Context& context_;
  MemoryCharge memory_;
  const PointTable2& corner_points_;
  bool has_bridges_;
  std::vector<SweepSegment> curves_;
  std::vector<std::uint32_t> polygon_;     // For each curve, its polygon; kNoPolygon for bridges.
  std::vector<std::uint32_t> ring_begin_;  // For each ring, its first curve; then their number.
  Arrangement arrangement_;
  std::vector<std::uint32_t> lists_;  // Polygons, later features, of all faces.
  IdVector<FaceId, std::size_t> first_, last_;
  std::vector<std::uint8_t> is_doubled_;  // For each face; empty if there is no such face.
  std::vector<std::uint32_t> misplaced_holes_;
  std::vector<SegmentId> origins_;
};

/// Returns for each face the first feature that covers it, or LayerRegion::kNobody.
std::vector<std::uint32_t> first_features(const CoveredCells& cells);

/// The features begin, ..., end - 1.
struct FeatureRange {
  std::uint32_t begin;
  std::uint32_t end;
};

/// Returns the number of connected regions of faces that the same features of the range cover, at
/// least two of them with different classes. `class_of` has an entry for each feature; if it is
/// empty, every feature is a class of its own.
std::size_t count_overlaps(const CoveredCells& cells, FeatureRange range,
                           std::span<const std::uint32_t> class_of);

}  // namespace plumb
