// Builds a complex in space from a polygon mesh: vertices, edges and facets, but neither volumes
// nor marks.
//
// Main flow of complex_of_mesh():
//  1. ordered_in_space     sorts meshes of 4,096 and more triangles, unless read as a surface, so
//                          that neighbours are close together in memory
//  2. merge_equal_points   makes points of equal coordinates one vertex; drops unused points
//  3. flatten_mesh         gives every face a plane; triangulates faces that are not planar or not
//                          simple, drops faces without area, and reports each
//  4. merge_doubled        makes facets with the same boundary one; their jumps add up
//  5. trace_borders        checks that every directed edge, cut at the vertices on it, occurs as
//                          often as its reverse; otherwise lists the borders, in input order
//  6. link_facets          makes edges, edge uses, their radial order, and stars
//  7. find_components      finds the connected components and the signs of their volumes
//  8. find_mesh_crossings  finds where the mesh meets itself outside common vertices and edges
//  9. CoplanarMerge        joins neighbours in one plane to one facet, if asked for (simplify.h)
//
// The caller does the rest: arrange() (mesh_arrangement.h), winding_numbers() from the jumps, marks
// by a rule, and simplification, which merges coplanar neighbours. The facets of a mesh that
// crosses itself are not cells of a complex until they are arranged.
//
// Cost: O(n log n + c) for n corners and c pairs of triangles whose boxes meet. Memory: about 300
// bytes per triangle. Source: docs/design/meshes.md.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "plumb/base/context.h"
#include "plumb/base/marks.h"
#include "plumb/predicates/error.h"
#include "plumb/space/mesh_arrays.h"
#include "plumb/space/space_complex.h"

#pragma GCC visibility push(default)
namespace plumb {

/// How complex_of_mesh() reads a mesh.
struct MeshOptions {
  /// Whether an open mesh is accepted, as the set of its facets. Vertices and facets then keep the
  /// order of the input. Otherwise an open mesh gives no complex, only a report with its borders.
  bool surface = false;
  /// Whether neighbours in one plane become one facet, and edges that continue each other one edge,
  /// as in minimal sets. Edges between triangles of one plane then need no second plane. Has no
  /// effect if `surface` is set or the mesh crosses itself.
  bool joins_coplanar = false;
  std::uint64_t max_listed = 1000;  ///< Limit on listed crossing pairs; counts are complete.
};

struct MeshReport;

/// How Nef3::from_mesh() makes a set from a mesh.
struct FromMeshOptions {
  /// Which winding numbers are inside. If there is no rule, the rule is Positive, and components of
  /// negative volume that no other component contains are flipped first, so that a solid whose
  /// faces look inwards is a solid.
  std::optional<WindingRule> rule;
  /// Whether the set consists of the facets of the mesh, which may be open, instead of what they
  /// bound.
  bool surface = false;
  std::uint64_t max_listed = 1000;  ///< Limit on listed crossing pairs; counts are complete.
  MeshReport* report = nullptr;     ///< Receives what was found in the mesh, if it is not null.
};

/// What was found in a mesh. Faces and vertices are 0-based input indices; lists are ascending.
struct MeshReport {
  using FacePair =
      std::pair<std::uint32_t,
                std::uint32_t>;  ///< The lesser and the greater face, unless stated otherwise.

  std::uint64_t vertices_merged = 0;      ///< Used points with the coordinates of an earlier one.
  std::vector<std::uint32_t> degenerate;  ///< Faces without area, which are left out.
  std::vector<std::uint32_t> trimmed;     ///< Faces that lost repeated corners or spikes (a b a).
  std::vector<std::uint32_t> not_planar;  ///< Faces that were triangulated: not planar.
  /// Faces that are not simple polygons. If their edges meet only in common vertices, they were
  /// triangulated; otherwise a fan of triangles with the same winding numbers replaces them.
  std::vector<std::uint32_t> not_simple;
  std::vector<FacePair> doubled;  ///< (Face, earlier face with the same boundary), now one facet.
  /// Closed chains of vertices along which faces are missing, in the direction in which a face that
  /// closes the mesh would run.
  std::vector<std::vector<std::uint32_t>> borders;
  /// Number of pairs of facets that meet outside common vertices and edges.
  std::uint64_t crossing_count = 0;
  std::vector<FacePair> crossings;        ///< The first of them, each pair of faces once.
  std::vector<std::uint32_t> inside_out;  ///< Least faces of the components of negative volume.
  std::vector<std::uint32_t> turned;      ///< Least faces of those that were flipped.

  /// Whether every directed edge occurs as often as its reverse.
  bool is_closed() const { return borders.empty(); }
  /// Whether the mesh meets itself outside common vertices and edges.
  bool crosses_itself() const { return crossing_count > 0; }
};

/// Thrown if a mesh must be closed and is not. The report says where faces are missing.
class OpenMesh : public Error {
 public:
  /// Makes the error from what was found, with the place in a file if there is one.
  explicit OpenMesh(MeshReport report, TextPlace place = {});
  /// Returns what was found in the mesh; borders is not empty.
  [[nodiscard]] const MeshReport& report() const { return *report_; }

 private:
  std::shared_ptr<const MeshReport> report_;  // shared, so that copies cannot fail
};

/// A complex made from a mesh, without volumes and with all marks 0, and the origins of its facets.
/// It is not minimal in general, even where neighbours were joined. A sheet is a facet as it was
/// before the mesh was arranged.
struct MeshComplex {
  SpaceComplex complex;  ///< Its facet_origin names the (least) input face.
  /// Rise of the winding number from the negative to the positive side of each sheet. An input face
  /// contributes 0 on the side from which its corners are seen counter-clockwise (outside), and 1
  /// behind it.
  std::vector<std::int32_t> jump;
  /// Component of each sheet. Sheets that share edges are in one component. Components are
  /// numbered by their least sheet.
  std::vector<std::uint32_t> component;
  std::vector<std::uint8_t> is_inside_out;  ///< Per component, 1 if its volume is negative.
  /// Pairs of sheets that meet outside common vertices and edges, each once.
  std::vector<std::pair<FacetId, FacetId>> crossings;
  std::vector<std::uint8_t> has_fan;  ///< Per vertex (mesh_topology.h); empty once volumes exist.
  // The next two are filled by arrange().
  std::vector<std::uint32_t> sheet_begin;  ///< Starts in `sheet`, facet_count() + 1 of them.
  std::vector<std::uint32_t> sheet;        ///< The sheets that each facet lies in, ascending.
  MeshReport report;                       ///< What was found in the mesh.

  /// Whether arrange() has cut the facets along each other.
  bool is_arranged() const { return !sheet_begin.empty(); }
  /// Returns the sheets that a facet lies in. Requires is_arranged().
  std::span<const std::uint32_t> sheets_of(FacetId f) const {
    return std::span(sheet).subspan(sheet_begin[f.value()],
                                    sheet_begin[f.value() + 1] - sheet_begin[f.value()]);
  }
};

/// Returns the complex of a mesh and a report. The arrays are not needed afterwards. If the mesh is
/// open and options.surface is false, only the report is filled. Throws Error{BadIndex} if a corner
/// names no point, Error{NotFinite} if a coordinate is not finite, and what the context throws.
[[nodiscard]] MeshComplex complex_of_mesh(const MeshView& mesh, const MeshOptions& options = {},
                                          Context& context = unlimited_context());

/// Returns the same for a mesh that owns its arrays.
[[nodiscard]] inline MeshComplex complex_of_mesh(const PolygonMesh& mesh,
                                                 const MeshOptions& options = {},
                                                 Context& context = unlimited_context()) {
  return complex_of_mesh(MeshView(mesh), options, context);
}

}  // namespace plumb
#pragma GCC visibility pop
