// The results of the sweep over the edges of a map: illegal contacts, and the order of the edges
// around every vertex.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "plumb/base/context.h"
#include "plumb/plane/check/map_edges.h"

namespace plumb {

/// Two edges that meet elsewhere than at a common vertex.
struct EdgeContact {
  /// The kind of contact.
  enum class Kind {
    Cross,    ///< The interiors cross in one point.
    Touch,    ///< A vertex of one lies inside the other.
    Alias,    ///< Two vertices have equal coordinates.
    Overlap,  ///< They have more than a point in common; the place is where that begins.
  };
  Kind kind;
  std::uint32_t edge_a;               ///< The edge with the lesser number.
  std::uint32_t edge_b;               ///< The other edge.
  std::uint32_t vertex = 0;           ///< The vertex at the place, for Touch, Alias and Overlap.
  std::optional<Crossing2> crossing;  ///< The place, for Cross.
};

/// The rotation system and the places of components. Complete only if there are no contacts.
struct MapRotation {
  std::vector<std::uint32_t> orbit_next;  ///< The next half-edge of the induced face of each one.
  std::vector<std::uint32_t> order;       ///< The number of each vertex in lexicographic order.
  std::vector<std::uint32_t>
      edge_below;  ///< The edge below each component's first vertex or kNone.
};

/// A vertex in the interior of an edge.
struct VertexOnEdge {
  std::uint32_t edge;    ///< The edge.
  std::uint32_t vertex;  ///< The vertex.
};

/// The results of the sweep.
struct MapContacts {
  std::uint64_t count = 0;  ///< The number of all pairs of edges in contact.
  /// The first contacts that the sweep meets, sorted by edges.
  std::vector<EdgeContact> described;
  /// The first contacts, sorted by edge, and along each edge from left to right.
  std::vector<VertexOnEdge> on_edge;
  MapRotation rotation;  ///< The order of edges around vertices.
};

/// Sweeps the edges once. Describes at most `max_described` contacts, and counts all.
MapContacts find_contacts(const Map& map, const MapEdges& edges, const MapComponents& components,
                          std::uint64_t max_described, Context& context);

}  // namespace plumb
