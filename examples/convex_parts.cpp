// Reads a set from a file, lists its convex parts and prints their number: the program of the
// manual on convex decomposition, for any set. Without an argument: an L.
#include <cstdio>

#include "plumb/convex/decompose.h"
#include "plumb/io/solid_io.h"
#include "plumb/predicates/error.h"
#include "plumb/space/to_mesh.h"

int main(int argc, char** argv) {
  try {
    const char* const file = argc > 1 ? argv[1] : "corpus/solids/l-block.off";
    const plumb::Nef3 set = plumb::read_solid_file(file).set;

    const plumb::ConvexPieces parts = plumb::decompose(set);
    std::printf("decomposition into %zu convex parts\n", parts.pieces.size());

    for (std::size_t i = 0; i < parts.pieces.size(); ++i) {
      const plumb::SpaceComplex& part = parts.pieces[i].complex();
      std::size_t walls = 0;
      for (std::size_t f = 0; f < part.facet_count(); ++f) {
        if (is_wall(part, plumb::FacetId(f))) ++walls;
      }
      std::printf("part %zu: %zu facets, %zu of them walls\n", i + 1, part.facet_count(), walls);
    }
    // Every point is in one part, so nothing is lost and nothing is there twice.
    const bool is_set = union_of(parts.pieces) == set;
    std::printf("together the set: %s\n", is_set ? "yes" : "no");
    return is_set ? 0 : 1;
  } catch (const plumb::Error& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 2;
  }
}
