#include "plumb/space/turn.h"

#include <algorithm>

#include "plumb/space/mesh_arrangement.h"

namespace plumb {
namespace {

/// Per component: does it border on volume 0? Alone somewhere, or, where several lie upon each other,
/// with others none of which does so alone.
std::vector<std::uint8_t> find_outermost(const MeshComplex& mesh) {
  const auto component_of = [&](std::uint32_t sheet) { return mesh.component[sheet]; };
  std::vector<std::uint8_t> is_outermost(mesh.is_inside_out.size(), 0);
  std::vector<std::uint32_t> shared;  // facets
  for (std::uint32_t f = 0; f < mesh.complex.facet_count(); ++f) {
    const auto& sides = mesh.complex.facet_volume[f];
    if (sides[0] != VolumeId(0) && sides[1] != VolumeId(0)) continue;
    const auto sheets = mesh.sheets_of(FacetId(f));
    const std::uint32_t first = component_of(sheets[0]);
    if (std::ranges::all_of(sheets, [&](auto s) { return component_of(s) == first; })) {
      is_outermost[first] = 1;
    } else {
      shared.push_back(f);
    }
  }
  std::vector<std::uint8_t> result = is_outermost;
  for (const std::uint32_t f : shared) {
    const auto sheets = mesh.sheets_of(FacetId(f));
    if (std::ranges::any_of(sheets, [&](auto s) { return is_outermost[component_of(s)] != 0; })) {
      continue;
    }
    for (const std::uint32_t s : sheets) result[component_of(s)] = 1;
  }
  return result;
}

}  // namespace

std::vector<std::uint32_t> turn_inside_out(MeshComplex& mesh, Context& context) {
  std::vector<std::uint32_t> turned;
  if (mesh.report.inside_out.empty()) return turned;
  arrange(mesh, context);
  std::vector<std::uint8_t> is_turned = find_outermost(mesh);
  auto face = mesh.report.inside_out.begin();  // of inside-out components in order
  for (std::size_t c = 0; c < is_turned.size(); ++c) {
    if (mesh.is_inside_out[c] == 0) {
      is_turned[c] = 0;
      continue;
    }
    if (is_turned[c] != 0) turned.push_back(*face);
    ++face;
  }
  for (std::size_t s = 0; s < mesh.jump.size(); ++s) {
    if (is_turned[mesh.component[s]] != 0) mesh.jump[s] = -mesh.jump[s];
  }
  return turned;
}

}  // namespace plumb
