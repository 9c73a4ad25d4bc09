// Complexes as plain lists, and their check by a sweep.
//
// A list is accepted only if a sweep confirms it. First, indices and lines are checked. Then the
// listed edges are swept with their listed marks as labels, and the result is listed again. If both
// lists agree, the listed marks belong to the faces that the edges really bound, edges meet only at
// vertices, and everything is in the right order. For a set, it is also required that simplify()
// changes nothing.
//
// Tested by tests/plane/plane_records_test.cpp and tests/io/plane_io_test.cpp.

#include "plumb/plane/complex/plane_records.h"

#include <algorithm>
#include <string>
#include <utility>

#include "plumb/plane/complex/plane_draft.h"
#include "plumb/plane/complex/plane_rules.h"
#include "plumb/predicates/error.h"

namespace plumb {
namespace {

using Kind = RecordError::Kind;

const char* name_of(Kind kind) {
  switch (kind) {
    case Kind::Crossing:
      return "crossing ";
    case Kind::Vertex:
      return "vertex ";
    default:
      return "edge ";
  }
}

[[noreturn]] void refuse(Kind kind, std::size_t index, const std::string& why) {
  throw RecordError(kind, index, why);
}

// The rule of the sweep. Every piece is kept, and the labels are the marks that are listed with the
// edges. If marks disagree, this is detected when the result is listed again.
class RecordRule {
 public:
  using Label = std::uint8_t;
  using Value = SegmentId;  // Edges do not overlap.
  static constexpr bool kKeepsAll = true;
  static constexpr bool kKeepsLabels = false;

  RecordRule(const PlaneRecords& records, std::vector<std::uint32_t> vertex_at)
      : records_(records), vertex_at_(std::move(vertex_at)) {}

  void start(const SweepCurves&) {}
  Label bottom() const { return records_.bottom ? 1 : 0; }
  void begin_change() const {}
  void join(Value& value, SegmentId s) const {
    if (value.is_valid()) refuse(Kind::Edge, s.value(), "it overlaps another edge");
    value = s;
  }
  void leave(Value& value, SegmentId) const { value = SegmentId(); }
  Label above(Label, Value value) const { return edge(value).left ? 1 : 0; }
  Label below(Label, Value value) const { return edge(value).right ? 1 : 0; }
  bool face_mark(Label l) const { return l != 0; }
  bool edge_mark(Label, Label, Value value) const { return edge(value).mark; }
  bool vertex_mark(const PlaneSurroundings<RecordRule>& at) const {
    if (at.event.points.empty()) {
      refuse(Kind::Edge, at.event.incoming.front().value(),
             "it crosses another edge where no vertex is");
    }
    return records_.vertices[vertex_at_[at.event.points.front()]].mark;
  }
  void keep_edge(Value) {}

 private:
  const PlaneRecords::Edge& edge(Value value) const { return records_.edges[value.value()]; }

  const PlaneRecords& records_;
  std::vector<std::uint32_t> vertex_at_;  // The vertex at each point.
};

// ---------------------------------------------------------------- checks before the sweep

void check_crossings(const PlanePoints& points) {
  const std::size_t inputs = points.inputs.size();
  for (std::size_t i = 0; i < points.crossings.size(); ++i) {
    const Crossing2& c = points.crossings[i];
    if (std::max({c.a, c.b, c.c, c.d}) >= inputs) {
      refuse(Kind::Crossing, i, "it names a point that does not exist");
    }
    if (cross_sign(points.inputs, c.a, c.b, c.c, c.d) == Sign::Zero) {
      refuse(Kind::Crossing, i, "its lines are parallel or have no direction");
    }
  }
}

void check_vertices(const PlaneRecords& r) {
  for (std::size_t i = 0; i < r.vertices.size(); ++i) {
    if (r.vertices[i].point >= r.points.size()) {
      refuse(Kind::Vertex, i, "it names a point that does not exist");
    }
    if (i > 0 &&
        compare_xy(r.points, r.vertices[i - 1].point, r.vertices[i].point) != Sign::Negative) {
      refuse(Kind::Vertex, i, "vertices must be in order of x, then y, and different");
    }
  }
}

void check_edge(const PlaneRecords& r, std::size_t i) {
  const PlaneRecords::Edge& e = r.edges[i];
  const std::size_t inputs = r.points.inputs.size();
  if (e.line.a >= inputs || e.line.b >= inputs) {
    refuse(Kind::Edge, i, "its line names a point that does not exist");
  }
  if (compare_xy(r.points, e.line.a, e.line.b) != Sign::Negative) {
    refuse(Kind::Edge, i, "the points of its line must be different and in order of x, then y");
  }
  for (const std::uint32_t v : {e.from, e.to}) {
    if (v == PlaneRecords::kUnbounded) continue;
    if (v >= r.vertices.size()) refuse(Kind::Edge, i, "it names a vertex that does not exist");
    if (orient2d(r.points, e.line.a, e.line.b, r.vertices[v].point) != Sign::Zero) {
      refuse(Kind::Edge, i, "an end does not lie on its line");
    }
  }
  const bool is_bounded = e.from != PlaneRecords::kUnbounded && e.to != PlaneRecords::kUnbounded;
  if (is_bounded && e.from >= e.to) refuse(Kind::Edge, i, "it must run from its lesser end");
}

/// Returns the edges as curves, and every vertex as a stop, so that a vertex inside of an edge is
/// an event, too.
SweepInput scene_of(const PlaneRecords& r) {
  SweepInput scene;
  scene.points = r.points;
  // Boxes are computed here, because the boxes of a file may be wrong.
  for (Crossing2& c : scene.points.crossings) {
    c = make_crossing(scene.points.inputs, c.a, c.b, c.c, c.d);
  }
  const auto point = [&](std::uint32_t v) {
    return v == PlaneRecords::kUnbounded ? SweepCurve::kUnbounded : r.vertices[v].point;
  };
  for (const PlaneRecords::Edge& e : r.edges) {
    scene.curves.push_back({point(e.from), point(e.to), e.line.a, e.line.b});
  }
  for (const PlaneRecords::Vertex& v : r.vertices) scene.stops.push_back(v.point);
  return scene;
}

// ---------------------------------------------------------------- checks after it

/// Throws unless the result, when it is listed again, equals the original list.
void compare(const PlaneRecords& given, const PlaneRecords& found) {
  if (given.vertices.size() != found.vertices.size()) {
    refuse(Kind::Vertex, std::min(given.vertices.size(), found.vertices.size()),
           "vertices at equal points, or one inside an edge");
  }
  for (std::size_t i = 0; i < found.edges.size(); ++i) {
    if (i >= given.edges.size() || given.edges[i].from != found.edges[i].from ||
        given.edges[i].to != found.edges[i].to) {
      refuse(Kind::Edge, i, "a vertex lies inside it, or it is out of order");
    }
    if (given.edges[i].left != found.edges[i].left ||
        given.edges[i].right != found.edges[i].right) {
      refuse(Kind::Edge, i, "a mark beside it is not that of the face there");
    }
  }
  if (given.bottom != found.bottom) {
    throw Error(ErrorCode::BadArgument, "the mark of face 0 is not that of the edges around it");
  }
}

/// Throws if the complex is not minimal.
void check_minimal(const PlaneComplex& complex) {
  const PlaneComplex minimal = simplify(complex);
  if (minimal.vertex_count() != complex.vertex_count() ||
      minimal.edge_count() != complex.edge_count()) {
    throw Error(ErrorCode::BadArgument,
                "not in minimal form: an edge or vertex has the mark of all that is around it");
  }
}

}  // namespace

RecordError::RecordError(Kind kind, std::size_t index, const std::string& why)
    : Error(ErrorCode::BadArgument, name_of(kind) + std::to_string(index + 1) + ": " + why),
      kind_(kind),
      index_(index) {}

PlaneRecords::Vertex record_of(const PlaneComplex& complex, VertexId v) {
  return {complex.vertex_point[v], complex.mark(v)};
}

PlaneRecords::Edge record_of(const PlaneComplex& complex, EdgeId e) {
  const auto vertex = [&](VertexId v) {
    return complex.is_at_infinity(v) ? PlaneRecords::kUnbounded : v.value();
  };
  const HalfedgeId h = first_half(e);
  return {vertex(complex.dcel.origin(h)),
          vertex(complex.dcel.target(h)),
          complex.line[e],
          complex.mark(e),
          complex.mark(complex.dcel.face(h)),
          complex.mark(complex.dcel.face(twin(h)))};
}

PlaneRecords to_records(const PlaneComplex& complex) {
  PlaneRecords r;
  r.points = complex.points;
  r.bottom = complex.mark(FaceId(0));
  for (std::size_t i = 0; i < complex.vertex_count(); ++i) {
    r.vertices.push_back(record_of(complex, VertexId(i)));
  }
  for (std::size_t i = 0; i < complex.edge_count(); ++i) {
    r.edges.push_back(record_of(complex, EdgeId(i)));
  }
  return r;
}

PlaneComplex rebuild(const PlaneRecords& records, Context& context) {
  check_crossings(records.points);
  check_vertices(records);
  for (std::size_t i = 0; i < records.edges.size(); ++i) check_edge(records, i);
  std::vector<std::uint32_t> vertex_at(records.points.size(), 0);
  for (std::uint32_t i = 0; i < records.vertices.size(); ++i) {
    vertex_at[records.vertices[i].point] = i;
  }
  SweepInput scene = scene_of(records);
  RecordRule rule(records, std::move(vertex_at));
  PlaneComplex complex = build_complex(scene, rule, context);
  compare(records, to_records(complex));
  return complex;
}

PlaneComplex from_records(const PlaneRecords& records, Context& context) {
  PlaneComplex complex = rebuild(records, context);
  check_minimal(complex);
  return complex;
}

}  // namespace plumb
