// The faces of a complex cut into trapezoids, for walking along rays.
//
// Notation: "left of" means lexicographically less, as everywhere in the sweep: the plane is
// sheared a little, so that no two vertices have one abscissa and no edge is vertical. A trapezoid
// lies between two edges, its bottom and top, and between the walls of two vertices, left and
// right; a wall goes up and down from its vertex to the next edges. An id that is not valid is at
// infinity. The ends at infinity of vertical edges (vertices of the frame) have walls, too. At the
// lower end, the wall only goes up. At the upper end, it only goes down.
//
// Main flow of the constructor. The complex numbers everything as a sweep meets it, so the sweep
// can be repeated without arithmetic:
//  1. open_left        begins the trapezoids between the edges from the left infinity
//  2. next_wall        goes through the vertices, merged with vertical ends at infinity
//  3. add_wall         ends the trapezoids left of the vertex and begins those right of it; for a
//                      vertex without edges to its left, the locator finds what is below
//  4. list_along       lists the trapezoids above and below each edge, left to right
//
// Cost: about as many trapezoids as edges and vertices, 32 bytes each; O(n) time, and one query of
// the locator for each vertex without edges to its left, so O(n log^2 n) in the worst case.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "plumb/plane/plane_complex.h"
#include "plumb/plane/query/plane_locator.h"

namespace plumb {

using TrapezoidId = StrongId<struct TrapezoidTag>;

/// A trapezoid of a face.
struct PlaneTrapezoid {
  EdgeId bottom;   ///< The edge below.
  EdgeId top;      ///< The edge above.
  VertexId left;   ///< The vertex whose wall is to the left.
  VertexId right;  ///< The vertex whose wall is to the right.
  // The trapezoids beyond the parts of the walls below and above the vertices; not valid where
  // there is no such part.
  TrapezoidId left_lower, left_upper;
  TrapezoidId right_lower, right_upper;
};

/// The trapezoids of a complex.
class PlaneTrapezoids {
 public:
  /// Cuts all faces. Keeps a reference to the complex.
  PlaneTrapezoids(const PlaneComplex& complex, const PlaneLocator& locator);

  const PlaneTrapezoid& operator[](TrapezoidId t) const { return trapezoids_[t]; }

  // The trapezoids above `bottom` and below `top`, left to right. If the edge is invalid, they are
  // the trapezoids that reach down, or up, to infinity.
  std::span<const TrapezoidId> above(EdgeId bottom) const { return above_.of(bottom); }
  std::span<const TrapezoidId> below(EdgeId top) const { return below_.of(top); }

  // The edges whose left (right) end a vertex is, bottom to top.
  std::span<const EdgeId> outgoing(VertexId v) const { return outgoing_.of(v); }
  std::span<const EdgeId> incoming(VertexId v) const { return incoming_.of(v); }
  // The trapezoid right (left) of v that is above so many of its outgoing (incoming) edges.
  TrapezoidId right_of(VertexId v, std::size_t edges_below) const;
  TrapezoidId left_of(VertexId v, std::size_t edges_below) const;

  /// Returns the edge that ends in a vertex of the frame.
  EdgeId vertical_edge(VertexId at_infinity) const;
  /// Whether a vertex of the frame is the lower end of its vertical edge.
  bool is_low(VertexId at_infinity) const;

 private:
  /// Lists by id, one after the other. The last entry belongs to the invalid id.
  template <class Key, class Item>
  struct Lists {
    IdVector<Key, std::uint32_t> begin;
    std::vector<Item> items;
    std::span<const Item> of(Key k) const {
      const std::size_t i = k.is_valid() ? k.value() : begin.size() - 2;
      return {items.data() + begin[i], items.data() + begin[i + 1]};
    }
  };
  class Builder;

  const PlaneComplex& complex_;
  IdVector<TrapezoidId, PlaneTrapezoid> trapezoids_;
  Lists<EdgeId, TrapezoidId> above_;
  Lists<EdgeId, TrapezoidId> below_;
  Lists<VertexId, EdgeId> outgoing_;
  Lists<VertexId, EdgeId> incoming_;
  IdVector<VertexId, TrapezoidId> first_right_;  // The lowest trapezoid right of each vertex.
  IdVector<VertexId, TrapezoidId> first_left_;   // The lowest trapezoid left of each vertex.
};

}  // namespace plumb
