// A mesh cut by a plane: what lies below it, what lies above, and the polygon in the plane between
// them.
#include <iostream>

#include "plumb/io/solid_io.h"
#include "plumb/predicates/error.h"
#include "plumb/space/space_measure.h"
#include "plumb/space/to_mesh.h"

int main(int argc, char** argv) {
  try {
    const char* const file = argc > 1 ? argv[1] : "corpus/solids/l-block.off";
    const plumb::Nef3 solid = plumb::read_solid_file(file).set;

    // x = 1/2 is 2 x - 1 = 0: no coordinate has to be rounded to say where to cut.
    const plumb::Plane3 plane{2, 0, 0, -1};
    const auto part = [&](plumb::Section section, plumb::MarkFunction function) {
      return boolean_op(solid, plane, section, function);
    };
    const plumb::Nef3 below = part(plumb::Section::ClosedHalfSpace, plumb::kIntersection);
    const plumb::Nef3 above = part(plumb::Section::ClosedHalfSpace, plumb::kDifference);
    const plumb::Nef3 cut = part(plumb::Section::PlaneOnly, plumb::kIntersection);

    std::cout << "volumes: " << marked_volume(below.complex()).value() << " + "
              << marked_volume(above.complex()).value() << " = "
              << marked_volume(solid.complex()).value() << '\n';
    // The cut is a set without volume: one facet, as a polygon with its corners.
    const plumb::MeshOfComplex polygons =
        soup_of_complex(cut.complex(), {.faces = plumb::MeshFaces::Polygons});
    std::cout << "the cut: " << polygons.mesh.face_count() << " polygon of "
              << polygons.mesh.points.size() << " corners\n";
    // The lower part kept the plane, the upper one did not: together they are the solid, and
    // nothing is in both.
    const bool is_solid =
        below + above == solid && (below * above).is_empty() && cut.is_subset_of(below);
    std::cout << "together the solid: " << (is_solid ? "yes" : "no") << '\n';
    return is_solid ? 0 : 1;
  } catch (const plumb::Error& error) {
    std::cerr << error.what() << '\n';
    return 2;
  }
}
