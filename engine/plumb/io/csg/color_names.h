// Colours by name, as CSS has them, and by hexadecimal digits.
#pragma once

#include <array>
#include <optional>
#include <string_view>

namespace plumb {

/// Returns red, green, blue and opacity, from 0 to 1, of a colour that is written as a name of CSS
/// in any case ("red", "DarkOrchid"), or as #rgb, #rgba, #rrggbb or #rrggbbaa. Returns nothing for
/// any other text. O(log n) for n names.
std::optional<std::array<double, 4>> color_named(std::string_view text);

}  // namespace plumb
