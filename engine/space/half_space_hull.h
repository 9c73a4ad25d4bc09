// The intersection of half-spaces as a convex polytope, without Booleans.
//
// Main flow:
//  1. take_planes   equal ones once; an open one hides a closed one
//  2. make_cube     the polytope begins as the cube of the frame (frame.h), so that it is bounded from the first
//  3. insert        one after the other, in an order that depends on nothing but their number. Each half-space
//                   to come knows a vertex that it cuts off (open: or touches), or none and is forgotten. From
//                   there the vertices outside are found, each facet around them loses a chain of edges
//                   and gets a new one, these bound the new facet. Who knew a vertex that goes looks at the
//                   vertices of the new facet: what a half-space cuts off hangs together, so one of them
//                   is outside if any vertex is
//  4. complex       edges, uses and facets of what is left
//
// Signs are sides of vertices on planes (point3_signs.h), nothing else. Cost: expected O(n log n).
// Source: Clarkson and Shor, Discrete & Computational Geometry 4 (1989), for the conflicts.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "plumb/base/context.h"
#include "plumb/space/half_space_list.h"
#include "plumb/space/nef3.h"
#include "plumb/space/space_complex.h"

namespace plumb {

struct HalfSpaceHull {
  /// In minimal form; none if the intersection reaches to infinity or has no inside.
  std::optional<SpaceComplex> polytope;
  /// Of the half-spaces given, those that have the same intersection: with a facet of it, or open and touching it.
  /// All, if it has no inside.
  std::vector<std::uint32_t> needed;
};

/// Throws Error{BadArgument} for a plane without a normal, and what the context throws.
HalfSpaceHull hull_of_half_spaces(std::span<const HalfSpace3> half_spaces, Context& context);
HalfSpaceHull hull_of_half_spaces(const HalfSpaceList& half_spaces, Context& context);

}  // namespace plumb
