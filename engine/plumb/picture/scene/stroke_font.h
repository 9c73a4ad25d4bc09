// Letters made of straight strokes, for text in images.
#pragma once

#include <string_view>
#include <utility>
#include <vector>

#include "plumb/predicates/point.h"

namespace plumb {

using TextStroke = std::pair<Point2, Point2>;

/// The width of a text in units of its height (that of a capital).
double stroked_width(std::string_view text);

/// The strokes of a text around its middle, y downwards, one unit high. Capitals, digits and the
/// usual signs; small letters are small capitals; of anything else nothing is seen.
std::vector<TextStroke> strokes_of(std::string_view text);

}  // namespace plumb
