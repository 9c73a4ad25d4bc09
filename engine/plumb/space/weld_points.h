// Merges points of a mesh that are close to each other.
//
// The points are processed in the order of their indices. For each point, the function finds the
// nearest of the points that were kept so far. If its distance is at most the tolerance, the point
// is moved to it. Otherwise the point is kept. A point that is kept never moves. So no point moves
// farther than the tolerance, even if there is a long chain of points that are close to each other.
// The result depends only on the mesh and the tolerance.
//
// Distances are compared exactly. To find the nearest kept point, the function stores kept points
// in the cells of a grid. The width of a cell is four times the tolerance. The distance between two
// kept points is greater than the tolerance, so the number of kept points in a cell is bounded.
// Expected cost: O(n) for n points.
#pragma once

#include <cstdint>
#include <vector>

#include "plumb/base/context.h"
#include "plumb/space/mesh_arrays.h"

#pragma GCC visibility push(default)
namespace plumb {

/// The result of weld_points().
struct PointWeld {
  /// For each point, the index of the point into which it was merged, or its own index if it was
  /// kept.
  std::vector<std::uint32_t> kept;
  /// The number of points that had the same coordinates as an earlier point. Points that no face
  /// uses are not counted.
  std::uint64_t equal = 0;
  /// The number of positions that were moved to another position.
  std::uint64_t moved = 0;
  double farthest = 0;  ///< The largest distance by which a point moved, rounded up.
};

/// Merges points that have equal coordinates or whose distance is at most `tolerance`. The function
/// changes the corners of faces to the indices of kept points. It does not change the list of
/// points, so points that no face uses any more remain in the list. Throws Error{BadArgument} if
/// the tolerance is negative or not finite. Throws Error{BadIndex} and Error{NotFinite} in the same
/// cases as complex_of_mesh(). Also throws the errors of the Context.
PointWeld weld_points(PolygonMesh& mesh, double tolerance, Context& context = unlimited_context());

}  // namespace plumb
#pragma GCC visibility pop
