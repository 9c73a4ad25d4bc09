// Reads `.nef` (docs/formats.md, ".nef"): complexes in space, exactly as they are held in memory.
//
// Main flow of read_nef3:
//  1. header       reads `plumb-nef3 1` and the counts, and checks the counts against the bytes
//  2. records      reads planes, points, vertices, edges, edge uses, facets, volumes and `end`
//  3. check_links  checks that every reference between records is in range and that redundant
//                  references agree (solid_text.h), so that code that follows references cannot
//                  leave the arrays or loop forever
//
// The reader does not check that the records form a complex, where points lie or in which order
// edges turn: that is the task of the audit.
//
// Cost: O(n). Errors: steps 1 and 2 throw, with the place (file, line, column), NotText, Syntax,
// NumberOutOfRange, CountMismatch, BadIndex, BadShape (coefficients that are no plane, a plane that
// was listed before, planes without a common point), UnknownFormat (another version) and
// ResourceLimit. Step 3 throws BadShape with the file. Cancelled as the Context demands.
#pragma once

#include <string_view>

#include "plumb/base/context.h"
#include "plumb/io/read_options.h"
#include "plumb/space/space_complex.h"

#pragma GCC visibility push(default)
namespace plumb {

/// Returns the complex that `text` holds. Coordinates of points are read as the nearest doubles
/// even if `options.exact_decimals` is set, because the writer prints doubles. The memory of the
/// complex stays charged to `context`. Throws the errors stated above.
SpaceComplex read_nef3(std::string_view text, const ReadOptions& options = {},
                       Context& context = unlimited_context());

}  // namespace plumb
#pragma GCC visibility pop
