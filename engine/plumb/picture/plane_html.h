// Writes a picture of the plane as one HTML file that can be moved and enlarged by mouse, finger
// and keys. The file is self-contained: it loads nothing.
#pragma once

#include <iosfwd>
#include <string>
#include <string_view>

#pragma GCC visibility push(default)
namespace plumb {

/// Writes the page. `svg` is a complete file made by one of the writers of SVG; `title` is any
/// bytes. Throws what `out` throws.
void write_plane_html(std::ostream& out, std::string_view svg, const std::string& title);

}  // namespace plumb
#pragma GCC visibility pop
