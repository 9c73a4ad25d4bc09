#include "plumb/space/tidy_tables.h"

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

namespace plumb {
namespace {

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

SpaceComplex with_tidy_tables(SpaceComplex complex) {
  const SpaceTables& tables = *complex.tables;
  const std::vector<PlaneId> planes = used_planes(complex);
  const std::size_t points = tables.points.size() + tables.planes.points().size();
  if (tables.planes.size() <= 2 * planes.size() + 64 && points <= 4 * complex.vertex_count() + 64) {
    return complex;
  }
  return compacted(std::move(complex), planes);
}

}  // namespace plumb
