#include "plumb/space/nef3.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <optional>
#include <utility>

#include "plumb/base/error.h"
#include "plumb/base/parallel.h"
#include "plumb/base/refused_memory.h"
#include "plumb/space/append.h"
#include "plumb/space/combine.h"
#include "plumb/space/frame.h"
#include "plumb/space/local_maps.h"
#include "plumb/space/nef3_state.h"
#include "plumb/space/same_complex.h"
#include "plumb/space/simplify.h"
#include "plumb/space/space_convexity.h"
#include "plumb/space/space_memory.h"
#include "plumb/space/tidy_tables.h"
#include "plumb/space/transform.h"
#include "plumb/space/unite.h"
#include "plumb/space/volumes.h"

namespace plumb {
namespace {

SpaceComplex without_boundary(Mark mark) {
  SpaceComplex complex;
  complex.tables = std::make_shared<SpaceTables>();
  complex.star_begin = complex.cycle_begin = complex.inner_begin = {0};
  complex.volume_mark = {mark};
  return complex;
}

/// Sets all marks but those of the frame.
void fill(std::vector<Mark>& marks, Mark value) {
  for (Mark& m : marks) {
    if (m != kBeyond) m = value;
  }
}

void fill_boundary(SpaceComplex& complex, Mark value) {
  fill(complex.vertex_mark, value);
  fill(complex.edge_mark, value);
  fill(complex.facet_mark, value);
}

SpaceComplex framed(SpaceComplex complex, Context& context) {
  return has_frame(complex) ? std::move(complex)
                            : with_frame(complex, copy(*complex.tables), context);
}

SpaceComplex combine_any(SpaceComplex a, SpaceComplex b, MarkFunction f, Context& context) {
  if (has_frame(a) != has_frame(b)) {
    a = framed(std::move(a), context);
    b = framed(std::move(b), context);
  }
  SpaceComplex result = combine(std::move(a), std::move(b), f, context);
  return with_tidy_tables(without_idle_frame(std::move(result), context));
}

/// With marks 0 where the selector does not accept.
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

std::size_t standard_count(const std::vector<Mark>& marks) {
  return static_cast<std::size_t>(
      std::count_if(marks.begin(), marks.end(), [](Mark m) { return m != kBeyond; }));
}

}  // namespace

// ---------------------------------------------------------------- holding

Nef3::Nef3() try : Nef3(without_boundary(0)) {
} catch (...) {
  rethrow_refused_memory();
}

Nef3::Nef3(SpaceComplex minimal) try : state_(std::make_shared<State>(std::move(minimal))) {
} catch (...) {
  rethrow_refused_memory();
}

Nef3 Nef3::space() try { return Nef3(without_boundary(1)); } catch (...) {
  rethrow_refused_memory();
}

Nef3 Nef3::from_complex(SpaceComplex complex, Context& context) try {
  MemoryCharge memory(context);
  memory.add(memory_bytes(complex), "a set of space");
  return Nef3(
      with_tidy_tables(without_idle_frame(simplified(std::move(complex), context), context)));
} catch (...) {
  rethrow_refused_memory();
}

const SpaceComplex& Nef3::complex() const { return state_->complex; }

SpaceComplex Nef3::taken() && try {
  const std::shared_ptr<const State> state = std::move(state_);
  if (state.use_count() > 1) return state->complex;
  std::atomic_thread_fence(std::memory_order_acquire);  // whoever shared it has read it before
  return std::move(const_cast<State&>(*state).complex);
} catch (...) {
  rethrow_refused_memory();
}

Nef3 Nef3::with_marks(const SpaceMarks& marks, Context& context) const try {
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
  return from_complex(std::move(changed), context);
} catch (...) {
  rethrow_refused_memory();
}

Nef3 Nef3::with_origins(std::span<const std::uint32_t> facet_origin) const try {
  SpaceComplex changed = complex();
  if (facet_origin.size() != changed.facet_count()) {
    throw Error(ErrorCode::BadArgument, "one origin is needed for each facet");
  }
  changed.facet_origin.assign(facet_origin.begin(), facet_origin.end());
  return Nef3(std::move(changed));
} catch (...) {
  rethrow_refused_memory();
}

Nef3 Nef3::with_bounded_volumes() const try {
  Context context;
  SpaceComplex c = complex();
  const std::vector<std::uint8_t> is_far = unbounded_volumes(c);
  for (std::size_t v = 0; v < c.volume_count(); ++v) {
    if (is_far[v] == 0) c.volume_mark[v] = 1;
  }
  return from_complex(std::move(c), context);
} catch (...) {
  rethrow_refused_memory();
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

bool Nef3::is_space() const {
  return complex().vertex_count() == 0 && complex().volume_mark[0] == 1;
}

bool Nef3::is_bounded() const try {
  const SpaceComplex& c = complex();
  const std::vector<std::uint8_t> is_far = unbounded_volumes(c);
  for (std::size_t v = 0; v < c.volume_count(); ++v) {
    if (is_far[v] != 0 && c.volume_mark[v] == 1) return false;
  }
  for (std::size_t u = 0; u < c.use_count(); ++u) {
    const bool is_framed = c.edge_mark[c.use_halfedge[u].value() / 2] == kBeyond;
    if (is_framed && c.facet_mark[c.use_facet[u].value()] == 1) return false;
  }
  for (std::size_t h = 0; h < c.origin.size(); ++h) {
    if (c.edge_mark[h / 2] == 1 && c.vertex_mark[c.origin[h].value()] == kBeyond) return false;
  }
  return true;
} catch (...) {
  rethrow_refused_memory();
}

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

/// Are all uses around the half-edge of standard facets, and two?
bool has_two_facets(const SpaceComplex& c, HalfedgeId h) {
  const UseId first = c.edge_use[h.value() / 2];
  if (!first.is_valid()) return false;
  const UseId second = c.use_radial[first.value()];
  return second != first && c.use_radial[second.value()] == first;
}

/// One cycle of corners: as many arcs as points, two faces.
bool is_on_one_cone(const SpaceComplex& c, VertexId v, LocalMap& local) {
  if (c.vertex_facet[v.value()].is_valid() || c.star_of(v).empty()) return false;
  local_map(c, v, local);
  return local.map.face_count() == 2;
}

}  // namespace

bool Nef3::is_simple() const try {
  const SpaceComplex& c = complex();
  for (std::size_t f = 0; f < c.facet_count(); ++f) {
    const auto& [above, below] = c.facet_volume[f];
    if (c.volume_mark[above.value()] == c.volume_mark[below.value()]) return false;
  }
  for (std::size_t e = 0; e < c.edge_count(); ++e) {
    if (c.edge_mark[e] != kBeyond && !has_two_facets(c, HalfedgeId(2 * e))) return false;
  }
  LocalMap local;
  for (std::size_t v = 0; v < c.vertex_count(); ++v) {
    if (c.vertex_mark[v] != kBeyond && !is_on_one_cone(c, VertexId(v), local)) return false;
  }
  return true;
} catch (...) {
  rethrow_refused_memory();
}

bool Nef3::is_convex() const try { return plumb::is_convex(complex()); } catch (...) {
  rethrow_refused_memory();
}

// ---------------------------------------------------------------- operations

Nef3 Nef3::operator!() const try {
  SpaceComplex c = complex();
  for (auto* marks : {&c.vertex_mark, &c.edge_mark, &c.facet_mark, &c.volume_mark}) {
    for (Mark& m : *marks) m = m == kBeyond ? m : static_cast<Mark>(1 - m);
  }
  return Nef3(std::move(c));
} catch (...) {
  rethrow_refused_memory();
}

Nef3 Nef3::interior() const try {
  Context context;
  SpaceComplex c = complex();
  fill_boundary(c, 0);
  return from_complex(std::move(c), context);
} catch (...) {
  rethrow_refused_memory();
}

Nef3 Nef3::closure() const try {
  Context context;
  SpaceComplex c = complex();
  fill_boundary(c, 1);
  return from_complex(std::move(c), context);
} catch (...) {
  rethrow_refused_memory();
}

Nef3 Nef3::boundary() const try {
  Context context;
  SpaceComplex c = complex();
  fill_boundary(c, 1);
  fill(c.volume_mark, 0);
  return from_complex(std::move(c), context);
} catch (...) {
  rethrow_refused_memory();
}

Nef3 Nef3::transformed(const AffineMap3& map) const try {
  Context context;
  return Nef3(plumb::transformed(complex(), map, context));
} catch (...) {
  rethrow_refused_memory();
}

namespace {

/// The operation f(m, m) or f(m, mark) of one set: itself, its complement, or nothing but a mark.
Nef3 with_marks(Nef3 set, bool of_outside, bool of_inside) {
  if (of_outside == of_inside) return of_inside ? Nef3::space() : Nef3::empty();
  return of_inside ? std::move(set) : !set;
}

/// Where each mark of one operand has but one partner, nothing has to meet: one of them is empty or the whole
/// space, or they are the same.
std::optional<Nef3> combine_marks(const Nef3& a, const Nef3& b, MarkFunction f) {
  const bool in_a = a.is_space(), in_b = b.is_space();
  if (in_b || b.is_empty()) return with_marks(a, f(false, in_b), f(true, in_b));
  if (in_a || a.is_empty()) return with_marks(b, f(in_a, false), f(in_a, true));
  if (!is_identical(a.complex(), b.complex())) return {};
  return with_marks(a, f(false, false), f(true, true));
}

}  // namespace

/// Bounded boundaries apart: all of one lies in volume 0 of the other.
std::optional<Nef3> Nef3::combined_apart(Nef3& a, Nef3& b, MarkFunction f) {
  if (has_frame(a.complex()) || has_frame(b.complex())) return {};
  std::vector<Box3> parts = a.state_->boxes();
  const std::vector<Box3> others = b.state_->boxes();
  if (!are_apart({a.complex(), parts}, {b.complex(), others})) return {};
  const bool of_a = a.complex().volume_mark[0] != 0, of_b = b.complex().volume_mark[0] != 0;
  a = plumb::with_marks(std::move(a), f(false, of_b), f(true, of_b));
  b = plumb::with_marks(std::move(b), f(of_a, false), f(of_a, true));
  if (b.complex().vertex_count() == 0) return a;
  if (a.complex().vertex_count() == 0) return b;
  parts.insert(parts.end(), others.begin(), others.end());
  Nef3 both;
  both.state_ = std::make_shared<State>(
      with_tidy_tables(appended(std::move(a).taken(), std::move(b).taken())), std::move(parts));
  return both;
}

Nef3 combine(Nef3 a, Nef3 b, MarkFunction f, Context& context) try {
  if (const std::optional<Nef3> known = combine_marks(a, b, f)) return *known;
  if (std::optional<Nef3> both = Nef3::combined_apart(a, b, f)) return std::move(*both);
  return Nef3::from_minimal(combine_any(std::move(a).taken(), std::move(b).taken(), f, context));
} catch (...) {
  rethrow_refused_memory();
}

Nef3 combine(const Nef3& a, const SpaceSelector& select_a, const Nef3& b,
             const SpaceSelector& select_b, MarkFunction f, Context& context) try {
  return Nef3::from_minimal(combine_any(selected(a.complex(), select_a, context),
                                        selected(b.complex(), select_b, context), f, context));
} catch (...) {
  rethrow_refused_memory();
}

Nef3 combine(const Nef3& a, const Plane3& plane, Section section, MarkFunction f,
             Context& context) try {
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
  SpaceComplex result = combine_with_plane(std::move(first), p, h, f, tables, context);
  return Nef3::from_minimal(with_tidy_tables(without_idle_frame(std::move(result), context)));
} catch (...) {
  rethrow_refused_memory();
}

namespace {

Nef3 combined(const Nef3& a, const Nef3& b, MarkFunction f) {
  Context context;
  return combine(a, b, f, context);
}

/// Pairwise, neighbours first: every set takes part in O(log n) operations. Uses up the sets.
Nef3 combine_all(std::span<Nef3> sets, MarkFunction f, Context& context) {
  if (sets.size() == 1) return std::move(sets[0]);
  const std::size_t half = sets.size() / 2;
  const std::array<std::span<Nef3>, 2> parts{sets.first(half), sets.subspan(half)};
  std::array<Nef3, 2> both;
  std::array<MemoryCharge, 2> memory{MemoryCharge(context), MemoryCharge(context)};
  run_jobs(context, 2, [&](std::size_t i, Context& own) {
    both[i] = combine_all(parts[i], f, own);
    if (parts[i].size() > 1) memory[i].add(both[i].bytes(), "a set of space");
  });
  return combine(std::move(both[0]), std::move(both[1]), f, context);
}

}  // namespace

Nef3 operator+(const Nef3& a, const Nef3& b) { return combined(a, b, kUnion); }
Nef3 operator*(const Nef3& a, const Nef3& b) { return combined(a, b, kIntersection); }
Nef3 operator-(const Nef3& a, const Nef3& b) { return combined(a, b, kDifference); }
Nef3 operator^(const Nef3& a, const Nef3& b) { return combined(a, b, kSymmetricDifference); }

bool operator==(const Nef3& a, const Nef3& b) try {
  return a.state_ == b.state_ || is_same(a.complex(), b.complex());
} catch (...) {
  rethrow_refused_memory();
}

bool operator<=(const Nef3& a, const Nef3& b) { return (a - b).is_empty(); }

Nef3 united(std::vector<Nef3> sets, Context& context) {
  return sets.empty() ? Nef3::empty() : combine_all(sets, kUnion, context);
}

Nef3 union_of(std::span<const Nef3> sets, Context& context) try {
  return united({sets.begin(), sets.end()}, context);
} catch (...) {
  rethrow_refused_memory();
}

Nef3 intersection_of(std::span<const Nef3> sets, Context& context) try {
  std::vector<Nef3> own(sets.begin(), sets.end());
  return own.empty() ? Nef3::space() : combine_all(own, kIntersection, context);
} catch (...) {
  rethrow_refused_memory();
}

}  // namespace plumb
