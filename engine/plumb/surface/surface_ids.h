// Ids of the cells of a divided surface.
#pragma once

#include <cstdint>
#include <limits>

#include "plumb/base/ids.h"
#include "plumb/predicates/error.h"

#pragma GCC visibility push(default)
namespace plumb {

using NodeId = StrongId<struct SurfaceNodeTag>;    ///< A point where arcs and sides of faces end.
using ArcId = StrongId<struct SurfaceArcTag>;      ///< A piece of polygons between two nodes.
using PieceId = StrongId<struct SurfacePieceTag>;  ///< A part of one face between arcs.
/// A connected part of the surface: pieces and whole faces with no polygon between them.
using CellId = StrongId<struct SurfaceCellTag>;

/// An integer that belongs to a polygon or a shape. A list of these is a sparse vector: ids ascend
/// and no value is zero.
struct SignedEntry {
  std::uint32_t id;    ///< The number of the polygon or shape.
  std::int32_t value;  ///< The integer; not zero in a list.
  friend auto operator<=>(const SignedEntry&, const SignedEntry&) = default;
};

/// Returns a sum as the value of an entry. The negative of the result is representable, too. Throws
/// Error{NumberOutOfRange} if the absolute value is 2^31 or more.
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
