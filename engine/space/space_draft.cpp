#include "plumb/space/space_draft.h"

#include <algorithm>

#include "plumb/base/error.h"

namespace plumb {

namespace {

template <class T>
void append(std::vector<T>& all, const std::vector<T>& more) {
  all.insert(all.end(), more.begin(), more.end());
}

void append_shifted(std::vector<std::uint32_t>& all, const std::vector<std::uint32_t>& more,
                    std::uint32_t shift) {
  for (const std::uint32_t i : more) all.push_back(i == SphereMap::kNone ? i : i + shift);
}

}  // namespace

SpaceDraft::Offsets SpaceDraft::add(SpacePoint at, const SphereMap& map, bool passed,
                                    std::span<const std::uint32_t> origin_ids) {
  const VertexId v(vertex_point.size());
  const Offsets offsets{static_cast<std::uint32_t>(maps.point_count()),
                        static_cast<std::uint32_t>(maps.arc_count()),
                        static_cast<std::uint32_t>(maps.face_count())};
  vertex_point.push_back(at);
  vertex_mark.push_back(map.centre_mark);
  is_passed.push_back(passed ? 1 : 0);
  begin.push_back(offsets);

  append(maps.direction, map.direction);
  append(maps.point_mark, map.point_mark);
  append_shifted(maps.first_out, map.first_out, 2 * offsets.arc);
  append_shifted(maps.point_face, map.point_face, offsets.face);
  append(maps.circle, map.circle);
  append(maps.arc_mark, map.arc_mark);
  append_shifted(maps.origin, map.origin, offsets.point);
  append_shifted(maps.next, map.next, 2 * offsets.arc);
  append_shifted(maps.face, map.face, offsets.face);
  append(maps.face_mark, map.face_mark);

  vertex_of_point.resize(maps.point_count(), v);
  twin.resize(maps.point_count(), SphereMap::kNone);
  PLUMB_CHECK(origin_ids.size() == map.arc_count());
  arc_origin.insert(arc_origin.end(), origin_ids.begin(), origin_ids.end());
  return offsets;
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
