// A set of space as a page: what it is, its picture, a legend of what occurs. Self-contained SVG without
// scripts.
//
// The picture is an image inside the page, not facets in an order: which facet hides which is then right at
// every sample, also where no order of whole facets is, and the file stays small whatever the number of
// facets. The image is encoded by whoever calls, so that the library needs nothing that writes PNG.
#pragma once

#include <ostream>
#include <string>
#include <string_view>
#include <vector>

#include "plumb/base/context.h"
#include "plumb/picture/render.h"
#include "plumb/picture/scene.h"
#include "plumb/picture/scene_html.h"
#include "plumb/space/nef3.h"

#pragma GCC visibility push(default)
namespace plumb {

/// What to render for the page: the place for it has these proportions.
inline constexpr RenderOptions kPageImage{1104, 828};

/// "12 vertices, 18 edges, 8 facets, 2 volumes; volume 3".
std::string facts_of(const Nef3& set);
std::string facts_of(const Nef3& set, Context& context);  ///< The same within limits.
/// "bounded, closed".
std::string kind_of(const Nef3& set);

/// `scene` is that of the set, `png` the file of its image. O(size of the image), and what facts_of() takes.
void write_space_svg(std::ostream& out, const Nef3& set, const Scene& scene, std::string_view png,
                     const std::string& title, Context& context);

/// What a page shows besides the legend of the scene.
struct ScenePage {
  SceneText text;                 ///< title and facts
  std::string_view png;           ///< of kPageImage's size
  std::vector<PlacedText> texts;  ///< over the image, in its pixels
  std::string middle;             ///< in place of a picture, if there is nothing to be seen
};

/// The same page for any scene.
void write_scene_svg(std::ostream& out, const Scene& scene, const ScenePage& page);

}  // namespace plumb
#pragma GCC visibility pop
