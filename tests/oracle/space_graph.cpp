#include "oracle/space_graph.h"

#include <algorithm>
#include <bit>
#include <map>
#include <numeric>

namespace plumb::testing {
namespace {

constexpr std::size_t kNone = SpaceGraph::kNone;

// The dimension in which the marks around each cell do not change.
class Invariance {
 public:
  Invariance(const SpaceCells& cells, const CellMarks& marks) : cells_(cells), marks_(marks) {}

  int at(std::size_t c) const {
    const int dimension = cells_[c].dimension;
    if (dimension == 3 || depends_only_on(c, 0)) return 3;
    if (dimension == 2 || is_along_a_plane(c)) return 2;
    return dimension == 1 || is_along_a_line(c) ? 1 : 0;
  }

 private:
  bool is_along_a_plane(std::size_t c) const {
    for (std::uint64_t left = cells_.planes_through(c); left != 0; left &= left - 1) {
      if (depends_only_on(c, left & (~left + 1))) return true;
    }
    return false;
  }

  // The edges of the cells at a vertex give the lines through it.
  bool is_along_a_line(std::size_t c) const {
    return std::any_of(cells_[c].around.begin(), cells_[c].around.end(), [&](std::size_t d) {
      return cells_[d].dimension == 1 && depends_only_on(c, cells_.planes_through(d));
    });
  }

  // Do cells around c on the same sides of these planes have the same mark?
  bool depends_only_on(std::size_t c, std::uint64_t planes) const {
    std::map<std::pair<std::uint64_t, std::uint64_t>, bool> mark_of = {{{0, 0}, marks_[c]}};
    return std::all_of(cells_[c].around.begin(), cells_[c].around.end(), [&](std::size_t d) {
      const SpaceCells::Signs& s = cells_[d].signs;
      const std::pair sides{s.positive & planes, s.negative & planes};
      return mark_of.emplace(sides, marks_[d]).first->second == marks_[d];
    });
  }

  const SpaceCells& cells_;
  const CellMarks& marks_;
};

class Melter {
 public:
  Melter(const SpaceCells& cells, const CellMarks& marks)
      : cells_(cells), marks_(marks), lineality_(cells.size()), root_(cells.size()) {
    const Invariance invariance(cells, marks);
    for (std::size_t c = 0; c < cells.size(); ++c) lineality_[c] = invariance.at(c);
    std::iota(root_.begin(), root_.end(), std::size_t{0});
  }

  SpaceGraph run() {
    for (std::size_t c = 0; c < cells_.size(); ++c) melt(c);
    graph_.element_of.resize(cells_.size());
    number_vertices();
    number_others();
    for (std::size_t c = 0; c < cells_.size(); ++c) describe(c);
    for (std::size_t c = 0; c < cells_.size(); ++c) {
      if (cells_[c].dimension == 0) end_edges(c);
    }
    for (SpaceGraph::Vertex& v : graph_.vertices) place(v);
    return std::move(graph_);
  }

 private:
  std::size_t root(std::size_t c) {
    while (root_[c] != c) c = root_[c] = root_[root_[c]];
    return c;
  }

  void melt(std::size_t c) {
    for (const std::size_t d : cells_[c].around) {
      if (lineality_[d] == lineality_[c]) root_[root(d)] = root(c);
    }
  }

  void number_vertices() {
    std::map<ExactPoint3, std::size_t> order;
    for (std::size_t c = 0; c < cells_.size(); ++c) {
      if (lineality_[c] == 0) order.emplace(cells_[c].point, c);
    }
    for (const auto& [point, c] : order) {
      graph_.element_of[c] = {0, graph_.vertices.size()};
      graph_.vertices.push_back({.point = point, .mark = marks_[c], .cell = c});
    }
  }

  // A root stands for all cells that melted together.
  void number_others() {
    for (std::size_t c = 0; c < cells_.size(); ++c) {
      if (lineality_[c] != 0 && root(c) == c) graph_.element_of[c] = new_element(lineality_[c]);
    }
    for (std::size_t c = 0; c < cells_.size(); ++c) {
      graph_.element_of[c] = graph_.element_of[root(c)];
    }
  }

  SpaceGraph::Element new_element(int dimension) {
    switch (dimension) {
      case 1:
        graph_.edges.emplace_back();
        return {1, graph_.edges.size() - 1};
      case 2:
        graph_.facets.emplace_back();
        return {2, graph_.facets.size() - 1};
      default:
        graph_.volumes.emplace_back();
        return {3, graph_.volumes.size() - 1};
    }
  }

  // What a cell of full dimension says about its element.
  void describe(std::size_t c) {
    const auto [dimension, index] = graph_.element_of[c];
    if (dimension != cells_[c].dimension) return;
    if (dimension == 1) describe_edge(c, graph_.edges[index]);
    if (dimension == 2) describe_facet(c, graph_.facets[index]);
    if (dimension == 3) {
      SpaceGraph::Volume& volume = graph_.volumes[index];
      volume.mark = marks_[c];
      volume.unbounded = volume.unbounded || cells_[c].unbounded;
    }
  }

  void describe_edge(std::size_t c, SpaceGraph::Edge& edge) const {
    const std::uint64_t planes = cells_.planes_through(c);
    const auto first = static_cast<std::size_t>(std::countr_zero(planes));
    const auto second = static_cast<std::size_t>(std::countr_zero(planes & (planes - 1)));
    edge.line = undirected(line_of(cells_.planes()[first], cells_.planes()[second]));
    edge.mark = marks_[c];
    edge.cell = c;
    if (are_all_in_volumes(cells_[c].around)) {
      edge.volume = graph_.element_of[cells_[c].around.back()].index;
    }
  }

  bool are_all_in_volumes(const std::vector<std::size_t>& some) const {
    return std::all_of(some.begin(), some.end(),
                       [&](std::size_t d) { return graph_.element_of[d].dimension == 3; });
  }

  void describe_facet(std::size_t c, SpaceGraph::Facet& facet) const {
    facet.plane = static_cast<std::size_t>(std::countr_zero(cells_.planes_through(c)));
    facet.mark = marks_[c];
    facet.unbounded = facet.unbounded || cells_[c].unbounded;
    for (const std::size_t d : cells_[c].around) {
      facet.volume[cells_[d].signs[facet.plane] > 0 ? 0 : 1] = graph_.element_of[d].index;
    }
  }

  void end_edges(std::size_t c) {
    const auto [dimension, v] = graph_.element_of[c];
    if (dimension != 0) return;
    for (const std::size_t d : cells_[c].around) {
      if (cells_[d].dimension != 1 || graph_.element_of[d].dimension != 1) continue;
      SpaceGraph::Edge& edge = graph_.edges[graph_.element_of[d].index];
      const bool starts = graph_.vertices[v].point < cells_[d].point;
      (starts ? edge.from : edge.to) = v;
    }
  }

  void place(SpaceGraph::Vertex& vertex) const {
    const auto& around = cells_[vertex.cell].around;
    if (are_all_in_volumes(around)) vertex.volume = graph_.element_of[around.back()].index;
    for (std::uint64_t left = cells_.planes_through(vertex.cell); left != 0; left &= left - 1) {
      const std::size_t facet = disk_around(vertex.cell, left & (~left + 1));
      if (facet != kNone) vertex.facet = facet;
    }
  }

  // The facet that everything around a vertex in a plane belongs to.
  std::size_t disk_around(std::size_t c, std::uint64_t plane) const {
    std::size_t facet = kNone;
    for (const std::size_t d : cells_[c].around) {
      if ((cells_.planes_through(d) & plane) == 0) continue;
      if (graph_.element_of[d].dimension != 2) return kNone;
      facet = graph_.element_of[d].index;
    }
    return facet;
  }

  const SpaceCells& cells_;
  const CellMarks& marks_;
  std::vector<int> lineality_;
  std::vector<std::size_t> root_;
  SpaceGraph graph_;
};

}  // namespace

bool SpaceGraph::has_unbounded_facets_or_edges() const {
  return std::any_of(facets.begin(), facets.end(), [](const Facet& f) { return f.unbounded; }) ||
         std::any_of(edges.begin(), edges.end(),
                     [](const Edge& e) { return e.from == kNone || e.to == kNone; });
}

SpaceGraph minimal_graph(const SpaceCells& cells, const CellMarks& marks) {
  return Melter(cells, marks).run();
}

SpaceItem SpaceMatch::item(const SpaceGraph::Element& element) const {
  switch (element.dimension) {
    case 0:
      return vertex[element.index];
    case 1:
      return edge[element.index];
    case 2:
      return facet[element.index];
    default:
      return volume[element.index];
  }
}

}  // namespace plumb::testing
