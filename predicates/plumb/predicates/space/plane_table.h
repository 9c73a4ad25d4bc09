// The planes of space, each stored once: equal planes have equal ids.
//
// A plane is the set n.x + d = 0 with its two sides. The table keeps, for every plane,
//
//   row          normal and offset in doubles with error bounds, which filters read
//   fingerprint  a hash of the exact homogeneous row (n, d), by which interning finds equal planes
//   source       three input points, or a slot of exact limbs, which the exact stages read
//
// A plane takes 60 bytes, 12 to 24 more in the index, and a plane through three input points
// allocates nothing. The exact coefficients of such a plane are never stored: computing them again
// costs less than fetching them.
//
// The canonical orientation of a plane makes the first nonzero one of (a, b, c) positive. So
// opposite orientations share an id and differ in one bit (OrientedPlane). Ids number the planes in
// the order of their first appearance.
//
// The frame consists of six planes x = -R, x = R, y = -R, ... of a cube whose size R is larger than
// every number, for sets that reach to infinity (docs/design/frame.md). Their normals are ordinary,
// their offsets are +R and -R. Only offsets hold R, and no two of them are ever multiplied, so
// every determinant is c0 + c1 R: it has the sign of c1, or if that is zero the sign of c0. Every
// predicate on planes and points takes them. No other plane equals them. Their rows have an exact
// normal, the offset in units of R, and an infinite offset error. So filters that read normals
// alone decide as for other planes; those that read offsets are Unsure of the rows as they stand,
// and decide c1 and c0 one after the other from rows for each part (filter_stages.h). The exact
// stages are asked for the two parts in the same way (Part in plane_exact.h).
//
// Const members may be called from several threads at once; interning is exclusive.
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

using PlaneId = StrongId<struct PlaneTag>;
/// An input point of space, by its index in the table.
using InputPointId = StrongId<struct InputPointTag>;

/// A plane with a direction of its normal, in 32 bits. A default-constructed one is no plane.
class OrientedPlane {
 public:
  constexpr OrientedPlane() = default;
  constexpr OrientedPlane(PlaneId plane, bool is_opposite)
      : code_(plane.value() * 2 + static_cast<std::uint32_t>(is_opposite)) {}

  constexpr bool is_valid() const { return code_ != kInvalid; }
  /// Requires is_valid().
  constexpr PlaneId plane() const { return PlaneId(code_ >> 1); }
  /// Whether the normal is opposite to the canonical one.
  constexpr bool is_opposite() const { return (code_ & 1) != 0; }
  /// Returns the factor of signs: the side of a point on the oriented plane is orientation() times
  /// its side on plane().
  constexpr Sign orientation() const { return is_opposite() ? Sign::Negative : Sign::Positive; }
  /// Returns the same plane with the other direction.
  constexpr OrientedPlane opposite() const { return {plane(), !is_opposite()}; }
  friend constexpr auto operator<=>(OrientedPlane, OrientedPlane) = default;

 private:
  static constexpr std::uint32_t kInvalid = ~std::uint32_t{0};
  std::uint32_t code_ = kInvalid;
};

/// The canonical plane, scaled by a power of two so that 1/2 <= max |n[i]| <= 1, in doubles:
/// |n[i] - exact| <= normal_error / 2 and |d - exact| <= offset_error / 2. The other halves pay for
/// the roundings of what is computed from them (plane_signs.cpp). If offset_error is infinite, no
/// filter that reads the offset decides. In the row of a plane with the offset d R, d is the sign
/// of that multiple and offset_error is infinite.
struct PlaneRow {
  std::array<double, 3> n;  ///< The normal.
  double d;                 ///< The offset.
  float normal_error;       ///< Twice the error of a component of the normal, at least 2^-48.
  float offset_error;       ///< Twice the error of the offset, at least 2^-126.
};

/// The residue that stands for R in fingerprints. Equal objects stay equal whatever number stands
/// for R.
inline constexpr Residue kFrameResidue = Residue::of(std::uint64_t{0x13198a2e03707344});

/// Where a plane comes from.
struct PlaneSource {
  static constexpr std::uint32_t kExplicit = ~std::uint32_t{0};
  /// One of three codes: three input points, counter-clockwise seen from the positive side;
  /// {kExplicit, slot, 0}, a plane with stored coefficients; {kExplicit, slot, 1 + i}, plane i of
  /// the frame for i < 6, and for i = 6 any other plane n.x + d R = 0, whose d the slot has.
  std::array<std::uint32_t, 3> code;
  /// Whether the coefficients are stored in a slot.
  bool is_explicit() const { return code[0] == kExplicit; }
  /// Whether the offset is a multiple of R.
  bool is_frame() const { return is_explicit() && code[2] != 0; }
  /// Returns the i of `code`. For the six planes of the cube i / 2 is the axis, and i is odd for
  /// the plane at +R. Requires is_frame().
  std::size_t frame_index() const { return code[2] - 1; }
  /// Whether p is one of the three input points that define the plane.
  bool has_point(InputPointId p) const {
    return !is_explicit() && (code[0] == p.value() || code[1] == p.value() || code[2] == p.value());
  }
};

/// The exact coefficients of n.x + d 2^scale = 0 in the limb pool: the 4 integers a, b, c, d in
/// two's complement.
struct PlaneSlot {
  std::size_t first;               ///< Index of the first limb.
  std::uint32_t limbs;             ///< Number of limbs of each of the four integers.
  std::int32_t scale;              ///< Exponent of the unit of the offset.
  std::int32_t normal_bits;        ///< |a|, |b|, |c| < 2^normal_bits.
  std::int32_t offset_bits;        ///< |d| < 2^offset_bits.
  std::array<PlaneId, 2> parents;  ///< The planes of a wall's pencil; not valid for other planes.
};

/// A wall: the plane c_second * first - c_first * second of the pencil of two planes, with exact
/// multipliers of their rows PlaneTable::coefficients.
struct Pencil {
  PlaneId first;     ///< One plane of the pencil.
  PlaneId second;    ///< The other plane of the pencil.
  Integer c_first;   ///< The value at the wall's point or direction of the first row.
  Integer c_second;  ///< The value there of the second row.
};

/// The planes of space and the input points that define them. See the head of this file.
class PlaneTable {
 public:
  PlaneTable();
  ~PlaneTable();
  /// Copies a table, with the same ids. Costs as much as copying the arrays; nothing is computed or
  /// looked up.
  explicit PlaneTable(const PlaneTable& other);
  /// Takes the planes and input points of `other` to which the maps give an id, under that id.
  /// Requires that each map has one entry for each plane (point), that the valid ones are 0, 1, 2,
  /// ... in order, and that every corner of a plane that is kept is kept. A wall whose parents are
  /// not both kept loses them.
  PlaneTable(const PlaneTable& other, std::span<const PlaneId> plane_map,
             std::span<const InputPointId> point_map);
  PlaneTable(PlaneTable&&) noexcept;
  PlaneTable& operator=(PlaneTable&&) noexcept;

  /// Reserves memory for so many planes in all.
  void reserve(std::size_t planes);

  // --- input points ---------------------------------------------------------------------------
  /// Adds points and returns the id of the first; the others follow. Equal points may be added
  /// twice and get two ids. Requires finite coordinates, and at most 2^31 - 1 points in all.
  InputPointId add_points(std::span<const Point3> points);
  /// Adds one point and returns its id.
  InputPointId add_point(const Point3& p) { return add_points({&p, 1}); }
  const Point3& point(InputPointId p) const { return points_[p.value()]; }
  std::span<const Point3> points() const { return points_; }
  /// Returns the grid of the point's coordinates. It is kept because every exact stage starts from
  /// it.
  const Grid& grid(InputPointId p) const { return grids_[p.value()]; }

  // --- interning ------------------------------------------------------------------------------
  // The result is valid if and only if the arguments define a plane: the normal is not zero. A
  // plane that is known already gives its id. Requires at most 2^31 - 2 planes.

  /// Returns the plane through three input points, positive where p, q, r are seen
  /// counter-clockwise. Cost: about 250 ns, mostly one modular inversion; intern_triangles() serves
  /// many at once.
  OrientedPlane intern(InputPointId p, InputPointId q, InputPointId r);
  /// Returns a x + b y + c z + d = 0 with its positive side. The doubles are taken exactly.
  /// Requires that they are finite.
  OrientedPlane intern(double a, double b, double c, double d);
  /// Returns the same for rational coefficients.
  OrientedPlane intern(const Rational& a, const Rational& b, const Rational& c, const Rational& d);
  /// Returns a plane of a pencil. If it is new, the table keeps the two planes as its parents().
  /// The wall of two planes of the frame, or of one of them and a plane through the origin, is a
  /// far plane n.x + d R = 0 (PlaneSource) and has no parents.
  OrientedPlane intern(const Pencil& wall);
  /// Returns the planes x = -R, x = R, y = -R, y = R, z = -R, z = R. The cube is on the positive
  /// side of those at -R and on the negative side of those at R.
  std::array<PlaneId, 6> intern_frame();
  /// Sets result[i] to intern() of triangle i, with one inversion for many. Cost: about 90 ns a
  /// triangle in cache, 200 ns in a mesh of 2*10^5 triangles. Requires result.size() ==
  /// triangles.size().
  void intern_triangles(std::span<const std::array<InputPointId, 3>> triangles,
                        std::span<OrientedPlane> result);
  /// Adds the points and planes of another table; result[i] is the id of its plane i here. Its
  /// points come after those of this table, in their order. This is a hash join: nothing is
  /// computed anew but the confirmation of equal planes. The canonical orientation belongs to the
  /// plane, so signs need no translation. Requires a table other than this one.
  std::vector<PlaneId> merge(const PlaneTable& other);

  // --- reading --------------------------------------------------------------------------------
  std::size_t size() const { return rows_.size(); }
  const PlaneRow& row(PlaneId p) const { return rows_[p.value()]; }
  Fingerprint fingerprint(PlaneId p) const { return fingerprints_[p.value()]; }
  const PlaneSource& source(PlaneId p) const { return sources_[p.value()]; }
  const PlaneSlot& slot(const PlaneSource& s) const { return slots_[s.code[1]]; }
  const std::uint64_t* limbs(const PlaneSlot& s) const { return limbs_.data() + s.first; }
  bool is_frame(PlaneId p) const { return source(p).is_frame(); }
  /// Returns what intern_frame() returned; ids that are not valid if it has not been called.
  const std::array<PlaneId, 6>& frame() const { return frame_; }

  /// Whether both parents of `wall` are among the given planes, so that it contains their common
  /// points.
  bool is_wall_of(PlaneId wall, std::span<const PlaneId> planes) const;
  /// Returns the parents of a plane that was first interned as a wall; nothing for other planes.
  std::optional<std::array<PlaneId, 2>> parents(PlaneId wall) const;
  /// Returns exact coefficients (a, b, c, d) of the canonical plane, up to a positive factor that
  /// is always the same. Of a plane of the frame, d is the multiple of R that its offset is.
  IntegerRow coefficients(PlaneId p) const;
  /// Returns the same with gcd 1. For output, as it costs the gcd.
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

/// Returns the wall of two planes, through their common line, that is parallel to `direction`. (Two
/// planes without a common line give one of the two, or no plane.) Requires finite doubles. The
/// multipliers are n1.u and n2.u for the direction u. If that is an axis and the planes go through
/// points of b bits, multipliers and normals have at most 2 b + 3 bits (docs/design/numbers.md), so
/// the wall's normal, a difference of two products, has at most 4 b + 7.
Pencil wall_along(const PlaneTable& planes, PlaneId first, PlaneId second, const Point3& direction);
/// Returns the wall of two planes that contains the point x; otherwise as wall_along().
Pencil wall_through(const PlaneTable& planes, PlaneId first, PlaneId second, const Point3& x);

}  // namespace plumb
#pragma GCC visibility pop
