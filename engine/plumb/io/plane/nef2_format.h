// Reads and writes `.nef2` (docs/formats.md, ".nef2"): sets of the plane, exactly as they are held.
//
// Main flow of read_nef2():
//  1. read_header    reads `plumb-nef2 1`, then the counts; claims are checked against the bytes
//  2. records        reads points, crossings, vertices and edges
//  3. end            requires that nothing but blank and comment lines follows
//  4. from_records   verifies that the records are the complex of a set (plane_records.h)
//
// Errors of steps 1 to 3 are thrown with the place (file, line, column): NotText, Syntax,
// NumberOutOfRange, CountMismatch, BadIndex, BadShape (a line through equal points, parallel lines
// of a crossing), UnknownFormat (another version), ResourceLimit; the errors of step 4 as BadShape
// with the file; Cancelled. Cost: O(n log n).
#pragma once

#include <ostream>
#include <string_view>

#include "plumb/base/context.h"
#include "plumb/io/read_options.h"
#include "plumb/plane/complex/plane_records.h"
#include "plumb/plane/nef2.h"

namespace plumb {

/// Returns the records (steps 1 to 3). Their memory stays charged to `context`.
PlaneRecords read_nef2_records(std::string_view text, const ReadOptions& options, Context& context);

/// Returns the set (all steps).
Nef2 read_nef2(std::string_view text, const ReadOptions& options, Context& context);

// Writes sets of the plane as `.nef2` (docs/formats.md, ".nef2").

/// Writes a complex without loss: read_nef2_records() of the text gives to_records(complex).
/// Coordinates are integers or fractions, never decimals. Throws the exceptions of `out` and the
/// errors of the Context.
void write_nef2(std::ostream& out, const PlaneComplex& complex, Context& context);

}  // namespace plumb
