// Reads half-spaces from text: lines `a b c d closed|open`, meaning a x + b y + c z + d <= 0 or <
// 0.
#pragma once

#include <string_view>

#include "plumb/base/context.h"
#include "plumb/io/read_options.h"
#include "plumb/space/half_space_list.h"

namespace plumb {

/// Returns the list of half-spaces. Its memory stays charged to `context`. Throws with the place:
/// errors of NumberReader, Syntax, DegenerateFace (a = b = c = 0), ResourceLimit.
HalfSpaceList read_half_spaces(std::string_view text, const ReadOptions& options, Context& context);

}  // namespace plumb
