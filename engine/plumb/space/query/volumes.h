// The volumes of a complex: connected parts of space between its facets.
//
// The first part makes classes of sides of facets, free edges and vertices that bound one volume
// without a gap: shells. The second unites shells to volumes, the third computes winding numbers.
//
// Nodes: side s of facet f is 2f + s (0 is the positive one); the only face of the map of a vertex
// v without facets around it is 2F + v for F facets. Two nodes are united where they meet at an
// edge or in one face of a sphere map.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "plumb/base/context.h"
#include "plumb/base/internal/union_find.h"
#include "plumb/space/local_maps.h"
#include "plumb/space/space_complex.h"

namespace plumb {

/// The classes of nodes.
class ShellNodes {
 public:
  /// Unites all nodes. Volumes of the complex are not read. `connected` is as for label_volumes().
  /// If `context` is not null, its limits are checked. O(n alpha(n)), and a sphere map for each
  /// vertex whose map is not connected.
  explicit ShellNodes(const SpaceComplex& complex, std::span<const std::uint8_t> connected = {},
                      const Context* context = nullptr);

  /// Returns the number of nodes.
  std::size_t size() const { return classes_.size(); }
  /// Returns the representative of a node's class.
  std::uint32_t root(std::uint32_t node) { return classes_.root(node); }
  /// Unites two classes.
  void unite(std::uint32_t i, std::uint32_t j) { classes_.unite(i, j); }

  /// Returns the node of a side of a facet.
  static std::uint32_t facet_node(FacetId f, bool is_negative_side) {
    return 2 * f.value() + (is_negative_side ? 1 : 0);
  }
  /// Returns the node of a vertex without facets around it.
  std::uint32_t vertex_node(VertexId v) const {
    return static_cast<std::uint32_t>(2 * complex_.facet_count()) + v.value();
  }
  /// Returns the node around an edge without uses, or kNone for other edges.
  std::uint32_t free_node(EdgeId e) const { return free_node_[e]; }
  /// Returns the node that follows an edge use (Weiler) in radial order.
  std::uint32_t node_after(UseId u) const {
    const HalfedgeId h = complex_.use_halfedge[u];
    return facet_node(complex_.use_facet[u], SpaceComplex::is_reverse(h));
  }
  /// Returns the node before an edge use in radial order.
  std::uint32_t node_before(UseId u) const { return node_after(u) ^ 1U; }

  /// Sets node[i] to a node of face i of the map of a cell. A face without arcs gets the node of
  /// the cell itself.
  void face_nodes(const LocalMap& local, SpaceItem item, std::vector<std::uint32_t>& node) const;

 private:
  void unite_around_edges(const Context* context);
  std::vector<VertexId> irregular_vertices(std::span<const std::uint8_t> connected,
                                           const Context* context) const;
  void unite_at_irregular_vertices(std::span<const std::uint8_t> connected, const Context* context);

  const SpaceComplex& complex_;
  UnionFind classes_;
  IdVector<EdgeId, std::uint32_t> free_node_;
};

/// Whether the corners around a vertex make one ring on which all its edges are, so that each of
/// them has two facets. Nearly all vertices have one ring; the map of another one may still be
/// connected.
bool has_one_ring(const SpaceComplex& complex, VertexId v);

// Volumes.
//
// Main flow of find_volumes():
//  1. ShellNodes           unites the sides of facets around every edge and in every face of every
//                          sphere map: each class is a shell, the boundary of one volume on one
//                          connected piece
//  2. find_pieces          finds the least vertex and the box of each piece; what the least vertex
//                          sees towards -x is the outer shell of the piece
//  3. nest_pieces          shoots from there towards -x to the next piece and the shell that faces
//                          the ray: both bound the same volume. If nothing is hit it is volume 0
//  4. numbered             numbers the volumes
//
// Cost: O(n alpha(n)), and a ray for each piece that may lie within another piece, as far as boxes
// tell. Proof:
// docs/design/boolean.md, Lemmas 6 and 7.

/// The volumes around cells, numbered by their least facet, then edge, then vertex; volume 0
/// reaches to infinity.
struct VolumeLabels {
  IdVector<FacetId, std::array<VolumeId, 2>>
      facet;                            ///< The volumes on its positive and negative side.
  IdVector<EdgeId, VolumeId> edge;      ///< The volume around each free edge; else invalid.
  IdVector<VertexId, VolumeId> vertex;  ///< The volume around each isolated vertex; else invalid.
  std::size_t count = 0;                ///< The number of volumes.
};

/// Returns the volumes of a complex. The volumes that are stored in the complex are not read.
/// `connected` has for each vertex a number that is not 0 if the sphere map is surely connected; it
/// is empty if nothing is known. Throws the errors of the Context.
VolumeLabels find_volumes(const SpaceComplex& complex, Context& context,
                          std::span<const std::uint8_t> connected = {});

/// Fills facet_volume, edge_volume, vertex_volume and volume_mark (all 0) with the volumes.
/// `connected` is as for find_volumes(). A mesh whose facets cross has its volumes found once for
/// each layer, because the Boolean of layers needs them, and once for the result (assemble.h).
void label_volumes(SpaceComplex& complex, Context& context,
                   std::span<const std::uint8_t> connected = {});

/// Returns the winding number of each volume: 0 in volume 0, rising by jump[f] from the negative to
/// the positive side of facet f. Facets link all volumes. If the jumps do not belong to a closed
/// surface, an invariant is broken (PLUMB_CHECK). O(facets). Proof: docs/design/meshes.md, Lemma 1.
IdVector<VolumeId, std::int32_t> winding_numbers(const SpaceComplex& complex,
                                                 std::span<const std::int32_t> jump);

}  // namespace plumb
