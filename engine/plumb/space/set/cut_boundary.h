// Divides the boundary of a set into pieces that lie in one source triangle each. Internal.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "plumb/base/context.h"
#include "plumb/space/mesh_with_attributes.h"
#include "plumb/space/set/growing_complex.h"
#include "plumb/space/set/source_triangles.h"
#include "plumb/space/space_complex.h"

namespace plumb {

/// The relation of a piece to its source triangle.
enum class PieceCover : std::uint8_t {
  Triangle,  ///< The piece lies in the triangle.
  Face,      ///< The piece is the face of the source that has the triangle.
  /// The piece lies in several triangles over which the attributes are the same functions.
  Joined,
};

/// A part of a facet with one source.
struct BoundaryPiece {
  FacetId facet;           ///< The facet of the set.
  std::uint32_t triangle;  ///< The triangle in SourceTriangles, or kNone.
  bool is_flipped;         ///< Whether the piece and the triangle have opposite orientations.
  PieceCover cover;        ///< The relation of the piece and the triangle.
};

/// The boundary of the closure of the interior, in faces.
struct CutBoundary {
  std::vector<BoundaryPiece> pieces;
  std::vector<std::uint32_t> face_begin = {0};  ///< Where each face starts in `corners`; the end.
  std::vector<VertexId> corners;                ///< Counter-clockwise seen from outside.
  std::vector<std::uint32_t> piece;             ///< For each face, its piece.

  /// Returns the vertices of a face.
  std::span<const VertexId> face(std::size_t f) const {
    return std::span(corners).subspan(face_begin[f], face_begin[f + 1] - face_begin[f]);
  }
};

/// Divides the boundary. Adds the vertices at which it is cut to `complex`, and their points to its
/// tables, which are those of the sources, too. Faces meet only in common vertices and edges.
/// Requires that no marked volume is unbounded. Throws the errors of the Context.
CutBoundary cut_boundary(GrowingComplex& complex, SourceTriangles& sources,
                         const AttributeOptions& options, Context& context);

}  // namespace plumb
