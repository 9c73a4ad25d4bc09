// Computes sphere maps. The sphere map at a vertex, edge or facet of a complex is the intersection
// of the complex with a small sphere around a point of that cell.
//
//   vertex   the half-edges at the vertex are points of the map, the sectors of facets at the
//            vertex are arcs, and the parts of volumes around the vertex are faces
//   edge     the map has two opposite points, which are joined by one half-circle for each edge use
//            (an occurrence of the edge on the boundary of a facet, space_complex.h)
//   facet    the map consists of a great circle (a loop) between two faces
//
// If the map of a vertex is connected, no arithmetic is needed. Otherwise a face of the map can
// have several boundary cycles. Walks along great circles determine which cycles bound the same
// face (docs/design/sphere.md, section Nesting).
#pragma once

#include <vector>

#include "plumb/space/space_complex.h"
#include "plumb/sphere/sphere_map.h"

#pragma GCC visibility push(default)
namespace plumb {

/// The sphere map of an item, which is a vertex, edge or facet of a complex. For each cell of the
/// map, the structure also has the cell of the complex to which it belongs.
struct LocalMap {
  SphereMap map;  ///< The map, seen from the centre of the sphere.
  /// The half-edge of each point of the map. In the map of a vertex, this half-edge leaves the
  /// vertex in the direction of the point. In the map of an edge, the two half-edges of the edge
  /// belong to the two points.
  std::vector<HalfedgeId> halfedge;
  /// The edge use to which each arc belongs. In the map of a vertex, the arc is the corner of the
  /// use. In the map of an edge, the arc is the half-circle of the use. A loop belongs to no edge
  /// use, so its entry is invalid.
  std::vector<UseId> use;
  std::vector<FacetId> facet;  ///< The facet of each arc.
  /// For each face, the volume (the cell of the complex) in which it lies. Invalid if the volumes
  /// of the complex have not been found yet.
  std::vector<VolumeId> volume;

  /// Returns the item of the complex to which a cell of the map belongs.
  SpaceItem item(SphereCell cell) const {
    switch (cell.kind()) {
      case SphereCell::Kind::Point:
        return SpaceComplex::edge_of(halfedge[cell.index()]);
      case SphereCell::Kind::Arc:
        return facet[cell.index()];
      case SphereCell::Kind::Face:
        break;
    }
    return volume[cell.index()];
  }
};

/// Stores the map of an item in `out`, and reuses the memory of `out`. Requires that the item is a
/// vertex, edge or facet.
void local_map(const SpaceComplex& complex, SpaceItem item, LocalMap& out);

/// Returns the direction of a half-edge, given by the two planes of its edge.
inline SphereDirection direction_of(const SpaceComplex& complex, HalfedgeId h) {
  const auto& [p, q] = complex.edge_planes[h.value() >> 1U];
  return SpaceComplex::is_reverse(h) ? SphereDirection{q, p} : SphereDirection{p, q};
}

}  // namespace plumb
#pragma GCC visibility pop
