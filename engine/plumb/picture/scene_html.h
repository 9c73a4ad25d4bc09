// Writes a scene as one HTML file. In a browser, the user can turn, move and enlarge the scene with
// the mouse, with fingers or with keys. The file does not load other files. The page needs WebGL.
// In a browser without WebGL, the page shows a message.
#pragma once

#include <iosfwd>
#include <string>

#include "plumb/picture/scene.h"

#pragma GCC visibility push(default)
namespace plumb {

/// The text on the page of a scene.
struct SceneText {
  std::string title;  ///< The title. May be any bytes.
  std::string kind;   ///< The kind of the set or surface, in a few words.
  std::string facts;  ///< Facts such as counts, in one line.
};

/// Writes the page. Cost: O(n) for n triangles, lines and dots. The page has about 170 bytes for
/// each triangle. Exceptions of `out` reach the caller.
void write_scene_html(std::ostream& out, const Scene& scene, const SceneText& text);

}  // namespace plumb
#pragma GCC visibility pop
