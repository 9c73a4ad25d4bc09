// What the box trees of meet() are made of. Every vertex and edge of a complex belongs to one leaf, so that
// it is tested against an item of the other complex once and not from every facet around it.
//
//   facet         its surface, with those of its corners and edges that are its own
//   large facet   one leaf for the surface, further ones for its corners, eight at a time, where something is their
//                 own; so it is with holes
//   free edge     with those of its ends that are its own
//   vertex        isolated or inside a facet
//
// An edge belongs to the facet of edge_use, a vertex to that of its first edge with facets, else to its first edge.
// Few leaves ever meet another one: what is a leaf's own is looked up when it does (LeafItems).
//
// Cost: O(complex). Memory: about 60 bytes a facet within reach.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "plumb/base/box_tree.h"
#include "plumb/space/space_complex.h"

namespace plumb {

/// An edge of a leaf; its ends by their place among the leaf's vertices.
struct LeafEdge {
  EdgeId edge;
  std::uint8_t from;
  std::uint8_t to;
  bool is_flat;  ///< it has no two facets in different planes
};

struct MeetLeaf {
  FacetId facet;        ///< the surface; invalid: none
  SpaceItem bare;       ///< a free edge or a vertex without facets; else invalid
  UseId first;          ///< corners: of this use ...
  std::uint32_t count;  ///< ... and those that follow it, so many in all
};

/// The vertices and edges that belong to a leaf.
class LeafItems {
 public:
  static constexpr std::size_t kMostCorners = 8;
  static constexpr std::size_t kMostVertices = 3 * kMostCorners;

  void fill(const SpaceComplex& complex, const MeetLeaf& leaf);

  /// Those that belong to the leaf, then the other ends of its edges.
  std::span<const VertexId> vertices() const { return std::span(vertices_).first(vertex_count_); }
  std::span<const VertexId> own_vertices() const { return std::span(vertices_).first(own_); }
  std::span<const LeafEdge> edges() const { return std::span(edges_).first(edge_count_); }
  bool has_flat_edges() const { return has_flat_edges_; }

 private:
  void take_bare(const SpaceComplex& complex, SpaceItem bare);
  void take_vertex(VertexId v);
  void take_edge(const SpaceComplex& complex, EdgeId e, bool is_flat);
  std::uint8_t place_of(VertexId v);

  std::array<VertexId, kMostVertices> vertices_;
  std::array<LeafEdge, kMostCorners> edges_;
  std::size_t own_ = 0;
  std::size_t vertex_count_ = 0;
  std::size_t edge_count_ = 0;
  bool has_flat_edges_ = false;
};

class MeetLeaves {
 public:
  /// Of what the box `reach` meets. Keeps a reference to the complex.
  MeetLeaves(const SpaceComplex& complex, const Box3& reach);

  const SpaceComplex& complex() const { return complex_; }
  std::span<const Box3> boxes() const { return boxes_; }
  /// Of more than FacetSites::kFewCorners corners; ascending.
  std::span<const FacetId> large_facets() const { return large_facets_; }
  const MeetLeaf& operator[](std::size_t i) const { return leaves_[i]; }

 private:
  void add_facet(FacetId f);
  std::uint32_t add_corners(UseId first);
  void add(const MeetLeaf& leaf, const Box3& box);

  const SpaceComplex& complex_;
  Box3 reach_;
  std::vector<MeetLeaf> leaves_;
  std::vector<Box3> boxes_;
  std::vector<FacetId> large_facets_;
};

/// The items of the leaves that were asked for last.
class LeafCache {
 public:
  explicit LeafCache(const MeetLeaves& leaves) : leaves_(leaves) { known_.fill(kNone); }

  /// Valid until the next call.
  const LeafItems& operator[](std::size_t leaf) {
    const std::size_t place = leaf % kPlaces;
    if (known_[place] != leaf) {
      known_[place] = leaf;
      items_[place].fill(leaves_.complex(), leaves_[leaf]);
    }
    return items_[place];
  }

 private:
  static constexpr std::size_t kPlaces = 64;
  static constexpr std::size_t kNone = ~std::size_t{0};

  const MeetLeaves& leaves_;
  std::array<std::size_t, kPlaces> known_;
  std::array<LeafItems, kPlaces> items_;
};

}  // namespace plumb
