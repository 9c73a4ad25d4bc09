// Faces of the graph that a listing's edges really induce, and how the listed cycles fit them.
//
// An orbit is one boundary cycle of an induced face: follow orbit_next. It runs counter-clockwise
// when it is the outer boundary of a bounded face, clockwise when it is the outside of a component.
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "plumb/plane/check/map_contacts.h"

namespace plumb {

struct MapOrbits {
  struct Orbit {
    std::uint32_t halfedge;  ///< one of them, leaving its lexicographically first vertex
    std::uint32_t cycle;     ///< a listed cycle with half-edges in it, or kNone
    bool counterclockwise;
    bool mixed;     ///< defect: see is_mixed() in map_orbits.cpp
    bool complete;  ///< every half-edge of it is listed
  };

  std::vector<Orbit> orbits;
  std::vector<std::uint32_t> of_halfedge;
  std::vector<std::uint32_t> outside;  ///< per component: its clockwise orbit
};

/// Requires a map without duplicate uses and without contacts. O(n); exact areas of cycles are
/// taken only where orbits and listed cycles differ.
MapOrbits trace_orbits(const Map& map, const MapEdges& edges, const MapComponents& components,
                       const MapRotation& rotation);

/// The listed cycles with half-edges in an orbit, ascending.
std::vector<std::uint32_t> cycles_of_orbit(const MapEdges& edges, const MapRotation& rotation,
                                           std::uint32_t halfedge);

/// For each component the orbit it lies in: a counter-clockwise one, or kNone for the unbounded
/// face.
std::vector<std::uint32_t> nest_components(const MapEdges& edges, const MapComponents& components,
                                           const MapRotation& rotation, const MapOrbits& orbits);

/// Vertices at which one orbit passes more than once, ascending.
std::vector<std::uint32_t> find_pinches(const Map& map, const MapEdges& edges,
                                        const MapOrbits& orbits);

}  // namespace plumb
