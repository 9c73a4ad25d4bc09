// Unions of sets that nobody else needs. Internal.
#pragma once

#include <vector>

#include "plumb/base/context.h"
#include "plumb/space/nef3.h"

namespace plumb {

/// union_of() that uses up its operands: their memory goes as they are united, not all of it at the end.
Nef3 united(std::vector<Nef3> sets, Context& context);

}  // namespace plumb
