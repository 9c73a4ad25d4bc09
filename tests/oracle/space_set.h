// Sets of space as expressions, and what they contain, by brute force: the twin of Nef3.
//
// An expression is a tree: leaves are half-spaces, planes, closed meshes, polygons, chains and
// points, inner nodes are the set operations and the operators of topology. All of it is decided on
// the cells of all planes involved (space_cells.h): leaves at the point in each cell, operations
// cell by cell (cell_marks.h).
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "oracle/cell_marks.h"
#include "oracle/space_cells.h"

namespace plumb::testing {

using Chain3 = std::vector<ExactPoint3>;

/// { n.x + d <= 0 } or { n.x + d < 0 }: the normal points out of the set.
struct HalfSpaceLeaf {
  CellPlane plane;
  bool closed;
};
struct PlaneLeaf {
  CellPlane plane;
};
/// Which winding numbers are inside.
enum class MeshRule : std::uint8_t { NonZero, Odd, Positive };
/// Planar faces by their corners, counter-clockwise seen from outside, whose edges cancel: several
/// shells, crossing and repeated ones too. The set is the closure of the volumes inside by the
/// rule.
struct MeshLeaf {
  std::vector<ExactPoint3> points;
  std::vector<std::vector<std::size_t>> faces;
  MeshRule rule = MeshRule::NonZero;
};
/// A simple polygon with its boundary, in one plane.
struct PolygonLeaf {
  Chain3 corners;
};
/// Consecutive points joined; a chain of one point is that point.
struct ChainsLeaf {
  std::vector<Chain3> chains;
};
struct PointsLeaf {
  std::vector<ExactPoint3> points;
};

struct SpaceSet;
using SpaceSetPointer = std::shared_ptr<const SpaceSet>;

struct SpaceOperation {
  SetOperator op;
  SpaceSetPointer first;
  SpaceSetPointer second;  ///< null when op is unary
};

struct SpaceSet {
  std::variant<HalfSpaceLeaf, PlaneLeaf, MeshLeaf, PolygonLeaf, ChainsLeaf, PointsLeaf,
               SpaceOperation>
      node;
};

template <class Node>
SpaceSetPointer space_set(Node node) {
  return std::make_shared<const SpaceSet>(SpaceSet{std::move(node)});
}
SpaceSetPointer apply(SetOperator op, SpaceSetPointer first, SpaceSetPointer second = nullptr);
SpaceSetPointer empty_space();

/// Every plane that bounds something in the set, and planes that make every end point a vertex.
void add_planes(const SpaceSet& set, std::vector<CellPlane>& planes);
SpaceCells cells_of(const SpaceSet& set);

/// The cells must be those of add_planes (and others).
CellMarks marks_of(const SpaceSet& set, const SpaceCells& cells);

/// None when infinite.
std::optional<BigRational> volume_of(const SpaceCells& cells, const CellMarks& marks);

std::string to_text(const ExactPoint3& p);
std::string to_text(const CellPlane& plane);
/// For messages: one line.
std::string to_text(const SpaceSet& set);

}  // namespace plumb::testing
