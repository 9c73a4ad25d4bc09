#include "plumb/picture/scene/stroke_font.h"

#include <array>
#include <cstddef>

namespace plumb {
namespace {

constexpr double kHeight = 6, kAdvance = 5.8, kGap = 1.8;
constexpr double kSmall = .78;  // A part of the height of a capital letter.

/// Polylines on a grid that is 4 wide and 6 high, with y upwards. The format is "xy xy ..", with a
/// bar between polylines.
struct Glyph {
  char letter;
  std::string_view path;
};

constexpr std::array kGlyphs{
    Glyph{'0', "10 01 05 16 36 45 41 30 10|12 34"},
    Glyph{'1', "04 26 20|00 40"},
    Glyph{'2', "05 16 36 45 44 00 40"},
    Glyph{'3', "05 16 36 45 44 33 13|33 42 41 30 10 01"},
    Glyph{'4', "30 36 02 42"},
    Glyph{'5', "46 06 03 33 42 41 30 10 01"},
    Glyph{'6', "45 36 16 05 01 10 30 41 42 33 13 02"},
    Glyph{'7', "06 46 10"},
    Glyph{'8', "13 04 05 16 36 45 44 33 13 02 01 10 30 41 42 33"},
    Glyph{'9', "01 10 30 41 45 36 16 05 04 13 33 44"},
    Glyph{'A', "00 26 40|12 32"},
    Glyph{'B', "00 06 36 45 44 33 03|33 42 41 30 00"},
    Glyph{'C', "45 36 16 05 01 10 30 41"},
    Glyph{'D', "00 06 26 44 42 20 00"},
    Glyph{'E', "46 06 00 40|03 33"},
    Glyph{'F', "46 06 00|03 33"},
    Glyph{'G', "45 36 16 05 01 10 30 41 43 23"},
    Glyph{'H', "00 06|40 46|03 43"},
    Glyph{'I', "10 30|20 26|16 36"},
    Glyph{'J', "01 10 20 31 36"},
    Glyph{'K', "00 06|46 03 40"},
    Glyph{'L', "06 00 40"},
    Glyph{'M', "00 06 23 46 40"},
    Glyph{'N', "00 06 40 46"},
    Glyph{'O', "10 01 05 16 36 45 41 30 10"},
    Glyph{'P', "00 06 36 45 44 33 03"},
    Glyph{'Q', "10 01 05 16 36 45 41 30 10|22 40"},
    Glyph{'R', "00 06 36 45 44 33 03|23 40"},
    Glyph{'S', "45 36 16 05 04 13 33 42 41 30 10 01"},
    Glyph{'T', "06 46|26 20"},
    Glyph{'U', "06 01 10 30 41 46"},
    Glyph{'V', "06 20 46"},
    Glyph{'W', "06 10 24 30 46"},
    Glyph{'X', "00 46|06 40"},
    Glyph{'Y', "06 23 46|23 20"},
    Glyph{'Z', "06 46 00 40"},
    Glyph{'+', "03 43|21 25"},
    Glyph{'-', "03 43"},
    Glyph{'.', "20 20"},
    Glyph{',', "21 10"},
    Glyph{'(', "36 24 22 30"},
    Glyph{')', "16 24 22 10"},
    Glyph{'/', "00 46"},
    Glyph{':', "21 21|24 24"},
    Glyph{'=', "02 42|04 44"},
    Glyph{'*', "12 34|14 32|03 43"},
    Glyph{'!', "26 22|20 20"},
    Glyph{'^', "14 26 34"},
    Glyph{'_', "00 40"},
};

bool is_small(char c) { return 'a' <= c && c <= 'z'; }

std::string_view path_of(char c) {
  const char letter = is_small(c) ? static_cast<char>(c - 'a' + 'A') : c;
  for (const Glyph& glyph : kGlyphs) {
    if (glyph.letter == letter) return glyph.path;
  }
  return {};
}

}  // namespace

double stroked_width(std::string_view text) {
  double width = 0;
  for (const char c : text) width += kAdvance * (is_small(c) ? kSmall : 1);
  return text.empty() ? 0 : (width - kGap) / kHeight;
}

std::vector<TextStroke> strokes_of(std::string_view text) {
  std::vector<TextStroke> strokes;
  double left = -stroked_width(text) / 2;
  for (const char c : text) {
    const double scale = (is_small(c) ? kSmall : 1) / kHeight;
    const std::string_view path = path_of(c);
    const auto corner = [&](std::size_t i) {
      return Point2{left + scale * (path[i] - '0'), .5 - scale * (path[i + 1] - '0')};
    };
    for (std::size_t i = 0; i + 4 < path.size(); i += 3) {
      if (path[i + 2] == ' ') strokes.push_back({corner(i), corner(i + 3)});
    }
    left += kAdvance * scale;
  }
  return strokes;
}

}  // namespace plumb
