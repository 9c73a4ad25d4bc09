// Labelled edges: a subdivision of the plane as a list of edges, each with the two faces beside it.
//
// Rounding works on such lists. A face of the exact subdivision is a label. The edges with label L
// on their left, minus the edges with label L on their right, form closed curves. These curves stay
// closed while vertices move and edges are bent, because an edge always leads from the place of one
// end to the place of the other end. So every point off the edges has a winding number of each
// label, and the sum of these numbers is 1 (docs/design/rounding.md, Labels).
//
// Main flow, once for each arrangement:
//  1. arrange_edges   arranges the edges exactly; every meeting becomes a vertex
//  2. pieces_of       adds up the labels of edges that fall together, and lists the pieces
//  3. placed          gives each vertex of the arrangement its new place
//     or face_labels  gives each face of the arrangement its label, if no vertex has to move
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "plumb/base/context.h"
#include "plumb/base/ids.h"
#include "plumb/plane/arrangement.h"
#include "plumb/plane/plane_complex.h"
#include "plumb/predicates/point.h"

namespace plumb {

/// An edge with its labels. The ends are vertices of a complex, or points of LabelledEdges.
struct LabelledEdge {
  std::uint32_t from;    ///< The lexicographically lesser end.
  std::uint32_t to;      ///< The other end.
  std::uint32_t above;   ///< The label to the left of the way from `from` to `to`.
  std::uint32_t below;   ///< The label to the right.
  std::uint32_t source;  ///< An edge of the exact subdivision of which this edge is a part.
  bool is_line;          ///< Whether the edge is kept even if both labels are equal.
  double drift;          ///< Bound for the distance of its points from this part (maximum norm).
};

/// Edges between doubles. Several edges may have the same ends.
struct LabelledEdges {
  std::vector<Point2> points;       ///< The points; different points may be equal.
  std::vector<LabelledEdge> edges;  ///< The edges; their ends are not equal.
  /// Points that belong to the set in any case, whatever cells are around them.
  std::vector<Point2> lone;
  double drift = 0;  ///< The greatest drift of an edge that was ever appended.
};

/// The counts of changes to edges of the exact subdivision.
struct EdgeTrace {
  std::vector<std::uint8_t> is_bent;  ///< For each exact edge, whether it has new corners.
  std::size_t folded = 0;             ///< Pieces that are left out between equal faces.
};

/// The edges of a complex. `edges` are sorted by edges of the complex.
struct EdgePieces {
  std::vector<LabelledEdge> edges;   ///< Their ends are vertices of the complex.
  std::vector<std::uint32_t> begin;  ///< For each edge of the complex, its first entry of `edges`.

  /// Returns the entries of edge e. There may be none.
  std::span<const LabelledEdge> of(EdgeId e) const {
    return {edges.data() + begin[e.value()], edges.data() + begin[e.value() + 1]};
  }
};

/// The place of a vertex after rounding.
struct VertexPlace {
  Point2 at;            ///< The place.
  double move = 0;      ///< Bound for the distance from the vertex (maximum norm).
  bool is_new = false;  ///< Whether the vertex may have moved.
};

/// Returns the bounded edges of the exact subdivision. All unbounded faces have label 0. An edge
/// with the same label on both sides is left out unless it is a line: a marked edge between faces
/// that are not marked.
EdgePieces pieces_of(const PlaneComplex& exact);

/// Returns the arrangement of the edges. Curve i of the arrangement is edge i.
Arrangement arrange_edges(const LabelledEdges& scene, Context& context);

/// Returns the pieces of the edges of a scene. `arrangement` is arrange_edges(scene). Pieces that
/// coincide become one piece with the sum of their labels. If the sum is zero and none of the
/// pieces is a line, they vanish. If the sum is not the jump of one edge, they become several
/// pieces with the same ends.
EdgePieces pieces_of(const LabelledEdges& scene, const Arrangement& arrangement, EdgeTrace& trace);

/// Returns an upper bound for the sum of two distances.
double sum_above(double a, double b);

/// Appends an edge to a scene in which `from` and `to` are points. If the points are equal, the
/// edge is left out, and a line becomes a lone point.
void append_edge(LabelledEdges& scene, LabelledEdge edge);

/// Returns the scene in which vertex v of the pieces is at places[v].
LabelledEdges placed(const EdgePieces& pieces, std::span<const VertexPlace> places,
                     std::vector<Point2> lone);

/// The labels of the faces of a complex.
struct FaceLabels {
  IdVector<FaceId, std::uint32_t> label;  ///< The label of each face.
  bool is_clear = true;  ///< Whether each face is wound round once by its label, and by no other.
};

/// Returns the label of each face of a complex: the label with the greatest winding number, and
/// the greatest of these labels if there are several. Requires that face 0 has label 0. O(n) if
/// all faces are clear.
FaceLabels face_labels(const PlaneComplex& complex, const EdgePieces& pieces);

}  // namespace plumb
