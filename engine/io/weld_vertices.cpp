#include "plumb/io/weld_vertices.h"

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

#include "plumb/space/mesh_vertices.h"

namespace plumb {
namespace {

constexpr std::uint32_t kNone = MeshVertices::kNone;

/// Takes the faces that stay sound when corner v becomes vertex_of[v]; returns how many do not.
std::size_t renumber_faces(PolygonMesh& mesh, const std::vector<std::uint32_t>& vertex_of) {
  PolygonMesh kept;
  std::vector<std::uint32_t> face;
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    face.clear();
    for (const std::uint32_t v : mesh.face(f)) face.push_back(vertex_of[v]);
    const bool is_sound =
        face.front() != face.back() && std::adjacent_find(face.begin(), face.end()) == face.end();
    if (is_sound) kept.add_face(face);
  }
  const std::size_t dropped = mesh.face_count() - kept.face_count();
  mesh.face_begin = std::move(kept.face_begin);
  mesh.corners = std::move(kept.corners);
  return dropped;
}

/// Corners are vertices, point_of says where those are; afterwards they are points, in order of use.
void renumber_points(PolygonMesh& mesh, const std::vector<std::uint32_t>& point_of) {
  std::vector<std::uint32_t> number(point_of.size(), kNone);
  PolygonMesh used;
  for (std::uint32_t& corner : mesh.corners) {
    const std::uint32_t point = point_of[corner];
    std::uint32_t& now = number[corner];
    if (now == kNone) {
      now = static_cast<std::uint32_t>(used.points.size());
      used.points.push_back(mesh.points[point]);
      const auto exact =
          std::lower_bound(mesh.exact.begin(), mesh.exact.end(), point,
                           [](const auto& entry, std::uint32_t p) { return entry.first < p; });
      const bool is_exact = exact != mesh.exact.end() && exact->first == point;
      if (is_exact) used.exact.emplace_back(now, exact->second);
    }
    corner = now;
  }
  mesh.points = std::move(used.points);
  mesh.exact = std::move(used.exact);
}

}  // namespace

std::size_t weld_vertices(PolygonMesh& mesh, Context& context) {
  constexpr std::uint64_t kPointBytes = 256;  // a table with an index, numbers, and a copy
  constexpr std::uint64_t kExactBytes = 320;  // three planes
  constexpr std::uint64_t kCornerBytes = 16;  // a copy of the faces
  MemoryCharge charge(context);
  charge.add(kPointBytes * mesh.points.size() + kExactBytes * mesh.exact.size() +
                 kCornerBytes * mesh.corners.size(),
             "the vertices of the mesh");
  SpaceTables tables;
  const MeshVertices vertices = merge_equal_points(mesh, tables);
  const std::size_t dropped = renumber_faces(mesh, vertices.of_point);
  renumber_points(mesh, vertices.input);
  return dropped;
}

}  // namespace plumb
