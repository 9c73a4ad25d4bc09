// Exact Boolean operations between polygons drawn on a triangle mesh.
//
// A shape is a sum of closed polygons, that is, an integer 1-cycle. A cell is a connected component
// of the surface after the polygons are removed. The label of a shape is a function that assigns an
// integer to each cell. Just to the left of a polygon of the shape, the label is greater by 1 than
// just to the right of the polygon. The label exists if and only if the shape is zero in the
// homology of the surface relative to the border of the surface. If a shape has no label, a closed
// walk from cell to cell proves that there is none (Separation::cycle).
//
// Main flow of SurfaceDivision:
//  1. slice       computes the intersections of the polygons in every face that they touch
//                 (surface_arrangement.h). The result consists of nodes, arcs, and pieces of faces.
//                 Each arc has a signed multiplicity for each polygon along the arc
//  2. cells       joins neighbouring pieces and faces into cells if no arc separates them, and
//                 builds the graph of cells (surface_cells.h)
//  3. labels      computes the labels of polygons and shapes, as potentials on the graph of cells
//                 (surface_labels.h)
// Main flow of a Boolean:
//  4. select      selects the cells whose labels satisfy a Boolean expression over shapes
//  5. borders     traces the borders of the selected cells (surface_cells.h). The borders are
//                 polygons, too
//
// Points are not moved: two points are the same point only if their rational coordinates are equal.
// Degenerate positions need no special treatment. Control points may lie on edges and vertices, and
// segments may run along edges. Polygons may touch, overlap or coincide. A polygon may also turn
// round and run back along itself.
//
// The cost of making a SurfaceDivision is the sum of:
// - O(n) for n faces,
// - O((s + k) log(s + k)) for s segments and k crossings,
// - the number of pairs of segments that lie in the same face and whose boxes meet,
// - for each piece of a mesh edge, the number of polygons that run along this piece,
// - the number of entries of all labels,
// - the number of multiplicities of all arcs between cells.
//
// Errors:
// - Error{BadArgument} and Error{BadIndex} for an invalid scene,
// - Error{NumberOutOfRange} for a label whose absolute value is 2^31 or more,
// - ResourceLimit if a limit of the Context is exceeded, and Cancelled if a stop is requested.
//
// Proofs: docs/design/surface.md.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "plumb/base/context.h"
#include "plumb/base/set_expression.h"
#include "plumb/plane/nef2.h"
#include "plumb/surface/surface_mesh.h"
#include "plumb/surface/surface_path.h"

#pragma GCC visibility push(default)
namespace plumb {

/// A known value of the label of a shape: its value in the cell that contains the first corner of a
/// face. This value determines the label in the whole component of the mesh that contains the face.
struct SurfaceLevel {
  std::uint32_t shape;  ///< The index of the shape.
  FaceId face;          ///< A face of the mesh.
  std::int32_t label;   ///< The value of the label at the first corner of the face.
};

/// Polygons on a mesh, and the shapes that are sums of these polygons. In each component of the
/// mesh, the label of a shape is unique up to a constant. `levels` or `outside` can determine this
/// constant. Otherwise it has the following default. In a component with border, the least integer
/// label of the cells at the border is zero. In a component without border, the least integer label
/// of all cells is zero.
struct SurfaceScene {
  std::shared_ptr<const SurfaceMesh> mesh;  ///< The mesh; several scenes may share it.
  SurfacePolygons polygons;                 ///< Polygons over that mesh.
  /// For each shape, the indices of the polygons whose sum is the shape. If this member has no
  /// value, each polygon is a shape.
  std::optional<std::vector<std::vector<std::uint32_t>>> shapes;
  /// The labels of all shapes are zero at the first corner of this face. May be invalid.
  FaceId outside;
  /// Known labels, which take precedence over `outside`. For each shape, there may be at most one
  /// level in each component of the mesh. If a shape has a label modulo 2 but no integer label, its
  /// levels are read modulo 2.
  std::vector<SurfaceLevel> levels = {};
};

/// Statistics of a divided surface.
struct SurfaceCounts {
  std::size_t triangles = 0;   ///< The number of faces of the mesh.
  std::size_t segments = 0;    ///< The number of segments of nonzero length.
  std::size_t crossings = 0;   ///< The number of nodes where more than two arcs end (arc_ends()).
  std::size_t cells = 0;       ///< The number of cells.
  std::size_t cell_edges = 0;  ///< The number of edges of the graph of cells (SurfaceCells::edges).
};

/// Whether a label of a polygon or shape exists.
struct Separation {
  bool over_z = true;  ///< Whether an integer label exists.
  bool mod_2 = true;   ///< Whether a label modulo 2 exists.
  /// A closed walk over cells, which proves that no integer label exists. The walk is empty if
  /// over_z is true. Each cell of the walk is adjacent to the next cell, and the last cell is
  /// adjacent to the first. An integer label would change from cell to cell along this walk, and
  /// the changes would not add up to zero. This is impossible on a closed walk. If mod_2 is false,
  /// the sum of the changes is odd.
  std::vector<CellId> cycle;
};

/// The cells that an expression selects.
struct SurfaceRegion {
  std::vector<std::uint8_t> is_selected;  ///< For each cell, 1 if it is selected, else 0.
  std::vector<std::uint32_t>
      /// The indices of the polygons of all shapes in the expression, in ascending order.
      generators;
  std::size_t cells = 0;  ///< The number of selected cells.
  double area = 0;        ///< The area of the selected cells, but at most the largest double.
};

/// The result of a Boolean. result_scene() converts it to a scene, for further Booleans.
struct SurfaceResult {
  SurfaceRegion region;  ///< The selected cells.
  /// The borders of the region. There is one polygon for each loop, with the region to its left.
  /// Loops that run only along the border of the mesh are omitted.
  SurfacePolygons borders;
};

struct SurfaceArrangement;
struct SurfaceCells;

/// A surface divided by polygons into cells with labels. Cells and shapes are numbered from 0.
class SurfaceDivision {
 public:
  /// Divides the surface: steps 1 to 3 of the main flow. Throws Error{BadArgument} or
  /// Error{BadIndex} if the scene is invalid. Throws Error{NumberOutOfRange} if the absolute value
  /// of a label is 2^31 or more. Also throws the errors of the Context.
  explicit SurfaceDivision(SurfaceScene scene, Context& context = unlimited_context());
  ~SurfaceDivision();
  /// A moved-from division may only be destroyed or assigned to.
  SurfaceDivision(SurfaceDivision&&) noexcept;
  SurfaceDivision& operator=(SurfaceDivision&&) noexcept;  ///< Moves, like the constructor.

  const SurfaceScene& scene() const;                         ///< Returns the scene that was given.
  const SurfaceMesh& mesh() const { return *scene().mesh; }  ///< Returns the scene's mesh.
  SurfaceCounts counts() const;     ///< Returns statistics of the mesh, polygons and cells.
  std::size_t cell_count() const;   ///< Returns the number of cells.
  std::size_t shape_count() const;  ///< Returns the number of shapes.

  /// Returns whether the shape that consists of only this polygon has a label.
  const Separation& polygon_separation(std::uint32_t polygon) const;
  /// Returns whether this shape has a label.
  const Separation& shape_separation(std::uint32_t shape) const;
  /// Returns the labels of the cell as pairs (shape, value). The pairs are in ascending order of
  /// shapes, and pairs with the value 0 are omitted. If a shape has only a label modulo 2, its
  /// values are 0 and 1. A shape without a label has no entries.
  std::span<const SignedEntry> labels(CellId c) const;
  double area(CellId c) const;  ///< Returns the rounded area of the cell.

  /// Returns nodes, arcs and pieces, for pictures and audits.
  const SurfaceArrangement& arrangement() const;
  const SurfaceCells& cells() const;  ///< Returns the cells and their graph.

  /// Returns the cells whose labels satisfy the expression. The names of shapes in the expression
  /// are A, B, C, ... or s0, s1, ..., in the order of their indices. In a cell, the value of a
  /// shape is true if `rule` counts the label of the shape in this cell as inside. Throws
  /// Error{BadArgument} for any other name, and for a shape without an integer label. For the rule
  /// EvenOdd, a label modulo 2 is sufficient. Throws the errors of the Context. Cost: O(cells +
  /// length of labels).
  SurfaceRegion select(const SetExpression& expression, WindingRule rule,
                       Context& context = unlimited_context()) const;
  /// Returns the borders of a region as polygons with the region to their left.
  SurfacePolygons borders(const SurfaceRegion& region,
                          Context& context = unlimited_context()) const;
  /// Returns the result of select(), together with the borders of this result.
  SurfaceResult evaluate(const SetExpression& expression, WindingRule rule,
                         Context& context = unlimited_context()) const;

 private:
  struct [[gnu::visibility("hidden")]] State;
  std::unique_ptr<State> state_;
};

// Results of Booleans, converted to scenes.

/// Returns the borders of a result as a scene with one shape. The label of this shape is 1 in
/// selected cells and 0 in all other cells. So the shape describes the same set under every rule.
/// The borders determine the label only up to a constant for each component of the mesh. The
/// default constant (see SurfaceScene) is wrong for a component if all its cells are selected, or
/// if all its cells at the border are selected. For each such component, the scene stores the right
/// constant. For the first such component, the scene stores a face in `outside`. For each later
/// component of this kind, the scene stores an entry of `levels`. There is one exception. It may be
/// that all faces of the first such component have their first corners inside the region. Then the
/// scene stores an entry of `levels` for this component instead. O(mesh).
SurfaceScene result_scene(const SurfaceDivision& division, const SurfaceResult& result);

}  // namespace plumb
#pragma GCC visibility pop
