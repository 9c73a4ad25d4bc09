#include "plumb/io/mesh_text.h"

#include <cmath>
#include <cstdint>
#include <string>

#include "plumb/base/error.h"
#include "plumb/predicates/rounding.h"

namespace plumb {

void write_coordinates(TextOutput& out, const Point3& p) { out << p.x << ' ' << p.y << ' ' << p.z; }

void write_face_lines(TextOutput& out, const PolygonMesh& mesh) {
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    const auto face = mesh.face(f);
    out << std::uint64_t{face.size()};
    for (const std::uint32_t v : face) out << ' ' << v;
    out << '\n';
  }
}

void require_doubles(const PolygonMesh& mesh) {
  for (const auto& [vertex, p] : mesh.exact) {
    for (const Rational* q : {&p.x, &p.y, &p.z}) {
      if (std::isfinite(nearest_double(*q))) continue;
      throw Error(ErrorCode::NumberOutOfRange, "a coordinate of vertex " + std::to_string(vertex) +
                                                   " is larger than the largest double");
    }
  }
}

void require_triangles(const PolygonMesh& mesh) {
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    if (mesh.face(f).size() == 3) continue;
    throw Error(ErrorCode::BadArgument, "face " + std::to_string(f) + " is no triangle");
  }
}

}  // namespace plumb
