// The faces that the edges of a map really induce, and how the listed cycles fit them.
//
// An orbit is one boundary cycle of an induced face: a cycle of orbit_next. It runs
// counter-clockwise if it is the outer boundary of a bounded face, clockwise if it is the outside
// of a component.
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

/// Returns the vertices that one orbit passes more than once, ascending.
std::vector<std::uint32_t> find_pinches(const Map& map, const MapEdges& edges,
                                        const MapOrbits& orbits);

}  // namespace plumb
