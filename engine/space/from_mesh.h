// From polygons to a complex in space: everything but volumes and marks.
//
// Main flow of complex_of_mesh():
//  1. ordered_in_space     of 4,096 triangles and more, no surface: neighbours close together in memory
//  2. merge_equal_points   points of equal coordinates are one vertex; unused ones go
//  3. flatten_mesh         a plane for every face; faces that are not planar or not simple become triangles,
//                          faces without area go; each is reported
//  4. merge_doubled        facets with the same boundary become one; jumps add up
//  5. trace_borders        every directed edge as often as its reverse, edges cut at vertices on them? else
//                          the border is listed, in the order of the input
//  6. link_facets          edges, uses, radial order, stars
//  7. find_components      connected parts and the signs of their volumes
//  8. find_mesh_crossings  does the mesh meet itself anywhere but in common vertices and edges?
//  9. CoplanarMerge        if asked for: neighbours in one plane are one facet (merge_coplanar.h)
//
// What follows is up to the caller: arrange() (mesh_arrangement.h), winding_numbers() of the jumps, marks by
// a rule, simplification (which merges coplanar neighbours). The facets of a mesh that crosses itself are
// no cells before they are arranged.
//
// Cost: O(n log n + c) for n corners and c pairs of triangles with common boxes. Memory: about 300
// bytes a triangle.
#pragma once

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "plumb/base/context.h"
#include "plumb/space/mesh_arrays.h"
#include "plumb/space/space_complex.h"

#pragma GCC visibility push(default)
namespace plumb {

/// How a mesh is read.
struct MeshOptions {
  /// An open mesh is its facets (else: no complex, borders listed). Vertices and facets are in the order of the input.
  bool surface = false;
  /// Neighbours in one plane are one facet, and edges that continue each other one, as in minimal sets, if the mesh is no surface
  /// and does not cross itself: then edges between triangles of one plane need no second one.
  bool joins_coplanar = false;
  std::uint64_t max_listed = 1000;  ///< pairs of crossing faces to list; counts are complete
};

/// What was found in a mesh. Faces and vertices are numbers in the input, 0-based; lists ascend.
struct MeshReport {
  using FacePair = std::pair<std::uint32_t, std::uint32_t>;  ///< two faces

  std::uint64_t vertices_merged = 0;  ///< used points that have the coordinates of an earlier one
  std::vector<std::uint32_t> degenerate;  ///< faces without area: left out
  std::vector<std::uint32_t> trimmed;     ///< repeated corners and spikes (a b a) were cut off
  std::vector<std::uint32_t> not_planar;  ///< triangulated
  /// Not simple polygons: triangulated where their edges meet in common vertices only, else
  /// replaced by a fan of triangles that winds as often around every point.
  std::vector<std::uint32_t> not_simple;
  std::vector<FacePair> doubled;  ///< (face, earlier face with the same boundary): one facet now
  /// Where faces are missing: closed chains of vertices, in the direction in which a face that
  /// closes the mesh would run.
  std::vector<std::vector<std::uint32_t>> borders;
  std::uint64_t crossing_count =
      0;                            ///< pairs of facets that meet outside common vertices and edges
  std::vector<FacePair> crossings;  ///< the first of them, each pair of faces once
  std::vector<std::uint32_t> inside_out;  ///< components of negative volume, by their least face

  /// Does every directed edge come as often as its reverse?
  bool is_closed() const { return borders.empty(); }
  /// Does it meet itself outside common vertices and edges?
  bool crosses_itself() const { return crossing_count > 0; }
};

/// A complex without volumes and marks (all 0), minimal at most where neighbours were joined, and where its facets come
/// from. A sheet is a facet before the mesh is arranged.
struct MeshComplex {
  SpaceComplex complex;  ///< facet_origin: the (least) input face
  /// Per sheet: how much the winding number rises from its negative to its positive side. An input
  /// face has the outside, 0, where its corners are seen counter-clockwise, and 1 behind it.
  std::vector<std::int32_t> jump;
  /// Per sheet. Components are closed, joined by edges, numbered by their least sheet.
  std::vector<std::uint32_t> component;
  std::vector<std::uint8_t> is_inside_out;  ///< per component: negative volume
  /// Sheets that meet outside common vertices and edges, each pair once.
  std::vector<std::pair<FacetId, FacetId>> crossings;
  std::vector<std::uint8_t> has_fan;  ///< per vertex (mesh_fans.h); empty once there are volumes
  // Filled by arrange().
  std::vector<std::uint32_t> sheet_begin;  ///< facet_count() + 1 entries into sheet
  std::vector<std::uint32_t> sheet;        ///< those that a facet lies in, ascending
  MeshReport report;                       ///< what was found

  /// Has arrange() cut the facets along each other?
  bool is_arranged() const { return !sheet_begin.empty(); }
  /// The sheets that a facet of the arrangement lies in.
  std::span<const std::uint32_t> sheets_of(FacetId f) const {
    return std::span(sheet).subspan(sheet_begin[f.value()],
                                    sheet_begin[f.value() + 1] - sheet_begin[f.value()]);
  }
};

/// Throws Error{BadIndex} for a corner that is no vertex, Error{NotFinite}, and what the context
/// throws. The arrays are not needed afterwards. Of an open mesh without options.surface only the report is filled.
MeshComplex complex_of_mesh(const MeshView& mesh, const MeshOptions& options, Context& context);

}  // namespace plumb
#pragma GCC visibility pop
