// Point location in a complex of the plane.
//
// Notation: columns are the different abscissae of vertices and vertical edges; slab i lies left of
// column i (slab 0 left of all, the last one right of all). The slabs are the leaves of a segment
// tree. If an edge spans all slabs of a node, but not all slabs of the parent of the node, it is in
// the list of the node. As edges do not cross, each list has a vertical order.
//
// Main flow of locate():
//  1. find_column       finds the column of the point or the slab around it, by binary search; on a
//                       column, its vertices and vertical edges are tested
//  2. highest_below     goes down the tree to the slab, for a column the one right of it; a binary
//                       search in each list finds the highest edge at or below the point
//  3. returns the face above that edge; if there is none, face 0 or the face right of the last
//     vertical edge that comes from below
//
// Cost: O(n log n) memory, O(n log^2 n) time to build; O(log^2 n) for a query.
#pragma once

#include <cstdint>
#include <vector>

#include "plumb/plane/plane_complex.h"
#include "plumb/predicates/plane/query2.h"

namespace plumb {

/// Finds the cells of a complex in which points lie. Const members may be called from several
/// threads at once.
class PlaneLocator {
 public:
  /// Builds the tree. Keeps a reference to the complex.
  explicit PlaneLocator(const PlaneComplex& complex);

  // The cell in which a point lies.
  PlaneLocation locate(const RationalPoint2& p) const { return locate(QueryPoint2(p)); }
  PlaneLocation locate(Point2 p) const { return locate(QueryPoint2(p)); }
  PlaneLocation locate(const QueryPoint2& q) const;

  /// Returns the next edge below a point that lies in a face, just to the right of the point.
  /// Returns an invalid id if there is none.
  EdgeId edge_below(const QueryPoint2& q) const;
  /// Returns the same for a vertex without edges to its left.
  EdgeId edge_below(VertexId v) const;

 private:
  struct Column {
    std::uint32_t point;         ///< Any point of this abscissa (dense index).
    std::uint32_t vertex_begin;  ///< Its first vertex; the last is before the next column's first.
    EdgeId line;                 ///< A vertical edge without vertices, if there is one.
  };
  struct ColumnPlace {
    std::size_t column;  ///< The first column that is not left of the point.
    bool is_on;          ///< Whether the point is on it.
  };

  void make_columns();
  std::size_t column_of(VertexId v) const { return column_of_vertex_[v]; }
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
  IdVector<VertexId, std::uint32_t> column_of_vertex_;
  std::vector<std::uint32_t> column_of_line_;  // The column of vertical edges without vertices.
  std::vector<std::vector<EdgeId>> lists_;     // The list of each node, bottom to top.
  struct Down {
    std::size_t column;
    FaceId right;
  };
  std::vector<Down> downs_;  // Vertical edges that come from below, by column.
};

}  // namespace plumb
