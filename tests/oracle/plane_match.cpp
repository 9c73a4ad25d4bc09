// PlaneGraph against the engine's complex.
#include <algorithm>
#include <map>

#include "oracle/plane_graph.h"

namespace plumb::testing {
namespace {

constexpr std::size_t kAbsent = PlaneGraph::kNone;

struct EdgeKey {
  std::size_t from, to;
  CellLine line;
  friend bool operator<(const EdgeKey& s, const EdgeKey& t) {
    return std::tie(s.from, s.to, s.line) < std::tie(t.from, t.to, t.line);
  }
};

// Throws the first difference, as text.
class Matcher {
 public:
  Matcher(const PlaneComplex& complex, const PlaneGraph& graph, const LineCells& cells)
      : complex_(complex), graph_(graph), cells_(cells) {
    match_.vertex.resize(graph.vertices.size());
    match_.edge.resize(graph.edges.size());
    match_.face.resize(graph.faces.size());
  }

  GraphMatch run() {
    try {
      compare_counts();
      match_vertices();
      match_edges();
      match_isolated();
      match_bottom();
      match_faces();
      check_edge_order();
      check_face_order();
    } catch (const std::string& difference) {
      match_.difference = difference;
    }
    return std::move(match_);
  }

 private:
  template <class T, class U>
  static void expect_equal(const T& engine, const U& twin, const std::string& what) {
    if (engine != static_cast<T>(twin)) {
      throw what + ": engine " + std::to_string(engine) + ", twin " +
          std::to_string(static_cast<T>(twin));
    }
  }

  void compare_counts() const {
    expect_equal(complex_.vertex_count(), graph_.vertices.size(), "vertices");
    expect_equal(complex_.edge_count(), graph_.edges.size(), "edges");
    expect_equal(complex_.face_count(), graph_.faces.size(), "faces");
    expect_equal(complex_.marks.vertex.size(), graph_.vertices.size(), "vertex marks");
    expect_equal(complex_.marks.edge.size(), graph_.edges.size(), "edge marks");
    expect_equal(complex_.marks.face.size(), graph_.faces.size(), "face marks");
  }

  void match_vertices() {
    for (std::size_t v = 0; v < graph_.vertices.size(); ++v) {
      const ExactPoint p = exact_of(exact(complex_.points, complex_.vertex_point[v]));
      if (!(p == graph_.vertices[v].point)) {
        throw "vertex " + std::to_string(v) + ": engine " + to_text(p) + ", twin " +
            to_text(graph_.vertices[v].point);
      }
      expect_equal(complex_.mark(VertexId(v)), graph_.vertices[v].mark, "mark at " + to_text(p));
      match_.vertex[v] = VertexId(v);
    }
  }

  std::size_t end_of(VertexId v) const {
    return complex_.is_at_infinity(v) ? kAbsent : static_cast<std::size_t>(v.value());
  }

  EdgeKey key_of(EdgeId e) const {
    const PlaneLine& line = complex_.line[e.value()];
    const auto point = [&](std::uint32_t i) { return exact_of(complex_.points.inputs.exact(i)); };
    const HalfedgeId h = first_half(e);
    return {end_of(complex_.dcel.origin(h)), end_of(complex_.dcel.target(h)),
            line_through(point(line.a), point(line.b))};
  }

  void match_edges() {
    std::map<EdgeKey, std::size_t> by_key;
    for (std::size_t e = 0; e < graph_.edges.size(); ++e) {
      const PlaneGraph::Edge& edge = graph_.edges[e];
      by_key.emplace(EdgeKey{edge.from, edge.to, edge.line}, e);
    }
    for (std::size_t i = 0; i < complex_.edge_count(); ++i) {
      const EdgeId e(i);
      const std::string name = "edge " + std::to_string(i);
      const auto found = by_key.find(key_of(e));
      if (found == by_key.end()) throw name + ": the twin has no such edge";
      if (match_.edge[found->second].is_valid()) throw name + ": there twice";
      match_.edge[found->second] = e;
      const PlaneGraph::Edge& edge = graph_.edges[found->second];
      expect_equal(complex_.mark(e), edge.mark, "mark of " + name);
      match_face(edge.left, complex_.dcel.face(first_half(e)), "left of " + name);
      match_face(edge.right, complex_.dcel.face(twin(first_half(e))), "right of " + name);
    }
  }

  void match_face(std::size_t f, FaceId engine, const std::string& where) {
    if (complex_.is_beyond(engine)) throw where + ": the face beyond";
    if (!match_.face[f].is_valid()) match_.face[f] = engine;
    expect_equal(engine.value(), match_.face[f].value(), "face " + where);
  }

  void match_isolated() {
    for (std::size_t v = 0; v < graph_.vertices.size(); ++v) {
      const std::string name = "vertex " + std::to_string(v);
      const bool isolated = graph_.vertices[v].face != kAbsent;
      expect_equal(complex_.dcel.is_isolated(VertexId(v)), isolated, name + " isolated");
      if (!isolated) continue;
      const LoopId loop = complex_.dcel.isolated_loop(VertexId(v));
      match_face(graph_.vertices[v].face, complex_.dcel.face(loop), "around " + name);
    }
  }

  void match_bottom() {
    match_face(graph_.element_of[cells_.bottom()].index, FaceId(0), "that is face 0");
  }

  void match_faces() const {
    std::vector<bool> seen(graph_.faces.size());
    for (std::size_t f = 0; f < graph_.faces.size(); ++f) {
      const FaceId engine = match_.face[f];
      if (!engine.is_valid()) throw "face " + std::to_string(f) + " of the twin is not there";
      if (seen[engine.value()]) throw "face " + std::to_string(engine.value()) + " is two faces";
      seen[engine.value()] = true;
      const std::string name = "face " + std::to_string(engine.value());
      expect_equal(complex_.mark(engine), graph_.faces[f].mark, "mark of " + name);
      expect_equal(is_unbounded(complex_, engine), graph_.faces[f].unbounded, name + " unbounded");
    }
  }

  // -1: e comes before f, by the left ends and then from bottom to top. Vertical edges from
  // infinity are not compared with anything.
  int order(const PlaneGraph::Edge& e, const PlaneGraph::Edge& f) const {
    if (e.from != f.from) {
      if ((e.from == kAbsent && e.line.b == 0) || (f.from == kAbsent && f.line.b == 0)) return 0;
      if (e.from == kAbsent || f.from == kAbsent) return e.from == kAbsent ? -1 : +1;
      return e.from < f.from ? -1 : +1;
    }
    // Slopes: -a / b with b >= 0.
    const BigInt turn = e.line.b * f.line.a - f.line.b * e.line.a;  // slope of e - slope of f
    if (e.from != kAbsent) return turn.sign();
    if (e.line.b == 0 || f.line.b == 0) return 0;
    if (turn != 0) return -turn.sign();
    return BigInt(f.line.c * e.line.b - e.line.c * f.line.b).sign();
  }

  void check_edge_order() const {
    std::vector<std::size_t> twin_of(graph_.edges.size());
    for (std::size_t e = 0; e < graph_.edges.size(); ++e) twin_of[match_.edge[e].value()] = e;
    for (std::size_t i = 0; i + 1 < twin_of.size(); ++i) {
      if (order(graph_.edges[twin_of[i]], graph_.edges[twin_of[i + 1]]) > 0) {
        throw "edges " + std::to_string(i) + " and the next are out of order";
      }
    }
  }

  void check_face_order() const {
    std::vector<std::uint32_t> least(complex_.face_count(), HalfedgeId::kInvalid);
    for (std::size_t h = 0; h < 2 * complex_.edge_count(); ++h) {
      const std::size_t f = complex_.dcel.face(HalfedgeId(h)).value();
      least[f] = std::min(least[f], static_cast<std::uint32_t>(h));
    }
    if (least.size() > 1 && !std::is_sorted(least.begin() + 1, least.end())) {
      throw std::string("faces are not numbered by their least half-edge");
    }
  }

  const PlaneComplex& complex_;
  const PlaneGraph& graph_;
  const LineCells& cells_;
  GraphMatch match_;
};

}  // namespace

GraphMatch match(const PlaneComplex& complex, const PlaneGraph& graph, const LineCells& cells) {
  return Matcher(complex, graph, cells).run();
}

}  // namespace plumb::testing
