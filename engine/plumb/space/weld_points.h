// Makes points of a mesh one that are close to each other.
//
// Points are taken in the order of their first index. A point becomes the nearest of the points
// kept so far if that is no farther than the tolerance; else it is kept itself. Points that are
// kept never move, and all others move to a point that is kept. So no point moves farther than the
// tolerance, however long a chain of close points is. The result depends on nothing but the mesh
// and the tolerance.
//
// Distances are compared exactly. Points that are kept lie in the cells of a grid, four times the
// tolerance wide; a cell holds a bounded number of them, since they are farther apart than the
// tolerance. Expected cost: O(n).
#pragma once

#include <cstdint>
#include <vector>

#include "plumb/base/context.h"
#include "plumb/space/mesh_arrays.h"

#pragma GCC visibility push(default)
namespace plumb {

/// What weld_points() did.
struct PointWeld {
  std::vector<std::uint32_t> kept;  ///< For each point the one that it became.
  std::uint64_t equal = 0;          ///< Used points that had the coordinates of an earlier one.
  std::uint64_t moved = 0;          ///< Places that moved to another place.
  double farthest = 0;              ///< How far they moved at most, rounded up.
};

/// Makes points with equal coordinates one, and points at most `tolerance` apart. Corners are
/// changed, points are not: those without a face stay. Throws Error{BadArgument} if the
/// tolerance is negative or not finite. Throws Error{BadIndex} and Error{NotFinite} in the same
/// cases as complex_of_mesh(). Also throws what the context throws.
PointWeld weld_points(PolygonMesh& mesh, double tolerance, Context& context = unlimited_context());

}  // namespace plumb
#pragma GCC visibility pop
