// The sphere map at a vertex, edge or facet of a complex: the intersection of the complex with a
// small sphere around a point of that cell.
//
//   vertex   its half-edges are points of the map, its corners are arcs, and parts of volumes are
//            faces
//   edge     its map has two opposite points, joined by one half-circle for each edge use
//   facet    its map has one loop between two faces
//
// A vertex whose map is connected needs no arithmetic. Otherwise cycles are grouped into faces by
// walks along great circles (docs/design/sphere.md, Nesting).
#pragma once

#include <vector>

#include "plumb/space/space_complex.h"
#include "plumb/sphere/sphere_map.h"

#pragma GCC visibility push(default)
namespace plumb {

/// The sphere map of an item (a vertex, edge or facet of a complex), and the cell of the complex
/// that each cell of the map belongs to.
struct LocalMap {
  SphereMap map;  ///< The map, seen from the item outwards.
  /// The half-edge of each point, which leaves the item. The two points of an edge have its two
  /// half-edges.
  std::vector<HalfedgeId> halfedge;
  /// The edge use of each arc. Around a vertex the arc is the corner of the use. Around an edge the
  /// arc is the half-circle of the use. A loop has no use (invalid).
  std::vector<UseId> use;
  std::vector<FacetId> facet;  ///< The facet of each arc.
  /// The volume of each face; invalid while volumes are not labelled.
  std::vector<VolumeId> volume;

  /// Returns the item of the complex that a cell of the map belongs to.
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

/// Replaces `out` by the map of an item, and reuses the memory of `out`. Requires that the item is
/// a vertex, edge or facet.
void local_map(const SpaceComplex& complex, SpaceItem item, LocalMap& out);

/// Returns the direction of a half-edge.
inline SphereDirection direction_of(const SpaceComplex& complex, HalfedgeId h) {
  const auto& [p, q] = complex.edge_planes[h.value() >> 1U];
  return SpaceComplex::is_reverse(h) ? SphereDirection{q, p} : SphereDirection{p, q};
}

}  // namespace plumb
#pragma GCC visibility pop
