// Checks the invariants of a sphere map that sphere_map.h states.
#pragma once

#include <optional>

#include "plumb/base/marks.h"
#include "plumb/dcel/dcel.h"
#include "plumb/sphere/sphere_map.h"

#pragma GCC visibility push(default)
namespace plumb {

/// Checks every invariant of a map from scratch and returns the first one that is broken, with its
/// place, or nothing. The invariants, in the order in which they are checked:
///   the arrays have the right sizes; ids are in range; marks are 0, 1 or kBeyond; a loop has no
///   point, any other arc has two
///   different circles have different normals; each direction is of two planes that cross
///   half-arcs follow each other, in one ring around each point; a boundary has one face
///   points lie on the circles of their arcs; rings turn clockwise, once around
///   no two points are equal; arcs intersect at points only; there is at most one loop
///   cycles and isolated points name the faces that they bound; every face has a boundary
/// AuditForm::Minimal also checks that no cell can be removed without changing the set. Costs as
/// much as an overlay of the map with itself, which is O(n^2) for small maps.
std::optional<DcelFlaw> audit(const PlaneTable& planes, const SphereMap& map, AuditForm form);

}  // namespace plumb
#pragma GCC visibility pop
