#include "plumb/io/geojson_writer.h"

#include "plumb/io/shape_writer.h"

namespace plumb {
namespace {

class GeoJsonWriter : public ShapeWriter {
 public:
  GeoJsonWriter(std::ostream& out, const PlaneShapes& shapes, Context& context)
      : ShapeWriter(out, shapes, {'[', ",", ']'}, context) {}

 private:
  void begin_collection(bool) override { out_ << R"({"type":"GeometryCollection","geometries":[)"; }
  void end_collection(bool) override { out_ << "]}"; }
  void begin_geometry(std::string_view name, bool is_multiple) override {
    out_ << R"({"type":")" << (is_multiple ? "Multi" : "") << name << R"(","coordinates":)";
  }
  void end_geometry() override { out_ << '}'; }
  void write_point(Point2 p) override { write_position(p); }
  void write_position(Point2 p) override { out_ << '[' << p.x << ',' << p.y << ']'; }
};

}  // namespace

void write_geojson(std::ostream& out, const PlaneShapes& shapes, Context& context) {
  GeoJsonWriter(out, shapes, context).write();
}

}  // namespace plumb
