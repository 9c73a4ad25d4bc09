// The sphere map at any vertex, edge or facet of a complex: what a small sphere around one of its
// points meets.
//
//   vertex   has its half-edges as points, its corners as arcs, and parts of volumes as faces
//   edge     has two opposite points, joined by a half-circle for each use
//   facet    has one loop between two faces
//
// A vertex whose map is connected needs no arithmetic. Otherwise cycles are grouped into faces by
// walks along great circles (docs/design/sphere.md, Nesting).
#pragma once

#include <vector>

#include "plumb/space/space_complex.h"
#include "plumb/sphere/sphere_map.h"

#pragma GCC visibility push(default)
namespace plumb {

/// The sphere map of an item, and the cells of the complex that its cells belong to.
struct LocalMap {
  SphereMap map;  ///< The map, seen from the item outwards.
  /// The half-edge of each point, which leaves the item. An edge has both its half-edges.
  std::vector<HalfedgeId> halfedge;
  /// The use of each arc. Around a vertex the arc is the corner of the use, around an edge it is
  /// its half-circle; a loop has no use (invalid).
  std::vector<UseId> use;
  std::vector<FacetId> facet;    ///< The facet of each arc.
  std::vector<VolumeId> volume;  ///< The volume of each face; invalid while not labelled.

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

/// Replaces `out` by the map of an item, reusing its memory. Requires that the item is a vertex,
/// edge or facet.
void local_map(const SpaceComplex& complex, SpaceItem item, LocalMap& out);

/// Returns the direction of a half-edge.
inline SphereDirection direction_of(const SpaceComplex& complex, HalfedgeId h) {
  const auto& [p, q] = complex.edge_planes[h.value() >> 1U];
  return SpaceComplex::is_reverse(h) ? SphereDirection{q, p} : SphereDirection{p, q};
}

}  // namespace plumb
#pragma GCC visibility pop
