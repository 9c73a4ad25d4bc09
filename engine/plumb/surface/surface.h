// Boolean operations between polygons drawn on a triangle mesh, exact.
//
// A shape is a sum of closed polygons: an integer 1-cycle. Its label is the integer function on
// cells that grows by one from the right to the left of a polygon. The label exists if and only if
// the shape is zero in the homology of the surface relative to its border; otherwise a cycle of
// cells proves that it does not exist.
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
// Nothing is snapped: two points are one only if their rational coordinates are equal. Degenerate
// positions need no special treatment: control points on edges and vertices, segments along edges,
// polygons that touch, overlap, coincide or run back the way they came.
//
// Cost: after O(n) for n faces, O((s + k) log (s + k)) for s segments and k crossings, plus the
// pairs of segments of one face whose boxes meet, plus the pieces of edges times the polygons that
// run along them. Labels cost O(sum of their lengths and of the multiplicities between cells).
// Errors: Error{BadArgument} and Error{BadIndex} for an invalid scene; Error{NumberOutOfRange} for
// labels of 2^31 or more; ResourceLimit and Cancelled as the Context demands. Proofs:
// docs/design/surface.md.
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

/// The value of a label in the cell at the first corner of a face, which fixes the label in that
/// component of the mesh.
struct SurfaceLevel {
  std::uint32_t shape;  ///< The number of the shape.
  FaceId face;          ///< A face of the mesh.
  std::int32_t label;   ///< The value of the shape's label at the face's first corner.
};

/// Polygons on a mesh, and the shapes that they make. Labels are unique up to a constant for each
/// component of the mesh. Where neither `levels` nor `outside` fixes it, the least integer label of
/// a cell at the border is zero, or the least of all cells in a component without border.
struct SurfaceScene {
  std::shared_ptr<const SurfaceMesh> mesh;  ///< The mesh; scenes may share it.
  SurfacePolygons polygons;                 ///< Polygons over that mesh.
  /// The numbers of the polygons that add up to each shape. Without a value, each polygon is one
  /// shape.
  std::optional<std::vector<std::vector<std::uint32_t>>> shapes;
  FaceId outside;  ///< Labels are zero in the cell at its first corner; may be invalid.
  /// Known labels, which take precedence over `outside`. There is at most one for each shape and
  /// component of the mesh. For shapes with labels modulo 2 only, levels count modulo 2.
  std::vector<SurfaceLevel> levels = {};
};

/// Statistics of a divided surface.
struct SurfaceCounts {
  std::size_t triangles = 0;   ///< The number of faces of the mesh.
  std::size_t segments = 0;    ///< The number of segments of polygons with positive length.
  std::size_t crossings = 0;   ///< The number of nodes where more than two arcs end (arc_ends()).
  std::size_t cells = 0;       ///< The number of cells.
  std::size_t cell_edges = 0;  ///< The number of distinct (pair of cells, signed polygons between).
};

/// Whether a label of a polygon or shape exists.
struct Separation {
  bool over_z = true;  ///< Whether an integer label exists.
  bool mod_2 = true;   ///< Whether a label modulo 2 exists.
  /// A certificate if over_z is false, else empty: cells, each adjacent to the one before and the
  /// last to the first, around which the label would change; by an odd number if mod_2 is false.
  std::vector<CellId> cycle;
};

/// The cells that an expression selects.
struct SurfaceRegion {
  std::vector<std::uint8_t> is_selected;  ///< Whether the cell is selected, for each cell.
  std::vector<std::uint32_t>
      generators;         ///< The polygons of the shapes in the expression, ascending.
  std::size_t cells = 0;  ///< The number of selected cells.
  double area = 0;        ///< Their area; the largest double if it is greater than that.
};

/// The result of a Boolean. result_scene() makes it input again.
struct SurfaceResult {
  SurfaceRegion region;  ///< The selected cells.
  SurfacePolygons
      borders;  ///< One polygon for each loop, with the region to its left; none on mesh borders.
};

struct SurfaceArrangement;
struct SurfaceCells;

/// A surface divided by polygons into cells with labels. Cells and shapes are numbered from 0.
class SurfaceDivision {
 public:
  /// Divides the surface: steps 1 to 3 above. Throws Error{BadArgument} or Error{BadIndex} if the
  /// scene is invalid, Error{NumberOutOfRange} if a label is 2^31 or more, and what the context
  /// throws.
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

  /// Returns whether this polygon alone has a label.
  const Separation& polygon_separation(std::uint32_t polygon) const;
  /// Returns whether this shape has a label.
  const Separation& shape_separation(std::uint32_t shape) const;
  /// Returns the labels of the cell as (shape, value), ascending, without zeros. A shape that
  /// separates modulo 2 only has the values 0 and 1; a shape that does not separate has no entries.
  std::span<const SignedEntry> labels(CellId c) const;
  double area(CellId c) const;  ///< Returns the area of the cell, rounded.

  /// Returns nodes, arcs and pieces, for pictures and audits.
  const SurfaceArrangement& arrangement() const;
  const SurfaceCells& cells() const;  ///< Returns the cells and their graph.

  /// Returns the cells whose labels satisfy the expression. Its names are A, B, C, ... or s0, s1,
  /// ..., the shapes by number; a shape is true in a cell if its label is inside by `rule`. Throws
  /// Error{BadArgument} for other names and for shapes that do not separate the surface (labels
  /// modulo 2 suffice for EvenOdd), and what the context throws. O(cells + length of labels).
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

// Results of Booleans as scenes.

/// Returns the borders of a result as a scene with one shape that is the same set under every rule:
/// its label is 1 in selected cells and 0 in others. Borders alone fix a label only up to a
/// constant for each component of the mesh. In components where the usual zero is wrong, because
/// all of the component or all cells at its border are selected, the constant is stored: for the
/// first such component as `outside` (as a level if no face there has its first corner outside),
/// for others as `levels`. O(mesh).
SurfaceScene result_scene(const SurfaceDivision& division, const SurfaceResult& result);

}  // namespace plumb
#pragma GCC visibility pop
