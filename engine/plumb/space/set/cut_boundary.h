// Divides the boundary of a set into pieces that lie in one source triangle each. Internal.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "plumb/base/context.h"
#include "plumb/space/mesh_with_attributes.h"
#include "plumb/space/set/source_triangles.h"
#include "plumb/space/space_complex.h"

namespace plumb {

/// A part of a facet with one source.
struct BoundaryPiece {
  FacetId facet;           ///< The facet of the set.
  std::uint32_t triangle;  ///< The triangle in SourceTriangles, or kNone.
  bool is_flipped;         ///< Whether triangle and boundary have opposite sides.
  bool is_joined;          ///< Whether parts in other triangles were joined with it.
};

/// The boundary of the closure of the interior, in triangles.
struct CutBoundary {
  std::vector<BoundaryPiece> pieces;
  std::vector<std::array<VertexId, 3>> triangles;  ///< Counter-clockwise seen from outside.
  std::vector<std::uint32_t> piece;                ///< For each triangle, its piece.
};

/// Divides the boundary. Appends the vertices at which it is cut to complex.vertex_point, and their
/// points to `tables`, which are the tables of the complex and of the sources. Triangles meet only
/// in common vertices and edges. Requires that no marked volume is unbounded. Throws what the
/// context throws.
CutBoundary cut_boundary(SpaceComplex& complex, SpaceTables& tables, const SourceTriangles& sources,
                         PieceJoin join, Context& context);

}  // namespace plumb
