// Writes a scene as one HTML file. In a browser, the scene can be turned, moved and enlarged by
// mouse, finger and keys. The file is self-contained: it loads nothing. The page needs WebGL. In a
// browser without WebGL it shows a message.
#pragma once

#include <iosfwd>
#include <string>

#include "plumb/picture/scene.h"

#pragma GCC visibility push(default)
namespace plumb {

/// The text on the page of a scene.
struct SceneText {
  std::string title;  ///< The title. Any bytes.
  std::string kind;   ///< The kind of the set or surface, in a few words.
  std::string facts;  ///< Facts such as counts, in one line.
};

/// Writes the page. Cost: O(n). The page has about 170 bytes for each triangle. Passes on
/// exceptions of `out`.
void write_scene_html(std::ostream& out, const Scene& scene, const SceneText& text);

}  // namespace plumb
#pragma GCC visibility pop
