// Where text goes on what is seen of the groups of a scene.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "plumb/picture/canvas.h"
#include "plumb/picture/scene.h"

#pragma GCC visibility push(default)
namespace plumb {

/// A text and where it is to stand.
struct PlacedText {
  Point2 middle;     ///< in samples of the canvas
  double height;     ///< of capitals
  std::string text;  ///< any bytes
};

/// For each group with a text of which enough is seen: the text at the place farthest from where something
/// else is seen, `most` high or as high as there is room for, at least `least`. In parts too small for that there
/// is none. O(samples).
std::vector<PlacedText> place_texts(const Scene& scene, const Canvas& canvas, double least,
                                    double most);

}  // namespace plumb
#pragma GCC visibility pop
