// Sets of the plane as expressions, and what they contain, by brute force: the twin of Nef2.
//
// An expression is a tree: leaves are half-planes, lines, rays, chains and points, inner nodes are
// the set operations and the operators of topology. All of it is decided on the cells of all lines
// involved (line_cells.h): leaves at the point in each cell, operations cell by cell, the interior
// as "and everything around the cell", the closure as "or something around it".
#pragma once

#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "oracle/cell_marks.h"
#include "oracle/line_cells.h"
#include "plumb/plane/nef2.h"

namespace plumb::testing {

using Chain = std::vector<ExactPoint>;

struct SetHalfPlane {  ///< left of a -> b
  ExactPoint a, b;
  Boundary boundary;
};
struct SetLine {
  ExactPoint a, b;
};
struct SetRay {  ///< from a on through b
  ExactPoint a, b;
  Boundary boundary;
};
/// Closed chains, as Nef2::polygons says:
///   off the chains  inside by the winding number
///   on a piece      Closed: inside on one side of it, or as many pieces run here one way as the
///                   other. Open: with `up` of them running one way and `down` the other, the
///                   winding numbers w - up to w + down occur in some order of crossing, w that of
///                   the left side: all of these must be inside
///   a vertex        Open: everything around it must be inside, Closed: something, or be a chain
///                   of one point
struct SetPolygons {
  std::vector<Chain> chains;
  WindingRule rule;
  Boundary boundary;
};
struct SetPolylines {
  std::vector<Chain> chains;
};
struct SetPoints {
  std::vector<ExactPoint> points;
};

struct PlaneSet;
using PlaneSetPointer = std::shared_ptr<const PlaneSet>;

struct SetOperation {
  SetOperator op;
  PlaneSetPointer first;
  PlaneSetPointer second;  ///< null when op is unary
};

struct PlaneSet {
  std::variant<SetHalfPlane, SetLine, SetRay, SetPolygons, SetPolylines, SetPoints, SetOperation>
      node;
};

template <class Node>
PlaneSetPointer set_of(Node node) {
  return std::make_shared<const PlaneSet>(PlaneSet{std::move(node)});
}
PlaneSetPointer apply(SetOperator op, PlaneSetPointer first, PlaneSetPointer second = nullptr);

/// Every line that bounds something in the set, and lines that make every end point a crossing.
void add_lines(const PlaneSet& set, std::vector<CellLine>& lines);
/// All points named in it.
void add_points(const PlaneSet& set, std::vector<ExactPoint>& points);

/// The cells must be those of add_lines (and others).
CellMarks marks_of(const PlaneSet& set, const LineCells& cells);

/// None when infinite.
std::optional<BigRational> area_of(const LineCells& cells, const CellMarks& marks);

/// The image under an affine map of determinant other than 0.
PlaneSetPointer transformed(const PlaneSetPointer& set, const AffineMap2& map);

std::string to_text(const ExactPoint& p);
/// For messages: one line.
std::string to_text(const PlaneSet& set);

/// The same in the engine.
Nef2 apply(SetOperator op, const Nef2& first, const Nef2& second);
Nef2 to_nef(const PlaneSet& set);

RationalPoint2 to_rational(const ExactPoint& p);

}  // namespace plumb::testing
