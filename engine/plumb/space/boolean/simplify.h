// Brings a complex into minimal form after its marks have changed. A cell is removed if it does not
// differ from the cells around it. CoplanarMerge works in the arrays, and handles the case in which
// no facet, free edge or isolated vertex is removed. simplified() handles every case, by sphere
// maps if necessary.
//
// CoplanarMerge unites facets of one plane over the edges between them, and edges over places
// inside them. Volumes do not change.
//
// Notation
//   flat edge   lies between two facets of one plane, all three with one mark: it is removed, and
//               the facets become one
//   fate        of a vertex: it is gone if nothing is left but one facet all around it, of its
//               mark; passed if two edges are left that are one, with the facets of both; else it
//               is kept, and may then lie inside a facet, with edges or without
//   chain       edges united over passed vertices; the first of them represents it, with its edge
//               uses
//
// Main flow of CoplanarMerge::run():
//  1. chains  follows each chain from its first edge to both ends; numbers vertices and edges anew
//  2. uses    keeps those of edges that represent a chain; finds the next one by walking on along
//             the facet, across flat edges around their ends
//  3. facets  makes classes over flat edges and traces their cycles anew; the outer cycle is found
//             by the corner at its least vertex. A facet has the least facet_origin of the pieces
//             that begin its corners, as by sphere maps
//  4. stars   lists the half-edges of vertices, and the vertices inside facets
//
// Cost: O(n alpha(n)), with signs for the cycles of facets that have several, and at vertices with
// two edges of facets in one plane. Proof: docs/design/meshes.md, Lemma 4.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "plumb/base/context.h"
#include "plumb/base/internal/union_find.h"
#include "plumb/space/space_complex.h"

namespace plumb {

/// Minimal form of a complex in which no facet, free edge or isolated vertex is removed.
class CoplanarMerge {
 public:
  /// Finds the edges and vertices that are removed. Keeps a reference to the complex; charges the
  /// context for memory while it lives. O(n).
  CoplanarMerge(const SpaceComplex& complex, Context& context);

  /// Whether any edge or vertex is removed.
  bool is_needed() const { return is_needed_; }
  /// Returns the complex without them, which is minimal if no facet, free edge or isolated vertex
  /// is superfluous. Requires is_needed().
  SpaceComplex run(Context& context);

  /// After run(), returns the new numbers of facets. Facets that were united have the same number.
  /// They ascend where each comes first.
  std::span<const FacetId> facet_numbers() const { return facet_number_; }
  /// After run(), returns the new numbers of vertices. The number of a removed vertex is invalid.
  std::span<const VertexId> vertex_numbers() const { return vertex_number_; }

 private:
  enum class Fate : std::uint8_t { Kept, Passed, Gone };

  void find_flat_edges();
  bool is_flat_edge(EdgeId e) const;
  Fate fate_of(VertexId v);
  std::size_t cross_from_left(VertexId v);
  FacetId facet_around(VertexId v) const;
  bool is_passed(VertexId v, HalfedgeId h, HalfedgeId other) const;
  HalfedgeId other_left(VertexId v, HalfedgeId h) const;
  UseId next_left(UseId u) const;
  UseId prev_left(UseId u) const;
  UseId prev_around(UseId flat) const;

  void number_vertices();
  void make_edges();
  VertexId end_of_chain(HalfedgeId h, EdgeId number);
  void make_uses();
  void make_facets();
  void name_facets();
  void gather_inner();

  bool is_flat(EdgeId e) const { return !is_flat_.empty() && is_flat_[e] != 0; }
  bool is_flat(HalfedgeId h) const { return is_flat(SpaceComplex::edge_of(h)); }
  bool is_flat(UseId u) const { return is_flat(edge(u)); }
  EdgeId edge(UseId u) const { return SpaceComplex::edge_of(in_.use_halfedge[u]); }
  bool stands_for_chain(EdgeId e) const { return first_[number_[e]] == e; }

  MemoryCharge memory_;
  const SpaceComplex& in_;
  SpaceComplex out_;
  bool is_needed_ = false;
  IdVector<EdgeId, std::uint8_t> is_flat_;  // One entry for each edge; empty if none is flat.
  // Whether a corner between edges that are left holds each half-edge.
  IdVector<HalfedgeId, std::uint8_t> is_crossed_;
  IdVector<VertexId, Fate> fate_;  // One entry for each vertex.
  // Vertices that now lie inside a facet, each with one of the facet's parts.
  std::vector<std::pair<VertexId, FacetId>> inside_;

  IdVector<VertexId, VertexId> vertex_number_;
  IdVector<EdgeId, EdgeId> number_;  // The chain of each edge that is not flat.
  IdVector<EdgeId, EdgeId> first_;   // The first edge of each chain.
  IdVector<UseId, UseId> use_number_;
  std::optional<UnionFind> classes_;  // Classes of facets over flat edges.
  IdVector<FacetId, FacetId> facet_number_;
};

// Minimal form of any complex.
//
// Main flow of simplified():
//  1. look      passes over facets, edges and vertices to see which kinds of cells are removed
//  2. merge     runs CoplanarMerge if these are at most edges between facets of one plane and
//               places inside edges
//  3. carry     else simplifies the map of every vertex and puts it into a draft (vertex_labels.h)
//  4. assemble  makes a complex of the draft (assemble.h)

/// Returns the same set in minimal form. A minimal complex is returned unchanged. O(n), besides the
/// assembly.
SpaceComplex simplified(SpaceComplex complex, Context& context);

/// Returns the same, but takes only steps 3 and 4, whichever cells are removed. Takes several times
/// as long where step 2 would do.
SpaceComplex simplified_by_maps(const SpaceComplex& complex, Context& context);

}  // namespace plumb
