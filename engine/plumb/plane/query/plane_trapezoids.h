// The faces of a complex cut into trapezoids, for walking along rays.
//
// Notation: "left of" means lexicographically less, as everywhere in the sweep: the plane is
// sheared a little, so no two vertices have one abscissa and no edge is vertical. A trapezoid lies
// between two edges, its bottom and top, and between the walls of two vertices, left and right; a
// wall goes up and down from its vertex to the next edges. Whatever is invalid is at infinity. Ends
// at infinity of vertical edges (vertices of the frame) have walls, too: at the bottom (below all
// of its x) one that only goes up, at the top one that only goes down.
//
// Main flow of the constructor: the complex numbers everything as a sweep meets it, so the sweep is
// run again without arithmetic:
//  1. open_left        trapezoids between the edges from the left infinity
//  2. next_wall        vertices, merged with vertical ends at infinity
//  3. add_wall         trapezoids left of the vertex end, those right of it begin; a vertex without
//                      edges to the left asks the locator what is below
//  4. list_along       per edge the trapezoids above and below it, left to right
//
// Cost: as many trapezoids as edges and vertices, 32 bytes each; O(n) time, and a question to the
// locator for each vertex without edges to its left; O(n log^2 n) at worst.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "plumb/plane/plane_complex.h"
#include "plumb/plane/query/plane_locator.h"

namespace plumb {

using TrapezoidId = StrongId<struct TrapezoidTag>;

struct PlaneTrapezoid {
  EdgeId bottom;
  EdgeId top;
  VertexId left;
  VertexId right;
  // Beyond the parts of the walls below and above the vertex; invalid: there is no such part.
  TrapezoidId left_lower, left_upper;
  TrapezoidId right_lower, right_upper;
};

class PlaneTrapezoids {
 public:
  PlaneTrapezoids(const PlaneComplex& complex, const PlaneLocator& locator);

  const PlaneTrapezoid& operator[](TrapezoidId t) const { return trapezoids_[t.value()]; }

  /// Left to right; `bottom` (`top`) invalid: those that reach down (up) to infinity.
  std::span<const TrapezoidId> above(EdgeId bottom) const { return above_.of(bottom); }
  std::span<const TrapezoidId> below(EdgeId top) const { return below_.of(top); }

  /// Edges whose left (right) end the vertex is, bottom to top.
  std::span<const EdgeId> outgoing(VertexId v) const { return outgoing_.of(v); }
  std::span<const EdgeId> incoming(VertexId v) const { return incoming_.of(v); }
  /// The one right (left) of v, above so many of its outgoing (incoming) edges.
  TrapezoidId right_of(VertexId v, std::size_t edges_below) const;
  TrapezoidId left_of(VertexId v, std::size_t edges_below) const;

  /// The vertical edge that ends in a vertex of the frame.
  EdgeId vertical_edge(VertexId at_infinity) const;
  /// Is it the end at the bottom?
  bool is_low(VertexId at_infinity) const;

 private:
  /// Lists by id, one after the other; the last is that of the invalid id.
  template <class Key, class Item>
  struct Lists {
    std::vector<std::uint32_t> begin;
    std::vector<Item> items;
    std::span<const Item> of(Key k) const {
      const std::size_t i = k.is_valid() ? k.value() : begin.size() - 2;
      return {items.data() + begin[i], items.data() + begin[i + 1]};
    }
  };
  class Builder;

  const PlaneComplex& complex_;
  std::vector<PlaneTrapezoid> trapezoids_;
  Lists<EdgeId, TrapezoidId> above_;
  Lists<EdgeId, TrapezoidId> below_;
  Lists<VertexId, EdgeId> outgoing_;
  Lists<VertexId, EdgeId> incoming_;
  std::vector<TrapezoidId> first_right_;  // per vertex: the lowest one right of it
  std::vector<TrapezoidId> first_left_;   // per vertex: the lowest one left of it
};

}  // namespace plumb
