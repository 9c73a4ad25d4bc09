#include "plumb/space/space_memory.h"

#include <vector>

namespace plumb {

namespace {

template <class... T>
std::size_t bytes_of(const std::vector<T>&... arrays) {
  return ((arrays.capacity() * sizeof(T)) + ...);
}

std::size_t bytes_of(const PlaneTable& planes) {
  constexpr std::size_t kIndexBytes = 36;  // a plane
  std::size_t bytes = planes.points().size() * (sizeof(Point3) + sizeof(Grid));
  bytes +=
      planes.size() * (sizeof(PlaneRow) + sizeof(Fingerprint) + sizeof(PlaneSource) + kIndexBytes);
  for (std::size_t p = 0; p < planes.size(); ++p) {
    const PlaneSource& source = planes.source(PlaneId(p));
    if (!source.is_explicit()) continue;
    bytes += sizeof(PlaneSlot) + 4 * sizeof(std::uint64_t) * planes.slot(source).limbs;
  }
  return bytes;
}

}  // namespace

std::size_t memory_bytes(const SpaceComplex& c) {
  return bytes_of(c.planes()) + c.points().size() * (sizeof(PointBox) + sizeof(PointSource) + 1) +
         array_bytes(c);
}

std::size_t array_bytes(const SpaceComplex& c) {
  return bytes_of(c.vertex_point, c.vertex_mark, c.vertex_volume, c.vertex_facet, c.star_begin,
                  c.star, c.edge_planes, c.edge_mark, c.edge_use, c.edge_volume, c.origin) +
         bytes_of(c.use_halfedge, c.use_next, c.use_prev, c.use_radial, c.use_facet) +
         bytes_of(c.facet_plane, c.facet_mark, c.facet_volume, c.facet_origin, c.cycle_begin,
                  c.cycle, c.inner_begin, c.inner, c.volume_mark);
}

}  // namespace plumb
