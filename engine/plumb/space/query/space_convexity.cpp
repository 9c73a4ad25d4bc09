// The tests that the header lists, in the same order. Each test reads the complex once.
//
// Because the complex is minimal, a cell gives information about the cells around it: a facet with
// V on both sides is a slit, and an edge with two facets of one plane separates different marks. So
// local conditions at facets, edges and vertices decide about the body, and counting runs of marked
// cells along the sides of a facet decides about its boundary. The proof is in the header and in
// docs/design/walls.md, "Convexity".
//
// Tested by tests/space/space_convexity_test.cpp.

#include "plumb/space/query/space_convexity.h"

#include <algorithm>
#include <span>
#include <vector>

#include "plumb/space/planar/facet_site.h"

namespace plumb {
namespace {

/// The test of one complex.
class ConvexityTest {
 public:
  explicit ConvexityTest(const SpaceComplex& complex) : c_(complex) {}

  bool run() {
    const auto marked = std::count(c_.volume_mark.begin(), c_.volume_mark.end(), Mark{1});
    if (marked > 1) return false;
    if (marked == 0) return is_convex_when_flat();
    const auto body = std::find(c_.volume_mark.begin(), c_.volume_mark.end(), Mark{1});
    body_ = VolumeId(static_cast<std::size_t>(body - c_.volume_mark.begin()));
    return is_body_convex() && are_planes_convex();
  }

 private:
  // ---- 1. body

  /// Whether K is convex and S lies between V and K: every facet has V on one side, every edge is
  /// convex, every vertex has one cone.
  bool is_body_convex() const {
    for (std::size_t f = 0; f < c_.facet_count(); ++f) {
      const auto& [above, below] = c_.facet_volume[f];
      if (c_.facet_mark[f] != kBeyond && (above == body_) == (below == body_)) return false;
    }
    for (std::size_t e = 0; e < c_.edge_count(); ++e) {
      if (c_.edge_mark[e] != kBeyond && !is_convex_at(EdgeId(e))) return false;
    }
    for (std::size_t v = 0; v < c_.vertex_count(); ++v) {
      if (c_.vertex_mark[v] != kBeyond && !is_on_one_cone(VertexId(v))) return false;
    }
    return true;
  }

  /// Whether two facets meet at an edge with at most a half turn inside of V. For the use s (n x
  /// d), with s = 1 for half-edge 2e and -1 for 2e + 1, this is the direction from the edge, which
  /// points in direction d along 2e, into a facet with normal n. The product of two of them is (n1
  /// x d) x (n2 x d) = d det(n1, n2, d).
  bool is_convex_at(EdgeId e) const {
    const UseId any = c_.edge_use[e];
    if (!any.is_valid()) return false;
    const UseId other = c_.use_radial[any];
    if (other == any || c_.use_radial[other] != any) return false;
    const UseId first = c_.volume_after(any) == body_ ? any : other;
    const UseId second = first == any ? other : any;
    const PlaneId n1 = plane_of(first), n2 = plane_of(second);
    if (n1 == n2) return true;
    const auto& [p, q] = c_.edge_planes[e];
    const Sign turn = same_direction(c_.planes(), p, q, n1, n2);
    return sense(first) * sense(second) * turn == Sign::Positive;
  }

  PlaneId plane_of(UseId u) const { return c_.facet_plane[c_.use_facet[u]]; }
  Sign sense(UseId u) const {
    return SpaceComplex::is_reverse(c_.use_halfedge[u]) ? Sign::Negative : Sign::Positive;
  }

  /// Whether a vertex lies inside a facet without edges, or its corners lead around through all
  /// half-edges. Requires edges of two uses.
  bool is_on_one_cone(VertexId v) const {
    const std::size_t degree = c_.star_of(v).size();
    if (c_.vertex_facet[v].is_valid()) return degree == 0;
    if (degree == 0) return false;
    const UseId first = c_.edge_use[c_.star_of(v)[0].value() / 2];
    std::size_t passed = 0;
    UseId u = first;
    do {
      const bool leaves = c_.use_origin(u) == v;
      const UseId across = leaves ? c_.use_prev[u] : c_.use_next[u];
      u = c_.use_radial[across];
      ++passed;
    } while (u != first);
    return passed == degree;
  }

  // ---- 2. planes

  /// Tests each plane that has facets.
  bool are_planes_convex() {
    std::vector<FacetId> facets;
    for (std::size_t f = 0; f < c_.facet_count(); ++f) {
      if (c_.facet_mark[f] != kBeyond) facets.push_back(FacetId(f));
    }
    std::sort(facets.begin(), facets.end(),
              [this](FacetId f, FacetId g) { return c_.facet_plane[f] < c_.facet_plane[g]; });
    const auto is_other_plane = [this](FacetId f, FacetId g) {
      return c_.facet_plane[f] != c_.facet_plane[g];
    };
    for (auto first = facets.begin(); first != facets.end();) {
      auto last = std::adjacent_find(first, facets.end(), is_other_plane);
      if (last != facets.end()) ++last;
      if (!is_plane_convex({first, last})) return false;
      first = last;
    }
    return true;
  }

  /// Tests one plane with all its facets. If a facet is marked, all marked edges and vertices must
  /// be on its boundary.
  bool is_plane_convex(std::span<const FacetId> facets) {
    const auto is_marked = [this](FacetId f) { return c_.facet_mark[f] == 1; };
    const auto f = std::find_if(facets.begin(), facets.end(), is_marked);
    gather(facets);
    if (f == facets.end()) return is_one_edge_or_vertex();
    if (std::find_if(f + 1, facets.end(), is_marked) != facets.end()) return false;
    if (!is_polygon_convex(*f)) return false;
    const std::size_t edges = edges_.size(), vertices = vertices_.size();
    gather(std::span(&*f, 1));
    return edges_.size() == edges && vertices_.size() == vertices;
  }

  /// Collects the marked edges and vertices on the boundaries of facets and inside of them, each
  /// once.
  void gather(std::span<const FacetId> facets) {
    edges_.clear();
    vertices_.clear();
    for (const FacetId f : facets) {
      for (const UseId cycle : c_.cycles_of(f)) gather(cycle);
      for (const VertexId v : c_.inner_of(f)) gather_vertex(v);
    }
    make_unique(edges_);
    make_unique(vertices_);
  }
  void gather(UseId cycle) {
    UseId u = cycle;
    do {
      const EdgeId e = edge_of(u);
      if (c_.edge_mark[e] == 1) edges_.push_back(e);
      gather_vertex(c_.use_origin(u));
      u = c_.use_next[u];
    } while (u != cycle);
  }
  void gather_vertex(VertexId v) {
    if (c_.vertex_mark[v] == 1) vertices_.push_back(v);
  }
  template <class Id>
  static void make_unique(std::vector<Id>& ids) {
    std::sort(ids.begin(), ids.end());
    ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
  }
  EdgeId edge_of(UseId u) const { return SpaceComplex::edge_of(c_.use_halfedge[u]); }

  /// Whether the collected cells are one edge with any of its ends, or one vertex, or no cells.
  bool is_one_edge_or_vertex() const {
    if (edges_.empty()) return vertices_.size() <= 1;
    if (edges_.size() > 1) return false;
    return std::all_of(vertices_.begin(), vertices_.end(), [this](VertexId v) {
      const std::uint32_t h = 2 * edges_[0].value();
      return v == c_.origin[h] || v == c_.origin[h + 1];
    });
  }

  // ---- 3. sides

  /// Whether the facet is convex together with the marked cells of its boundary.
  bool is_polygon_convex(FacetId f) const {
    if (c_.cycles_of(f).size() != 1 || !c_.inner_of(f).empty()) return false;
    const UseId cycle = c_.cycles_of(f)[0];
    UseId u = cycle, start;
    do {
      if (is_side_end(u)) {
        start = u;
      } else if (!is_straight(u)) {
        return false;
      }
      u = c_.use_next[u];
    } while (u != cycle);
    u = start;
    do {
      if (!is_side_convex(u)) return false;
    } while (u != start);
    return true;
  }

  /// Whether a side ends at the corner, because its angle is less than a half turn, or because it
  /// is on the frame.
  bool is_side_end(UseId u) const {
    return c_.vertex_mark[c_.use_origin(u)] == kBeyond || corner_sign(c_, u) == Sign::Positive;
  }
  /// Whether the corner is a half turn, and not the end of a slit.
  bool is_straight(UseId u) const {
    const UseId before = c_.use_prev[u];
    return edge_of(before) != edge_of(u) && corner_sign(c_, u) == Sign::Zero;
  }

  /// Whether the marked cells of the side that starts at u are consecutive. Moves u to the next
  /// side.
  bool is_side_convex(UseId& u) const {
    std::size_t runs = 0;
    bool was_marked = false;
    const auto pass = [&](Mark mark) {
      if (mark == 1 && !was_marked) ++runs;
      was_marked = mark == 1;
    };
    pass(c_.vertex_mark[c_.use_origin(u)]);
    do {
      pass(c_.edge_mark[edge_of(u)]);
      u = c_.use_next[u];
      pass(c_.vertex_mark[c_.use_origin(u)]);
    } while (!is_side_end(u));
    return runs <= 1;
  }

  // ---- without a marked volume

  /// Tests a set without a marked volume. It must have at most one facet, or one edge, or one
  /// vertex. Only sides and ends may be unmarked, because all other unmarked cells would lie within
  /// the complement.
  bool is_convex_when_flat() const {
    const std::size_t facets = standard(c_.facet_mark);
    if (facets > 1) return false;
    IdVector<VertexId, std::uint8_t> is_seen(c_.vertex_count(), 0);
    const std::size_t edges = standard(c_.edge_mark);
    if (facets == 0 && edges > 1) return false;
    for (std::size_t e = 0; e < c_.edge_count(); ++e) {
      if (c_.edge_mark[e] == kBeyond) continue;
      if (facets == 1 && !c_.edge_use[e].is_valid()) return false;
      is_seen[c_.origin[2 * e]] = is_seen[c_.origin[2 * e + 1]] = 1;
    }
    std::size_t lone = 0;
    for (std::size_t v = 0; v < c_.vertex_count(); ++v) {
      if (c_.vertex_mark[v] != kBeyond && is_seen[v] == 0) ++lone;
    }
    if (lone > (facets == 0 && edges == 0 ? 1U : 0U)) return false;
    return facets == 0 || is_polygon_convex(standard_facet());
  }

  /// Returns the number of cells off the frame.
  static std::size_t standard(const std::vector<Mark>& marks) {
    return marks.size() - static_cast<std::size_t>(std::count(marks.begin(), marks.end(), kBeyond));
  }
  /// Returns the first facet off the frame.
  FacetId standard_facet() const {
    std::size_t f = 0;
    while (c_.facet_mark[f] == kBeyond) ++f;
    return FacetId(f);
  }

  const SpaceComplex& c_;
  VolumeId body_;
  std::vector<EdgeId> edges_;  // The marked edges of the current plane.
  std::vector<VertexId> vertices_;
};

}  // namespace

bool is_convex(const SpaceComplex& complex) { return ConvexityTest(complex).run(); }

}  // namespace plumb
