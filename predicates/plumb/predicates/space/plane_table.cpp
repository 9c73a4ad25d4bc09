// The interning of planes: equal planes get equal ids, however they are defined.
//
// A new plane is brought into canonical orientation, and its exact row (a, b, c, d) is hashed to a
// fingerprint that does not depend on its scale (fingerprint.h). A hash set finds the first plane
// with that fingerprint; whether the two are equal is then decided exactly, from the definitions if
// these are the same, by orient3d of the corners of one plane against the other, or by comparing
// exact coefficients. So fingerprints speed up the search and never decide. Planes that share a
// fingerprint with a different plane go to an ordered map by their primitive rows, so that input
// made to collide costs O(log n) a plane and not O(n).
//
// Triangles are interned in blocks: all residues of a block are inverted with one inversion, and
// the entries of the hash set that will be read are fetched ahead.
//
// Invariant: the index holds each plane once, by its fingerprint or, if another plane was there
// first, in `others`. docs/design/numbers.md (Planes) proves the rows' errors, docs/design/frame.md
// the planes at infinity.
//
// Tested by tests/predicates/plane_table_test.cpp and tests/predicates/frame_test.cpp.

#include "plumb/predicates/space/plane_table.h"

#include <algorithm>
#include <climits>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include "plumb/predicates/arithmetic/double_bits.h"
#include "plumb/predicates/arithmetic/seeded_hash.h"
#include "plumb/predicates/space/filter_stages.h"
#include "plumb/predicates/space/plane_row.h"

namespace plumb {

using exact3::BigPlane;
using exact3::kAnyScale;

// --- the index: a hash set of ids that finds planes ---------------------------------------------

namespace {

/// The sign is Zero if two canonical planes (n, d) and (m, e) are equal, and Positive otherwise.
/// They are equal if n x m = 0 and n_k e = m_k d, for the first n_k that is not zero. Parallel
/// canonical planes have the same direction, so m_k is not zero then either, and n x m = 0 follows
/// from its components with the factor n_k: m_i = 0 for i < k, and n_k m_i = m_k n_i for i > k.
struct SamePlane {
  template <class Plane>
  Sign operator()(const std::array<Plane, 2>& planes) const {
    const auto& [a, b] = planes;
    std::size_t k = 0;
    while (k < 2 && exact3::sign_of(a.n[k]) == Sign::Zero) ++k;
    using Number = typename exact3::Types<Plane>::Det4;
    for (std::size_t i = k + 1; i < 3; ++i) {
      if (differ<Number>(a.n[k], b.n[i], b.n[k], a.n[i])) return Sign::Positive;
    }
    for (std::size_t i = 0; i < k; ++i) {
      if (exact3::sign_of(b.n[i]) != Sign::Zero) return Sign::Positive;
    }
    const bool same = !differ<Number>(a.n[k], b.d, b.n[k], a.d);
    return same ? Sign::Zero : Sign::Positive;
  }

 private:
  template <class Number, class A, class B>
  static bool differ(const A& a, const B& b, const A& c, const B& d) {
    return !(exact3::product<Number>(a, b) == exact3::product<Number>(c, d));
  }
};

/// Whether the planes are defined by the same numbers. This is often the case if two tables are
/// merged that were derived from the same table.
bool is_same_definition(const PlaneTable& table, const PlaneSource& a, const PlaneSource& b) {
  if (a.is_explicit() != b.is_explicit()) return false;
  if (a.is_explicit()) {
    const PlaneSlot &s = table.slot(a), &t = table.slot(b);
    return a.code[2] == b.code[2] && s.scale == t.scale && s.limbs == t.limbs &&
           std::equal(table.limbs(s), table.limbs(s) + std::size_t{4} * s.limbs, table.limbs(t));
  }
  const std::span<const Point3> points = table.points();
  return std::equal(a.code.begin(), a.code.end(), b.code.begin(), [&](auto i, auto j) {
    const Point3 &p = points[i], &q = points[j];
    return i == j || (is_equal(p.x, q.x) && is_equal(p.y, q.y) && is_equal(p.z, q.z));
  });
}

/// Returns the side of `plane` on which the first corner of `other` lies that is not on the plane.
/// Returns Zero if all corners are on it, and Unsure if the points have more bits than the fixed
/// widths hold. Requires planes through input points. Points that are already noted as points of
/// the plane are skipped, and points that are found on it are noted.
template <class Notes>
FilteredSign first_off_plane(const PlaneTable& table, PlaneId plane, const PlaneSource& other,
                             Notes* notes) {
  const PlaneSource& source = table.source(plane);
  for (const std::uint32_t i : other.code) {
    const InputPointId p(i);
    if (source.has_point(p) || (notes != nullptr && notes->is_on(p, plane))) continue;
    const FilteredSign side = exact3::side_by_corners(table, p, source);
    if (side != FilteredSign::Zero) return side;
    if (notes != nullptr) notes->note(p, plane);
  }
  return FilteredSign::Zero;
}

/// Whether two planes with equal fingerprints are equal, exactly. There is no filter stage before,
/// because different planes with equal fingerprints are so rare that a filter does not save time.
template <class Notes>
bool is_same_plane(const PlaneTable& table, PlaneId plane, const PlaneSource& b, Notes* notes) {
  const PlaneSource& a = table.source(plane);
  if (a.is_frame() != b.is_frame()) return false;
  if (is_same_definition(table, a, b)) return true;
  if (!a.is_explicit() && !b.is_explicit()) {
    const FilteredSign off = first_off_plane(table, plane, b, notes);
    if (is_decided(off)) return off == FilteredSign::Zero;
  }
  const std::array<exact3::Operand, 2> both = {exact3::operand(table, a),
                                               exact3::operand(table, b)};
  return exact3::exact_sign(both, SamePlane{}, [](Rung) {}) == Sign::Zero;
}

std::uint32_t hash_of(Fingerprint fingerprint) {
  return static_cast<std::uint32_t>(SeededHash{}(fingerprint));
}

/// Returns (a, b, c, d) as integers on one scale.
IntegerRow integer_row(const BigPlane& plane) {
  const int scale = plane.scale == kAnyScale ? 0 : plane.scale;
  const int up = std::max(-scale, 0);
  return {shifted(plane.n[0], up), shifted(plane.n[1], up), shifted(plane.n[2], up),
          shifted(plane.d, std::max(scale, 0))};
}

IntegerRow integer_row(const PlaneTable& table, const PlaneSource& source) {
  return integer_row(exact3::load_big(exact3::operand(table, source)));
}

/// A key that equal planes have in common, however they are defined: whether the plane belongs to
/// the frame, and its primitive row.
using ExactPlane = std::pair<bool, IntegerRow>;

ExactPlane exact_plane(const PlaneTable& table, const PlaneSource& source) {
  return {source.is_frame(), primitive(integer_row(table, source))};
}

}  // namespace

struct PlaneTable::Index {
  IdIndex firsts;  ///< The first plane of each fingerprint.
  /// The planes whose fingerprint was already used by a different plane. There are few of them,
  /// except in input that is made to collide: 33^3 planes through points at powers of 2^61 on the
  /// axes have the same residue.
  std::map<ExactPlane, PlaneId> others;

  /// Prefetches the entries that the search for these fingerprints will read. The number of
  /// fingerprints should be so small that the entries stay in the cache.
  void look_ahead(std::span<const Fingerprint> fingerprints) const {
    for (const Fingerprint f : fingerprints) firsts.prefetch(hash_of(f));
  }
};

/// A plane that is not interned yet.
struct PlaneTable::Draft {
  bool is_plane;       ///< Whether the normal is not zero.
  bool is_flipped;     ///< Whether the given orientation is opposite to the canonical one.
  PlaneRow row;        ///< The row in canonical orientation.
  PlaneSource source;  ///< The source in canonical orientation.
};

/// The data about all input points while many triangles are interned: the residues of each point,
/// and the four planes on which it was last found.
class PlaneTable::CornerNotes {
 public:
  CornerNotes(std::span<const Point3> points, bool keep) : points_(points) {
    if (!keep) return;
    residues_.reserve(points.size());
    for (const Point3& p : points) residues_.push_back(residues(p));
    planes_.resize(points.size());
  }
  Residues3 residues_of(InputPointId p) const {
    return residues_.empty() ? residues(points_[p.value()]) : residues_[p.value()];
  }
  bool is_on(InputPointId p, PlaneId plane) const {
    if (planes_.empty()) return false;
    const auto& known = planes_[p.value()];
    return std::find(known.begin(), known.end(), plane) != known.end();
  }
  /// Notes that p is on a plane. This note replaces the oldest of four notes.
  void note(InputPointId p, PlaneId plane) {
    if (planes_.empty()) return;
    auto& known = planes_[p.value()];
    std::move_backward(known.begin(), known.end() - 1, known.end());
    known[0] = plane;
  }

 private:
  std::span<const Point3> points_;
  std::vector<Residues3> residues_;
  std::vector<std::array<PlaneId, 4>> planes_;
};

PlaneTable::PlaneTable() : index_(std::make_unique<Index>()) {}
PlaneTable::~PlaneTable() = default;
PlaneTable::PlaneTable(const PlaneTable& other)
    : points_(other.points_),
      grids_(other.grids_),
      rows_(other.rows_),
      fingerprints_(other.fingerprints_),
      sources_(other.sources_),
      slots_(other.slots_),
      limbs_(other.limbs_),
      frame_(other.frame_),
      index_(std::make_unique<Index>(*other.index_)) {}
PlaneTable::PlaneTable(PlaneTable&&) noexcept = default;
PlaneTable& PlaneTable::operator=(PlaneTable&&) noexcept = default;

void PlaneTable::reserve(std::size_t planes) {
  rows_.reserve(planes);
  fingerprints_.reserve(planes);
  sources_.reserve(planes);
  index_->firsts.reserve(planes);
}

/// Reserves memory for additional planes in one step. Many calls with small numbers still grow the
/// memory geometrically.
void PlaneTable::make_room(std::size_t planes) {
  const std::size_t needed = size() + planes;
  if (needed > rows_.capacity()) reserve(std::max(needed, 2 * rows_.capacity()));
}

InputPointId PlaneTable::add_points(std::span<const Point3> points) {
  const InputPointId first{points_.size()};
  points_.insert(points_.end(), points.begin(), points.end());
  grids_.reserve(points_.capacity());
  for (const Point3& p : points) grids_.push_back({p.x, p.y, p.z});
  return first;
}

/// The plane is first searched by its fingerprint. If a different plane has this fingerprint, the
/// ordered map is searched by the exact row. Therefore the time does not depend on the number of
/// planes with one fingerprint.
OrientedPlane PlaneTable::find_or_add(const Draft& draft, Fingerprint fingerprint,
                                      CornerNotes* notes) {
  const PlaneId next{rows_.size()};
  const auto has_fingerprint = [&](std::uint32_t id) { return fingerprints_[id] == fingerprint; };
  PlaneId plane{index_->firsts.find_or_add(hash_of(fingerprint), next.value(), has_fingerprint)};
  if (plane != next && !is_same_plane(*this, plane, draft.source, notes)) {
    plane = index_->others.try_emplace(exact_plane(*this, draft.source), next).first->second;
  }
  return {plane == next ? push(draft.row, fingerprint, draft.source) : plane, draft.is_flipped};
}

/// Appends a plane to all arrays. Requires that the index already contains it under this id.
PlaneId PlaneTable::push(const PlaneRow& row, Fingerprint fingerprint, const PlaneSource& source) {
  const PlaneId id{rows_.size()};
  rows_.push_back(row);
  fingerprints_.push_back(fingerprint);
  sources_.push_back(source);
  const bool is_of_cube = source.is_frame() && source.frame_index() < frame_.size();
  if (is_of_cube) frame_[source.frame_index()] = id;
  return id;
}

// --- planes through three points -----------------------------------------------------------------

namespace {

/// Returns the sign of the first nonzero component of the normal; Zero if there is none.
template <class Plane>
Sign orientation(const Plane& plane) {
  for (const auto& n : plane.n) {
    if (const Sign s = exact3::sign_of(n); s != Sign::Zero) return s;
  }
  return Sign::Zero;
}

template <class Plane>
void negate(Plane& plane) {
  for (auto& n : plane.n) n = -n;
  plane.d = -plane.d;
}

/// Sets `row` to the row of the plane in canonical orientation, and returns the orientation that
/// the plane had.
template <class Plane>
Sign canonical_row(Plane plane, PlaneRow& row) {
  const Sign sign = orientation(plane);
  if (sign == Sign::Zero) return sign;
  if (sign == Sign::Negative) negate(plane);
  row = exact_row(plane);
  return sign;
}

}  // namespace

/// For nearly every triangle, doubles determine the row and the orientation. For other triangles,
/// which are degenerate or nearly degenerate, they are computed from exact coefficients. A flip
/// swaps two corners.
PlaneTable::Draft PlaneTable::draft(const PlaneSource& corners) const {
  const auto& [p, q, r] = corners.code;
  const FastRow fast = fast_row(points_[p], points_[q], points_[r]);
  Draft result{fast.is_good, fast.is_flipped, fast.row, corners};
  if (!fast.is_good) {
    const exact3::Operand exact = exact3::operand(*this, corners);
    const Sign sign = exact.width <= exact3::Medium::kIndex
                          ? canonical_row(exact3::load<exact3::Medium>(exact), result.row)
                          : canonical_row(exact3::load_big(exact), result.row);
    result.is_plane = sign != Sign::Zero;
    result.is_flipped = sign == Sign::Negative;
  }
  if (result.is_flipped) std::swap(result.source.code[1], result.source.code[2]);
  return result;
}

namespace {

// The number of triangles that share one inversion. The scratch memory fits into the L1 cache.
constexpr std::size_t kBlock = 256;

}  // namespace

void PlaneTable::intern_triangles(std::span<const std::array<InputPointId, 3>> triangles,
                                  std::span<OrientedPlane> result) {
  CornerNotes notes(points_, triangles.size() >= points_.size() / 2);
  make_room(triangles.size());
  for (std::size_t i = 0; i < triangles.size(); i += kBlock) {
    const std::size_t count = std::min(kBlock, triangles.size() - i);
    intern_block(triangles.subspan(i, count), result.subspan(i, count), notes);
  }
}

OrientedPlane PlaneTable::intern(InputPointId p, InputPointId q, InputPointId r) {
  OrientedPlane result;
  const std::array<InputPointId, 3> triangle = {p, q, r};
  CornerNotes none(points_, false);
  intern_block({&triangle, 1}, {&result, 1}, none);
  return result;
}

/// Works in three passes over the block: the residues of the exact rows; their inversion and
/// fingerprints; row and search for each triangle. A row whose residues are all zero gets the
/// fingerprint of its primitive row. It is computed in the last pass, because only triangles that
/// define a plane need it.
void PlaneTable::intern_block(std::span<const std::array<InputPointId, 3>> triangles,
                              std::span<OrientedPlane> result, CornerNotes& notes) {
  std::array<ResidueRow, kBlock> rows;
  std::array<Residue, kBlock> inverses, scratch;
  const std::size_t count = triangles.size();
  for (std::size_t i = 0; i < count; ++i) {
    const auto& [p, q, r] = triangles[i];
    const auto [n, d] =
        plane_residues(notes.residues_of(p), notes.residues_of(q), notes.residues_of(r));
    rows[i] = {n[0], n[1], n[2], d};
    inverses[i] = leading(rows[i]);
  }
  invert_all(std::span(inverses).first(count), std::span(scratch).first(count));
  // The value is 0 as long as the fingerprint is not known.
  std::array<Fingerprint, kBlock> fingerprints;
  for (std::size_t i = 0; i < count; ++i) {
    fingerprints[i] = inverses[i].is_zero() ? 0 : plumb::fingerprint(rows[i], inverses[i]);
  }
  index_->look_ahead(std::span(fingerprints).first(count));
  for (std::size_t i = 0; i < count; ++i) {
    const auto& [p, q, r] = triangles[i];
    const Draft plane = draft({{p.value(), q.value(), r.value()}});
    result[i] = OrientedPlane{};
    if (!plane.is_plane) continue;
    const Fingerprint f = inverses[i].is_zero()
                              ? plumb::fingerprint(integer_row(*this, plane.source))
                              : fingerprints[i];
    result[i] = find_or_add(plane, f, &notes);
  }
}

// --- planes from coefficients --------------------------------------------------------------------

namespace {

/// Removes powers of two from the coefficients n, d 2^scale: the common one of the normal, and all
/// those of d, which is then odd or zero. Requires a normal other than zero.
void strip(IntegerRow& row, int& scale) {
  int low = INT_MAX;
  for (std::size_t i = 0; i < 3; ++i) {
    if (!row[i].is_zero()) low = std::min(low, trailing_zeros(row[i]));
  }
  for (std::size_t i = 0; i < 3; ++i) row[i] >>= static_cast<unsigned>(low);
  const int offset_low = row[3].is_zero() ? 0 : trailing_zeros(row[3]);
  row[3] >>= static_cast<unsigned>(offset_low);
  scale += offset_low - low;
}

BigPlane big_plane(const IntegerRow& row, int scale) {
  return {{row[0], row[1], row[2]}, row[3], row[3].is_zero() ? kAnyScale : scale};
}

Fingerprint fingerprint_of(const IntegerRow& row, int scale) {
  const ResidueRow residues = {Residue::of(row[0]), Residue::of(row[1]), Residue::of(row[2]),
                               Residue::of(row[3]) * Residue::power_of_two(scale)};
  return leading(residues).is_zero() ? fingerprint(integer_row(big_plane(row, scale)))
                                     : fingerprint(residues);
}

}  // namespace

/// Stores coefficients in the limb pool, each with a bit for the sign.
PlaneSource PlaneTable::push_slot(const IntegerRow& row, int scale,
                                  std::array<PlaneId, 2> parents) {
  const int normal_bits = std::max({bit_length(row[0]), bit_length(row[1]), bit_length(row[2])});
  const int offset_bits = bit_length(row[3]);
  const int limbs = std::max(normal_bits, offset_bits) / 64 + 1;
  const auto slot = static_cast<std::uint32_t>(slots_.size());
  slots_.push_back(
      {limbs_.size(), static_cast<std::uint32_t>(limbs), scale, normal_bits, offset_bits, parents});
  for (const Integer& x : row) append_limbs(x, static_cast<std::size_t>(limbs), limbs_);
  return {{PlaneSource::kExplicit, slot, 0}};
}

/// Undoes the last push_slot().
void PlaneTable::pop_slot() {
  limbs_.resize(slots_.back().first);
  slots_.pop_back();
}

/// The slot is stored first, because the comparison with known planes reads it. It is removed again
/// if the plane is known.
OrientedPlane PlaneTable::intern_row(IntegerRow row, int scale, std::array<PlaneId, 2> parents) {
  const auto leading =
      std::find_if(row.begin(), row.begin() + 3, [](const Integer& x) { return !x.is_zero(); });
  if (leading == row.begin() + 3) return {};
  const bool is_flipped = leading->sign() < 0;
  strip(row, scale);
  if (is_flipped) {
    for (Integer& x : row) mpz_neg(x.mpz(), x.mpz());
  }
  const Fingerprint fingerprint = fingerprint_of(row, scale);
  const PlaneSource source = push_slot(row, scale, parents);
  const int offset_scale = row[3].is_zero() ? kAnyScale : scale;
  const BigPlane plane{
      {std::move(row[0]), std::move(row[1]), std::move(row[2])}, std::move(row[3]), offset_scale};
  const Draft draft{true, is_flipped, exact_row(plane), source};
  const std::size_t planes = size();
  const OrientedPlane result = find_or_add(draft, fingerprint);
  if (size() == planes) pop_slot();  // The plane was known before.
  return result;
}

/// The normal is computed on the common grid of its components. The offset has its own scale.
OrientedPlane PlaneTable::intern(double a, double b, double c, double d) {
  const Grid normal = {a, b, c};
  const Decomposed offset = decompose(d);
  return intern_row({to_integer(a, normal.low()), to_integer(b, normal.low()),
                     to_integer(c, normal.low()), Integer(offset.mantissa)},
                    offset.exponent - normal.low(), {});
}

OrientedPlane PlaneTable::intern(const Rational& a, const Rational& b, const Rational& c,
                                 const Rational& d) {
  if (a.is_whole() && b.is_whole() && c.is_whole() && d.is_whole()) {
    return intern_row({numerator(a), numerator(b), numerator(c), numerator(d)}, 0, {});
  }
  const Integer common =
      lcm(lcm(denominator(a), denominator(b)), lcm(denominator(c), denominator(d)));
  const auto whole = [&](const Rational& x) {
    return Integer(numerator(x) * (common / denominator(x)));
  };
  return intern_row({whole(a), whole(b), whole(c), whole(d)}, 0, {});
}

namespace {

using exact3::LongPlane;
using LongNumber = LongPlane::Number;

/// Returns the number of limbs that hold x in two's complement, at least 1.
int used_limbs(const LongNumber& x) {
  const std::uint64_t fill = x.is_negative() ? ~std::uint64_t{0} : 0;
  int count = LongNumber::kLimbs;
  while (count > 1 && x.limb(count - 1) == fill) --count;
  const bool has_sign = (x.limb(count - 1) >> 63) == (fill & 1);
  return has_sign ? count : count + 1;
}

/// Returns the residue of x. As 2^64 = 2^3 modulo q, the limbs are digits of a number to base 8. In
/// two's complement, the highest one counts negative for a negative number.
Residue residue_of(const LongNumber& x) {
  constexpr Residue kBase = Residue::power_of_two(3);
  const int count = used_limbs(x);
  Residue sum = x.is_negative() ? -Residue::of(std::uint64_t{1}) : Residue();
  for (int i = count; i-- > 0;) sum = sum * kBase + Residue::of(x.limb(i));
  return sum;
}

/// Returns x / 2^by. Requires a multiple of 2^by.
LongNumber shifted_down(const LongNumber& x, int by) {
  constexpr int kLimbs = LongNumber::kLimbs;
  if (by == 0) return x;
  const std::uint64_t fill = x.is_negative() ? ~std::uint64_t{0} : 0;
  const int limbs = by / 64, bits = by % 64;
  const auto limb = [&](int i) { return i < kLimbs ? x.limb(i) : fill; };
  std::array<std::uint64_t, kLimbs> result;
  for (int i = 0; i < kLimbs; ++i) {
    const std::uint64_t low = limb(i + limbs), high = limb(i + limbs + 1);
    result[static_cast<std::size_t>(i)] = bits == 0 ? low : (low >> bits) | (high << (64 - bits));
  }
  return LongNumber::from_limbs(result.data());
}

/// Takes powers of two out of the coefficients, as strip() of an IntegerRow does. Requires a normal
/// other than zero.
void strip(LongPlane& plane) {
  int low = INT_MAX;
  for (const LongNumber& x : plane.n) {
    if (!x.is_zero()) low = std::min(low, trailing_zeros(x));
  }
  for (LongNumber& x : plane.n) x = shifted_down(x, low);
  if (plane.d.is_zero()) return;
  const int offset_low = trailing_zeros(plane.d);
  plane.d = shifted_down(plane.d, offset_low);
  plane.scale += offset_low - low;
}

Integer integer_of(const LongNumber& x) {
  std::array<std::uint64_t, LongNumber::kLimbs> limbs;
  for (std::size_t i = 0; i < limbs.size(); ++i) limbs[i] = x.limb(static_cast<int>(i));
  return integer_from_limbs(limbs.data(), limbs.size());
}

}  // namespace

/// Stores the coefficients of a plane that has no parents.
PlaneSource PlaneTable::push_slot(const LongPlane& plane) {
  const int normal_bits =
      std::max({bit_length(plane.n[0]), bit_length(plane.n[1]), bit_length(plane.n[2])});
  const int offset_bits = bit_length(plane.d);
  const int limbs = std::max(normal_bits, offset_bits) / 64 + 1;
  const auto slot = static_cast<std::uint32_t>(slots_.size());
  slots_.push_back({limbs_.size(),
                    static_cast<std::uint32_t>(limbs),
                    plane.d.is_zero() ? 0 : plane.scale,
                    normal_bits,
                    offset_bits,
                    {}});
  for (const LongNumber* x : {&plane.n[0], &plane.n[1], &plane.n[2], &plane.d}) {
    for (int i = 0; i < limbs; ++i) limbs_.push_back(x->limb(i));
  }
  return {{PlaneSource::kExplicit, slot, 0}};
}

/// Interns one plane, whose normal is not zero, by its fingerprint.
OrientedPlane PlaneTable::intern_coefficients(const LongPlane& plane, Fingerprint fingerprint) {
  LongPlane own = plane;
  strip(own);
  const bool is_flipped = orientation(own) == Sign::Negative;
  if (is_flipped) negate(own);
  const std::size_t planes = size();
  const Draft draft{true, is_flipped, exact_row(own), push_slot(own)};
  const OrientedPlane result = find_or_add(draft, fingerprint);
  if (size() == planes) pop_slot();  // The plane was known already.
  return result;
}

/// Works in two passes over each block, as intern_block() does.
void PlaneTable::intern_coefficients(std::span<const LongPlane> planes,
                                     std::span<OrientedPlane> result) {
  make_room(planes.size());
  for (std::size_t first = 0; first < planes.size(); first += kBlock) {
    const std::size_t count = std::min(kBlock, planes.size() - first);
    std::array<ResidueRow, kBlock> rows;
    std::array<Residue, kBlock> inverses, scratch;
    for (std::size_t i = 0; i < count; ++i) {
      const LongPlane& plane = planes[first + i];
      rows[i] = {
          residue_of(plane.n[0]), residue_of(plane.n[1]), residue_of(plane.n[2]),
          plane.d.is_zero() ? Residue() : residue_of(plane.d) * Residue::power_of_two(plane.scale)};
      inverses[i] = leading(rows[i]);
    }
    invert_all(std::span(inverses).first(count), std::span(scratch).first(count));
    std::array<Fingerprint, kBlock> fingerprints;
    for (std::size_t i = 0; i < count; ++i) {
      fingerprints[i] = plumb::fingerprint(rows[i], inverses[i]);
    }
    index_->look_ahead(std::span(fingerprints).first(count));
    for (std::size_t i = 0; i < count; ++i) {
      const LongPlane& plane = planes[first + i];
      if (inverses[i].is_zero() || orientation(plane) == Sign::Zero) {
        result[first + i] = intern_row({integer_of(plane.n[0]), integer_of(plane.n[1]),
                                        integer_of(plane.n[2]), integer_of(plane.d)},
                                       plane.d.is_zero() ? 0 : plane.scale, {});
      } else {
        result[first + i] = intern_coefficients(plane, fingerprints[i]);
      }
    }
  }
}

// --- the frame -----------------------------------------------------------------------------------

/// The rows are exact: a unit vector and the offset +-1 in units of R. Their offset error is set to
/// infinity nevertheless, so that no filter uses the offset as a number. far_row() sets the error
/// to 0 if offsets are multiples of R.
std::array<PlaneId, 6> PlaneTable::intern_frame() {
  for (std::size_t i = 0; i < frame_.size(); ++i) {
    if (frame_[i].is_valid()) continue;
    const bool is_above = i % 2 != 0;  // The plane x - R = 0, or else x + R = 0.
    IntegerRow row = {0, 0, 0, is_above ? -1 : 1};
    ResidueRow residues{};
    residues[3] = is_above ? -kFrameResidue : kFrameResidue;
    PlaneRow doubles{{},
                     is_above ? -1.0 : 1.0,
                     rounded_up(2 * kUnitError),
                     std::numeric_limits<float>::infinity()};
    row[i / 2] = 1;
    residues[i / 2] = Residue::of(std::uint64_t{1});
    doubles.n[i / 2] = 1;
    PlaneSource source = push_slot(row, 0, {});
    source.code[2] = static_cast<std::uint32_t>(i) + 1;
    find_or_add({true, false, doubles, source}, plumb::fingerprint(residues));
  }
  return frame_;
}

// --- walls ---------------------------------------------------------------------------------------

/// The row is a combination of the two rows. If the plane is far, that is, if its offset is a
/// multiple of R, the row is made primitive, because its fingerprint has R only in the offset.
OrientedPlane PlaneTable::intern(const Pencil& wall) {
  const IntegerRow p = coefficients(wall.first), q = coefficients(wall.second);
  IntegerRow row;
  for (std::size_t i = 0; i < 4; ++i) row[i] = wall.c_second * p[i] - wall.c_first * q[i];
  if (!is_frame(wall.first) && !is_frame(wall.second)) {
    return intern_row(std::move(row), 0, {wall.first, wall.second});
  }
  // The offset is a multiple of R. The plane may be a plane of the cube. The planes of the cube
  // must be added first, because they have their own kind of source.
  intern_frame();
  const Sign sign = orientation(big_plane(row, 0));
  if (sign == Sign::Zero) return {};
  row = plumb::primitive(row);
  if (sign == Sign::Negative) {
    for (Integer& x : row) x = -x;
  }
  const ResidueRow residues = {Residue::of(row[0]), Residue::of(row[1]), Residue::of(row[2]),
                               Residue::of(row[3]) * kFrameResidue};
  Draft draft{true, sign == Sign::Negative, exact_row(big_plane(row, 0)), push_slot(row, 0, {})};
  draft.row.d = row[3].sign();
  draft.row.offset_error = std::numeric_limits<float>::infinity();
  draft.source.code[2] = static_cast<std::uint32_t>(frame_.size()) + 1;
  const std::size_t planes = size();
  const OrientedPlane result = find_or_add(draft, plumb::fingerprint(residues));
  if (size() == planes) pop_slot();  // The plane was known before.
  return result;
}

namespace {

/// Returns n.x + d w over the unit of the grid of x, or over 1 if w is 1 and that unit is larger:
/// the multiplier of a wall. Both rows of a pencil get the same factor, which is all that matters.
Integer value_at(const IntegerRow& row, const Point3& x, int w) {
  const int low = Grid{x.x, x.y, x.z}.low();
  Integer sum =
      row[0] * to_integer(x.x, low) + row[1] * to_integer(x.y, low) + row[2] * to_integer(x.z, low);
  if (w == 0) return sum;
  return shifted(sum, std::max(low, 0)) + shifted(row[3], std::max(-low, 0));
}

/// The combination c_second first - c_first second vanishes at x (w = 1), or along x (w = 0).
Pencil wall(const PlaneTable& planes, PlaneId first, PlaneId second, const Point3& x, int w) {
  return {first, second, value_at(planes.coefficients(first), x, w),
          value_at(planes.coefficients(second), x, w)};
}

}  // namespace

Pencil wall_along(const PlaneTable& planes, PlaneId first, PlaneId second,
                  const Point3& direction) {
  return wall(planes, first, second, direction, 0);
}

Pencil wall_through(const PlaneTable& planes, PlaneId first, PlaneId second, const Point3& x) {
  return wall(planes, first, second, x, 1);
}

std::optional<std::array<PlaneId, 2>> PlaneTable::parents(PlaneId wall) const {
  const PlaneSource& s = source(wall);
  if (!s.is_explicit() || !slot(s).parents[0].is_valid()) return {};
  return slot(s).parents;
}

bool PlaneTable::is_wall_of(PlaneId wall, std::span<const PlaneId> planes) const {
  const auto pair = parents(wall);
  const auto is_known = [&](PlaneId p) {
    return std::find(planes.begin(), planes.end(), p) != planes.end();
  };
  return pair && is_known((*pair)[0]) && is_known((*pair)[1]);
}

// --- output and merging --------------------------------------------------------------------------

IntegerRow PlaneTable::coefficients(PlaneId p) const { return integer_row(*this, source(p)); }

IntegerRow PlaneTable::primitive(PlaneId p) const { return plumb::primitive(coefficients(p)); }

/// Copies a slot of another table. Parents are renamed by `map`, and lost unless both have an id.
PlaneSource PlaneTable::copy_slot(const PlaneTable& other, const PlaneSource& source,
                                  std::span<const PlaneId> map) {
  const PlaneSlot& slot = other.slot(source);
  const auto index = static_cast<std::uint32_t>(slots_.size());
  slots_.push_back(slot);
  slots_.back().first = limbs_.size();
  auto& parents = slots_.back().parents;
  if (parents[0].is_valid()) parents = {map[parents[0].value()], map[parents[1].value()]};
  if (!parents[0].is_valid() || !parents[1].is_valid()) parents = {};
  const std::uint64_t* from = other.limbs(slot);
  limbs_.insert(limbs_.end(), from, from + std::size_t{4} * slot.limbs);
  return {{PlaneSource::kExplicit, index, source.code[2]}};
}

/// The planes are all different and come in the order of their new ids, so find_or_add() gives each
/// of them its new id.
PlaneTable::PlaneTable(const PlaneTable& other, std::span<const PlaneId> plane_map,
                       std::span<const InputPointId> point_map)
    : PlaneTable() {
  for (std::size_t i = 0; i < point_map.size(); ++i) {
    if (!point_map[i].is_valid()) continue;
    points_.push_back(other.points_[i]);
    grids_.push_back(other.grids_[i]);
  }
  reserve(static_cast<std::size_t>(
      std::count_if(plane_map.begin(), plane_map.end(), [](PlaneId p) { return p.is_valid(); })));
  for (std::size_t i = 0; i < plane_map.size(); ++i) {
    if (!plane_map[i].is_valid()) continue;
    PlaneSource source = other.sources_[i];
    if (source.is_explicit()) {
      source = copy_slot(other, source, plane_map);
    } else {
      for (std::uint32_t& p : source.code) p = point_map[p].value();
    }
    find_or_add({true, false, other.rows_[i], source}, other.fingerprints_[i]);
  }
}

std::vector<PlaneId> PlaneTable::merge(const PlaneTable& other) {
  const auto shift = add_points(other.points()).value();
  make_room(other.size());
  std::vector<PlaneId> map;
  map.reserve(other.size());
  const std::span ahead(other.fingerprints_);
  for (std::size_t i = 0; i < other.size(); ++i) {
    if (i % kBlock == 0) {
      index_->look_ahead(ahead.subspan(i, std::min(kBlock, other.size() - i)));
    }
    PlaneSource source = other.sources_[i];
    if (source.is_explicit()) {
      source = copy_slot(other, source, map);
    } else {
      for (std::uint32_t& p : source.code) p += shift;
    }
    const Draft draft{true, false, other.rows_[i], source};
    const std::size_t planes = size();
    map.push_back(find_or_add(draft, other.fingerprints_[i]).plane());
    if (source.is_explicit() && size() == planes) pop_slot();
  }
  return map;
}

}  // namespace plumb
