#include "plumb/plane/nef2.h"

#include <algorithm>
#include <array>
#include <utility>

#include "plumb/base/error.h"
#include "plumb/base/refused_memory.h"
#include "plumb/plane/nef2_state.h"
#include "plumb/plane/plane_measure.h"
#include "plumb/plane/plane_scene.h"
#include "plumb/plane/plane_simplify.h"
#include "plumb/predicates/decompose.h"

namespace plumb {
namespace {

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

/// Marks of the closure that are not those of the interior.
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

// Two minimal complexes of the same counts, over one table of points.
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
  /// The lines of bounded edges are given by their ends.
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

// ---------------------------------------------------------------- holding

Nef2::Nef2() try : Nef2(one_face(false)) {
} catch (...) {
  rethrow_refused_memory();
}

Nef2::Nef2(PlaneComplex minimal) try : state_(std::make_shared<const State>(std::move(minimal))) {
} catch (...) {
  rethrow_refused_memory();
}

Nef2 Nef2::plane() try { return Nef2(one_face(true)); } catch (...) {
  rethrow_refused_memory();
}

Nef2 Nef2::from_complex(PlaneComplex complex) try {
  return Nef2(simplify(std::move(complex)));
} catch (...) {
  rethrow_refused_memory();
}

Nef2 Nef2::with_marks(PlaneMarks marks) const try {
  require_sizes(complex(), marks);
  PlaneComplex other = complex();
  other.marks = std::move(marks);
  return from_complex(std::move(other));
} catch (...) {
  rethrow_refused_memory();
}

const PlaneComplex& Nef2::complex() const { return state_->complex; }

const PlaneLocator& Nef2::locator() const {
  std::call_once(state_->locator_made,
                 [this] { state_->locator = std::make_unique<PlaneLocator>(state_->complex); });
  return *state_->locator;
}

// ---------------------------------------------------------------- questions

bool Nef2::is_empty() const {
  const PlaneMarks& m = complex().marks;
  return m.face.size() == 1 && m.face[0] == 0 && m.vertex.empty() && m.edge.empty();
}

bool Nef2::is_plane() const {
  const PlaneMarks& m = complex().marks;
  return m.face.size() == 1 && m.face[0] == 1 && m.vertex.empty() && m.edge.empty();
}

bool Nef2::is_bounded() const try {
  const PlaneComplex& c = complex();
  for (std::size_t v = c.vertex_count(); v < c.dcel.vertex_count(); ++v) {
    for (const HalfedgeId h : c.dcel.around(VertexId(v))) {
      const FaceId f = c.dcel.face(h);
      if (!c.is_beyond(f) && c.mark(f)) return false;
      if (!c.is_frame(h) && c.mark(edge_of(h))) return false;
    }
  }
  return !c.mark(FaceId(0));
} catch (...) {
  rethrow_refused_memory();
}

bool Nef2::is_closed() const try {
  return closure_marks(complex()) == complex().marks;
} catch (...) {
  rethrow_refused_memory();
}
bool Nef2::is_open() const try {
  return interior_marks(complex()) == complex().marks;
} catch (...) {
  rethrow_refused_memory();
}

bool Nef2::has_on_boundary(const RationalPoint2& p) const try {
  // In minimal form every vertex and edge is on the boundary, and no face is.
  return !locate(p).face.is_valid();
} catch (...) {
  rethrow_refused_memory();
}

PlaneLocation Nef2::locate(const RationalPoint2& p) const try {
  return locator().locate(p);
} catch (...) {
  rethrow_refused_memory();
}

PlaneLocation Nef2::locate(Point2 p) const try {
  if (!is_finite(p.x) || !is_finite(p.y)) {
    throw Error(ErrorCode::NotFinite, "the coordinates of a point must be finite numbers");
  }
  return locator().locate(p);
} catch (...) {
  rethrow_refused_memory();
}

std::optional<Rational> Nef2::area() const try { return marked_area(complex()); } catch (...) {
  rethrow_refused_memory();
}

// ---------------------------------------------------------------- unary operations

Nef2 Nef2::complement() const try {
  PlaneComplex c = complex();
  c.marks = flipped(std::move(c.marks));
  return Nef2(std::move(c));
} catch (...) {
  rethrow_refused_memory();
}

Nef2 Nef2::interior() const try { return with_marks(interior_marks(complex())); } catch (...) {
  rethrow_refused_memory();
}
Nef2 Nef2::closure() const try { return with_marks(closure_marks(complex())); } catch (...) {
  rethrow_refused_memory();
}
Nef2 Nef2::boundary() const try { return with_marks(boundary_marks(complex())); } catch (...) {
  rethrow_refused_memory();
}
Nef2 Nef2::exterior() const { return complement().interior(); }
Nef2 Nef2::regularization() const { return interior().closure(); }

// ---------------------------------------------------------------- comparison

bool operator==(const Nef2& a, const Nef2& b) try {
  return a.state_ == b.state_ || is_same(a.complex(), b.complex());
} catch (...) {
  rethrow_refused_memory();
}

bool operator<=(const Nef2& a, const Nef2& b) { return (a - b).is_empty(); }

std::optional<DcelFlaw> Nef2::audit() const try {
  return plumb::audit(complex(), true);
} catch (...) {
  rethrow_refused_memory();
}

}  // namespace plumb
