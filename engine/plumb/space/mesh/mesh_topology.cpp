// Borders, components, signed volumes and fans of a mesh.
//
// Borders: the boundary of the sum of all faces is an integer chain. If it is not 0, edges are cut
// at vertices that lie on them, so that parts at equal places cancel. The rest balances at every
// vertex, because it is a boundary, and is followed as closed chains.
//
// Components: facets are joined across plain edges, and then across edges where a component alone
// does not balance. Invariant: every component except the open component balances at each of its
// edges.
//
// Volumes: sums of cones over a fan of every facet, in doubles with an error bound: first from the
// origin with one bound for all cones, then from a corner of the component with a bound for each
// cone, and exactly where that bound is larger than the sum. Jumps give the orientation of the
// facets.
//
// Fans: the comparisons of the header are made for the three axes at once, as bits of one byte.
//
// See docs/design/meshes.md, "Winding numbers", "Components turned inside out" and "Does the mesh
// meet itself?".
// Tested by tests/space/from_mesh_test.cpp, tests/space/mesh_arrangement_test.cpp and
// tests/space/mesh_crossings_test.cpp.

#include "plumb/space/mesh/mesh_topology.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <limits>
#include <numeric>
#include <string_view>
#include <utility>

#include "plumb/base/internal/box_tree.h"
#include "plumb/base/internal/union_find.h"
#include "plumb/predicates/input_predicates.h"
#include "plumb/predicates/point3_signs.h"
#include "plumb/predicates/rational_predicates.h"
#include "plumb/space/complex/space_boxes.h"
#include "plumb/space/planar/facet_site.h"

namespace plumb {
namespace {

using VertexPair = std::array<std::uint32_t, 2>;

/// Reports progress, and stops if the caller requests it, after about every thousand steps.
class StepCounter {
 public:
  StepCounter(std::string_view phase, Context& context) : phase_(phase), context_(context) {}
  void operator()() {
    if (++steps_ % 1024 == 0) context_.checkpoint(phase_, 0, 0);
  }

 private:
  std::string_view phase_;
  Context& context_;
  std::uint64_t steps_ = 0;
};

/// Returns the boundary of the sum of all faces, with the edges of faces without area.
EdgeSurpluses imbalances(const MeshFacets& facets, const MeshLinks& links, MemoryCharge& memory,
                         Context& context) {
  StepCounter step("borders", context);
  EdgeSurpluses surplus;
  for (std::size_t e = 0; e < links.edge_count(); ++e) {
    step();
    std::int32_t sum = 0;
    for (const std::uint32_t u : links.uses_of(e)) {
      // The facet occurs `times` times in its canonical direction, which is counter-clockwise seen
      // from the positive side. If a face has this direction seen from outside, its jump is -1.
      const std::int32_t times = -facets.jump[links.facet[u]];
      sum += links.is_forward(facets, u) ? times : -times;
    }
    if (sum != 0) add_to(surplus, links.end[e][0], links.end[e][1], sum);
  }
  for (const VertexPair& e : facets.loose) add_to(surplus, e[0], e[1], 1);
  memory.add(surplus.size() * sizeof(EdgeSurplus), "the borders of a mesh");
  collect(surplus);
  return surplus;
}

// ---------------------------------------------------------------- edges with vertices on them

/// Finds vertices that lie inside edges.
class InnerVertexSearch {
 public:
  InnerVertexSearch(std::span<const SpacePoint> points, const Point3Table& table,
                    MemoryCharge& memory, Context& context)
      : points_(points),
        table_(table),
        memory_(memory),
        context_(context),
        step_("vertices on edges", context) {}

  /// Finds the ends of all edges that lie inside of an edge. Other vertices need no test, because a
  /// cut there does not change the balance.
  InnerVertices find(std::span<const VertexPair> edges) {
    // The memory of a tree.
    constexpr std::size_t kBytesPerEnd = 2 * sizeof(std::uint32_t) + sizeof(Box3) + 76;
    memory_.add(2 * edges.size() * kBytesPerEnd, "vertices on edges");
    for (const VertexPair& edge : edges) ends_.insert(ends_.end(), edge.begin(), edge.end());
    std::sort(ends_.begin(), ends_.end());
    ends_.erase(std::unique(ends_.begin(), ends_.end()), ends_.end());
    std::vector<Box3> boxes;
    boxes.reserve(ends_.size());
    for (const std::uint32_t v : ends_) {
      step_();
      boxes.push_back(box_of(table_, points_[v]));
    }
    const BoxTree tree(boxes);
    InnerVertices result;
    for (std::size_t i = 0; i < edges.size(); ++i) {
      if (i % 256 == 0) context_.checkpoint("vertices on edges", i, edges.size());
      gather_inner(edges[i], tree);
      memory_.add(inner_.size() * sizeof(std::uint32_t), "vertices on edges");
      result.vertex.insert(result.vertex.end(), inner_.begin(), inner_.end());
      result.begin.push_back(static_cast<std::uint32_t>(result.vertex.size()));
    }
    return result;
  }

 private:
  /// Collects the vertices inside of the edge, from its first end to its second end.
  void gather_inner(const VertexPair& edge, const BoxTree& tree) {
    inner_.clear();
    const std::size_t axis = axis_of(edge);
    const Sign along = compare(edge[0], edge[1], axis);
    const auto keep_if_inside = [&](std::uint32_t i) {
      step_();
      const std::uint32_t v = ends_[i];
      const bool is_between =
          compare(edge[0], v, axis) == along && compare(v, edge[1], axis) == along;
      if (is_between && are_collinear(edge[0], edge[1], v)) inner_.push_back(v);
    };
    for_each_near(edge, tree, keep_if_inside);
    // Points of one line are in the order of any coordinate that varies along it.
    std::sort(inner_.begin(), inner_.end(),
              [&](std::uint32_t v, std::uint32_t w) { return compare(v, w, axis) == along; });
  }

  /// Visits the boxes that the edge may meet. The box of a long edge that is parallel to no plane
  /// of the axes contains many vertices that are far from the edge. So the tree is searched along
  /// the edge, unless the differences of its ends exceed the doubles.
  template <class Visit>
  void for_each_near(const VertexPair& edge, const BoxTree& tree, Visit visit) const {
    const Box3 from = box_of(table_, points_[edge[0]]), to = box_of(table_, points_[edge[1]]);
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    BoxRay ray{from, {}};
    bool is_finite = true;
    for (std::size_t i = 0; i < 3; ++i) {
      ray.direction.low[i] = std::nextafter(to.low[i] - from.high[i], -kInfinity);
      ray.direction.high[i] = std::nextafter(to.high[i] - from.low[i], kInfinity);
      is_finite &= std::isfinite(ray.direction.low[i]) && std::isfinite(ray.direction.high[i]);
    }
    if (is_finite) {
      tree.for_each_along(ray, 1, [&](std::uint32_t i, double) {
        visit(i);
        return 1.0;
      });
    } else {
      Box3 box = from;
      box.add(to);
      tree.for_each_meeting(box, visit);
    }
  }

  /// Returns an axis along which the ends differ. They are different points.
  std::size_t axis_of(const VertexPair& edge) const {
    std::size_t axis = 0;
    while (axis < 2 && compare(edge[0], edge[1], axis) == Sign::Zero) ++axis;
    return axis;
  }
  Sign compare(std::uint32_t v, std::uint32_t w, std::size_t axis) const {
    return compare_axis(table_, points_[v], points_[w], axis);
  }

  /// Whether three points lie on one line: they do if they do so seen along each axis.
  bool are_collinear(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
    const std::array<SpacePoint, 3> p{points_[a], points_[b], points_[c]};
    if (std::ranges::all_of(p, &SpacePoint::is_input)) {
      const PlaneTable& planes = table_.planes();
      return are_collinear(planes.point(p[0].input()), planes.point(p[1].input()),
                           planes.point(p[2].input()));
    }
    return are_collinear(exact(table_, p[0]), exact(table_, p[1]), exact(table_, p[2]));
  }
  static bool are_collinear(const Point3& a, const Point3& b, const Point3& c) {
    return orient2d(Point2{a.x, a.y}, Point2{b.x, b.y}, Point2{c.x, c.y}) == Sign::Zero &&
           orient2d(Point2{a.y, a.z}, Point2{b.y, b.z}, Point2{c.y, c.z}) == Sign::Zero &&
           orient2d(Point2{a.z, a.x}, Point2{b.z, b.x}, Point2{c.z, c.x}) == Sign::Zero;
  }
  static bool are_collinear(const RationalPoint3& a, const RationalPoint3& b,
                            const RationalPoint3& c) {
    using P = RationalPoint2;
    return orient2d(P{a.x, a.y}, P{b.x, b.y}, P{c.x, c.y}) == Sign::Zero &&
           orient2d(P{a.y, a.z}, P{b.y, b.z}, P{c.y, c.z}) == Sign::Zero &&
           orient2d(P{a.z, a.x}, P{b.z, b.x}, P{c.z, c.x}) == Sign::Zero;
  }

  std::span<const SpacePoint> points_;
  const Point3Table& table_;
  MemoryCharge& memory_;
  Context& context_;
  StepCounter step_;
  std::vector<std::uint32_t> ends_;   // The ends of all edges, ascending.
  std::vector<std::uint32_t> inner_;  // The vertices inside of the current edge.
};

// ---------------------------------------------------------------- chains

/// Walks along directed edges, of which equally many enter and leave every vertex, and cuts off
/// loops. Therefore every chain is simple.
class ChainWalker {
 public:
  ChainWalker(const EdgeSurpluses& surplus, MemoryCharge& memory, Context& context)
      : step_("borders", context) {
    std::size_t count = 0;
    for (const EdgeSurplus& s : surplus) {
      count += static_cast<std::size_t>(std::abs(s.times));
      vertex_.insert(vertex_.end(), s.end.begin(), s.end.end());
    }
    // Apart from the targets, every edge is in one chain, and most chains have at least three
    // edges.
    memory.add((vertex_.size() + count) * 4 * sizeof(std::uint32_t), "the borders of a mesh");
    std::sort(vertex_.begin(), vertex_.end());
    vertex_.erase(std::unique(vertex_.begin(), vertex_.end()), vertex_.end());
    begin_.resize(vertex_.size() + 1);
    place_.assign(vertex_.size(), kNone);
    target_.resize(count);
    add_edges(surplus);
  }

  std::vector<std::vector<std::uint32_t>> chains() {
    for (std::uint32_t i = 0; i < vertex_.size(); ++i) {
      while (end_[i] > begin_[i]) walk(i);
    }
    return std::move(chains_);
  }

 private:
  /// Sorts the edges by the vertex from which they lead. Edges of one vertex keep their order.
  void add_edges(const EdgeSurpluses& surplus) {
    for (const EdgeSurplus& s : surplus) {
      begin_[number_of(start_of(s)) + 1] += static_cast<std::uint32_t>(std::abs(s.times));
    }
    std::partial_sum(begin_.begin(), begin_.end(), begin_.begin());
    end_.assign(begin_.begin(), begin_.end() - 1);
    for (const EdgeSurplus& s : surplus) {
      const std::uint32_t from = number_of(start_of(s)), to = number_of(s.end[s.times < 0 ? 1 : 0]);
      for (std::int32_t i = 0; i < std::abs(s.times); ++i) target_[end_[from]++] = to;
    }
  }
  /// Returns the vertex at which an edge must begin to balance the surplus. It is the lesser vertex
  /// if the edge occurs too often in the downward direction.
  static std::uint32_t start_of(const EdgeSurplus& s) { return s.end[s.times < 0 ? 0 : 1]; }
  std::uint32_t number_of(std::uint32_t v) {
    step_();
    return static_cast<std::uint32_t>(std::ranges::lower_bound(vertex_, v) - vertex_.begin());
  }

  /// Walks until the start is reached again. This happens because equally many edges enter and
  /// leave every vertex.
  void walk(std::uint32_t start) {
    path_ = {start};
    place_[start] = 0;
    do {
      step_();
      const std::uint32_t to = target_[--end_[path_.back()]];
      if (place_[to] == kNone) {
        place_[to] = static_cast<std::uint32_t>(path_.size());
        path_.push_back(to);
      } else {
        cut_loop(place_[to]);
      }
    } while (path_.size() > 1);
    place_[start] = kNone;
  }

  /// Makes a chain of the part of the path since a vertex that is reached again.
  void cut_loop(std::size_t from) {
    std::vector<std::uint32_t>& chain = chains_.emplace_back();
    chain.reserve(path_.size() - from);
    for (std::size_t i = from; i < path_.size(); ++i) {
      chain.push_back(vertex_[path_[i]]);
      if (i > from) place_[path_[i]] = kNone;
    }
    path_.resize(from + 1);
  }

  StepCounter step_;
  // The vertices in ascending order. The arrays below have indices of this array.
  std::vector<std::uint32_t> vertex_;
  // The targets of edges, sorted by the vertices at which the edges begin.
  std::vector<std::uint32_t> target_;
  std::vector<std::uint32_t> begin_;  // The first target of each vertex.
  std::vector<std::uint32_t> end_;    // The end of the targets that have not been visited.
  std::vector<std::uint32_t> path_;   // The walk, without the loops that were cut off.
  std::vector<std::uint32_t> place_;  // The place of each vertex in the walk, or kNone.
  std::vector<std::vector<std::uint32_t>> chains_;
};

}  // namespace

void collect(EdgeSurpluses& list) {
  std::sort(list.begin(), list.end(),
            [](const EdgeSurplus& a, const EdgeSurplus& b) { return a.end < b.end; });
  std::size_t count = 0;
  for (std::size_t i = 0; i < list.size();) {
    EdgeSurplus sum{list[i].end, 0};
    for (; i < list.size() && list[i].end == sum.end; ++i) sum.times += list[i].times;
    if (sum.times != 0) list[count++] = sum;
  }
  list.resize(count);
}

InnerVertices vertices_inside(std::span<const VertexPair> edges, std::span<const SpacePoint> points,
                              const Point3Table& table, MemoryCharge& memory, Context& context) {
  return InnerVertexSearch(points, table, memory, context).find(edges);
}

EdgeSurpluses cut_at_vertices(const EdgeSurpluses& edges, std::span<const SpacePoint> points,
                              const Point3Table& table, MemoryCharge& memory, Context& context) {
  std::vector<VertexPair> ends;
  ends.reserve(edges.size());
  for (const EdgeSurplus& edge : edges) ends.push_back(edge.end);
  const InnerVertices inner = vertices_inside(ends, points, table, memory, context);
  const std::size_t count = edges.size() + inner.vertex.size();
  memory.add(count * sizeof(EdgeSurplus), "parts of edges");
  EdgeSurpluses pieces;
  pieces.reserve(count);
  for (std::size_t i = 0; i < edges.size(); ++i) {
    std::uint32_t from = edges[i].end[0];
    for (const std::uint32_t v : inner.of(i)) {
      add_to(pieces, from, v, edges[i].times);
      from = v;
    }
    add_to(pieces, from, edges[i].end[1], edges[i].times);
  }
  context.check_limits("parts of edges");
  collect(pieces);
  return pieces;
}

std::vector<std::vector<std::uint32_t>> chains_of(const EdgeSurpluses& surplus,
                                                  MemoryCharge& memory, Context& context) {
  return ChainWalker(surplus, memory, context).chains();
}

std::vector<std::vector<std::uint32_t>> trace_borders(const MeshFacets& facets,
                                                      const MeshLinks& links,
                                                      std::span<const SpacePoint> points,
                                                      const Point3Table& table, Context& context) {
  MemoryCharge memory(context);
  EdgeSurpluses surplus = imbalances(facets, links, memory, context);
  if (!surplus.empty()) surplus = cut_at_vertices(surplus, points, table, memory, context);
  return chains_of(surplus, memory, context);
}

namespace {

/// The sum of the jumps at an edge, for the component of each of its facets.
using JumpSums = std::vector<std::pair<std::uint32_t, std::int32_t>>;

/// Whether there are one or two facets at the edge of a use.
bool is_plain(const SpaceComplex& complex, UseId u) {
  return complex.use_radial[complex.use_radial[u]] == u;
}

/// Whether the two facets at a plain edge balance, that is, winding numbers increase towards the
/// same side. They do at most edges of most meshes.
bool is_balanced(const SpaceComplex& complex, std::span<const std::int32_t> jump, UseId u,
                 UseId v) {
  const std::int32_t at_u = jump[complex.use_facet[u].value()],
                     at_v = jump[complex.use_facet[v].value()];
  const bool is_one_way = complex.use_halfedge[u] == complex.use_halfedge[v];
  return v != u && (is_one_way ? at_u == -at_v : at_u == at_v);
}

/// Unites the facets at each plain edge. Returns a use of each edge that is not plain and balanced.
std::vector<UseId> unite_at_plain_edges(const SpaceComplex& complex,
                                        std::span<const std::int32_t> jump, UnionFind& classes) {
  std::vector<UseId> rest;
  for (const UseId u : complex.edge_use) {
    const UseId v = complex.use_radial[u];
    const bool is_plain = complex.use_radial[v] == u;
    if (is_plain) classes.unite(complex.use_facet[u].value(), complex.use_facet[v].value());
    if (!is_plain || !is_balanced(complex, jump, u, v)) rest.push_back(u);
  }
  return rest;
}

/// Unites the components that use an edge more often in one direction than in the other, and adds
/// `one` to them. Returns a facet of the united component, or `one` if all components balance.
/// `sums` is scratch memory.
std::uint32_t unite_unbalanced(const SpaceComplex& complex, std::span<const std::int32_t> jump,
                               UseId first, UnionFind& classes, JumpSums& sums,
                               std::uint32_t one = kNone) {
  sums.clear();
  UseId u = first;
  do {
    const std::uint32_t f = complex.use_facet[u].value();
    const std::uint32_t root = classes.root(f);
    auto sum = std::ranges::find(sums, root, [](const auto& s) { return s.first; });
    if (sum == sums.end()) sum = sums.insert(sum, {root, 0});
    sum->second += SpaceComplex::is_reverse(complex.use_halfedge[u]) ? -jump[f] : jump[f];
    u = complex.use_radial[u];
  } while (u != first);
  for (const auto& [root, sum] : sums) {
    if (sum == 0) continue;
    if (one == kNone) one = root;
    classes.unite(one, root);
  }
  return one;
}

/// The number of the component of each facet, and how many components there are.
struct NumberedComponents {
  std::vector<std::uint32_t> of_facet;
  std::size_t count = 0;
};

/// Numbers classes of facets by their least facets.
NumberedComponents numbered(UnionFind& classes) {
  NumberedComponents result{std::vector<std::uint32_t>(classes.size(), kNone), 0};
  std::vector<std::uint32_t>& number = result.of_facet;
  for (std::uint32_t f = 0; f < classes.size(); ++f) {
    const std::uint32_t root = classes.root(f);
    if (number[root] == kNone) number[root] = static_cast<std::uint32_t>(result.count++);
    number[f] = number[root];
  }
  return result;
}

/// Returns the components of facets. Plain edges, with one facet or two, join their facets at once.
/// Then edges with more facets join the components that do not balance there by themselves. Last,
/// whatever still does not balance becomes one open component.
NumberedComponents components_of_facets(const SpaceComplex& complex,
                                        std::span<const std::int32_t> jump) {
  UnionFind classes(complex.facet_count());
  JumpSums sums;
  const std::vector<UseId> rest = unite_at_plain_edges(complex, jump, classes);
  for (const UseId u : rest) {
    if (!is_plain(complex, u)) unite_unbalanced(complex, jump, u, classes, sums);
  }
  std::uint32_t open = kNone;
  for (const UseId u : rest) open = unite_unbalanced(complex, jump, u, classes, sums, open);
  return numbered(classes);
}

// ---------------------------------------------------------------- volumes

/// Signs of the volumes of components: six times the volume of the cone over each facet from the
/// first corner of its component, summed.
class VolumeSigns {
 public:
  VolumeSigns(const SpaceComplex& complex, std::span<const std::int32_t> jump,
              const NumberedComponents& components)
      : complex_(complex), jump_(jump), component_(components.of_facet), apex_(components.count) {}

  std::vector<Sign> run() {
    std::vector<Sum> sums(apex_.size());
    std::vector<Sign> signs(sums.size(), Sign::Zero);
    sum_from_origin(sums);
    if (note_signs(sums, signs)) return signs;
    for (std::uint32_t f = 0; f < complex_.facet_count(); ++f) {
      if (Sum& sum = sums[component_[f]]; !sum.is_sure) add(f, sum);
    }
    if (!note_signs(sums, signs)) decide(sums, signs);
    return signs;
  }

 private:
  /// A sum of products, with the data for its error bound.
  struct Sum {
    double value = 0;      ///< The sum in doubles.
    double size = 0;       ///< The sum of the magnitudes of all products.
    double reach = 1;      ///< The largest difference of coordinates, or 1.
    double terms = 0;      ///< The number of cones.
    bool is_sure = false;  ///< Whether the sign of `value` is right.
    /// Returns a bound for the error of `value`. A term is off by less than 12 roundings of its
    /// magnitude, each partial sum by one more; flushed subnormals lose less than 2^-1000 times the
    /// square of the reach.
    double error() const { return (terms + 16) * (0x1p-51 * size + 0x1p-990 * reach * reach); }
  };

  /// Notes the signs of the sums that exceed their error bounds, and clears the others. Returns
  /// whether all are known.
  static bool note_signs(std::vector<Sum>& sums, std::vector<Sign>& signs) {
    bool are_sure = true;
    for (std::size_t c = 0; c < sums.size(); ++c) {
      Sum& sum = sums[c];
      if (sum.is_sure) continue;
      if (std::fabs(sum.value) > sum.error()) {  // If anything overflowed, this is false.
        sum.is_sure = true;
        signs[c] = sign_of(sum.value);
      } else {
        sum = {};
        are_sure = false;
      }
    }
    return are_sure;
  }

  UseId first_use(std::uint32_t f) const { return complex_.cycles_of(FacetId(f))[0]; }
  UseId next(UseId u) const { return complex_.use_next[u]; }

  /// Returns the largest magnitude of a coordinate; infinity if a vertex is a constructed point.
  double largest_coordinate() const {
    double largest = 0;
    for (const SpacePoint p : complex_.vertex_point) {
      if (!p.is_input()) return std::numeric_limits<double>::infinity();
      const Point3& at = complex_.planes().point(p.input());
      largest = std::max({largest, std::fabs(at.x), std::fabs(at.y), std::fabs(at.z)});
    }
    return largest;
  }

  /// Sums the cones from the origin, whose products need no differences and have one bound, six
  /// times the cube of the largest coordinate. The sums are left at 0, which is never sure, if
  /// there are constructed points, or if the products may overflow or be flushed to zero.
  void sum_from_origin(std::vector<Sum>& sums) const {
    const double reach = largest_coordinate();
    if (!(reach > 0x1p-300 && reach < 0x1p300)) return;
    for (std::uint32_t f = 0; f < complex_.facet_count(); ++f) {
      Sum& sum = sums[component_[f]];
      const double times = -jump_[f];
      for_fan(f, [&](SpacePoint p, SpacePoint q, SpacePoint r) {
        const Point3 &a = complex_.planes().point(p.input()),
                     &b = complex_.planes().point(q.input()),
                     &c = complex_.planes().point(r.input());
        sum.value += times * (a.x * (b.y * c.z - b.z * c.y) + a.y * (b.z * c.x - b.x * c.z) +
                              a.z * (b.x * c.y - b.y * c.x));
        sum.size += std::fabs(times);
        sum.terms += 1;
      });
    }
    const double largest_cone = 6 * reach * reach * reach;
    for (Sum& sum : sums) {
      sum.size *= largest_cone;
      sum.reach = reach;
    }
  }

  /// Calls visit(a, b, c) for the triangles of a fan of the facet, counter-clockwise seen from the
  /// canonical side.
  template <class Visit>
  void for_fan(std::uint32_t f, const Visit& visit) const {
    const UseId first = first_use(f);
    for (UseId u = next(first); next(u) != first; u = next(u)) {
      visit(point(first), point(u), point(next(u)));
    }
  }
  SpacePoint point(UseId u) const { return complex_.vertex_point[complex_.use_origin(u)]; }

  /// Returns the apex of the cones of the facet's component: its first corner, near which
  /// differences are short.
  SpacePoint apex(std::uint32_t f) {
    SpacePoint& p = apex_[component_[f]];
    if (!p.is_valid()) p = point(first_use(f));
    return p;
  }

  using Vector3 = std::array<double, 3>;

  /// Returns the coordinates of an input point, or the middle of the box of a constructed one.
  Vector3 middle(SpacePoint p) const {
    if (!p.is_input()) return complex_.points().box(p).mid;
    const Point3& at = complex_.planes().point(p.input());
    return {at.x, at.y, at.z};
  }

  /// Adds the cone over a facet. A constructed point makes the reach infinite, so that the sum is
  /// decided exactly.
  void add(std::uint32_t f, Sum& sum) {
    const Vector3 o = middle(apex(f));
    const auto from_apex = [&](SpacePoint p) {
      const Vector3 m = middle(p), d{m[0] - o[0], m[1] - o[1], m[2] - o[2]};
      // The middle of a box is not the constructed point.
      if (!p.is_input()) sum.reach = std::numeric_limits<double>::infinity();
      for (const double x : d) sum.reach = std::max(sum.reach, std::fabs(x));
      return d;
    };
    const double times = -jump_[f];
    for_fan(f, [&](SpacePoint p, SpacePoint q, SpacePoint r) {
      const Vector3 a = from_apex(p), b = from_apex(q), c = from_apex(r);
      double value = 0, size = 0;
      for (std::size_t k = 0; k < 3; ++k) {
        const double s = b[(k + 1) % 3] * c[(k + 2) % 3], t = b[(k + 2) % 3] * c[(k + 1) % 3];
        value += a[k] * (s - t);
        size += std::fabs(a[k]) * (std::fabs(s) + std::fabs(t));
      }
      sum.value += times * value;
      sum.size += std::fabs(times) * size;
      sum.terms += 1;
    });
  }

  /// Computes the sums that are not certain with rationals.
  void decide(const std::vector<Sum>& sums, std::vector<Sign>& signs) const {
    std::vector<Rational> exact(sums.size());
    for (std::uint32_t f = 0; f < complex_.facet_count(); ++f) {
      if (!sums[component_[f]].is_sure) exact[component_[f]] += exact_cone(f);
    }
    for (std::size_t c = 0; c < sums.size(); ++c) {
      if (!sums[c].is_sure) signs[c] = sign_of(exact[c]);
    }
  }

  /// Returns the cone over a facet from the origin. The apex does not matter, because the component
  /// is closed.
  Rational exact_cone(std::uint32_t f) const {
    Rational sum;
    for_fan(f, [&](SpacePoint p, SpacePoint q, SpacePoint r) {
      const RationalPoint3 a = exact(complex_.points(), p), b = exact(complex_.points(), q),
                           c = exact(complex_.points(), r);
      sum += a.x * (b.y * c.z - b.z * c.y) + a.y * (b.z * c.x - b.x * c.z) +
             a.z * (b.x * c.y - b.y * c.x);
    });
    return -jump_[f] * sum;
  }

  const SpaceComplex& complex_;
  std::span<const std::int32_t> jump_;
  const std::vector<std::uint32_t>& component_;
  std::vector<SpacePoint> apex_;  // The apex of each component, after it is known.
};

}  // namespace

MeshComponents find_components(const SpaceComplex& complex, std::span<const std::int32_t> jump) {
  NumberedComponents components = components_of_facets(complex, jump);
  std::vector<Sign> volume = VolumeSigns(complex, jump, components).run();
  return {std::move(components.of_facet), std::move(volume)};
}

namespace {

/// A set of axes as bits 0, 1, 2. In the view along axis i, the axes i + 1 and i + 2 point right
/// and up.
using Axes = std::uint8_t;
constexpr Axes kAllAxes = 7;

/// The axes along which the positive side of a facet's plane is visible, and those along which the
/// negative side is. An axis in neither set is undecided.
struct Sides {
  Axes positive = 0;
  Axes negative = 0;
};

/// Finds the vertices with a fan.
class FanSearch {
 public:
  explicit FanSearch(const SpaceComplex& complex)
      : complex_(complex),
        can_be_(complex.vertex_count(), kAllAxes),
        turns_(complex.vertex_count()) {}

  std::vector<std::uint8_t> run() {
    find_sides();
    for (std::uint32_t e = 0; e < complex_.edge_count(); ++e) look_at_edge(EdgeId(e));
    for (std::uint32_t f = 0; f < complex_.facet_count(); ++f) count_turns(FacetId(f));
    for (const VertexId v : complex_.inner) can_be_[v.value()] = 0;
    for (std::size_t v = 0; v < can_be_.size(); ++v) {
      can_be_[v] = (can_be_[v] & turns_[v].once & ~turns_[v].twice) != 0 ? 1 : 0;
    }
    return std::move(can_be_);
  }

 private:
  /// The axes along which the corners around a vertex pass the direction 0 at least once, and at
  /// least twice.
  struct Turns {
    Axes once = 0;
    Axes twice = 0;
  };

  // The error of a component of the row's normal is less than the error of the row, so a larger
  // component has the right sign.
  void find_sides() {
    sides_.reserve(complex_.facet_count());
    for (const PlaneId plane : complex_.facet_plane) {
      const PlaneRow& row = complex_.planes().row(plane);
      Sides sides;
      for (std::size_t i = 0; i < 3; ++i) {
        const double error = static_cast<double>(row.normal_error);
        sides.positive |= static_cast<Axes>((row.n[i] > error ? 1U : 0U) << i);
        sides.negative |= static_cast<Axes>((row.n[i] < -error ? 1U : 0U) << i);
      }
      sides_.push_back(sides);
    }
  }

  /// Excludes the axes along which the facets at an edge do not lie on different sides of it. Seen
  /// from the positive side, the facet is to the left of its edge use. Two uses in opposite
  /// directions need the same visible side, and two uses in the same direction need different
  /// visible sides.
  void look_at_edge(EdgeId e) {
    const UseId u = complex_.edge_use[e];
    const UseId v = u.is_valid() ? complex_.use_radial[u] : u;
    Axes good = 0;
    if (v != u && complex_.use_radial[v] == u) {
      const Sides &s = sides_of(u), &t = sides_of(v);
      const bool is_opposite = complex_.use_halfedge[u] != complex_.use_halfedge[v];
      good = is_opposite ? (s.positive & t.positive) | (s.negative & t.negative)
                         : (s.positive & t.negative) | (s.negative & t.positive);
    }
    can_be_[complex_.origin[2 * e.value()].value()] &= good;
    can_be_[complex_.origin[2 * e.value() + 1].value()] &= good;
  }
  const Sides& sides_of(UseId u) const { return sides_[complex_.use_facet[u].value()]; }

  /// Counts the corners of a facet. A triangle of input points takes three comparisons of points.
  void count_turns(FacetId f) {
    const UseId first = complex_.cycles_of(f)[0];
    std::array<UseId, 3> uses{first};
    for (std::size_t i = 1; i < 3; ++i) uses[i] = complex_.use_next[uses[i - 1]];
    const bool is_triangle =
        complex_.cycles_of(f).size() == 1 && complex_.use_next[uses[2]] == first;
    if (!is_triangle) return count_turns_of_any(f);
    std::array<std::uint32_t, 3> corner;
    std::array<const Point3*, 3> at;
    for (std::size_t i = 0; i < 3; ++i) {
      const VertexId v = complex_.use_origin(uses[i]);
      const SpacePoint p = complex_.vertex_point[v];
      if (!p.is_input()) return count_turns_of_any(f);
      corner[i] = v.value();
      at[i] = &complex_.planes().point(p.input());
    }
    std::array<Axes, 3> rises;  // The axes along which side i, to the next corner, leads upward.
    for (std::size_t i = 0; i < 3; ++i) rises[i] = rises_along(*at[i], *at[i == 2 ? 0 : i + 1]);
    const Axes is_reversed = sides_[f.value()].negative;
    for (std::size_t i = 0; i < 3; ++i) {
      // Seen from the positive side, the counter-clockwise order is from the next corner to the
      // previous corner.
      const Axes begins_up = rises[i], ends_up = ~rises[i == 0 ? 2 : i - 1];
      const Axes passes =
          (is_reversed & begins_up & ~ends_up) | (~is_reversed & ~begins_up & ends_up);
      count(corner[i], passes);
    }
  }
  /// Counts a corner at v for the axes along which it passes the direction 0.
  void count(std::uint32_t v, unsigned passes) {
    Turns& turns = turns_[v];
    turns.twice |= static_cast<Axes>(turns.once & passes);
    turns.once |= static_cast<Axes>(passes);
  }

  /// Returns the axes along which q is in the upper half-plane around p: above p, or level with p
  /// and to the right.
  static Axes rises_along(const Point3& p, const Point3& q) {
    const std::array<unsigned, 3> above{q.x > p.x, q.y > p.y, q.z > p.z};
    const std::array<unsigned, 3> level{q.x == p.x, q.y == p.y, q.z == p.z};
    unsigned axes = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t right = (i + 1) % 3, up = (i + 2) % 3;
      axes |= (above[up] | (level[up] & above[right])) << i;
    }
    return static_cast<Axes>(axes);
  }

  // ---- corners of polygons, and constructed ones

  /// Counts the corners of any facet.
  void count_turns_of_any(FacetId f) {
    for (const UseId first : complex_.cycles_of(f)) {
      UseId u = first;
      do {
        count_turn(f, u);
        u = complex_.use_next[u];
      } while (u != first);
    }
  }
  /// Counts the corner of a use. Axes along which boxes do not determine the directions of its
  /// edges are excluded. If both edges lead up or both lead down, the corner passes the direction 0
  /// if and only if it is not less than a half turn.
  void count_turn(FacetId f, UseId u) {
    const VertexId v = complex_.use_origin(u);
    const HalfedgeId next = complex_.use_halfedge[u];
    const HalfedgeId before = SpaceComplex::twin(complex_.use_halfedge[complex_.use_prev[u]]);
    const Rises ahead = rises_along(v, complex_.target(next)),
                behind = rises_along(v, complex_.target(before));
    can_be_[v.value()] &= ahead.known & behind.known;
    if (can_be_[v.value()] == 0) return;
    const Axes is_reversed = sides_[f.value()].negative;
    const Axes begins_up = (is_reversed & behind.up) | (~is_reversed & ahead.up),
               ends_up = (is_reversed & ahead.up) | (~is_reversed & behind.up);
    const Axes is_level = ~(begins_up ^ ends_up) & can_be_[v.value()];
    const bool is_reflex =
        is_level != 0 &&
        side_in_plane(complex_, complex_.facet_plane[f], next, complex_.points(),
                      complex_.vertex_point[complex_.target(before)]) != Sign::Positive;
    count(v.value(), (~begins_up & ends_up) | (is_reflex ? is_level : 0));
  }

  /// The axes along which an edge certainly leads upward, and those along which the boxes decide.
  struct Rises {
    Axes up = 0;
    Axes known = 0;
  };
  Rises rises_along(VertexId v, VertexId w) const {
    const SpacePoint p = complex_.vertex_point[v], q = complex_.vertex_point[w];
    const PlaneTable& planes = complex_.planes();
    if (p.is_input() && q.is_input()) {
      return {rises_along(planes.point(p.input()), planes.point(q.input())), kAllAxes};
    }
    Rises rises;
    for (std::size_t i = 0; i < 3; ++i) {
      const FilteredSign above = rung::compare_axis_filter(complex_.points().box(q),
                                                           complex_.points().box(p), (i + 2) % 3);
      rises.up |= static_cast<Axes>((above == FilteredSign::Positive ? 1U : 0U) << i);
      rises.known |= static_cast<Axes>((is_decided(above) ? 1U : 0U) << i);
    }
    return rises;
  }

  const SpaceComplex& complex_;
  std::vector<Axes> can_be_;  // The axes along which each vertex may have a fan.
  std::vector<Turns> turns_;  // One entry for each vertex.
  std::vector<Sides> sides_;  // One entry for each facet.
};

}  // namespace

std::vector<std::uint8_t> find_fans(const SpaceComplex& complex) {
  return FanSearch(complex).run();
}

}  // namespace plumb
