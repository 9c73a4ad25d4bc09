// The intersection of half-spaces as a convex polytope, without Booleans. The first part is the
// polytope in the making, as half-edges between bounds; the second inserts half-spaces. Internal.
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

/// What is kept of a half-space: it lies below the oriented plane.
struct HullBound {
  OrientedPlane plane;  ///< Positive outside.
  bool is_open;         ///< Whether the plane does not belong to it.
  std::uint32_t index;  ///< The number of the half-space; kNone for a side of the cube.
};

/// The polytope: half-edges 2i and 2i + 1 are twins; each runs with its facet to the left, seen
/// from outside.
class HullPolytope {
 public:
  /// A half-edge.
  struct Halfedge {
    std::uint32_t origin;  ///< The vertex at which it begins.
    std::uint32_t next;    ///< The next one along the facet.
    std::uint32_t prev;    ///< The previous one along the facet.
    std::uint32_t facet;   ///< The index of its bound; kNone if it was removed.
  };
  /// A vertex.
  struct Vertex {
    SpacePoint point;    ///< Its place.
    std::uint32_t half;  ///< A half-edge that leaves it; kNone if it was removed.
  };

  /// Returns the half-edge of the same edge in the other direction.
  static std::uint32_t twin(std::uint32_t h) { return h ^ 1U; }
  /// Returns the vertex at which a half-edge ends.
  std::uint32_t target(std::uint32_t h) const { return halfedge[twin(h)].origin; }
  /// Lets one half-edge follow another one.
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
  /// Adds a vertex and returns its index.
  std::uint32_t add_vertex(SpacePoint point, std::uint32_t half) {
    PLUMB_CHECK(point.is_valid());
    vertex.push_back({point, half});
    return static_cast<std::uint32_t>(vertex.size() - 1);
  }
  /// Adds an edge and returns its half-edge from a to b along the facet. Its twin has no facet yet,
  /// and neither is linked.
  std::uint32_t add_edge(std::uint32_t a, std::uint32_t b, std::uint32_t facet) {
    halfedge.push_back({a, kNone, kNone, facet});
    halfedge.push_back({b, kNone, kNone, kNone});
    return static_cast<std::uint32_t>(halfedge.size() - 2);
  }

  /// Returns for each bound 1 if there is a facet on it, else 0.
  std::vector<std::uint8_t> facets_left(std::size_t bounds) const;

  std::vector<Vertex> vertex;      ///< All vertices, including removed vertices.
  std::vector<Halfedge> halfedge;  ///< All half-edges, including removed half-edges.
};

/// Returns the complex of a bounded polytope in minimal form. `touching` lists open half-spaces
/// that cut nothing off, but remove the points that touch their planes. O(n).
SpaceComplex complex_of_polytope(const HullPolytope& polytope, std::span<const HullBound> bounds,
                                 std::span<const std::uint32_t> touching,
                                 std::shared_ptr<SpaceTables> tables);

// The intersection of half-spaces.
//
// Main flow:
//  1. take_planes  takes equal planes once; an open half-space hides a closed one
//  2. make_cube    starts with the cube of the frame (frame.h), so that the polytope is bounded
//                  from the beginning
//  3. insert       inserts one half-space after the other, in an order that depends on nothing but
//                  their number. Each one to come knows a vertex that it cuts off (or touches, if
//                  it is open): its conflict. If there is none, it is forgotten. From there the
//                  vertices outside are found; each facet around them loses a chain of edges and
//                  gets a new edge, and these bound the new facet. A half-space whose conflict is
//                  removed looks for another one among the vertices of the new facet: what it cuts
//                  off is connected, so one of them is outside if any vertex is
//  4. complex      makes edges, uses and facets of what is left
//
// All signs are sides of vertices on planes (point3_signs.h). Cost: expected O(n log n). Source: K.
// Clarkson, P. Shor, Applications of random sampling in computational geometry, II, Discrete &
// Computational Geometry 4 (1989), for the conflicts.

/// The intersection of half-spaces.
struct HalfSpaceHull {
  /// The polytope in minimal form; empty if the intersection is unbounded or has no interior.
  std::optional<SpaceComplex> polytope;
  /// Half-spaces that have the same intersection: the half-spaces with a facet of it, and open
  /// half-spaces that touch it. In ascending order. All, if it has no interior.
  std::vector<std::uint32_t> needed;
};

/// Returns the intersection of half-spaces. Throws Error{BadArgument} for a plane without a normal,
/// and the errors of the Context.
HalfSpaceHull hull_of_half_spaces(std::span<const HalfSpace3> half_spaces, Context& context);
HalfSpaceHull hull_of_half_spaces(const HalfSpaceList& half_spaces, Context& context);

}  // namespace plumb
