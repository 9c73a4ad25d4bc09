// A picture of the plane as one HTML file: moved and enlarged by mouse, finger and keys. Nothing is loaded from
// anywhere.
#pragma once

#include <ostream>
#include <string>
#include <string_view>

#pragma GCC visibility push(default)
namespace plumb {

/// `svg` is a whole file of one of the other writers.
void write_plane_html(std::ostream& out, std::string_view svg, const std::string& title);

}  // namespace plumb
#pragma GCC visibility pop
