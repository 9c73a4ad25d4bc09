#include "plumb/space/space_draft.h"

#include <algorithm>

#include "plumb/base/error.h"

namespace plumb {

namespace {

constexpr std::size_t kFew = 16;  ///< of so few, each is added faster than all at once

template <class T>
void extend(std::vector<T>& all, const std::vector<T>& more) {
  if (more.size() > kFew) {
    all.insert(all.end(), more.begin(), more.end());
  } else {
    for (const T& item : more) all.push_back(item);
  }
}

void extend_shifted(std::vector<std::uint32_t>& all, const std::vector<std::uint32_t>& more,
                    std::uint32_t shift) {
  for (const std::uint32_t i : more) all.push_back(i == SphereMap::kNone ? i : i + shift);
}

void append_map(SphereMap& maps, const SphereMap& map, const SpaceDraft::Offsets& offsets) {
  extend(maps.direction, map.direction);
  extend(maps.point_mark, map.point_mark);
  extend_shifted(maps.first_out, map.first_out, 2 * offsets.arc);
  extend_shifted(maps.point_face, map.point_face, offsets.face);
  extend(maps.circle, map.circle);
  extend(maps.arc_mark, map.arc_mark);
  extend_shifted(maps.origin, map.origin, offsets.point);
  extend_shifted(maps.next, map.next, 2 * offsets.arc);
  extend_shifted(maps.face, map.face, offsets.face);
  extend(maps.face_mark, map.face_mark);
}

}  // namespace

SpaceDraft::Offsets SpaceDraft::add(SpacePoint at, const SphereMap& map, bool passed,
                                    std::span<const std::uint32_t> origin_ids) {
  const VertexId v(vertex_point.size());
  const Offsets offsets = end();
  vertex_point.push_back(at);
  vertex_mark.push_back(map.centre_mark);
  is_passed.push_back(passed ? 1 : 0);
  begin.push_back(offsets);

  append_map(maps, map, offsets);
  for (std::size_t i = 0; i < map.point_count(); ++i) {
    vertex_of_point.push_back(v);
    twin.push_back(SphereMap::kNone);
  }
  PLUMB_CHECK(origin_ids.size() == map.arc_count());
  for (const std::uint32_t origin : origin_ids) arc_origin.push_back(origin);
  return offsets;
}

void SpaceDraft::resize(std::size_t vertices, std::size_t points, std::size_t arcs,
                        std::size_t faces) {
  const auto resize = [](std::size_t size, auto&... arrays) { (arrays.resize(size), ...); };
  resize(vertices, vertex_point, vertex_mark, is_passed, begin);
  resize(points, maps.direction, maps.point_mark, maps.first_out, vertex_of_point);
  maps.point_face.resize(points, SphereMap::kNone);
  twin.resize(points, SphereMap::kNone);
  resize(arcs, maps.circle, maps.arc_mark, arc_origin);
  resize(2 * arcs, maps.origin, maps.next, maps.face);
  resize(faces, maps.face_mark);
}

SpaceDraft::Offsets SpaceDraft::end() const {
  return {static_cast<std::uint32_t>(maps.point_count()),
          static_cast<std::uint32_t>(maps.arc_count()),
          static_cast<std::uint32_t>(maps.face_count())};
}

void SpaceDraft::append(const SpaceDraft& other) {
  const auto vertices = static_cast<std::uint32_t>(vertex_count());
  const Offsets offsets = end();
  extend(vertex_point, other.vertex_point);
  extend(vertex_mark, other.vertex_mark);
  extend(is_passed, other.is_passed);
  for (const Offsets& o : other.begin) {
    begin.push_back({o.point + offsets.point, o.arc + offsets.arc, o.face + offsets.face});
  }
  append_map(maps, other.maps, offsets);
  for (const VertexId v : other.vertex_of_point) {
    vertex_of_point.push_back(VertexId(v.value() + vertices));
  }
  extend_shifted(twin, other.twin, offsets.point);
  extend(arc_origin, other.arc_origin);
}

void SpaceDraft::reserve_more(std::size_t vertices, std::size_t point_count, std::size_t arcs,
                              std::size_t faces) {
  const auto reserve = [](std::size_t more, auto&... arrays) {
    (arrays.reserve(arrays.size() + more), ...);
  };
  reserve(vertices, vertex_point, vertex_mark, is_passed, begin);
  reserve(point_count, maps.direction, maps.point_mark, maps.first_out, maps.point_face,
          vertex_of_point, twin);
  reserve(arcs, maps.circle, maps.arc_mark, arc_origin);
  reserve(2 * arcs, maps.origin, maps.next, maps.face);
  reserve(faces, maps.face_mark);
}

}  // namespace plumb
