// Which sides of facets, free edges and vertices bound one volume without a gap: the classes that
// volumes and shells are made of.
//
// Nodes: side s of facet f is 2f + s (0: the positive one); the only face of the map of a vertex v
// without facets around it is 2F + v. Two nodes are joined where they meet at an edge or in one
// face of a sphere map.
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

class ShellNodes {
 public:
  /// Joins everything. Volumes are not looked at. O(n alpha(n)), and a sphere map for each vertex
  /// whose map is not connected. `connected` as for label_volumes().
  explicit ShellNodes(const SpaceComplex& complex, std::span<const std::uint8_t> connected = {});

  std::size_t size() const { return classes_.size(); }
  std::uint32_t root(std::uint32_t node) { return classes_.root(node); }
  void unite(std::uint32_t i, std::uint32_t j) { classes_.unite(i, j); }

  static std::uint32_t facet_node(FacetId f, bool is_negative_side) {
    return 2 * f.value() + (is_negative_side ? 1 : 0);
  }
  std::uint32_t vertex_node(VertexId v) const {
    return static_cast<std::uint32_t>(2 * complex_.facet_count()) + v.value();
  }
  /// The node around an edge without uses; kNone for others.
  std::uint32_t free_node(EdgeId e) const { return free_node_[e.value()]; }
  /// In radial order.
  std::uint32_t node_after(UseId u) const {
    const HalfedgeId h = complex_.use_halfedge[u.value()];
    return facet_node(complex_.use_facet[u.value()], SpaceComplex::is_reverse(h));
  }
  std::uint32_t node_before(UseId u) const { return node_after(u) ^ 1U; }

  /// A node for each face of the map of an item; a face without arcs has the item's own.
  void face_nodes(const LocalMap& local, SpaceItem item, std::vector<std::uint32_t>& node) const;

 private:
  void join_around_edges();
  std::vector<VertexId> irregular_vertices(std::span<const std::uint8_t> connected) const;
  void join_at_irregular_vertices(std::span<const std::uint8_t> connected);

  const SpaceComplex& complex_;
  UnionFind classes_;
  std::vector<std::uint32_t> free_node_;
};

// The volumes of a complex: connected parts of space between its facets.
//
// Main flow of find_volumes():
//  1. join the sides of facets around every edge and in every face of every sphere map: each class
//     is a shell, the boundary of one volume on one connected piece
//  2. the outer shell of a piece is the one that its lexicographically least vertex sees towards -x
//  3. a ray from there towards -x finds the next piece, and the shell that faces the ray: both
//     bound the same volume; no hit: volume 0
// Cost: O(n alpha(n)), and a ray for each piece if there are at least two. The ray of the least
// piece cannot meet another one, but nest_pieces() shoots it all the same.

/// The volumes around items, numbered by their least facet, then edge, then vertex; volume 0
/// reaches to infinity.
struct VolumeLabels {
  std::vector<std::array<VolumeId, 2>> facet;  ///< on the positive and on the negative side
  std::vector<VolumeId> edge;                  ///< of a free edge; else invalid
  std::vector<VolumeId> vertex;                ///< of a vertex alone in a volume; else invalid
  std::size_t count = 0;
};

/// Of a complex whose volumes, if any are named, are not looked at. `connected`, per vertex: not 0
/// where the sphere map surely hangs together; empty: nothing is known.
VolumeLabels find_volumes(const SpaceComplex& complex, Context& context,
                          std::span<const std::uint8_t> connected = {});

/// Fills facet_volume, edge_volume, vertex_volume and volume_mark (all 0) with them. `connected` as
/// above.
void label_volumes(SpaceComplex& complex, Context& context,
                   std::span<const std::uint8_t> connected = {});

/// Winding numbers of volumes: 0 in volume 0, rising by jump[f] from the negative to the positive
/// side of facet f. Facets link all volumes. Jumps that are not those of a closed surface stop the
/// program. O(facets).
std::vector<std::int32_t> winding_numbers(const SpaceComplex& complex,
                                          std::span<const std::int32_t> jump);

}  // namespace plumb
