// Renders a scene as an image. Every sample of the image shows the facet that is nearest to the
// viewer. The light comes from one side. Lines and dots are drawn over the facets, unless a nearer
// facet hides them. If the patches of a scene form groups, the text of each group is written on the
// visible part of the group.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "plumb/picture/canvas.h"
#include "plumb/picture/scene.h"

#pragma GCC visibility push(default)
namespace plumb {

/// A text with its position and size in a picture.
struct PlacedText {
  Point2 middle;     ///< The middle of the text, in samples of the canvas.
  double height;     ///< Height of capital letters, in samples of the canvas.
  std::string text;  ///< The text. May be any bytes.
};

/// Chooses a position and a height for the text of each group, and returns the texts. The middle of
/// a text is the sample that is farthest from the border of the visible part of its group. The
/// height of a text is `most` if a text of this height fits into the visible part. Otherwise the
/// height is the largest height that fits, but at least `least`. If a text of height `least / 2`
/// does not fit, the group gets no text. Cost: O(samples).
std::vector<PlacedText> place_texts(const Scene& scene, const Canvas& canvas, double least,
                                    double most);

/// A parallel projection. The scale of the projection is chosen so that the whole scene fits into
/// the picture. The direction of view cannot be chosen: a flat scene is seen from above, and all
/// other scenes are seen from the same direction.
class Camera {
 public:
  /// Makes the projection of the whole scene into a picture of the given size.
  Camera(const Scene& scene, double width, double height);

  Spot place(const Point3& p) const;  ///< Returns the image of a point.
  /// Returns the point of space whose image is `spot`.
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
  double text_height = 24;     ///< Largest height of capital letters, in pixels.
};

/// An image, and the texts that a caller may write over it.
struct Rendering {
  Image image;                    ///< The image without text.
  std::vector<PlacedText> texts;  ///< The texts. Positions and heights are in pixels.
};

/// Returns the image of a scene. The output is deterministic. Cost: O(pixels + triangles).
Image rendered(const Scene& scene, const RenderOptions& options = {});
/// Returns the image of a scene without its texts, and the texts separately. So a page can write
/// the texts in its own fonts. The cost is the same as for rendered().
Rendering rendered_without_text(const Scene& scene, const RenderOptions& options = {});

}  // namespace plumb
#pragma GCC visibility pop
