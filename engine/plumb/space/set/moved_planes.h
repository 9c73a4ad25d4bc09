// Finds the images of planes of a mesh among the planes of a set, without interning them. Internal.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "plumb/predicates/arithmetic/fingerprint.h"
#include "plumb/predicates/arithmetic/seeded_hash.h"
#include "plumb/predicates/space/plane_table.h"
#include "plumb/space/set/integer_map.h"

namespace plumb {

/// An index of some planes of a table by their fingerprints. Most planes of moved sources are
/// hidden in the result of a Boolean, so their images are in no table. The residues of an image
/// show this for a few products modulo q. Only if a fingerprint is found, the exact image is
/// computed and compared.
class MovedPlanes {
 public:
  /// A map, with the residues of its matrix.
  struct Map {
    explicit Map(const AffineMap3& map);

    IntegerMap exact;                    ///< The map in integers.
    std::array<ResidueRow, 4> residues;  ///< The residues of IntegerMap::plane_matrix().
  };

  /// Indexes these planes of the table. Keeps a reference to the table, which may grow. O(n).
  MovedPlanes(const PlaneTable& planes, std::span<const PlaneId> wanted);

  /// Returns the image of plane p of the table `from` if it is one of the indexed planes. The
  /// positive side of the result is the image of the positive side of p. Otherwise the result is
  /// not valid. Requires a plane that does not belong to the frame.
  OrientedPlane image_of(const PlaneTable& from, PlaneId p, const Map& map) const;

 private:
  const PlaneTable& planes_;
  IdIndex index_;
};

}  // namespace plumb
