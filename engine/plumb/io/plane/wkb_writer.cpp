// Writing of well-known binary: little-endian, with the codes of ISO and OGC, two coordinates.
// Tested by tests/io/wkb_test.cpp and tests/system/shapely_test.py.
#include <cstdint>
#include <ostream>
#include <span>

#include "plumb/io/plane/wkb.h"
#include "plumb/io/text/text_output.h"

namespace plumb {
namespace {

constexpr std::uint32_t kWkbPoint = 1, kWkbLine = 2, kWkbPolygon = 3, kWkbCollection = 7;
// The difference between the code of a shape and the code of several shapes.
constexpr std::uint32_t kWkbMultiple = 3;

class WkbWriter {
 public:
  WkbWriter(std::ostream& out, const PlaneShapes& shapes, Context& context)
      : out_(out, context), shapes_(shapes) {}

  /// If all shapes are of one kind, writes a geometry of this kind; otherwise, a collection of
  /// geometries.
  void write() {
    const std::uint32_t kinds = (shapes_.polygon_count() > 0 ? 1U : 0U) +
                                (shapes_.line_count() > 0 ? 1U : 0U) +
                                (shapes_.single_points.empty() ? 0U : 1U);
    if (kinds != 1) begin(kWkbCollection, kinds);
    write_kind(kWkbPolygon, shapes_.polygon_count(), [this](std::size_t p) { polygon(p); });
    write_kind(kWkbLine, shapes_.line_count(),
               [this](std::size_t l) { positions(shapes_.line(l), /*is_ring=*/false); });
    write_kind(kWkbPoint, shapes_.single_points.size(),
               [this](std::size_t i) { position(shapes_.single_points[i]); });
    out_.flush();
  }

 private:
  void head(std::uint32_t code) {
    out_ << '\1';
    put_little_endian(out_, code);
  }
  void begin(std::uint32_t code, std::size_t count) {
    head(code);
    put_little_endian(out_, static_cast<std::uint32_t>(count));
  }
  /// Writes one geometry with all shapes of a kind: a single shape, or several shapes.
  template <class Shape>
  void write_kind(std::uint32_t code, std::size_t count, const Shape& shape) {
    if (count > 1) begin(code + kWkbMultiple, count);
    for (std::size_t i = 0; i < count; ++i) {
      head(code);
      shape(i);
    }
  }
  void polygon(std::size_t p) {
    const std::uint32_t first = shapes_.polygon_begin[p], last = shapes_.polygon_begin[p + 1];
    put_little_endian(out_, last - first);
    for (std::uint32_t r = first; r < last; ++r) positions(shapes_.ring(r), /*is_ring=*/true);
  }
  /// Writes a chain. A ring is written with its first position again at the end.
  void positions(std::span<const std::uint32_t> chain, bool is_ring) {
    put_little_endian(out_, static_cast<std::uint32_t>(chain.size() + (is_ring ? 1 : 0)));
    for (const std::uint32_t i : chain) position(i);
    if (is_ring) position(chain.front());
  }
  void position(std::uint32_t i) {
    const Point2 p = shapes_.points.approx(i);
    put_little_endian(out_, p.x);
    put_little_endian(out_, p.y);
  }

  TextOutput out_;
  const PlaneShapes& shapes_;
};

}  // namespace

void write_wkb(std::ostream& out, const PlaneShapes& shapes, Context& context) {
  WkbWriter(out, shapes, context).write();
}

}  // namespace plumb
