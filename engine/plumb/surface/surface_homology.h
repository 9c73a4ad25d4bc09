// The homology of a surface. If a polygon does not separate the surface, loops can be added so that
// the polygon and the loops together separate the surface.
//
// Homology is computed as if each loop of the border of the mesh were closed by a disk. So a cycle
// also separates the surface if the cycle and parts of the border together bound a region.
//
// Main flow of the constructor (tree and cotree; D. Eppstein, Dynamic generators of topologically
// embedded graphs, SODA 2003):
//  1. tree       grows a spanning tree of the vertices, breadth first
//  2. cotree     grows a spanning tree of the faces and disks (the cotree). A link of the cotree
//                leads from a face or disk to its neighbour across a mesh edge that is not in the
//                first tree
//  3. generators are made from all edges that remain: the edges that are not in the tree, and that
//                the cotree does not cross. For genus g there are 2 g such edges. Each of these
//                edges closes one loop with edges of the first tree; this loop is its generator
//  4. dual loops are made from the same edges. Each dual loop crosses one of these edges, and
//                returns through the cotree
//
// The class of a polygon has one coefficient for each generator. To compute the class, the polygon
// is first replaced by a homologous polygon that runs along edges of the mesh. The coefficient of a
// generator is the signed number of times that this polygon crosses the dual loop of the generator.
// This is correct for the following reason. Adding boundaries of faces to the polygon changes
// neither its class nor its signed crossings with dual loops. By such additions, all edges that the
// cotree crosses can be removed from the polygon. The remaining polygon runs along edges of the
// tree and along edges of generators. Each dual loop crosses exactly one of these edges, which is
// the edge of its generator. So the number of times that the polygon contains a generator equals
// the number of times that the polygon crosses the dual loop of this generator.
//
// Cost: the constructor takes O(n + total length of the dual loops) for a mesh of n faces. The
// trees are grown breadth first, because this keeps dual loops short. Computing a class takes O(2
// g) time. In addition, each edge of the polygon takes O(1) time for each dual loop that crosses
// the edge. Appending a loop takes time linear in the length of the loop. Errors: the errors of the
// Context. Proofs: docs/design/surface.md.
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
  /// Computes generators and dual loops. The mesh must outlive the object. Throws the errors of the
  /// Context.
  explicit SurfaceHomology(const SurfaceMesh& mesh, Context& context = unlimited_context());

  /// Returns the number of generators: twice the sum of the genera of all components.
  std::size_t generator_count() const { return generators_.size(); }
  /// Returns the vertices of generator i, which is a closed loop of edges. The vertices are in the
  /// order of the loop, and each occurs once.
  std::vector<VertexId> generator(std::size_t i) const;

  /// Returns one coefficient for each generator. The sum of the generators with these coefficients
  /// is homologous to the polygon. The polygon separates the surface if and only if all
  /// coefficients are zero. Requires valid polygons (require_valid()). Throws the errors of the
  /// Context.
  std::vector<std::int64_t> class_of(const SurfacePolygons& polygons, std::size_t polygon,
                                     Context& context = unlimited_context()) const;
  /// Returns the class of a sum of polygons. If `sum` contains an index several times, the class of
  /// this polygon is added that many times, but is computed only once.
  std::vector<std::int64_t> class_of(const SurfacePolygons& polygons,
                                     std::span<const std::uint32_t> sum,
                                     Context& context = unlimited_context()) const;

  /// Appends generator i, or its reverse, to `polygons`.
  void add_generator(std::size_t i, bool is_reversed, SurfacePolygons& polygons) const;
  /// Appends loops to `polygons` such that the sum of a shape and these loops separates the
  /// surface. `shape` lists the indices of the polygons of the shape. Returns the indices of the
  /// new polygons. Throws the errors of the Context.
  std::vector<std::uint32_t> add_repair(std::span<const std::uint32_t> shape,
                                        SurfacePolygons& polygons,
                                        Context& context = unlimited_context()) const;

 private:
  /// A step of a spanning tree towards the root: the parent, and the edge to the parent.
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
  IdVector<VertexId, EdgeId> parent_;          // The edge to the parent of each vertex.
  IdVector<EdgeId, std::uint8_t> is_in_tree_;  // For each edge: 1 in the tree, 2 in the cotree.
  // For each half-edge of a border loop, the index of the disk that closes the loop.
  IdVector<HalfedgeId, std::uint32_t> disk_of_;
  std::vector<std::uint32_t> disk_begin_;  // Where each disk starts in the next list.
  std::vector<HalfedgeId> disk_halfedges_;
  std::vector<Step> cotree_;  // Nodes are faces, then disks. Parents come first.
  std::vector<EdgeId> generators_;
  // For each edge, the dual loops that cross it, as pairs (generator, +1 or -1).
  IdVector<EdgeId, std::uint32_t> crossed_begin_;
  std::vector<SignedEntry> crossed_;
};

}  // namespace plumb
#pragma GCC visibility pop
