// Labels of cells by a potential on a spanning forest of the graph of cells.
//
// A label exists if and only if the shape is zero in homology relative to the border; it is then
// determined by its jumps up to a constant for each component. So labels are computed along tree
// edges and every other edge is checked: one that fails closes a cycle with the tree around which
// the label would change by a number that is not zero, which proves that there is none. The cycle
// kept is one of odd change if there is one, because then not even a label modulo 2 exists. Proof:
// docs/design/surface.md, section Labels; after M. Riso et al., BoolSurf: Boolean operations on
// surfaces, ACM Transactions on Graphics 41 (2022).
//
// Labels are sparse lists of (shape, value), ascending by shape, in one growing array; parents come
// before children, so one pass appends all of them. Memory is charged as the arrays grow.
// Tested by tests/surface/surface_labels_test.cpp, tests/surface/surface_test.cpp and
// tests/surface/surface_plane_test.cpp.
#include "plumb/surface/cells/surface_labels.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace plumb {
namespace {

constexpr std::uint64_t kLabelBytes =
    3 * sizeof(SignedEntry);  // Before, while and after they are shifted.
constexpr std::size_t kChargeStep = 65536;

constexpr std::uint64_t kJumpBytes = 2 * sizeof(SignedEntry);  // As the list grows.
constexpr std::uint64_t kBeginBytes = 2 * sizeof(std::uint32_t);

/// Charges a growing list of entries, in steps, to a charge that lives as long as the list.
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

/// Appends a + sign b; both are ascending.
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

class Labeller {
 public:
  Labeller(const SurfaceCells& cells, const CellJumps& jumps, std::size_t shapes, CellId outside,
           std::span<const CellLevel> levels, Context& context)
      : cells_(cells),
        jumps_(jumps),
        outside_(outside),
        levels_(levels.begin(), levels.end()),
        context_(context),
        working_(context),
        charge_(working_, kLabelBytes) {
    context.charge_memory(shapes * sizeof(Separation), "labels");
    labels_.separation.resize(shapes);
    std::sort(levels_.begin(), levels_.end(), [&](const CellLevel& a, const CellLevel& b) {
      return std::pair(component(a.cell), a.shape) < std::pair(component(b.cell), b.shape);
    });
  }

  CellLabels run() {
    gather_edges();
    grow_trees();
    spread();
    for (std::uint32_t e = 0; e < cells_.edges.size(); ++e) {
      if (e % 4096 == 0) context_.checkpoint("labels", e, cells_.edges.size());
      check(e);
    }
    drop_failed();
    shift();
    return std::move(labels_);
  }

 private:
  struct Step {
    CellId cell;
    std::uint32_t edge;  ///< Edge from its parent; kNone at roots.
  };
  struct Place {
    std::uint32_t begin;
    std::uint32_t end;
  };

  std::uint32_t component(CellId c) const { return cells_.component[c.value()]; }
  CellId across(std::uint32_t e, CellId c) const {
    const CellEdge& edge = cells_.edges[e];
    return edge.from == c ? edge.to : edge.from;
  }

  void gather_edges() {
    edges_begin_.assign(cells_.size() + 2, 0);
    for (const CellEdge& e : cells_.edges) {
      ++edges_begin_[e.from.value() + 2];
      ++edges_begin_[e.to.value() + 2];
    }
    for (std::size_t c = 2; c < edges_begin_.size(); ++c) edges_begin_[c] += edges_begin_[c - 1];
    edges_of_.resize(2 * cells_.edges.size());
    for (std::uint32_t e = 0; e < cells_.edges.size(); ++e) {
      edges_of_[edges_begin_[cells_.edges[e].from.value() + 1]++] = e;
      edges_of_[edges_begin_[cells_.edges[e].to.value() + 1]++] = e;
    }
  }

  // ---------------------------------------------------------------- potential

  // Prefers the given outside cell, then a cell at the border, then the largest cell, whose label
  // tends to be zero: fewer entries.
  bool is_better_root(CellId c, CellId than) const {
    if (!than.is_valid()) return true;
    if (c == outside_ || than == outside_) return c == outside_;
    const auto rank = [&](CellId d) {
      return std::pair(cells_.is_at_border[d.value()], cells_.area[d.value()]);
    };
    return rank(c) > rank(than);
  }

  /// Breadth-first from the root of each component. The order in which cells are found puts parents
  /// first.
  void grow_trees() {
    std::vector<CellId> root;
    for (std::uint32_t i = 0; i < cells_.size(); ++i) {
      const std::uint32_t component = cells_.component[i];
      if (component >= root.size()) root.resize(component + std::size_t{1});
      if (is_better_root(CellId(i), root[component])) root[component] = CellId(i);
    }
    parent_edge_.assign(cells_.size(), kNone);
    std::vector<std::uint8_t> is_seen(cells_.size());
    for (const CellId r : root) {
      if (!r.is_valid()) continue;
      std::size_t at = order_.size();
      order_.push_back({r, kNone});
      is_seen[r.value()] = 1;
      for (; at < order_.size(); ++at) {
        const CellId c = order_[at].cell;
        for (std::uint32_t i = edges_begin_[c.value()]; i < edges_begin_[c.value() + 1]; ++i) {
          const std::uint32_t e = edges_of_[i];
          const CellId d = across(e, c);
          if (is_seen[d.value()] != 0) continue;
          is_seen[d.value()] = 1;
          parent_edge_[d.value()] = e;
          order_.push_back({d, e});
        }
      }
    }
  }

  /// The label of a cell is that of its parent and the jump of the edge between them, with the sign
  /// of the direction in which it is crossed.
  void spread() {
    place_.resize(cells_.size());
    for (const Step& s : order_) {
      const auto begin = static_cast<std::uint32_t>(raw_.size());
      if (s.edge != kNone) {
        const Place from = place_[across(s.edge, s.cell).value()];
        // The parent's entries are copied, because raw_ grows.
        scratch_.assign(raw_.begin() + from.begin, raw_.begin() + from.end);
        append_sum(scratch_, jumps_[s.edge], cells_.edges[s.edge].to == s.cell ? 1 : -1, raw_);
      }
      place_[s.cell.value()] = {begin, static_cast<std::uint32_t>(raw_.size())};
      if (charge_.grow_to(raw_.size())) {
        context_.checkpoint("labels", raw_.size(), raw_.size());
      }
    }
  }
  std::span<const SignedEntry> raw(CellId c) const {
    const Place p = place_[c.value()];
    return std::span(raw_).subspan(p.begin, p.end - p.begin);
  }

  // ---------------------------------------------------------------- check

  // Checks an edge that is not in the tree: the difference of the labels at its ends must be its
  // jump.
  void check(std::uint32_t e) {
    const CellEdge& edge = cells_.edges[e];
    if (parent_edge_[edge.from.value()] == e || parent_edge_[edge.to.value()] == e) return;
    scratch_.clear();
    append_sum(raw(edge.to), raw(edge.from), -1, scratch_);
    error_.clear();
    append_sum(scratch_, jumps_[e], -1, error_);
    for (const SignedEntry& wrong : error_) {
      Separation& s = labels_.separation[wrong.id];
      const bool is_odd = wrong.value % 2 != 0;
      if (s.over_z || (s.mod_2 && is_odd)) give_cycle(s, e);
      s.over_z = false;
      if (is_odd) s.mod_2 = false;
    }
  }
  /// Stores the cycle of an edge. It stays charged, because a division keeps its cycles.
  void give_cycle(Separation& s, std::uint32_t e) {
    context_.checkpoint("labels", e, cells_.edges.size());
    std::vector<CellId> cycle = cycle_of(e);
    context_.charge_memory(cycle.size() * sizeof(CellId), "cycles of cells");
    s.cycle = std::move(cycle);
  }

  std::vector<CellId> to_root(CellId c) const {
    std::vector<CellId> path = {c};
    while (parent_edge_[c.value()] != kNone) {
      c = across(parent_edge_[c.value()], c);
      path.push_back(c);
    }
    return path;
  }
  /// Returns the cells along the tree from one end of the edge to the other.
  std::vector<CellId> cycle_of(std::uint32_t e) const {
    std::vector<CellId> up = to_root(cells_.edges[e].from), down = to_root(cells_.edges[e].to);
    while (up.size() > 1 && down.size() > 1 && up[up.size() - 2] == down[down.size() - 2]) {
      up.pop_back();
      down.pop_back();
    }
    if (up.size() == 1 && down.size() == 1) return up;  // The edge leads back to its cell.
    up.insert(up.end(), down.rbegin() + 1, down.rend());
    return up;
  }

  /// Reduces labels: shapes that separate modulo 2 only keep their parity, those that do not
  /// separate keep nothing.
  void drop_failed() {
    std::uint32_t kept = 0;
    for (const Step& s : order_) {
      Place& p = place_[s.cell.value()];
      const std::uint32_t begin = kept;
      for (std::uint32_t i = p.begin; i < p.end; ++i) {
        SignedEntry entry = raw_[i];
        const Separation& how = labels_.separation[entry.id];
        if (!how.over_z) entry.value = how.mod_2 ? entry.value & 1 : 0;
        if (entry.value != 0) raw_[kept++] = entry;
      }
      p = {begin, kept};
    }
    raw_.resize(kept);
  }

  // ---------------------------------------------------------------- zero

  /// Cells of a component. If `has_border`, the least label is taken over those at the border.
  struct Range {
    std::size_t begin;
    std::size_t end;  ///< Range of order_.
    bool has_border;
  };

  /// Returns the shift without levels: the least label becomes zero.
  std::vector<SignedEntry> usual_shift_of(const Range& r) const {
    if (order_[r.begin].cell == outside_) return {};
    // Labels below zero; a shape that is not listed in a cell has label zero there.
    std::vector<SignedEntry> least;
    for (std::size_t i = r.begin; i < r.end; ++i) {
      const CellId c = order_[i].cell;
      if (r.has_border && cells_.is_at_border[c.value()] == 0) continue;
      for (const SignedEntry& e : raw(c)) {
        if (e.value < 0 && labels_.separation[e.id].over_z) least.push_back(e);
      }
    }
    std::sort(least.begin(), least.end());
    std::vector<SignedEntry> shift;
    for (const SignedEntry& e : least) {
      if (shift.empty() || shift.back().id != e.id) shift.push_back({e.id, -e.value});
    }
    return shift;
  }

  std::int32_t raw_value(CellId c, std::uint32_t shape) const {
    const auto list = raw(c);
    const auto at = std::lower_bound(list.begin(), list.end(), SignedEntry{shape, 0},
                                     [](const auto& a, const auto& b) { return a.id < b.id; });
    return at != list.end() && at->id == shape ? at->value : 0;
  }

  /// Returns what to add to the labels of a component, ascending. They are zero at its root until
  /// then.
  std::vector<SignedEntry> shift_of(const Range& r) const {
    std::vector<SignedEntry> usual = usual_shift_of(r), given;
    const std::uint32_t here = component(order_[r.begin].cell);
    const auto first = std::ranges::lower_bound(
        levels_, here, {}, [&](const CellLevel& l) { return component(l.cell); });
    for (auto l = first; l != levels_.end() && component(l->cell) == here; ++l) {
      if (labels_.separation[l->shape].mod_2) {
        const std::int64_t by = std::int64_t{l->label} - raw_value(l->cell, l->shape);
        given.push_back({l->shape, entry_value(by)});
      }
    }
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

  /// Reduces entries from `from` on to parities, for shapes that separate modulo 2 only.
  void keep_parity(std::vector<SignedEntry>& list, std::size_t from) const {
    std::size_t kept = from;
    for (std::size_t i = from; i < list.size(); ++i) {
      SignedEntry e = list[i];
      if (!labels_.separation[e.id].over_z) e.value &= 1;
      if (e.value != 0) list[kept++] = e;
    }
    list.resize(kept);
  }

  /// Adds the shift of each component to the labels of its cells, and lists them by cell.
  void shift() {
    labels_.begin.assign(cells_.size() + 1, 0);
    std::vector<SignedEntry> shifted;
    std::vector<Place> places(cells_.size());
    for (std::size_t i = 0, j = 0; i < order_.size(); i = j) {
      Range r{i, i + 1, false};
      while (r.end < order_.size() && order_[r.end].edge != kNone) ++r.end;
      j = r.end;
      for (std::size_t k = i; k < j; ++k) {
        if (cells_.is_at_border[order_[k].cell.value()] != 0) r.has_border = true;
      }
      const std::vector<SignedEntry> by = shift_of(r);
      for (std::size_t k = i; k < j; ++k) {
        const CellId c = order_[k].cell;
        const auto begin = static_cast<std::uint32_t>(shifted.size());
        append_sum(raw(c), by, 1, shifted);
        if (!levels_.empty()) keep_parity(shifted, begin);
        if (charge_.grow_to(shifted.size())) {
          context_.checkpoint("labels", shifted.size(), shifted.size());
        }
        places[c.value()] = {begin, static_cast<std::uint32_t>(shifted.size())};
      }
    }
    context_.charge_memory(shifted.size() * sizeof(SignedEntry), "labels");
    labels_.entries.reserve(shifted.size());
    for (std::size_t c = 0; c < cells_.size(); ++c) {
      labels_.entries.insert(labels_.entries.end(), shifted.begin() + places[c].begin,
                             shifted.begin() + places[c].end);
      labels_.begin[c + 1] = static_cast<std::uint32_t>(labels_.entries.size());
    }
  }

  const SurfaceCells& cells_;
  const CellJumps& jumps_;
  CellId outside_;
  std::vector<CellLevel> levels_;  // Sorted by component of the mesh and shape.
  Context& context_;
  MemoryCharge working_;
  ListCharge charge_;
  std::vector<std::uint32_t> edges_begin_;  // Per cell.
  std::vector<std::uint32_t> edges_of_;
  std::vector<Step> order_;  // Cells, parents first, component by component.
  std::vector<std::uint32_t> parent_edge_;
  std::vector<Place> place_;      // Range in raw_ for each cell.
  std::vector<SignedEntry> raw_;  // Labels with zero at the root.
  std::vector<SignedEntry> scratch_;
  std::vector<SignedEntry> error_;
  CellLabels labels_;
};

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
  return Labeller(cells, jumps, shapes, outside, levels, context).run();
}

}  // namespace plumb
