#include "plumb/io/obj_writer.h"

#include "plumb/io/mesh_text.h"

namespace plumb {

void write_obj(std::ostream& stream, const PolygonMesh& mesh) {
  require_doubles(mesh);
  TextOutput out(stream);
  out << "# plumb\n";
  for (const Point3& p : mesh.points) {
    out << "v ";
    write_coordinates(out, p);
    out << '\n';
  }
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    out << 'f';
    for (const std::uint32_t v : mesh.face(f)) out << ' ' << std::uint64_t{v} + 1;
    out << '\n';
  }
  out.flush();
}

}  // namespace plumb
