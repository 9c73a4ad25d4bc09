// The segments of polygons in one face, arranged.
//
// Main flow of run():
//  1. contacts   pairs of segments whose boxes meet: crossings, ends on other segments, overlaps
//  2. split      the points on each segment in order; equal ones become one (union-find)
//  3. merge      pieces of overlapping segments add up; those that cancel go
//  4. link       half-edges in angular order around nodes; next around pieces
//  5. nest       parts that do not reach the boundary lie in a piece: the one below their leftmost
//                point, which a sweep over the points finds where there are many of them
//
// Equal crossings are found where they are neighbours on a segment: whatever else runs through the
// point meets that segment there, too. So only the order along segments is ever asked, never
// equality of two points anywhere.
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

/// One of the different segments of a face, between two points of it. `bundle`: what polygons run
/// along it.
struct FaceSegment {
  std::uint32_t from;  ///< lexicographically the lesser, once run() was called
  std::uint32_t to;
  std::uint32_t bundle;
  std::int32_t sign;  ///< -1: the bundle is meant from `to` to `from`
};

/// A piece of segments between two points. `from` comes first lexicographically.
struct FaceArc {
  std::uint32_t from;
  std::uint32_t to;
  std::uint32_t segment;  ///< one that it lies on
  std::uint32_t bundle;
  std::int32_t sign;
};

/// Used for one face after the other: keeps its memory.
class FaceArrangement {
 public:
  /// Input: the boundary's points first, counter-clockwise from corner 0, then others; distinct.
  PlanePoints points;           ///< crossings are output
  std::uint32_t ring_size = 0;  ///< points on the boundary
  std::uint32_t corner_1 = 0;   ///< of them, where side 0 ends
  std::vector<FaceSegment> segments;

  void clear();
  /// Errors: Cancelled, ResourceLimit.
  void run(SurfaceBundles& bundles, Context& context);

  // Output. Half-edge r < ring_size runs from point r along the boundary; ring_size + 2 a and the
  // one after it are arc a and its reverse.
  std::vector<FaceArc> arcs;
  std::vector<std::uint32_t> next;
  std::vector<std::uint32_t> piece;  ///< per half-edge
  std::uint32_t piece_count = 0;
  struct Loop {
    std::uint32_t piece;
    std::uint32_t halfedge;
    bool is_hole;
  };
  std::vector<Loop> loops;  ///< by piece, the outer one first

  std::uint32_t origin(std::uint32_t h) const {
    if (h < ring_size) return h;
    const FaceArc& a = arcs[(h - ring_size) / 2];
    return is_reverse(h) ? a.to : a.from;
  }
  std::uint32_t halfedge_count() const {
    return ring_size + 2 * static_cast<std::uint32_t>(arcs.size());
  }

 private:
  struct Contact {
    std::uint32_t segment;
    std::uint32_t point;
  };

  Sign compare(std::uint32_t i, std::uint32_t j) const {
    return compare_xy(PlanePointsView(points), i, j);
  }
  /// Positive: the point lies left of the segment's line.
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
  std::vector<std::uint32_t> same_;       // per crossing: an equal point, or itself
  std::vector<std::uint32_t> out_begin_;  // per point
  std::vector<std::uint32_t> out_;        // half-edges of arcs by origin, counter-clockwise
  std::vector<std::uint32_t>
      islands_;                       // the leftmost point of each part without boundary, in order
  std::vector<std::uint32_t> below_;  // per island: the half-edge below its leftmost point
  std::vector<Box3> boxes_;           // of segments
  std::vector<std::uint32_t> loop_of_;  // per half-edge
  std::vector<SignedEntry> terms_;
};

}  // namespace plumb
