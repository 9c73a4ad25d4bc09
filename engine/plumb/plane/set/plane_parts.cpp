// Nef2::parts(): the closure of a set as polygons, lines and points.

#include <algorithm>
#include <utility>

#include "plumb/plane/nef2.h"
#include "plumb/plane/plane_measure.h"

namespace plumb {
namespace {

// Works on the complex of a closed set: no marked face has an edge or vertex in its inside.
class PartCollector {
 public:
  PartCollector(const PlaneComplex& complex, Context& context)
      : c_(complex), context_(context), is_used_(complex.edge_count(), 0) {}

  PlaneParts collect() {
    for (std::size_t f = 0; f < c_.face_count(); ++f) {
      watch();
      if (c_.mark(FaceId(f))) add_face(FaceId(f));
    }
    // Chains from their ends first; what is left then are closed ones.
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
  /// For every step: a look at the context now and then.
  void watch() {
    constexpr std::size_t kStepsPerCheckpoint = 1024;
    if (++steps_ % kStepsPerCheckpoint == 0) context_.checkpoint("parts", 0, 1);
  }

  RationalPoint2 point(VertexId v) {
    watch();
    return exact(c_.points, c_.vertex_point[v.value()]);
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

  /// Marked, bounded, not yet in a chain, and not the border of a marked face.
  bool is_line(EdgeId e) {
    const HalfedgeId h = first_half(e);
    if (is_used_[e.value()] != 0 || !c_.mark(e) || c_.mark(c_.dcel.face(h)) ||
        c_.mark(c_.dcel.face(twin(h)))) {
      return false;
    }
    const bool is_bounded =
        !c_.is_at_infinity(c_.dcel.origin(h)) && !c_.is_at_infinity(c_.dcel.target(h));
    if (!is_bounded) parts_.dropped_unbounded = true;
    return is_bounded;
  }

  /// The other edge of a vertex with exactly two; invalid if there are more or fewer.
  HalfedgeId going_on(HalfedgeId h) const {
    const HalfedgeId n = c_.dcel.next(h);
    const bool has_two = n != twin(h) && c_.dcel.turn_left(c_.dcel.turn_left(n)) == n;
    return has_two ? n : HalfedgeId();
  }

  void add_open_chain(EdgeId e) {
    if (!is_line(e)) return;
    for (const HalfedgeId h : {first_half(e), twin(first_half(e))}) {
      const HalfedgeId before = going_on(twin(h));
      const bool starts_here = !before.is_valid() || !is_line(edge_of(before));
      if (starts_here && is_used_[e.value()] == 0) add_chain(h);
    }
  }

  void add_chain(HalfedgeId h) {
    std::vector<RationalPoint2> chain = {point(c_.dcel.origin(h))};
    while (h.is_valid() && is_line(edge_of(h))) {
      is_used_[edge_of(h).value()] = 1;
      chain.push_back(point(c_.dcel.target(h)));
      h = going_on(h);
    }
    parts_.lines.push_back(std::move(chain));
  }

  const PlaneComplex& c_;
  Context& context_;
  std::size_t steps_ = 0;
  std::vector<std::uint8_t> is_used_;
  PlaneParts parts_;
};

}  // namespace

PlaneParts Nef2::parts(Context& context) const {
  const bool was_closed = is_closed();
  const Nef2 closed = was_closed ? *this : closure(context);
  PlaneParts parts = PartCollector(closed.complex(), context).collect();
  parts.dropped_open = !was_closed;
  return parts;
}

}  // namespace plumb
