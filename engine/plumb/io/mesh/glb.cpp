#include "plumb/io/mesh/glb.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <ostream>
#include <sstream>
#include <string>

#include "plumb/io/mesh/mesh_formats.h"
#include "plumb/io/mesh/stl.h"
#include "plumb/io/text/text_output.h"
#include "plumb/predicates/error.h"

namespace plumb {
namespace {

constexpr std::uint64_t kGlbHeaderBytes = 12, kGlbChunkBytes = 8;
constexpr std::uint64_t kGlbRecordBytes = 12;  // Three floats of a vertex, or three corners.

void put_array(TextOutput& out, const std::array<double, 3>& numbers) {
  out << '[' << numbers[0] << ',' << numbers[1] << ',' << numbers[2] << ']';
}

/// Writes the bounds of the vertices, which glTF requires of positions.
void put_bounds(TextOutput& out, const PolygonMesh& mesh) {
  const Point3& first = mesh.points.front();
  std::array<double, 3> low{first.x, first.y, first.z};
  std::array<double, 3> high = low;
  for (const Point3& p : mesh.points) {
    const std::array<double, 3> parts{p.x, p.y, p.z};
    for (std::size_t i = 0; i < 3; ++i) {
      low[i] = std::min(low[i], parts[i]);
      high[i] = std::max(high[i], parts[i]);
    }
  }
  out << R"("min":)";
  put_array(out, low);
  out << R"(,"max":)";
  put_array(out, high);
}

/// Returns the document, with blanks that make its length a multiple of four.
std::string glb_document(const PolygonMesh& mesh, std::uint64_t vertex_bytes,
                         std::uint64_t corner_bytes) {
  std::ostringstream text;
  TextOutput out(text);
  out << R"({"asset":{"version":"2.0","generator":"plumb"},"scene":0,"scenes":[{"nodes":[0]}],)"
      << R"("nodes":[{"mesh":0}],"meshes":[{"primitives":[{"attributes":{"POSITION":0},)"
      << R"("indices":1}]}],"buffers":[{"byteLength":)" << vertex_bytes + corner_bytes
      << R"(}],"bufferViews":[{"buffer":0,"byteLength":)" << vertex_bytes
      << R"(,"target":34962},{"buffer":0,"byteOffset":)" << vertex_bytes << R"(,"byteLength":)"
      << corner_bytes << R"(,"target":34963}],"accessors":[{"bufferView":0,"componentType":5126,)"
      << R"("count":)" << std::uint64_t{mesh.points.size()} << R"(,"type":"VEC3",)";
  put_bounds(out, mesh);
  out << R"(},{"bufferView":1,"componentType":5125,"count":)" << std::uint64_t{mesh.corners.size()}
      << R"(,"type":"SCALAR"}]})";
  out.flush();
  std::string document = text.str();
  document.resize((document.size() + 3) / 4 * 4, ' ');
  return document;
}

}  // namespace

void require_faces(const PolygonMesh& mesh) {
  if (mesh.face_count() == 0) {
    throw Error(ErrorCode::BadArgument, "the mesh has no faces, and glTF cannot hold such a mesh");
  }
}

void write_glb(std::ostream& stream, const PolygonMesh& mesh) {
  require_faces(mesh);
  require_triangles(mesh);
  const PolygonMesh floats = rounded_to_floats(mesh);
  const std::uint64_t vertex_bytes = kGlbRecordBytes * floats.points.size();
  const std::uint64_t corner_bytes = kGlbRecordBytes * floats.face_count();
  const std::uint64_t data_bytes = vertex_bytes + corner_bytes;
  const std::string document = glb_document(floats, vertex_bytes, corner_bytes);
  const std::uint64_t bytes = kGlbHeaderBytes + 2 * kGlbChunkBytes + document.size() + data_bytes;
  if (bytes > UINT32_MAX) {
    throw Error(ErrorCode::CannotWrite, "binary glTF cannot hold 2^32 bytes or more");
  }
  TextOutput out(stream);
  out << "glTF";
  put_little_endian(out, std::uint32_t{2});
  put_little_endian(out, static_cast<std::uint32_t>(bytes));
  put_little_endian(out, static_cast<std::uint32_t>(document.size()));
  out << "JSON" << document;
  put_little_endian(out, static_cast<std::uint32_t>(data_bytes));
  out << std::string_view("BIN\0", 4);
  for (const Point3& p : floats.points) {
    for (const double value : {p.x, p.y, p.z}) put_little_endian(out, static_cast<float>(value));
  }
  for (const std::uint32_t corner : floats.corners) put_little_endian(out, corner);
  out.flush();
}

}  // namespace plumb
