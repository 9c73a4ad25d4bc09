// Builds a complex in space from a polygon mesh. The complex has vertices, edges and facets, but
// neither volumes nor marks.
//
// Main flow of complex_of_mesh():
//  1. ordered_in_space     sorts the faces of the mesh so that neighbours in space are close
//                          together in memory. This step is taken only for a mesh of 4,096 or more
//                          triangles, and only if MeshOptions::surface is false
//  2. merge_equal_points   replaces all points with equal coordinates by one vertex, and drops
//                          points that no face uses
//  3. flatten_mesh         finds the plane of every face. Faces that are not planar or not simple
//                          are triangulated, and faces without area are dropped. All such faces are
//                          listed in the report
//  4. merge_doubled        makes one facet of all facets with the same boundary. The jump of a
//                          facet is the winding number on its positive side minus the winding
//                          number on its negative side (MeshComplex::jump). The new facet gets the
//                          sum of the jumps of the old facets
//  5. trace_borders        cuts each directed edge at the vertices that lie on the edge. Then the
//                          step checks that each directed part of an edge occurs as often as the
//                          same part in the opposite direction. If this is not the case, the step
//                          lists the borders in the order of the input. Then orient_faces()
//                          (mesh_orientation.h) finds out which borders are caused by flipped
//                          faces, and which by missing faces
//  6. link_facets          makes edges, edge uses, the radial order of the edge uses, and stars
//  7. find_components      finds the connected components and the signs of their volumes
//  8. find_mesh_crossings  finds pairs of facets that have a common point outside their common
//                          vertices and edges
//  9. CoplanarMerge        if MeshOptions::joins_coplanar is set, joins neighbouring facets in the
//                          same plane into one facet (simplify.h)
//
// The caller does the remaining steps:
//  - arrange() (mesh_arrangement.h) cuts the facets along the lines in which they meet,
//  - winding_numbers() computes winding numbers from the jumps,
//  - a winding rule turns winding numbers into marks,
//  - simplification merges coplanar neighbours.
//
// If a mesh crosses itself, its facets overlap or cross before arrange(). So only after arrange()
// are they cells of a valid complex.
//
// Cost: O(n log n + c) for n corners and c pairs of triangles whose bounding boxes meet. Memory:
// about 300 bytes per triangle. Source: docs/design/meshes.md.
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

/// Options of complex_of_mesh().
struct MeshOptions {
  /// Whether the mesh represents the union of its facets, and not a solid. In this case the mesh
  /// may be open, and vertices and facets keep the order of the input. If this option is false, an
  /// open mesh gives only a report with the borders, but no complex.
  bool surface = false;
  /// Whether neighbouring facets in the same plane become one facet, as in minimal sets. In this
  /// case, consecutive edges on one line also become one edge, and no second plane is stored for an
  /// edge between two triangles in the same plane. This option has no effect if `surface` is set or
  /// the mesh crosses itself.
  bool joins_coplanar = false;
  /// The greatest number of crossing pairs that are listed. The count includes all pairs.
  std::uint64_t max_listed = 1000;
};

struct MeshReport;

/// Options of Nef3::from_mesh().
struct FromMeshOptions {
  /// The rule that determines which winding numbers count as inside. If there is no value, the rule
  /// is Positive. In this case, each component of negative volume that does not lie inside another
  /// component is flipped first. So a mesh whose faces are all oriented inwards also becomes a
  /// solid.
  std::optional<WindingRule> rule;
  /// Whether the set consists of the facets of the mesh instead of the volumes that the facets
  /// bound. The mesh may then be open.
  bool surface = false;
  /// The greatest number of crossing pairs that are listed. The count includes all pairs.
  std::uint64_t max_listed = 1000;
  /// If this pointer is not null, a report on the mesh is stored there.
  MeshReport* report = nullptr;
};

/// A report on a mesh: its defects and other special cases, such as merged points. Faces and
/// vertices are 0-based indices of the input. All lists are in ascending order.
struct MeshReport {
  using FacePair =
      std::pair<std::uint32_t,
                std::uint32_t>;  ///< Two faces, the lesser index first, unless stated otherwise.

  /// The number of points that were merged into an earlier point with equal coordinates. Points
  /// that no face uses are not counted.
  std::uint64_t vertices_merged = 0;
  std::vector<std::uint32_t>
      degenerate;                      ///< Faces without area; the complex does not contain them.
  std::vector<std::uint32_t> trimmed;  ///< Faces that lost repeated corners or spikes (a b a).
  std::vector<std::uint32_t> not_planar;  ///< Faces that are not planar; they were triangulated.
  /// Faces that are not simple polygons. A face whose edges meet only in common vertices was
  /// triangulated. Any other face in this list was replaced by a fan of triangles with the same
  /// winding numbers.
  std::vector<std::uint32_t> not_simple;
  /// Pairs of faces with the same boundary. The second face of a pair comes before the first face
  /// in the mesh. The two faces became one facet.
  std::vector<FacePair> doubled;
  /// Closed chains of vertices along which faces are missing or flipped. Each chain has the
  /// direction that the boundary of a missing face would have.
  std::vector<std::vector<std::uint32_t>> borders;
  // The next three lists state the causes of borders. They are filled if the mesh is open and was
  // not read as a surface.
  /// Faces that should be flipped, because they are not oriented like their neighbours. Consider a
  /// connected set of faces whose orientations disagree. The set consists of two parts: if one of
  /// the parts is flipped, all orientations agree. The smaller part is listed here. If both parts
  /// have the same number of faces, the list contains the part that must be flipped to make the
  /// volume positive.
  std::vector<std::uint32_t> flipped;
  /// Closed chains of vertices along which faces are missing after the faces in `flipped` have been
  /// flipped. If this list is empty, flipping these faces closes the mesh.
  std::vector<std::vector<std::uint32_t>> holes;
  /// For each connected set of faces whose orientations cannot agree (such as a Moebius strip), the
  /// face with the least index.
  std::vector<std::uint32_t> one_sided;
  /// Number of pairs of facets that meet outside common vertices and edges.
  std::uint64_t crossing_count = 0;
  std::vector<FacePair> crossings;  ///< The first pairs of faces that cross; each pair occurs once.
  /// For each component with negative volume, the face with the least index.
  std::vector<std::uint32_t> inside_out;
  /// For each component that was flipped, the face with the least index.
  std::vector<std::uint32_t> turned;

  /// Whether every directed edge occurs as often as the edge in the opposite direction.
  bool is_closed() const { return borders.empty(); }
  /// Whether the mesh meets itself outside common vertices and edges.
  bool crosses_itself() const { return crossing_count > 0; }
};

/// The error that is thrown if a mesh must be closed but is open. The report of the error lists the
/// places where faces are missing.
class OpenMesh : public Error {
 public:
  /// Constructs the error from the report and an optional position in a file.
  explicit OpenMesh(MeshReport report, TextPlace place = {});
  /// Returns the report on the mesh. Its list of borders is not empty.
  [[nodiscard]] const MeshReport& report() const { return *report_; }

 private:
  std::shared_ptr<const MeshReport> report_;  // shared, so that copies cannot fail
};

/// A complex made from a mesh, and the origins of its facets. The complex has no volumes, and all
/// its marks are 0. In general, the complex is not minimal, even if neighbouring coplanar facets
/// were joined. A sheet is a facet of the mesh before arrange() cuts the facets. After arrange(), a
/// sheet can consist of several facets.
struct MeshComplex {
  /// The complex. The facet_origin of each facet is the index of the input face from which the
  /// facet was made. If several faces became one facet, facet_origin is the least of their indices.
  SpaceComplex complex;
  /// For each sheet, the winding number on its positive side minus the winding number on its
  /// negative side. The front of an input face is the side from which its corners appear
  /// counter-clockwise. The winding number behind an input face is 1 more than the winding number
  /// in front of the face.
  std::vector<std::int32_t> jump;
  /// The index of the component of each sheet. Sheets that share an edge are in the same component.
  /// Components are in the order of their least sheets.
  std::vector<std::uint32_t> component;
  /// For each component, 1 if its volume is negative, else 0.
  std::vector<std::uint8_t> is_inside_out;
  /// The pairs of sheets that have a common point outside their common vertices and edges. Each
  /// pair occurs once.
  std::vector<std::pair<FacetId, FacetId>> crossings;
  /// For each vertex, 1 if find_fans() found that the corners at the vertex form a fan
  /// (mesh_topology.h), or if the mesh is star-shaped (star_shape.h), else 0. At such a vertex the
  /// sectors of the facets form one ring, and no two of them cross. The list is empty after the
  /// volumes have been found.
  std::vector<std::uint8_t> has_fan;
  // arrange() fills the next two fields.
  /// For each facet, the index in `sheet` at which its sheets start. The last entry is the size of
  /// `sheet`.
  std::vector<std::uint32_t> sheet_begin;
  std::vector<std::uint32_t> sheet;  ///< For each facet, the sheets that contain it, ascending.
  MeshReport report;                 ///< The report on the mesh.

  /// Whether arrange() has cut the facets along each other.
  bool is_arranged() const { return !sheet_begin.empty(); }
  /// Returns the sheets that contain a facet. Requires is_arranged().
  std::span<const std::uint32_t> sheets_of(FacetId f) const {
    return std::span(sheet).subspan(sheet_begin[f.value()],
                                    sheet_begin[f.value() + 1] - sheet_begin[f.value()]);
  }
};

/// Returns a report on a mesh, and the complex of the mesh. The arrays of the mesh are not needed
/// afterwards. If the mesh is open and options.surface is false, only the report is filled. Throws
/// Error{BadIndex} if a corner is not the index of a point. Throws Error{NotFinite} if a coordinate
/// is not finite. Also throws the errors of the Context.
[[nodiscard]] MeshComplex complex_of_mesh(const MeshView& mesh, const MeshOptions& options = {},
                                          Context& context = unlimited_context());

/// Calls the function above for a mesh that owns its arrays.
[[nodiscard]] inline MeshComplex complex_of_mesh(const PolygonMesh& mesh,
                                                 const MeshOptions& options = {},
                                                 Context& context = unlimited_context()) {
  return complex_of_mesh(MeshView(mesh), options, context);
}

}  // namespace plumb
#pragma GCC visibility pop
