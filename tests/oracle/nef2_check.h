// Is a Nef2 what the twin says it is? In everything that can be asked of it.
#pragma once

#include <string>

#include "oracle/plane_graph.h"

namespace plumb::testing {

/// A set of the engine beside the twin's marks of the same set.
struct TwoSets {
  Nef2 engine;
  CellMarks twin;
};

/// Empty when both are the same set: audit, complex (element by element), emptiness, boundedness,
/// openness, area; else the first difference in words.
std::string difference(const LineCells& cells, const TwoSets& sets);

/// The same, and everything else that a set can be asked: location of a point in each cell, rays,
/// operators, parts, records, marks.
std::string deep_difference(const LineCells& cells, const TwoSets& sets);

/// Builds the expression in the engine and looks at every node of the tree; at the root deeply.
std::string disagreement(const PlaneSet& set);

/// The cells of an expression.
LineCells cells_of(const PlaneSet& set);

/// The first cell met by a ray that is accepted, and the point where the ray gets there.
struct CellHit {
  std::size_t cell;
  ExactPoint point;
};
std::optional<CellHit> first_hit(const LineCells& cells, const std::vector<bool>& accepted,
                                 const ExactPoint& origin, const ExactPoint& direction);

}  // namespace plumb::testing
