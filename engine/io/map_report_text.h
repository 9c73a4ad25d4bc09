// The report of check_map() for people and pipes: the DCEL listing, or the defects line by line.
#pragma once

#include <ostream>
#include <string_view>

#include "plumb/plane/map_check.h"

#pragma GCC visibility push(default)
namespace plumb {

/// "valid", "not a planar subdivision", "open", "superposed".
std::string_view headline(MapVerdict verdict);

/// "duplicate", "open", "crossing", "twin", "mixed", "nested".
std::string_view name_of(DefectKind kind);

/// "pinch", "isolated-vertex", "inferred-outer", "merged-vertex".
std::string_view name_of(WarningKind kind);

/// Valid: the DCEL listing (docs/formats.md, "DCEL listing"), half-edge k being the k-th corner of
/// the listed cycles. Otherwise the headline, then a line per described defect. Everything 1-based.
/// O(n). Throws what `out` throws.
void write_map_report_text(std::ostream& out, const MapReport& report);

}  // namespace plumb
#pragma GCC visibility pop
