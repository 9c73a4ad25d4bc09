#include "generate/near_solids.h"

#include <cmath>

#include "generate/meshes.h"
#include "plumb/predicates/error.h"

namespace plumb::testing {
namespace {

/// Returns 0, 1, 2 or 3, and at most three units of the last digit of 1 more or less.
double near_coordinate(std::uint8_t byte) {
  return (byte & 3U) + std::ldexp(static_cast<double>(byte >> 2U & 7U) - 3, -52);
}

Point3 near_corner(std::span<const std::uint8_t> record, std::size_t first) {
  return {near_coordinate(record[first]), near_coordinate(record[first + 1]),
          near_coordinate(record[first + 2])};
}

PolygonMesh near_solid(std::span<const std::uint8_t> record) {
  const Point3 a = near_corner(record, 2);
  if ((record[0] & 1U) != 0) {
    return tetrahedron_mesh(a, near_corner(record, 5), near_corner(record, 8),
                            near_corner(record, 11));
  }
  // From no angle to a quarter of a radian.
  const int exponent = -2 - record[1] % 52;
  return turned(box_mesh(a, {4, 4, 4}), record[1] == 255 ? 0 : std::ldexp(1, exponent));
}

}  // namespace

NearSolidOutput near_solid_output(std::span<const std::uint8_t> record) {
  const bool is_float = (record[0] & 8U) != 0, is_polygons = (record[0] & 16U) != 0;
  return {is_float ? CoordinateType::Float : CoordinateType::Double,
          is_polygons ? MeshFaces::PlanarPolygons : MeshFaces::Triangles, (record[0] & 32U) != 0};
}

Nef3 apply_near_solid(const Nef3& set, std::span<const std::uint8_t> record) {
  Nef3 next;
  try {
    next = Nef3::from_mesh(near_solid(record));
  } catch (const Error&) {
    return set;
  }
  const unsigned operation = record[0] >> 1U & 3U;
  if (set.is_empty() || operation < 2) return (set + next).regularization();
  return (operation == 2 ? set - next : set ^ next).regularization();
}

std::vector<std::uint8_t> random_near_solids(Dice& dice, std::size_t solids) {
  std::vector<std::uint8_t> bytes(solids * kNearSolidRecord);
  for (std::uint8_t& byte : bytes) byte = static_cast<std::uint8_t>(dice.below(256));
  return bytes;
}

}  // namespace plumb::testing
