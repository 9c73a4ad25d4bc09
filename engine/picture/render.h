// A scene as an image: every sample shows the nearest facet, lit from one side; lines and dots over what does not
// hide them.
#pragma once

#include "plumb/picture/canvas.h"
#include "plumb/picture/scene.h"
#include "plumb/picture/text_places.h"

#pragma GCC visibility push(default)
namespace plumb {

/// Looks at a scene from far away, along a fixed direction (from above, for a flat one), so that all of it
/// fits into the picture. Parallel lines stay parallel.
class Camera {
 public:
  /// Fits the whole scene into a picture of that size.
  Camera(const Scene& scene, double width, double height);

  Spot place(const Point3& p) const;  ///< Where a point of the scene is seen.
  /// The point of the scene at a spot.
  Point3 point_at(const Spot& spot) const;
  /// Towards the viewer, of length 1.
  const Point3& viewer() const { return axes_[2]; }
  const Point3& right() const { return axes_[0]; }  ///< To the right in the picture, of length 1.
  const Point3& up() const { return axes_[1]; }     ///< Upwards in the picture, of length 1.

 private:
  std::array<Point3, 3> axes_;  // to the right, up, towards the viewer
  double scale_ = 1;
  Spot middle_{}, shift_{};
};

/// What an image is to be like.
struct RenderOptions {
  std::uint32_t width = 1200;  ///< in pixels
  std::uint32_t height = 900;  ///< in pixels
  double text_height = 24;     ///< of capitals, in pixels, where there is room
};

/// An image, and the texts that are not in it: places and heights in pixels.
struct Rendering {
  Image image;                    ///< without text
  std::vector<PlacedText> texts;  ///< what is to be written over it
};

/// Deterministic. O(pixels + triangles).
Image rendered(const Scene& scene, const RenderOptions& options = {});
/// The same with text apart, for pages that have fonts.
Rendering rendered_without_text(const Scene& scene, const RenderOptions& options = {});

}  // namespace plumb
#pragma GCC visibility pop
