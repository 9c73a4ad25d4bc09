// The planes of space. Each plane is stored only once, so equal planes have equal ids.
//
// A plane is the set of all points x with n.x + d = 0. It has a positive and a negative side. The
// table stores for every plane:
//
//   row          the normal and the offset in doubles, with error bounds. Filters use the row
//   fingerprint  a hash of the exact coefficients (n, d). The table uses it to find equal planes
//   source       the definition of the plane: three input points, or stored exact coefficients
//                (PlaneSlot). The exact stages use the source
//
// A plane takes 60 bytes, and 12 to 24 more bytes in the index. A plane through three input points
// needs no allocation of its own. The exact coefficients of such a plane are never stored, because
// computing them again costs less than fetching them.
//
// In the canonical orientation of a plane, the first nonzero coefficient among (a, b, c) is
// positive. Both orientations of a plane have the same id. An OrientedPlane consists of the id and
// one more bit, which states the orientation. Ids number the planes in the order of their first
// appearance.
//
// The frame consists of the six planes x = -R, x = R, y = -R, ... of a cube. Its half-width R is
// larger than every number. Unbounded sets need the frame (docs/design/frame.md). The normals of
// the six planes do not contain R, and their offsets are +R or -R. R occurs only in offsets, and no
// two offsets are ever multiplied. Therefore every determinant has the form c0 + c1 R. It has the
// sign of c1 if c1 is not zero, and otherwise the sign of c0. Every predicate on planes and points
// accepts planes of the frame. No other plane equals a plane of the frame.
//
// The row of a plane of the frame has an exact normal, the offset in units of R, and an infinite
// offset error. Filters that use only normals decide as for other planes. Filters that use offsets
// return Unsure for these rows. Then other filters compute the signs of c1 and c0 separately
// (filter_stages.h). The exact stages compute the two parts separately, too (Part in
// plane_exact.h).
//
// Several threads may call const members at the same time. A thread that adds planes or points
// needs exclusive access to the table.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "plumb/predicates/arithmetic/double_bits.h"
#include "plumb/predicates/arithmetic/fingerprint.h"
#include "plumb/predicates/point.h"
#include "plumb/predicates/rational.h"
#include "plumb/predicates/sign.h"
#include "plumb/predicates/strong_id.h"

#pragma GCC visibility push(default)
namespace plumb {

namespace exact3 {
struct LongPlane;
}  // namespace exact3

using PlaneId = StrongId<struct PlaneTag>;
/// An input point of space, by its index in the table.
using InputPointId = StrongId<struct InputPointTag>;

/// A plane together with one of the two directions of its normal, in 32 bits. A default-constructed
/// OrientedPlane is not valid.
class OrientedPlane {
 public:
  constexpr OrientedPlane() = default;
  constexpr OrientedPlane(PlaneId plane, bool is_opposite)
      : code_(plane.value() * 2 + static_cast<std::uint32_t>(is_opposite)) {}

  constexpr bool is_valid() const { return code_ != kInvalid; }
  /// Requires is_valid().
  constexpr PlaneId plane() const { return PlaneId(code_ >> 1); }
  /// Whether the normal is opposite to the canonical normal.
  constexpr bool is_opposite() const { return (code_ & 1) != 0; }
  /// Returns Negative if is_opposite(), otherwise Positive. The side of the oriented plane on which
  /// a point lies is orientation() times the side of plane() on which the point lies.
  constexpr Sign orientation() const { return is_opposite() ? Sign::Negative : Sign::Positive; }
  /// Returns the same plane with the other direction.
  constexpr OrientedPlane opposite() const { return {plane(), !is_opposite()}; }
  friend constexpr auto operator<=>(OrientedPlane, OrientedPlane) = default;

 private:
  static constexpr std::uint32_t kInvalid = ~std::uint32_t{0};
  std::uint32_t code_ = kInvalid;
};

/// The coefficients of a plane in its canonical orientation, in doubles. They are scaled by a power
/// of two so that 1/2 <= max |n[i]| <= 1. The error of each n[i] is at most normal_error / 2, and
/// the error of d is at most offset_error / 2. The other halves of normal_error and offset_error
/// cover the rounding errors of computations with the row (plane_signs.cpp). If offset_error is
/// infinite, every filter that uses the offset returns Unsure. If the offset of the plane is a
/// multiple f R of R, d is the sign of f, and offset_error is infinite.
struct PlaneRow {
  std::array<double, 3> n;  ///< The normal.
  double d;                 ///< The offset.
  float normal_error;       ///< Twice the error bound of each component of n, at least 2^-48.
  float offset_error;       ///< Twice the error bound of the offset, at least 2^-126.
};

/// The residue that stands for R when fingerprints are computed. Any other residue would be
/// possible, too: equal objects always have equal fingerprints.
inline constexpr Residue kFrameResidue = Residue::of(std::uint64_t{0x13198a2e03707344});

/// The definition of a plane by three input points, by stored coefficients, or as a plane of the
/// frame.
struct PlaneSource {
  static constexpr std::uint32_t kExplicit = ~std::uint32_t{0};
  /// One of the following codes:
  ///   - the ids of three input points, which appear counter-clockwise from the positive side;
  ///   - {kExplicit, slot, 0}: a plane whose coefficients are stored in the PlaneSlot with this
  ///     index;
  ///   - {kExplicit, slot, 1 + i} with i < 6: plane i of the frame;
  ///   - {kExplicit, slot, 7}: any other plane n.x + d R = 0; the slot stores d.
  std::array<std::uint32_t, 3> code;
  /// Whether the coefficients are stored in a PlaneSlot.
  bool is_explicit() const { return code[0] == kExplicit; }
  /// Whether the offset is a multiple of R.
  bool is_frame() const { return is_explicit() && code[2] != 0; }
  /// Returns the index i = code[2] - 1. For the six planes of the frame, i < 6, and i / 2 is the
  /// axis to which the plane is orthogonal. The index is odd for a plane at +R and even for a plane
  /// at -R. For any other plane n.x + d R = 0, i = 6. Requires is_frame().
  std::size_t frame_index() const { return code[2] - 1; }
  /// Whether p is one of the three input points that define the plane.
  bool has_point(InputPointId p) const {
    return !is_explicit() && (code[0] == p.value() || code[1] == p.value() || code[2] == p.value());
  }
};

/// The exact coefficients of a plane n.x + d 2^scale = 0 with n = (a, b, c). The table stores the
/// four integers a, b, c, d in two's complement, in one array of limbs.
struct PlaneSlot {
  std::size_t first;               ///< Index of the first limb.
  std::uint32_t limbs;             ///< Number of limbs of each of the four integers.
  std::int32_t scale;              ///< The unit of the offset is 2^scale.
  std::int32_t normal_bits;        ///< |a|, |b|, |c| < 2^normal_bits.
  std::int32_t offset_bits;        ///< |d| < 2^offset_bits.
  std::array<PlaneId, 2> parents;  ///< The parents of a wall; invalid for other planes.
};

/// A plane of a pencil. The pencil of two planes consists of all planes through their common line.
/// A plane of the pencil is called a wall of the two planes. The coefficients of the wall are
/// c_second * first - c_first * second. Here `first` and `second` stand for the coefficients that
/// PlaneTable::coefficients() returns for the two planes.
struct Pencil {
  PlaneId first;     ///< One of the two planes that define the pencil.
  PlaneId second;    ///< The other of these two planes.
  Integer c_first;   ///< The value of the equation of `first` at a point or direction of the wall.
  Integer c_second;  ///< The value of the equation of `second` at the same point or direction.
};

/// The planes of space and the input points that define them. The opening comment of this file
/// describes the table.
class PlaneTable {
 public:
  PlaneTable();
  ~PlaneTable();
  /// Copies a table and keeps all ids. This costs as much as copying the arrays.
  explicit PlaneTable(const PlaneTable& other);
  /// Copies a part of the planes and input points of `other`. The maps contain the new id of each
  /// plane and point that is kept, and invalid ids for the rest. A wall whose parents are not both
  /// kept has no parents in the copy. Requires:
  ///   - each map has one entry for each plane (or point);
  ///   - the valid entries of each map are 0, 1, 2, ... in this order;
  ///   - the input points that define a kept plane are kept, too.
  PlaneTable(const PlaneTable& other, std::span<const PlaneId> plane_map,
             std::span<const InputPointId> point_map);
  PlaneTable(PlaneTable&&) noexcept;
  PlaneTable& operator=(PlaneTable&&) noexcept;

  /// Reserves memory for `planes` planes, including the planes that are already in the table.
  void reserve(std::size_t planes);

  // --- input points ---------------------------------------------------------------------------
  /// Adds points and returns the id of the first point. The ids of the other points follow in the
  /// order of `points`. If equal points are added, each of them gets its own id. Requires finite
  /// coordinates, and at most 2^31 - 1 points in all.
  InputPointId add_points(std::span<const Point3> points);
  /// Adds one point and returns its id.
  InputPointId add_point(const Point3& p) { return add_points({&p, 1}); }
  const Point3& point(InputPointId p) const { return points_[p.value()]; }
  std::span<const Point3> points() const { return points_; }
  /// Returns the grid of the point's coordinates. The table stores it because every exact stage
  /// needs it.
  const Grid& grid(InputPointId p) const { return grids_[p.value()]; }

  // --- interning ------------------------------------------------------------------------------
  // To intern a plane means to find its id, or to add the plane if it is new. The result is valid
  // if and only if the arguments define a plane, that is, the normal is not zero. Requires at most
  // 2^31 - 2 planes.

  /// Returns the plane through three input points. Seen from the positive side of this plane, p, q,
  /// r appear counter-clockwise. Cost: about 250 ns, most of it for one modular inversion. For many
  /// planes, intern_triangles() is faster.
  OrientedPlane intern(InputPointId p, InputPointId q, InputPointId r);
  /// Returns the plane a x + b y + c z + d = 0. Its positive side consists of the points at which
  /// the left side of this equation is positive. The exact values of the doubles are used. Requires
  /// finite doubles.
  OrientedPlane intern(double a, double b, double c, double d);
  /// Returns the plane a x + b y + c z + d = 0 with rational coefficients.
  OrientedPlane intern(const Rational& a, const Rational& b, const Rational& c, const Rational& d);
  /// Sets result[i] to the plane with the coefficients planes[i] (plane_exact.h). Many planes share
  /// one modular inversion, and no number is allocated. Requires result.size() == planes.size().
  void intern_coefficients(std::span<const exact3::LongPlane> planes,
                           std::span<OrientedPlane> result);
  /// Returns the plane of a wall. If the plane is new, the table stores the two planes of the
  /// pencil as its parents(). There are two cases in which the wall is a far plane n.x + d R = 0
  /// (PlaneSource), which has no parents:
  ///   - both planes of the pencil belong to the frame;
  ///   - one plane belongs to the frame, and the other plane contains the origin.
  OrientedPlane intern(const Pencil& wall);
  /// Returns the planes x = -R, x = R, y = -R, y = R, z = -R, z = R. The cube lies on the positive
  /// side of the planes at -R and on the negative side of the planes at R.
  std::array<PlaneId, 6> intern_frame();
  /// Sets result[i] to intern() of the corners of triangle i. Many triangles share one modular
  /// inversion. Each triangle takes about 90 ns if the data are in the cache, and about 200 ns in a
  /// mesh of 2*10^5 triangles. Requires result.size() == triangles.size().
  void intern_triangles(std::span<const std::array<InputPointId, 3>> triangles,
                        std::span<OrientedPlane> result);
  /// Adds the points and planes of another table. Plane i of `other` has the id result[i] in this
  /// table. The points of `other` are appended to the points of this table in the same order. Equal
  /// planes of the two tables are found by their fingerprints. If two planes have the same
  /// fingerprint, exact arithmetic confirms that they are equal. A plane has the same canonical
  /// orientation in both tables, so the signs of predicates stay valid. Requires a table other than
  /// this one.
  std::vector<PlaneId> merge(const PlaneTable& other);

  // --- reading --------------------------------------------------------------------------------
  std::size_t size() const { return rows_.size(); }
  const PlaneRow& row(PlaneId p) const { return rows_[p.value()]; }
  Fingerprint fingerprint(PlaneId p) const { return fingerprints_[p.value()]; }
  const PlaneSource& source(PlaneId p) const { return sources_[p.value()]; }
  const PlaneSlot& slot(const PlaneSource& s) const { return slots_[s.code[1]]; }
  const std::uint64_t* limbs(const PlaneSlot& s) const { return limbs_.data() + s.first; }
  bool is_frame(PlaneId p) const { return source(p).is_frame(); }
  /// Returns the result of intern_frame(), or invalid ids if it has not been called.
  const std::array<PlaneId, 6>& frame() const { return frame_; }

  /// Whether both parents of `wall` are among the given planes. If so, `wall` contains every common
  /// point of these planes.
  bool is_wall_of(PlaneId wall, std::span<const PlaneId> planes) const;
  /// Returns the parents of a plane that was first interned as a wall, and no value for other
  /// planes.
  std::optional<std::array<PlaneId, 2>> parents(PlaneId wall) const;
  /// Returns exact coefficients (a, b, c, d) of the plane in its canonical orientation, up to a
  /// positive factor. The factor is the same in every call. The offset of a plane of the frame is a
  /// multiple d R of R. For such a plane, the function returns this factor d.
  IntegerRow coefficients(PlaneId p) const;
  /// Returns the coefficients divided by their greatest common divisor. Computing this divisor is
  /// expensive, so the function is meant for output only.
  IntegerRow primitive(PlaneId p) const;

 private:
  struct Index;
  struct Draft;
  class CornerNotes;

  void make_room(std::size_t planes);
  Draft draft(const PlaneSource& corners) const;
  OrientedPlane find_or_add(const Draft& draft, Fingerprint fingerprint,
                            CornerNotes* notes = nullptr);
  PlaneId push(const PlaneRow& row, Fingerprint fingerprint, const PlaneSource& source);
  void intern_block(std::span<const std::array<InputPointId, 3>> triangles,
                    std::span<OrientedPlane> result, CornerNotes& notes);
  PlaneSource push_slot(const IntegerRow& row, int scale, std::array<PlaneId, 2> parents);
  PlaneSource push_slot(const exact3::LongPlane& plane);
  OrientedPlane intern_coefficients(const exact3::LongPlane& plane, Fingerprint fingerprint);
  PlaneSource copy_slot(const PlaneTable& other, const PlaneSource& source,
                        std::span<const PlaneId> map);
  void pop_slot();
  OrientedPlane intern_row(IntegerRow row, int scale, std::array<PlaneId, 2> parents);

  std::vector<Point3> points_;
  std::vector<Grid> grids_;  // The grid of each point.
  std::vector<PlaneRow> rows_;
  std::vector<Fingerprint> fingerprints_;
  std::vector<PlaneSource> sources_;
  std::vector<PlaneSlot> slots_;
  std::vector<std::uint64_t> limbs_;
  std::array<PlaneId, 6> frame_;
  std::unique_ptr<Index> index_;  // Finds the id of a fingerprint (plane_table.cpp).
};

/// Returns the wall of two planes that is parallel to `direction`. (If the two planes have no
/// common line, the result is one of these planes, or no plane.) Requires finite doubles. The
/// multipliers c_first and c_second are n1.u and n2.u, where n1 and n2 are the normals of the two
/// planes and u is the direction. Suppose that u is a coordinate axis, and that the planes pass
/// through input points of b bits. Then the multipliers and normals have at most 2 b + 3 bits
/// (docs/design/numbers.md). The normal of the wall is a difference of two products, so it has at
/// most 4 b + 7 bits.
Pencil wall_along(const PlaneTable& planes, PlaneId first, PlaneId second, const Point3& direction);
/// Returns the wall of two planes that contains the point x. Otherwise the function does the same
/// as wall_along().
Pencil wall_through(const PlaneTable& planes, PlaneId first, PlaneId second, const Point3& x);

}  // namespace plumb
#pragma GCC visibility pop
