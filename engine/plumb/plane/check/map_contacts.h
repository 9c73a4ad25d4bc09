// What the sweep tells about the edges of a map: illegal contacts, and the way the edges lie around
// every vertex.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "plumb/base/context.h"
#include "plumb/plane/check/map_edges.h"

namespace plumb {

/// Two edges that meet anywhere but at a common vertex.
struct EdgeContact {
  enum class Kind {
    Cross,    ///< interiors cross in one point
    Touch,    ///< a vertex of one lies inside the other
    Alias,    ///< two vertices with equal coordinates
    Overlap,  ///< more than a point in common; the place is where that begins
  };
  Kind kind;
  std::uint32_t edge_a;  ///< edge_a < edge_b
  std::uint32_t edge_b;
  std::uint32_t vertex = 0;           ///< the vertex at the place (Touch, Alias, Overlap)
  std::optional<Crossing2> crossing;  ///< the place, for Cross
};

/// Rotation system and places of components; complete only when there are no contacts.
struct MapRotation {
  std::vector<std::uint32_t> orbit_next;  ///< per half-edge: the next one of its induced face
  std::vector<std::uint32_t> order;       ///< per vertex: its number in lexicographic order
  std::vector<std::uint32_t> edge_below;  ///< per component: edge below its first vertex, or kNone
};

/// A vertex in the interior of an edge.
struct VertexOnEdge {
  std::uint32_t edge;
  std::uint32_t vertex;
};

struct MapContacts {
  std::uint64_t count = 0;             ///< all pairs of edges in contact
  std::vector<EdgeContact> described;  ///< the first ones met by the sweep, sorted by edges
  std::vector<VertexOnEdge> on_edge;   ///< the first ones; by edge, then along it left to right
  MapRotation rotation;
};

/// Sweeps the edges once. Describes at most `max_described` contacts.
MapContacts find_contacts(const Map& map, const MapEdges& edges, const MapComponents& components,
                          std::uint64_t max_described, Context& context);

}  // namespace plumb
