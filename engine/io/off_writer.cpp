#include "plumb/io/off_writer.h"

#include "plumb/io/text_output.h"

namespace plumb {
namespace {

void write_vertices(TextOutput& out, const PolygonMesh& mesh, MeshNumbers numbers) {
  auto exact = mesh.exact.begin();
  if (numbers == MeshNumbers::Nearest) exact = mesh.exact.end();
  for (std::uint32_t i = 0; i < mesh.points.size(); ++i) {
    if (exact != mesh.exact.end() && exact->first == i) {
      const RationalPoint3& p = (exact++)->second;
      out << format_exact(p.x) << ' ' << format_exact(p.y) << ' ' << format_exact(p.z) << '\n';
    } else {
      const Point3& p = mesh.points[i];
      out << p.x << ' ' << p.y << ' ' << p.z << '\n';
    }
  }
}

void write_faces(TextOutput& out, const PolygonMesh& mesh) {
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    const auto face = mesh.face(f);
    out << std::uint64_t{face.size()};
    for (const std::uint32_t v : face) out << ' ' << v;
    out << '\n';
  }
}

}  // namespace

void write_off(std::ostream& stream, const PolygonMesh& mesh, MeshNumbers numbers) {
  TextOutput out(stream);
  out << "OFF\n" << std::uint64_t{mesh.points.size()} << ' ' << std::uint64_t{mesh.face_count()};
  out << " 0\n";
  write_vertices(out, mesh, numbers);
  write_faces(out, mesh);
  out.flush();
}

}  // namespace plumb
