// Removes vertices of a mesh at which its triangles are nearly in one plane or in two planes.
#pragma once

#include <cstdint>
#include <span>

#include "plumb/base/context.h"
#include "plumb/space/mesh/changed_mesh.h"

namespace plumb {

/// A mesh without flat vertices.
struct FlattenedMesh {
  ChangedMesh changes;
  std::uint32_t removed = 0;  ///< The number of vertices that were removed.
};

/// Removes vertices at which the surface is flat or folded along a straight line, up to `width`.
///
/// A vertex v is *flat* if all triangles around it are at most `width` away from one plane. It is
/// *on a fold* if it is at most `width` away from the segment between two of its neighbours, and
/// the triangles on each side of this segment are at most `width` away from one plane. If such a
/// vertex is removed, the segment becomes an edge, and each side is triangulated again.
///
/// A vertex v stays in any of these cases: is_removable is 0 for v; a face of v is not a triangle;
/// v has more than 32 triangles; its triangles do not form one closed fan; a triangle without v
/// would be flipped or thinner than twice the width; an edge would get more than two faces. It also
/// stays if the sum of the distances over vertices that were removed one after the other near the
/// same place exceeds 16 times the width.
///
/// Whether things are near each other is decided in doubles. This is allowed, because no decision
/// makes an edge that lacks a face, and largest_move includes the effect of each decision. A
/// triangle that was made from several faces has the least of them as its origin.
///
/// `is_near` has an entry for each face. It is 1 for each face with a removable vertex, and may be
/// 1 for other faces. O(1) for each face with is_near = 1 and for each removed vertex whose
/// neighbours have few faces. In addition, O(corners) if a vertex is flat or on a fold.
FlattenedMesh drop_flat_vertices(const PolygonMesh& mesh,
                                 std::span<const std::uint8_t> is_removable,
                                 std::span<const std::uint8_t> is_near, double width,
                                 Context& context);

}  // namespace plumb
