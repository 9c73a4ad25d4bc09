// Is a sphere map, or a set of the sphere, what the twin says it is?
#pragma once

#include <string>

#include "oracle/sphere_cells.h"
#include "plumb/sphere/nef_sphere.h"

namespace plumb::testing {

/// A direction through planes of the table, which may get two new ones.
SphereDirection direction_in(PlaneTable& planes, const CellVector& v);
SphereVector vector_of(const CellVector& v);
CellVector cell_vector(const SphereVector& v);

/// Empty when the map is the minimal form of the marked cells: audit, as many points, arcs and
/// faces, with their marks, and each cell located in the one item that it is a part of; else the
/// first difference in words.
std::string difference(PlaneTable& planes, const SphereMap& map, const SphereCells& cells,
                       const CellMarks& marks);

/// A set of the engine beside the twin's marks of the same set.
struct TwoSpheres {
  NefSphere engine;
  CellMarks twin;
};
std::string difference(const SphereCells& cells, const TwoSpheres& sets);

/// The same, and everything else that a set can be asked: great circles, operators, marks.
std::string deep_difference(const SphereCells& cells, const TwoSpheres& sets);

}  // namespace plumb::testing
