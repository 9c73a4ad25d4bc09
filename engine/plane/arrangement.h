// The arrangement of segments, rays and lines: every vertex, edge and face they cut the plane into,
// and which inputs each edge came from.
//
// Main flow of arrange(): renumber along the sweep (scene_order.h) -> sweep (sweep.h) -> PlaneBuilder
// keeps every piece, and takes the old numbers back -> PlaneAssembler.
// Cost: O((n + k) log n) for n curves and k crossings, overlaps included: the edges of n nested
// segments on one line come from n^2 curves in all, but their sets share what they have in common.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "plumb/base/context.h"
#include "plumb/plane/plane_complex.h"
#include "plumb/plane/segment_sets.h"
#include "plumb/plane/sweep.h"

#pragma GCC visibility push(default)
namespace plumb {

/// What curves cut the plane into.
struct Arrangement {
  PlaneComplex
      complex;  ///< nothing marked; not minimal: end points inside other edges are vertices
  SegmentSets origin_sets;                ///< of curves
  std::vector<SegmentSets::Set> origins;  ///< per ordinary edge, in origin_sets

  /// The curves that an edge is part of, ascending. O(their number).
  std::vector<SegmentId> origins_of(EdgeId e) const {
    std::vector<SegmentId> curves;
    origin_sets.append(origins[e.value()], curves);
    return curves;
  }
};

/// Arranges the curves and the isolated points. Curves of length zero become isolated points.
Arrangement arrange(const PlanePoints& points, std::span<const SweepCurve> curves,
                    std::span<const std::uint32_t> isolated, Context& context);

/// The same for segments between input points.
Arrangement arrange(PointTable2 points, std::span<const SweepSegment> segments, Context& context);

}  // namespace plumb
#pragma GCC visibility pop
