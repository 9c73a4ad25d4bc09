// A convex polytope in the making, as half-edges between bounds (half_space_hull.h). Internal.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "plumb/base/context.h"
#include "plumb/predicates/error.h"
#include "plumb/space/half_space_list.h"
#include "plumb/space/nef3.h"
#include "plumb/space/space_complex.h"

namespace plumb {

/// What is kept of a half-space: below the oriented plane.
struct HullBound {
  OrientedPlane plane;
  bool is_open;
  std::uint32_t index;  ///< of the half-space; kNone: of the cube
};

/// The polytope: half-edges 2i and 2i + 1 are twins; each runs with its facet to the left, seen
/// from outside.
class HullPolytope {
 public:
  struct Halfedge {
    std::uint32_t origin;
    std::uint32_t next;
    std::uint32_t prev;
    std::uint32_t facet;  ///< index of its bound; kNone: gone
  };
  struct Vertex {
    SpacePoint point;
    std::uint32_t half;  ///< one that leaves it; kNone: gone
  };

  static std::uint32_t twin(std::uint32_t h) { return h ^ 1U; }
  std::uint32_t target(std::uint32_t h) const { return halfedge[twin(h)].origin; }
  void link(std::uint32_t h, std::uint32_t after) {
    halfedge[h].next = after;
    halfedge[after].prev = h;
  }
  /// Calls visit(h) for the half-edges that leave a vertex.
  template <class Visit>
  void for_each_leaving(std::uint32_t v, const Visit& visit) const {
    const std::uint32_t first = vertex[v].half;
    std::uint32_t h = first;
    do {
      visit(h);
      h = twin(halfedge[h].prev);
    } while (h != first);
  }
  std::uint32_t add_vertex(SpacePoint point, std::uint32_t half) {
    PLUMB_CHECK(point.is_valid());
    vertex.push_back({point, half});
    return static_cast<std::uint32_t>(vertex.size() - 1);
  }
  /// From a to b along the facet; its twin has no facet yet. Not linked.
  std::uint32_t add_edge(std::uint32_t a, std::uint32_t b, std::uint32_t facet) {
    halfedge.push_back({a, kNone, kNone, facet});
    halfedge.push_back({b, kNone, kNone, kNone});
    return static_cast<std::uint32_t>(halfedge.size() - 2);
  }

  /// Per bound: is there a facet on it?
  std::vector<std::uint8_t> facets_left(std::size_t bounds) const;

  std::vector<Vertex> vertex;
  std::vector<Halfedge> halfedge;
};

/// In minimal form. `touching`: open bounds that cut nothing off but take away what they touch.
SpaceComplex complex_of_polytope(const HullPolytope& polytope, std::span<const HullBound> bounds,
                                 std::span<const std::uint32_t> touching,
                                 std::shared_ptr<SpaceTables> tables);

// The intersection of half-spaces as a convex polytope, without Booleans.
//
// Main flow:
//  1. take_planes   equal ones once; an open one hides a closed one
//  2. make_cube     the polytope begins as the cube of the frame (frame.h), so that it is bounded
//                   from the first
//  3. insert        one after the other, in an order that depends on nothing but their number. Each
//                   half-space to come knows a vertex that it cuts off (open: or touches), or none
//                   and is forgotten. From there the vertices outside are found, each facet around
//                   them loses a chain of edges and gets a new one, these bound the new facet. Who
//                   knew a vertex that goes looks at the vertices of the new facet: what a
//                   half-space cuts off hangs together, so one of them is outside if any vertex is
//  4. complex       edges, uses and facets of what is left
//
// Signs are sides of vertices on planes (point3_signs.h), nothing else. Cost: expected O(n log n).
// Source: Clarkson and Shor, Discrete & Computational Geometry 4 (1989), for the conflicts.

struct HalfSpaceHull {
  /// In minimal form; none if the intersection reaches to infinity or has no inside.
  std::optional<SpaceComplex> polytope;
  /// Of the half-spaces given, those that have the same intersection: with a facet of it, or open
  /// and touching it. All, if it has no inside.
  std::vector<std::uint32_t> needed;
};

/// Throws Error{BadArgument} for a plane without a normal, and what the context throws.
HalfSpaceHull hull_of_half_spaces(std::span<const HalfSpace3> half_spaces, Context& context);
HalfSpaceHull hull_of_half_spaces(const HalfSpaceList& half_spaces, Context& context);

}  // namespace plumb
