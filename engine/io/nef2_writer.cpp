#include "plumb/io/nef2_writer.h"

#include <cmath>
#include <cstdint>

#include "plumb/io/text_output.h"

namespace plumb {
namespace {

class Nef2Writer {
 public:
  Nef2Writer(std::ostream& stream, const PlaneComplex& complex, Context& context)
      : out_(stream, context), complex_(complex) {}

  void write() {
    write_header();
    for (std::uint32_t i = 0; i < complex_.points.inputs.size(); ++i) write_point(i);
    for (const Crossing2& c : complex_.points.crossings) {
      write_line(c.a + 1, c.b + 1, c.c + 1, c.d + 1);
    }
    for (std::uint32_t i = 0; i < complex_.vertex_count(); ++i) {
      const PlaneRecords::Vertex v = record_of(complex_, VertexId(i));
      write_line(v.point + 1, mark(v.mark));
    }
    for (std::uint32_t i = 0; i < complex_.edge_count(); ++i) {
      const PlaneRecords::Edge e = record_of(complex_, EdgeId(i));
      write_line(end(e.from), end(e.to), e.line.a + 1, e.line.b + 1, mark(e.mark), mark(e.left),
                 mark(e.right));
    }
    out_.flush();
  }

 private:
  void write_header() {
    out_ << "plumb-nef2 1\n";
    write_line(complex_.points.inputs.size(), complex_.points.crossings.size(),
               complex_.vertex_count(), complex_.edge_count(), mark(complex_.mark(FaceId(0))));
  }

  void write_point(std::uint32_t i) {
    const PointTable2& points = complex_.points.inputs;
    const Point2 p = points.approx(i);
    if (points.is_double(i) && is_short_integer(p.x) && is_short_integer(p.y)) {
      out_ << p.x << ' ' << p.y << '\n';
      return;
    }
    const RationalPoint2 exact = points.exact(i);
    out_ << format_exact(exact.x) << ' ' << format_exact(exact.y) << '\n';
  }

  /// Numbers that format_double() writes as integers.
  static bool is_short_integer(double value) {
    return std::fabs(value) < 0x1p53 && std::trunc(value) == value;
  }
  static std::uint64_t mark(bool marked) { return marked ? 1 : 0; }
  static std::uint64_t end(std::uint32_t vertex) {
    return vertex == PlaneRecords::kUnbounded ? 0 : std::uint64_t{vertex} + 1;
  }

  template <class... Rest>
  void write_line(std::uint64_t first, Rest... rest) {
    out_ << first;
    ((out_ << ' ' << std::uint64_t{rest}), ...);
    out_ << '\n';
  }

  TextOutput out_;
  const PlaneComplex& complex_;
};

}  // namespace

void write_nef2(std::ostream& out, const PlaneComplex& complex, Context& context) {
  Nef2Writer(out, complex, context).write();
}

}  // namespace plumb
