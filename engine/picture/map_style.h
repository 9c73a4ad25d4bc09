// How maps and their defects look: one colour and one shape for each kind, told apart also by
// readers who do not see colours.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "plumb/picture/picture.h"
#include "plumb/plane/map_check.h"

namespace plumb {

struct DefectStyle {
  DefectKind kind;
  const char* name;
  const char* meaning;
  const char* colour;           ///< dark enough for white text on it
  std::vector<Point2> outline;  ///< of the symbol, within [-1, 1]; y downwards
};

/// All kinds, in the order of the enumeration.
const std::vector<DefectStyle>& defect_styles();
const DefectStyle& style_of(DefectKind kind);

/// The filled symbol of a kind, `radius` picture units large.
std::string symbol(const DefectStyle& style, Point2 at, double radius);

inline constexpr std::size_t kTints = 9;
const char* tint(std::size_t colour);

/// The first of `count` colours from `wish` on, cyclically, that is not taken (bit c: colour c);
/// `wish` itself when all are.
std::uint8_t free_colour(std::uint32_t taken, std::size_t wish, std::size_t count);

inline constexpr const char* kInk = "#1f2933";
inline constexpr const char* kQuietInk = "#5b6672";
inline constexpr const char* kPaper = "#ffffff";
inline constexpr const char* kEdgeInk = "#76808c";
inline constexpr const char* kMixedInk = "#2b2f36";  // labels of several kinds at once

/// A tint (0 .. kTints - 1) for each listed cycle; cycles with a common edge get different ones as
/// long as nine suffice in the order of the listing. O(corners).
std::vector<std::uint8_t> colour_cycles(const Map& map);

}  // namespace plumb
