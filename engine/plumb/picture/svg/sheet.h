// The page around every picture (title, badge, a line of facts, legend, notes), and the style of
// maps and defects. What lies between is drawn by the caller, from the height y() on.
#pragma once

#include <cstdint>
#include <ostream>
#include <sstream>
#include <string>
#include <vector>

#include "plumb/picture/svg/svg_text.h"
#include "plumb/plane/map_check.h"

namespace plumb {

/// Size of a page.
struct SheetOptions {
  double width = 1000;    ///< Picture units.
  double text_scale = 1;  ///< 1 means body text of 17 picture units.
};

/// A few words on a coloured ground.
struct Badge {
  std::string text;
  const char* colour;  ///< Dark enough for white text on it.
};
inline constexpr const char* kGoodBadge = "#00705a";
inline constexpr const char* kBadBadge = "#a32020";
inline constexpr const char* kPlainBadge = "#3d4b59";

/// A page that grows downwards.
class Sheet {
 public:
  static constexpr double kMargin = 24;

  explicit Sheet(SheetOptions options) : options_(options) {}

  double width() const { return options_.width; }
  double column() const { return options_.width - 2 * kMargin; }
  double right() const { return options_.width - kMargin; }
  /// Returns the height of a text that is `size` units high on an unscaled sheet.
  double text(double size) const { return size * options_.text_scale; }

  double y() const { return y_; }
  void set_y(double y) { y_ = y; }
  void move_down(double by) { y_ += by; }
  std::ostream& body() { return body_; }

  /// Writes title, badge and facts.
  void write_header(const std::string& title, const Badge& badge, const std::string& facts);
  /// Writes one line of text at the current height.
  void write_line(const char* css, double x, const std::string& text);
  /// Opens a <g> that shows the inside of `frame` only; close it with </g>.
  void begin_clip(const Rectangle& frame);
  /// Writes an entry of the legend; `symbol` is drawn around (0, 0). Two entries stand side by side
  /// if the page is wide enough.
  void write_item(const std::string& symbol, const std::string& name, const std::string& meaning);
  void end_legend();
  /// Keeps a note for the end of the page.
  void note(const std::string& text) { notes_.push_back(text); }

  /// Writes the file; `style` holds further CSS rules. Notes come last.
  void write(std::ostream& out, const std::string& heading, const std::string& style);

 private:
  void write_badge(const Badge& badge);
  std::string common_style() const;

  SheetOptions options_;
  std::ostringstream body_;
  std::vector<std::string> notes_;
  std::size_t clips_ = 0;
  std::size_t items_ = 0;
  double y_ = kMargin;
};

/// Returns "1 edge", "2 edges", "0 vertices".
std::string counted(std::uint64_t n, const std::string& one, const std::string& many = "");

// The look of maps and their defects: one colour and one shape for each kind, so that readers who
// do not see colours can distinguish them as well.

/// The look of one kind of defect.
struct DefectStyle {
  DefectKind kind;
  const char* name;
  const char* meaning;
  const char* colour;           ///< Dark enough for white text on it.
  std::vector<Point2> outline;  ///< Outline of the symbol, within [-1, 1]; y downwards.
};

/// Returns the styles of all kinds, in the order of the enumeration.
const std::vector<DefectStyle>& defect_styles();
const DefectStyle& style_of(DefectKind kind);

/// Returns the filled symbol of a kind, `radius` picture units large.
std::string symbol(const DefectStyle& style, Point2 at, double radius);

inline constexpr std::size_t kTints = 9;
const char* tint(std::size_t colour);

/// Returns the first of `count` colours from `wish` on, cyclically, that is not taken (bit c stands
/// for colour c); `wish` itself if all are.
std::uint8_t free_colour(std::uint32_t taken, std::size_t wish, std::size_t count);

inline constexpr const char* kInk = "#1f2933";
inline constexpr const char* kQuietInk = "#5b6672";
inline constexpr const char* kPaper = "#ffffff";
inline constexpr const char* kEdgeInk = "#76808c";
inline constexpr const char* kMixedInk = "#2b2f36";  // For labels of several kinds at once.

/// Returns a tint (0 .. kTints - 1) for each listed cycle; cycles with a common edge get different
/// tints, if nine tints suffice in the order of the listing. Cost: O(corners).
std::vector<std::uint8_t> colour_cycles(const Map& map);

}  // namespace plumb
