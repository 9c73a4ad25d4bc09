// The audit of a PlaneComplex. It computes all invariants again.
//
// Sizes, the half-edge structure, the frame, points and the order around vertices are checked
// first, so that links and ids can be followed safely. Then a sweep over the edges alone, with
// their listed marks, builds the complex once more (plane_records.h). The two complexes are equal
// if and only if the edges meet only at vertices, and faces and links agree with the geometry.
//
// Tested by tests/plane/nef2_test.cpp and tests/plane/plane_records_test.cpp.

#include "plumb/plane/plane_audit.h"

#include <string>
#include <utility>
#include <vector>

#include "plumb/plane/complex/plane_records.h"
#include "plumb/predicates/error.h"

namespace plumb {
namespace {

/// One audit, which keeps the first flaw that it finds.
class PlaneAudit {
 public:
  PlaneAudit(const PlaneComplex& complex, AuditForm form, Context& context)
      : c_(complex), form_(form), context_(context) {}

  std::optional<DcelFlaw> run() {
    if (!has_right_sizes() || !has_sound_dcel() || !has_right_frame() || !names_points()) {
      return flaw_;
    }
    for (std::size_t v = 0; v < c_.vertex_count(); ++v) {
      if (v % 1024 == 0) context_.checkpoint("audit", v, c_.vertex_count());
      if (!is_in_order(VertexId(v)) || !has_sorted_ring(VertexId(v))) return flaw_;
    }
    if (is_rebuilt_alike()) return std::nullopt;
    return flaw_;
  }

 private:
  bool require(bool holds, const char* invariant, const std::string& place) {
    if (!holds) flaw_ = DcelFlaw{invariant, place};
    return holds;
  }
  static std::string name(VertexId v) { return "vertex " + std::to_string(v.value()); }
  static std::string name(EdgeId e) { return "edge " + std::to_string(e.value()); }

  bool has_right_sizes() {
    return require(c_.dcel.face_count() > 0, "there is a face", "complex") &&
           require(c_.dcel.vertex_slots() == c_.dcel.vertex_count() &&
                       c_.dcel.edge_slots() == c_.dcel.edge_count() &&
                       c_.dcel.face_slots() == c_.dcel.face_count(),
                   "numberings have no holes", "complex") &&
           require(
               c_.dcel.edge_count() - c_.edge_count() == c_.dcel.vertex_count() - c_.vertex_count(),
               "the frame has as many edges as vertices", "complex") &&
           require(c_.marks.vertex.size() == c_.vertex_count() &&
                       c_.marks.edge.size() == c_.edge_count() &&
                       c_.marks.face.size() == c_.face_count(),
                   "each vertex, edge and face has a mark", "complex");
  }

  bool has_sound_dcel() {
    flaw_ = c_.dcel.audit();
    if (!flaw_) flaw_ = c_.dcel.audit_planar();
    return !flaw_ && require(!c_.dcel.has_pinches(), "no pinches in the half-edges", "complex");
  }

  bool has_right_frame() {
    for (std::size_t v = c_.vertex_count(); v < c_.dcel.vertex_count(); ++v) {
      std::size_t ordinary = 0;
      std::size_t all = 0;
      for (const HalfedgeId h : c_.dcel.around(VertexId(v))) {
        ++all;
        ordinary += c_.is_frame(h) ? 0 : 1;
      }
      if (!require(all == 3 && ordinary == 1, "one ordinary edge ends at each frame vertex",
                   name(VertexId(v)))) {
        return false;
      }
    }
    return true;
  }

  bool names_points() {
    for (std::size_t v = 0; v < c_.vertex_count(); ++v) {
      if (v % 1024 == 0) context_.checkpoint("audit", v, c_.vertex_count());
      if (!require(c_.vertex_point[v] < c_.points.size(), "a vertex has a point",
                   name(VertexId(v)))) {
        return false;
      }
    }
    for (std::size_t e = 0; e < c_.edge_count(); ++e) {
      if (e % 1024 == 0) context_.checkpoint("audit", e, c_.edge_count());
      const PlaneLine& l = c_.line[e];
      const std::size_t n = c_.points.inputs.size();
      if (!require(l.a < n && l.b < n && compare_xy(c_.points.inputs, l.a, l.b) == Sign::Negative,
                   "the line of an edge runs from left to right", name(EdgeId(e)))) {
        return false;
      }
    }
    return true;
  }

  bool is_in_order(VertexId v) {
    return v.value() == 0 || require(compare_xy(c_.points, c_.vertex_point[v.value() - 1U],
                                                c_.vertex_point[v]) == Sign::Negative,
                                     "vertices are in lexicographic order", name(v));
  }

  /// Whether the ring of a vertex is sorted: half-edges that leave to the right come before those
  /// that leave to the left, each by direction. A sorted ring has one descent, where it starts
  /// again.
  bool has_sorted_ring(VertexId v) {
    if (c_.dcel.is_isolated(v)) return true;
    std::size_t descents = 0;
    for (const HalfedgeId h : c_.dcel.around(v)) {
      const PlaneLine& l = c_.line[edge_of(h)];
      if (!require(orient2d(c_.points, l.a, l.b, c_.vertex_point[v]) == Sign::Zero,
                   "a vertex lies on the lines of its edges", name(v))) {
        return false;
      }
      if (!is_before(h, c_.dcel.turn_left(h))) ++descents;
    }
    return require(descents == 1, "edges leave a vertex counter-clockwise", name(v));
  }
  bool is_before(HalfedgeId h, HalfedgeId g) const {
    const auto goes_left = [](HalfedgeId k) { return (k.value() & 1U) != 0; };
    if (goes_left(h) != goes_left(g)) return goes_left(g);
    const PlaneLine& k = c_.line[edge_of(h)];
    const PlaneLine& l = c_.line[edge_of(g)];
    return cross_sign(c_.points.inputs, k.a, k.b, l.a, l.b) == Sign::Positive;
  }

  /// Whether a sweep over the edges alone finds the same faces and links. The sweep throws if edges
  /// meet outside of vertices.
  bool is_rebuilt_alike() {
    try {
      const PlaneRecords records = to_records(c_);
      const PlaneComplex again = form_ == AuditForm::Minimal ? from_records(records, context_)
                                                             : rebuild(records, context_);
      return has_same_links(again);
    } catch (const Error& e) {
      if (e.code() == ErrorCode::ResourceLimit || e.code() == ErrorCode::Cancelled) throw;
      return require(false, e.what(), "complex");
    }
  }
  bool has_same_links(const PlaneComplex& again) {
    if (!require(again.dcel.halfedge_count() == c_.dcel.halfedge_count() && again.marks == c_.marks,
                 "a sweep over the edges finds the same elements and marks", "complex")) {
      return false;
    }
    for (std::size_t i = 0; i < c_.dcel.halfedge_count(); ++i) {
      if (i % 1024 == 0) {
        context_.checkpoint("audit", i, c_.dcel.halfedge_count());
      }
      const HalfedgeId h(i);
      if (again.dcel.next(h) != c_.dcel.next(h) || again.dcel.origin(h) != c_.dcel.origin(h) ||
          again.dcel.face(h) != c_.dcel.face(h)) {
        return require(false, "a sweep over the edges finds the same links and faces",
                       "half-edge " + std::to_string(i));
      }
    }
    return true;
  }

  const PlaneComplex& c_;
  AuditForm form_;
  Context& context_;
  std::optional<DcelFlaw> flaw_;
};

}  // namespace

std::optional<DcelFlaw> audit(const PlaneComplex& complex, AuditForm form, Context& context) {
  return PlaneAudit(complex, form, context).run();
}

}  // namespace plumb
