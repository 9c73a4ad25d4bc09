// The homology of a surface, and what a polygon that does not separate lacks.
//
// A surface with border counts as closed by a disk at each border: a cycle that bounds with the border's help
// separates.
//
// Main flow of the constructor (tree-cotree; Eppstein, SODA 2003):
//  1. tree       spans the vertices, breadth first
//  2. cotree     spans the faces and the disks, over edges that are not in the tree
//  3. generators the edges left over, 2 g of them: each closes a loop with the tree
//  4. dual loops each leads across an edge left over and home over the cotree
// Class of a polygon: it is pushed onto edges, point by point; how often it then crosses the dual loop of a generator
// counts that. (Adding faces would clear it from the cotree, where alone dual loops meet other edges, and leave that
// many times the generator.)
//
// Cost: O(mesh + length of the dual loops, which breadth first keeps short); a class O(length of the polygon x dual
// loops across its edges + 2 g); a loop O(its length). Errors: ResourceLimit, Cancelled.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "plumb/base/context.h"
#include "plumb/surface/surface_ids.h"
#include "plumb/surface/surface_path.h"

#pragma GCC visibility push(default)
namespace plumb {

/// Loops that generate the first homology of a mesh relative to its border, and classes of polygons
/// in them.
class SurfaceHomology {
 public:
  /// The mesh has to outlive it.
  SurfaceHomology(const SurfaceMesh& mesh, Context& context);

  /// Twice the genus, of all components together.
  std::size_t generator_count() const { return generators_.size(); }
  /// The vertices of a generator, along edges; none twice.
  std::vector<VertexId> generator(std::size_t i) const;

  /// A polygon is homologous to the sum of generators times these. All zero: it separates. Requires
  /// require_valid(polygons) to pass.
  std::vector<std::int64_t> class_of(const SurfacePolygons& polygons, std::size_t polygon,
                                     Context& context) const;
  /// The same for a sum of polygons, where a polygon may be named many times: each is counted once.
  std::vector<std::int64_t> class_of(const SurfacePolygons& polygons,
                                     std::span<const std::uint32_t> sum, Context& context) const;

  /// Appends a generator as a polygon, or its reverse.
  void add_generator(std::size_t i, bool is_reversed, SurfacePolygons& polygons) const;
  /// Appends the loops that have to be added to a shape so that it separates; returns their numbers.
  std::vector<std::uint32_t> add_repair(std::span<const std::uint32_t> shape,
                                        SurfacePolygons& polygons, Context& context) const;

 private:
  /// A step of a spanning tree: the edge to the parent.
  struct Step {
    std::uint32_t node;
    EdgeId edge;  ///< invalid at roots
  };

  void grow_tree();
  void find_disks();
  void grow_cotree();
  VertexId across(EdgeId e, VertexId v) const;
  std::vector<VertexId> to_root(VertexId v) const;
  VertexId vertex_at(const SurfacePointTable& points, SurfacePointId p) const;
  void cross_dual_loops(Context& context);
  std::uint32_t node_behind(HalfedgeId h) const;
  /// Adds the class of a polygon, so many times.
  void count(const SurfacePolygons& polygons, std::size_t polygon, std::int64_t multiplicity,
             std::vector<std::int64_t>& times, Context& context) const;

  const SurfaceMesh& mesh_;
  std::vector<EdgeId> parent_;             // per vertex
  std::vector<std::uint8_t> is_in_tree_;   // per edge: 1 tree, 2 cotree
  std::vector<std::uint32_t> disk_of_;     // per half-edge at the border
  std::vector<std::uint32_t> disk_begin_;  // per disk and one more, into disk_halfedges_
  std::vector<HalfedgeId> disk_halfedges_;
  std::vector<Step> cotree_;  // faces, then disks by number; parents first
  std::vector<EdgeId> generators_;
  // Per edge: the dual loops across it, as (generator, +1 or -1).
  std::vector<std::uint32_t> crossed_begin_;
  std::vector<SignedEntry> crossed_;
};

}  // namespace plumb
#pragma GCC visibility pop
