// Point location in a complex.
//
// Notation: columns are the different abscissae of vertices and vertical edges; slab i lies left of
// column i (slab 0 left of all, the last one right of all). The slabs are the leaves of a segment
// tree; an edge that spans the slabs of a node (and not those of its parent) is in the node's list,
// and the list is in vertical order: edges do not cross.
//
// Main flow of locate():
//  1. find_column       binary search; on a column, its vertices and vertical edges are looked at
//  2. highest_below     down the tree to the slab (the one right of the column); in each list a
//                       binary search; the highest edge at or below the point wins
//  3. the face above that edge; without one, face 0 or the face right of the last vertical edge
//     that comes from below
//
// Cost: O(n log n) memory, O(n log^2 n) time to build; O(log^2 n) for a query.
#pragma once

#include <cstdint>
#include <vector>

#include "plumb/plane/plane_complex.h"
#include "plumb/predicates/plane/query2.h"

namespace plumb {

class PlaneLocator {
 public:
  /// Keeps a reference to the complex.
  explicit PlaneLocator(const PlaneComplex& complex);

  PlaneLocation locate(const RationalPoint2& p) const { return locate(QueryPoint2(p)); }
  PlaneLocation locate(Point2 p) const { return locate(QueryPoint2(p)); }
  PlaneLocation locate(const QueryPoint2& q) const;

  /// The edge next below a point that lies in a face, just right of it; invalid if there is none.
  EdgeId edge_below(const QueryPoint2& q) const;
  /// The same for a vertex without edges to its left.
  EdgeId edge_below(VertexId v) const;

 private:
  struct Column {
    std::uint32_t point;         ///< any point of this abscissa (dense index)
    std::uint32_t vertex_begin;  ///< its vertices are [vertex_begin, next column's)
    EdgeId line;                 ///< a vertical edge without vertices, if any
  };
  struct ColumnPlace {
    std::size_t column;  ///< the first one not left of the point
    bool is_on;
  };

  void make_columns();
  std::size_t column_of(VertexId v) const { return column_of_vertex_[v.value()]; }
  void fill_lists();
  void spread(EdgeId e, std::size_t node, std::size_t begin, std::size_t end, std::size_t from,
              std::size_t to);
  bool is_vertical(EdgeId e) const;
  bool is_below(EdgeId e, EdgeId f) const;

  ColumnPlace find_column(const QueryPoint2& q) const;
  bool locate_on_column(const Column& column, std::size_t vertex_end, const QueryPoint2& q,
                        PlaneLocation& found) const;
  template <class Below>
  EdgeId highest_below(std::size_t slab, const Below& is_below_point) const;
  FaceId bottom_face(std::size_t slab) const;
  Sign side(EdgeId e, const QueryPoint2& q) const;
  PlaneLocation at(VertexId v) const;
  PlaneLocation at(EdgeId e) const;
  PlaneLocation at(FaceId f) const;

  const PlaneComplex& complex_;
  PlanePointsView points_;
  std::vector<Column> columns_;
  std::vector<std::uint32_t> column_of_vertex_;
  std::vector<std::uint32_t> column_of_line_;  // per edge, for vertical edges without vertices
  std::vector<std::vector<EdgeId>> lists_;     // per node of the tree, bottom to top
  struct Down {
    std::size_t column;
    FaceId right;
  };
  std::vector<Down> downs_;  // vertical edges from below, by column
};

}  // namespace plumb
