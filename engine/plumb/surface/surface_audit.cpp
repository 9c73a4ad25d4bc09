// An independent check of a divided surface, from its definition rather than from the code that
// made it.
//
// Seven steps, each on the whole division: links (next is a permutation within pieces, twins
// agree), faces (each touched face has as many pieces as Euler's formula says, and their areas add
// up), flow (no polygon ends at a node), places (no two nodes of a face coincide, exactly), cells
// (no two cells without an arc between them, and the graph of cells is complete), labels (the jump
// across every arc is that of its shapes), and certificates (the cycle of a shape without labels
// changes the label by a number that is not 0, odd if there is no label modulo 2). The last two
// make both outcomes of label_cells() certain: see docs/design/surface.md, section Labels.
//
// In the spirit of K. Mehlhorn, S. Näher et al., Checking geometric programs or verification of
// geometric structures, Computational Geometry 12 (1999).
// Tested by tests/surface/surface_arrangement_test.cpp, which audits every division it makes.
#include "plumb/surface/surface_audit.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include "plumb/base/internal/union_find.h"
#include "plumb/surface/cells/surface_arrangement.h"
#include "plumb/surface/cells/surface_cells.h"

namespace plumb {
namespace {

using Flaw = std::optional<std::string>;

std::string at(const char* what, std::size_t i) {
  return std::string(" at ") + what + " " + std::to_string(i);
}

class SurfaceAudit {
 public:
  explicit SurfaceAudit(const SurfaceDivision& division)
      : d_(division), a_(division.arrangement()), cells_(division.cells()) {}

  Flaw run() const {
    for (const auto step :
         {&SurfaceAudit::links, &SurfaceAudit::faces, &SurfaceAudit::flow, &SurfaceAudit::places,
          &SurfaceAudit::cells, &SurfaceAudit::labels, &SurfaceAudit::certificates}) {
      if (Flaw flaw = (this->*step)()) return flaw;
    }
    return std::nullopt;
  }

 private:
  // ---------------------------------------------------------------- 1. links

  Flaw links() const {
    const std::size_t n = a_.halfedge_count();
    if (a_.twin.size() != n || a_.next.size() != n || a_.piece.size() != n || a_.arc.size() != n) {
      return "sizes of half-edge arrays";
    }
    IdVector<HalfedgeId, std::uint8_t> is_next(n);
    for (std::size_t i = 0; i < n; ++i) {
      const HalfedgeId next = a_.next[i], twin = a_.twin[i];
      if (next.value() >= n || is_next[next]++ != 0)
        return "next is no permutation" + at("half-edge", i);
      if (a_.piece[next] != a_.piece[i]) return "next leaves the piece" + at("half-edge", i);
      if (a_.origin[i].value() >= a_.node_count()) return "no such node" + at("half-edge", i);
      if (!twin.is_valid()) continue;
      if (twin.value() >= n || a_.twin[twin].value() != i) return "twin" + at("half-edge", i);
      if (a_.origin[twin] != a_.target(HalfedgeId(i))) return "twin's origin" + at("half-edge", i);
      if (a_.arc[twin] != a_.arc[i]) return "twin's arc" + at("half-edge", i);
    }
    for (std::size_t i = 0; i < a_.arc_count(); ++i) {
      if (a_.arc[a_.arc_halfedge[i]].value() != i) return "half-edge of arc" + at("arc", i);
      if (a_.multiplicities(ArcId(i)).empty()) return "no polygon" + at("arc", i);
    }
    return std::nullopt;
  }

  // ---------------------------------------------------------------- 2. faces

  Flaw faces() const {
    std::size_t loops = 0;
    for (std::uint32_t slot = 0; slot < a_.slot_face.size(); ++slot) {
      const std::uint32_t begin = a_.sides_begin(slot);
      const auto end = slot + 1 < a_.slot_face.size()
                           ? a_.sides_begin(slot + 1)
                           : static_cast<std::uint32_t>(a_.halfedge_count());
      const std::uint32_t pieces = a_.piece_begin[slot + 1].value() - a_.piece_begin[slot].value();
      if (count_pieces(begin, a_.arcs_begin(slot), end) != pieces)
        return "Euler" + at("face", slot);
      double share = 0;
      for (std::uint32_t p = a_.piece_begin[slot].value(); p < a_.piece_begin[slot + 1].value();
           ++p) {
        share += a_.piece_share[p];
        if (a_.piece_slot[p] != slot) return "slot" + at("piece", p);
      }
      if (std::fabs(share - 1) > 1e-9) return "areas of pieces" + at("face", slot);
      loops += count_loops(begin, end);
    }
    return loops == a_.loop.size() ? std::nullopt : Flaw("loops");
  }
  /// Returns E - V + C: a planar subdivision has E - V + C + 1 faces, one of which is the outside.
  std::uint32_t count_pieces(std::uint32_t begin, std::uint32_t arcs, std::uint32_t end) const {
    std::map<NodeId, std::uint32_t> local;
    for (std::uint32_t h = begin; h < end; ++h) {
      local.emplace(a_.origin[h], static_cast<std::uint32_t>(local.size()));
    }
    UnionFind parts(local.size());
    auto components = static_cast<std::uint32_t>(local.size());
    for (std::uint32_t h = begin; h < end; ++h) {
      const std::uint32_t i = parts.root(local.at(a_.origin[h]));
      const std::uint32_t j = parts.root(local.at(a_.target(HalfedgeId(h))));
      if (i == j) continue;
      parts.unite(i, j);
      --components;
    }
    const std::uint32_t edges = (arcs - begin) + (end - arcs) / 2;
    return edges - static_cast<std::uint32_t>(local.size()) + components;
  }
  std::size_t count_loops(std::uint32_t begin, std::uint32_t end) const {
    std::vector<std::uint8_t> is_seen(end - begin);
    std::size_t loops = 0;
    for (std::uint32_t first = begin; first < end; ++first) {
      if (is_seen[first - begin] != 0) continue;
      ++loops;
      for (std::uint32_t h = first; is_seen[h - begin]++ == 0;) h = a_.next[h].value();
    }
    return loops;
  }

  // ---------------------------------------------------------------- 3. flow

  Flaw flow() const {
    std::map<std::pair<NodeId, std::uint32_t>, std::int64_t> balance;
    for (std::size_t i = 0; i < a_.arc_count(); ++i) {
      const HalfedgeId h = a_.arc_halfedge[i];
      for (const SignedEntry& e : a_.multiplicities(ArcId(i))) {
        if (e.value == 0 || e.id >= d_.scene().polygons.size())
          return "multiplicity" + at("arc", i);
        balance[{a_.origin[h], e.id}] -= e.value;
        balance[{a_.target(h), e.id}] += e.value;
      }
    }
    for (const auto& [where, sum] : balance) {
      if (sum != 0) return "a polygon ends" + at("node", where.first.value());
    }
    return std::nullopt;
  }

  // ---------------------------------------------------------------- 4. places

  Flaw places() const {
    std::map<FaceId, std::vector<RationalPoint2>> in_face;
    for (const SurfaceCrossing& c : a_.crossings) {
      const RationalPoint2 p = exact_crossing(a_, d_.scene().polygons.points, c);
      if (p.x <= 0 || p.y <= 0 || p.x + p.y >= 1) return "a crossing outside its face";
      in_face[c.face].push_back(p);
    }
    // Points of polygons that cancel may lie anywhere.
    IdVector<NodeId, std::uint8_t> is_used(a_.node_count());
    for (const NodeId n : a_.origin) is_used[n] = 1;
    for (std::size_t n = 0; n < a_.node_point.size(); ++n) {
      const SurfacePointTable& points = d_.scene().polygons.points;
      if (is_used[n] == 0 || points.place(a_.node_point[n]) != SurfacePlace::Face) continue;
      in_face[points.face(a_.node_point[n])].push_back(points.exact(a_.node_point[n]));
    }
    for (auto& [face, list] : in_face) {
      const auto is_before = [](const RationalPoint2& p, const RationalPoint2& q) {
        return p.x != q.x ? p.x < q.x : p.y < q.y;
      };
      std::sort(list.begin(), list.end(), is_before);
      if (std::adjacent_find(list.begin(), list.end()) != list.end()) {
        return "two nodes in one place" + at("face", face.value());
      }
    }
    return std::nullopt;
  }

  // ---------------------------------------------------------------- 5. cells

  CellId cell(HalfedgeId h) const { return cells_.of_piece[a_.piece[h]]; }

  Flaw cells() const {
    std::vector<std::pair<CellId, CellId>> pairs;
    for (std::size_t i = 0; i < a_.halfedge_count(); ++i) {
      const HalfedgeId h(i), t = a_.twin[i];
      if (!t.is_valid()) continue;
      if (!a_.arc[i].is_valid()) {
        if (cell(h) != cell(t)) return "cells without arc between" + at("half-edge", i);
      } else {
        pairs.push_back(std::minmax(cell(h), cell(t)));
      }
    }
    for (const CellEdge& e : cells_.edges) {
      if (e.to < e.from) return std::string("cell edge");
    }
    std::sort(pairs.begin(), pairs.end());
    pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
    std::vector<std::pair<CellId, CellId>> listed;
    for (const CellEdge& e : cells_.edges) listed.emplace_back(e.from, e.to);
    listed.erase(std::unique(listed.begin(), listed.end()), listed.end());
    if (listed != pairs) return "graph of cells";
    return std::nullopt;
  }

  // ---------------------------------------------------------------- 6. labels

  using Sparse = std::map<std::uint32_t, std::int64_t>;

  Flaw labels() const {
    for (std::size_t i = 0; i < a_.arc_count(); ++i) {
      const HalfedgeId h = a_.arc_halfedge[i], t = a_.twin[h];
      if (!t.is_valid()) continue;
      Sparse jump = jump_of(ArcId(i));
      for (const SignedEntry& e : d_.labels(cell(h))) jump[e.id] -= e.value;
      for (const SignedEntry& e : d_.labels(cell(t))) jump[e.id] += e.value;
      for (const auto& [shape, error] : jump) {
        const Separation& s = d_.shape_separation(shape);
        if (s.over_z ? error != 0 : (s.mod_2 && error % 2 != 0)) return "label" + at("arc", i);
      }
    }
    for (std::uint32_t c = 0; c < d_.cell_count(); ++c) {
      for (const SignedEntry& e : d_.labels(CellId(c))) {
        const Separation& s = d_.shape_separation(e.id);
        if (e.value == 0 || (!s.over_z && !s.mod_2)) return "label" + at("cell", c);
      }
    }
    return std::nullopt;
  }
  Sparse jump_of(ArcId a) const {
    Sparse polygons, jump;
    for (const SignedEntry& e : a_.multiplicities(a)) polygons[e.id] = e.value;
    if (!d_.scene().shapes) return polygons;
    const auto& shapes = *d_.scene().shapes;
    for (std::uint32_t s = 0; s < shapes.size(); ++s) {
      for (const std::uint32_t p : shapes[s]) {
        if (const auto found = polygons.find(p); found != polygons.end()) jump[s] += found->second;
      }
    }
    return jump;
  }

  Flaw certificates() const {
    for (std::uint32_t s = 0; s < d_.shape_count(); ++s) {
      const Separation& how = d_.shape_separation(s);
      if (how.over_z) continue;
      const std::optional<CycleSums> sums = sums_around(how.cycle, polygons_of(s));
      if (!sums) return "no cycle" + at("shape", s);
      if (sums->least == 0 && sums->most == 0)
        return "a cycle that proves nothing" + at("shape", s);
      if (!how.mod_2 && !sums->can_be_odd) return "a cycle that is even" + at("shape", s);
    }
    return std::nullopt;
  }

  /// Returns how often each polygon occurs in a shape.
  Sparse polygons_of(std::uint32_t shape) const {
    if (!d_.scene().shapes) return {{shape, 1}};
    Sparse times;
    for (const std::uint32_t p : (*d_.scene().shapes)[shape]) ++times[p];
    return times;
  }

  /// The amount by which the label would change around a cycle of cells. Two cells may have
  /// different arcs between them, so the amount is a range.
  struct CycleSums {
    std::int64_t least = 0, most = 0;
    bool can_be_even = true, can_be_odd = false;
  };
  // Each step of the cycle may take any of the arcs between its two cells. Parities are combined as
  // sets: which parities a sum over the steps so far can have.
  std::optional<CycleSums> sums_around(const std::vector<CellId>& cycle,
                                       const Sparse& times) const {
    if (cycle.empty()) return std::nullopt;
    CycleSums sums;
    for (std::size_t i = 0; i < cycle.size(); ++i) {
      const CellId c = cycle[i], d = cycle[(i + 1) % cycle.size()];
      const std::vector<std::int64_t> jumps = jumps_between(c, d, times);
      if (jumps.empty()) return std::nullopt;
      const auto [least, most] = std::ranges::minmax(jumps);
      sums.least += least;
      sums.most += most;
      const auto is_odd = [](std::int64_t jump) { return jump % 2 != 0; };
      const bool some_odd = std::ranges::any_of(jumps, is_odd);
      const bool some_even = !std::ranges::all_of(jumps, is_odd);
      const bool even = (sums.can_be_even && some_even) || (sums.can_be_odd && some_odd);
      sums.can_be_odd = (sums.can_be_odd && some_even) || (sums.can_be_even && some_odd);
      sums.can_be_even = even;
    }
    return sums;
  }
  std::vector<std::int64_t> jumps_between(CellId c, CellId d, const Sparse& times) const {
    const auto [low, high] = std::minmax(c, d);
    const std::pair ends(low, high);
    std::vector<std::int64_t> jumps;
    const auto first = std::ranges::lower_bound(
        cells_.edges, ends, {}, [](const CellEdge& e) { return std::pair(e.from, e.to); });
    for (auto edge = first; edge != cells_.edges.end(); ++edge) {
      const CellEdge& e = *edge;
      if (std::pair(e.from, e.to) != ends) break;
      std::int64_t jump = 0;
      for (const SignedEntry& m : a_.bundles[e.bundle]) {
        const auto found = times.find(m.id);
        if (found != times.end()) jump += found->second * m.value * e.sign;
      }
      if (c == e.from) jumps.push_back(jump);
      if (c == e.to) jumps.push_back(-jump);
    }
    return jumps;
  }

  const SurfaceDivision& d_;
  const SurfaceArrangement& a_;
  const SurfaceCells& cells_;
};

}  // namespace

std::optional<std::string> audit(const SurfaceDivision& division) {
  return SurfaceAudit(division).run();
}

}  // namespace plumb
