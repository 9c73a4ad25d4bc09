// The operations of models, layers, offsets, distances and repairs, on inputs as large as one
// likes, for checkpoint_gaps: what large_operations.h lacks.
#pragma once

#include <string>

#include "system/large_operations.h"

namespace plumb::testing {

/// Size 1 is for continuous integration. `room`: offsets, layers, mending, models, trees, queries;
/// empty: all.
void measure_large_models(double size, const std::string& room, const Measure& measured);

}  // namespace plumb::testing
