// Reads `.nef` files (docs/formats.md, ".nef"). Such a file represents a SpaceComplex without loss.
//
// Main flow of read_nef3:
//  1. header       reads `plumb-nef3 1` and the counts, and checks that the file has enough bytes
//                  for these counts
//  2. records      reads planes, points, vertices, edges, edge uses, facets and volumes, and the
//                  word `end`
//  3. check_links  checks that every reference between records is in range. If two references state
//                  the same fact, the step checks that they agree (solid_text.h). After this step,
//                  code that follows references never leaves the arrays and always terminates.
//
// The reader does not check all invariants of a complex. For example, it does not check that points
// lie where they should, or that edges leave a vertex in the right order. The audit (space_audit.h)
// checks all invariants.
//
// Cost: O(n) for n bytes.
//
// Errors of steps 1 and 2 name the file, line and column. These errors are:
//   - NotText, Syntax, NumberOutOfRange, CountMismatch, BadIndex and ResourceLimit
//   - BadShape if coefficients do not describe a plane, if a plane is listed twice, or if the
//     planes of a point do not intersect in exactly one point
//   - UnknownFormat if the file has another version of the format
// Step 3 throws BadShape. This error names the file only. Every step throws Cancelled if the
// Context demands it.
#pragma once

#include <string_view>

#include "plumb/base/context.h"
#include "plumb/io/read_options.h"
#include "plumb/space/space_complex.h"

#pragma GCC visibility push(default)
namespace plumb {

/// Returns the complex that `text` describes. Decimal coordinates of points are read as the nearest
/// doubles, because write_nef3() writes coordinates of points as doubles. The reader ignores
/// `options.exact_decimals`. The memory of the complex stays charged to `context`. Throws the
/// errors that the head of this file states.
SpaceComplex read_nef3(std::string_view text, const ReadOptions& options = {},
                       Context& context = unlimited_context());

}  // namespace plumb
#pragma GCC visibility pop
