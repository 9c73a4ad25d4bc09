// The planes of space, each stored once: equal planes have equal ids.
//
// A plane is the set n.x + d = 0 with its two sides. The table keeps, for every plane,
//
//   row          normal and offset in doubles with their errors: what filters read
//   fingerprint  of the exact homogeneous row (n, d): what interning reads
//   source       three input points, or a slot of exact limbs: what exact rungs read
//
// 60 bytes a plane, 12 to 24 in the index, and no allocation for a plane through three input
// points. Exact coefficients of such a plane are never stored: rebuilding them costs less than
// fetching them.
//
// Canonical orientation: the first nonzero one of (a, b, c) is positive, so opposite orientations
// share an id and differ in a bit. Ids number the planes in the order of their first appearance.
//
// The frame: six planes x = -R, x = R, y = -R, ... of a cube with R beyond all bounds, for sets
// that reach to infinity (SPACE.md 5). Their normals are ordinary, their offsets are +R and -R.
// Only offsets hold R, and never two of them are multiplied, so that every determinant is c0 + c1
// R: it has the sign of c1, or if that is zero of c0. Every predicate on planes and points takes
// them. No other plane equals them, and no doubles bound them: filters are Unsure, and the exact
// rungs ask twice (plane_exact.h, Part).
//
// Const members may be called from many threads at once; interning is exclusive.
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

/// A plane with a direction of its normal, in 32 bits. Default-constructed: no plane.
class OrientedPlane {
 public:
  constexpr OrientedPlane() = default;
  constexpr OrientedPlane(PlaneId plane, bool is_opposite)
      : code_(plane.value() * 2 + static_cast<std::uint32_t>(is_opposite)) {}

  constexpr bool is_valid() const { return code_ != kInvalid; }
  /// Requires is_valid().
  constexpr PlaneId plane() const { return PlaneId(code_ >> 1); }
  /// Does it run against the canonical orientation?
  constexpr bool is_opposite() const { return (code_ & 1) != 0; }
  /// The side of the oriented plane = orientation() * the side of plane().
  constexpr Sign orientation() const { return is_opposite() ? Sign::Negative : Sign::Positive; }
  constexpr OrientedPlane opposite() const { return {plane(), !is_opposite()}; }
  friend constexpr auto operator<=>(OrientedPlane, OrientedPlane) = default;

 private:
  static constexpr std::uint32_t kInvalid = ~std::uint32_t{0};
  std::uint32_t code_ = kInvalid;
};

/// The canonical plane, scaled by a power of two so that 1/2 <= max |n[i]| <= 1, in doubles:
/// |n[i] - exact| <= normal_error / 2 and |d - exact| <= offset_error / 2. The other halves pay for
/// the rounding of what is computed from them (plane_signs.cpp). normal_error >= 2^-48;
/// offset_error may be infinite: no filter then decides. With d R for an offset: d is its sign.
struct PlaneRow {
  std::array<double, 3> n;
  double d;
  float normal_error;
  float offset_error;
};

/// What R of the frame is in fingerprints: equal objects stay equal when any number stands for R.
inline constexpr Residue kFrameResidue = Residue::of(std::uint64_t{0x13198a2e03707344});

/// Where a plane comes from.
struct PlaneSource {
  static constexpr std::uint32_t kExplicit = ~std::uint32_t{0};
  /// Three input points; counter-clockwise seen from the positive side. Or {kExplicit, slot, 0}. Or
  /// {kExplicit, slot, 1 + i}: plane i of the frame, i = 6 any other plane n.x + d R = 0; the slot
  /// has d.
  std::array<std::uint32_t, 3> code;
  bool is_explicit() const { return code[0] == kExplicit; }
  bool is_frame() const { return is_explicit() && code[2] != 0; }
  /// Requires is_frame(). Of the frame's six the axis is half of it; odd: at +R.
  std::size_t frame_index() const { return code[2] - 1; }
  bool has_point(InputPointId p) const {
    return !is_explicit() && (code[0] == p.value() || code[1] == p.value() || code[2] == p.value());
  }
};

/// Exact coefficients n.x + d 2^scale = 0 in the limb pool: 4 integers of `limbs` limbs each, from
/// `first` on.
struct PlaneSlot {
  std::size_t first;
  std::uint32_t limbs;
  std::int32_t scale;
  std::int32_t normal_bits;        ///< |a|, |b|, |c| < 2^normal_bits
  std::int32_t offset_bits;        ///< |d| < 2^offset_bits
  std::array<PlaneId, 2> parents;  ///< of a wall; else invalid
};

/// A wall: the plane c_second * first - c_first * second of the pencil of two planes, with exact
/// multipliers of their rows PlaneTable::coefficients.
struct Pencil {
  PlaneId first;
  PlaneId second;
  Integer c_first;
  Integer c_second;
};

class PlaneTable {
 public:
  PlaneTable();
  ~PlaneTable();
  /// A copy with the same ids. Cost: that of copying the arrays; nothing is computed or looked up.
  explicit PlaneTable(const PlaneTable& other);
  /// The planes and input points of `other` that the maps give an id, under that id.
  /// Requires of both maps: one entry for each plane (point), the valid ones 0, 1, 2, ... in order;
  /// and every corner of a kept plane kept. A wall whose parents are not both kept forgets them.
  PlaneTable(const PlaneTable& other, std::span<const PlaneId> plane_map,
             std::span<const InputPointId> point_map);
  PlaneTable(PlaneTable&&) noexcept;
  PlaneTable& operator=(PlaneTable&&) noexcept;

  void reserve(std::size_t planes);

  // --- input points ---------------------------------------------------------------------------
  /// Requires finite coordinates. At most 2^31 - 1 points. Returns the id of the first; the others
  /// follow. Equal points may be added twice: ids are not merged.
  InputPointId add_points(std::span<const Point3> points);
  InputPointId add_point(const Point3& p) { return add_points({&p, 1}); }
  const Point3& point(InputPointId p) const { return points_[p.value()]; }
  std::span<const Point3> points() const { return points_; }
  /// The grid of the point's coordinates; kept because every exact rung starts from it.
  const Grid& grid(InputPointId p) const { return grids_[p.value()]; }

  // --- interning ------------------------------------------------------------------------------
  // The result is not valid exactly when the arguments define no plane (a zero normal). A plane
  // known already gives its id. At most 2^31 - 2 planes.

  /// The plane through three input points; positive where p, q, r are seen counter-clockwise.
  /// Cost: ~250 ns (one inversion); use intern_triangles for many.
  OrientedPlane intern(InputPointId p, InputPointId q, InputPointId r);
  /// a x + b y + c z + d = 0 with its positive side; finite doubles, taken exactly.
  OrientedPlane intern(double a, double b, double c, double d);
  OrientedPlane intern(const Rational& a, const Rational& b, const Rational& c, const Rational& d);
  /// Known to lie in the pencil ever after: see has_parents. Of two planes of the frame, or a far
  /// one and one through the origin: a far plane (PlaneSource).
  OrientedPlane intern(const Pencil& wall);
  /// The planes x = -R, x = R, y = -R, y = R, z = -R, z = R; the cube is on the positive side of
  /// those at -R and on the negative side of those at R.
  std::array<PlaneId, 6> intern_frame();
  /// One plane for each triangle: result[i] = intern(triangles[i]...), but with one inversion for
  /// many. Cost: ~90 ns a triangle in cache, ~200 ns in a mesh of 2*10^5. Requires result.size() ==
  /// triangles.size().
  void intern_triangles(std::span<const std::array<InputPointId, 3>> triangles,
                        std::span<OrientedPlane> result);
  /// Adds the points and planes of another table: result[i] is its plane i here. Its points follow
  /// ours in their order. A hash join: nothing is computed anew but the confirmation of equal
  /// planes. Canonical orientation belongs to the plane, so signs need no translation.
  /// Requires another table than this one.
  std::vector<PlaneId> merge(const PlaneTable& other);

  // --- reading --------------------------------------------------------------------------------
  std::size_t size() const { return rows_.size(); }
  const PlaneRow& row(PlaneId p) const { return rows_[p.value()]; }
  Fingerprint fingerprint(PlaneId p) const { return fingerprints_[p.value()]; }
  const PlaneSource& source(PlaneId p) const { return sources_[p.value()]; }
  const PlaneSlot& slot(const PlaneSource& s) const { return slots_[s.code[1]]; }
  const std::uint64_t* limbs(const PlaneSlot& s) const { return limbs_.data() + s.first; }
  bool is_frame(PlaneId p) const { return source(p).is_frame(); }
  /// As intern_frame(); not valid where a plane has not been interned.
  const std::array<PlaneId, 6>& frame() const { return frame_; }

  /// Is `wall` a pencil of two of the given planes, so that it holds their common points?
  bool is_wall_of(PlaneId wall, std::span<const PlaneId> planes) const;
  /// The parents of a plane first interned as a wall.
  std::optional<std::array<PlaneId, 2>> parents(PlaneId wall) const;
  /// Exact coefficients (a, b, c, d) of the canonical plane; some multiple, always the same one. Of
  /// a plane of the frame: (a, b, c) and the multiple of R that its offset is.
  IntegerRow coefficients(PlaneId p) const;
  /// The same with gcd 1. For output: costs the gcd.
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
  std::vector<Grid> grids_;  // of each point
  std::vector<PlaneRow> rows_;
  std::vector<Fingerprint> fingerprints_;
  std::vector<PlaneSource> sources_;
  std::vector<PlaneSlot> slots_;
  std::vector<std::uint64_t> limbs_;
  std::array<PlaneId, 6> frame_;
  std::unique_ptr<Index> index_;  // fingerprint -> id (plane_table.cpp)
};

/// The wall of two planes through the line they share that holds the direction u, and the one that
/// holds the point x. (Two planes without a common line give one of the two, or no plane.)
/// Requires finite doubles. With n1.u, n2.u as multipliers: normal 4b + 7 bits (KERNEL.md 3).
Pencil wall_along(const PlaneTable& planes, PlaneId first, PlaneId second, const Point3& direction);
Pencil wall_through(const PlaneTable& planes, PlaneId first, PlaneId second, const Point3& x);

}  // namespace plumb
#pragma GCC visibility pop
