#include "plumb/io/off_writer.h"

#include "plumb/io/mesh_text.h"

namespace plumb {
namespace {

void write_vertices(TextOutput& out, const PolygonMesh& mesh, MeshNumbers numbers) {
  auto exact = mesh.exact.begin();
  if (numbers == MeshNumbers::Nearest) exact = mesh.exact.end();
  for (std::uint32_t i = 0; i < mesh.points.size(); ++i) {
    if (exact != mesh.exact.end() && exact->first == i) {
      const RationalPoint3& p = (exact++)->second;
      out << format_exact(p.x) << ' ' << format_exact(p.y) << ' ' << format_exact(p.z);
    } else {
      write_coordinates(out, mesh.points[i]);
    }
    out << '\n';
  }
}

}  // namespace

void write_off(std::ostream& stream, const PolygonMesh& mesh, MeshNumbers numbers) {
  if (numbers == MeshNumbers::Nearest) require_doubles(mesh);
  TextOutput out(stream);
  out << "OFF\n" << std::uint64_t{mesh.points.size()} << ' ' << std::uint64_t{mesh.face_count()};
  out << " 0\n";
  write_vertices(out, mesh, numbers);
  write_face_lines(out, mesh);
  out.flush();
}

}  // namespace plumb
