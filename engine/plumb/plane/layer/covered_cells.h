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
  /// Arranges the rings and the bridges. Throws ResourceLimit if a limit of the Context is
  /// exceeded, and Cancelled if a stop is requested. Requires that the layer outlives the cells.
  CoveredCells(const Layer& layer, const Bridges& bridges, Context& context);
  /// Arranges the rings alone.
  CoveredCells(const Layer& layer, Context& context) : CoveredCells(layer, Bridges(), context) {}

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

 private:
  void add_curves(const Layer& layer);
  bool is_of_polygon(SegmentId s) const { return polygon_[s.value()] != kNoPolygon; }
  void visit_faces();
  void enter(FaceId from, FaceId to, EdgeId across);
  void name_features(const Layer& layer);

  static constexpr std::uint32_t kNoPolygon = std::numeric_limits<std::uint32_t>::max();

  Context& context_;
  MemoryCharge memory_;
  const PointTable2& corner_points_;
  bool has_bridges_;
  std::vector<SweepSegment> curves_;
  std::vector<std::uint32_t> polygon_;  // For each curve, its polygon; kNoPolygon for bridges.
  Arrangement arrangement_;
  std::vector<std::uint32_t> lists_;  // Polygons, later features, of all faces.
  IdVector<FaceId, std::size_t> first_, last_;
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
