#include "plumb/io/solid/nef3_links.h"

#include <cstdint>
#include <string_view>
#include <vector>

namespace plumb {
namespace {

class LinkCheck {
 public:
  explicit LinkCheck(const SpaceComplex& complex) : c_(complex) {}

  std::string first_flaw() {
    check_edges();
    check_vertices();
    check_uses();
    if (flaw_.empty()) check_radial_cycles();
    if (flaw_.empty()) check_facet_cycles();
    return flaw_;
  }

 private:
  void check_edges();
  void check_vertices();
  void check_uses();
  void check_radial_cycles();
  void check_facet_cycles();
  bool visit_cycle(UseId first, FacetId facet);

  void require(bool holds, std::string_view kind, std::size_t index, std::string_view rule) {
    if (holds || !flaw_.empty()) return;
    flaw_ = std::string(kind) + ' ' + std::to_string(index + 1) + ": " + std::string(rule);
  }

  const SpaceComplex& c_;
  std::vector<std::uint8_t> visited_;  // per use
  std::string flaw_;
};

void LinkCheck::check_edges() {
  for (std::uint32_t e = 0; e < c_.edge_count(); ++e) {
    require(c_.origin[2 * e] != c_.origin[2 * e + 1], "edge", e, "joins a vertex to itself");
    require(c_.edge_planes[e][0] != c_.edge_planes[e][1], "edge", e, "lies on one plane");
    const UseId use = c_.edge_use[e];
    require(use.is_valid() != c_.edge_volume[e].is_valid(), "edge", e,
            "is free in a volume or has uses, one of the two");
    if (!use.is_valid()) continue;
    const HalfedgeId h = c_.use_halfedge[use.value()];
    require(SpaceComplex::edge_of(h) == EdgeId(e), "edge", e, "names a use of another edge");
  }
}

void LinkCheck::check_vertices() {
  for (std::uint32_t v = 0; v < c_.vertex_count(); ++v) {
    const bool is_alone = c_.star_of(VertexId(v)).empty() && !c_.vertex_facet[v].is_valid();
    require(is_alone == c_.vertex_volume[v].is_valid(), "vertex", v,
            "has a volume if nothing else is at it, and only then");
  }
}

/// `use_prev` is the inverse of `use_next`, made by the reader: a permutation if it is complete.
void LinkCheck::check_uses() {
  std::vector<std::uint8_t> is_radial(c_.use_count(), 0);
  for (std::uint32_t u = 0; u < c_.use_count(); ++u) {
    const UseId next = c_.use_next[u];
    const UseId radial = c_.use_radial[u];
    require(c_.use_prev[u].is_valid(), "use", u, "is the next of none");
    require(c_.target(c_.use_halfedge[u]) == c_.use_origin(next), "use", u,
            "does not end where the next begins");
    require(c_.use_facet[u] == c_.use_facet[next.value()], "use", u,
            "is in another facet than the next");
    const HalfedgeId h = c_.use_halfedge[radial.value()];
    require(SpaceComplex::edge_of(h) == SpaceComplex::edge_of(c_.use_halfedge[u]), "use", u,
            "is of another edge than the next around it");
    require(c_.edge_use[SpaceComplex::edge_of(h).value()].is_valid(), "use", u,
            "is of an edge that has none");
    require(is_radial[radial.value()] == 0, "use", radial.value(),
            "follows two uses around its edge");
    is_radial[radial.value()] = 1;
  }
}

/// Requires a permutation: then walking on comes back.
void LinkCheck::check_radial_cycles() {
  std::vector<std::uint32_t> at_edge(c_.edge_count(), 0);
  for (const HalfedgeId h : c_.use_halfedge) ++at_edge[SpaceComplex::edge_of(h).value()];
  for (std::uint32_t e = 0; e < c_.edge_count(); ++e) {
    const UseId first = c_.edge_use[e];
    std::uint32_t around = 0;
    UseId use = first;
    while (first.is_valid() && (around == 0 || use != first)) {
      use = c_.use_radial[use.value()];
      ++around;
    }
    require(around == at_edge[e], "edge", e, "has uses that are not around it");
  }
}

void LinkCheck::check_facet_cycles() {
  visited_.assign(c_.use_count(), 0);
  for (std::uint32_t f = 0; f < c_.facet_count(); ++f) {
    const auto cycles = c_.cycles_of(FacetId(f));
    require(!cycles.empty(), "facet", f, "has no boundary");
    for (const UseId first : cycles) {
      require(visit_cycle(first, FacetId(f)), "facet", f,
              "lists a cycle twice or one of another facet");
    }
  }
  for (std::size_t u = 0; u < visited_.size(); ++u) {
    require(visited_[u] != 0, "use", u, "is on a cycle that its facet does not list");
  }
}

bool LinkCheck::visit_cycle(UseId first, FacetId facet) {
  if (visited_[first.value()] != 0 || c_.use_facet[first.value()] != facet) return false;
  for (UseId use = first; visited_[use.value()] == 0; use = c_.use_next[use.value()]) {
    visited_[use.value()] = 1;
  }
  return true;
}

}  // namespace

std::string flaw_of_links(const SpaceComplex& complex) { return LinkCheck(complex).first_flaw(); }

}  // namespace plumb
