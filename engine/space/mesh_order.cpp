#include "plumb/space/mesh_order.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "plumb/space/morton.h"

namespace plumb {
namespace {

bool has_only_triangles(const MeshView& mesh) {
  for (std::size_t f = 1; f < mesh.face_begin.size(); ++f) {
    if (mesh.face_begin[f] != 3 * f) return false;
  }
  return true;
}

bool is_sound(const MeshView& mesh) {
  const std::size_t points = mesh.point_count();
  return std::ranges::all_of(mesh.corners, [=](std::uint32_t c) { return c < points; }) &&
         std::ranges::all_of(mesh.coordinates, [](double x) { return std::isfinite(x); });
}

/// The code of each point's place; none where the extent is no double.
std::vector<std::uint32_t> places_of(const MeshView& mesh) {
  constexpr std::uint32_t kLast = 1023;
  const auto at = [&](std::size_t i) {
    const Point3 p = mesh.point(i);
    return std::array{p.x, p.y, p.z};
  };
  Box3 around;
  for (std::size_t i = 0; i < mesh.point_count(); ++i) around.add({at(i), at(i)});
  const CellGrid grid(around, kLast);
  std::vector<std::uint32_t> places;
  if (!grid.is_finite()) return places;
  places.reserve(mesh.point_count());
  for (std::size_t i = 0; i < mesh.point_count(); ++i) {
    places.push_back(morton_code(grid.cell(at(i))));
  }
  return places;
}

template <class CodeOf>
std::vector<MortonCoded> sorted(std::size_t n, CodeOf&& code_of) {
  std::vector<MortonCoded> items;
  items.reserve(n);
  for (std::uint32_t i = 0; i < n; ++i) items.push_back({code_of(i), i});
  sort_by_code(items);
  return items;
}

}  // namespace

OrderedMesh ordered_in_space(const MeshView& mesh) {
  OrderedMesh ordered;
  if (mesh.face_count() == 0 || !mesh.exact.empty()) return ordered;
  if (!has_only_triangles(mesh) || !is_sound(mesh)) return ordered;
  const std::vector<std::uint32_t> place = places_of(mesh);
  if (place.empty()) return ordered;

  std::vector<std::uint32_t> number(place.size());  // of each point, in the new order
  ordered.coordinates.reserve(mesh.coordinates.size());
  std::uint32_t next = 0;
  for (const MortonCoded& p : sorted(place.size(), [&](std::uint32_t i) { return place[i]; })) {
    const Point3 at = mesh.point(p.item);
    ordered.coordinates.insert(ordered.coordinates.end(), {at.x, at.y, at.z});
    number[p.item] = next++;
  }
  const auto corners_of = [&](std::uint32_t f) {
    return mesh.corners.subspan(3 * std::size_t{f}, 3);
  };
  const auto place_of_face = [&](std::uint32_t f) {
    const auto c = corners_of(f);
    return std::min({place[c[0]], place[c[1]], place[c[2]]});
  };
  ordered.corners.reserve(mesh.corners.size());
  ordered.face.reserve(mesh.face_count());
  for (const MortonCoded& f : sorted(mesh.face_count(), place_of_face)) {
    for (const std::uint32_t c : corners_of(f.item)) ordered.corners.push_back(number[c]);
    ordered.face.push_back(f.item);
  }
  return ordered;
}

}  // namespace plumb
