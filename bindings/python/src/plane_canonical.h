// A form of sets of the plane that depends on the set alone.
#pragma once

#include "plumb/base/context.h"
#include "plumb/plane/nef2.h"

namespace plumb::python {

/// Returns the same set with coordinates in canonical form: equal sets have equal .nef2 files.
Nef2 canonical(const Nef2& set, Context& context);

}  // namespace plumb::python
