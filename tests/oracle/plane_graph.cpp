#include "oracle/plane_graph.h"

#include <algorithm>
#include <map>
#include <numeric>

namespace plumb::testing {
namespace {

constexpr std::size_t kNone = PlaneGraph::kNone;

class Melter {
 public:
  Melter(const LineCells& cells, const std::vector<bool>& needed, const CellMarks& marks)
      : cells_(cells), needed_(needed), marks_(marks), root_(cells.size()) {
    std::iota(root_.begin(), root_.end(), std::size_t{0});
  }

  PlaneGraph run() {
    for (std::size_t c = 0; c < cells_.size(); ++c) melt(c);
    graph_.element_of.resize(cells_.size());
    number_vertices();
    number_runs();
    for (std::size_t c = 0; c < cells_.size(); ++c) {
      graph_.element_of[c] = graph_.element_of[root(c)];
    }
    measure_faces();
    join_edges();
    place_isolated();
    return std::move(graph_);
  }

 private:
  bool is_edge(std::size_t c) const { return cells_[c].dimension == 1 && needed_[c]; }

  std::size_t root(std::size_t c) const {
    while (root_[c] != c) c = root_[c];
    return c;
  }

  std::vector<std::size_t> edges_around(std::size_t c) const {
    std::vector<std::size_t> edges;
    for (const std::size_t d : cells_[c].around) {
      if (is_edge(d)) edges.push_back(d);
    }
    return edges;
  }

  // A place on an edge belongs to the edge, any other to the face.
  void melt(std::size_t c) {
    if (needed_[c] || cells_[c].dimension == 2) return;
    std::vector<std::size_t> into = edges_around(c);
    if (into.empty()) into = cells_[c].around;
    for (const std::size_t d : into) root_[root(d)] = root(c);
  }

  void number_vertices() {
    std::map<ExactPoint, std::size_t> order;
    for (std::size_t c = 0; c < cells_.size(); ++c) {
      if (cells_[c].dimension == 0 && needed_[c]) order.emplace(cells_[c].point, c);
    }
    for (const auto& [point, c] : order) {
      graph_.element_of[c] = {0, graph_.vertices.size()};
      graph_.vertices.push_back({point, marks_[c], kNone});
    }
  }

  // Edges and faces: a root stands for all cells that melted together.
  void number_runs() {
    std::map<std::size_t, bool> is_run;  // root -> an edge
    for (std::size_t c = 0; c < cells_.size(); ++c) {
      if (cells_[c].dimension == 2) is_run.emplace(root(c), false);
      if (is_edge(c)) is_run.emplace(root(c), true);
    }
    for (const auto& [c, edge] : is_run) {
      graph_.element_of[c] = edge ? PlaneGraph::Element{1, graph_.edges.size()}
                                  : PlaneGraph::Element{2, graph_.faces.size()};
      edge ? void(graph_.edges.emplace_back()) : void(graph_.faces.emplace_back());
    }
  }

  void measure_faces() {
    for (std::size_t c = 0; c < cells_.size(); ++c) {
      if (cells_[c].dimension != 2) continue;
      PlaneGraph::Face& face = graph_.faces[graph_.element_of[c].index];
      face.mark = marks_[c];
      face.unbounded = face.unbounded || cells_[c].unbounded;
    }
  }

  void join_edges() {
    for (std::size_t c = 0; c < cells_.size(); ++c) {
      if (is_edge(c)) describe_edge(c, graph_.edges[graph_.element_of[c].index]);
    }
    for (std::size_t c = 0; c < cells_.size(); ++c) {
      if (cells_[c].dimension == 0 && needed_[c]) end_edges(c);
    }
  }

  void describe_edge(std::size_t c, PlaneGraph::Edge& edge) const {
    edge.line = cells_.lines()[*cells_[c].line];
    edge.mark = marks_[c];
    edge.cell = c;
    for (const std::size_t f : cells_[c].around) {
      const bool left = side(edge.line, cells_[f].sample) > 0;
      (left ? edge.left : edge.right) = graph_.element_of[f].index;
    }
  }

  // Cells of an edge beyond the vertex end... start there; those before it end there.
  void end_edges(std::size_t c) {
    const std::size_t v = graph_.element_of[c].index;
    for (const std::size_t e : edges_around(c)) {
      PlaneGraph::Edge& edge = graph_.edges[graph_.element_of[e].index];
      const bool starts = graph_.vertices[v].point < cells_[e].point;
      (starts ? edge.from : edge.to) = v;
    }
  }

  void place_isolated() {
    for (std::size_t c = 0; c < cells_.size(); ++c) {
      if (cells_[c].dimension != 0 || !needed_[c] || !edges_around(c).empty()) continue;
      const std::size_t some_face = cells_[c].around.back();
      graph_.vertices[graph_.element_of[c].index].face = graph_.element_of[some_face].index;
    }
  }

  const LineCells& cells_;
  const std::vector<bool>& needed_;
  const CellMarks& marks_;
  std::vector<std::size_t> root_;
  PlaneGraph graph_;
};

// Do just two of these edges meet here, on one line?
bool pass_straight(const LineCells& cells, const std::vector<std::size_t>& edges) {
  return edges.size() == 2 && cells[edges[0]].line == cells[edges[1]].line;
}

std::vector<std::size_t> needed_around(const LineCells& cells, std::size_t c,
                                       const std::vector<bool>& needed) {
  std::vector<std::size_t> edges;
  for (const std::size_t d : cells[c].around) {
    if (cells[d].dimension == 1 && needed[d]) edges.push_back(d);
  }
  return edges;
}

bool is_vertex_needed(const LineCells& cells, const CellMarks& marks, std::size_t c,
                      const std::vector<bool>& needed) {
  const std::vector<std::size_t> edges = needed_around(cells, c, needed);
  if (edges.empty()) return marks[c] != marks[cells[c].around.front()];
  return !pass_straight(cells, edges) || marks[edges[0]] != marks[c] || marks[edges[1]] != marks[c];
}

}  // namespace

PlaneGraph minimal_graph(const LineCells& cells, const CellMarks& marks) {
  std::vector<bool> needed(cells.size());
  for (std::size_t c = 0; c < cells.size(); ++c) {
    if (cells[c].dimension != 1) continue;
    for (const std::size_t f : cells[c].around) needed[c] = needed[c] || marks[f] != marks[c];
  }
  for (std::size_t c = 0; c < cells.size(); ++c) {
    if (cells[c].dimension == 0) needed[c] = is_vertex_needed(cells, marks, c, needed);
  }
  return Melter(cells, needed, marks).run();
}

PlaneGraph arrangement_graph(const LineCells& cells, const CurveScene& scene) {
  std::vector<bool> needed(cells.size());
  for (std::size_t c = 0; c < cells.size(); ++c) {
    if (cells[c].dimension != 1) continue;
    const ExactPoint p = cells[c].point;
    needed[c] = std::any_of(scene.curves.begin(), scene.curves.end(),
                            [&](const TestCurve& curve) { return curve.contains(p); });
  }
  std::vector<ExactPoint> ends = scene.isolated;
  for (const TestCurve& curve : scene.curves) {
    if (curve.from) ends.push_back(*curve.from);
    if (curve.to) ends.push_back(*curve.to);
  }
  for (std::size_t c = 0; c < cells.size(); ++c) {
    if (cells[c].dimension != 0) continue;
    const std::vector<std::size_t> edges = needed_around(cells, c, needed);
    const bool is_end = std::find(ends.begin(), ends.end(), cells[c].point) != ends.end();
    needed[c] = is_end || (!edges.empty() && !pass_straight(cells, edges));
  }
  return Melter(cells, needed, CellMarks(cells.size())).run();
}

std::vector<CellLine> lines_of(const CurveScene& scene) {
  std::vector<CellLine> lines;
  std::vector<ExactPoint> stops = scene.isolated;
  for (const TestCurve& curve : scene.curves) {
    if (!curve.is_point()) lines.push_back(line_through(curve.a, curve.b));
    for (const auto& end : {curve.from, curve.to}) {
      if (end) stops.push_back(*end);
    }
  }
  for (const ExactPoint& p : stops) {
    lines.push_back(vertical_through(p));
    lines.push_back(line_through(p, {p.x + 1, p.y}));
  }
  return lines;
}

}  // namespace plumb::testing
