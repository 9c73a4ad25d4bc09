// The invariants of a sphere map, from scratch.
#pragma once

#include <optional>

#include "plumb/dcel/dcel.h"
#include "plumb/sphere/sphere_map.h"

#pragma GCC visibility push(default)
namespace plumb {

/// A broken invariant of a map and where; nothing when all hold. In this order:
///   sizes of the arrays; ids in range; marks 0, 1 or kBeyond; loops without any point
///   circles are of different normals; directions are of two planes
///   half-arcs follow each other: one ring around each point; faces are the same along a boundary
///   points lie on the circles of their arcs; rings turn clockwise, once around
///   no two points are equal; no two arcs meet but at points
///   cycles and isolated points name the faces that they bound; every face has a boundary
/// `minimal`: also that no item could go without changing the set.
/// Cost: O(n^2) for small maps, as an overlay with itself.
std::optional<DcelFlaw> audit(const PlaneTable& planes, const SphereMap& map, bool minimal);

}  // namespace plumb
#pragma GCC visibility pop
