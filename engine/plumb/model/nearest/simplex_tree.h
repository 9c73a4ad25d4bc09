// Many simplices of space in a tree of boxes, and a search for the nearest points of two trees.
//
// Main flow of nearest_points(a, b):
//  1. candidates  descends into both trees, nearer pairs of nodes first. A pair of nodes is left
//                 out if the distance of their boxes is greater than the least upper bound so far.
//                 A pair of leaves is also left out if their distance in the direction of the
//                 shortest segment so far is greater than this bound. (Curved surfaces have many
//                 boxes that are nearly as near as the nearest ones; in this direction, they are
//                 well apart.) A pair of simplices is a candidate if its lower bound
//                 (simplex_pair.h) is not greater
//  2. decide      computes the exact nearest points of the candidates in the order of their lower
//                 bounds, until the next lower bound is greater than the exact distance
//
// Cost: building takes O(n log n). A search usually takes O(log n), and the exact part takes about
// 10 us for each pair that doubles cannot tell from the nearest pair. If a magnitude is not
// between 2^-400 and 2^500, doubles tell nothing, and all pairs are candidates.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "plumb/base/context.h"
#include "plumb/base/internal/box_tree.h"
#include "plumb/model/nearest/simplex_pair.h"

namespace plumb {

/// Simplices whose corners are shared vertices. Immutable after build(). Several threads may search
/// at the same time.
class SimplexTree {
 public:
  /// The vertices of the simplex. Missing vertices are kNone.
  using Corners = std::array<std::uint32_t, 3>;
  static constexpr std::uint32_t kNone = 0xffffffff;

  std::vector<std::array<double, 3>> vertex;  ///< Doubles near each vertex.
  /// At least the difference of any double and the exact coordinate.
  double error = 0;
  std::vector<Corners> simplex;  ///< The simplices.
  /// Returns the exact coordinates of a vertex.
  std::function<RationalPoint3(std::uint32_t)> exact_vertex;

  /// Builds the tree. Requires at least one simplex, and that the tree was not built before.
  void build(Context& context);
  /// Returns a box around all simplices.
  Box3 bounds() const { return widened(nodes_[0].box); }
  /// Returns a box of doubles near vertices, widened such that it contains the exact vertices.
  Box3 widened(Box3 box) const;

  /// The nearest pair of simplices, and their nearest points.
  struct Nearest {
    std::uint32_t a = 0;   ///< A simplex of the first tree.
    std::uint32_t b = 0;   ///< A simplex of the second tree.
    NearestPoints points;  ///< Their nearest points.
  };
  /// Returns nearest points of two trees that were built. Throws the errors of the Context.
  static Nearest nearest(const SimplexTree& a, const SimplexTree& b, Context& context);

 private:
  friend class NearestSearch;
  static constexpr std::uint32_t kLeaf = 4;
  /// A node with the simplices order_[begin], ..., order_[end - 1].
  struct Node {
    Box3 box;
    std::uint32_t begin;
    std::uint32_t end;
    std::uint32_t second;  ///< The second node below it, 0 for a leaf. The first one comes next.
  };

  /// A simplex by its first corner.
  struct Placed {
    std::array<double, 3> at;
    std::uint32_t simplex;
  };

  std::uint32_t add_node(std::vector<Placed>& placed, std::uint32_t begin, std::uint32_t end,
                         Context& context);
  RoundedSimplex rounded(std::uint32_t s) const;
  ExactSimplex exact(std::uint32_t s) const;

  std::vector<std::uint32_t> order_;     // The simplices, neighbours together.
  std::vector<RoundedSimplex> rounded_;  // In that order.
  std::vector<Node> nodes_;
  double magnitude_ = 0;  // The greatest absolute value of a coordinate.
};

}  // namespace plumb
