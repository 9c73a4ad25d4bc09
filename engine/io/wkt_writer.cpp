#include "plumb/io/wkt_writer.h"

#include <algorithm>
#include <string>

#include "plumb/io/shape_writer.h"

namespace plumb {
namespace {

char upper(char c) { return 'a' <= c && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; }

class WktWriter : public ShapeWriter {
 public:
  WktWriter(std::ostream& out, const PlaneShapes& shapes, Context& context)
      : ShapeWriter(out, shapes, {'(', ", ", ')'}, context) {}

 private:
  void begin_collection(bool is_empty) override {
    out_ << (is_empty ? "GEOMETRYCOLLECTION EMPTY" : "GEOMETRYCOLLECTION (");
  }
  void end_collection(bool is_empty) override {
    if (!is_empty) out_ << ')';
  }
  void begin_geometry(std::string_view name, bool is_multiple) override {
    std::string upper_case(name);
    std::transform(name.begin(), name.end(), upper_case.begin(), upper);
    out_ << (is_multiple ? "MULTI" : "") << upper_case << ' ';
  }
  void end_geometry() override {}
  void write_point(Point2 p) override {
    write_list(0, 1, [&](std::size_t) { write_position(p); });
  }
  void write_position(Point2 p) override { out_ << p.x << ' ' << p.y; }
};

}  // namespace

void write_wkt(std::ostream& out, const PlaneShapes& shapes, Context& context) {
  WktWriter(out, shapes, context).write();
}

}  // namespace plumb
