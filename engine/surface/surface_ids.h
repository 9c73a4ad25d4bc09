// Ids of the parts of a divided surface.
#pragma once

#include <cstdint>

#include "plumb/base/ids.h"

namespace plumb {

using NodeId = StrongId<struct SurfaceNodeTag>;    ///< where arcs and sides end
using ArcId = StrongId<struct SurfaceArcTag>;      ///< a piece of polygons between two nodes
using PieceId = StrongId<struct SurfacePieceTag>;  ///< a part of one face
using CellId = StrongId<struct SurfaceCellTag>;  ///< pieces and faces with no polygon between them

/// A number that belongs to a polygon or a shape. Lists of these are sparse vectors: ascending ids, no zeros.
struct SignedEntry {
  std::uint32_t id;
  std::int32_t value;
  friend auto operator<=>(const SignedEntry&, const SignedEntry&) = default;
};

}  // namespace plumb
