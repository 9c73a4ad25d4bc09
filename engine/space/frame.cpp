#include "plumb/space/frame.h"

#include <algorithm>
#include <array>

#include "plumb/base/error.h"
#include "plumb/space/local_maps.h"
#include "plumb/space/space_draft.h"

namespace plumb {

namespace {

/// Adds the vertices that `is_kept` accepts, each with its map, and the edges between them.
template <class IsKept>
void copy_vertices(const SpaceComplex& complex, IsKept is_kept, SpaceDraft& draft,
                   Context& context) {
  std::vector<std::uint32_t> point_of(complex.origin.size(), SphereMap::kNone), origin_ids;
  LocalMap local;
  for (std::uint32_t v = 0; v < complex.vertex_count(); ++v) {
    if (v % 4096 == 0) context.checkpoint("frame", v, complex.vertex_count());
    if (!is_kept(VertexId(v))) continue;
    local_map(complex, VertexId(v), local);
    origin_ids.clear();
    for (const FacetId f : local.facet) origin_ids.push_back(complex.facet_origin[f.value()]);
    const auto offsets = draft.add(complex.vertex_point[v], local.map, false, origin_ids);
    for (std::uint32_t i = 0; i < local.halfedge.size(); ++i) {
      point_of[local.halfedge[i].value()] = offsets.point + i;
    }
  }
  for (std::uint32_t h = 0; h < point_of.size(); ++h) {
    if (point_of[h] != SphereMap::kNone) draft.twin[point_of[h]] = point_of[h ^ 1U];
  }
}

/// A corner of the cube: per axis, whether it lies at +R.
using Corner = std::array<bool, 3>;

/// The map of a corner: point k leads along axis k, arc k lies in the plane of axis k; face 0 is the
/// cube, face 1 the beyond. `plane`: of each axis at this corner.
SphereMap corner_map(const Corner& corner, const std::array<PlaneId, 3>& plane, Mark inside) {
  SphereMap map;
  map.centre_mark = kBeyond;
  map.face_mark = {inside, kBeyond};
  map.origin.resize(6);
  map.next.resize(6);
  map.face.resize(6);
  for (std::uint32_t k = 0; k < 3; ++k) {
    const std::uint32_t i = (k + 1) % 3, j = (k + 2) % 3;
    // All frame planes have the axis as their normal: n_i x n_j runs along +k; edges lead inwards.
    const SphereDirection along{plane[i], plane[j]};
    map.direction.push_back(corner[k] ? along.opposite() : along);
    map.point_mark.push_back(kBeyond);
    map.point_face.push_back(SphereMap::kNone);
    map.circle.push_back(plane[k]);
    map.arc_mark.push_back(kBeyond);
    // Counter-clockwise about +k from axis i to axis j, if both lead the same way.
    const bool is_turned = corner[i] != corner[j];
    map.origin[2 * k] = is_turned ? j : i;
    map.origin[2 * k + 1] = is_turned ? i : j;
    map.face[2 * k] = corner[k] ? 1 : 0;
    map.face[2 * k + 1] = corner[k] ? 0 : 1;
  }
  map.first_out.resize(3);
  for (std::uint32_t h = 0; h < 6; ++h) {
    map.first_out[map.origin[h]] = h;
    for (std::uint32_t g = 0; g < 6; ++g) {
      if (g / 2 != h / 2 && map.face[g] == map.face[h] && map.origin[g] == map.target(h)) {
        map.next[h] = g;
      }
    }
  }
  return map;
}

void add_cube(SpaceDraft& draft, Mark inside) {
  const std::array<PlaneId, 6> frame = draft.tables->planes.intern_frame();
  const std::array<std::uint32_t, 3> no_origins{SphereMap::kNone, SphereMap::kNone,
                                                SphereMap::kNone};
  std::array<std::uint32_t, 8> first{};
  for (std::uint32_t c = 0; c < 8; ++c) {
    const Corner corner{(c & 1U) != 0, (c & 2U) != 0, (c & 4U) != 0};
    std::array<PlaneId, 3> plane;
    for (std::size_t k = 0; k < 3; ++k) plane[k] = frame[2 * k + (corner[k] ? 1 : 0)];
    const SpacePoint at = draft.tables->points.add(plane[0], plane[1], plane[2]);
    first[c] = draft.add(at, corner_map(corner, plane, inside), false, no_origins).point;
  }
  for (std::uint32_t c = 0; c < 8; ++c) {
    for (std::uint32_t k = 0; k < 3; ++k) draft.twin[first[c] + k] = first[c ^ (1U << k)] + k;
  }
}

}  // namespace

bool has_frame(const SpaceComplex& complex) {
  return !complex.volume_mark.empty() && complex.volume_mark[0] == kBeyond;
}

std::vector<std::uint8_t> unbounded_volumes(const SpaceComplex& complex) {
  std::vector<std::uint8_t> is_far(complex.volume_count(), 0);
  if (!is_far.empty()) is_far[0] = 1;
  for (std::size_t f = 0; f < complex.facet_count(); ++f) {
    if (complex.facet_mark[f] != kBeyond) continue;
    for (const VolumeId v : complex.facet_volume[f]) is_far[v.value()] = 1;
  }
  return is_far;
}

SpaceComplex with_frame(const SpaceComplex& complex, std::shared_ptr<SpaceTables> tables,
                        Context& context) {
  SpaceDraft draft(std::move(tables));
  copy_vertices(
      complex, [](VertexId) { return true; }, draft, context);
  add_cube(draft, complex.volume_mark[0]);
  return join(std::move(draft), context);
}

namespace {

/// Does an edge or facet of the set end on the frame?
bool is_reached(const SpaceComplex& c) {
  const auto is_beyond = [&c](std::size_t h) {
    return c.vertex_mark[c.origin[h].value()] == kBeyond;
  };
  for (std::size_t h = 0; h < c.origin.size(); ++h) {
    if (c.edge_mark[h / 2] != kBeyond && is_beyond(h)) return true;
  }
  for (std::size_t u = 0; u < c.use_count(); ++u) {
    if (c.facet_mark[c.use_facet[u].value()] != kBeyond && is_beyond(c.use_halfedge[u].value())) {
      return true;
    }
  }
  return false;
}

}  // namespace

SpaceComplex without_idle_frame(SpaceComplex complex, Context& context) {
  if (!has_frame(complex)) return complex;
  const auto is_kept = [&complex](VertexId v) { return complex.vertex_mark[v.value()] != kBeyond; };
  if (is_reached(complex)) return complex;
  Mark inside = kBeyond;
  for (std::uint32_t f = 0; f < complex.facet_count(); ++f) {
    for (const VolumeId v : complex.facet_volume[f]) {
      if (complex.facet_mark[f] == kBeyond && v != VolumeId(0)) {
        inside = complex.volume_mark[v.value()];
      }
    }
  }
  SpaceDraft draft(std::const_pointer_cast<SpaceTables>(complex.tables));
  copy_vertices(complex, is_kept, draft, context);
  SpaceComplex result = join(std::move(draft), context);
  if (result.vertex_count() == 0) result.volume_mark[0] = inside;
  return result;
}

}  // namespace plumb
