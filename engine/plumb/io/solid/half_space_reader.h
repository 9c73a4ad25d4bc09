// Half-spaces from text: lines `a b c d closed|open`, meaning a x + b y + c z + d <= 0 or < 0.
#pragma once

#include <string_view>

#include "plumb/base/context.h"
#include "plumb/io/read_options.h"
#include "plumb/space/half_space_list.h"

namespace plumb {

/// The memory of the list stays charged to `context`. Errors, with their place: those of
/// NumberReader, Syntax, DegenerateFace (a = b = c = 0), ResourceLimit.
HalfSpaceList read_half_spaces(std::string_view text, const ReadOptions& options, Context& context);

}  // namespace plumb
