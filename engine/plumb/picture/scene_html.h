// Writes a scene as one HTML file that can be turned, moved and enlarged by mouse, finger and keys.
// The file is self-contained: it loads nothing. It needs WebGL and shows a message without it.
#pragma once

#include <iosfwd>
#include <string>

#include "plumb/picture/scene.h"

#pragma GCC visibility push(default)
namespace plumb {

/// The text on the page of a scene.
struct SceneText {
  std::string title;  ///< The title; any bytes.
  std::string kind;   ///< The kind of the set or surface, in a few words.
  std::string facts;  ///< Facts such as counts, in one line.
};

/// Writes the page. Cost: O(n), about 170 bytes for each triangle. Throws what `out` throws.
void write_scene_html(std::ostream& out, const Scene& scene, const SceneText& text);

}  // namespace plumb
#pragma GCC visibility pop
