// Memory of a complex, and dropping planes and points that it does not use.
//
// Tested by tests/space/nef3_queries_test.cpp.

#include "plumb/space/complex/tidy_tables.h"

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

namespace plumb {

namespace {

template <class... T>
std::size_t bytes_of(const std::vector<T>&... arrays) {
  return ((arrays.capacity() * sizeof(T)) + ...);
}

std::size_t bytes_of(const PlaneTable& planes) {
  constexpr std::size_t kIndexBytes = 36;  // The bytes of the index for each plane.
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

namespace {

/// Returns the planes of edges and facets in ascending order, each once.
std::vector<PlaneId> used_planes(const SpaceComplex& complex) {
  std::vector<std::uint8_t> is_used(complex.planes().size(), 0);
  for (const PlaneId p : complex.facet_plane) is_used[p.value()] = 1;
  for (const auto& [p, q] : complex.edge_planes) is_used[p.value()] = is_used[q.value()] = 1;
  std::vector<PlaneId> planes;
  for (std::size_t p = 0; p < is_used.size(); ++p) {
    if (is_used[p] != 0) planes.push_back(PlaneId(p));
  }
  return planes;
}

/// Returns the number of different planes of facets.
std::size_t count_facet_planes(const SpaceComplex& complex) {
  std::vector<std::uint8_t> is_used(complex.planes().size(), 0);
  std::size_t count = 0;
  for (const PlaneId p : complex.facet_plane) {
    count += is_used[p.value()] == 0 ? 1 : 0;
    is_used[p.value()] = 1;
  }
  return count;
}

/// Returns the complex with its own tables, which have these planes and the points of its vertices.
SpaceComplex compacted(SpaceComplex complex, const std::vector<PlaneId>& planes) {
  const CompactedTables kept = compacted(*complex.tables, planes, complex.vertex_point);
  for (SpacePoint& p : complex.vertex_point) p = kept(p);
  for (PlaneId& p : complex.facet_plane) p = kept(p);
  for (auto& pair : complex.edge_planes) pair = {kept(pair[0]), kept(pair[1])};
  complex.tables = kept.tables;
  return complex;
}

}  // namespace

SpaceComplex with_used_tables(SpaceComplex complex) {
  const std::vector<PlaneId> planes = used_planes(complex);
  return compacted(std::move(complex), planes);
}

// Compaction takes time linear in the tables. It is done only if the tables are twice as large as
// needed, so that the cost of a chain of operations is linear.
SpaceComplex with_tidy_tables(SpaceComplex complex) {
  const SpaceTables& tables = *complex.tables;
  const std::size_t points = tables.points.size() + tables.planes.points().size();
  const bool has_few_points = points <= 4 * complex.vertex_count() + 64;
  const auto has_few_planes = [&](std::size_t used) {
    return tables.planes.size() <= 2 * used + 64;
  };
  // In general position, each facet has its own plane, and the planes of facets are sufficient.
  if (has_few_points && has_few_planes(count_facet_planes(complex))) return complex;
  const std::vector<PlaneId> planes = used_planes(complex);
  if (has_few_points && has_few_planes(planes.size())) return complex;
  return compacted(std::move(complex), planes);
}

}  // namespace plumb
