// The members of Nef3 that copy, query and transform a set, and the Booleans of sets.
//
// Unary operators change marks and bring the complex into minimal form. Booleans first look for
// cases that need no geometry: an operand that is empty or whole, operands that are identical, and
// bounded operands that boxes prove apart; then operands get frames if one of them has one, are
// combined (boolean/boolean_op.h), and the result loses a frame that nothing reaches and tables
// that are mostly unused.
//
// Invariants of a State: the complex is minimal, has a frame if and only if a facet or edge of the
// set reaches infinity, and changes only while one set alone holds it. A use count of 1 is read
// relaxed, so an acquire fence comes before memory is reused that other threads may have read.
//
// Unions and intersections of many sets are computed in a balanced tree of neighbours (halve()),
// its halves in parallel. All orders give the same set; the order decides how large intermediate
// sets are.
//
// Tested by tests/space/nef3_test.cpp, tests/space/nef3_property_test.cpp and
// tests/space/threads_test.cpp.

#include "plumb/space/nef3.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <optional>
#include <utility>

#include "plumb/base/internal/parallel.h"
#include "plumb/base/internal/work_log.h"
#include "plumb/predicates/error.h"
#include "plumb/space/boolean/boolean_op.h"
#include "plumb/space/boolean/frame.h"
#include "plumb/space/boolean/simplify.h"
#include "plumb/space/complex/tidy_tables.h"
#include "plumb/space/local_maps.h"
#include "plumb/space/query/space_convexity.h"
#include "plumb/space/query/volumes.h"
#include "plumb/space/set/compare_complexes.h"
#include "plumb/space/set/nef3_state.h"
#include "plumb/space/set/source_carrier.h"
#include "plumb/space/set/transform.h"
#include "plumb/space/space_measure.h"
#include "plumb/space/valid_mesh.h"

namespace plumb {
namespace {

/// Returns the complex of all of space with one mark.
SpaceComplex without_boundary(Mark mark) {
  SpaceComplex complex;
  complex.tables = std::make_shared<SpaceTables>();
  complex.star_begin = complex.cycle_begin = complex.inner_begin = {0};
  complex.volume_mark = {mark};
  return complex;
}

/// Sets all marks except those of the frame.
void fill(std::vector<Mark>& marks, Mark value) {
  for (Mark& m : marks) {
    if (m != kBeyond) m = value;
  }
}

/// Sets the marks of all vertices, edges and facets that are not on the frame.
void fill_boundary(SpaceComplex& complex, Mark value) {
  fill(complex.vertex_mark, value);
  fill(complex.edge_mark, value);
  fill(complex.facet_mark, value);
}

/// Returns the complex with a frame.
SpaceComplex framed(SpaceComplex complex, Context& context) {
  return has_frame(complex) ? std::move(complex)
                            : with_frame(complex, copy(*complex.tables), context);
}

/// Returns f(a, b) for any two operands. The result has a frame only if it needs one.
SpaceComplex combine_any(SpaceComplex a, SpaceComplex b, MarkFunction f, Context& context) {
  if (has_frame(a) != has_frame(b)) {
    a = framed(std::move(a), context);
    b = framed(std::move(b), context);
  }
  SpaceComplex result = boolean_op(std::move(a), std::move(b), f, context);
  const WorkPhase phase("tidy tables");
  return with_tidy_tables(without_idle_frame(std::move(result), context));
}

/// Returns the set in which only cells that the selector accepts are marked.
SpaceComplex selected(SpaceComplex complex, const SpaceSelector& select, Context& context) {
  const auto clear = [](auto id, const auto& accepts, std::vector<Mark>& marks) {
    using Id = decltype(id);
    for (std::size_t i = 0; accepts && i < marks.size(); ++i) {
      if (marks[i] == 1 && !accepts(Id(i))) marks[i] = 0;
    }
  };
  clear(VertexId(), select.vertex, complex.vertex_mark);
  clear(EdgeId(), select.edge, complex.edge_mark);
  clear(FacetId(), select.facet, complex.facet_mark);
  clear(VolumeId(), select.volume, complex.volume_mark);
  return without_idle_frame(simplified(std::move(complex), context), context);
}

/// Returns the number of cells that are not on the frame.
std::size_t standard_count(const std::vector<Mark>& marks) {
  return static_cast<std::size_t>(
      std::count_if(marks.begin(), marks.end(), [](Mark m) { return m != kBeyond; }));
}

}  // namespace

// ---------------------------------------------------------------- holding

Nef3::Nef3() : Nef3(without_boundary(0)) {}

Nef3::Nef3(SpaceComplex minimal) : state_(std::make_shared<State>(std::move(minimal))) {}

Nef3 Nef3::whole() { return Nef3(without_boundary(1)); }

Nef3 Nef3::from_complex(SpaceComplex complex, Context& context) {
  MemoryCharge memory(context);
  memory.add(memory_bytes(complex), "a set of space");
  return Nef3(
      with_tidy_tables(without_idle_frame(simplified(std::move(complex), context), context)));
}

const SpaceComplex& Nef3::complex() const& { return state_->complex; }

SpaceComplex Nef3::complex() && {
  const std::shared_ptr<State> state = std::move(state_);
  if (state.use_count() > 1) return state->complex;
  // Other threads may have read the complex before.
  std::atomic_thread_fence(std::memory_order_acquire);
  return std::move(state->complex);
}

SpaceMarks Nef3::marks() const {
  const SpaceComplex& c = complex();
  return {c.vertex_mark, c.edge_mark, c.facet_mark, c.volume_mark};
}

Nef3 Nef3::with_marks(const SpaceMarks& marks, Context& context) const {
  SpaceComplex changed = complex();
  const auto set = [](std::vector<Mark>& to, const std::vector<Mark>& from) {
    if (to.size() != from.size()) {
      throw Error(ErrorCode::BadArgument,
                  "one mark is needed for each vertex, edge, facet, volume");
    }
    for (std::size_t i = 0; i < to.size(); ++i) {
      if (to[i] != kBeyond) to[i] = from[i] != 0 ? 1 : 0;
    }
  };
  set(changed.vertex_mark, marks.vertex);
  set(changed.edge_mark, marks.edge);
  set(changed.facet_mark, marks.facet);
  set(changed.volume_mark, marks.volume);
  return SourceCarrier::put(sources_, from_complex(std::move(changed), context));
}

Nef3 Nef3::with_origins(std::span<const std::uint32_t> facet_origin) const {
  SpaceComplex changed = complex();
  if (facet_origin.size() != changed.facet_count()) {
    throw Error(ErrorCode::BadArgument, "one origin is needed for each facet");
  }
  changed.facet_origin.assign(facet_origin.begin(), facet_origin.end());
  return SourceCarrier::put(sources_, Nef3(std::move(changed)));
}

Nef3 Nef3::with_bounded_volumes(Context& context) const {
  SpaceComplex c = complex();
  const std::vector<std::uint8_t> is_far = unbounded_volumes(c);
  for (std::size_t v = 0; v < c.volume_count(); ++v) {
    if (is_far[v] == 0) c.volume_mark[v] = 1;
  }
  return SourceCarrier::put(sources_, from_complex(std::move(c), context));
}

// ---------------------------------------------------------------- reading

SpaceCounts Nef3::counts() const {
  const SpaceComplex& c = complex();
  SpaceCounts counts;
  counts.vertices = standard_count(c.vertex_mark);
  counts.edges = standard_count(c.edge_mark);
  counts.facets = standard_count(c.facet_mark);
  counts.volumes = standard_count(c.volume_mark);
  counts.marked_volumes =
      static_cast<std::size_t>(std::count(c.volume_mark.begin(), c.volume_mark.end(), 1));
  return counts;
}

std::size_t Nef3::bytes() const { return memory_bytes(complex()); }

bool Nef3::is_empty() const {
  return complex().vertex_count() == 0 && complex().volume_mark[0] == 0;
}

bool Nef3::is_whole() const {
  return complex().vertex_count() == 0 && complex().volume_mark[0] == 1;
}

// Marked volumes must be bounded; marked facets and edges must not reach the frame.
bool Nef3::is_bounded() const {
  const SpaceComplex& c = complex();
  const std::vector<std::uint8_t> is_far = unbounded_volumes(c);
  for (std::size_t v = 0; v < c.volume_count(); ++v) {
    if (is_far[v] != 0 && c.volume_mark[v] == 1) return false;
  }
  for (std::size_t u = 0; u < c.use_count(); ++u) {
    // A marked facet or edge that reaches the frame is unbounded, too.
    const bool is_framed = c.edge_mark[c.use_halfedge[u].value() / 2] == kBeyond;
    if (is_framed && c.facet_mark[c.use_facet[u]] == 1) return false;
  }
  for (std::size_t h = 0; h < c.origin.size(); ++h) {
    if (c.edge_mark[h / 2] == 1 && c.vertex_mark[c.origin[h]] == kBeyond) return false;
  }
  return true;
}

// In a minimal complex, a vertex, edge or facet that is not marked is a limit of points of the set.
// Otherwise, no cell around it would be marked either, and it would be superfluous.
bool Nef3::is_closed() const {
  const SpaceComplex& c = complex();
  const auto has_open = [](const std::vector<Mark>& marks) {
    return std::find(marks.begin(), marks.end(), 0) != marks.end();
  };
  return !has_open(c.vertex_mark) && !has_open(c.edge_mark) && !has_open(c.facet_mark);
}

bool Nef3::is_open() const {
  const SpaceComplex& c = complex();
  const auto has_closed = [](const std::vector<Mark>& marks) {
    return std::find(marks.begin(), marks.end(), 1) != marks.end();
  };
  return !has_closed(c.vertex_mark) && !has_closed(c.edge_mark) && !has_closed(c.facet_mark);
}

namespace {

/// Whether the edge of a half-edge has two uses.
bool has_two_facets(const SpaceComplex& c, HalfedgeId h) {
  const UseId first = c.edge_use[h.value() / 2];
  if (!first.is_valid()) return false;
  const UseId second = c.use_radial[first];
  return second != first && c.use_radial[second] == first;
}

/// Whether the corners around a vertex make one cycle, that is, whether there are as many arcs as
/// points, and therefore two faces. Requires edges with two uses.
bool is_on_one_cone(const SpaceComplex& c, VertexId v, LocalMap& local) {
  if (c.vertex_facet[v].is_valid() || c.star_of(v).empty()) return false;
  local_map(c, v, local);
  return local.map.face_count() == 2;
}

}  // namespace

// In a 2-manifold, facets separate the set from its complement, each edge has two facets, and each
// vertex has one cone.
bool Nef3::is_simple() const {
  const SpaceComplex& c = complex();
  for (std::size_t f = 0; f < c.facet_count(); ++f) {
    const auto& [above, below] = c.facet_volume[f];
    if (c.volume_mark[above] == c.volume_mark[below]) return false;
  }
  for (std::size_t e = 0; e < c.edge_count(); ++e) {
    if (c.edge_mark[e] != kBeyond && !has_two_facets(c, HalfedgeId(2 * e))) return false;
  }
  LocalMap local;
  for (std::size_t v = 0; v < c.vertex_count(); ++v) {
    if (c.vertex_mark[v] != kBeyond && !is_on_one_cone(c, VertexId(v), local)) return false;
  }
  return true;
}

bool Nef3::is_convex() const { return plumb::is_convex(complex()); }

bool Nef3::is_subset_of(const Nef3& other, Context& context) const {
  return boolean_op(*this, other, kDifference, context).is_empty();
}

std::optional<Rational> Nef3::volume(Context& context) const {
  return marked_volume(complex(), context);
}

std::optional<SpaceFlaw> Nef3::audit(Context& context) const {
  return plumb::audit(complex(), AuditForm::Minimal, context);
}

TriangleMesh Nef3::to_mesh(Context& context) const {
  MeshOfComplex made =
      valid_mesh(*this, {.faces = MeshFaces::Triangles}, CoordinateType::Double, context).made;
  if (made.report.is_unbounded) {
    throw Error(ErrorCode::BadArgument, "an unbounded set has no mesh");
  }
  const std::span<const double> xyz = coordinates_of(made.mesh);
  return {{xyz.begin(), xyz.end()}, std::move(made.mesh.corners)};
}

MeshOfComplex Nef3::to_polygons(const ToMeshOptions& options, Context& context) const {
  if (options.keeps_exact) return mesh_of_complex(complex(), options, context);
  return valid_mesh(*this, options, CoordinateType::Double, context).made;
}

// ---------------------------------------------------------------- operations

// Exchanging the marks 0 and 1 keeps a minimal complex minimal.
Nef3 Nef3::complement(Context& context) const {
  context.checkpoint("complement", 0, 0);
  SpaceComplex c = complex();
  for (std::vector<Mark>* marks : std::initializer_list<std::vector<Mark>*>{
           &c.vertex_mark, &c.edge_mark, &c.facet_mark, &c.volume_mark}) {
    for (Mark& m : *marks) m = m == kBeyond ? m : static_cast<Mark>(1 - m);
  }
  return SourceCarrier::put(sources_, Nef3(std::move(c)));
}

Nef3 Nef3::interior(Context& context) const {
  SpaceComplex c = complex();
  fill_boundary(c, 0);
  return SourceCarrier::put(sources_, from_complex(std::move(c), context));
}

Nef3 Nef3::closure(Context& context) const {
  SpaceComplex c = complex();
  fill_boundary(c, 1);
  return SourceCarrier::put(sources_, from_complex(std::move(c), context));
}

// In a minimal complex all vertices, edges and facets are boundary points.
Nef3 Nef3::boundary(Context& context) const {
  SpaceComplex c = complex();
  fill_boundary(c, 1);
  fill(c.volume_mark, 0);
  return SourceCarrier::put(sources_, from_complex(std::move(c), context));
}

Nef3 Nef3::exterior(Context& context) const { return complement(context).interior(context); }

Nef3 Nef3::regularization(Context& context) const { return interior(context).closure(context); }

Nef3 Nef3::transformed(const AffineMap3& map, Context& context) const {
  return SourceCarrier::put(SourceCarrier::mapped(sources_, map),
                            Nef3(plumb::transformed(complex(), map, context)));
}

Nef3 Nef3::translated(const RationalPoint3& by, Context& context) const {
  const Rational zero = 0, one = 1;
  return transformed({.matrix = {{{one, zero, zero}, {zero, one, zero}, {zero, zero, one}}},
                      .offset = {by.x, by.y, by.z}},
                     context);
}

namespace {

/// Returns the set with the given marks for the points outside and inside: the set itself, its
/// complement, the empty set or the whole space.
Nef3 with_marks(Nef3 set, bool of_outside, bool of_inside) {
  if (of_outside == of_inside) return of_inside ? Nef3::whole() : Nef3::empty();
  return of_inside ? std::move(set) : !set;
}

/// Returns f(a, b) if each mark of one operand occurs with only one mark of the other operand. This
/// is the case if one operand is empty or the whole space, or if they are the same set. Otherwise,
/// returns nothing.
std::optional<Nef3> combine_marks(const Nef3& a, const Nef3& b, MarkFunction f) {
  const bool in_a = a.is_whole(), in_b = b.is_whole();
  if (in_b || b.is_empty()) return with_marks(a, f(false, in_b), f(true, in_b));
  if (in_a || a.is_empty()) return with_marks(b, f(in_a, false), f(in_a, true));
  if (!is_identical(a.complex(), b.complex())) return {};
  return with_marks(a, f(false, false), f(true, true));
}

}  // namespace

/// Returns f(a, b) for bounded boundaries that are apart. Each lies completely in volume 0 of the
/// other, so the marks of each operand change independently. Returns nothing if boxes do not prove
/// that the boundaries are apart.
std::optional<Nef3> Nef3::combined_apart(Nef3& a, Nef3& b, MarkFunction f) {
  if (has_frame(a.complex()) || has_frame(b.complex())) return {};
  std::vector<Box3> parts = a.state_->boxes();
  const std::vector<Box3> others = b.state_->boxes();
  if (!are_apart({a.complex(), parts}, {b.complex(), others})) return {};
  // The set a lies completely in volume 0 of b, and conversely. Therefore the marks of each change
  // by a separate function: f with the mark of volume 0 of the other set.
  const bool of_a = a.complex().volume_mark[0] != 0, of_b = b.complex().volume_mark[0] != 0;
  a = plumb::with_marks(std::move(a), f(false, of_b), f(true, of_b));
  b = plumb::with_marks(std::move(b), f(of_a, false), f(of_a, true));
  if (b.complex().vertex_count() == 0) return a;
  if (a.complex().vertex_count() == 0) return b;
  // The boxes of both sets are kept, so that later sets can be proved apart from each part.
  parts.insert(parts.end(), others.begin(), others.end());
  Nef3 both;
  both.state_ = std::make_shared<State>(
      with_tidy_tables(appended(std::move(a).complex(), std::move(b).complex())), std::move(parts));
  return both;
}

Nef3 boolean_op(Nef3 a, Nef3 b, MarkFunction f, Context& context) {
  const WorkPhase phase("Boolean");
  SourceCarrier::List sources = SourceCarrier::joined(a.sources_, b.sources_);
  if (std::optional<Nef3> known = combine_marks(a, b, f)) {
    return SourceCarrier::put(std::move(sources), std::move(*known));
  }
  if (std::optional<Nef3> both = Nef3::combined_apart(a, b, f)) {
    return SourceCarrier::put(std::move(sources), std::move(*both));
  }
  return SourceCarrier::put(std::move(sources),
                            Nef3::from_minimal_unchecked(combine_any(
                                std::move(a).complex(), std::move(b).complex(), f, context)));
}

Nef3 boolean_op(const Nef3& a, const SpaceSelector& select_a, const Nef3& b,
                const SpaceSelector& select_b, MarkFunction f, Context& context) {
  return SourceCarrier::put(SourceCarrier::joined(SourceCarrier::of(a), SourceCarrier::of(b)),
                            Nef3::from_minimal_unchecked(
                                combine_any(selected(a.complex(), select_a, context),
                                            selected(b.complex(), select_b, context), f, context)));
}

// A frame is needed only if the plane divides volume 0 into parts with different marks. Only in
// this case does a facet of the result reach infinity there.
Nef3 boolean_op(const Nef3& a, const Plane3& plane, Section section, MarkFunction f,
                Context& context) {
  const SpaceComplex& c = a.complex();
  const MarkTable table(f);
  const Mark outside = c.volume_mark[0];
  const bool needs_frame = !has_frame(c) && table(outside, 0) != table(outside, 1);
  const std::shared_ptr<SpaceTables> tables = copy(*c.tables);
  SpaceComplex first = needs_frame ? with_frame(c, tables, context) : c;
  const OrientedPlane p = tables->planes.intern(plane.a, plane.b, plane.c, plane.d);
  if (!p.is_valid()) throw Error(ErrorCode::BadArgument, "a plane needs a normal that is not zero");
  const PlaneSet h = section == Section::PlaneOnly         ? PlaneSet::Plane
                     : section == Section::ClosedHalfSpace ? PlaneSet::ClosedBelow
                                                           : PlaneSet::OpenBelow;
  SpaceComplex result = boolean_op_with_plane(std::move(first), p, h, f, tables, context);
  return SourceCarrier::put(SourceCarrier::of(a),
                            Nef3::from_minimal_unchecked(
                                with_tidy_tables(without_idle_frame(std::move(result), context))));
}

namespace {

/// A set with the data that decide when it is combined, and with which other sets.
struct PlacedSet {
  Nef3 set;
  Box3 box;            // The box around its boundary. It is infinite if nothing is known.
  std::size_t weight;  // An estimate of the work that the set causes.
};

double centre(const Box3& box, std::size_t axis) {
  const double sum = box.low[axis] + box.high[axis];
  return std::isfinite(sum) ? sum : 0;
}

std::vector<PlacedSet> placed(std::vector<Nef3> sets) {
  std::vector<PlacedSet> result;
  result.reserve(sets.size());
  for (Nef3& set : sets) {
    const SpaceComplex& c = set.complex();
    const Box3 box = c.vertex_count() == 0 ? Box3{{0, 0, 0}, {0, 0, 0}} : box_of(c);
    const std::size_t weight = c.edge_count() + 1;
    result.push_back({std::move(set), box, weight});
  }
  return result;
}

std::size_t total_weight(std::span<const PlacedSet> sets) {
  std::size_t total = 0;
  for (const PlacedSet& placed : sets) total += placed.weight;
  return total;
}

/// Returns the axis along which the centres of the sets are spread most.
std::size_t widest_axis(std::span<const PlacedSet> sets) {
  std::array<double, 3> spread{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    double low = centre(sets[0].box, axis), high = low;
    for (const PlacedSet& placed : sets) {
      low = std::min(low, centre(placed.box, axis));
      high = std::max(high, centre(placed.box, axis));
    }
    spread[axis] = high - low;
  }
  const auto widest = std::max_element(spread.begin(), spread.end());
  return static_cast<std::size_t>(widest - spread.begin());
}

/// Orders sets and returns how many of them make the first half. A set that outweighs all others
/// is a half of its own, so that it takes part in one operation only. Otherwise the halves lie side
/// by side and weigh about the same, so that sets are combined with their neighbours first: what
/// lies inside others is gone early, and halves that are apart need no Boolean.
std::size_t halve(std::span<PlacedSet> sets) {
  const std::size_t total = total_weight(sets);
  const auto is_lighter = [](const PlacedSet& a, const PlacedSet& b) {
    return a.weight < b.weight;
  };
  const auto heaviest = std::max_element(sets.begin(), sets.end(), is_lighter);
  if (2 * heaviest->weight > total) {
    std::swap(sets.front(), *heaviest);
    return 1;
  }
  const std::size_t axis = widest_axis(sets);
  std::stable_sort(sets.begin(), sets.end(), [axis](const PlacedSet& a, const PlacedSet& b) {
    return centre(a.box, axis) < centre(b.box, axis);
  });
  std::size_t count = 1;
  for (std::size_t weight = sets[0].weight; count + 1 < sets.size(); ++count) {
    if (2 * weight + sets[count].weight > total) break;
    weight += sets[count].weight;
  }
  return count;
}

/// Combines sets pairwise in a balanced tree (halve()). The sets are consumed.
Nef3 combine_all(std::span<PlacedSet> sets, MarkFunction f, Context& context) {
  if (sets.size() == 1) return std::move(sets[0].set);
  const std::size_t half = halve(sets);
  const std::array<std::span<PlacedSet>, 2> parts{sets.first(half), sets.subspan(half)};
  std::array<Nef3, 2> both;
  // The memory of each half is charged while the other half may still be computed.
  std::array<MemoryCharge, 2> memory{MemoryCharge(context), MemoryCharge(context)};
  run_jobs(context, 2, [&](std::size_t i, Context& own) {
    both[i] = combine_all(parts[i], f, own);
    if (parts[i].size() > 1) memory[i].add(both[i].bytes(), "a set of space");
  });
  return boolean_op(std::move(both[0]), std::move(both[1]), f, context);
}

/// Whether a set and its boundary lie in the box around its boundary.
bool is_in_box(const Nef3& set) {
  return set.complex().volume_mark[0] == 0 && !has_frame(set.complex());
}

/// Whether the boxes of all sets have a common point.
bool have_common_point(std::span<const PlacedSet> sets) {
  Box3 common = sets[0].box;
  for (const PlacedSet& placed : sets) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      common.low[axis] = std::max(common.low[axis], placed.box.low[axis]);
      common.high[axis] = std::min(common.high[axis], placed.box.high[axis]);
      if (common.low[axis] > common.high[axis]) return false;
    }
  }
  return true;
}

}  // namespace

Nef3 operator+(const Nef3& a, const Nef3& b) { return boolean_op(a, b, kUnion); }
Nef3 operator*(const Nef3& a, const Nef3& b) { return boolean_op(a, b, kIntersection); }
Nef3 operator-(const Nef3& a, const Nef3& b) { return boolean_op(a, b, kDifference); }
Nef3 operator^(const Nef3& a, const Nef3& b) { return boolean_op(a, b, kSymmetricDifference); }

bool operator==(const Nef3& a, const Nef3& b) {
  return a.state_ == b.state_ || is_same(a.complex(), b.complex());
}

Nef3 united(std::vector<Nef3> sets, Context& context) {
  if (sets.empty()) return Nef3::empty();
  // The balanced tree takes the sets in another order; their sources keep the order of the sets.
  SourceCarrier::List sources = SourceCarrier::joined(sets);
  std::vector<PlacedSet> parts = placed(std::move(sets));
  return SourceCarrier::put(std::move(sources), combine_all(parts, kUnion, context));
}

Nef3 union_of(std::span<const Nef3> sets, Context& context) {
  return united({sets.begin(), sets.end()}, context);
}

Nef3 intersection_of(std::span<const Nef3> sets, Context& context) {
  if (sets.empty()) return Nef3::whole();
  std::vector<PlacedSet> parts = placed({sets.begin(), sets.end()});
  const bool are_in_boxes = std::all_of(sets.begin(), sets.end(), is_in_box);
  if (are_in_boxes && !have_common_point(parts)) return Nef3::empty();
  return SourceCarrier::put(SourceCarrier::joined(sets),
                            combine_all(parts, kIntersection, context));
}

Nef3 difference_of(const Nef3& a, std::span<const Nef3> others, Context& context) {
  std::vector<Nef3> near;
  if (is_in_box(a) && !a.is_empty()) {
    const Box3 box = box_of(a.complex());
    for (const Nef3& other : others) {
      const bool is_apart =
          other.is_empty() || (is_in_box(other) && !box.meets(box_of(other.complex())));
      if (!is_apart) near.push_back(other);
    }
  } else {
    near.assign(others.begin(), others.end());
  }
  return boolean_op(a, united(std::move(near), context), kDifference, context);
}

}  // namespace plumb
