#include "plumb/space/from_mesh.h"

#include <algorithm>
#include <memory>
#include <utility>

#include "plumb/base/refused_memory.h"
#include "plumb/space/link_facets.h"
#include "plumb/space/mesh_borders.h"
#include "plumb/space/mesh_components.h"
#include "plumb/space/mesh_crossings.h"
#include "plumb/space/mesh_facets.h"
#include "plumb/space/mesh_fans.h"
#include "plumb/space/mesh_links.h"
#include "plumb/space/mesh_vertices.h"

namespace plumb {
namespace {

constexpr std::uint64_t kBytesPerCorner = 200;
constexpr std::uint64_t kBytesPerPoint = 4;  // also of points that no face names

/// Vertices without a facet (corners of faces without area only) go.
void drop_unused(MeshFacets& facets, MeshLinks& links, MeshVertices& vertices) {
  std::vector<std::uint32_t> number(vertices.point.size(), 0);
  for (const std::uint32_t v : facets.corner) number[v] = 1;
  std::uint32_t count = 0;
  for (std::uint32_t v = 0; v < number.size(); ++v) {
    if (number[v] == 0) continue;
    vertices.point[count] = vertices.point[v];
    vertices.input[count] = vertices.input[v];
    number[v] = count++;
  }
  if (count == number.size()) return;
  vertices.point.resize(count);
  vertices.input.resize(count);
  for (std::uint32_t& v : facets.corner) v = number[v];
  for (auto& [a, b] : links.end) {
    a = number[a];
    b = number[b];
  }
}

void describe_components(const MeshFacets& facets, MeshComplex& result) {
  MeshComponents components = find_components(result.complex, facets.jump);
  result.component = std::move(components.of_facet);
  for (const Sign s : components.volume) {
    result.is_inside_out.push_back(s == Sign::Negative ? 1 : 0);
  }
  std::uint32_t next = 0;
  for (std::uint32_t f = 0; f < facets.size(); ++f) {
    if (result.component[f] != next) continue;
    if (result.is_inside_out[next] != 0) result.report.inside_out.push_back(facets.origin[f]);
    ++next;
  }
}

void describe_crossings(const MeshOptions& options, MeshComplex& result, MemoryCharge& memory,
                        Context& context) {
  const SpaceComplex& complex = result.complex;
  std::vector<MeshReport::FacePair> pairs;
  result.has_fan = find_fans(complex);
  result.crossings = find_mesh_crossings(complex, result.has_fan, context);
  memory.add(result.crossings.size() * (sizeof(result.crossings[0]) + sizeof(pairs[0])),
             "crossings of the mesh");
  pairs.reserve(result.crossings.size());
  for (const auto& [f, g] : result.crossings) {
    pairs.emplace_back(complex.facet_origin[f.value()], complex.facet_origin[g.value()]);
  }
  result.report.crossing_count = pairs.size();
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  pairs.resize(std::min<std::uint64_t>(pairs.size(), options.max_listed));
  result.report.crossings = std::move(pairs);
}

}  // namespace

MeshComplex complex_of_mesh(const MeshView& mesh, const MeshOptions& options,
                            Context& context) try {
  MeshComplex result;
  MemoryCharge memory(context);
  memory.add(kBytesPerCorner * mesh.corners.size() + kBytesPerPoint * mesh.point_count(), "a mesh");
  const auto tables = std::make_shared<SpaceTables>();
  MeshVertices vertices = merge_equal_points(mesh, *tables);
  result.report.vertices_merged = vertices.merged;
  context.checkpoint("reading faces", 0, 1);
  MeshFacets facets = flatten_mesh(mesh, vertices, *tables, result.report, context);
  MeshLinks links = link_corners(facets, vertices.point.size());
  result.report.doubled = merge_doubled(facets, links, vertices.point.size());
  result.report.borders = trace_borders(facets, links, vertices.point, tables->points);
  for (auto& chain : result.report.borders) {
    for (std::uint32_t& v : chain) v = vertices.input[v];
  }
  if (!result.report.is_closed() && !options.surface) return result;

  context.checkpoint("linking facets", 0, 1);
  drop_unused(facets, links, vertices);
  result.complex = link_facets(facets, links, vertices.point, tables);
  context.checkpoint("components", 0, 1);
  describe_components(facets, result);
  describe_crossings(options, result, memory, context);
  result.jump = std::move(facets.jump);
  return result;
} catch (...) {
  rethrow_refused_memory();
}

}  // namespace plumb
