// Which corners of a mesh's facets run along which edge.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "plumb/space/mesh/mesh_facets.h"
#include "plumb/space/space_complex.h"

namespace plumb {

/// Uses are numbered as MeshFacets::corner: use u leaves that corner in the canonical direction.
struct MeshLinks {
  std::vector<std::uint32_t> next;   ///< per use
  std::vector<std::uint32_t> facet;  ///< per use
  std::vector<std::array<std::uint32_t, 2>>
      end;                           ///< per edge: vertices, ascending; edges ascend by them
  std::vector<std::uint32_t> begin;  ///< edge_count() + 1 entries into use
  std::vector<std::uint32_t> use;    ///< of edges; ascending in each

  std::size_t edge_count() const { return end.size(); }
  std::span<const std::uint32_t> uses_of(std::size_t e) const {
    return std::span(use).subspan(begin[e], begin[e + 1] - begin[e]);
  }
  /// Does the use run from the lesser end to the greater one?
  bool is_forward(const MeshFacets& facets, std::uint32_t u) const {
    return facets.corner[u] < facets.corner[next[u]];
  }
};

/// O(n log k) for n corners, k at a vertex.
MeshLinks link_corners(const MeshFacets& facets, std::size_t vertex_count);

/// Makes facets with equal boundaries one, with the sum of their jumps; then links again. Returns
/// (input face, earlier input face), ascending.
std::vector<MeshReport::FacePair> merge_doubled(MeshFacets& facets, MeshLinks& links,
                                                std::size_t vertex_count);

// Edges, uses, radial orders and stars of facets that meet in common vertices and edges.

/// Edges between two triangles of one plane, with corners at input points: what is asked of such
/// triangles needs no planes of edges.
enum class FlatEdges : std::uint8_t {
  Complete,  ///< have a second plane: through them, parallel to an axis
  Open,      ///< have that one plane, and half-edges in any order, until they go or are completed
};

/// The complex of the facets, all marks 0, volumes invalid. Adds second planes of edges at which
/// all facets are in one plane. O(n log k) for k uses of an edge.
SpaceComplex link_facets(const MeshFacets& facets, const MeshLinks& links,
                         std::span<const SpacePoint> points,
                         const std::shared_ptr<SpaceTables>& tables,
                         FlatEdges flat_edges = FlatEdges::Complete);

/// Gives open edges their second planes.
void complete_flat_edges(SpaceComplex& complex, SpaceTables& tables);

}  // namespace plumb
