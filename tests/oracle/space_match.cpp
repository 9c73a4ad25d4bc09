// SpaceGraph against the engine's complex.
#include <algorithm>
#include <map>

#include "oracle/space_graph.h"
#include "plumb/predicates/point3_signs.h"

namespace plumb::testing {
namespace {

constexpr std::size_t kAbsent = SpaceGraph::kNone;

struct SpaceEdgeKey {
  CellLine3 line;
  std::size_t from, to;
  friend bool operator<(const SpaceEdgeKey& s, const SpaceEdgeKey& t) {
    if (s.from != t.from || s.to != t.to) return std::tie(s.from, s.to) < std::tie(t.from, t.to);
    return s.line < t.line;
  }
};

// Throws the first difference, as text.
class SpaceMatcher {
 public:
  SpaceMatcher(const SpaceComplex& complex, const SpaceGraph& graph, const SpaceCells& cells)
      : complex_(complex), graph_(graph), cells_(cells) {
    match_.vertex.resize(graph.vertices.size());
    match_.edge.resize(graph.edges.size());
    match_.facet.resize(graph.facets.size());
    match_.volume.resize(graph.volumes.size());
  }

  SpaceMatch run() {
    try {
      compare_counts();
      match_vertices();
      match_edges();
      match_uses();
      match_whole_planes();
      match_volumes();
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
  static bool is_marked(Mark mark) { return mark == 1; }
  static std::size_t ordinary(const std::vector<Mark>& marks) {
    return marks.size() - static_cast<std::size_t>(std::count(marks.begin(), marks.end(), kBeyond));
  }

  // ---------------------------------------------------------------- counts

  void compare_counts() const {
    expect_equal(ordinary(complex_.vertex_mark), graph_.vertices.size(), "vertices");
    expect_equal(ordinary(complex_.edge_mark), graph_.edges.size(), "edges");
    expect_equal(ordinary(complex_.facet_mark), graph_.facets.size(), "facets");
    expect_equal(ordinary(complex_.volume_mark), graph_.volumes.size(), "volumes");
    const bool framed = ordinary(complex_.facet_mark) != complex_.facet_count();
    expect_equal(framed, graph_.has_unbounded_facets_or_edges(), "has a frame");
  }

  // ---------------------------------------------------------------- vertices

  void match_vertices() {
    std::map<ExactPoint3, std::size_t> by_point;
    for (std::size_t v = 0; v < graph_.vertices.size(); ++v) {
      by_point.emplace(graph_.vertices[v].point, v);
    }
    vertex_twin_.assign(complex_.vertex_count(), kAbsent);
    for (std::size_t i = 0; i < complex_.vertex_count(); ++i) {
      if (complex_.vertex_mark[i] == kBeyond) continue;
      const ExactPoint3 p = exact_of(exact(complex_.points(), complex_.vertex_point[i]));
      const auto found = by_point.find(p);
      if (found == by_point.end()) throw "the twin has no vertex at " + to_text(p);
      if (match_.vertex[found->second].is_valid()) throw "two vertices at " + to_text(p);
      match_.vertex[found->second] = VertexId(i);
      vertex_twin_[i] = found->second;
      expect_equal(is_marked(complex_.vertex_mark[i]), graph_.vertices[found->second].mark,
                   "mark at " + to_text(p));
    }
  }

  // ---------------------------------------------------------------- edges

  CellPlane plane(PlaneId p) const {
    const IntegerRow row = complex_.planes().coefficients(p);
    const auto number = [&](std::size_t i) { return exact_of(Rational(row[i])); };
    return plane_of(number(0), number(1), number(2), number(3));
  }
  CellLine3 line(EdgeId e) const {
    const auto [p, q] = complex_.edge_planes[e.value()];
    return line_of(plane(p), plane(q));
  }

  void match_edges() {
    std::map<SpaceEdgeKey, std::size_t> by_key;
    for (std::size_t e = 0; e < graph_.edges.size(); ++e) {
      by_key.emplace(SpaceEdgeKey{graph_.edges[e].line, graph_.edges[e].from, graph_.edges[e].to},
                     e);
    }
    edge_twin_.assign(complex_.edge_count(), kAbsent);
    for (std::size_t i = 0; i < complex_.edge_count(); ++i) {
      if (complex_.edge_mark[i] == kBeyond) continue;
      const std::string name = "edge " + std::to_string(i);
      const auto found = by_key.find(key_of(EdgeId(i)));
      if (found == by_key.end()) throw "the twin has no " + name;
      const std::size_t e = found->second;
      if (match_.edge[e].is_valid()) throw name + " is there twice";
      match_.edge[e] = EdgeId(i);
      edge_twin_[i] = e;
      expect_equal(is_marked(complex_.edge_mark[i]), graph_.edges[e].mark, "mark of " + name);
    }
  }

  SpaceEdgeKey key_of(EdgeId e) const {
    const CellLine3 directed = line(e);
    std::size_t from = vertex_twin_[complex_.origin[2 * e.value()].value()];
    std::size_t to = vertex_twin_[complex_.origin[2 * e.value() + 1].value()];
    const CellLine3 key = undirected(directed);
    if (!(key == directed)) std::swap(from, to);
    return {key, from, to};
  }

  // ---------------------------------------------------------------- facets

  void match_uses() {
    std::vector<std::size_t> uses(graph_.edges.size());
    for (std::size_t i = 0; i < complex_.use_count(); ++i) {
      const UseId u(i);
      const std::size_t e = edge_twin_[SpaceComplex::edge_of(complex_.use_halfedge[i]).value()];
      const FacetId f = complex_.use_facet[i];
      if (e == kAbsent || complex_.facet_mark[f.value()] == kBeyond) continue;
      match_facet(facet_beside(u, graph_.edges[e].cell), f, "left of use " + std::to_string(i));
      ++uses[e];
    }
    for (std::size_t e = 0; e < graph_.edges.size(); ++e) {
      expect_equal(uses[e], facets_around(graph_.edges[e].cell),
                   "uses of edge " + std::to_string(match_.edge[e].value()));
    }
  }

  std::size_t facets_around(std::size_t edge_cell) const {
    const auto& around = cells_[edge_cell].around;
    return static_cast<std::size_t>(std::count_if(around.begin(), around.end(), [&](std::size_t d) {
      return graph_.element_of[d].dimension == 2;
    }));
  }

  // The facet of the graph in the plane of u's facet, to the left of u.
  std::size_t facet_beside(UseId u, std::size_t edge_cell) const {
    const HalfedgeId h = complex_.use_halfedge[u.value()];
    const CellPlane facet_plane =
        plane(complex_.facet_plane[complex_.use_facet[u.value()].value()]);
    const CellLine3 edge_line = line(SpaceComplex::edge_of(h));
    const BigInt sign = SpaceComplex::is_reverse(h) ? -1 : 1;
    const CellVector left = sign * cross(facet_plane.n, edge_line.direction);
    const BigRational here = along(left, cells_[edge_cell].point);
    for (const std::size_t d : cells_[edge_cell].around) {
      const bool is_there = cells_[d].dimension == 2 && graph_.element_of[d].dimension == 2 &&
                            side(facet_plane, cells_[d].sample) == 0;
      if (is_there && along(left, cells_[d].point) > here) return graph_.element_of[d].index;
    }
    throw "the twin has no facet to the left of use " + std::to_string(u.value());
  }
  static BigRational along(const CellVector& v, const ExactPoint3& p) {
    return v.x * p.x + v.y * p.y + v.z * p.z;
  }

  void match_facet(std::size_t f, FacetId engine, const std::string& where) {
    if (match_.facet[f].is_valid()) {
      expect_equal(engine.value(), match_.facet[f].value(), "facet " + where);
      return;
    }
    match_.facet[f] = engine;
    const std::string name = "facet " + std::to_string(engine.value());
    expect_equal(is_marked(complex_.facet_mark[engine.value()]), graph_.facets[f].mark,
                 "mark of " + name);
    for (const int s : {0, 1}) {
      const auto which = static_cast<std::size_t>(s);
      match_volume(graph_.facets[f].volume[which], complex_.facet_volume[engine.value()][which],
                   (s == 0 ? "above " : "below ") + name);
    }
  }

  // Those that no use has matched: nothing but vertices is missing in them.
  void match_whole_planes() {
    for (std::size_t f = 0; f < graph_.facets.size(); ++f) {
      if (match_.facet[f].is_valid()) continue;
      const CellPlane& wanted = cells_.planes()[graph_.facets[f].plane];
      for (std::size_t i = 0; i < complex_.facet_count(); ++i) {
        const bool is_it =
            complex_.facet_mark[i] != kBeyond && plane(complex_.facet_plane[i]) == wanted;
        if (is_it) match_facet(f, FacetId(i), "in plane " + to_text(wanted));
      }
      if (!match_.facet[f].is_valid()) throw "no facet in plane " + to_text(wanted);
    }
  }

  // ---------------------------------------------------------------- volumes

  void match_volume(std::size_t v, VolumeId engine, const std::string& where) {
    if (engine.value() >= complex_.volume_count() ||
        complex_.volume_mark[engine.value()] == kBeyond) {
      throw "no volume " + where;
    }
    if (!match_.volume[v].is_valid()) match_.volume[v] = engine;
    expect_equal(engine.value(), match_.volume[v].value(), "volume " + where);
  }

  void match_volumes() {
    for (std::size_t e = 0; e < graph_.edges.size(); ++e) match_place(e);
    for (std::size_t v = 0; v < graph_.vertices.size(); ++v) match_place(graph_.vertices[v], v);
    if (!graph_.has_unbounded_facets_or_edges()) match_outside();
    std::vector<bool> seen(complex_.volume_count());
    for (std::size_t v = 0; v < graph_.volumes.size(); ++v) {
      const VolumeId engine = match_.volume[v];
      if (!engine.is_valid()) throw "volume " + std::to_string(v) + " of the twin is not there";
      if (seen[engine.value()]) throw "volume " + std::to_string(engine.value()) + " is two";
      seen[engine.value()] = true;
      expect_equal(is_marked(complex_.volume_mark[engine.value()]), graph_.volumes[v].mark,
                   "mark of volume " + std::to_string(engine.value()));
    }
  }

  void match_place(std::size_t e) {
    const std::size_t i = match_.edge[e].value();
    const std::string name = "edge " + std::to_string(i);
    const bool is_free = graph_.edges[e].volume != kAbsent;
    expect_equal(!complex_.edge_use[i].is_valid(), is_free, name + " is free");
    if (is_free) match_volume(graph_.edges[e].volume, complex_.edge_volume[i], "around " + name);
  }

  void match_place(const SpaceGraph::Vertex& vertex, std::size_t v) {
    const std::size_t i = match_.vertex[v].value();
    const std::string name = "vertex " + std::to_string(i);
    const FacetId facet = complex_.vertex_facet[i];
    expect_equal(facet.is_valid(), vertex.facet != kAbsent, name + " lies inside a facet");
    if (facet.is_valid()) match_facet(vertex.facet, facet, "around " + name);
    if (vertex.volume != kAbsent) {
      match_volume(vertex.volume, complex_.vertex_volume[i], "around " + name);
    }
  }

  // Without a frame everything but one volume is bounded.
  void match_outside() {
    for (std::size_t v = 0; v < graph_.volumes.size(); ++v) {
      if (graph_.volumes[v].unbounded) match_volume(v, VolumeId(0), "that is volume 0");
    }
  }

  const SpaceComplex& complex_;
  const SpaceGraph& graph_;
  const SpaceCells& cells_;
  std::vector<std::size_t> vertex_twin_;  // per vertex of the engine; kAbsent: of the frame
  std::vector<std::size_t> edge_twin_;
  SpaceMatch match_;
};

}  // namespace

SpaceMatch match(const SpaceComplex& complex, const SpaceGraph& graph, const SpaceCells& cells) {
  return SpaceMatcher(complex, graph, cells).run();
}

}  // namespace plumb::testing
