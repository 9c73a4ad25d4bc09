// Is a sphere map what the twin says it is?
#pragma once

#include <string>

#include "oracle/sphere_cells.h"
#include "plumb/sphere/sphere_map.h"

namespace plumb::testing {

/// A direction through planes of the table, which may get two new ones.
SphereDirection direction_in(PlaneTable& planes, const CellVector& v);

/// Empty when the map is the minimal form of the marked cells: as many points, arcs and faces, with
/// their marks, and each cell located in the one item that it is a part of; else the first difference
/// in words.
std::string difference(PlaneTable& planes, const SphereMap& map, const SphereCells& cells,
                       const SphereMarks& marks);

}  // namespace plumb::testing
