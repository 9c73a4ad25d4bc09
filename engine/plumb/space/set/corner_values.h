// The numbers at the corners of a mesh with attributes. Internal.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <unordered_map>

#include "plumb/base/context.h"
#include "plumb/predicates/point3_signs.h"
#include "plumb/space/mesh_with_attributes.h"
#include "plumb/space/set/cut_boundary.h"
#include "plumb/space/set/growing_complex.h"
#include "plumb/space/set/round_mesh.h"
#include "plumb/space/set/source_triangles.h"

namespace plumb {

/// For each point that is rounded, its place before. If several points are rounded to the same
/// numbers, the place of the first one stands for all.
class PlacesBeforeRounding {
 public:
  /// Lists the points of a mesh that is to be rounded to numbers of this type.
  PlacesBeforeRounding(const MeshToRound& input, CoordinateType type);

  /// Returns the homogeneous coordinates (point3_signs.h) of the place before rounding. If no point
  /// was rounded to p, these are the coordinates of p. The result is valid until the next call.
  const IntegerRow& row(const Point3Table& points, const Point3& p);
  /// Returns the constructed point that was rounded to p; not valid if there is none.
  SpacePoint constructed(const Point3& p) const;

 private:
  /// The bits of the coordinates of a rounded point.
  using Key = std::array<std::uint64_t, 3>;
  struct KeyHash {
    std::size_t operator()(const Key& key) const noexcept;
  };
  struct Place {
    SpacePoint at;   // Invalid if the coordinates were doubles.
    Point3 nearest;  // The nearest doubles.
    IntegerRow row;  // Its coordinates, all 0 until they are needed.
  };

  static Key key_of(const Point3& p);

  std::unordered_map<Key, Place, KeyHash> places_;
  IntegerRow itself_;  // Of a point that was not rounded.
};

/// The input of fill_channels().
struct CornerInput {
  const CutBoundary& cut;
  const GrowingComplex& complex;
  SourceTriangles& sources;
  PlacesBeforeRounding& places;
  CoordinateType type;  ///< The numbers to which the points of the mesh were rounded.

  /// Returns the points of the tables. The reference is valid until the tables change.
  const Point3Table& points() const { return complex.tables().points; }
};

/// Makes the channels of the result, and computes the numbers at all corners of its mesh. `piece`
/// has the piece of each face. Throws the errors of the Context. O(n) for n corners.
void fill_channels(const CornerInput& input, std::span<const std::uint32_t> piece,
                   MeshWithAttributes& result, Context& context);

}  // namespace plumb
