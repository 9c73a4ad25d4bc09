// Writes sets of the plane as `.nef2` (docs/formats.md, ".nef2").
#pragma once

#include <ostream>

#include "plumb/plane/plane_records.h"

namespace plumb {

/// Lossless: read_nef2_records() of the text gives to_records(complex). Coordinates are integers or
/// fractions, never decimals. Throws what `out` throws, and Error{Cancelled} or Error{ResourceLimit} as the context says.
void write_nef2(std::ostream& out, const PlaneComplex& complex, Context& context);

}  // namespace plumb
