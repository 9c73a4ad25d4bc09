// Is a Nef3 what the twin says it is? In everything that can be asked of it.
#pragma once

#include <string>

#include "oracle/space_graph.h"
#include "plumb/space/nef3.h"

namespace plumb::testing {

/// Expressions in the engine.
Nef3 apply(SetOperator op, const Nef3& first, const Nef3& second);
Nef3 to_nef(const SpaceSet& set);
Plane3 to_plane(const CellPlane& plane);
RationalPoint3 to_rational(const ExactPoint3& p);

/// A set of the engine beside the twin's marks of the same set.
struct TwoSpaceSets {
  Nef3 engine;
  CellMarks twin;
};

/// Empty when both are the same set: audit, complex (element by element), counts, emptiness,
/// boundedness, openness, volume; else the first difference in words.
std::string difference(const SpaceCells& cells, const TwoSpaceSets& sets);

/// The same, and everything else that a set can be asked: location of a point in each cell,
/// operators, marks.
std::string deep_difference(const SpaceCells& cells, const TwoSpaceSets& sets);

/// Builds the expression in the engine and looks at every node of the tree; at the root deeply.
std::string disagreement(const SpaceSet& set);

}  // namespace plumb::testing
