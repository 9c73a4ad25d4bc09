// Lists the cells on each shell.
//
// The classes of ShellNodes (volumes.h) are the shells. Sides of facets, free edges, corners and
// isolated vertices are listed with the root of their class, cells of the frame left out; sorting
// drops repetitions. Shells are ordered by volume, then by their lexicographically least vertex: of
// all shells of a bounded volume, the outer shell has the least vertex, so it comes first.
//
// Tested by tests/space/nef3_queries_test.cpp.

#include "plumb/space/space_shells.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <utility>

#include "plumb/predicates/error.h"
#include "plumb/predicates/point3_signs.h"
#include "plumb/space/query/volumes.h"

namespace plumb {
namespace {

/// A cell, and the root of its shell.
template <class Item>
using OnShell = std::pair<std::uint32_t, Item>;

/// Lists the cells of shells, without the frame.
class ShellLister {
 public:
  explicit ShellLister(const SpaceComplex& complex) : complex_(complex), nodes_(complex) {}

  void run() {
    for (std::uint32_t f = 0; f < complex_.facet_count(); ++f) list_sides(FacetId(f));
    for (std::uint32_t e = 0; e < complex_.edge_count(); ++e) list_edge(EdgeId(e));
    for (std::uint32_t u = 0; u < complex_.use_count(); ++u) list_corner(UseId(u));
    for (std::uint32_t v = 0; v < complex_.vertex_count(); ++v) list_vertex(VertexId(v));
    sort_once(vertices_);
    sort_once(edges_);
    sort_once(shells_);
    sort_by_least_vertex();
  }

  std::vector<OnShell<FacetSide>> sides_;
  std::vector<OnShell<EdgeId>> edges_;
  std::vector<OnShell<VertexId>> vertices_;
  std::vector<OnShell<VolumeId>> shells_;  ///< Shells that bound a part off the frame.

 private:
  void list_sides(FacetId f) {
    if (complex_.facet_mark[f] == kBeyond) return;
    for (const bool is_negative : {false, true}) {
      const std::uint32_t shell = nodes_.root(ShellNodes::facet_node(f, is_negative));
      sides_.push_back({shell, {f, !is_negative}});
      shells_.push_back({shell, complex_.facet_volume[f][is_negative ? 1 : 0]});
      for (const VertexId v : complex_.inner_of(f)) vertices_.push_back({shell, v});
    }
  }

  void list_edge(EdgeId e) {
    if (complex_.edge_mark[e] == kBeyond) return;
    if (const std::uint32_t node = nodes_.free_node(e); node != kNone) {
      const std::uint32_t shell = nodes_.root(node);
      edges_.push_back({shell, e});
      shells_.push_back({shell, complex_.edge_volume[e]});
      for (const std::uint32_t h : {2 * e.value(), 2 * e.value() + 1}) {
        list(complex_.origin[h], shell);
      }
    }
  }

  /// Lists the edge and the origin of a use on both shells beside it.
  void list_corner(UseId u) {
    const EdgeId e = SpaceComplex::edge_of(complex_.use_halfedge[u]);
    for (const std::uint32_t node : {nodes_.node_after(u), nodes_.node_before(u)}) {
      const std::uint32_t shell = nodes_.root(node);
      if (complex_.edge_mark[e] != kBeyond) edges_.push_back({shell, e});
      list(complex_.use_origin(u), shell);
    }
  }

  void list_vertex(VertexId v) {
    if (!complex_.vertex_volume[v].is_valid()) return;
    const std::uint32_t shell = nodes_.root(nodes_.vertex_node(v));
    vertices_.push_back({shell, v});
    shells_.push_back({shell, complex_.vertex_volume[v]});
  }

  void list(VertexId v, std::uint32_t shell) {
    if (complex_.vertex_mark[v] != kBeyond) vertices_.push_back({shell, v});
  }

  /// Returns the least vertex of each shell, by its root; invalid if it has none.
  std::vector<VertexId> least_vertices() const {
    std::vector<VertexId> least(nodes_.size());
    for (const auto& [root, v] : vertices_) {
      VertexId& known = least[root];
      if (!known.is_valid() || compare(v, known) == Sign::Negative) known = v;
    }
    return least;
  }

  void sort_by_least_vertex() {
    const std::vector<VertexId> least = least_vertices();
    std::sort(shells_.begin(), shells_.end(), [&](const auto& a, const auto& b) {
      if (a.second != b.second) return a.second < b.second;
      // Shells of one volume have different least vertices. Shells without vertices (at infinity)
      // are an exception, and come last.
      const VertexId v = least[a.first], w = least[b.first];
      if (v.is_valid() != w.is_valid()) return v.is_valid();
      const Sign order = v.is_valid() ? compare(v, w) : Sign::Zero;
      return order != Sign::Zero ? order == Sign::Negative : a.first < b.first;
    });
  }

  Sign compare(VertexId v, VertexId w) const {
    return compare_xyz(complex_.points(), complex_.vertex_point[v], complex_.vertex_point[w]);
  }

  /// Sorts the list, and removes repetitions.
  template <class Item>
  static void sort_once(std::vector<OnShell<Item>>& items) {
    std::sort(items.begin(), items.end());
    items.erase(std::unique(items.begin(), items.end()), items.end());
  }

  const SpaceComplex& complex_;
  ShellNodes nodes_;
};

/// Lists the cells of each shell one after the other in `all`, with their starts in `begin`.
template <class Item>
void group(const std::vector<OnShell<Item>>& items, const std::vector<ShellId>& id_of,
           std::size_t shells, std::vector<Item>& all, std::vector<std::uint32_t>& begin) {
  begin.assign(shells + 1, 0);
  for (const auto& [root, item] : items) ++begin[id_of[root].value() + 1];
  std::partial_sum(begin.begin(), begin.end(), begin.begin());
  std::vector<std::uint32_t> at(begin.begin(), begin.end() - 1);
  all.resize(items.size());
  for (const auto& [root, item] : items) all[at[id_of[root].value()]++] = item;
}

}  // namespace

SpaceShells::SpaceShells(const SpaceComplex& complex) : complex_(complex) {
  ShellLister lister(complex);
  lister.run();
  // The shells are sorted now, so their ids have the same order, and the shells of each volume are
  // consecutive.
  std::vector<ShellId> id_of(2 * complex.facet_count() + complex.vertex_count());
  volume_begin_.assign(complex.volume_count() + 1, 0);
  for (const auto& [root, volume] : lister.shells_) {
    id_of[root] = ShellId(ids_.size());
    ids_.push_back(id_of[root]);
    volume_.push_back(volume);
    ++volume_begin_[volume.value() + 1];
  }
  std::partial_sum(volume_begin_.begin(), volume_begin_.end(), volume_begin_.begin());
  group(lister.sides_, id_of, size(), sides_, side_begin_);
  group(lister.edges_, id_of, size(), edges_, edge_begin_);
  group(lister.vertices_, id_of, size(), vertices_, vertex_begin_);
}

std::span<const ShellId> SpaceShells::shells_of(VolumeId v) const {
  const std::uint32_t begin = volume_begin_[v.value()];
  return std::span(ids_).subspan(begin, volume_begin_[v.value() + 1] - begin);
}

namespace {

/// Marks all cells, or gives them the marks of the set.
template <class Id>
void set_marks(std::span<const Id> items, const std::vector<Mark>& own, ShellMarks marks,
               std::vector<Mark>& out) {
  for (const Id i : items) out[i.value()] = marks == ShellMarks::All ? Mark{1} : own[i.value()];
}

}  // namespace

MeshOfComplex mesh_of_shell(const SpaceShells& shells, ShellId s, ShellSolid solid,
                            const ToMeshOptions& options, Context& context) {
  std::vector<FacetSide> sides(shells.sides(s).begin(), shells.sides(s).end());
  for (FacetSide& side : sides) {
    if (is_unbounded(shells.complex(), side.facet)) {
      throw Error(ErrorCode::BadArgument, "a shell that reaches to infinity has no mesh");
    }
    // The sides on which the volume of the shell is treated as the solid are listed.
    if (solid == ShellSolid::Other) side.is_reversed = !side.is_reversed;
  }
  return mesh_of_sides(shells.complex(), sides, options, context);
}

Nef3 set_of_shell(const Nef3& set, const SpaceShells& shells, ShellId s, ShellMarks marks,
                  Context& context) {
  const SpaceComplex& c = set.complex();
  SpaceMarks own{std::vector<Mark>(c.vertex_count(), 0), std::vector<Mark>(c.edge_count(), 0),
                 std::vector<Mark>(c.facet_count(), 0), std::vector<Mark>(c.volume_count(), 0)};
  for (const FacetSide& side : shells.sides(s)) {
    const std::size_t f = side.facet.value();
    own.facet[f] = marks == ShellMarks::All ? Mark{1} : c.facet_mark[f];
  }
  set_marks(shells.edges(s), c.edge_mark, marks, own.edge);
  set_marks(shells.vertices(s), c.vertex_mark, marks, own.vertex);
  return set.with_marks(own, context);
}

}  // namespace plumb
