// The sphere map at any item of a complex: what a small sphere around one of its points sees.
//
//   vertex   its half-edges, corners and volumes
//   edge     two opposite points joined by a half-circle for each use
//   facet    one loop between two faces
//
// Vertices whose map is connected need no arithmetic; otherwise cycles are grouped into faces by
// shooting along great circles.
#pragma once

#include <vector>

#include "plumb/space/space_complex.h"
#include "plumb/sphere/sphere_map.h"

#pragma GCC visibility push(default)
namespace plumb {

/// The sphere map of an item and what its cells are.
struct LocalMap {
  SphereMap map;                     ///< seen from the item outwards
  std::vector<HalfedgeId> halfedge;  ///< per point; leaves the item (of an edge: both half-edges)
  std::vector<UseId> use;      ///< per arc: whose corner (of an edge: the use; of a facet: invalid)
  std::vector<FacetId> facet;  ///< per arc
  std::vector<VolumeId> volume;  ///< per face; invalid while volumes are not labelled

  /// The item of the complex that a cell of the map belongs to.
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

/// Fills `out`, keeping its memory. Requires a vertex, edge or facet.
void local_map(const SpaceComplex& complex, SpaceItem item, LocalMap& out);

/// Where a half-edge leads.
inline SphereDirection direction_of(const SpaceComplex& complex, HalfedgeId h) {
  const auto& [p, q] = complex.edge_planes[h.value() >> 1U];
  return SpaceComplex::is_reverse(h) ? SphereDirection{q, p} : SphereDirection{p, q};
}

}  // namespace plumb
#pragma GCC visibility pop
