// Sets of the plane: the state that copies share, comparison, queries, operators of topology, ray
// shooting and the parts of a set.
//
// A set is its minimal complex, whose numbering is canonical (plane_draft.h). So equality compares
// links, marks, points and the lines of unbounded edges one by one, and operators of topology
// change marks and simplify in linear time. Copies share one state; the structures for location and
// for rays are built once, when any thread needs them first.
//
// Booleans are in set/boolean_op.cpp. The construction of basic sets is in set/shapes.cpp.
//
// Tested by tests/plane/nef2_test.cpp and tests/plane/nef2_property_test.cpp.

#include "plumb/plane/nef2.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <memory>
#include <mutex>
#include <utility>

#include "plumb/plane/complex/plane_draft.h"
#include "plumb/plane/plane_audit.h"
#include "plumb/plane/plane_measure.h"
#include "plumb/plane/query/plane_locator.h"
#include "plumb/plane/query/plane_trapezoids.h"
#include "plumb/plane/query/ray_walk.h"
#include "plumb/plane/set/boolean_op.h"
#include "plumb/predicates/arithmetic/double_bits.h"
#include "plumb/predicates/error.h"

namespace plumb {

/// The data that the copies of a set share.
struct Nef2::State {
  explicit State(PlaneComplex c) : complex(std::move(c)) {}

  /// Returns the complex of a state that a set releases. The complex is moved if no copy shares it;
  /// otherwise it is copied.
  static PlaneComplex taken(std::shared_ptr<State> state) {
    if (state.use_count() > 1) return state->complex;
    // use_count() does not synchronize, so the fence orders the reads of former owners before the
    // move.
    std::atomic_thread_fence(std::memory_order_acquire);
    return std::move(state->complex);
  }

  PlaneComplex complex;
  mutable std::once_flag locator_made;
  mutable std::unique_ptr<PlaneLocator> locator;
  mutable std::once_flag trapezoids_made;
  mutable std::unique_ptr<PlaneTrapezoids> trapezoids;
};

namespace {

/// Returns the complex of the empty set or of the whole plane.
PlaneComplex one_face(bool mark) {
  PlaneComplex complex;
  complex.dcel.add_face();
  complex.marks.face.assign(1, mark ? 1 : 0);
  return complex;
}

void require_sizes(const PlaneComplex& complex, const PlaneMarks& marks) {
  if (marks.vertex.size() != complex.vertex_count() || marks.edge.size() != complex.edge_count() ||
      marks.face.size() != complex.face_count()) {
    throw Error(ErrorCode::BadArgument, "one mark is needed for each vertex, edge and face");
  }
}

void flip(std::vector<std::uint8_t>& marks) {
  for (std::uint8_t& m : marks) m = m == 0 ? 1 : 0;
}

PlaneMarks flipped(PlaneMarks marks) {
  flip(marks.vertex);
  flip(marks.edge);
  flip(marks.face);
  return marks;
}

/// Returns the marks of the boundary, which is the closure without the interior.
PlaneMarks boundary_marks(const PlaneComplex& complex) {
  PlaneMarks marks = closure_marks(complex);
  const PlaneMarks inner = interior_marks(complex);
  const auto take_off = [](std::vector<std::uint8_t>& from, const std::vector<std::uint8_t>& what) {
    for (std::size_t i = 0; i < from.size(); ++i) {
      from[i] = from[i] != 0 && what[i] == 0 ? 1 : 0;
    }
  };
  take_off(marks.vertex, inner.vertex);
  take_off(marks.edge, inner.edge);
  take_off(marks.face, inner.face);
  return marks;
}

// ---------------------------------------------------------------- equality

// Compares two minimal complexes with the same counts and marks, over the same table of points.
class SameComplex {
 public:
  SameComplex(const PlaneComplex& a, const PlaneComplex& b)
      : a_(a), b_(b), joined_(join_points(std::array<const PlaneComplex*, 2>{&a, &b})) {}

  bool operator()() const { return have_same_links() && have_same_points() && have_same_lines(); }

 private:
  bool have_same_links() const {
    for (std::size_t i = 0; i < a_.dcel.halfedge_count(); ++i) {
      const HalfedgeId h(i);
      if (a_.dcel.next(h) != b_.dcel.next(h) || a_.dcel.origin(h) != b_.dcel.origin(h) ||
          a_.dcel.face(h) != b_.dcel.face(h)) {
        return false;
      }
    }
    return true;
  }
  bool have_same_points() const {
    for (std::size_t i = 0; i < a_.vertex_count(); ++i) {
      const std::uint32_t p = joined_.to[0][a_.vertex_point[i]];
      const std::uint32_t q = joined_.to[1][b_.vertex_point[i]];
      if (compare_xy(joined_.points, p, q) != Sign::Zero) return false;
    }
    return true;
  }
  /// Whether unbounded edges have the same lines. The lines of bounded edges follow from their
  /// ends.
  bool have_same_lines() const {
    for (std::size_t i = 0; i < a_.edge_count(); ++i) {
      const HalfedgeId h = first_half(EdgeId(i));
      const bool is_bounded =
          !a_.is_at_infinity(a_.dcel.origin(h)) && !a_.is_at_infinity(a_.dcel.target(h));
      if (!is_bounded && !is_same_line(a_.line[i], b_.line[i])) return false;
    }
    return true;
  }
  bool is_same_line(const PlaneLine& k, const PlaneLine& l) const {
    const auto& to = joined_.to;
    const auto side = [&](std::uint32_t p) {
      return orient2d(joined_.points, to[0][k.a], to[0][k.b], to[1][p]);
    };
    return side(l.a) == Sign::Zero && side(l.b) == Sign::Zero;
  }

  const PlaneComplex& a_;
  const PlaneComplex& b_;
  JoinedPoints joined_;
};

bool is_same(const PlaneComplex& a, const PlaneComplex& b) {
  if (a.vertex_count() != b.vertex_count() || a.edge_count() != b.edge_count() ||
      a.dcel.vertex_count() != b.dcel.vertex_count() || a.marks != b.marks ||
      a.dcel.loop_count() != b.dcel.loop_count()) {
    return false;
  }
  return SameComplex(a, b)();
}

}  // namespace

// ---------------------------------------------------------------- construction and reading

Nef2::Nef2() : Nef2(one_face(false)) {}

Nef2::Nef2(PlaneComplex minimal) : state_(std::make_shared<State>(std::move(minimal))) {}

Nef2 Nef2::whole() { return Nef2(one_face(true)); }

Nef2 Nef2::from_complex(PlaneComplex complex, Context& context) {
  context.checkpoint("simplify", 0, 0);
  return Nef2(simplify(std::move(complex)));
}

Nef2 Nef2::with_marks(PlaneMarks marks, Context& context) const {
  require_sizes(complex(), marks);
  PlaneComplex other = complex();
  other.marks = std::move(marks);
  return from_complex(std::move(other), context);
}

const PlaneComplex& Nef2::complex() const& { return state_->complex; }

PlaneComplex Nef2::complex() && { return State::taken(std::move(state_)); }

PlaneMarks Nef2::marks() const { return complex().marks; }

PlaneCounts Nef2::counts() const {
  const PlaneComplex& c = complex();
  const auto marked = std::count_if(c.marks.face.begin(), c.marks.face.end(),
                                    [](std::uint8_t mark) { return mark != 0; });
  return {c.vertex_count(), c.edge_count(), c.face_count(), static_cast<std::size_t>(marked)};
}

std::size_t Nef2::bytes() const {
  const PlaneComplex& c = complex();
  const Dcel& d = c.dcel;
  return c.points.inputs.bytes() + c.points.crossings.size() * sizeof(Crossing2) +
         16 * (d.halfedge_count() + d.loop_count()) + 4 * (d.vertex_count() + d.face_count()) +
         c.vertex_point.size() * (sizeof(std::uint32_t) + 1) +
         c.line.size() * (sizeof(PlaneLine) + 1) + c.face_count();
}

/// The first thread that needs the structure builds it, and other threads wait.
const PlaneLocator& Nef2::locator() const {
  std::call_once(state_->locator_made,
                 [this] { state_->locator = std::make_unique<PlaneLocator>(state_->complex); });
  return *state_->locator;
}

// ---------------------------------------------------------------- queries

bool Nef2::is_empty() const {
  const PlaneMarks& m = complex().marks;
  return m.face.size() == 1 && m.face[0] == 0 && m.vertex.empty() && m.edge.empty();
}

bool Nef2::is_whole() const {
  const PlaneMarks& m = complex().marks;
  return m.face.size() == 1 && m.face[0] == 1 && m.vertex.empty() && m.edge.empty();
}

/// A set is unbounded if and only if a cell that reaches the frame, or face 0, is marked.
bool Nef2::is_bounded() const {
  const PlaneComplex& c = complex();
  for (std::size_t v = c.vertex_count(); v < c.dcel.vertex_count(); ++v) {
    for (const HalfedgeId h : c.dcel.around(VertexId(v))) {
      const FaceId f = c.dcel.face(h);
      if (!c.is_beyond(f) && c.mark(f)) return false;
      if (!c.is_frame(h) && c.mark(edge_of(h))) return false;
    }
  }
  return !c.mark(FaceId(0));
}

bool Nef2::is_closed() const { return closure_marks(complex()) == complex().marks; }
bool Nef2::is_open() const { return interior_marks(complex()) == complex().marks; }

bool Nef2::is_subset_of(const Nef2& other, Context& context) const {
  return boolean_op(*this, other, kDifference, context).is_empty();
}

bool Nef2::has_on_boundary(const RationalPoint2& p, Context& context) const {
  // In the minimal form, every vertex and every edge is on the boundary, and no face is.
  return !locate(p, context).face.is_valid();
}

PlaneLocation Nef2::locate(const RationalPoint2& p, Context& context) const {
  context.checkpoint("locate", 0, 0);
  return locator().locate(p);
}

PlaneLocation Nef2::locate(Point2 p, Context& context) const {
  if (!is_finite(p.x) || !is_finite(p.y)) {
    throw Error(ErrorCode::NotFinite, "the coordinates of a point must be finite numbers");
  }
  context.checkpoint("locate", 0, 0);
  return locator().locate(p);
}

std::optional<Rational> Nef2::area(Context& context) const {
  return marked_area(complex(), context);
}

// ---------------------------------------------------------------- unary operations

Nef2 Nef2::complement(Context& context) const {
  context.checkpoint("complement", 0, 0);
  PlaneComplex c = complex();
  c.marks = flipped(std::move(c.marks));
  return Nef2(std::move(c));
}

Nef2 Nef2::interior(Context& context) const {
  return with_marks(interior_marks(complex()), context);
}

Nef2 Nef2::closure(Context& context) const { return with_marks(closure_marks(complex()), context); }

Nef2 Nef2::boundary(Context& context) const {
  return with_marks(boundary_marks(complex()), context);
}

Nef2 Nef2::exterior(Context& context) const { return complement(context).interior(context); }

Nef2 Nef2::regularization(Context& context) const { return interior(context).closure(context); }

// ---------------------------------------------------------------- comparison

bool operator==(const Nef2& a, const Nef2& b) {
  return a.state_ == b.state_ || is_same(a.complex(), b.complex());
}

std::optional<DcelFlaw> Nef2::audit(Context& context) const {
  return plumb::audit(complex(), AuditForm::Minimal, context);
}

// Ray shooting by a walk from cell to cell (ray_walk.h).

namespace {

/// Returns the first cell on a walk for which is_wanted() holds.
template <class Wanted>
std::optional<PlaneHit> first_met(RayWalk walk, const Wanted& is_wanted) {
  do {
    if (is_wanted(walk.here())) return PlaneHit{walk.here(), walk.point()};
  } while (walk.advance());
  return std::nullopt;
}

QueryRay2 ray_of(const RationalPoint2& origin, const RationalPoint2& direction) {
  if (direction.x == 0 && direction.y == 0) {
    throw Error(ErrorCode::BadArgument, "a ray needs a direction that is not zero");
  }
  return QueryRay2(origin, direction);
}

}  // namespace

const PlaneTrapezoids& Nef2::trapezoids() const {
  std::call_once(state_->trapezoids_made, [this] {
    state_->trapezoids = std::make_unique<PlaneTrapezoids>(complex(), locator());
  });
  return *state_->trapezoids;
}

std::optional<PlaneHit> Nef2::shoot(const RationalPoint2& origin, const RationalPoint2& direction,
                                    Context& context) const {
  context.checkpoint("shoot", 0, 0);
  const QueryRay2 ray = ray_of(origin, direction);
  return first_met(RayWalk(complex(), locator(), trapezoids(), ray),
                   [](const PlaneLocation& at) { return at.marked; });
}

std::optional<PlaneHit> Nef2::shoot_to_boundary(const RationalPoint2& origin,
                                                const RationalPoint2& direction,
                                                Context& context) const {
  context.checkpoint("shoot", 0, 0);
  const QueryRay2 ray = ray_of(origin, direction);
  return first_met(RayWalk(complex(), locator(), trapezoids(), ray),
                   [](const PlaneLocation& at) { return !at.face.is_valid(); });
}

// The closure of a set as polygons, lines and points.

namespace {

// Collects the parts. Works on the minimal complex of a closed set, in which no marked face has an
// edge or vertex in its inside: every bounded marked face is a polygon, and the marked edges beside
// no marked face are lines.
class PartCollector {
 public:
  PartCollector(const PlaneComplex& complex, Context& context)
      : c_(complex), context_(context), is_used_(complex.edge_count(), 0) {}

  PlaneParts collect() {
    for (std::size_t f = 0; f < c_.face_count(); ++f) {
      watch();
      if (c_.mark(FaceId(f))) add_face(FaceId(f));
    }
    // Chains with ends are followed first, from their ends. The remaining edges form closed chains.
    for (std::size_t e = 0; e < c_.edge_count(); ++e) {
      watch();
      add_open_chain(EdgeId(e));
    }
    for (std::size_t e = 0; e < c_.edge_count(); ++e) {
      watch();
      if (is_line(EdgeId(e))) add_chain(first_half(EdgeId(e)));
    }
    for (std::size_t v = 0; v < c_.vertex_count(); ++v) {
      const bool is_lone = c_.dcel.is_isolated(VertexId(v));
      if (is_lone && c_.mark(VertexId(v))) parts_.points.push_back(point(VertexId(v)));
    }
    return std::move(parts_);
  }

 private:
  /// Counts a step, and checks the context after every 1024 steps.
  void watch() {
    constexpr std::size_t kStepsPerCheckpoint = 1024;
    if (++steps_ % kStepsPerCheckpoint == 0) context_.checkpoint("parts", 0, 1);
  }

  RationalPoint2 point(VertexId v) {
    watch();
    return exact(c_.points, c_.vertex_point[v]);
  }

  void add_face(FaceId f) {
    if (is_unbounded(c_, f)) {
      parts_.dropped_unbounded = true;
      return;
    }
    PolygonWithHoles2 polygon;
    for (const std::vector<VertexId>& ring : face_rings(c_, f)) {
      std::vector<RationalPoint2> points;
      points.reserve(ring.size());
      for (const VertexId v : ring) points.push_back(point(v));
      if (polygon.outer.empty()) {
        polygon.outer = std::move(points);
      } else {
        polygon.holes.push_back(std::move(points));
      }
    }
    parts_.polygons.push_back(std::move(polygon));
  }

  /// Whether an edge is marked, bounded, not yet in a chain, and not the border of a marked face.
  bool is_line(EdgeId e) {
    const HalfedgeId h = first_half(e);
    if (is_used_[e] != 0 || !c_.mark(e) || c_.mark(c_.dcel.face(h)) ||
        c_.mark(c_.dcel.face(twin(h)))) {
      return false;
    }
    const bool is_bounded =
        !c_.is_at_infinity(c_.dcel.origin(h)) && !c_.is_at_infinity(c_.dcel.target(h));
    if (!is_bounded) parts_.dropped_unbounded = true;
    return is_bounded;
  }

  /// Returns the half-edge that leaves the target of h along its other edge. The id is invalid
  /// unless the target has exactly two edges.
  HalfedgeId going_on(HalfedgeId h) const {
    const HalfedgeId n = c_.dcel.next(h);
    const bool has_two = n != twin(h) && c_.dcel.turn_left(c_.dcel.turn_left(n)) == n;
    return has_two ? n : HalfedgeId();
  }

  /// Adds the chain of an edge if the chain starts at one of its ends.
  void add_open_chain(EdgeId e) {
    if (!is_line(e)) return;
    for (const HalfedgeId h : {first_half(e), twin(first_half(e))}) {
      const HalfedgeId before = going_on(twin(h));
      const bool starts_here = !before.is_valid() || !is_line(edge_of(before));
      if (starts_here && is_used_[e] == 0) add_chain(h);
    }
  }

  void add_chain(HalfedgeId h) {
    std::vector<RationalPoint2> chain = {point(c_.dcel.origin(h))};
    while (h.is_valid() && is_line(edge_of(h))) {
      is_used_[edge_of(h)] = 1;
      chain.push_back(point(c_.dcel.target(h)));
      h = going_on(h);
    }
    parts_.lines.push_back(std::move(chain));
  }

  const PlaneComplex& c_;
  Context& context_;
  std::size_t steps_ = 0;
  IdVector<EdgeId, std::uint8_t> is_used_;
  PlaneParts parts_;
};

/// Whether the closure gains points that are not on its border: an unmarked cell in the interior of
/// the closure, or an unmarked vertex between two marked edges beside which no face is marked.
bool gains_inside(const PlaneComplex& complex, const PlaneComplex& closed) {
  const PlaneMarks inner = interior_marks(closed);
  const auto gains = [](const std::vector<std::uint8_t>& now,
                        const std::vector<std::uint8_t>& was) {
    for (std::size_t i = 0; i < was.size(); ++i) {
      if (now[i] != 0 && was[i] == 0) return true;
    }
    return false;
  };
  if (gains(inner.edge, complex.marks.edge) || gains(inner.vertex, complex.marks.vertex)) {
    return true;
  }
  IdVector<VertexId, std::uint8_t> has_chain(complex.vertex_count(), 0);
  for (std::size_t e = 0; e < complex.edge_count(); ++e) {
    const HalfedgeId h = first_half(EdgeId(e));
    if (!complex.mark(EdgeId(e)) || complex.mark(complex.dcel.face(h)) ||
        complex.mark(complex.dcel.face(twin(h)))) {
      continue;
    }
    for (const VertexId v : {complex.dcel.origin(h), complex.dcel.target(h)}) {
      if (complex.is_at_infinity(v) || complex.mark(v)) continue;
      if (has_chain[v] != 0) return true;
      has_chain[v] = 1;
    }
  }
  return false;
}

}  // namespace

PlaneParts Nef2::parts(Context& context) const {
  if (is_closed()) return PartCollector(complex(), context).collect();
  const Nef2 minimal = closure(context);
  PlaneParts parts = PartCollector(minimal.complex(), context).collect();
  parts.dropped_open = true;
  parts.filled = closure_fills_inside(*this);
  return parts;
}

bool closure_fills_inside(const Nef2& set) {
  if (set.is_closed()) return false;
  PlaneComplex closed = set.complex();  // The cells of this set, so that marks can be compared.
  closed.marks = closure_marks(set.complex());
  return gains_inside(set.complex(), closed);
}

}  // namespace plumb
