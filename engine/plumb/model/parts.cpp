#include "plumb/model/parts.h"

#include <algorithm>

#include "plumb/base/internal/union_find.h"

namespace plumb {
namespace {

/// Numbers for all cells of a complex: volumes, facets, edges and vertices.
class CellNumbers {
 public:
  explicit CellNumbers(const SpaceComplex& c)
      : facets_(c.volume_count()),
        edges_(facets_ + c.facet_count()),
        vertices_(edges_ + c.edge_count()),
        size_(vertices_ + c.vertex_count()) {}

  std::uint32_t of(VolumeId v) const { return v.value(); }
  std::uint32_t of(FacetId f) const { return number(facets_, f.value()); }
  std::uint32_t of(EdgeId e) const { return number(edges_, e.value()); }
  std::uint32_t of(VertexId v) const { return number(vertices_, v.value()); }
  std::size_t size() const { return size_; }

 private:
  static std::uint32_t number(std::size_t first, std::uint32_t i) {
    return static_cast<std::uint32_t>(first + i);
  }
  std::size_t facets_, edges_, vertices_, size_;
};

/// The equivalence classes of marked cells. Two cells are equivalent if one is contained in the
/// boundary of the other.
class Components {
 public:
  explicit Components(const SpaceComplex& c) : c_(c), numbers_(c), classes_(numbers_.size()) {
    for (std::uint32_t f = 0; f < c.facet_count(); ++f) join_facet(FacetId(f));
    for (std::uint32_t e = 0; e < c.edge_count(); ++e) join_edge(EdgeId(e));
    for (std::uint32_t v = 0; v < c.vertex_count(); ++v) join_vertex(VertexId(v));
  }

  /// Numbers the components in the order of their least cells, and returns their count.
  std::uint32_t number_them() {
    number_.assign(numbers_.size(), kNoComponent);
    std::uint32_t count = 0;
    for_each_marked([&](auto cell, std::vector<Mark> SpaceMarks::*) {
      std::uint32_t& n = number_[classes_.root(numbers_.of(cell))];
      if (n == kNoComponent) n = count++;
    });
    return count;
  }
  /// Returns the marks of the cells of one component.
  SpaceMarks marks_of(std::uint32_t component) {
    SpaceMarks marks{std::vector<Mark>(c_.vertex_count()), std::vector<Mark>(c_.edge_count()),
                     std::vector<Mark>(c_.facet_count()), std::vector<Mark>(c_.volume_count())};
    for_each_marked([&](auto cell, std::vector<Mark> SpaceMarks::*list) {
      if (number_[classes_.root(numbers_.of(cell))] == component) (marks.*list)[cell.value()] = 1;
    });
    return marks;
  }

 private:
  static constexpr std::uint32_t kNoComponent = 0xffffffff;

  /// Calls visit(cell, list of its marks) for all marked cells, volumes first.
  template <class Visit>
  void for_each_marked(const Visit& visit) const {
    for_each_marked_of<VolumeId>(c_.volume_count(), &SpaceMarks::volume, visit);
    for_each_marked_of<FacetId>(c_.facet_count(), &SpaceMarks::facet, visit);
    for_each_marked_of<EdgeId>(c_.edge_count(), &SpaceMarks::edge, visit);
    for_each_marked_of<VertexId>(c_.vertex_count(), &SpaceMarks::vertex, visit);
  }
  template <class Id, class Visit>
  void for_each_marked_of(std::size_t count, std::vector<Mark> SpaceMarks::*list,
                          const Visit& visit) const {
    for (std::uint32_t i = 0; i < count; ++i) {
      if (is_marked(Id(i))) visit(Id(i), list);
    }
  }
  bool is_marked(VolumeId v) const { return c_.volume_mark[v] == 1; }
  bool is_marked(FacetId f) const { return c_.facet_mark[f] == 1; }
  bool is_marked(EdgeId e) const { return c_.edge_mark[e] == 1; }
  bool is_marked(VertexId v) const { return c_.vertex_mark[v] == 1; }

  template <class A, class B>
  void join(A a, B b) {
    if (a.is_valid() && b.is_valid() && is_marked(a) && is_marked(b)) {
      classes_.unite(numbers_.of(a), numbers_.of(b));
    }
  }
  void join_facet(FacetId f) {
    for (const VolumeId v : c_.facet_volume[f]) join(f, v);
  }
  /// Joins an edge or a vertex with the facets and volumes around an edge.
  template <class Cell>
  void join_around(Cell cell, EdgeId e) {
    join(cell, c_.edge_volume[e]);
    const UseId first = c_.edge_use[e];
    if (!first.is_valid()) return;
    UseId u = first;
    do {
      join(cell, c_.use_facet[u]);
      join(cell, c_.volume_after(u));
      u = c_.use_radial[u];
    } while (u != first);
  }
  void join_edge(EdgeId e) { join_around(e, e); }
  void join_vertex(VertexId v) {
    join(v, c_.vertex_volume[v]);
    const FacetId around = c_.vertex_facet[v];
    join(v, around);
    if (around.is_valid()) {
      for (const VolumeId volume : c_.facet_volume[around]) join(v, volume);
    }
    for (const HalfedgeId h : c_.star_of(v)) {
      const EdgeId e = SpaceComplex::edge_of(h);
      join(v, e);
      join_around(v, e);
    }
  }

  const SpaceComplex& c_;
  CellNumbers numbers_;
  UnionFind classes_;
  std::vector<std::uint32_t> number_;  ///< The component of each root.
};

std::size_t count_of_surfaces(const SpaceComplex& c) {
  UnionFind facets(c.facet_count());
  std::size_t count = c.facet_count();
  for (std::uint32_t u = 0; u < c.use_count(); ++u) {
    const FacetId a = c.use_facet[UseId(u)], b = c.use_facet[c.use_radial[UseId(u)]];
    if (facets.unite(a.value(), b.value())) --count;
  }
  return count;
}

}  // namespace

std::vector<Nef3> components(const Nef3& set, Context& context) {
  std::vector<Nef3> parts;
  MemoryCharge memory(context);
  Components found(set.complex());
  const std::uint32_t count = found.number_them();
  if (count == 1) return {set};
  for (std::uint32_t i = 0; i < count; ++i) {
    context.checkpoint("components", i, count);
    parts.push_back(set.with_marks(found.marks_of(i), context));
    memory.add(parts.back().bytes(), "components");
  }
  return parts;
}

// A facet with k borders is a sphere with k holes, whose Euler characteristic is 2 - k. A closed
// surface of genus g has the Euler characteristic 2 - 2 g.
std::optional<std::uint64_t> genus(const Nef3& set) {
  if (!set.is_bounded() || !set.is_simple()) return std::nullopt;
  const SpaceComplex& c = set.complex();
  const auto count = [](std::size_t n) { return static_cast<std::int64_t>(n); };
  const std::int64_t characteristic = count(c.vertex_count()) - count(c.edge_count()) +
                                      2 * count(c.facet_count()) - count(c.cycle.size());
  return static_cast<std::uint64_t>(count(count_of_surfaces(c)) - characteristic / 2);
}

}  // namespace plumb
