// Gaps that open to the outside or into a hole: channels and notches between features.
//
// A bridge is a segment that crosses an uncovered face from one feature to another one. It is
// shorter than the bound for widths. Bridges cut narrow cells off the outside and off holes.
//
// Main flow, by two arrangements:
//  1. open_gap_bridges   finds the bridges: from corners of a border to the nearest points of edges
//                        of other features, and where two edges come as near as the bound
//  2. CoveredCells       arranges the rings and the bridges
//  3. join_open_cells    unites narrow cells that share bridges to gaps, and takes the bridges away
//                        at which there is no gap
//
// A gap is open to its surroundings at its mouths, which are bridges. Its border along features is
// at least twice as long as its mouths, and two features are along it. So a short dent is no gap.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "plumb/base/context.h"
#include "plumb/base/internal/union_find.h"
#include "plumb/plane/layer/covered_cells.h"
#include "plumb/plane/plane_complex.h"

namespace plumb {

/// Returns the bridges of an arrangement. For each face, `owner` is the feature to which it
/// belongs, or LayerRegion::kNobody if it is open. Requires below >= 0.
Bridges open_gap_bridges(const PlaneComplex& complex, std::span<const std::uint32_t> owner,
                         double below, Context& context);

/// When narrow cells are a gap.
struct OpenGapRule {
  double below;     ///< Gaps are narrower than this width.
  double slender;   ///< If the bound is a default, 4 A / p^2 of a gap is less than this,
  double rounding;  ///< or its width is less than this.
  bool is_default;  ///< Whether `below` is a default.
};

/// Joins faces across bridges. `classes` unites faces that only edges without meaning separate.
/// Returns for each face whether it is the root of the class of a gap that is open at a mouth.
std::vector<std::uint8_t> join_open_cells(const CoveredCells& cells, UnionFind& classes,
                                          const OpenGapRule& rule, Context& context);

}  // namespace plumb
