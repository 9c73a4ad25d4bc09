// The steps of valid_mesh() after the mesh of a set has been made (valid_mesh.h). Internal.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "plumb/base/context.h"
#include "plumb/space/space_complex.h"
#include "plumb/space/to_mesh.h"
#include "plumb/space/valid_mesh.h"

namespace plumb {

/// A mesh of a complex before its coordinates are rounded and repaired.
struct MeshToRound {
  /// The mesh. `rounded` lists all constructed points. `facet` has any ids that the faces of the
  /// result are to keep.
  MeshOfComplex made;
  /// For each face, the marked volume that it bounds. Empty if `facet` has facets of `complex`,
  /// which tell this.
  std::vector<std::uint32_t> solid;
  const SpaceComplex* complex;      ///< Has the tables and the vertices of the points.
  std::vector<std::uint32_t> kept;  ///< Points that stay even if the boundary is flat there.
  /// Whether faces with different entries in `facet` stay apart, even if a repair puts them into
  /// one plane.
  bool has_pieces = false;
};

/// Returns the marked volume at each facet. Requires facets of the boundary of the closure of the
/// interior.
std::vector<std::uint32_t> solids_at(const SpaceComplex& complex, std::span<const FacetId> facets);

/// Rounds the points of a mesh, and repairs the damage. Otherwise as valid_mesh().
ValidMesh round_mesh(MeshToRound input, const ToMeshOptions& options, CoordinateType type,
                     Context& context);

}  // namespace plumb
