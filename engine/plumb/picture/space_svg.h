// Writes a page about a set of space as SVG. The page has facts about the set, a picture, and a
// legend of the paints that occur. The file does not load other files and has no scripts.
//
// The picture is a PNG image inside the page. A picture made of SVG polygons would need the facets
// in an order from back to front, and such an order does not always exist. An image has two
// advantages: it shows the visible facet at every sample, and the size of the file does not depend
// on the number of facets. The caller encodes the image as PNG, so the library does not depend on a
// PNG encoder.
#pragma once

#include <iosfwd>
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

/// Render options for the image of a page. An image may have another size, but its width and height
/// must have the same ratio.
inline constexpr RenderOptions kPageImage{1104, 828};

/// Returns facts about a set in one line, such as "12 vertices, 18 edges, 8 facets, 2 volumes;
/// volume 3". The last number is the measure of the set.
std::string facts_of(const Nef3& set, Context& context = unlimited_context());
/// Returns the kind of a set in words, such as "bounded, closed".
std::string kind_of(const Nef3& set);

/// Writes a page that shows a set. `scene` is the scene of the set. `png` contains the bytes of a
/// PNG file with the image of this scene. Cost: O(size of the image), plus the cost of facts_of().
/// Exceptions of `out` reach the caller.
void write_space_svg(std::ostream& out, const Nef3& set, const Scene& scene, std::string_view png,
                     const std::string& title, Context& context = unlimited_context());

/// The contents of the page of a scene. The page also has a legend, which write_scene_svg() makes
/// from the scene.
struct ScenePage {
  SceneText text;                 ///< Title, kind and facts.
  std::string_view png;           ///< The bytes of a PNG file with the size of kPageImage.
  std::vector<PlacedText> texts;  ///< Texts over the image. Positions are in pixels of the image.
  std::string middle;             ///< The text that replaces the image if nothing is visible.
};

/// Writes a page that shows `scene`, with the contents of `page`. Exceptions of `out` reach the
/// caller.
void write_scene_svg(std::ostream& out, const Scene& scene, const ScenePage& page);

}  // namespace plumb
#pragma GCC visibility pop
