// Reads `.nef` files (docs/formats.md, ".nef"). Such a file contains a complex in space, exactly as
// it is in memory.
//
// Main flow of read_nef3:
//  1. header       reads `plumb-nef3 1` and the counts, and checks the counts against the bytes
//  2. records      reads planes, points, vertices, edges, edge uses, facets, volumes and `end`
//  3. check_links  checks that every reference between records is in range, and that redundant
//                  references agree (solid_text.h). After this step, code that follows references
//                  cannot leave the arrays or loop forever.
//
// The reader does not check that the records form a valid complex. It does not check where points
// lie, or in which order edges leave a vertex. The audit (space_audit.h) checks these invariants.
//
// Cost: O(n).
//
// Errors of steps 1 and 2 name the file, line and column. They are NotText, Syntax,
// NumberOutOfRange, CountMismatch, BadIndex, ResourceLimit and:
//   - BadShape if coefficients do not describe a plane, if a plane is listed twice, or if the
//     planes of a point do not intersect in exactly one point
//   - UnknownFormat if the file has another version of the format
// Step 3 throws BadShape, which names the file. All steps throw Cancelled as the Context demands.
#pragma once

#include <string_view>

#include "plumb/base/context.h"
#include "plumb/io/read_options.h"
#include "plumb/space/space_complex.h"

#pragma GCC visibility push(default)
namespace plumb {

/// Returns the complex that `text` describes. Coordinates of points are read as the nearest doubles
/// because the writer prints doubles. `options.exact_decimals` does not change this. The memory of
/// the complex stays charged to `context`. Throws the errors stated above.
SpaceComplex read_nef3(std::string_view text, const ReadOptions& options = {},
                       Context& context = unlimited_context());

}  // namespace plumb
#pragma GCC visibility pop
