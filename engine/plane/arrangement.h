// The arrangement of segments, rays and lines: every vertex, edge and face they cut the plane into,
// and which inputs each edge came from.
//
// Main flow of arrange(): renumber along the sweep (scene_order.h) -> sweep (sweep.h) -> PlaneBuilder
// keeps every piece, and takes the old numbers back -> PlaneAssembler.
// Cost: O((n + k) log n) for n curves and k crossings.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "plumb/base/context.h"
#include "plumb/plane/plane_complex.h"
#include "plumb/plane/sweep.h"

namespace plumb {

/// What curves cut the plane into.
struct Arrangement {
  PlaneComplex
      complex;  ///< nothing marked; not minimal: end points inside other edges are vertices
  std::vector<std::uint32_t> origin_begin;  ///< per ordinary edge, and one more
  std::vector<SegmentId> origins;           ///< the curves an edge is part of, ascending

  /// The curves that an edge is part of.
  std::span<const SegmentId> origins_of(EdgeId e) const {
    return {origins.data() + origin_begin[e.value()], origins.data() + origin_begin[e.value() + 1]};
  }
};

/// Arranges the curves and the isolated points. Curves of length zero become isolated points.
Arrangement arrange(const PlanePoints& points, std::span<const SweepCurve> curves,
                    std::span<const std::uint32_t> isolated, Context& context);

/// The same for segments between input points.
Arrangement arrange(PointTable2 points, std::span<const SweepSegment> segments, Context& context);

}  // namespace plumb
