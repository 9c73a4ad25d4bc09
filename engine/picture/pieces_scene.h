// Several sets in one scene, moved apart so that one sees between them.
#pragma once

#include <span>

#include "plumb/picture/scene.h"
#include "plumb/space/nef3.h"

#pragma GCC visibility push(default)
namespace plumb {

/// Each set in a colour of its own, a group each; one layer. The middle of each set is moved away from the middle
/// of all by `apart` times their distance: 0 leaves them where they are. Throws Error{BadArgument} for an unbounded set,
/// unless `apart` is finite and not negative, and where a point would be moved beyond the largest double. O(n log n).
Scene exploded_scene(std::span<const Nef3> sets, double apart, Context& context);

}  // namespace plumb
#pragma GCC visibility pop
