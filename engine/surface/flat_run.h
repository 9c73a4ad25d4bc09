// Where a straight line crosses sides of faces that lie in one plane: exactly.
//
// On flat parts of a mesh this needs no roots: lines that overlap, touch or meet in one point in that plane do
// so on the surface, too, wherever they begin and end.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "plumb/base/context.h"
#include "plumb/predicates/rational.h"
#include "plumb/surface/surface_mesh.h"
#include "plumb/surface/surface_point.h"

namespace plumb {

/// A point of a strip of faces: a vertex, or else one of a table.
struct FlatRunEnd {
  VertexId vertex;  ///< invalid: `point`
  SurfacePointId point;
};

/// The line from a point in the face of doors.front() to one in the face beyond doors.back(): which part of the way
/// from the origin of each door to its target it crosses it at. None unless all those faces lie in one plane, none
/// folded back, and the line passes strictly inside all doors. Cost: O(doors); most often the first predicate
/// says no. Errors: Cancelled, ResourceLimit.
std::optional<std::vector<Rational>> flat_run(const SurfacePointTable& points,
                                              std::span<const HalfedgeId> doors,
                                              const FlatRunEnd& from, const FlatRunEnd& to,
                                              Context& context);

}  // namespace plumb
