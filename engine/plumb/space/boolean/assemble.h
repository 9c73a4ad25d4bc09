// A complex in the making: vertices with their sphere maps, before edges, facets and volumes are
// known. Its maker adds the minimal map of each vertex and pairs the points of maps that face each
// other; assemble() does the rest.
//
// Main flow of assemble():
//  1. splice             removes vertices inside edges: what faced them faces each other
//  2. make_vertices      copies the vertices that stay
//  3. make_edges         makes an edge of each pair of facing points
//  4. link_uses          matches the rings of arcs at both ends of an edge, which are mirror
//                        images: this links the corners of facets to cycles and gives the radial
//                        order
//  5. gather_facets      walks the cycles; in each plane holes and inner vertices find the facet
//                        around them (facet_site.h)
//  6. label_volumes      finds the volumes (volumes.h)
//  7. copy_volume_marks  copies the marks of volumes from the faces of the maps
//
// Every step is O(n), except the sweeps of planes with holes, O(n log n), and the rays of
// label_volumes(). Proof: docs/design/boolean.md, steps 6 and 7 of "The algorithm".
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "plumb/base/context.h"
#include "plumb/space/space_complex.h"
#include "plumb/sphere/sphere_map.h"

namespace plumb {

/// Vertices with their sphere maps. Indices of points, arcs and faces run through all maps.
struct SpaceDraft {
  /// The indices at which the parts of an added map begin.
  struct Offsets {
    std::uint32_t point;  ///< Index of its first point.
    std::uint32_t arc;    ///< Index of its first arc.
    std::uint32_t face;   ///< Index of its first face.
  };

  /// Makes a draft without vertices. Its points will come from the tables.
  explicit SpaceDraft(std::shared_ptr<const SpaceTables> used_tables)
      : tables(std::move(used_tables)) {}

  /// Adds a vertex, or with is_passed a place inside an edge of the result: two opposite points
  /// whose neighbours will face each other. `origin_ids` has a facet_origin for each arc. Returns
  /// where the parts of the map begin.
  Offsets add(SpacePoint at, const SphereMap& map, bool is_passed,
              std::span<const std::uint32_t> origin_ids);

  /// Drops the last vertices and their maps, or adds some for the caller to fill: none of them is a
  /// place inside an edge, no point has a face around it, none has a twin.
  void resize(std::size_t vertices, std::size_t points, std::size_t arcs, std::size_t faces);

  /// Appends the vertices of drafts over the same tables, in their order, and uses them up.
  void take_all(std::span<SpaceDraft* const> parts, Context& context);

  /// Reserves memory for so many vertices, points, arcs and faces besides those there are.
  void reserve_more(std::size_t vertices, std::size_t point_count, std::size_t arcs,
                    std::size_t faces);

  /// Returns the number of vertices, places inside edges included.
  std::size_t vertex_count() const { return vertex_point.size(); }
  /// Returns where the parts of the next map will begin.
  Offsets end() const;
  /// Whether no arc leaves the point: it is a free edge.
  bool is_free(std::uint32_t point) const { return maps.first_out[point] == kNone; }
  /// Whether the arc is a whole circle: the vertex lies inside a facet.
  bool is_loop(std::uint32_t arc) const { return maps.is_loop(arc); }

  std::shared_ptr<const SpaceTables> tables;  ///< Planes and points, to which the maker may add.
  SphereMap maps;  ///< All maps, one after the other, with running indices.

  // One entry for each vertex.
  IdVector<VertexId, SpacePoint> vertex_point;  ///< Its place.
  IdVector<VertexId, Mark> vertex_mark;         ///< Its mark.
  IdVector<VertexId, std::uint8_t> is_passed;   ///< 1 if it is a place inside an edge.
  IdVector<VertexId, Offsets> begin;            ///< The indices at which its map begins.

  std::vector<VertexId> vertex_of_point;  ///< The vertex of each point.
  std::vector<std::uint32_t> twin;        ///< The point at the other end of each point's edge.
  std::vector<std::uint32_t> arc_origin;  ///< The facet_origin of each arc.
};

/// Returns the complex of a draft. Requires that all points have twins and that the maps agree at
/// both ends of every edge: a broken invariant stops the program. A draft without vertices gives
/// one volume with mark 0. Throws the errors of the Context.
SpaceComplex assemble(SpaceDraft draft, Context& context);

}  // namespace plumb
