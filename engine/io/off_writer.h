// Writes meshes as OFF (docs/formats.md, "OFF").
#pragma once

#include <cstdint>
#include <ostream>

#include "plumb/space/polygon_mesh.h"

namespace plumb {

/// What a writer does with coordinates that are no doubles.
enum class MeshNumbers : std::uint8_t {
  Nearest,  ///< the nearest double, in the shortest decimal that reads back as it
  Exact,    ///< p/q
};

/// read_off() of the text gives the same mesh, with MeshNumbers::Nearest but for what `exact` holds.
/// Throws Error{NumberOutOfRange} when a vertex that is to be rounded lies beyond the largest double;
/// what `out` throws.
void write_off(std::ostream& out, const PolygonMesh& mesh,
               MeshNumbers numbers = MeshNumbers::Nearest);

}  // namespace plumb
