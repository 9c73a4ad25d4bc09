// Renders a scene as an image: every sample shows the nearest facet, lit from one side; lines and
// dots are drawn over what does not hide them. Texts are placed on the visible parts of groups.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "plumb/picture/canvas.h"
#include "plumb/picture/scene.h"

#pragma GCC visibility push(default)
namespace plumb {

/// A text and its place.
struct PlacedText {
  Point2 middle;     ///< The middle of the text, in samples of the canvas.
  double height;     ///< Height of capitals.
  std::string text;  ///< The text; any bytes.
};

/// Returns a place for the text of each group of which enough is visible: the place farthest from
/// everything else that is visible. The text is `most` high, or as high as fits, but at least
/// `least` high; a group whose visible part is too small has no text. Cost: O(samples).
std::vector<PlacedText> place_texts(const Scene& scene, const Canvas& canvas, double least,
                                    double most);

/// A parallel projection along a fixed direction (from above for a flat scene), scaled so that the
/// whole scene fits into the picture.
class Camera {
 public:
  /// Fits the whole scene into a picture of the given size.
  Camera(const Scene& scene, double width, double height);

  Spot place(const Point3& p) const;  ///< Returns the image of a point.
  /// Returns the point of the scene at a spot.
  Point3 point_at(const Spot& spot) const;
  /// Returns the unit vector towards the viewer.
  const Point3& viewer() const { return axes_[2]; }
  const Point3& right() const { return axes_[0]; }  ///< Unit vector to the right.
  const Point3& up() const { return axes_[1]; }     ///< Unit vector upwards.

 private:
  std::array<Point3, 3> axes_;  // Unit vectors: right, up, towards the viewer.
  double scale_ = 1;
  Spot middle_{}, shift_{};
};

/// Options of an image.
struct RenderOptions {
  std::uint32_t width = 1200;  ///< Width in pixels.
  std::uint32_t height = 900;  ///< Height in pixels.
  double text_height = 24;     ///< Largest height of capitals, in pixels.
};

/// An image and the texts that are not drawn in it, with places and heights in pixels.
struct Rendering {
  Image image;                    ///< The image without text.
  std::vector<PlacedText> texts;  ///< The texts to be written over the image.
};

/// Returns the image of a scene. The output is deterministic. Cost: O(pixels + triangles).
Image rendered(const Scene& scene, const RenderOptions& options = {});
/// Returns the image and its texts separately, for pages that have fonts. Cost as for rendered().
Rendering rendered_without_text(const Scene& scene, const RenderOptions& options = {});

}  // namespace plumb
#pragma GCC visibility pop
