// Colours for things of one kind that have to be told apart.
#pragma once

#include <cstddef>

#include "plumb/picture/scene.h"

namespace plumb {

/// Light colours, far apart however many: hues by the golden section, in three strengths.
Colour distinct_colour(std::size_t i);

}  // namespace plumb
