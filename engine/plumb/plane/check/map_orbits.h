// The faces that the edges of a map really induce, and how the listed cycles fit them.
//
// An orbit is one boundary cycle of an induced face: a cycle of orbit_next. It runs
// counter-clockwise if it is the outer boundary of a bounded face, clockwise if it is the outside
// of a component.
//
// Two models of a region are accepted. In the model of cycles, the outer boundary of a region is
// one counter-clockwise cycle, which may touch itself. In the model of rings, which GIS use, it is
// a counter-clockwise shell and clockwise holes that touch the shell or each other at vertices.
// trace_orbits() knows the model of cycles; settle_touching_rings() finds the regions of the other.
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "plumb/plane/check/map_contacts.h"

namespace plumb {

/// The orbits of a map.
struct MapOrbits {
  /// One orbit.
  struct Orbit {
    std::uint32_t halfedge;  ///< A half-edge that leaves its lexicographically first vertex.
    std::uint32_t cycle;     ///< The least listed cycle with half-edges in it, or kNone.
    bool counterclockwise;   ///< Whether it is the outer boundary of a bounded face.
    bool mixed;              ///< Whether it is a defect, as is_mixed() in map_orbits.cpp says.
    bool complete;           ///< Whether every half-edge of it is listed.
  };

  std::vector<Orbit> orbits;               ///< All orbits, by their least half-edges.
  std::vector<std::uint32_t> of_halfedge;  ///< The orbit of each half-edge.
  std::vector<std::uint32_t> outside;      ///< The clockwise orbit of each component.
};

/// Returns the orbits. Requires a map in which no half-edge is listed twice, without contacts.
/// O(n); exact areas of cycles are computed only where orbits and listed cycles differ.
MapOrbits trace_orbits(const Map& map, const MapEdges& edges, const MapComponents& components,
                       const MapRotation& rotation);

/// Returns the listed cycles with half-edges in the orbit of a half-edge, ascending.
std::vector<std::uint32_t> cycles_of_orbit(const MapEdges& edges, const MapRotation& rotation,
                                           std::uint32_t halfedge);

/// Returns for each component the orbit in which it lies: a counter-clockwise one, or kNone for the
/// unbounded face.
std::vector<std::uint32_t> nest_components(const MapEdges& edges, const MapComponents& components,
                                           const MapRotation& rotation, const MapOrbits& orbits);

/// Finds the regions of which the boundary is listed as rings that touch, and clears the flag
/// `mixed` of their orbits. `parent` is the result of nest_components(). Returns for each listed
/// cycle the counter-clockwise cycle around its region, or kNone if the region is unbounded; the
/// entry of a cycle in a defective region has no meaning. Requires the same as trace_orbits(). O(n
/// a(n)), and the exact area of every listed cycle.
std::vector<std::uint32_t> settle_touching_rings(const Map& map, const MapEdges& edges,
                                                 const MapComponents& components,
                                                 const std::vector<std::uint32_t>& parent,
                                                 MapOrbits& orbits);

/// Returns for each orbit a listed counter-clockwise cycle with half-edges in it, the least one, or
/// kNone. The region inside of that cycle claims the face of the orbit. O(n), and the exact area of
/// every listed cycle.
std::vector<std::uint32_t> claims_of_orbits(const Map& map, const MapEdges& edges,
                                            const MapOrbits& orbits);

/// Returns the vertices that one orbit passes more than once, ascending.
std::vector<std::uint32_t> find_pinches(const Map& map, const MapEdges& edges,
                                        const MapOrbits& orbits);

}  // namespace plumb
