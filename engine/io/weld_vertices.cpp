#include "plumb/io/weld_vertices.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <utility>
#include <vector>

#include "plumb/predicates/id_index.h"
#include "plumb/predicates/seeded_hash.h"
#include "plumb/space/mesh_vertices.h"

namespace plumb {
namespace {

constexpr std::uint32_t kNone = MeshVertices::kNone;
constexpr std::uint32_t kPointsPerCheckpoint = 4096;

/// -0 equals 0. By the bits: subnormals are not zero, whatever FTZ/DAZ say.
std::array<std::uint64_t, 3> bits_of(const Point3& p) {
  const auto bits = [](double value) {
    const auto all = std::bit_cast<std::uint64_t>(value);
    return all << 1U == 0 ? 0 : all;
  };
  return {bits(p.x), bits(p.y), bits(p.z)};
}

/// For each point the first with its coordinates.
std::vector<std::uint32_t> first_equals(const PolygonMesh& mesh, Context& context) {
  std::vector<std::uint32_t> first;
  first.reserve(mesh.points.size());
  IdIndex known;
  for (std::uint32_t i = 0; i < mesh.points.size(); ++i) {
    if (i % kPointsPerCheckpoint == 0) context.checkpoint("weld", i, mesh.points.size());
    const auto bits = bits_of(mesh.points[i]);
    first.push_back(
        known.find_or_add(static_cast<std::uint32_t>(SeededHash{}(bits)), i,
                          [&](std::uint32_t j) { return bits_of(mesh.points[j]) == bits; }));
  }
  return first;
}

/// The same where some coordinates are no doubles; kNone for points of no face.
std::vector<std::uint32_t> first_exact_equals(const PolygonMesh& mesh) {
  SpaceTables tables;
  MeshVertices vertices = merge_equal_points(mesh, tables);
  for (std::uint32_t& v : vertices.of_point) {
    if (v != kNone) v = vertices.input[v];
  }
  return std::move(vertices.of_point);
}

/// Takes the faces that stay sound when corner v becomes first[v]; returns how many do not.
std::size_t renumber_faces(PolygonMesh& mesh, const std::vector<std::uint32_t>& first) {
  PolygonMesh kept;
  kept.corners.reserve(mesh.corners.size());
  kept.face_begin.reserve(mesh.face_begin.size());
  std::vector<std::uint32_t> face;
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    face.clear();
    for (const std::uint32_t v : mesh.face(f)) face.push_back(first[v]);
    const bool is_sound =
        face.front() != face.back() && std::adjacent_find(face.begin(), face.end()) == face.end();
    if (is_sound) kept.add_face(face);
  }
  const std::size_t dropped = mesh.face_count() - kept.face_count();
  mesh.face_begin = std::move(kept.face_begin);
  mesh.corners = std::move(kept.corners);
  return dropped;
}

std::size_t used_points(const PolygonMesh& mesh) {
  std::vector<std::uint8_t> is_used(mesh.points.size());
  for (const std::uint32_t corner : mesh.corners) is_used[corner] = 1;
  return static_cast<std::size_t>(std::count(is_used.begin(), is_used.end(), 1));
}

/// Only points with corners stay, in order of use.
void renumber_points(PolygonMesh& mesh) {
  std::vector<std::uint32_t> number(mesh.points.size(), kNone);
  PolygonMesh used;
  used.points.reserve(used_points(mesh));
  for (std::uint32_t& corner : mesh.corners) {
    const std::uint32_t point = corner;
    std::uint32_t& now = number[point];
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
  constexpr std::uint64_t kPointBytes = 64;   // a number, its place in a set that doubles, a copy
  constexpr std::uint64_t kExactBytes = 320;  // three planes, numbers
  constexpr std::uint64_t kCornerBytes = 4;   // a copy of the faces
  constexpr std::uint64_t kTableBytes = 192;  // a point of a table with an index
  const bool is_exact = !mesh.exact.empty();
  MemoryCharge charge(context);
  charge.add((kPointBytes + (is_exact ? kTableBytes : 0)) * mesh.points.size() +
                 kExactBytes * mesh.exact.size() +
                 kCornerBytes * (mesh.corners.size() + mesh.face_count()),
             "the vertices of the mesh");
  const std::size_t dropped =
      renumber_faces(mesh, is_exact ? first_exact_equals(mesh) : first_equals(mesh, context));
  renumber_points(mesh);
  return dropped;
}

}  // namespace plumb
