// Exact Boolean operations between polygons drawn on a triangle mesh.
//
// A shape is a sum of closed polygons: an integer 1-cycle. The label of a shape is an integer
// function on cells. It is greater by one to the left of a polygon of the shape than to its right.
// The label exists if and only if the shape is zero in the homology of the surface relative to its
// border. Otherwise a cycle of cells proves that there is no label.
//
// Main flow of SurfaceDivision:
//  1. slice       intersects the polygons in every face they touch (surface_arrangement.h): nodes,
//                 arcs with the signed multiplicities of polygons, pieces of faces
//  2. cells       joins pieces and faces with no arc between them, and builds the graph of cells
//                 (surface_cells.h)
//  3. labels      computes labels of polygons and shapes, as potentials on that graph
//                 (surface_labels.h)
// Main flow of a Boolean:
//  4. select      selects the cells whose labels satisfy an expression over shapes
//  5. borders     traces the borders of the selected cells, as polygons again (surface_cells.h)
//
// Nothing is snapped: two points are the same point only if their rational coordinates are equal.
// Degenerate positions need no special treatment. Control points may lie on edges and vertices, and
// segments along edges. Polygons may touch, overlap, coincide or run back the way they came.
//
// Cost of a division is the sum of:
// - O(n) for n faces,
// - O((s + k) log(s + k)) for s segments and k crossings,
// - the number of pairs of segments of one face whose boxes meet,
// - the number of pieces of edges times the number of polygons that run along them,
// - for labels, O(sum of their lengths and of the multiplicities between cells).
//
// Errors:
// - Error{BadArgument} and Error{BadIndex} for an invalid scene,
// - Error{NumberOutOfRange} for a label whose absolute value is 2^31 or more,
// - ResourceLimit and Cancelled as the Context demands.
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

/// A known value of a label: its value in the cell at the first corner of a face. It fixes the
/// label in that component of the mesh.
struct SurfaceLevel {
  std::uint32_t shape;  ///< The index of the shape.
  FaceId face;          ///< A face of the mesh.
  std::int32_t label;   ///< The value of the shape's label at the face's first corner.
};

/// Polygons on a mesh, and the shapes that they make. Labels are unique up to a constant for each
/// component of the mesh. If neither `levels` nor `outside` fixes this constant, the least
/// integer label of the cells at the mesh border is zero. In a component without border, the least
/// integer label of all cells is zero.
struct SurfaceScene {
  std::shared_ptr<const SurfaceMesh> mesh;  ///< The mesh; several scenes may share it.
  SurfacePolygons polygons;                 ///< Polygons over that mesh.
  /// The indices of the polygons that add up to each shape. If there is no value, each polygon is
  /// one shape.
  std::optional<std::vector<std::vector<std::uint32_t>>> shapes;
  FaceId outside;  ///< A face: labels are zero in the cell at its first corner. May be invalid.
  /// Known labels, which take precedence over `outside`. There is at most one level for each pair
  /// of a shape and a component of the mesh. If a shape has labels modulo 2 only, its levels count
  /// modulo 2.
  std::vector<SurfaceLevel> levels = {};
};

/// Statistics of a divided surface.
struct SurfaceCounts {
  std::size_t triangles = 0;  ///< The number of faces of the mesh.
  std::size_t segments = 0;   ///< The number of segments of polygons, without those of length zero.
  std::size_t crossings = 0;  ///< The number of nodes where more than two arcs end (arc_ends()).
  std::size_t cells = 0;      ///< The number of cells.
  std::size_t cell_edges = 0;  ///< The number of edges of the graph of cells (SurfaceCells::edges).
};

/// Whether a label of a polygon or shape exists.
struct Separation {
  bool over_z = true;  ///< Whether an integer label exists.
  bool mod_2 = true;   ///< Whether a label modulo 2 exists.
  /// A certificate if over_z is false, else empty. It is a cycle of cells: each cell is adjacent to
  /// the cell before it, and the last to the first. Once around the cycle, the label would change
  /// by a number that is not zero. If mod_2 is false, the number is odd.
  std::vector<CellId> cycle;
};

/// The cells that an expression selects.
struct SurfaceRegion {
  std::vector<std::uint8_t> is_selected;  ///< For each cell, 1 if it is selected, else 0.
  std::vector<std::uint32_t>
      generators;         ///< The polygons of the shapes in the expression, ascending.
  std::size_t cells = 0;  ///< The number of selected cells.
  double area = 0;  ///< The area of the selected cells; the largest double if the area exceeds it.
};

/// The result of a Boolean. result_scene() converts it to a scene, for further Booleans.
struct SurfaceResult {
  SurfaceRegion region;  ///< The selected cells.
  /// The borders: one polygon for each loop, with the region to its left. Loops of mesh border
  /// alone are left out.
  SurfacePolygons borders;
};

struct SurfaceArrangement;
struct SurfaceCells;

/// A surface divided by polygons into cells with labels. Cells and shapes are numbered from 0.
class SurfaceDivision {
 public:
  /// Divides the surface: steps 1 to 3 of the main flow. Throws Error{BadArgument} or
  /// Error{BadIndex} if the scene is invalid, Error{NumberOutOfRange} if the absolute value of a
  /// label is 2^31 or more, and what the context throws.
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

  /// Returns whether the polygon has a label as a shape of its own.
  const Separation& polygon_separation(std::uint32_t polygon) const;
  /// Returns whether this shape has a label.
  const Separation& shape_separation(std::uint32_t shape) const;
  /// Returns the labels of the cell as pairs (shape, value), ascending, without zeros. The values
  /// of a shape that separates modulo 2 only are 0 and 1. A shape that does not separate has no
  /// entries.
  std::span<const SignedEntry> labels(CellId c) const;
  double area(CellId c) const;  ///< Returns the area of the cell, rounded.

  /// Returns nodes, arcs and pieces, for pictures and audits.
  const SurfaceArrangement& arrangement() const;
  const SurfaceCells& cells() const;  ///< Returns the cells and their graph.

  /// Returns the cells whose labels satisfy the expression. Names in the expression stand for
  /// shapes by index: A, B, C, ... or s0, s1, .... A shape is true in a cell if `rule` says that
  /// its label is inside. Throws Error{BadArgument} for any other name, and for a shape that does
  /// not separate the surface. For the rule EvenOdd it is enough that the shape separates modulo 2.
  /// Throws what the context throws. O(cells + length of labels).
  SurfaceRegion select(const SetExpression& expression, WindingRule rule,
                       Context& context = unlimited_context()) const;
  /// Returns the borders of a region as polygons with the region to their left.
  SurfacePolygons borders(const SurfaceRegion& region,
                          Context& context = unlimited_context()) const;
  /// Returns the result of select() and its borders().
  SurfaceResult evaluate(const SetExpression& expression, WindingRule rule,
                         Context& context = unlimited_context()) const;

 private:
  struct [[gnu::visibility("hidden")]] State;
  std::unique_ptr<State> state_;
};

// Results of Booleans, converted to scenes.

/// Returns the borders of a result as a scene with one shape. The label of that shape is 1 in
/// selected cells and 0 in others, so the shape is the same set under every rule. Borders alone fix
/// a label only up to a constant for each component of the mesh. The usual constant (SurfaceScene)
/// is wrong in a component if all its cells, or all its cells at the border, are selected. For such
/// components the scene stores the constant. The first such component is fixed by `outside`, or by
/// a level if none of its faces has its first corner outside. The other such components are fixed
/// by `levels`. O(mesh).
SurfaceScene result_scene(const SurfaceDivision& division, const SurfaceResult& result);

}  // namespace plumb
#pragma GCC visibility pop
