#include "plumb/space/set/moved_planes.h"

#include <array>
#include <cstddef>
#include <vector>

#include "plumb/predicates/arithmetic/fingerprint.h"
#include "plumb/predicates/space/filter_stages.h"

namespace plumb {
namespace {

std::uint32_t hash_of_fingerprint(Fingerprint fingerprint) {
  return static_cast<std::uint32_t>(SeededHash{}(fingerprint));
}

/// Returns the residues of the image of a plane.
ResidueRow image_of_residues(const MovedPlanes::Map& map, const PlaneResidues& plane) {
  ResidueRow image;
  for (std::size_t k = 0; k < image.size(); ++k) {
    const ResidueRow& row = map.residues[k];
    image[k] = sum_of_products(row[0], plane.n[0], row[1], plane.n[1], row[2], plane.n[2]) +
               row[3] * plane.d;
  }
  return image;
}

/// Compares two planes. Returns Zero if they are different, and otherwise the sign of the factor
/// between their coefficients.
Sign factor_between(const IntegerRow& p, const IntegerRow& q) {
  std::size_t k = 0;
  while (p[k].is_zero()) ++k;  // This ends, because the normal is not zero.
  for (std::size_t i = 0; i < p.size(); ++i) {
    if (p[i] * q[k] != q[i] * p[k]) return Sign::Zero;
  }
  return sign_of(p[k].sign()) * sign_of(q[k].sign());
}

}  // namespace

MovedPlanes::Map::Map(const AffineMap3& map) : exact(map) {
  for (std::size_t k = 0; k < residues.size(); ++k) {
    for (std::size_t j = 0; j < residues[k].size(); ++j) {
      residues[k][j] = Residue::of(exact.plane_matrix()[k][j]);
    }
  }
}

MovedPlanes::MovedPlanes(const PlaneTable& planes, std::span<const PlaneId> wanted)
    : planes_(planes) {
  std::vector<std::uint8_t> is_known(planes.size(), 0);
  for (const PlaneId p : wanted) {
    if (is_known[p.value()] != 0 || planes.is_frame(p)) continue;
    is_known[p.value()] = 1;
    // Several planes may have the same fingerprint, but each plane is added once.
    index_.find_or_add(hash_of_fingerprint(planes.fingerprint(p)), p.value(),
                       [](std::uint32_t) { return false; });
  }
}

OrientedPlane MovedPlanes::image_of(const PlaneTable& from, PlaneId p, const Map& map) const {
  const ResidueRow residues_of_image = image_of_residues(map, residues(from, p));
  IntegerRow image;
  bool has_image = false;
  const auto exact_image = [&]() -> const IntegerRow& {
    if (!has_image) image = map.exact.image_of_plane(from.coefficients(p));
    has_image = true;
    return image;
  };
  const Fingerprint wanted = leading(residues_of_image).is_zero() ? fingerprint(exact_image())
                                                                  : fingerprint(residues_of_image);
  OrientedPlane found;
  index_.find(hash_of_fingerprint(wanted), [&](std::uint32_t id) {
    if (planes_.fingerprint(PlaneId(id)) != wanted) return false;
    const Sign factor = factor_between(exact_image(), planes_.coefficients(PlaneId(id)));
    if (factor == Sign::Zero) return false;
    found = OrientedPlane(PlaneId(id), factor == Sign::Negative);
    return true;
  });
  return found;
}

}  // namespace plumb
