// From a mesh to a complex: the steps in order, and the report on the mesh.
//
// Each step has its own source in mesh/: vertices, facets, links, borders, components, fans and
// crossings. This file calls the steps, keeps the input numbers of faces, and fills the report. A
// mesh that is open and not read as a surface stops after its borders are known.
//
// Large meshes of triangles are first sorted along a space-filling curve, which makes the later
// steps faster; the indices of faces are translated back. An open mesh is read again in its own
// order, so that its report does not depend on the sorting.
//
// Flat edges (between two triangles of one plane) get their second planes only if they stay: for a
// mesh that does not cross itself coplanar neighbours are joined first, and most of them are
// removed (docs/design/meshes.md, "Merging coplanar facets").
//
// A closed mesh that is star-shaped, as all convex ones are, is one component that does not cross
// itself; it is searched for neither components nor fans nor crossings (star_shape.h).
//
// Tested by tests/space/from_mesh_test.cpp.

#include "plumb/space/from_mesh.h"

#include <algorithm>
#include <memory>
#include <string>
#include <utility>

#include "plumb/base/internal/message_text.h"
#include "plumb/base/internal/parallel.h"
#include "plumb/base/internal/work_log.h"
#include "plumb/space/boolean/simplify.h"
#include "plumb/space/mesh/link_facets.h"
#include "plumb/space/mesh/mesh_crossings.h"
#include "plumb/space/mesh/mesh_facets.h"
#include "plumb/space/mesh/mesh_orientation.h"
#include "plumb/space/mesh/mesh_topology.h"
#include "plumb/space/mesh/mesh_vertices.h"
#include "plumb/space/mesh/star_shape.h"

namespace plumb {
namespace {

constexpr std::uint64_t kBytesPerCorner = 200;
constexpr std::uint64_t kBytesPerPoint = 4;  // This also counts points that no face refers to.
// If there are fewer faces, they are close together in any order.
constexpr std::size_t kWorthOrdering = 4096;
// If there are fewer facets, they take less time than starting a thread.
constexpr std::size_t kWorthThreads = 4096;

/// Removes vertices without a facet. They are corners of faces without area.
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

/// Stores the components, and lists those of negative volume by their least faces.
void describe_components(const MeshFacets& facets, MeshComponents components, MeshComplex& result) {
  result.component = std::move(components.of_facet);
  for (const Sign s : components.volume) {
    result.is_inside_out.push_back(s == Sign::Negative ? 1 : 0);
  }
  std::vector<std::uint32_t> least(components.volume.size(), kNone);  // The least input face.
  for (std::uint32_t f = 0; f < facets.size(); ++f) {
    least[result.component[f]] = std::min(least[result.component[f]], facets.origin[f]);
  }
  for (std::size_t c = 0; c < least.size(); ++c) {
    if (result.is_inside_out[c] != 0) result.report.inside_out.push_back(least[c]);
  }
  std::ranges::sort(result.report.inside_out);
}

/// Finds fans and components at the same time, because they do not depend on each other.
void describe_parts(const MeshFacets& facets, MeshComplex& result, Context& context) {
  const auto describe = [&](std::size_t i, Context&) {
    if (i == 0) {
      describe_components(facets, find_components(result.complex, facets.jump), result);
    } else {
      result.has_fan = find_fans(result.complex);
    }
  };
  if (facets.size() >= kWorthThreads) return run_jobs(context, 2, describe);
  for (const std::size_t i : {0U, 1U}) describe(i, context);
}

/// Stores the facts about a star-shaped mesh: it has one component and no crossings, and each
/// vertex has one ring of corners. These rings serve as fans.
void describe_star(const MeshFacets& facets, Sign orientation, MeshComplex& result) {
  describe_components(facets, {std::vector<std::uint32_t>(facets.size(), 0), {orientation}},
                      result);
  result.has_fan.assign(result.complex.vertex_count(), 1);
}

/// Finds crossings, and reports them as pairs of input faces.
void describe_crossings(const MeshOptions& options, BoxOrder order, MeshComplex& result,
                        MemoryCharge& memory, Context& context) {
  const SpaceComplex& complex = result.complex;
  std::vector<MeshReport::FacePair> pairs;
  result.crossings = find_mesh_crossings(complex, result.has_fan, context, order);
  memory.add(result.crossings.size() * (sizeof(result.crossings[0]) + sizeof(pairs[0])),
             "crossings of the mesh");
  pairs.reserve(result.crossings.size());
  for (const auto& [f, g] : result.crossings) {
    pairs.push_back(std::minmax({complex.facet_origin[f], complex.facet_origin[g]}));
  }
  result.report.crossing_count = pairs.size();
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  pairs.resize(std::min<std::uint64_t>(pairs.size(), options.max_listed));
  result.report.crossings = std::move(pairs);
}

/// Moves the data about cells that are kept to their new numbers. If several cells get the same
/// number, their data agree.
template <class T, class Id>
void renumber(std::span<const Id> number, std::vector<T>& known) {
  std::size_t count = 0;
  // The numbers are ascending at their first occurrences.
  for (std::size_t i = 0; i < number.size(); ++i) {
    if (number[i].is_valid() && number[i].value() == count) known[count++] = known[i];
  }
  known.resize(count);
}

/// If the caller wants it and the mesh does not cross itself, joins coplanar neighbours, which
/// removes open edges. Otherwise, completes open edges.
void settle_flat_edges(const MeshOptions& options, SpaceTables& tables, MeshComplex& mesh,
                       Context& context) {
  if (!options.joins_coplanar || options.surface || !mesh.crossings.empty()) {
    return complete_flat_edges(mesh.complex, tables);
  }
  CoplanarMerge merge(mesh.complex, context);
  if (!merge.is_needed()) return;
  SpaceComplex joined = merge.run(context);
  renumber(merge.facet_numbers(), mesh.jump);
  renumber(merge.facet_numbers(), mesh.component);
  renumber(merge.vertex_numbers(), mesh.has_fan);
  mesh.complex = std::move(joined);
}

/// Gives the faces of an ordered mesh their original numbers.
void rename_faces(std::span<const std::uint32_t> name, MeshFacets& facets, MeshReport& report) {
  for (std::uint32_t& f : facets.origin) f = name[f];
  // Faces of triangles have no other entries in the report.
  for (auto* const list : {&report.degenerate, &report.trimmed}) {
    for (std::uint32_t& f : *list) f = name[f];
    std::ranges::sort(*list);
  }
  for (auto& [f, g] : report.doubled) {
    f = name[f];
    g = name[g];
  }
  std::ranges::sort(report.doubled);
}

using Chains = std::vector<std::vector<std::uint32_t>>;

/// Gives vertices of chains the numbers that points have in the mesh that was read.
void rename_chains(const MeshVertices& vertices, Chains& chains) {
  for (auto& chain : chains) {
    for (std::uint32_t& v : chain) v = vertices.input[v];
  }
}

/// Finds the reason why a mesh is open.
void describe_borders(const MeshView& mesh, const MeshVertices& vertices, const Point3Table& points,
                      MeshReport& report, Context& context) {
  MeshOrientation orientation = orient_faces(mesh, vertices, points, context, &report.borders);
  report.flipped = std::move(orientation.flipped);
  report.holes = std::move(orientation.holes);
  report.one_sided = std::move(orientation.one_sided);
  rename_chains(vertices, report.holes);
}

/// Returns the complex of `ordered`, which was made from `input`, or of `input` if `ordered` is
/// empty. In borders, points have the numbers of the mesh that was read.
MeshComplex complex_in_order(const MeshView& input, OrderedMesh ordered, const MeshOptions& options,
                             MemoryCharge& memory, Context& context) {
  MeshComplex result;
  const auto tables = std::make_shared<SpaceTables>();
  WorkPhase phase("equal points");
  const MeshView mesh = ordered.is_empty() ? input : ordered.view();
  MeshVertices vertices =
      ordered.is_empty() ? merge_equal_points(mesh, *tables) : merge_equal_points(ordered, *tables);
  result.report.vertices_merged = vertices.merged;
  context.checkpoint("reading faces", 0, 1);
  phase.next("planes of faces");
  MeshFacets facets = flatten_mesh(mesh, vertices, *tables, result.report, context);
  phase.next("links of corners");
  MeshLinks links = link_corners(facets, vertices.point.size());
  const bool is_plain = is_plainly_closed(facets, links);
  if (!is_plain) result.report.doubled = merge_doubled(facets, links, vertices.point.size());
  const bool has_input_order = ordered.is_empty();
  if (!has_input_order) rename_faces(ordered.face, facets, result.report);
  ordered = {};
  if (!is_plain) {
    result.report.borders = trace_borders(facets, links, vertices.point, tables->points, context);
  }
  const bool is_refused = !result.report.is_closed() && !options.surface;
  if (is_refused && has_input_order) {
    describe_borders(input, vertices, tables->points, result.report, context);
  }
  rename_chains(vertices, result.report.borders);
  if (is_refused) return result;

  context.checkpoint("linking facets", 0, 1);
  phase.next("edges and stars");
  drop_unused(facets, links, vertices);
  result.complex = link_facets(facets, links, vertices.point, tables, FlatEdges::Open);
  context.checkpoint("components", 0, 1);
  phase.next("fans and components");
  const Sign star =
      is_plain ? star_orientation(facets, vertices.point, tables->points) : Sign::Zero;
  if (star == Sign::Zero) {
    describe_parts(facets, result, context);
  } else {
    describe_star(facets, star, result);
  }
  result.jump = std::move(facets.jump);
  facets = {};  // The search for crossings needs memory.
  links = {};
  vertices = {};
  phase.next("self-test");
  if (star == Sign::Zero) {
    describe_crossings(options, has_input_order ? BoxOrder::Any : BoxOrder::Kept, result, memory,
                       context);
  }
  phase.next("coplanar facets");
  settle_flat_edges(options, *tables, result, context);
  return result;
}

/// Returns a text such as "the mesh is open: 2 border(s), the first along the vertices 3, 8, 11 and
/// 5 more (0-based)".
std::string text_of_chains(const Chains& chains) {
  std::string text = "the mesh is open: " + std::to_string(chains.size()) + " border(s)";
  if (chains.empty()) return text;
  return text + ", the first along the vertices " + listed(chains.front()) + " (0-based)";
}

/// Returns a text such as "the mesh has no holes, but 2 faces are flipped: 0, 7 (0-based)".
std::string open_mesh_message(const MeshReport& report) {
  const bool is_one = report.flipped.size() == 1;
  const std::string flipped =
      (is_one ? "1 face is flipped: "
              : std::to_string(report.flipped.size()) + " faces are flipped: ") +
      listed(report.flipped) + " (0-based)";
  if (!report.one_sided.empty()) {
    return "the mesh has a component with one side only, as a Moebius strip: neighbouring faces "
           "cannot all agree; its first face is " +
           std::to_string(report.one_sided.front()) + " (0-based)";
  }
  if (report.flipped.empty()) return text_of_chains(report.borders);
  if (report.holes.empty()) return "the mesh has no holes, but " + flipped;
  return text_of_chains(report.holes) + "; besides, " + flipped;
}

}  // namespace

OpenMesh::OpenMesh(MeshReport report, TextPlace place)
    : Error(ErrorCode::BadShape, open_mesh_message(report), std::move(place)),
      report_(std::make_shared<const MeshReport>(std::move(report))) {}

// An open mesh is read again in its own order, because its report must have the numbers of the
// input.
MeshComplex complex_of_mesh(const MeshView& mesh, const MeshOptions& options, Context& context) {
  MemoryCharge memory(context);
  memory.add(kBytesPerCorner * mesh.corners.size() + kBytesPerPoint * mesh.point_count(), "a mesh");
  if (mesh.face_count() >= kWorthOrdering && !options.surface) {
    OrderedMesh ordered = [&] {
      const WorkPhase phase("order of points");
      return ordered_in_space(mesh);
    }();
    if (!ordered.is_empty()) {
      MeshComplex result = complex_in_order(mesh, std::move(ordered), options, memory, context);
      if (result.report.is_closed()) return result;
    }
  }
  return complex_in_order(mesh, {}, options, memory, context);
}

}  // namespace plumb
