// Writes a picture of the plane as one HTML file. In a browser, the user can move and enlarge the
// picture with the mouse, with fingers or with keys. The file does not load other files.
#pragma once

#include <iosfwd>
#include <string>
#include <string_view>

#pragma GCC visibility push(default)
namespace plumb {

/// Writes the page. `svg` is a complete SVG file made by write_map_svg(), write_nef2_svg() or
/// write_overlay_svg(). `title` may contain any bytes. Exceptions of `out` reach the caller.
void write_plane_html(std::ostream& out, std::string_view svg, const std::string& title);

}  // namespace plumb
#pragma GCC visibility pop
