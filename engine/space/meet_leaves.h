// What the box trees of meet() are made of. Every vertex and edge of a complex belongs to one leaf, so that
// it is tested against an item of the other complex once and not from every facet around it.
//
//   facet         its surface, with those of its vertices and edges that no leaf before has
//   large facet   one leaf for the surface, further ones for its corners, eight at a time
//   free edge     with those of its ends that no leaf before has
//   vertex        isolated or inside a facet
//
// Cost: O(complex). Memory: about 100 bytes a triangle within reach.
#pragma once

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
  FacetId facet;  ///< the surface; invalid: none
  std::uint32_t vertex_begin;
  std::uint32_t edge_begin;
  std::uint8_t
      own;       ///< so many of the vertices belong to the leaf; the others are ends of its edges
  bool is_bare;  ///< its vertices and edges have no facet around them
  bool has_flat_edges;
};

class MeetLeaves {
 public:
  static constexpr std::size_t kMostCorners = 8;
  static constexpr std::size_t kMostVertices = 3 * kMostCorners;

  /// Of what the box `reach` meets. Keeps a reference to the complex.
  MeetLeaves(const SpaceComplex& complex, const Box3& reach);

  const SpaceComplex& complex() const { return complex_; }
  std::span<const Box3> boxes() const { return boxes_; }
  /// Of more than FacetSites::kFewCorners corners; ascending.
  std::span<const FacetId> large_facets() const { return large_facets_; }
  const MeetLeaf& operator[](std::size_t i) const { return leaves_[i]; }
  /// The vertices that belong to the leaf, then the other ends of its edges.
  std::span<const VertexId> vertices(std::size_t i) const {
    return std::span(vertices_).subspan(leaves_[i].vertex_begin,
                                        leaves_[i + 1].vertex_begin - leaves_[i].vertex_begin);
  }
  std::span<const VertexId> own_vertices(std::size_t i) const {
    return std::span(vertices_).subspan(leaves_[i].vertex_begin, leaves_[i].own);
  }
  std::span<const LeafEdge> edges(std::size_t i) const {
    return std::span(edges_).subspan(leaves_[i].edge_begin,
                                     leaves_[i + 1].edge_begin - leaves_[i].edge_begin);
  }

 private:
  void add_facet(FacetId f);
  void add_corners_of_large_facet();
  void add_free_edge(EdgeId e);
  void add_vertex(VertexId v);

  void open(FacetId facet, bool is_bare);
  void close(const Box3& box);
  void take_vertex(VertexId v);
  void take_edge(EdgeId e, bool is_flat);
  std::uint8_t place_of(VertexId v);
  void take_corners(std::span<const UseId> uses);
  bool is_flat(UseId u) const;
  bool is_in_reach(const Box3& box) const { return box.meets(reach_); }

  const SpaceComplex& complex_;
  Box3 reach_;
  std::vector<bool> is_taken_;    // per vertex
  std::vector<UseId> uses_;       // of the facet at hand
  std::vector<MeetLeaf> leaves_;  // one more than there are
  std::vector<Box3> boxes_;
  std::vector<VertexId> vertices_;
  std::vector<LeafEdge> edges_;
  std::vector<FacetId> large_facets_;
};

}  // namespace plumb
