// Labels of cells by a potential on a spanning forest of the graph of cells.
//
// A label exists if and only if the shape is zero in homology relative to the border; it is then
// determined by its jumps up to a constant for each component. So labels are computed along tree
// edges and every other edge is checked: an edge that fails closes a cycle with the tree. Around
// this cycle the label would change by a number that is not zero, which proves that no label
// exists. If there is a cycle with an odd change, this cycle is kept, because it proves that there
// is not even a label modulo 2. Proof: docs/design/surface.md, section Labels; after M. Riso et
// al., BoolSurf: Boolean operations on surfaces, ACM Transactions on Graphics 41 (2022).
//
// Labels are sparse lists of (shape, value), ascending by shape, in one growing array; parents come
// before children, so one pass appends all of them. Memory is charged as the arrays grow.
// Tested by tests/surface/surface_labels_test.cpp, tests/surface/surface_test.cpp and
// tests/surface/surface_plane_test.cpp.
#include "plumb/surface/cells/surface_labels.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "plumb/predicates/strong_id.h"

namespace plumb {
namespace {

constexpr std::uint64_t kLabelBytes =
    3 * sizeof(SignedEntry);  // The memory before, during and after the shift.
constexpr std::size_t kChargeStep = 65536;

constexpr std::uint64_t kJumpBytes = 2 * sizeof(SignedEntry);  // The memory while the list grows.
constexpr std::uint64_t kBeginBytes = 2 * sizeof(std::uint32_t);

/// Charges memory for a growing list of entries, in steps. The charge lives as long as the list.
class ListCharge {
 public:
  ListCharge(MemoryCharge& charge, std::uint64_t bytes) : charge_(charge), bytes_(bytes) {}
  /// Charges the growth and returns true if it is time for a checkpoint.
  bool grow_to(std::size_t size) {
    if (size < charged_ + kChargeStep) return false;
    charge_.add(bytes_ * (size - charged_), "labels");
    charged_ = size;
    return true;
  }

 private:
  MemoryCharge& charge_;
  std::uint64_t bytes_;
  std::size_t charged_ = 0;
};

/// Appends a + sign b. Both lists are ascending.
void append_sum(std::span<const SignedEntry> a, std::span<const SignedEntry> b, std::int32_t sign,
                std::vector<SignedEntry>& out) {
  auto i = a.begin();
  auto j = b.begin();
  while (i != a.end() || j != b.end()) {
    if (j == b.end() || (i != a.end() && i->id < j->id)) {
      out.push_back(*i++);
    } else if (i == a.end() || j->id < i->id) {
      out.push_back({j->id, sign * j->value});
      ++j;
    } else {
      const std::int64_t sum = std::int64_t{i->value} + sign * std::int64_t{j->value};
      if (sum != 0) out.push_back({i->id, entry_value(sum)});
      ++i;
      ++j;
    }
  }
}

std::uint32_t component_of(const SurfaceCells& cells, CellId c) { return cells.component[c]; }

/// Returns the cell on the other side of an edge.
CellId across(const SurfaceCells& cells, std::uint32_t e, CellId c) {
  const CellEdge& edge = cells.edges[e];
  return edge.from == c ? edge.to : edge.from;
}

/// Returns the levels, sorted by component of the mesh and shape.
std::vector<CellLevel> sorted_levels(const SurfaceCells& cells, std::span<const CellLevel> levels) {
  std::vector<CellLevel> sorted(levels.begin(), levels.end());
  std::sort(sorted.begin(), sorted.end(), [&](const CellLevel& a, const CellLevel& b) {
    return std::pair(component_of(cells, a.cell), a.shape) <
           std::pair(component_of(cells, b.cell), b.shape);
  });
  return sorted;
}

// ---------------------------------------------------------------- tree

/// The edges at each cell.
struct IncidentEdges {
  IdVector<CellId, std::uint32_t> begin;  ///< First entry of each cell, and one past the last.
  std::vector<std::uint32_t> edge;        ///< Edges at cells, cell by cell.

  std::span<const std::uint32_t> operator[](CellId c) const {
    return std::span(edge).subspan(begin[c], begin[c.value() + 1] - begin[c]);
  }
};

IncidentEdges incident_edges(const SurfaceCells& cells) {
  IncidentEdges at;
  at.begin.assign(cells.size() + 2, 0);
  for (const CellEdge& e : cells.edges) {
    ++at.begin[e.from.value() + 2];
    ++at.begin[e.to.value() + 2];
  }
  for (std::size_t c = 2; c < at.begin.size(); ++c) at.begin[c] += at.begin[c - 1];
  at.edge.resize(2 * cells.edges.size());
  for (std::uint32_t e = 0; e < cells.edges.size(); ++e) {
    at.edge[at.begin[cells.edges[e].from.value() + 1]++] = e;
    at.edge[at.begin[cells.edges[e].to.value() + 1]++] = e;
  }
  return at;
}

/// Whether the cell c is a better root than another cell. The given outside cell is the best root,
/// then a cell at the border. Then the largest cell is preferred, because its label tends to be
/// zero, which makes fewer entries.
bool is_better_root(const SurfaceCells& cells, CellId outside, CellId c, CellId than) {
  if (!than.is_valid()) return true;
  if (c == outside || than == outside) return c == outside;
  const auto rank = [&](CellId d) { return std::pair(cells.is_at_border[d], cells.area[d]); };
  return rank(c) > rank(than);
}

/// Returns the root of each component. It is invalid if the component has no cell.
std::vector<CellId> find_roots(const SurfaceCells& cells, CellId outside) {
  std::vector<CellId> root;
  for (std::uint32_t i = 0; i < cells.size(); ++i) {
    const std::uint32_t component = cells.component[i];
    if (component >= root.size()) root.resize(component + std::size_t{1});
    if (is_better_root(cells, outside, CellId(i), root[component])) root[component] = CellId(i);
  }
  return root;
}

/// A spanning tree of each component.
struct CellTrees {
  struct Step {
    CellId cell;
    std::uint32_t edge;  ///< Edge from its parent; kNone at roots.
  };
  std::vector<Step> order;  ///< All cells, parents first, component by component.
  IdVector<CellId, std::uint32_t> parent_edge;  ///< Edge from the parent of each cell, or kNone.
};

/// Searches breadth-first from the root of each component. The order in which cells are found puts
/// parents first.
CellTrees grow_trees(const SurfaceCells& cells, const IncidentEdges& incident, CellId outside) {
  const std::vector<CellId> root = find_roots(cells, outside);
  CellTrees trees;
  trees.parent_edge.assign(cells.size(), kNone);
  IdVector<CellId, std::uint8_t> is_seen(cells.size());
  for (const CellId r : root) {
    if (!r.is_valid()) continue;
    std::size_t at = trees.order.size();
    trees.order.push_back({r, kNone});
    is_seen[r] = 1;
    for (; at < trees.order.size(); ++at) {
      const CellId c = trees.order[at].cell;
      for (const std::uint32_t e : incident[c]) {
        const CellId d = across(cells, e, c);
        if (is_seen[d] != 0) continue;
        is_seen[d] = 1;
        trees.parent_edge[d] = e;
        trees.order.push_back({d, e});
      }
    }
  }
  return trees;
}

// ---------------------------------------------------------------- potential

/// Labels of cells in one list, in any order of cells.
struct ScatteredLabels {
  struct Place {
    std::uint32_t begin;
    std::uint32_t end;
  };
  IdVector<CellId, Place> place;  ///< Range of each cell in `entries`.
  std::vector<SignedEntry> entries;

  std::span<const SignedEntry> operator[](CellId c) const {
    const Place p = place[c];
    return std::span(entries).subspan(p.begin, p.end - p.begin);
  }
};

/// Returns the labels that are zero at the roots. The label of a cell is that of its parent plus
/// the jump of the edge between them, with the sign of the direction in which the edge is crossed.
ScatteredLabels spread(const SurfaceCells& cells, const CellJumps& jumps, const CellTrees& trees,
                       ListCharge& charge, Context& context) {
  ScatteredLabels raw;
  raw.place.resize(cells.size());
  std::vector<SignedEntry> parent;
  for (const CellTrees::Step& s : trees.order) {
    const auto begin = static_cast<std::uint32_t>(raw.entries.size());
    if (s.edge != kNone) {
      const ScatteredLabels::Place from = raw.place[across(cells, s.edge, s.cell)];
      // The parent's entries are copied, because the list grows.
      parent.assign(raw.entries.begin() + from.begin, raw.entries.begin() + from.end);
      append_sum(parent, jumps[s.edge], cells.edges[s.edge].to == s.cell ? 1 : -1, raw.entries);
    }
    raw.place[s.cell] = {begin, static_cast<std::uint32_t>(raw.entries.size())};
    if (charge.grow_to(raw.entries.size())) {
      context.checkpoint("labels", raw.entries.size(), raw.entries.size());
    }
  }
  return raw;
}

// ---------------------------------------------------------------- check

std::vector<CellId> path_to_root(const SurfaceCells& cells, const CellTrees& trees, CellId c) {
  std::vector<CellId> path = {c};
  while (trees.parent_edge[c] != kNone) {
    c = across(cells, trees.parent_edge[c], c);
    path.push_back(c);
  }
  return path;
}

/// Returns the cells along the tree from one end of the edge to the other.
std::vector<CellId> cycle_of(const SurfaceCells& cells, const CellTrees& trees, std::uint32_t e) {
  std::vector<CellId> up = path_to_root(cells, trees, cells.edges[e].from);
  std::vector<CellId> down = path_to_root(cells, trees, cells.edges[e].to);
  while (up.size() > 1 && down.size() > 1 && up[up.size() - 2] == down[down.size() - 2]) {
    up.pop_back();
    down.pop_back();
  }
  if (up.size() == 1 && down.size() == 1) return up;  // The edge leads back to the same cell.
  up.insert(up.end(), down.rbegin() + 1, down.rend());
  return up;
}

/// Stores the cycle of an edge. Its memory remains charged, because a division keeps its cycles.
void give_cycle(const SurfaceCells& cells, const CellTrees& trees, std::uint32_t e, Separation& s,
                Context& context) {
  context.checkpoint("labels", e, cells.edges.size());
  std::vector<CellId> cycle = cycle_of(cells, trees, e);
  context.charge_memory(cycle.size() * sizeof(CellId), "cycles of cells");
  s.cycle = std::move(cycle);
}

/// Checks each edge that is not in a tree: the difference of the labels at its ends must equal its
/// jump. If it does not, the shape has no label, and `separation` states this.
void check_edges(const SurfaceCells& cells, const CellJumps& jumps, const CellTrees& trees,
                 const ScatteredLabels& raw, std::vector<Separation>& separation,
                 Context& context) {
  std::vector<SignedEntry> difference, error;
  for (std::uint32_t e = 0; e < cells.edges.size(); ++e) {
    if (e % 4096 == 0) context.checkpoint("labels", e, cells.edges.size());
    const CellEdge& edge = cells.edges[e];
    if (trees.parent_edge[edge.from] == e || trees.parent_edge[edge.to] == e) continue;
    difference.clear();
    append_sum(raw[edge.to], raw[edge.from], -1, difference);
    error.clear();
    append_sum(difference, jumps[e], -1, error);
    for (const SignedEntry& wrong : error) {
      Separation& s = separation[wrong.id];
      const bool is_odd = wrong.value % 2 != 0;
      if (s.over_z || (s.mod_2 && is_odd)) give_cycle(cells, trees, e, s, context);
      s.over_z = false;
      if (is_odd) s.mod_2 = false;
    }
  }
}

/// Reduces labels. Shapes that separate only modulo 2 keep their parities, and shapes that do not
/// separate keep no labels.
void drop_failed(const CellTrees& trees, std::span<const Separation> separation,
                 ScatteredLabels& raw) {
  std::uint32_t kept = 0;
  for (const CellTrees::Step& s : trees.order) {
    ScatteredLabels::Place& p = raw.place[s.cell];
    const std::uint32_t begin = kept;
    for (std::uint32_t i = p.begin; i < p.end; ++i) {
      SignedEntry entry = raw.entries[i];
      const Separation& how = separation[entry.id];
      if (!how.over_z) entry.value = how.mod_2 ? entry.value & 1 : 0;
      if (entry.value != 0) raw.entries[kept++] = entry;
    }
    p = {begin, kept};
  }
  raw.entries.resize(kept);
}

// ---------------------------------------------------------------- shift

/// The data that determine the shifts: the labels that are zero at the roots, and the places where
/// they must be zero.
struct ShiftInput {
  const SurfaceCells& cells;
  const ScatteredLabels& raw;
  std::span<const Separation> separation;
  CellId outside;
  std::span<const CellLevel> levels;  ///< Sorted by component of the mesh and shape.
};

/// The cells of a component, the root first. If `has_border` is true, the least label is taken over
/// the cells at the border.
struct ComponentCells {
  std::span<const CellTrees::Step> steps;
  bool has_border;
};

/// Returns the shift without levels: the least label becomes zero.
std::vector<SignedEntry> usual_shift(const ShiftInput& in, const ComponentCells& component) {
  if (component.steps.front().cell == in.outside) return {};
  // The labels below zero. If a shape is not listed in a cell, its label there is zero.
  std::vector<SignedEntry> least;
  for (const CellTrees::Step& s : component.steps) {
    if (component.has_border && in.cells.is_at_border[s.cell] == 0) continue;
    for (const SignedEntry& e : in.raw[s.cell]) {
      if (e.value < 0 && in.separation[e.id].over_z) least.push_back(e);
    }
  }
  std::sort(least.begin(), least.end());
  std::vector<SignedEntry> shift;
  for (const SignedEntry& e : least) {
    if (shift.empty() || shift.back().id != e.id) shift.push_back({e.id, -e.value});
  }
  return shift;
}

std::int32_t value_of(std::span<const SignedEntry> list, std::uint32_t shape) {
  const auto at = std::lower_bound(list.begin(), list.end(), SignedEntry{shape, 0},
                                   [](const auto& a, const auto& b) { return a.id < b.id; });
  return at != list.end() && at->id == shape ? at->value : 0;
}

/// Returns the shifts of the shapes that have a level in a component.
std::vector<SignedEntry> given_shift(const ShiftInput& in, std::uint32_t component) {
  std::vector<SignedEntry> given;
  const auto component_of_level = [&](const CellLevel& l) {
    return component_of(in.cells, l.cell);
  };
  const auto first = std::ranges::lower_bound(in.levels, component, {}, component_of_level);
  for (auto l = first; l != in.levels.end() && component_of_level(*l) == component; ++l) {
    if (in.separation[l->shape].mod_2) {
      const std::int64_t by = std::int64_t{l->label} - value_of(in.raw[l->cell], l->shape);
      given.push_back({l->shape, entry_value(by)});
    }
  }
  return given;
}

/// Returns the numbers to be added to the labels of a component, in ascending order of shapes.
/// Until then, the labels are zero at the root of the component.
std::vector<SignedEntry> shift_of(const ShiftInput& in, const ComponentCells& component) {
  std::vector<SignedEntry> usual = usual_shift(in, component);
  const std::vector<SignedEntry> given =
      given_shift(in, component_of(in.cells, component.steps.front().cell));
  if (given.empty()) return usual;
  const auto is_less = [](const SignedEntry& a, const SignedEntry& b) { return a.id < b.id; };
  std::vector<SignedEntry> others, shift;
  std::set_difference(usual.begin(), usual.end(), given.begin(), given.end(),
                      std::back_inserter(others), is_less);
  std::merge(others.begin(), others.end(), given.begin(), given.end(), std::back_inserter(shift),
             is_less);
  std::erase_if(shift, [](const SignedEntry& e) { return e.value == 0; });
  return shift;
}

/// Reduces the entries from `from` on to parities, if their shapes separate only modulo 2.
void keep_parity(std::span<const Separation> separation, std::vector<SignedEntry>& list,
                 std::size_t from) {
  std::size_t kept = from;
  for (std::size_t i = from; i < list.size(); ++i) {
    SignedEntry e = list[i];
    if (!separation[e.id].over_z) e.value &= 1;
    if (e.value != 0) list[kept++] = e;
  }
  list.resize(kept);
}

/// Returns the cells of the component whose root is at `begin`, in the order of the trees.
ComponentCells component_at(const SurfaceCells& cells, const CellTrees& trees, std::size_t begin) {
  std::size_t end = begin + 1;
  while (end < trees.order.size() && trees.order[end].edge != kNone) ++end;
  const auto steps = std::span(trees.order).subspan(begin, end - begin);
  const bool has_border = std::ranges::any_of(
      steps, [&](const CellTrees::Step& s) { return cells.is_at_border[s.cell] != 0; });
  return {steps, has_border};
}

/// Returns the sums of the labels of all cells and the shifts of their components.
ScatteredLabels shifted_labels(const ShiftInput& in, const CellTrees& trees, ListCharge& charge,
                               Context& context) {
  ScatteredLabels shifted;
  shifted.place.resize(in.cells.size());
  for (std::size_t i = 0; i < trees.order.size();) {
    const ComponentCells component = component_at(in.cells, trees, i);
    const std::vector<SignedEntry> by = shift_of(in, component);
    for (const CellTrees::Step& s : component.steps) {
      const auto begin = static_cast<std::uint32_t>(shifted.entries.size());
      append_sum(in.raw[s.cell], by, 1, shifted.entries);
      if (!in.levels.empty()) keep_parity(in.separation, shifted.entries, begin);
      if (charge.grow_to(shifted.entries.size())) {
        context.checkpoint("labels", shifted.entries.size(), shifted.entries.size());
      }
      shifted.place[s.cell] = {begin, static_cast<std::uint32_t>(shifted.entries.size())};
    }
    i += component.steps.size();
  }
  return shifted;
}

/// Lists labels by cell in `labels`.
void list_by_cell(const ScatteredLabels& shifted, CellLabels& labels, Context& context) {
  const std::size_t cells = shifted.place.size();
  context.charge_memory(shifted.entries.size() * sizeof(SignedEntry), "labels");
  labels.entries.reserve(shifted.entries.size());
  for (std::size_t c = 0; c < cells; ++c) {
    const auto own = shifted[CellId(c)];
    labels.entries.insert(labels.entries.end(), own.begin(), own.end());
    labels.begin[c + 1] = static_cast<std::uint32_t>(labels.entries.size());
  }
}

}  // namespace

CellJumps jumps_of_polygons(const SurfaceArrangement& arrangement, const SurfaceCells& cells,
                            Context& context) {
  CellJumps jumps(context);
  jumps.memory->add(cells.edges.size() * kBeginBytes, "labels");
  ListCharge charge(*jumps.memory, kJumpBytes);
  for (const CellEdge& e : cells.edges) {
    for (const SignedEntry& m : arrangement.bundles[e.bundle]) {
      jumps.entries.push_back({m.id, m.value * e.sign});
    }
    if (charge.grow_to(jumps.entries.size())) context.checkpoint("labels", 0, 1);
    jumps.begin.push_back(static_cast<std::uint32_t>(jumps.entries.size()));
  }
  return jumps;
}

CellJumps jumps_of_shapes(const CellJumps& polygons,
                          std::span<const std::vector<std::uint32_t>> shapes, Context& context) {
  std::vector<std::vector<std::uint32_t>> shapes_of;
  for (std::uint32_t s = 0; s < shapes.size(); ++s) {
    for (const std::uint32_t p : shapes[s]) {
      if (p >= shapes_of.size()) shapes_of.resize(p + std::size_t{1});
      shapes_of[p].push_back(s);
    }
  }
  SurfaceBundles sums;
  CellJumps jumps(context);
  jumps.memory->add(polygons.begin.size() * kBeginBytes, "labels");
  std::vector<SignedEntry> terms;
  MemoryCharge working(context);
  ListCharge charge(*jumps.memory, kJumpBytes), sums_charge(working, kJumpBytes),
      terms_charge(working, kJumpBytes);
  std::size_t work = 0;
  for (std::size_t e = 0; e + 1 < polygons.begin.size(); ++e) {
    terms.clear();
    for (const SignedEntry& m : polygons[e]) {
      if (m.id >= shapes_of.size()) continue;
      for (const std::uint32_t s : shapes_of[m.id]) terms.push_back({s, m.value});
      terms_charge.grow_to(terms.size());
    }
    work += terms.size() + 1;
    const std::size_t most = jumps.entries.size() + terms.size();
    sums_charge.grow_to(most);
    if (charge.grow_to(most) || work >= kChargeStep) {
      context.checkpoint("labels", e, polygons.begin.size());
      work = 0;
    }
    if (sums.add_sum(terms)) {
      const auto sum = sums[sums.size() - 1];
      jumps.entries.insert(jumps.entries.end(), sum.begin(), sum.end());
    }
    jumps.begin.push_back(static_cast<std::uint32_t>(jumps.entries.size()));
  }
  return jumps;
}

CellLabels label_cells(const SurfaceCells& cells, const CellJumps& jumps, std::size_t shapes,
                       CellId outside, std::span<const CellLevel> levels, Context& context) {
  MemoryCharge working(context);
  ListCharge charge(working, kLabelBytes);
  context.charge_memory(shapes * sizeof(Separation), "labels");
  CellLabels labels;
  labels.separation.resize(shapes);
  const std::vector<CellLevel> sorted = sorted_levels(cells, levels);
  const IncidentEdges incident = incident_edges(cells);
  const CellTrees trees = grow_trees(cells, incident, outside);
  ScatteredLabels raw = spread(cells, jumps, trees, charge, context);
  check_edges(cells, jumps, trees, raw, labels.separation, context);
  drop_failed(trees, labels.separation, raw);
  labels.begin.assign(cells.size() + 1, 0);
  const ShiftInput input{cells, raw, labels.separation, outside, sorted};
  const ScatteredLabels shifted = shifted_labels(input, trees, charge, context);
  list_by_cell(shifted, labels, context);
  return labels;
}

}  // namespace plumb
