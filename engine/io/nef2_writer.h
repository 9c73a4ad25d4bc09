// Writes sets of the plane as `.nef2` (docs/formats.md, ".nef2").
#pragma once

#include <ostream>

#include "plumb/plane/plane_records.h"

namespace plumb {

/// Lossless: read_nef2_records() of the text gives the same records. Coordinates are integers or
/// fractions, never decimals. Throws what `out` throws.
void write_nef2(std::ostream& out, const PlaneRecords& records);

}  // namespace plumb
