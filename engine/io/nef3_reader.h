// Reads `.nef` (docs/formats.md, ".nef"): complexes in space, exactly as they are held.
//
//  1. `plumb-nef3 1`, then the counts; claims are checked against the bytes
//  2. planes, points, vertices, edges, uses, facets, volumes, `end`
//  3. check_links: whatever one record says of another is in range, and what is said twice agrees
//     (nef3_links.h): nobody who follows links can leave the arrays or go round for ever
//
// Whether the records are a complex, where points lie and in which order edges turn, is a matter for the audit.
//
// Errors of 1 and 2 are thrown with the place (file, line, column): NotText, Syntax, NumberOutOfRange,
// CountMismatch, BadIndex, BadShape (no plane, or one that was there before; planes without a common point),
// UnknownFormat (another version), ResourceLimit; those of 3 as BadShape with the file; Cancelled. Cost: O(n).
#pragma once

#include <string_view>

#include "plumb/base/context.h"
#include "plumb/io/read_options.h"
#include "plumb/space/space_complex.h"

#pragma GCC visibility push(default)
namespace plumb {

/// Coordinates of points are the nearest doubles, whatever `options` say of decimals: a writer prints doubles.
/// The memory of the complex stays charged to `context`.
SpaceComplex read_nef3(std::string_view text, const ReadOptions& options, Context& context);

}  // namespace plumb
#pragma GCC visibility pop
