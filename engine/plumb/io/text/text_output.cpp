#include "plumb/io/text/text_output.h"

#include <charconv>
#include <cstring>

#include "plumb/predicates/rounding.h"

namespace plumb {
std::string format_exact(const Rational& value) { return exact_text(value); }

TextOutput::TextOutput(std::ostream& out)
    : out_(out), block_(std::make_unique_for_overwrite<char[]>(kBlock)) {}

TextOutput& TextOutput::operator<<(std::string_view text) {
  if (text.size() > kBlock) {
    flush();
    out_.write(text.data(), static_cast<std::streamsize>(text.size()));
    return *this;
  }
  std::memcpy(room(text.size()), text.data(), text.size());
  used_ += text.size();
  return *this;
}

TextOutput& TextOutput::operator<<(std::uint64_t value) {
  char* const to = room(kNumberBytes);
  used_ += static_cast<std::size_t>(std::to_chars(to, to + kNumberBytes, value).ptr - to);
  return *this;
}

TextOutput& TextOutput::operator<<(double value) {
  char* const to = room(kNumberBytes);
  used_ += static_cast<std::size_t>(put_double(to, value) - to);
  return *this;
}

void TextOutput::flush() {
  const std::size_t size = used_;
  used_ = 0;
  if (context_ != nullptr) context_->checkpoint("write", 0, 0);
  out_.write(block_.get(), static_cast<std::streamsize>(size));
}

void write_point(TextOutput& out, const PointTable2& points, std::uint32_t i) {
  if (points.is_double(i)) {
    const Point2 p = points.approx(i);
    out << p.x << ' ' << p.y;
    return;
  }
  const RationalPoint2 p = points.exact(i);
  out << format_exact(p.x) << ' ' << format_exact(p.y);
}

}  // namespace plumb
