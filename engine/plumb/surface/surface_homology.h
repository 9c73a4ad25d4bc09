// The homology of a surface, and the loops that must be added to a polygon so that it separates the
// surface.
//
// Each border counts as closed by a disk. So a cycle that bounds only with the help of the border
// separates the surface, too.
//
// Main flow of the constructor (tree and cotree; D. Eppstein, Dynamic generators of topologically
// embedded graphs, SODA 2003):
//  1. tree       spans the vertices, breadth first
//  2. cotree     spans the faces and the disks, over edges that are not in the tree
//  3. generators are the 2 g edges that are in neither tree, for genus g; each closes a loop with
//                the tree
//  4. dual loops cross one of these edges each, and return through the cotree
//
// The class of a polygon has one coefficient for each generator. The polygon is pushed onto edges,
// point by point. The coefficient is the signed number of times that the pushed polygon crosses the
// dual loop of the generator. This is correct for the following reason. Dual loops cross edges of
// the cotree, and one generator each. Adding faces to the polygon would clear it from all edges of
// the cotree, without a change of its crossings with dual loops. Each generator would then remain
// as often as its dual loop is crossed.
//
// Cost: the constructor takes O(mesh + length of the dual loops); breadth first search keeps these
// loops short. A class takes O(length of the polygon * dual loops across its edges + 2 g), and a
// loop O(its length). Errors: ResourceLimit and Cancelled as the Context demands. Proofs:
// docs/design/surface.md.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "plumb/base/context.h"
#include "plumb/surface/surface_mesh.h"
#include "plumb/surface/surface_path.h"

#pragma GCC visibility push(default)
namespace plumb {

/// Generators of the first homology of a mesh relative to its border, and the classes of polygons
/// as sums of these generators.
class SurfaceHomology {
 public:
  /// Computes generators and dual loops. The mesh must outlive the object. Throws what the context
  /// throws.
  explicit SurfaceHomology(const SurfaceMesh& mesh, Context& context = unlimited_context());

  /// Returns the number of generators: twice the sum of the genera of all components.
  std::size_t generator_count() const { return generators_.size(); }
  /// Returns the vertices of generator i, a closed loop of edges, in order and each once.
  std::vector<VertexId> generator(std::size_t i) const;

  /// Returns the coefficients of the generators whose sum is homologous to the polygon. The polygon
  /// separates the surface if and only if all coefficients are zero. Requires valid polygons
  /// (require_valid()). Throws what the context throws.
  std::vector<std::int64_t> class_of(const SurfacePolygons& polygons, std::size_t polygon,
                                     Context& context = unlimited_context()) const;
  /// Returns the class of a sum of polygons. A polygon that occurs in `sum` several times adds its
  /// class that many times, but the class is computed only once.
  std::vector<std::int64_t> class_of(const SurfacePolygons& polygons,
                                     std::span<const std::uint32_t> sum,
                                     Context& context = unlimited_context()) const;

  /// Appends generator i, or its reverse, to `polygons`.
  void add_generator(std::size_t i, bool is_reversed, SurfacePolygons& polygons) const;
  /// Appends the loops that must be added to a shape, a sum of polygons, so that it separates the
  /// surface. Returns the indices of the new polygons. Throws what the context throws.
  std::vector<std::uint32_t> add_repair(std::span<const std::uint32_t> shape,
                                        SurfacePolygons& polygons,
                                        Context& context = unlimited_context()) const;

 private:
  /// A step of a spanning tree towards the root: the parent and the edge to it.
  struct Step {
    std::uint32_t node;
    EdgeId edge;  ///< Invalid at roots.
  };

  void grow_tree();
  void find_disks();
  void grow_cotree();
  VertexId across(EdgeId e, VertexId v) const;
  std::vector<VertexId> to_root(VertexId v) const;
  VertexId vertex_at(const SurfacePointTable& points, SurfacePointId p) const;
  void cross_dual_loops(Context& context);
  std::uint32_t node_behind(HalfedgeId h) const;
  /// Adds the class of a polygon times `multiplicity` to `times`.
  void count(const SurfacePolygons& polygons, std::size_t polygon, std::int64_t multiplicity,
             std::vector<std::int64_t>& times, Context& context) const;

  const SurfaceMesh& mesh_;
  std::vector<EdgeId> parent_;             // The edge to the parent of each vertex.
  std::vector<std::uint8_t> is_in_tree_;   // For each edge: 1 tree, 2 cotree.
  std::vector<std::uint32_t> disk_of_;     // For each half-edge at the border.
  std::vector<std::uint32_t> disk_begin_;  // For each disk and one more, into disk_halfedges_.
  std::vector<HalfedgeId> disk_halfedges_;
  std::vector<Step> cotree_;  // Faces, then disks by number; parents first.
  std::vector<EdgeId> generators_;
  // For each edge, the dual loops across it, as (generator, +1 or -1).
  std::vector<std::uint32_t> crossed_begin_;
  std::vector<SignedEntry> crossed_;
};

}  // namespace plumb
#pragma GCC visibility pop
