// Boolean operations between polygons drawn on a triangle mesh, exact.
//
// A shape is a sum of closed polygons: an integer 1-cycle. Its label is the integer function on cells that
// grows by one from the right to the left of a polygon. It exists if and only if the shape is zero in the homology
// of the surface relative to its border; otherwise a cycle of cells proves that it does not.
//
// Main flow of SurfaceDivision:
//  1. slice       polygons against each other in every face they touch (surface_arrangement.h): nodes, arcs
//                 with the signed multiplicities of polygons, pieces of faces
//  2. cells       pieces and faces with no arc between them; the graph of cells (surface_cells.h)
//  3. labels      of polygons and of shapes, as potentials on that graph (surface_labels.h)
// Of a Boolean:
//  4. select      cells whose labels satisfy an expression over shapes
//  5. borders     of the selected cells, as polygons again (surface_borders.h)
//
// Nothing is snapped; equal rationals are one point. Ties are ordinary: control points on edges and vertices,
// segments along edges, touching, overlapping, doubled and backtracking ones.
//
// Cost: after O(n) for n faces, O((s + k) log (s + k)) for s segments and k crossings, plus pairs of segments of one
// face whose boxes meet, plus pieces of edges times the polygons that run along them; labels O(sum of their lengths
// and of the multiplicities between cells). Errors: Error{BadArgument}, Error{BadIndex} for what is no scene;
// NumberOutOfRange; ResourceLimit and Cancelled by the Context.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "plumb/base/context.h"
#include "plumb/base/set_expression.h"
#include "plumb/plane/nef2.h"
#include "plumb/surface/surface_ids.h"
#include "plumb/surface/surface_mesh.h"
#include "plumb/surface/surface_path.h"

#pragma GCC visibility push(default)
namespace plumb {

/// What a label is in the cell at the first corner of a face, and so in that component of the mesh.
struct SurfaceLevel {
  std::uint32_t shape;  ///< index
  FaceId face;          ///< a face of the mesh
  std::int32_t label;   ///< its value there
};

/// Polygons on a mesh, and which of them make a shape.
struct SurfaceScene {
  std::shared_ptr<const SurfaceMesh> mesh;  ///< shared with other scenes
  SurfacePolygons polygons;                 ///< over that mesh
  /// Polygons that add up to each shape; none given: one shape per polygon.
  std::optional<std::vector<std::vector<std::uint32_t>>> shapes;
  FaceId outside;  ///< labels are zero in the cell at its first corner; may be invalid
  /// Stronger than `outside`. At most one for a shape in a component; modulo 2 where labels are.
  std::vector<SurfaceLevel> levels = {};
};

/// Numbers for people.
struct SurfaceCounts {
  std::size_t triangles = 0;   ///< of the mesh
  std::size_t segments = 0;    ///< of polygons, those of length zero not counted
  std::size_t crossings = 0;   ///< points where more than two arcs end (arc_ends())
  std::size_t cells = 0;       ///< parts of the surface with no polygon between them
  std::size_t cell_edges = 0;  ///< different (pair of cells, signed polygons between them)
};

/// Does a label exist?
struct Separation {
  bool over_z = true;  ///< is there an integer label?
  bool mod_2 = true;   ///< is there one modulo 2?
  /// If not over Z: cells, each next to the one before and the last to the first, around which the label
  /// would change; by an odd number, if not modulo 2 either.
  std::vector<CellId> cycle;
};

/// The cells an expression selects.
struct SurfaceRegion {
  std::vector<std::uint8_t> is_selected;  ///< per cell
  std::vector<std::uint32_t>
      generators;         ///< polygons of the shapes that the expression names, ascending
  std::size_t cells = 0;  ///< how many are selected
  double area = 0;        ///< beyond doubles the largest
};

/// What a Boolean gives. result_scene() (surface_result.h) makes it input again.
struct SurfaceResult {
  SurfaceRegion region;  ///< the cells selected
  SurfacePolygons
      borders;  ///< one polygon a loop, the region to its left; the mesh border is no loop
};

struct SurfaceArrangement;
struct SurfaceCells;

/// A surface cut by polygons into cells with labels.
class SurfaceDivision {
 public:
  SurfaceDivision(SurfaceScene scene, Context& context);  ///< Steps 1 to 3.
  ~SurfaceDivision();
  /// Moved from, the other can only be destroyed or assigned to.
  SurfaceDivision(SurfaceDivision&&) noexcept;
  SurfaceDivision& operator=(SurfaceDivision&&) noexcept;  ///< As the constructor.

  const SurfaceScene& scene() const;                         ///< What was given.
  const SurfaceMesh& mesh() const { return *scene().mesh; }  ///< What is drawn on.
  SurfaceCounts counts() const;                              ///< Of mesh, polygons and cells.
  std::size_t cell_count() const;                            ///< Numbers of cells run from 0.
  std::size_t shape_count() const;                           ///< Numbers of shapes run from 0.

  /// Has this one polygon a label?
  const Separation& polygon_separation(std::uint32_t polygon) const;
  const Separation& shape_separation(std::uint32_t shape) const;  ///< Has this shape a label?
  /// (shape, value), ascending, without zeros. Of a shape that separates modulo 2 only, values are 0 and 1; of
  /// one that does not separate there are none.
  std::span<const SignedEntry> labels(CellId c) const;
  double area(CellId c) const;  ///< of a cell

  /// What the stages made, for pictures and audits.
  const SurfaceArrangement& arrangement() const;
  const SurfaceCells& cells() const;  ///< Pieces and faces joined, and the graph of cells.

  /// Names A, B, C ... or s0, s1 ... are shapes. Throws Error{BadArgument} for other names, and for shapes that do
  /// not separate (modulo 2 is enough for EvenOdd).
  SurfaceRegion select(const SetExpression& expression, WindingRule rule, Context& context) const;
  /// The boundary of a region, as polygons with the region to their left.
  SurfacePolygons borders(const SurfaceRegion& region, Context& context) const;
  /// Select() and borders().
  SurfaceResult evaluate(const SetExpression& expression, WindingRule rule, Context& context) const;
  /// The same without limits.
  SurfaceRegion select(const SetExpression& expression, WindingRule rule) const;
  /// The same without limits.
  SurfaceResult evaluate(const SetExpression& expression, WindingRule rule) const;

 private:
  struct [[gnu::visibility("hidden")]] State;
  std::unique_ptr<State> state_;
};

}  // namespace plumb
#pragma GCC visibility pop
