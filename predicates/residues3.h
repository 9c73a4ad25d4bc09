// Points and planes of space modulo q = 2^61 - 1: what fingerprints are made of.
#pragma once

#include <array>
#include <cstddef>

#include "plumb/predicates/fingerprint.h"
#include "plumb/predicates/plane_table.h"
#include "plumb/predicates/point.h"

namespace plumb {

using Residues3 = std::array<Residue, 3>;

inline Residues3 residues(const Point3& p) {
  return {Residue::of(p.x), Residue::of(p.y), Residue::of(p.z)};
}

inline Residues3 cross(const Residues3& a, const Residues3& b) {
  return {cross_product(a[1], b[2], a[2], b[1]), cross_product(a[2], b[0], a[0], b[2]),
          cross_product(a[0], b[1], a[1], b[0])};
}

inline Residue dot(const Residues3& a, const Residues3& b) {
  return sum_of_products(a[0], b[0], a[1], b[1], a[2], b[2]);
}

inline Residues3 operator*(Residue s, const Residues3& a) { return {s * a[0], s * a[1], s * a[2]}; }

inline Residues3 operator-(const Residues3& a, const Residues3& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

/// n.x + d = 0 up to a factor.
struct PlaneResidues {
  Residues3 n;
  Residue d;
};

inline PlaneResidues plane_residues(const Residues3& p, const Residues3& q, const Residues3& r) {
  const Residues3 n = cross(q - p, r - p);
  return {n, -dot(n, p)};
}

/// Of a plane of the frame: with kFrameResidue for R.
inline PlaneResidues residues(const PlaneTable& planes, PlaneId id) {
  const PlaneSource& source = planes.source(id);
  if (source.is_explicit()) {
    const IntegerRow row = planes.coefficients(id);
    const Residue unit = source.is_frame() ? kFrameResidue : Residue::of(std::uint64_t{1});
    return {{Residue::of(row[0]), Residue::of(row[1]), Residue::of(row[2])},
            unit * Residue::of(row[3])};
  }
  const auto at = [&](std::size_t i) { return residues(planes.points()[source.code[i]]); };
  return plane_residues(at(0), at(1), at(2));
}

}  // namespace plumb
