// A complex in the making: vertices with their sphere maps, before edges, facets and volumes are
// known. Whoever makes it adds the minimal map of each vertex and says which points of maps face
// each other; join() does the rest.
//
// Main flow of join():
//  1. splice          vertices in the middle of an edge go: what faced them faces each other
//  2. make_edges      each pair of facing points is an edge
//  3. link_uses       the rings of arcs at both ends of an edge are mirror images: this links the
//                     corners of facets to cycles and gives the radial order
//  4. gather_facets   cycles are walked; in each plane holes and inner vertices find the facet
//                     around them (facet_site.h)
//  5. label_volumes   (volumes.h)
//  6. copy marks
//
// Every step is O(n) but the sweeps of planes with holes, O(n log n), and the rays of
// label_volumes.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "plumb/base/context.h"
#include "plumb/space/space_complex.h"
#include "plumb/sphere/sphere_map.h"

namespace plumb {

struct SpaceDraft {
  /// Where the parts of an added map begin.
  struct Offsets {
    std::uint32_t point;
    std::uint32_t arc;
    std::uint32_t face;
  };

  explicit SpaceDraft(std::shared_ptr<const SpaceTables> used_tables)
      : tables(std::move(used_tables)) {}

  /// Adds a vertex, or with is_passed a place inside an edge of the result: two opposite points
  /// whose neighbours will face each other. `origin_ids`: facet_origin for each arc.
  Offsets add(SpacePoint at, const SphereMap& map, bool is_passed,
              std::span<const std::uint32_t> origin_ids);

  /// Drops the last ones, or adds some, to be filled by the caller: none is a place inside an edge,
  /// no point has a face around it, none a twin.
  void resize(std::size_t vertices, std::size_t points, std::size_t arcs, std::size_t faces);

  /// Adds the vertices of a draft over the same tables, in their order.
  void append(const SpaceDraft& other);

  /// Room for so many besides those there are.
  void reserve_more(std::size_t vertices, std::size_t point_count, std::size_t arcs,
                    std::size_t faces);

  std::size_t vertex_count() const { return vertex_point.size(); }
  /// Where the parts of the next map will begin.
  Offsets end() const;
  bool is_free(std::uint32_t point) const { return maps.first_out[point] == kNone; }
  bool is_loop(std::uint32_t arc) const { return maps.is_loop(arc); }

  std::shared_ptr<const SpaceTables> tables;
  SphereMap maps;  ///< all maps, one after the other, with running indices

  // per vertex
  std::vector<SpacePoint> vertex_point;
  std::vector<Mark> vertex_mark;
  std::vector<std::uint8_t> is_passed;
  std::vector<Offsets> begin;

  std::vector<VertexId> vertex_of_point;  ///< per point
  std::vector<std::uint32_t> twin;        ///< per point: the one at the other end of the edge
  std::vector<std::uint32_t> arc_origin;  ///< per arc: facet_origin
};

/// Requires twins, and maps that agree at both ends of every edge: a broken invariant stops the
/// program.
SpaceComplex join(SpaceDraft draft, Context& context);

}  // namespace plumb
