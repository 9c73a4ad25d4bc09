// The public operations that can take long or much, on inputs as large as one likes: for programs
// that measure them.
#pragma once

#include <functional>
#include <string>

#include "plumb/base/context.h"

namespace plumb::testing {

/// Is given an operation; runs it once.
using Measure =
    std::function<void(const std::string& name, const std::function<void(Context&)>& run)>;

/// Size 1 is for continuous integration, 10 and more to look for offenders. `room`: plane, maps,
/// sphere, space, convex, surface; empty: all.
void measure_large_operations(double size, const std::string& room, const Measure& measured);

}  // namespace plumb::testing
