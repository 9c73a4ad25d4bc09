// Edges of a mesh, and its complex. The first part finds the corners of facets that run along each
// edge, and merges doubled facets. The second part makes a complex of facets that meet only in
// common vertices and edges. It makes edges, edge uses, radial orders and stars.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "plumb/space/mesh/mesh_facets.h"
#include "plumb/space/space_complex.h"

namespace plumb {

/// The edges of a mesh with their edge uses (Weiler). Uses are numbered as MeshFacets::corner: use
/// u leaves that corner in the canonical direction.
struct MeshLinks {
  std::vector<std::uint32_t> next;   ///< The next use along the facet of each use.
  std::vector<std::uint32_t> facet;  ///< The facet of each use.
  /// The two vertices of each edge, ascending; edges are sorted by them.
  std::vector<std::array<std::uint32_t, 2>> end;
  std::vector<std::uint32_t> begin;  ///< Starts in `use`, edge_count() + 1 of them.
  std::vector<std::uint32_t> use;    ///< The uses of each edge, ascending.

  /// Returns the number of edges.
  std::size_t edge_count() const { return end.size(); }
  /// Returns the uses of an edge.
  std::span<const std::uint32_t> uses_of(std::size_t e) const {
    return std::span(use).subspan(begin[e], begin[e + 1] - begin[e]);
  }
  /// Whether the use runs from the lesser vertex of its edge to the greater one.
  bool is_forward(const MeshFacets& facets, std::uint32_t u) const {
    return facets.corner[u] < facets.corner[next[u]];
  }
};

/// Returns the edges of the facets. O(n log k) for n corners, k at a vertex.
MeshLinks link_corners(const MeshFacets& facets, std::size_t vertex_count);

/// Whether every edge has two uses at which its facets balance, no facet comes twice, and no face
/// is without area. Nearly all closed meshes have this property. They need no search for doubled
/// facets or for borders. The result may be false if facets of one plane begin with one edge. O(n)
/// for n corners.
bool is_plainly_closed(const MeshFacets& facets, const MeshLinks& links);

/// Merges facets with equal boundaries into one with the sum of their jumps, and links again if
/// there are any. Returns the pairs (input face, earlier input face), ascending.
std::vector<MeshReport::FacePair> merge_doubled(MeshFacets& facets, MeshLinks& links,
                                                std::size_t vertex_count);

// The complex of facets that meet in common vertices and edges.

/// What is done with an edge between two triangles of one plane with corners at input points. The
/// tests of such triangles need no planes of edges, and most of these edges are removed later.
enum class FlatEdges : std::uint8_t {
  Complete,  ///< They get a second plane, which goes through them and is parallel to an axis.
  Open,      ///< They keep one plane, with half-edges in any order, until they are completed.
};

/// Returns the complex of the facets, with all marks 0 and invalid volumes. `points` has the place
/// of each vertex. Adds to the tables second planes for edges whose facets all lie in one plane.
/// O(n log k) for k uses of an edge.
SpaceComplex link_facets(const MeshFacets& facets, const MeshLinks& links,
                         std::span<const SpacePoint> points,
                         const std::shared_ptr<SpaceTables>& tables,
                         FlatEdges flat_edges = FlatEdges::Complete);

/// Gives open edges their second planes, and turns half-edges that do not run as the planes say.
/// Requires that nobody else reads the tables meanwhile.
void complete_flat_edges(SpaceComplex& complex, SpaceTables& tables);

}  // namespace plumb
