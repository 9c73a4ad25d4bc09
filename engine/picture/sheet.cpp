#include "plumb/picture/sheet.h"

#include "plumb/picture/map_style.h"
#include "plumb/picture/svg_text.h"

namespace plumb {
namespace {

constexpr double kTitleSize = 30;
constexpr double kBold = 1.15;  // how much wider bold letters may be
constexpr double kBadgeSize = 22;
constexpr double kFactsSize = 17;
constexpr double kNoteSize = 15;
constexpr double kLine = 23;         // between the lines of a text of size 17
constexpr double kTwoColumns = 900;  // least width, unscaled text

}  // namespace

std::string counted(std::uint64_t n, const std::string& one, const std::string& many) {
  return std::to_string(n) + " " + (n == 1 ? one : many.empty() ? one + "s" : many);
}

void Sheet::write_line(const char* css, double x, const std::string& text) {
  body_ << "<text class=\"" << css << "\" x=\"" << svg_number(x) << "\" y=\"" << svg_number(y_)
        << "\">" << xml_escaped(text) << "</text>\n";
}

void Sheet::write_badge(const Badge& badge) {
  const double width = text_width(badge.text, text(kBadgeSize)) + text(36);
  const Rectangle box = {kMargin, y_, kMargin + width, y_ + text(40)};
  body_ << "<rect " << svg_box(box) << " rx=\"8\" fill=\"" << badge.colour
        << "\"/><text class=\"verdict\" x=\"" << svg_number(box.centre().x) << "\" y=\""
        << svg_number(y_ + text(28)) << "\">" << xml_escaped(badge.text) << "</text>\n";
}

/// The facts stand beside the badge where they fit, else below it.
void Sheet::write_header(const std::string& title, const Badge& badge, const std::string& facts) {
  for (const std::string& line : wrapped(title, text(kBold * kTitleSize), column(), 2)) {
    y_ += text(kTitleSize - 2);
    write_line("title", kMargin, line);
    y_ += text(6);
  }
  y_ += text(12);
  write_badge(badge);
  const double beside = kMargin + text_width(badge.text, text(kBadgeSize)) + text(54);
  if (beside + text_width(facts, text(kFactsSize)) <= right()) {
    y_ += text(27);
    write_line("sub", beside, facts);
  } else {
    y_ += text(45);
    for (const std::string& line : wrapped(facts, text(kFactsSize), column(), 4)) {
      y_ += text(kLine);
      write_line("sub", kMargin, line);
    }
    y_ -= text(10);
  }
  y_ += text(30);
}

void Sheet::begin_clip(const Rectangle& frame) {
  ++clips_;
  body_ << "<clipPath id=\"c" << clips_ << "\"><rect " << svg_box(frame)
        << "/></clipPath><g clip-path=\"url(#c" << clips_ << ")\">\n";
}

void Sheet::write_item(const std::string& symbol, const std::string& name,
                       const std::string& meaning) {
  const bool has_columns = options_.width / options_.text_scale >= kTwoColumns;
  const bool is_right = has_columns && items_ % 2 != 0;
  if (!is_right) y_ += text(kLine + 3);
  const double x = kMargin + (is_right ? column() / 2 : 0);
  ++items_;
  body_ << "<g transform=\"translate(" << svg_number(x + text(10)) << ' '
        << svg_number(y_ - text(6)) << ")\">" << symbol << "</g><text x=\""
        << svg_number(x + text(30)) << "\" y=\"" << svg_number(y_) << "\"><tspan class=\"kind\">"
        << xml_escaped(name) << "</tspan> <tspan class=\"sub\">" << xml_escaped(meaning)
        << "</tspan></text>\n";
}

void Sheet::end_legend() { y_ += items_ > 0 ? text(14) : 0; }

std::string Sheet::common_style() const {
  const auto size = [this](double n) { return svg_number(text(n)) + "px"; };
  return R"(text{font-family:Helvetica,Arial,"Liberation Sans","DejaVu Sans",sans-serif;font-size:)" +
         size(kFactsSize) + ";fill:" + kInk + "}\n.title{font-size:" + size(kTitleSize) +
         ";font-weight:bold}\n.verdict{font-size:" + size(kBadgeSize) +
         ";font-weight:bold;fill:#fff;text-anchor:middle}\n.sub{fill:" + kQuietInk +
         "}\n.note{font-size:" + size(kNoteSize) + ";fill:" + kQuietInk +
         "}\n.kind{font-weight:bold}\n.panel{fill:none;stroke:#c3c9d0;stroke-width:1}\n";
}

void Sheet::write(std::ostream& out, const std::string& heading, const std::string& style) {
  for (const std::string& note : notes_) {
    for (const std::string& line : wrapped(note, text(kNoteSize), column(), 3)) {
      y_ += text(21);
      write_line("note", kMargin, line);
    }
  }
  const std::string width = svg_number(options_.width);
  const std::string height = svg_number(y_ + kMargin - 6);
  out << "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 " << width << ' ' << height
      << "\" width=\"" << width << "\" height=\"" << height << "\" role=\"img\">\n<title>"
      << xml_escaped(heading) << "</title>\n<style>\n"
      << common_style() << style << "</style>\n<rect width=\"" << width << "\" height=\"" << height
      << "\" fill=\"" << kPaper << "\"/>\n"
      << body_.str() << "</svg>\n";
}

}  // namespace plumb
