// Writes a page about a set of space: facts, a picture, and a legend of what occurs. The file is
// self-contained SVG without scripts.
//
// The picture is an image inside the page, not a sorted list of facets. Visibility is then correct
// at every sample, even where facets cannot be sorted by depth, and the size of the file does not
// depend on the number of facets. The caller encodes the image, so that the library does not depend
// on a writer of PNG.
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

/// Render options for the image of the page, which has these proportions.
inline constexpr RenderOptions kPageImage{1104, 828};

/// Returns the facts in one line: "12 vertices, 18 edges, 8 facets, 2 volumes; volume 3".
std::string facts_of(const Nef3& set, Context& context = unlimited_context());
/// Returns the kind of a set in words: "bounded, closed".
std::string kind_of(const Nef3& set);

/// Writes the page of a set. `scene` is the scene of the set and `png` the PNG file of its image.
/// Cost: O(size of the image), and the cost of facts_of(). Throws what `out` throws.
void write_space_svg(std::ostream& out, const Nef3& set, const Scene& scene, std::string_view png,
                     const std::string& title, Context& context = unlimited_context());

/// The contents of a page besides the legend of the scene.
struct ScenePage {
  SceneText text;                 ///< Title, kind and facts.
  std::string_view png;           ///< A PNG file of the size of kPageImage.
  std::vector<PlacedText> texts;  ///< Texts over the image, in its pixels.
  std::string middle;             ///< Text in place of a picture, if nothing is visible.
};

/// Writes the page of any scene. Throws what `out` throws.
void write_scene_svg(std::ostream& out, const Scene& scene, const ScenePage& page);

}  // namespace plumb
#pragma GCC visibility pop
