// The faces of a mesh as simple polygons in planes, ready to be linked.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "plumb/base/context.h"
#include "plumb/space/from_mesh.h"
#include "plumb/space/mesh/mesh_vertices.h"

namespace plumb {

struct MeshFacets {
  // per facet
  std::vector<std::uint32_t> begin = {0};  ///< size() + 1 entries into corner
  std::vector<PlaneId> plane;
  std::vector<std::int32_t> jump;     ///< MeshComplex::jump
  std::vector<std::uint32_t> origin;  ///< input face; ascending
  /// Vertices, counter-clockwise seen from the positive side of the plane, the least one first.
  std::vector<std::uint32_t> corner;
  /// Directed edges of what has no area: they take part in the balance of the mesh.
  std::vector<std::array<std::uint32_t, 2>> loose;

  std::size_t size() const { return plane.size(); }
  std::span<const std::uint32_t> corners(std::size_t f) const {
    return std::span(corner).subspan(begin[f], begin[f + 1] - begin[f]);
  }
};

/// Main flow: corners -> a plane by three of them -> are all others on it? simple? -> else
/// triangles. Notes in `report` what it changes. O(n log n).
MeshFacets flatten_mesh(const MeshView& mesh, const MeshVertices& vertices, SpaceTables& tables,
                        MeshReport& report, Context& context);

/// The plane of three points, positive where they are seen counter-clockwise; not valid: on a line.
OrientedPlane plane_through(SpaceTables& tables, SpacePoint a, SpacePoint b, SpacePoint c);

}  // namespace plumb
