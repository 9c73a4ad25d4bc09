// Convex pieces of the plane, rounded together.
//
// Each bounded piece with an area becomes a feature of a layer. The repair of a layer without
// overlaps changes nothing but coordinates: all borders are arranged in one sweep, rounded as one
// subdivision, and read off feature by feature. A bound of zero for the widths of gaps keeps every
// gap as it is. The other pieces have no interior that could overlap another piece after rounding,
// or reach infinity, where no double is.
//
// Tested by tests/convex/rounded_pieces_test.cpp.
#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

#include "plumb/convex/plane_convexity.h"
#include "plumb/convex/plane_partition.h"
#include "plumb/convex/region/plane_region.h"
#include "plumb/plane/layer.h"
#include "plumb/plane/plane_measure.h"
#include "plumb/predicates/plane/plane_points.h"

namespace plumb {
namespace {

constexpr std::size_t kPiecesPerCheckpoint = 64;

bool has_area(const Nef2& piece) {
  const PlaneComplex& complex = piece.complex();
  for (std::size_t f = 0; f < complex.face_count(); ++f) {
    if (complex.mark(FaceId(f))) return true;
  }
  return false;
}

/// Appends the marked faces of a bounded piece as a feature.
void append_feature(Layer& layer, const Nef2& piece) {
  const PlaneComplex& complex = piece.complex();
  const auto first = static_cast<std::uint32_t>(layer.points.size());
  for (const std::uint32_t p : complex.vertex_point) {
    const RationalPoint2 at = exact(complex.points, p);
    layer.points.push_back(at.x, at.y);
  }
  for (std::size_t f = 0; f < complex.face_count(); ++f) {
    if (!complex.mark(FaceId(f))) continue;
    for (const std::vector<VertexId>& ring : face_rings(complex, FaceId(f))) {
      for (const VertexId v : ring) layer.ring_corners.push_back(first + v.value());
      layer.end_ring();
    }
    layer.end_polygon();
  }
  layer.end_feature({}, {});
}

/// Returns the closed set of the polygons of a feature.
Nef2 set_of_feature(const Layer& layer, std::size_t feature, Context& context) {
  PointTable2 points;
  std::vector<std::uint32_t> corners, chain_begin{0};
  const std::size_t begin = layer.polygon_begin[layer.feature_begin[feature]];
  const std::size_t end = layer.polygon_begin[layer.feature_begin[feature + 1]];
  for (std::size_t r = begin; r < end; ++r) {
    for (const std::uint32_t corner : layer.ring(r)) {
      corners.push_back(static_cast<std::uint32_t>(points.size()));
      points.push_back(layer.points.approx(corner));
    }
    chain_begin.push_back(static_cast<std::uint32_t>(corners.size()));
  }
  return Nef2::polygons(points, corners, chain_begin, WindingRule::EvenOdd, Boundary::Closed,
                        context);
}

/// Adds the changes in another part of the plane.
void add_to(PlaneRoundingReport& sum, const PlaneRoundingReport& report) {
  sum.vertices_moved += report.vertices_moved;
  sum.vertices_merged += report.vertices_merged;
  sum.edges_bent += report.edges_bent;
  sum.edges_folded += report.edges_folded;
  sum.collapsed += report.collapsed;
  sum.largest_move = std::max(sum.largest_move, report.largest_move);
  sum.largest_ulp = std::max(sum.largest_ulp, report.largest_ulp);
}

}  // namespace

RoundedPieces round_to_doubles(std::span<const Nef2> pieces, Context& context) {
  RoundedPieces result;
  Layer layer;
  std::vector<std::size_t> of_feature;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    if (i % kPiecesPerCheckpoint == 0) context.checkpoint(kPartitionPhase, i, pieces.size());
    result.pieces.push_back(pieces[i]);
    if (!pieces[i].is_bounded()) continue;
    if (has_area(pieces[i])) {
      append_feature(layer, pieces[i]);
      of_feature.push_back(i);
    } else {
      RoundedSet alone = round_to_doubles(pieces[i], context);
      result.pieces.back() = std::move(alone.set);
      add_to(result.rounding, alone.report);
    }
  }
  const RepairedLayer rounded =
      repair_layer(layer, {OwnerRule::First, /*gaps_below=*/0.0}, context);
  add_to(result.rounding, rounded.report.rounding);
  for (std::size_t f = 0; f < of_feature.size(); ++f) {
    Nef2& piece = result.pieces[of_feature[f]];
    piece = set_of_feature(rounded.layer, f, context);
    if (!convexity_of_set(piece, context).is_convex) ++result.not_convex;
  }
  return result;
}

}  // namespace plumb
