// Nef2::parts() within limits.
#pragma once

#include "plumb/base/context.h"
#include "plumb/plane/nef2.h"

#pragma GCC visibility push(default)
namespace plumb {

/// Polygons, lines and points of the closure. O(n log n).
PlaneParts parts_of(const Nef2& set, Context& context);

}  // namespace plumb
#pragma GCC visibility pop
