// Sets of the sphere: construction from maps, operators of topology, comparison and Booleans.
//
// A set is its unique minimal map (docs/design/sphere.md, Minimal form). So two sets are equal if
// and only if their symmetric difference is empty, and operators of topology only change marks and
// simplify: the interior keeps the mark of a cell if all cells around it are marked. The closure
// marks a cell if any cell around it is marked. Booleans bring both maps over one table of planes
// and overlay them (sphere_overlay.h).
//
// Tested by tests/sphere/nef_sphere_test.cpp and tests/sphere/nef_sphere_property_test.cpp.

#include "plumb/sphere/nef_sphere.h"

#include <algorithm>
#include <atomic>
#include <utility>

#include "plumb/predicates/error.h"
#include "plumb/sphere/overlay/sphere_overlay.h"
#include "plumb/sphere/overlay/sphere_simplify.h"
#include "plumb/sphere/set/sphere_vectors.h"

namespace plumb {

namespace {

/// Returns the empty set or the whole sphere.
NefSphere one_face(Mark mark) {
  static const auto no_planes = std::make_shared<const PlaneTable>();
  SphereMap map;
  map.face_mark.assign(1, mark);
  return NefSphere::from_minimal_unchecked({no_planes, std::move(map)});
}

/// Returns the set of a map that need not be minimal.
NefSphere simplified(std::shared_ptr<const PlaneTable> planes, SphereMap map) {
  SphereMap minimal;
  const bool changed = SphereSimplifier().run(map, minimal);
  return NefSphere::from_minimal_unchecked({std::move(planes), std::move(changed ? minimal : map)});
}

void flip(std::vector<Mark>& marks) {
  for (Mark& m : marks) m = m == 0 ? 1 : 0;
}

/// Returns for each cell its mark combined with those of all cells around it.
template <class Combine>
SphereMarks neighbourhood_marks(const SphereMap& map, Combine boolean_op) {
  SphereMarks marks{map.point_mark, map.arc_mark, map.face_mark};
  for (std::size_t a = 0; a < map.arc_count(); ++a) {
    marks.arc[a] = boolean_op(marks.arc[a], boolean_op(map.face_mark[map.face[2 * a]],
                                                       map.face_mark[map.face[2 * a + 1]]));
  }
  for (std::size_t v = 0; v < map.point_count(); ++v) {
    const std::uint32_t first = map.first_out[v];
    if (first == kNone) {
      marks.point[v] = boolean_op(marks.point[v], map.face_mark[map.point_face[v]]);
      continue;
    }
    std::uint32_t h = first;
    do {  // The new marks of arcs include those of the faces beside them.
      marks.point[v] = boolean_op(marks.point[v], marks.arc[h / 2]);
      h = map.clockwise(h);
    } while (h != first);
  }
  return marks;
}

SphereMarks interior_marks(const SphereMap& map) {
  return neighbourhood_marks(map, [](Mark a, Mark b) -> Mark { return a != 0 && b != 0 ? 1 : 0; });
}
SphereMarks closure_marks(const SphereMap& map) {
  return neighbourhood_marks(map, [](Mark a, Mark b) -> Mark { return a != 0 || b != 0 ? 1 : 0; });
}

bool are_marks_of(const SphereMap& map, const SphereMarks& marks) {
  return marks.point == map.point_mark && marks.arc == map.arc_mark && marks.face == map.face_mark;
}

void take_off(std::vector<Mark>& from, const std::vector<Mark>& what) {
  for (std::size_t i = 0; i < from.size(); ++i) {
    if (what[i] != 0) from[i] = 0;
  }
}

bool is_one_face(const SphereMap& map, Mark mark) {
  return map.point_count() == 0 && map.arc_count() == 0 && map.face_mark[0] == mark;
}

}  // namespace

SphereFaceBoundary face_boundary(const SphereMap& map, std::uint32_t face) {
  SphereFaceBoundary boundary;
  std::vector<std::uint8_t> is_walked(map.next.size(), 0);
  for (std::uint32_t first = 0; first < map.next.size(); ++first) {
    if (map.face[first] != face || is_walked[first] != 0) continue;
    boundary.half_arcs.push_back(first);
    for (std::uint32_t h = first; is_walked[h] == 0; h = map.next[h]) is_walked[h] = 1;
  }
  for (std::uint32_t v = 0; v < map.point_count(); ++v) {
    if (map.point_face[v] == face) boundary.points.push_back(v);
  }
  return boundary;
}

// ---------------------------------------------------------------- construction and reading

NefSphere::NefSphere() : NefSphere(empty()) {}

NefSphere NefSphere::empty() {
  static const NefSphere none = one_face(0);
  return none;
}

NefSphere NefSphere::whole() {
  static const NefSphere all = one_face(1);
  return all;
}

NefSphere NefSphere::from_minimal_unchecked(SphereComplex complex) {
  return NefSphere(std::make_shared<SphereComplex>(std::move(complex)));
}

NefSphere NefSphere::from_complex(SphereComplex complex, Context& context) {
  context.checkpoint("audit", 0, 0);
  auto& [planes, map] = complex;
  if (const auto flaw = plumb::audit(*planes, map, AuditForm::Any)) {
    throw Error(ErrorCode::BadArgument,
                "not a map of the sphere: " + flaw->invariant + ", " + flaw->place);
  }
  map.centre_mark = 0;
  for (auto* marks : {&map.point_mark, &map.arc_mark, &map.face_mark}) {
    for (Mark& m : *marks) m = m == 1 ? 1 : 0;
  }
  std::shared_ptr<const PlaneTable> table = centred(*planes, map);
  return simplified(std::move(table), std::move(map));
}

NefSphere NefSphere::with_marks(SphereMarks marks, Context& context) const {
  context.checkpoint("simplify", 0, 0);
  if (marks.point.size() != map().point_count() || marks.arc.size() != map().arc_count() ||
      marks.face.size() != map().face_count()) {
    throw Error(ErrorCode::BadArgument, "one mark is needed for each point, arc and face");
  }
  SphereMap changed = map();
  changed.point_mark = std::move(marks.point);
  changed.arc_mark = std::move(marks.arc);
  changed.face_mark = std::move(marks.face);
  for (auto* some : {&changed.point_mark, &changed.arc_mark, &changed.face_mark}) {
    for (Mark& m : *some) m = m != 0 ? 1 : 0;
  }
  return simplified(complex().planes, std::move(changed));
}

const SphereComplex& NefSphere::complex() const& { return *complex_; }

SphereComplex NefSphere::complex() && {
  const std::shared_ptr<SphereComplex> own = std::move(complex_);
  if (own.use_count() > 1) return *own;
  // use_count() does not synchronize, so the fence orders the reads of former owners before the
  // move.
  std::atomic_thread_fence(std::memory_order_acquire);
  return std::move(*own);
}

SphereMarks NefSphere::marks() const { return {map().point_mark, map().arc_mark, map().face_mark}; }

SphereCounts NefSphere::counts() const {
  const SphereMap& m = map();
  const auto marked =
      std::count_if(m.face_mark.begin(), m.face_mark.end(), [](Mark mark) { return mark != 0; });
  return {m.point_count(), m.arc_count(), m.face_count(), static_cast<std::size_t>(marked)};
}

std::size_t NefSphere::bytes() const {
  constexpr std::size_t kBytesPerPoint = sizeof(SphereDirection) + 2 * sizeof(std::uint32_t) + 1;
  constexpr std::size_t kBytesPerArc = sizeof(PlaneId) + 8 * sizeof(std::uint32_t) + 1;
  const SphereMap& m = map();
  return kBytesPerPoint * m.point_count() + kBytesPerArc * m.arc_count() + m.face_count() +
         60 * planes().size();
}

SphereVector NefSphere::direction(std::uint32_t point) const {
  return exact_direction(planes(), map().direction[point]);
}
SphereVector NefSphere::normal(std::uint32_t arc) const {
  return exact_normal(planes(), map().circle[arc]);
}

bool NefSphere::is_empty() const { return is_one_face(map(), 0); }
bool NefSphere::is_whole() const { return is_one_face(map(), 1); }
bool NefSphere::is_closed() const { return are_marks_of(map(), closure_marks(map())); }
bool NefSphere::is_open() const { return are_marks_of(map(), interior_marks(map())); }

bool NefSphere::is_subset_of(const NefSphere& other, Context& context) const {
  return boolean_op(*this, other, kDifference, context).is_empty();
}

std::optional<DcelFlaw> NefSphere::audit(Context& context) const {
  context.checkpoint("audit", 0, 0);
  return plumb::audit(planes(), map(), AuditForm::Minimal);
}

// ---------------------------------------------------------------- operators of topology

NefSphere NefSphere::complement(Context& context) const {
  context.checkpoint("complement", 0, 0);
  SphereMap flipped = map();
  for (auto* marks : {&flipped.point_mark, &flipped.arc_mark, &flipped.face_mark}) flip(*marks);
  return from_minimal_unchecked({complex().planes, std::move(flipped)});
}

NefSphere NefSphere::interior(Context& context) const {
  return with_marks(interior_marks(map()), context);
}

NefSphere NefSphere::closure(Context& context) const {
  return with_marks(closure_marks(map()), context);
}

NefSphere NefSphere::boundary(Context& context) const {
  SphereMarks marks = closure_marks(map());
  const SphereMarks inner = interior_marks(map());
  take_off(marks.point, inner.point);
  take_off(marks.arc, inner.arc);
  take_off(marks.face, inner.face);
  return with_marks(std::move(marks), context);
}

NefSphere NefSphere::exterior(Context& context) const {
  return complement(context).interior(context);
}

NefSphere NefSphere::regularization(Context& context) const {
  return interior(context).closure(context);
}

// ---------------------------------------------------------------- comparison

bool operator==(const NefSphere& a, const NefSphere& b) {
  if (a.complex_ == b.complex_) return true;
  const SphereMap& s = a.map();
  const SphereMap& t = b.map();
  return s.point_count() == t.point_count() && s.arc_count() == t.arc_count() &&
         s.face_count() == t.face_count() && (a ^ b).is_empty();
}

// NefSphere: operations of several sets.

namespace {

/// The maps of two sets over one table of planes.
struct OneTable {
  std::shared_ptr<const PlaneTable> planes;
  SphereMap a;
  SphereMap b;
};

/// Merges the tables of planes, unless both sets share a table.
OneTable over_one_table(const NefSphere& a, const NefSphere& b) {
  const std::shared_ptr<const PlaneTable>& shared = a.complex().planes;
  if (shared == b.complex().planes) return {shared, a.map(), b.map()};
  auto planes = std::make_shared<PlaneTable>(a.planes());
  const std::vector<PlaneId> to = planes->merge(b.planes());
  OneTable one{planes, a.map(), b.map()};
  for (PlaneId& c : one.b.circle) c = to[c.value()];
  for (SphereDirection& u : one.b.direction) u = {to[u.p.value()], to[u.q.value()]};
  return one;
}

void select(const std::function<bool(std::uint32_t)>& accepts, std::vector<Mark>& marks) {
  if (!accepts) return;
  for (std::uint32_t i = 0; i < marks.size(); ++i) {
    if (marks[i] != 0 && !accepts(i)) marks[i] = 0;
  }
}

void select(const SphereSelector& selector, SphereMap& map) {
  select(selector.point, map.point_mark);
  select(selector.arc, map.arc_mark);
  select(selector.face, map.face_mark);
}

/// Returns the bytes that an overlay takes, except for the places where the maps meet. SphereLimits
/// charges these.
std::uint64_t memory_of_overlay(const SphereMap& a, const SphereMap& b) {
  const auto items = [](const SphereMap& m) { return m.point_count() + m.arc_count(); };
  return 400 * (items(a) + items(b));
}

/// Returns the set of a minimal map. If many planes are no longer used by any cell, they are
/// removed.
NefSphere with_few_planes(std::shared_ptr<const PlaneTable> planes, SphereMap map) {
  const std::size_t named = map.arc_count() + 2 * map.point_count();
  if (planes->size() > 2 * named + 64) planes = centred(*planes, map);
  return NefSphere::from_minimal_unchecked({std::move(planes), std::move(map)});
}

/// Combines the sets in a balanced tree. Requires at least one.
NefSphere fold(std::span<const NefSphere> sets, MarkFunction f, Context& context) {
  if (sets.size() == 1) return sets.front();
  const std::size_t half = sets.size() / 2;
  return boolean_op(fold(sets.first(half), f, context), fold(sets.subspan(half), f, context), f,
                    context);
}

}  // namespace

NefSphere boolean_op(const NefSphere& a, const SphereSelector& select_a, const NefSphere& b,
                     const SphereSelector& select_b, MarkFunction f, Context& context) {
  context.checkpoint("overlay", 0, 1);
  MemoryCharge memory(context);
  memory.add(memory_of_overlay(a.map(), b.map()), "an overlay of the sphere");
  OneTable one = over_one_table(a, b);
  context.checkpoint("overlay", 0, 1);
  select(select_a, one.a);
  select(select_b, one.b);
  SphereMap map;
  SphereOrigins origins;
  SphereOverlay(*one.planes).boolean_op(one.a, one.b, MarkTable(f), map, origins, &context);
  map.centre_mark = 0;
  context.checkpoint("overlay", 0, 1);
  return with_few_planes(std::move(one.planes), std::move(map));
}

NefSphere boolean_op(const NefSphere& a, const NefSphere& b, MarkFunction f, Context& context) {
  return boolean_op(a, {}, b, {}, f, context);
}

NefSphere union_of(std::span<const NefSphere> sets, Context& context) {
  return sets.empty() ? NefSphere::empty() : fold(sets, kUnion, context);
}

NefSphere intersection_of(std::span<const NefSphere> sets, Context& context) {
  return sets.empty() ? NefSphere::whole() : fold(sets, kIntersection, context);
}

NefSphere operator+(const NefSphere& a, const NefSphere& b) { return boolean_op(a, b, kUnion); }
NefSphere operator*(const NefSphere& a, const NefSphere& b) {
  return boolean_op(a, b, kIntersection);
}
NefSphere operator-(const NefSphere& a, const NefSphere& b) {
  return boolean_op(a, b, kDifference);
}
NefSphere operator^(const NefSphere& a, const NefSphere& b) {
  return boolean_op(a, b, kSymmetricDifference);
}

}  // namespace plumb
