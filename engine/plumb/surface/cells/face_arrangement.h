// The segments of polygons in one face, arranged.
//
// Main flow of run():
//  1. contacts   finds crossings, ends on other segments and overlaps among pairs of segments whose
//                boxes meet
//  2. split      sorts the points on each segment; equal points become one point (union-find)
//  3. merge      adds up pieces of overlapping segments; pieces that cancel each other vanish
//  4. link       orders half-edges by angle around nodes and links them around pieces
//  5. nest       places components that do not reach the boundary in a piece: the one below their
//                leftmost point, which a sweep over the points finds if there are many
//
// Equal crossings are found as neighbours on a segment, because every other segment through the
// point meets this segment at the same point. So only the order along segments is ever asked, never
// equality of two points anywhere (docs/design/surface.md, Lemma 1).
//
// Cost: O(k log k) for k pieces, plus pairs of boxes that meet.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "plumb/base/internal/box_tree.h"
#include "plumb/predicates/plane/plane_points.h"
#include "plumb/surface/cells/surface_arrangement.h"

namespace plumb {

/// One of the different segments of a face, between two points of it. `bundle` names the polygons
/// that run along it.
struct FaceSegment {
  std::uint32_t from;  ///< The lexicographically lesser end, once run() has been called.
  std::uint32_t to;
  std::uint32_t bundle;
  std::int32_t sign;  ///< -1 if the bundle runs from `to` to `from`.
};

/// A piece of segments between two points; `from` comes first lexicographically.
struct FaceArc {
  std::uint32_t from;
  std::uint32_t to;
  std::uint32_t segment;  ///< A segment that it lies on.
  std::uint32_t bundle;
  std::int32_t sign;
};

/// An arrangement that is used for one face after the other and keeps its memory.
class FaceArrangement {
 public:
  /// Input: the boundary's points first, counter-clockwise from corner 0, then others; all
  /// distinct.
  PlanePoints points;           ///< Given points; crossings are output.
  std::uint32_t ring_size = 0;  ///< Number of points on the boundary.
  std::uint32_t corner_1 = 0;   ///< The boundary point where side 0 ends.
  std::vector<FaceSegment> segments;

  /// Starts again, without points and segments.
  void clear();
  /// Arranges the segments. Throws Error{Cancelled} and Error{ResourceLimit}.
  void run(SurfaceBundles& bundles, Context& context);

  // Output. Half-edge r < ring_size runs from point r along the boundary; half-edges ring_size + 2
  // a and ring_size + 2 a + 1 are arc a and its reverse.
  std::vector<FaceArc> arcs;
  std::vector<std::uint32_t> next;
  std::vector<std::uint32_t> piece;  ///< Piece to the left of each half-edge.
  std::uint32_t piece_count = 0;
  /// A boundary cycle of a piece.
  struct Loop {
    std::uint32_t piece;
    std::uint32_t halfedge;
    bool is_hole;
  };
  std::vector<Loop> loops;  ///< Sorted by piece, the outer one first.

  /// Returns the point that a half-edge leaves.
  std::uint32_t origin(std::uint32_t h) const {
    if (h < ring_size) return h;
    const FaceArc& a = arcs[(h - ring_size) / 2];
    return is_reverse(h) ? a.to : a.from;
  }
  std::uint32_t halfedge_count() const {
    return ring_size + 2 * static_cast<std::uint32_t>(arcs.size());
  }

 private:
  /// A point on a segment.
  struct Contact {
    std::uint32_t segment;
    std::uint32_t point;
  };

  Sign compare(std::uint32_t i, std::uint32_t j) const {
    return compare_xy(PlanePointsView(points), i, j);
  }
  /// Returns Positive if the point lies left of the segment's line.
  Sign side(const FaceSegment& s, std::uint32_t point) const {
    return orient2d(PlanePointsView(points), s.from, s.to, point);
  }
  bool is_given(std::uint32_t point) const { return point < points.inputs.size(); }
  bool is_reverse(std::uint32_t h) const { return ((h - ring_size) & 1U) != 0; }
  std::uint32_t reverse(std::uint32_t h) const { return ((h - ring_size) ^ 1U) + ring_size; }

  void orient_segments();
  void find_contacts(Context& context);
  void meet(std::uint32_t s, std::uint32_t t);
  bool is_inside(std::uint32_t point, const FaceSegment& s) const;
  void sharpen();
  void split();
  std::uint32_t representative(std::uint32_t point) const;
  void unite(std::uint32_t i, std::uint32_t j);
  void merge_overlaps(SurfaceBundles& bundles);
  void link(Context& context);
  bool turns_before(std::uint32_t g, std::uint32_t h) const;
  void trace_loops();
  void nest(Context& context);
  void find_islands();
  void find_below(Context& context);
  void sweep_below(Context& context);
  std::vector<std::uint32_t> points_in_order() const;
  std::uint32_t side_below(std::uint32_t point) const;
  bool is_below(const FaceArc& a, std::uint32_t point) const;
  bool is_lower(const FaceArc& a, const FaceArc& b) const;

  std::vector<Contact> contacts_;
  bool overlaps_ = false;
  std::vector<std::uint32_t> same_;       // Per crossing: an equal point, or itself.
  std::vector<std::uint32_t> out_begin_;  // Per point.
  std::vector<std::uint32_t> out_;        // Half-edges of arcs by origin, counter-clockwise.
  // The leftmost point of each component that does not reach the boundary, from left to right.
  std::vector<std::uint32_t> islands_;
  std::vector<std::uint32_t> below_;    // Per island: the half-edge below its leftmost point.
  std::vector<Box3> boxes_;             // Per segment.
  std::vector<std::uint32_t> loop_of_;  // Per half-edge.
  std::vector<SignedEntry> terms_;
};

}  // namespace plumb
