// A scene as one HTML file: turned around, moved and enlarged by mouse, finger and keys. Nothing is loaded from
// anywhere; it needs WebGL and says so where there is none.
#pragma once

#include <ostream>
#include <string>

#include "plumb/picture/scene.h"

#pragma GCC visibility push(default)
namespace plumb {

/// What a page says of a scene.
struct SceneText {
  std::string title;  ///< any bytes
  std::string kind;   ///< a few words
  std::string facts;  ///< a line
};

/// O(n), ~170 bytes a triangle.
void write_scene_html(std::ostream& out, const Scene& scene, const SceneText& text);

}  // namespace plumb
#pragma GCC visibility pop
