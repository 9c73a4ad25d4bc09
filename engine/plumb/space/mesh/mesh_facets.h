// The faces of a mesh as simple polygons in planes, ready to be linked.
//
// A face whose corners lie in one plane and that is simple becomes one facet. Any other face
// becomes triangles with the same boundary chain, so that winding numbers do not change
// (docs/design/meshes.md, "Winding numbers").
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "plumb/base/context.h"
#include "plumb/space/from_mesh.h"
#include "plumb/space/mesh/mesh_vertices.h"

namespace plumb {

/// Facets of a mesh: polygons in planes, with the faces from which they come.
struct MeshFacets {
  // One entry for each facet.
  std::vector<std::uint32_t> begin = {0};  ///< Starts in `corner`, size() + 1 of them.
  std::vector<PlaneId> plane;              ///< Its plane.
  std::vector<std::int32_t> jump;          ///< What MeshComplex::jump says of it.
  std::vector<std::uint32_t> origin;       ///< The face from which it comes, ascending.
  /// Its vertices, counter-clockwise seen from the positive side of the plane, the least one first.
  std::vector<std::uint32_t> corner;
  /// Directed edges of faces without area. They take part in the balance of the mesh.
  std::vector<std::array<std::uint32_t, 2>> loose;

  /// Returns the number of facets.
  std::size_t size() const { return plane.size(); }
  /// Returns the vertices of a facet.
  std::span<const std::uint32_t> corners(std::size_t f) const {
    return std::span(corner).subspan(begin[f], begin[f + 1] - begin[f]);
  }
};

/// Returns the facets of a mesh and adds their planes to the tables. Reports the changes in
/// `report`. Throws the errors of the Context. O(n log n).
///
/// Main flow: trims repeated corners, finds a plane by three corners, tests whether all others lie
/// on it and the polygon is simple, else makes triangles.
MeshFacets flatten_mesh(const MeshView& mesh, const MeshVertices& vertices, SpaceTables& tables,
                        MeshReport& report, Context& context);

// Trimming of faces. The corners of a face are the end of a list, from index `first` on.

/// Appends a corner to a face, unless it repeats the last corner. If the two corners beside a
/// corner are equal, removes this corner, because the face would run forth and back along an edge.
void push_corner(std::vector<std::uint32_t>& corner, std::size_t first, std::uint32_t v);
/// Trims in the same way where the end of a face meets its beginning. Fewer than three corners may
/// be left. The edges of such a face cancel.
void trim_ends(std::vector<std::uint32_t>& corner, std::size_t first);

/// Returns the plane of three points, with the side positive from which they are seen
/// counter-clockwise; invalid if they lie on a line.
OrientedPlane plane_through(SpaceTables& tables, SpacePoint a, SpacePoint b, SpacePoint c);

}  // namespace plumb
