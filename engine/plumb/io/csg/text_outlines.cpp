// Calls of FreeType and of fontconfig.
//
// Outlines are loaded in units of the font, so no hinting depends on a resolution and every
// coordinate is an integer until it is scaled. OpenSCAD loads them at 2170 pixels an em; it rounds
// the greatest height and depth of a text away from zero to such pixels before it aligns the text,
// and so does this file. A font is found by a pattern of fontconfig from which the name of a file
// is removed.
//
// Without PLUMB_WITH_TEXT this file has only the message of its error.
// Tested by tests/io/text_outlines_test.cpp.
#include "plumb/io/csg/text_outlines.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <utility>

#include "plumb/io/text/input_cursors.h"
#include "plumb/predicates/error.h"

#ifdef PLUMB_WITH_TEXT
#include <fontconfig/fontconfig.h>
#include <ft2build.h>
#include FT_FREETYPE_H
#include FT_OUTLINE_H
#endif

namespace plumb {

#ifdef PLUMB_WITH_TEXT

namespace {

constexpr double kEmOfSize = 100.0 / 72.0;
constexpr double kAdvanceScale = 1000.0 / 1024.0;
// The number of pixels in a size of 1. Heights are rounded to whole pixels.
constexpr double kPixelsOfSize = 1600;

template <class T, void (*destroy)(T*)>
struct Destroyer {
  void operator()(T* object) const { destroy(object); }
};
using Pattern = std::unique_ptr<FcPattern, Destroyer<FcPattern, FcPatternDestroy>>;
using Config = std::unique_ptr<FcConfig, Destroyer<FcConfig, FcConfigDestroy>>;

struct FaceDestroyer {
  void operator()(FT_Face face) const { FT_Done_Face(face); }
};
struct LibraryDestroyer {
  void operator()(FT_Library library) const { FT_Done_FreeType(library); }
};
using Face = std::unique_ptr<FT_FaceRec_, FaceDestroyer>;
using Library = std::unique_ptr<FT_LibraryRec_, LibraryDestroyer>;

[[noreturn]] void fail_without_font(const std::string& name) {
  throw Error(ErrorCode::UnknownFormat,
              "text() finds no font with outlines for the name " + plumb::quoted(name));
}

const FcChar8* bytes_of(const std::string& text) {
  return reinterpret_cast<const FcChar8*>(text.c_str());
}

/// A font that is installed.
struct FontFile {
  std::string path;
  int index = 0;
  std::string family;
  bool is_named = true;  // Whether one of the families of the font has the requested name.
};

std::string text_in(const Pattern& pattern, const char* object, int which = 0) {
  FcChar8* value = nullptr;
  if (FcPatternGetString(pattern.get(), object, which, &value) != FcResultMatch) return {};
  return reinterpret_cast<const char*>(value);
}

/// Whether one of the families of a font is the requested one.
bool has_family(const Pattern& font, const std::string& family) {
  for (int i = 0;; ++i) {
    const std::string other = text_in(font, FC_FAMILY, i);
    if (other.empty()) return false;
    if (FcStrCmpIgnoreCase(bytes_of(other), bytes_of(family)) == 0) return true;
  }
}

/// The installed fonts. The configuration is separate, because the configuration of the process
/// belongs to the program that uses plumb.
FcConfig* installed_fonts() {
  static const Config config(FcInitLoadConfigAndFonts());
  return config.get();
}

/// Performs step 1 of the main flow.
FontFile find_font(const std::string& name) {
  const Pattern pattern(FcNameParse(bytes_of(name.empty() ? "Liberation Sans" : name)));
  if (!pattern) fail_without_font(name);
  FcPatternDel(pattern.get(), FC_FILE);
  FcPatternDel(pattern.get(), FC_SCALABLE);
  FcPatternAddBool(pattern.get(), FC_SCALABLE, FcTrue);
  const std::string family = text_in(pattern, FC_FAMILY);
  FcConfigSubstitute(installed_fonts(), pattern.get(), FcMatchPattern);
  FcDefaultSubstitute(pattern.get());
  FcResult result = FcResultNoMatch;
  const Pattern found(FcFontMatch(installed_fonts(), pattern.get(), &result));
  if (!found) fail_without_font(name);
  FontFile font{text_in(found, FC_FILE), 0, text_in(found, FC_FAMILY),
                family.empty() || has_family(found, family)};
  FcPatternGetInteger(found.get(), FC_INDEX, 0, &font.index);
  if (font.path.empty()) fail_without_font(name);
  return font;
}

/// Returns the characters of a text in UTF-8.
std::vector<char32_t> characters_of(const std::string& text) {
  std::vector<char32_t> characters;
  const FcChar8* at = bytes_of(text);
  int left = static_cast<int>(text.size());
  while (left > 0) {
    FcChar32 character = 0;
    const int length = FcUtf8ToUcs4(at, &character, left);
    if (length <= 0 || character > 0x10ffff || (character >= 0xd800 && character < 0xe000)) {
      throw Error(ErrorCode::Syntax, "the text of text() is not valid UTF-8");
    }
    characters.push_back(static_cast<char32_t>(character));
    at += length;
    left -= length;
  }
  return characters;
}

/// Collects the points of an outline as FreeType passes them, in units of the font.
class OutlinePen {
 public:
  explicit OutlinePen(std::uint32_t chords) : chords_(chords) {}

  GlyphOutline draw(FT_Outline& outline) {
    FT_Outline_Funcs calls{};
    calls.move_to = [](const FT_Vector* to, void* pen) { return pen_of(pen).begin(*to); };
    calls.line_to = [](const FT_Vector* to, void* pen) { return pen_of(pen).add(point(*to)); };
    calls.conic_to = [](const FT_Vector* control, const FT_Vector* to, void* pen) {
      const Point c = point(*control);
      return pen_of(pen).curve({pen_of(pen).last(), c, c, point(*to)}, false);
    };
    calls.cubic_to = [](const FT_Vector* c, const FT_Vector* d, const FT_Vector* to, void* pen) {
      return pen_of(pen).curve({pen_of(pen).last(), point(*c), point(*d), point(*to)}, true);
    };
    FT_Outline_Decompose(&outline, &calls, this);
    end_path();
    return std::move(glyph_);
  }

 private:
  using Point = std::array<double, 2>;

  static OutlinePen& pen_of(void* pen) { return *static_cast<OutlinePen*>(pen); }
  static Point point(const FT_Vector& v) {
    return {static_cast<double>(v.x), static_cast<double>(v.y)};
  }
  Point last() const { return glyph_.points.back(); }

  int begin(const FT_Vector& to) {
    end_path();
    first_ = glyph_.points.size();
    return add(point(to));
  }
  int add(const Point& p) {
    glyph_.points.push_back(p);
    return 0;
  }

  /// Adds the ends of the chords of a curve of degree 2 or 3.
  int curve(const std::array<Point, 4>& p, bool is_cubic) {
    for (std::uint32_t i = 1; i <= chords_; ++i) {
      const double t = static_cast<double>(i) / chords_, s = 1 - t;
      const std::array<double, 4> weight =
          is_cubic ? std::array{s * s * s, 3 * s * s * t, 3 * s * t * t, t * t * t}
                   : std::array{s * s, 2 * s * t, 0.0, t * t};
      Point at{0, 0};
      for (std::size_t k = 0; k < 4; ++k) {
        for (std::size_t axis = 0; axis < 2; ++axis) at[axis] += weight[k] * p[k][axis];
      }
      add(at);
    }
    return 0;
  }

  /// Removes the last point of a path if it equals the first point, and removes paths without an
  /// interior.
  void end_path() {
    std::vector<Point>& points = glyph_.points;
    if (points.size() > first_ + 1 && points.back() == points[first_]) points.pop_back();
    if (points.size() < first_ + 3) {
      points.resize(first_);
    } else {
      glyph_.path_sizes.push_back(static_cast<std::uint32_t>(points.size() - first_));
    }
    first_ = points.size();
  }

  std::uint32_t chords_;
  GlyphOutline glyph_;
  std::size_t first_ = 0;  // The first point of the path.
};

/// Performs steps 2 to 4 of the main flow.
class TextSetter {
 public:
  TextSetter(FT_Face face, const TextRequest& request, Context& context)
      : face_(face), request_(request), context_(context), memory_(context) {}

  std::vector<GlyphOutline> run() {
    unit_ = request_.size * kEmOfSize / face_->units_per_EM;
    std::vector<char32_t> characters = characters_of(request_.text);
    const TextDirection direction = request_.direction;
    is_vertical_ = direction == TextDirection::Down || direction == TextDirection::Up;
    const bool is_turned = direction == TextDirection::Left || direction == TextDirection::Up;
    if (is_turned) reverse_characters(characters);
    for (const char32_t character : characters) set(character);
    const double dx = shift_along(), dy = shift_across();
    for (GlyphOutline& glyph : glyphs_) {
      for (auto& p : glyph.points) p = {p[0] + dx, p[1] + dy};
    }
    return std::move(glyphs_);
  }

 private:
  /// Reverses the characters, but not a character and the combining marks after it.
  static void reverse_characters(std::vector<char32_t>& characters) {
    const auto is_mark = [](char32_t c) { return c >= 0x300 && c < 0x370; };
    std::reverse(characters.begin(), characters.end());
    for (auto first = characters.begin(); first != characters.end();) {
      const auto base = std::find_if_not(first, characters.end(), is_mark);
      const auto end = base == characters.end() ? base : base + 1;
      std::reverse(first, end);
      first = end;
    }
  }

  void set(char32_t character) {
    context_.checkpoint("text", 0, 1);
    const FT_UInt index = FT_Get_Char_Index(face_, character);
    if (FT_Load_Glyph(face_, index, FT_LOAD_NO_SCALE) != 0) return;
    FT_GlyphSlot slot = face_->glyph;
    if (is_vertical_) return set_below(*slot);
    x_ += kerning_before(index) * unit_ * kAdvanceScale * request_.spacing;
    if (slot->format == FT_GLYPH_FORMAT_OUTLINE && slot->outline.n_points > 0) add(slot->outline);
    x_ += static_cast<double>(slot->advance.x) * unit_ * kAdvanceScale * request_.spacing;
    last_ = index;
  }

  /// Adds a character below the ones before. Its middle comes to x = 0, and its highest place to
  /// where the character before ends.
  void set_below(FT_GlyphSlotRec& slot) {
    const FT_Glyph_Metrics& m = slot.metrics;
    x_ = static_cast<double>(m.vertBearingX - m.horiBearingX) * unit_ * kAdvanceScale;
    const double top = static_cast<double>(m.horiBearingY + m.vertBearingY);
    const double end = y_;
    y_ -= top * unit_ * kAdvanceScale;
    if (slot.format == FT_GLYPH_FORMAT_OUTLINE && slot.outline.n_points > 0) add(slot.outline);
    y_ = end - static_cast<double>(m.vertAdvance) * unit_ * kAdvanceScale * request_.spacing;
  }

  void add(FT_Outline& outline) {
    FT_BBox box{};
    FT_Outline_Get_CBox(&outline, &box);
    highest_ = std::max(highest_, static_cast<double>(box.yMax));
    lowest_ = std::min(lowest_, static_cast<double>(box.yMin));
    widest_ = std::max(widest_, rounded_up(static_cast<double>(box.xMax)) +
                                    rounded_up(-static_cast<double>(box.xMin)));
    GlyphOutline glyph = OutlinePen(request_.chords).draw(outline);
    if (glyph.path_sizes.empty()) return;
    memory_.add(sizeof(glyph) + glyph.points.size() * sizeof(glyph.points[0]), "a text");
    for (auto& p : glyph.points) p = {p[0] * unit_ + x_, p[1] * unit_ + y_};
    glyphs_.push_back(std::move(glyph));
  }

  double kerning_before(FT_UInt index) {
    if (!last_ || !FT_HAS_KERNING(face_)) return 0;
    FT_Vector by{};
    FT_Get_Kerning(face_, *last_, index, FT_KERNING_UNSCALED, &by);
    return static_cast<double>(by.x);
  }

  double shift_along() const {
    const double width = is_vertical_ ? widest_ : x_;
    if (request_.halign == "right") return -width;
    return request_.halign == "center" ? -width / 2 : 0;
  }
  double shift_across() const {
    // As in OpenSCAD, `top` and `center` of a vertical text are its end and its middle.
    const double height = is_vertical_ ? y_ : rounded_up(highest_);
    const double depth = is_vertical_ ? 0 : rounded_up(-lowest_);
    if (request_.valign == "top") return -height;
    if (request_.valign == "bottom") return depth;
    return request_.valign == "center" ? (depth - height) / 2 : 0;
  }
  /// Returns a length in units of the font as OpenSCAD computes it, in whole pixels.
  double rounded_up(double units) const {
    const double pixels = units * kEmOfSize / face_->units_per_EM * (kPixelsOfSize * kAdvanceScale);
    return std::ceil(pixels) / kPixelsOfSize * request_.size;
  }

  FT_Face face_;
  const TextRequest& request_;
  Context& context_;
  MemoryCharge memory_;
  double unit_ = 0;  // The length of a unit of the font.
  bool is_vertical_ = false;
  double x_ = 0, y_ = 0;             // The place of the next character.
  double widest_ = 0;                // The greatest width of a character.
  double highest_ = 0, lowest_ = 0;  // For all characters, in units of the font.
  std::optional<FT_UInt> last_;      // The previous character.
  std::vector<GlyphOutline> glyphs_;
};

}  // namespace

TextOutlines text_outlines(const TextRequest& request, Context& context) {
  if (request.text.size() > kMostTextBytes) {
    throw Error(ErrorCode::ResourceLimit,
                "a text has at most " + std::to_string(kMostTextBytes) + " bytes");
  }
  const FontFile font = find_font(request.font);
  FT_Library opened = nullptr;
  if (FT_Init_FreeType(&opened) != 0) fail_without_font(request.font);
  const Library library(opened);
  FT_Face face = nullptr;
  if (FT_New_Face(library.get(), font.path.c_str(), font.index, &face) != 0) {
    fail_without_font(request.font);
  }
  const Face owner(face);
  if (!FT_IS_SCALABLE(face) || face->units_per_EM == 0) fail_without_font(request.font);
  return {TextSetter(face, request, context).run(), font.family, font.is_named};
}

#else

TextOutlines text_outlines(const TextRequest&, Context&) {
  throw Error(ErrorCode::UnknownFormat,
              "text() needs FreeType and fontconfig, and plumb was built without them (Debian: "
              "libfreetype-dev, libfontconfig-dev)");
}

#endif

}  // namespace plumb
