// Facets of one plane joined over the edges between them, and edges over places inside them: what
// the minimal form of a complex asks for where no facet, free edge or lone vertex goes. Without
// sphere maps: volumes stay what they are.
//
// Notation
//   an edge is flat    between two facets of one plane, all three of one mark: it goes, and the
//                      facets are one
//   fate of a vertex   gone: nothing is left but one facet all around it, of its mark. Passed: two
//                      edges are left that are one, with the facets of both. Else it is kept; it
//                      may lie inside a facet now, with edges or without
//   chain              edges joined over passed vertices; the first of them stands for it, with its
//                      uses
//
// Main flow of run():
//  1. chains     followed from the first edge of each to both ends; vertices and edges numbered
//                anew
//  2. uses       those of edges that stand for a chain; the next one is found by walking on along
//                the facet, across flat edges around their ends
//  3. facets     classes over flat edges; their cycles traced anew, the outer one by the corner at
//                its least vertex. A facet has the least id of the pieces that begin its corners,
//                as it has by sphere maps
//  4. stars      and what lies inside facets
//
// Cost: O(n alpha), with signs for the cycles of facets that have several, and at vertices with two
// edges of facets in one plane. Source: SPACE.md 3.
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

class CoplanarMerge {
 public:
  /// Looks which edges and vertices go. Keeps a reference to the complex; charges the context for
  /// memory while it lives.
  CoplanarMerge(const SpaceComplex& complex, Context& context);

  /// Does any?
  bool is_needed() const { return is_needed_; }
  /// The complex without them: minimal, if no facet, free edge or lone vertex goes. Requires
  /// is_needed().
  SpaceComplex run(Context& context);

  /// After run(), the new numbers of facets, the same of those that were joined, and of vertices,
  /// not valid of those that went. They ascend where they come first.
  std::span<const FacetId> facet_numbers() const { return facet_number_; }
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
  void make_stars();
  void gather_inner();

  bool is_flat(EdgeId e) const { return !is_flat_.empty() && is_flat_[e.value()] != 0; }
  bool is_flat(HalfedgeId h) const { return is_flat(SpaceComplex::edge_of(h)); }
  bool is_flat(UseId u) const { return is_flat(edge(u)); }
  EdgeId edge(UseId u) const { return SpaceComplex::edge_of(in_.use_halfedge[u.value()]); }
  bool stands_for_chain(EdgeId e) const { return first_[number_[e.value()].value()] == e; }

  MemoryCharge memory_;
  const SpaceComplex& in_;
  SpaceComplex out_;
  bool is_needed_ = false;
  std::vector<std::uint8_t> is_flat_;  // per edge
  std::vector<std::uint8_t>
      is_crossed_;          // per half-edge: does a corner between edges that are left hold it?
  std::vector<Fate> fate_;  // per vertex
  std::vector<std::pair<VertexId, FacetId>>
      inside_;  // vertices that now lie inside a facet, and one of its parts

  std::vector<VertexId> vertex_number_;
  std::vector<EdgeId> number_;  // per edge that is not flat: of its chain
  std::vector<EdgeId> first_;   // per chain
  std::vector<UseId> use_number_;
  std::optional<UnionFind> classes_;  // of facets
  std::vector<FacetId> facet_number_;
};

// Bringing a complex into minimal form after marks were changed: items that do not differ from what
// is around them go.
//
// Main flow of simplified():
//  1. look      flat passes over facets, edges and vertices: what goes?
//  2. merge     at most edges between facets of one plane, and places inside edges: joined as they
//               lie in the arrays (simplify.h)
//  3. carry     else the map of every vertex is simplified and put into a draft (vertex_labels.h)
//  4. join      (assemble.h)

/// The same set in minimal form. O(n); a minimal complex is given back as it is.
SpaceComplex simplified(SpaceComplex complex, Context& context);

/// The same by steps 3 and 4 alone, whatever goes; several times as long where step 2 would do.
SpaceComplex simplified_by_maps(const SpaceComplex& complex, Context& context);

}  // namespace plumb
