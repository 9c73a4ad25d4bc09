// Outlines of a text, as OpenSCAD's text() has them.
//
// Flow of text_outlines():
//  1. find     the font that fontconfig finds by a name; a name is never the path of a file
//  2. load     the outline and the advance of each character, in units of the font, with FreeType
//  3. place    the characters one after the other, with the kerning of the font's table `kern`
//  4. divide   each curve into chords, and scale and move the outlines to their place
//
// Sizes are the same as in OpenSCAD: a text of size s has an em of s * 100 / 72, and the characters
// are moved by 1000 / 1024 of their advances. Ligatures and other substitutions are not made.
// Cost: O(n) for n points of outlines, and the search for the font.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "plumb/base/context.h"

namespace plumb {

/// Where the next character of a text comes.
enum class TextDirection : std::uint8_t { Right, Left, Down, Up };

/// The parameters of text().
struct TextRequest {
  std::string text = {};  ///< In UTF-8.
  std::string font = {};  ///< A name, which can have a style: "Liberation Sans:style=Bold".
  /// Left and Up set the characters in reverse order, to the right and downwards, as OpenSCAD does.
  TextDirection direction = TextDirection::Right;
  double size = 10;
  double spacing = 1;               ///< Multiplies the advance of each character.
  std::string halign = "left";      ///< left, center or right; other values count as left.
  std::string valign = "baseline";  ///< baseline, top, center, bottom; others count as baseline.
  std::uint32_t chords = 4;         ///< The number of chords of each curve of an outline.
};

/// The outline of a character: closed paths. A point belongs to the character if it lies inside an
/// odd number of paths.
struct GlyphOutline {
  std::vector<std::array<double, 2>> points;  ///< The points of all paths.
  std::vector<std::uint32_t> path_sizes;      ///< The number of points of each path.
};

/// The characters of a text. Characters without an outline, such as blanks, are left out.
struct TextOutlines {
  std::vector<GlyphOutline> glyphs;
  std::string family;    ///< The name of the font that was used.
  bool is_named = true;  ///< Whether the font has the requested name, or none was requested.
};

/// The greatest number of bytes of a text.
inline constexpr std::size_t kMostTextBytes = 1U << 14U;

/// Returns the outlines of a text. Throws Error{Syntax} if the text is not valid UTF-8,
/// Error{ResourceLimit} if it is longer than kMostTextBytes, Error{UnknownFormat} if no font with
/// outlines is found or if plumb was built without FreeType and fontconfig, and the errors of the
/// Context.
TextOutlines text_outlines(const TextRequest& request, Context& context);

}  // namespace plumb
