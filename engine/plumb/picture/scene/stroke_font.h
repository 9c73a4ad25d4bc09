// Letters made of straight strokes, for text in images.
#pragma once

#include <string_view>
#include <utility>
#include <vector>

#include "plumb/predicates/point.h"

namespace plumb {

/// A straight stroke.
using TextStroke = std::pair<Point2, Point2>;

/// Returns the width of a text, divided by the height of its capital letters.
double stroked_width(std::string_view text);

/// Returns the strokes of a text around its middle, y downwards, one unit high. Capitals, digits
/// and common signs have strokes; small letters are small capitals; anything else is blank.
std::vector<TextStroke> strokes_of(std::string_view text);

}  // namespace plumb
