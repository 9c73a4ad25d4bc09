// Text and numbers for SVG: escaping, coordinates, line breaking, path data.
//
// Numbers are written as integers of tenths or hundredths and clamped far off the picture, so no
// coordinate is ever "nan" or "inf" and files stay short. Path data uses relative moves between
// rounded points; the differences are those of the rounded points, so rounding errors do not add up
// along a path. Input text may be any bytes: what is not UTF-8, or not allowed in XML, becomes
// U+FFFD.
// Tested by tests/picture/plane_view_test.cpp and tests/picture/map_svg_test.cpp.
#include "plumb/picture/svg/svg_text.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>

#include "plumb/io/text/input_cursors.h"

namespace plumb {
namespace {

constexpr double kFarOff = 100000;  // In picture units.
constexpr long kLeastStep = 3;      // In tenths of a picture unit.
constexpr std::string_view kReplacement = "\xEF\xBF\xBD";

/// Returns the bytes of the UTF-8 sequence at the beginning of `text`; 0 if there is none, or if
/// XML does not allow it.
std::size_t utf8_length(std::string_view text) {
  const auto lead = static_cast<unsigned char>(text[0]);
  if (lead < 0x80) return 1;
  const std::string_view sequence = text.substr(0, lead < 0xE0 ? 2 : lead < 0xF0 ? 3 : 4);
  // The characters are U+FFFE and U+FFFF.
  if (sequence == "\xEF\xBF\xBE" || sequence == "\xEF\xBF\xBF") return 0;
  return text_prefix(sequence) == sequence.size() ? sequence.size() : 0;
}

std::string_view entity(char c) {
  switch (c) {
    case '&':
      return "&amp;";
    case '<':
      return "&lt;";
    case '>':
      return "&gt;";
    case '"':
      return "&quot;";
    case '\'':
      return "&#39;";
    default:
      return {};
  }
}

long tenths(double value) { return std::lround(std::clamp(value, -kFarOff, kFarOff) * 10); }

void append_long(std::string& to, long value) {
  std::array<char, 24> buffer;
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value).ptr;
  to.append(buffer.data(), end);
}

}  // namespace

std::string xml_escaped(std::string_view text) {
  std::string out;
  while (!text.empty()) {
    const std::size_t length = utf8_length(text);
    const auto c = static_cast<unsigned char>(text[0]);
    if (length == 0 || (length == 1 && (c < 0x20 || c == 0x7F))) {
      out += kReplacement;
      text.remove_prefix(1);
      continue;
    }
    const std::string_view escaped = length == 1 ? entity(text[0]) : std::string_view();
    out += escaped.empty() ? text.substr(0, length) : escaped;
    text.remove_prefix(length);
  }
  return out;
}

std::string svg_number(double value) {
  if (std::isnan(value)) value = 0;
  const double rounded = std::round(std::clamp(value, -kFarOff, kFarOff) * 100) / 100 + 0.0;
  std::array<char, 32> buffer;
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), rounded).ptr;
  return {buffer.data(), end};
}

std::string svg_box(const Rectangle& r) {
  return "x=\"" + svg_number(r.left) + "\" y=\"" + svg_number(r.top) + "\" width=\"" +
         svg_number(r.width()) + "\" height=\"" + svg_number(r.height()) + "\"";
}

double text_width(std::string_view text, double font_size) {
  double ems = 0;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte >> 6U == 2) continue;  // The byte is inside of a code point.
    const bool is_narrow =
        std::string_view(" .,:;!|'il()[]-trfj").find(c) != std::string_view::npos;
    ems += is_narrow ? 0.38 : 0.62;
  }
  return ems * font_size;
}

std::vector<std::string> wrapped(std::string_view text, double font_size, double width,
                                 std::size_t max_lines) {
  std::vector<std::string> lines = {""};
  while (!text.empty()) {
    const std::size_t space = std::min(text.find(' '), text.size());
    const std::string word(text.substr(0, space));
    text.remove_prefix(std::min(space + 1, text.size()));
    std::string& line = lines.back();
    const std::string longer = line.empty() ? word : line + " " + word;
    if (line.empty() || text_width(longer, font_size) <= width) {
      line = longer;
    } else if (lines.size() < max_lines) {
      lines.push_back(word);
    } else {
      line += " \xE2\x80\xA6";
      break;
    }
  }
  for (std::string& line : lines) {  // A single word may be wider than the line.
    while (text_width(line, font_size) > width * 1.05) {
      while (line.size() > 1 && static_cast<unsigned char>(line.back()) >> 6U == 2) line.pop_back();
      line.pop_back();
    }
  }
  return lines;
}

void PathData::write(char command, Point2 p) {
  const long x = tenths(p.x), y = tenths(p.y);
  data_ += command;
  append_long(data_, x - last_x_);
  if (y - last_y_ >= 0) data_ += ' ';
  append_long(data_, y - last_y_);
  last_x_ = x;
  last_y_ = y;
  ++points_;
}

void PathData::move_to(Point2 p) {
  write('m', p);
  start_x_ = last_x_;
  start_y_ = last_y_;
}

void PathData::line_to(Point2 p) {
  if (std::abs(tenths(p.x) - last_x_) + std::abs(tenths(p.y) - last_y_) >= kLeastStep)
    write('l', p);
}

void PathData::close() {
  data_ += 'z';
  last_x_ = start_x_;
  last_y_ = start_y_;
}

std::string base64(std::string_view bytes) {
  static constexpr std::string_view kDigits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::size_t count = std::min<std::size_t>(3, bytes.size() - i);
    std::uint32_t group = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      group = group << 8U | (k < count ? static_cast<std::uint8_t>(bytes[i + k]) : 0U);
    }
    for (std::size_t k = 0; k < 4; ++k) {
      text += k <= count ? kDigits[group >> (18 - 6 * k) & 63U] : '=';
    }
  }
  return text;
}

}  // namespace plumb
