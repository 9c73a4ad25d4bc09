// Ids of the parts of a divided surface.
#pragma once

#include <cstdint>
#include <limits>

#include "plumb/base/error.h"
#include "plumb/base/ids.h"

#pragma GCC visibility push(default)
namespace plumb {

using NodeId = StrongId<struct SurfaceNodeTag>;    ///< where arcs and sides end
using ArcId = StrongId<struct SurfaceArcTag>;      ///< a piece of polygons between two nodes
using PieceId = StrongId<struct SurfacePieceTag>;  ///< a part of one face
using CellId = StrongId<struct SurfaceCellTag>;  ///< pieces and faces with no polygon between them

/// A number that belongs to a polygon or a shape. Lists of these are sparse vectors: ascending ids, no zeros.
struct SignedEntry {
  std::uint32_t id;    ///< of a polygon or shape
  std::int32_t value;  ///< not zero
  friend auto operator<=>(const SignedEntry&, const SignedEntry&) = default;
};

/// A sum as the value of an entry. Its negative is one, too. Throws Error{NumberOutOfRange} beyond.
inline std::int32_t entry_value(std::int64_t sum) {
  constexpr std::int64_t kMost = std::numeric_limits<std::int32_t>::max();
  if (sum > kMost || sum < -kMost) {
    throw Error(ErrorCode::NumberOutOfRange,
                "a polygon or shape winds around a cell 2^31 times or more");
  }
  return static_cast<std::int32_t>(sum);
}

}  // namespace plumb
#pragma GCC visibility pop
