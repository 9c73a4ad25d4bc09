// The stages of the predicates of space: rows and boxes for the filters of each part of a number
// c0 + c1 R, residues for fingerprints, and the exact stages of signs about planes.
//
// A point that depends on the frame is P0 + u R, where R is larger than every number, and a form of
// such points is c0 + c1 R (docs/design/frame.md). The filters serve each part by itself, with
// other rows and boxes for the planes and points:
//
//   far   For c1, in units of R: the offset of a plane is the multiple of R that it has, 0 for
//         ordinary planes; a box is around u, which is 0 for a point without R.
//   near  For c0, with 0 for R: a plane of the frame has no offset; a box is around P0.
//
// If the far filter decides, that is the sign of the whole. The near filter may be asked only where
// c1 is known to be 0.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "plumb/predicates/arithmetic/fingerprint.h"
#include "plumb/predicates/input/rung_counters.h"
#include "plumb/predicates/point.h"
#include "plumb/predicates/space/plane_exact.h"
#include "plumb/predicates/space/plane_table.h"
#include "plumb/predicates/space/point3_table.h"

namespace plumb {

/// Returns the row with the exact offset 0.
inline PlaneRow row_of_normal(PlaneRow row) {
  row.d = 0;
  row.offset_error = 0;
  return row;
}

/// Returns the row for far filters. The rows of the cube's planes are exact: a unit vector and +-1.
/// Those of other far planes keep an infinite offset error, as the row does not have the multiple
/// of R, and no filter decides.
inline PlaneRow far_row(const PlaneTable& planes, PlaneId p) {
  const PlaneSource& source = planes.source(p);
  PlaneRow row = planes.row(p);
  if (!source.is_frame()) return row_of_normal(row);
  if (source.frame_index() < planes.frame().size()) row.offset_error = 0;
  return row;
}

/// Returns the row for near filters.
inline PlaneRow near_row(const PlaneTable& planes, PlaneId p) {
  return planes.is_frame(p) ? row_of_normal(planes.row(p)) : planes.row(p);
}

/// Returns the box for far filters. Requires a box that is finite or has a known direction.
inline PointBox far_box(const PointBox& box) {
  if (!is_far(box)) return {{}, 0};
  const auto& u = box.mid;
  return {u, kDirectionError * std::max({std::fabs(u[0]), std::fabs(u[1]), std::fabs(u[2])})};
}

// Points and planes of space modulo q = 2^61 - 1, from which fingerprints are made.

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

/// The plane n.x + d = 0 modulo q, up to a factor.
struct PlaneResidues {
  Residues3 n;  ///< The normal.
  Residue d;    ///< The offset.
};

/// Returns the plane through three points.
inline PlaneResidues plane_residues(const Residues3& p, const Residues3& q, const Residues3& r) {
  const Residues3 n = cross(q - p, r - p);
  return {n, -dot(n, p)};
}

/// Returns the plane with the given id, with kFrameResidue for R.
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

// The exact stages of every sign about planes. First, the narrowest width that can represent the
// operands; then wider widths; then GMP. A *form* computes the sign from an array of loaded planes
// of any number type:
//
//   form(const std::array<Plane, K>&) -> Sign      Plane = FixedPlane<W> or BigPlane, aligned
//
// If planes of the frame take part, a form is asked part by part (plane_exact.h).
namespace plumb::exact3 {

template <std::size_t K>
std::array<Operand, K> operands(const PlaneTable& table, const std::array<PlaneId, K>& ids) {
  std::array<Operand, K> result;
  for (std::size_t i = 0; i < K; ++i) result[i] = operand(table, ids[i]);
  return result;
}

template <std::size_t K>
int width_of(const std::array<Operand, K>& operands) {
  int width = 0;
  for (const Operand& o : operands) width = o.width > width ? o.width : width;
  return width;
}

template <std::size_t K>
bool has_frame(const std::array<Operand, K>& operands) {
  bool any = false;
  for (const Operand& o : operands) any |= o.source.is_frame();
  return any;
}

/// Returns the sign of one part in the width W. Unsure if the operands, or their offsets on a
/// common scale, do not fit W.
template <class W, std::size_t K, class Form>
FilteredSign fixed_part(const std::array<Operand, K>& operands, Part part, const Form& form) {
  if (width_of(operands) > W::kIndex) return FilteredSign::Unsure;
  std::array<FixedPlane<W>, K> planes;
  for (std::size_t i = 0; i < K; ++i) {
    planes[i] = load<W>(operands[i]);
    take_part(operands[i], part, planes[i]);
  }
  if (!align(planes)) return FilteredSign::Unsure;
  return filtered(form(planes));
}

/// Returns the sign of one part in integers of any length.
template <std::size_t K, class Form>
Sign big_part(const std::array<Operand, K>& operands, Part part, const Form& form) {
  std::array<BigPlane, K> planes;
  for (std::size_t i = 0; i < K; ++i) {
    planes[i] = load_big(operands[i]);
    take_part(operands[i], part, planes[i]);
  }
  align(planes);
  return form(planes);
}

/// Returns the sign of the form in the width W, part by part; Unsure as fixed_part().
template <class W, std::size_t K, class Form>
FilteredSign fixed_sign(const std::array<Operand, K>& operands, const Form& form) {
  return by_parts(has_frame(operands),
                  [&](Part part) { return fixed_part<W>(operands, part, form); });
}

/// Returns the sign of the form in integers of any length.
template <std::size_t K, class Form>
Sign big_sign(const std::array<Operand, K>& operands, const Form& form) {
  return decided(by_parts(has_frame(operands),
                          [&](Part part) { return filtered(big_part(operands, part, form)); }));
}

/// Returns the sign of one part in the narrowest numbers that hold it; calls `count` with the stage
/// that decides.
template <std::size_t K, class Form, class Count>
Sign exact_part(const std::array<Operand, K>& operands, Part part, const Form& form,
                const Count& count) {
  const auto tell = [&](Rung rung, FilteredSign s) {
    if (is_decided(s)) count(rung);
    return s;
  };
  FilteredSign s = tell(Rung::Small, fixed_part<Narrow>(operands, part, form));
  if (!is_decided(s)) s = tell(Rung::Exact, fixed_part<Medium>(operands, part, form));
  if (!is_decided(s)) s = tell(Rung::Exact, fixed_part<Wide>(operands, part, form));
  if (!is_decided(s)) s = tell(Rung::Big, filtered(big_part(operands, part, form)));
  return decided(s);
}

/// Returns the sign of the form, exactly. With a frame it asks c1 first, then near() ->
/// FilteredSign, a filter for c0, then c0.
template <std::size_t K, class Form, class Near, class Count>
Sign exact_sign(const std::array<Operand, K>& operands, const Form& form, const Near& near,
                const Count& count) {
  if (has_frame(operands)) {
    const Sign infinite = exact_part(operands, Part::Infinite, form, count);
    if (infinite != Sign::Zero) return infinite;
    const FilteredSign finite = near();
    if (is_decided(finite)) return decided(finite);
  }
  return exact_part(operands, Part::Finite, form, count);
}

/// Returns the same without a filter for c0.
template <std::size_t K, class Form, class Count>
Sign exact_sign(const std::array<Operand, K>& operands, const Form& form, const Count& count) {
  return exact_sign(
      operands, form, [] { return FilteredSign::Unsure; }, count);
}

}  // namespace plumb::exact3
