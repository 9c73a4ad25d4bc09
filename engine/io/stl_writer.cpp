#include "plumb/io/stl_writer.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>

#include "plumb/base/error.h"
#include "plumb/io/binary_output.h"
#include "plumb/io/mesh_text.h"
#include "plumb/io/number_reader.h"

namespace plumb {
namespace {

using Triangle = std::array<Point3, 3>;

Triangle triangle(const PolygonMesh& mesh, std::size_t f) {
  const auto face = mesh.face(f);
  return {mesh.points[face[0]], mesh.points[face[1]], mesh.points[face[2]]};
}

/// For programs that do not compute it themselves: roughly of length 1, or 0 0 0 if doubles do not say.
Point3 rough_normal(const Triangle& t) {
  const Point3 u{t[1].x - t[0].x, t[1].y - t[0].y, t[1].z - t[0].z};
  const Point3 v{t[2].x - t[0].x, t[2].y - t[0].y, t[2].z - t[0].z};
  const Point3 n{u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x};
  const double length = std::hypot(n.x, n.y, n.z);
  if (!std::isfinite(length) || length == 0) return {};
  return {n.x / length, n.y / length, n.z / length};
}

void put_floats(TextOutput& out, const Point3& p) {
  for (const double value : {p.x, p.y, p.z}) put_little_endian(out, static_cast<float>(value));
}

double rounded_to_float(double value) {
  constexpr double kMost = std::numeric_limits<float>::max();
  if (std::fabs(value) > kMost) {
    throw Error(ErrorCode::NumberOutOfRange,
                "the coordinate " + format_double(value) + " is larger than the largest float");
  }
  return static_cast<double>(static_cast<float>(value));
}

}  // namespace

void write_stl_text(std::ostream& stream, const PolygonMesh& mesh) {
  require_triangles(mesh);
  require_doubles(mesh);
  TextOutput out(stream);
  out << "solid plumb\n";
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    const Triangle corners = triangle(mesh, f);
    out << "facet normal ";
    write_coordinates(out, rough_normal(corners));
    out << "\n  outer loop\n";
    for (const Point3& p : corners) {
      out << "    vertex ";
      write_coordinates(out, p);
      out << '\n';
    }
    out << "  endloop\nendfacet\n";
  }
  out << "endsolid plumb\n";
  out.flush();
}

PolygonMesh rounded_to_floats(PolygonMesh mesh) {
  const RoundToNearest rounding;
  require_doubles(mesh);
  for (Point3& p : mesh.points) {
    p = {rounded_to_float(p.x), rounded_to_float(p.y), rounded_to_float(p.z)};
  }
  mesh.exact.clear();
  return mesh;
}

void write_stl_binary(std::ostream& stream, const PolygonMesh& mesh) {
  constexpr std::size_t kHeaderBytes = 80;
  require_triangles(mesh);
  const PolygonMesh floats = rounded_to_floats(mesh);
  TextOutput out(stream);
  std::string header("plumb");
  header.resize(kHeaderBytes, ' ');
  out << header;
  put_little_endian(out, static_cast<std::uint32_t>(floats.face_count()));
  for (std::size_t f = 0; f < floats.face_count(); ++f) {
    const Triangle corners = triangle(floats, f);
    put_floats(out, rough_normal(corners));
    for (const Point3& p : corners) put_floats(out, p);
    put_little_endian(out, std::uint16_t{0});
  }
  out.flush();
}

}  // namespace plumb
