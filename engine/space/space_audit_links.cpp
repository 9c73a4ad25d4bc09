// Step 1 of audit(): arrays and ids alone.
#include <algorithm>

#include "plumb/space/space_audit_parts.h"

namespace plumb {
namespace {

class LinkAudit : SpaceAuditPart {
 public:
  LinkAudit(const SpaceComplex& complex, Context& context) : SpaceAuditPart(complex, context, 0) {}

  std::optional<SpaceFlaw> run() {
    // Each step reads only what those before have found to be there.
    static_cast<void>(has_right_sizes() && has_marks() && names_tables() && names_items() &&
                      has_edges_with_two_ends() && has_stars() && has_linked_uses() &&
                      has_radial_cycles() && has_boundary_cycles() && has_inner_vertices() &&
                      has_volumes_where_needed());
    return flaw_;
  }

 private:
  // ---- sizes and ids

  bool has_right_sizes() {
    const std::size_t v = c_.vertex_count(), e = c_.edge_count(), u = c_.use_count(),
                      f = c_.facet_count();
    const bool right =
        c_.tables && c_.vertex_mark.size() == v && c_.vertex_volume.size() == v &&
        c_.vertex_facet.size() == v && c_.edge_mark.size() == e && c_.edge_use.size() == e &&
        c_.edge_volume.size() == e && c_.origin.size() == 2 * e && c_.use_next.size() == u &&
        c_.use_prev.size() == u && c_.use_radial.size() == u && c_.use_facet.size() == u &&
        c_.facet_mark.size() == f && c_.facet_volume.size() == f && c_.facet_origin.size() == f;
    return require(right, "arrays have one entry for each item") &&
           require(c_.volume_count() > 0, "there is a volume") &&
           require(has_rows(c_.star_begin, v, c_.star.size()) &&
                       has_rows(c_.cycle_begin, f, c_.cycle.size()) &&
                       has_rows(c_.inner_begin, f, c_.inner.size()),
                   "lists cover their arrays");
  }
  static bool has_rows(const std::vector<std::uint32_t>& begin, std::size_t rows,
                       std::size_t entries) {
    return begin.size() == rows + 1 && begin.front() == 0 && begin.back() == entries &&
           std::is_sorted(begin.begin(), begin.end());
  }

  bool has_marks() {
    for (const auto* marks : {&c_.vertex_mark, &c_.edge_mark, &c_.facet_mark, &c_.volume_mark}) {
      const bool known =
          std::all_of(marks->begin(), marks->end(), [](Mark m) { return m <= kBeyond; });
      if (!require(known, "marks are 0, 1 or beyond")) return false;
    }
    return true;
  }

  bool names_tables() {
    const auto is_plane = [this](PlaneId p) { return p.value() < c_.planes().size(); };
    for (std::uint32_t v = 0; v < c_.vertex_count(); ++v) {
      const SpacePoint p = c_.vertex_point[v];
      const bool known =
          p.is_valid() && (p.is_input() ? p.input().value() < c_.planes().points().size()
                                        : p.index() < c_.points().size());
      if (!require(known, "a vertex has a point", VertexId(v))) return false;
    }
    for (std::uint32_t e = 0; e < c_.edge_count(); ++e) {
      const auto& [p, q] = c_.edge_planes[e];
      if (!require(is_plane(p) && is_plane(q), "an edge has two planes", EdgeId(e))) return false;
    }
    for (std::uint32_t f = 0; f < c_.facet_count(); ++f) {
      if (!require(is_plane(c_.facet_plane[f]), "a facet has a plane", FacetId(f))) return false;
    }
    return true;
  }

  template <class Id>
  static bool are_below(const std::vector<Id>& ids, std::size_t end, bool may_be_invalid) {
    return std::all_of(ids.begin(), ids.end(),
                       [&](Id id) { return id.is_valid() ? id.value() < end : may_be_invalid; });
  }
  bool names_items() {
    bool right = are_below(c_.star, c_.origin.size(), false) &&
                 are_below(c_.origin, c_.vertex_count(), false) &&
                 are_below(c_.edge_use, c_.use_count(), true) &&
                 are_below(c_.use_halfedge, c_.origin.size(), false) &&
                 are_below(c_.use_next, c_.use_count(), false) &&
                 are_below(c_.use_prev, c_.use_count(), false) &&
                 are_below(c_.use_radial, c_.use_count(), false) &&
                 are_below(c_.use_facet, c_.facet_count(), false) &&
                 are_below(c_.cycle, c_.use_count(), false) &&
                 are_below(c_.inner, c_.vertex_count(), false) &&
                 are_below(c_.vertex_facet, c_.facet_count(), true) &&
                 are_below(c_.vertex_volume, c_.volume_count(), true) &&
                 are_below(c_.edge_volume, c_.volume_count(), true);
    for (const auto& sides : c_.facet_volume) {
      for (const VolumeId v : sides) right = right && v.is_valid() && v.value() < c_.volume_count();
    }
    return require(right, "ids name items that are there");
  }

  // ---- links

  bool has_edges_with_two_ends() {
    for (std::uint32_t e = 0; e < c_.edge_count(); ++e) {
      if (!require(c_.origin[2 * e] != c_.origin[2 * e + 1], "an edge has two ends", EdgeId(e))) {
        return false;
      }
    }
    return true;
  }

  bool has_stars() {
    std::vector<std::uint8_t> is_listed(c_.origin.size());
    for (std::uint32_t v = 0; v < c_.vertex_count(); ++v) {
      for (const HalfedgeId h : c_.star_of(VertexId(v))) {
        if (!require(c_.origin[h.value()] == VertexId(v), "a star holds what leaves its vertex",
                     VertexId(v), h) ||
            !require(is_listed[h.value()]++ == 0, "a star lists a half-edge once", VertexId(v),
                     h)) {
          return false;
        }
      }
    }
    return require(c_.star.size() == c_.origin.size(), "each half-edge is in a star");
  }

  bool has_linked_uses() {
    for (std::uint32_t i = 0; i < c_.use_count(); ++i) {
      const UseId u(i);
      const UseId next = c_.use_next[i];
      if (!require(c_.use_prev[next.value()] == u, "prev undoes next", u) ||
          !require(c_.use_origin(next) == c_.target(halfedge(u)),
                   "a use starts where the one before ends", u, next) ||
          !require(facet(next) == facet(u), "a cycle stays with its facet", u, next)) {
        return false;
      }
    }
    return true;
  }

  bool has_radial_cycles() {
    std::vector<std::uint8_t> is_reached(c_.use_count());
    for (std::uint32_t e = 0; e < c_.edge_count(); ++e) {
      const UseId first = c_.edge_use[e];
      if (first.is_valid() && !has_radial_cycle(EdgeId(e), first, is_reached)) return false;
    }
    for (std::uint32_t u = 0; u < c_.use_count(); ++u) {
      if (!require(is_reached[u] != 0, "the radial cycle of an edge has all its uses", UseId(u))) {
        return false;
      }
    }
    return true;
  }
  bool has_radial_cycle(EdgeId e, UseId first, std::vector<std::uint8_t>& is_reached) {
    UseId u = first;
    do {
      if (!require(SpaceComplex::edge_of(halfedge(u)) == e, "a radial cycle stays at its edge", e,
                   u) ||
          !require(is_reached[u.value()]++ == 0, "a radial cycle returns to its start", e, u)) {
        return false;
      }
      u = c_.use_radial[u.value()];
    } while (u != first);
    return true;
  }

  bool has_boundary_cycles() {
    std::vector<std::uint8_t> is_reached(c_.use_count());
    for (std::uint32_t f = 0; f < c_.facet_count(); ++f) {
      if (!require(!c_.cycles_of(FacetId(f)).empty(), "a facet has a boundary", FacetId(f)))
        return false;
      for (const UseId first : c_.cycles_of(FacetId(f))) {
        if (!require(facet(first) == FacetId(f), "a facet lists its own cycles", FacetId(f),
                     first) ||
            !require(is_reached[first.value()] == 0, "a facet lists a cycle once", FacetId(f),
                     first)) {
          return false;
        }
        all_of_cycle(first, [&](UseId u) { return is_reached[u.value()] = 1; });
      }
    }
    for (std::uint32_t u = 0; u < c_.use_count(); ++u) {
      if (!require(is_reached[u] != 0, "each use is on a cycle of its facet", UseId(u)))
        return false;
    }
    return true;
  }

  // ---- free parts

  bool has_inner_vertices() {
    std::size_t inside = 0;
    for (const FacetId f : c_.vertex_facet) inside += f.is_valid() ? 1U : 0U;
    std::vector<std::uint8_t> is_listed(c_.vertex_count());
    for (std::uint32_t f = 0; f < c_.facet_count(); ++f) {
      for (const VertexId v : c_.inner_of(FacetId(f))) {
        if (!require(c_.vertex_facet[v.value()] == FacetId(f),
                     "a facet lists the vertices inside it", FacetId(f), v) ||
            !require(is_listed[v.value()]++ == 0, "a facet lists an inner vertex once", FacetId(f),
                     v)) {
          return false;
        }
      }
    }
    return require(inside == c_.inner.size(), "a vertex inside a facet is listed there");
  }

  bool has_volumes_where_needed() {
    for (std::uint32_t e = 0; e < c_.edge_count(); ++e) {
      if (!require(c_.edge_use[e].is_valid() != c_.edge_volume[e].is_valid(),
                   "an edge has uses or lies in a volume", EdgeId(e))) {
        return false;
      }
    }
    for (std::uint32_t v = 0; v < c_.vertex_count(); ++v) {
      const bool is_alone = c_.star_of(VertexId(v)).empty() && !c_.vertex_facet[v].is_valid();
      if (!require(is_alone == c_.vertex_volume[v].is_valid(), "a vertex alone lies in a volume",
                   VertexId(v))) {
        return false;
      }
    }
    return true;
  }
};

}  // namespace

std::optional<SpaceFlaw> audit_links(const SpaceComplex& complex, Context& context) {
  return LinkAudit(complex, context).run();
}

}  // namespace plumb
