// Closed chains of vertices in a plane: which way they run around, and what lies inside.
#pragma once

#include <span>
#include <vector>

#include "plumb/convex/cut_surface.h"

namespace plumb {

/// A side of a ring in the plane n: runs along `along` * (n x n_other), n the canonical normal.
struct RingSide {
  VertexId from;
  VertexId to;
  PlaneId other;
  Sign along;
};

/// A boundary cycle of a face.
std::vector<RingSide> ring_of(const CutSurface& surface, HalfedgeId first);

/// Does it run clockwise, seen from the side that `plane` looks to? Decided at its least vertex. O(length).
bool is_hole(const CutSurface& surface, OrientedPlane plane, std::span<const RingSide> ring);

enum class RingPlace : std::uint8_t { Outside, On, Inside };

/// Where a vertex in the plane lies: by the sides that cross a line through it, parallel to a coordinate plane. O(length).
RingPlace place_in(const CutSurface& surface, PlaneId plane, std::span<const RingSide> ring,
                   VertexId v);

/// Where another ring that crosses none of its sides lies: where its first vertex that is not on it does.
/// On: all vertices are.
RingPlace place_in(const CutSurface& surface, PlaneId plane, std::span<const RingSide> ring,
                   std::span<const RingSide> other);

}  // namespace plumb
