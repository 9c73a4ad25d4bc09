#include "plumb/io/ply_writer.h"

#include <algorithm>
#include <string_view>

#include "plumb/io/binary_output.h"
#include "plumb/io/mesh_text.h"

namespace plumb {
namespace {

/// The types of a list of corners.
struct CornerTypes {
  bool short_length;  ///< uchar, else uint
  bool is_signed;     ///< int, which more programs read, else uint
};

CornerTypes types_for(const PolygonMesh& mesh) {
  std::size_t longest = 0;
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    longest = std::max(longest, mesh.face(f).size());
  }
  return {longest <= 0xff, mesh.points.size() <= 0x8000'0000U};
}

void write_header(TextOutput& out, std::string_view format, const PolygonMesh& mesh,
                  CornerTypes types) {
  out << "ply\nformat " << format << " 1.0\ncomment plumb\n";
  out << "element vertex " << std::uint64_t{mesh.points.size()};
  out << "\nproperty double x\nproperty double y\nproperty double z\n";
  out << "element face " << std::uint64_t{mesh.face_count()};
  out << "\nproperty list " << (types.short_length ? "uchar" : "uint");
  out << (types.is_signed ? " int" : " uint") << " vertex_indices\nend_header\n";
}

}  // namespace

void write_ply_text(std::ostream& stream, const PolygonMesh& mesh) {
  require_doubles(mesh);
  TextOutput out(stream);
  write_header(out, "ascii", mesh, types_for(mesh));
  for (const Point3& p : mesh.points) {
    write_coordinates(out, p);
    out << '\n';
  }
  write_face_lines(out, mesh);
  out.flush();
}

void write_ply_binary(std::ostream& stream, const PolygonMesh& mesh) {
  require_doubles(mesh);
  TextOutput out(stream);
  const CornerTypes types = types_for(mesh);
  write_header(out, "binary_little_endian", mesh, types);
  for (const Point3& p : mesh.points) {
    for (const double value : {p.x, p.y, p.z}) put_little_endian(out, value);
  }
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    const auto face = mesh.face(f);
    const auto length = static_cast<std::uint32_t>(face.size());
    if (types.short_length) {
      out << static_cast<char>(length);
    } else {
      put_little_endian(out, length);
    }
    for (const std::uint32_t v : face) put_little_endian(out, v);
  }
  out.flush();
}

}  // namespace plumb
