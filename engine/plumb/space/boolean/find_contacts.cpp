// The search for contacts: two trees of leaves, and a test for each pair of leaves whose boxes
// meet. Leaves whose boxes would nearly all meet go to trees of oriented boxes (thin_leaves.h).
//
// Notation
//   x, y      leaves of the two complexes
//   forward   cells of the first complex against facets of the second; backward is the reverse
//   located   found in a facet around the other cell by its site
//
// The tests are complete (docs/design/boolean.md, step 1 of "The algorithm"). A contact with a
// facet is found by testing the other cell against that facet. The other contacts are found so:
//
//   VE, EV   the vertex is located in any facet of the edge; direct if the edge is free
//   VV       forward if the second vertex has a facet, else backward if the first has one; else
//            direct
//   EE       an edge that does not lie in some facet's plane around the other crosses that plane
//            and is located. The plane of two crossing edges holds all facets of both only if both
//            are flat: direct
//
// So pairs of triangles in general position or in one plane cost sides of vertices and little else.
//
// Tested by tests/space/find_contacts_test.cpp.

#include "plumb/space/boolean/find_contacts.h"

#include <algorithm>
#include <optional>

#include "plumb/base/internal/box_tree.h"
#include "plumb/base/internal/parallel.h"
#include "plumb/predicates/input_predicates.h"
#include "plumb/predicates/point3_signs.h"
#include "plumb/predicates/space/box_orientation.h"
#include "plumb/space/boolean/contact_leaves.h"
#include "plumb/space/boolean/thin_leaves.h"
#include "plumb/space/complex/space_boxes.h"
#include "plumb/space/planar/facet_site.h"

namespace plumb {

namespace {

/// Planes that contain a vertex by construction. If a plane is one of them, a comparison of ids
/// gives the side 0.
class IncidentPlanes {
 public:
  IncidentPlanes(const SpaceComplex& complex, VertexId v) {
    for (const HalfedgeId h : complex.star_of(v)) {
      if (count_ == planes_.size()) return;
      for (const PlaneId p : complex.edge_planes[SpaceComplex::edge_of(h)]) {
        planes_[count_++] = p;
      }
    }
  }
  std::span<const PlaneId> planes() const { return std::span(planes_).first(count_); }

 private:
  // More planes would hardly help, because identity only saves time.
  std::array<PlaneId, 16> planes_;
  std::size_t count_ = 0;
};

/// Returns the side of a plane on which a vertex lies: by the filter stage, then by identity, then
/// exactly. The known planes are collected only if the filter stage fails.
Sign side_of(const SpaceComplex& complex, VertexId v, PlaneId plane) {
  const Point3Table& points = complex.points();
  const SpacePoint x = complex.vertex_point[v];
  const FilteredSign s = rung::side_filter(points.box(x), points.planes().row(plane));
  if (is_decided(s)) return decide(Predicate::SideOfPlane, Rung::Filter, s);
  return rung::side_without_filter(points, x, plane, IncidentPlanes(complex, v).planes());
}

/// Returns the origin (i = 0) or target (i = 1) of half-edge 2e.
VertexId end(const SpaceComplex& complex, EdgeId e, std::size_t i) {
  return complex.origin[2 * e.value() + i];
}

/// Whether the ends of the edge lie strictly on different sides of one of the planes.
bool crosses_one_of(const SpaceComplex& complex, EdgeId e, std::span<const PlaneId> planes) {
  return std::any_of(planes.begin(), planes.end(), [&](PlaneId p) {
    return side_of(complex, end(complex, e, 0), p) * side_of(complex, end(complex, e, 1), p) ==
           Sign::Negative;
  });
}

/// Whether two edges that are not on one line cross in their relative interiors. Their four planes
/// have a common point or direction (det4 = 0), and each edge crosses a plane through the other. So
/// the lines meet in a point, as an edge parallel to the other's line crosses no plane through it;
/// and the point is inside both edges.
bool edges_cross(const SpaceComplex& a, EdgeId e, const SpaceComplex& b, EdgeId f) {
  const auto &p = a.edge_planes[e], &q = b.edge_planes[f];
  return crosses_one_of(b, f, p) && crosses_one_of(a, e, q) &&
         det4_sign(a.planes(), p[0], p[1], q[0], q[1]) == Sign::Zero;
}

/// Whether the vertex lies in the relative interior of an edge of another complex.
bool is_on_edge(const SpaceComplex& of_vertex, VertexId v, const SpaceComplex& of_edge, EdgeId e) {
  const std::array<PlaneId, 2>& planes = of_edge.edge_planes[e];
  for (const PlaneId p : planes) {
    if (side_of(of_vertex, v, p) != Sign::Zero) return false;
  }
  const auto runs_to = [&](SpacePoint from, SpacePoint to) {
    return order_along_line(of_edge.points(), planes[0], planes[1], from, to) == Sign::Positive;
  };
  const SpacePoint x = of_vertex.vertex_point[v];
  return runs_to(of_edge.vertex_point[end(of_edge, e, 0)], x) &&
         runs_to(x, of_edge.vertex_point[end(of_edge, e, 1)]);
}

/// The corners of a facet that is a triangle of input points. A cut with such a facet needs no
/// planes and no constructed points.
class InputTriangle {
 public:
  InputTriangle(const SpaceComplex& complex, FacetId f) {
    if (complex.cycles_of(f).size() != 1 || !complex.inner_of(f).empty()) return;
    UseId u = complex.cycles_of(f).front();
    for (std::size_t i = 0; i < 3; ++i, u = complex.use_next[u]) {
      const SpacePoint p = complex.vertex_point[complex.use_origin(u)];
      if (!p.is_input()) return;
      uses_[i] = u;
      corners_[i] = &complex.planes().point(p.input());
    }
    is_valid_ = u == uses_[0];
  }
  bool is_valid() const { return is_valid_; }

  /// Returns the facet or edge where the line a b cuts the triangle, and an invalid item if it
  /// passes outside or through a vertex. Requires that the line cuts the plane of the triangle in
  /// one point. The signs orient3d(a, b, p, q) say on which side the line passes each side p q; it
  /// passes inside if all three agree, and through a side if that one is 0 and the others agree.
  SpaceItem cut(const SpaceComplex& complex, FacetId f, const Point3& a, const Point3& b) const {
    std::array<Sign, 3> turn;
    for (std::size_t i = 0; i < 3; ++i) {
      turn[i] = orient3d(a, b, *corners_[i], *corners_[(i + 1) % 3]);
    }
    const auto is_edge = [&](std::size_t i) {
      return turn[i] == Sign::Zero && turn[(i + 1) % 3] == turn[(i + 2) % 3];
    };
    if (turn[0] != Sign::Zero && turn[0] == turn[1] && turn[1] == turn[2]) return f;
    for (std::size_t i = 0; i < 3; ++i) {
      if (is_edge(i)) return SpaceComplex::edge_of(complex.use_halfedge[uses_[i]]);
    }
    return {};
  }

 private:
  std::array<UseId, 3> uses_;
  std::array<const Point3*, 3> corners_{};
  bool is_valid_ = false;
};

/// Returns the side on which the line a b passes the line p q, which is the sign of orient3d(a, b,
/// p, q). Returns Zero if the lines meet, and also if a point is constructed and the boxes do not
/// determine the sign. The planes of an edge may be nearly parallel, so the ends give clearer signs
/// than the planes.
Sign passing_side(const Point3Table& points, SpacePoint a, SpacePoint b, SpacePoint p,
                  SpacePoint q) {
  if (a.is_input() && b.is_input() && p.is_input() && q.is_input()) {
    const PlaneTable& planes = points.planes();
    return orient3d(planes.point(a.input()), planes.point(b.input()), planes.point(p.input()),
                    planes.point(q.input()));
  }
  const FilteredSign sign =
      rung::orient3d_filter(points.box(a), points.box(b), points.box(p), points.box(q));
  return is_decided(sign) ? decided(sign) : Sign::Zero;
}

/// Whether the line a b passes through the interior of a facet of a few corners. Returns nothing
/// for other facets, or if the line meets a cycle or a diagonal from the first corner, or if a sign
/// is unclear. In these cases, the point of the cut is located in the facet. Requires that the line
/// cuts the plane of the facet in one point. That point is inside if an odd number of triangles
/// hold it that have the first corner and a side of a cycle.
std::optional<bool> passes_inside(const SpaceComplex& complex, FacetId f, SpacePoint a,
                                  SpacePoint b) {
  constexpr std::size_t kMostCorners = 16;
  if (complex.cycles_of(f).empty() || !complex.inner_of(f).empty()) return {};
  const Point3Table& points = complex.points();
  const auto corner_of = [&](UseId u) { return complex.vertex_point[complex.use_origin(u)]; };
  const UseId first = complex.cycles_of(f).front();
  const SpacePoint start = corner_of(first);
  bool is_inside = false;
  std::size_t count = 0;
  for (const UseId cycle : complex.cycles_of(f)) {
    // The first cycle begins and ends at `start`, so its first and its last side have no triangle.
    UseId u = cycle == first ? complex.use_next[cycle] : cycle;
    const UseId last = cycle == first ? complex.use_prev[cycle] : cycle;
    SpacePoint before = corner_of(u);
    Sign spoke = passing_side(points, a, b, start, before);
    if (spoke == Sign::Zero) return {};
    do {
      if (++count == kMostCorners) return {};
      u = complex.use_next[u];
      const SpacePoint corner = corner_of(u);
      const Sign next_spoke = passing_side(points, a, b, start, corner);
      const Sign side = passing_side(points, a, b, before, corner);
      if (next_spoke == Sign::Zero || side == Sign::Zero) return {};
      if (spoke == side && side != next_spoke) is_inside = !is_inside;
      spoke = next_spoke;
      before = corner;
    } while (u != last);
  }
  return is_inside;
}

/// Returns the cell of a facet, the facet or an edge, in which an edge that crosses its plane cuts
/// it. A vertex may be reported, or may count as outside, because it is found as a vertex of its
/// own complex on the edge.
SpaceItem cut_of_edge(const SpaceComplex& of_edge, EdgeId e, const SpaceComplex& of_facet,
                      FacetId f, const FacetSites& sites, Context& context) {
  const SpacePoint a = of_edge.vertex_point[end(of_edge, e, 0)];
  const SpacePoint b = of_edge.vertex_point[end(of_edge, e, 1)];
  if (a.is_input() && b.is_input()) {
    const InputTriangle triangle(of_facet, f);
    const PlaneTable& planes = of_edge.planes();
    if (triangle.is_valid()) {
      return triangle.cut(of_facet, f, planes.point(a.input()), planes.point(b.input()));
    }
  }
  const auto is_inside = passes_inside(of_facet, f, a, b);
  if (is_inside) return *is_inside ? SpaceItem(f) : SpaceItem();
  const auto [p, q] = of_edge.edge_planes[e];
  return sites.site(f, p, q, context);
}

/// Collects the pairs of cells in contact, in any order, some more than once. Each part of the
/// pairs of leaves has one collector, and the parts may run at the same time.
class ContactFinder {
 public:
  ContactFinder(const ContactLeaves& a, const ContactLeaves& b,
                const std::array<FacetSites, 2>& sites, Context& context)
      : a_(a),
        b_(b),
        items_of_a_(a),
        items_of_b_(b),
        sites_(sites),
        context_(context),
        memory_(context) {}

  /// Tests leaf x of the first complex and leaf y of the second complex against each other, in both
  /// directions.
  void test(std::size_t x, std::size_t y) {
    if (++tested_ % 4096 == 0) report();
    const LeafItems &in_a = items_of_a_[x], &in_b = items_of_b_[y];
    if (b_[y].facet.is_valid()) items_in_facet<true>(a_[x], in_a, y);
    if (a_[x].facet.is_valid()) items_in_facet<false>(b_[y], in_b, x);
    // Contacts that facets do not reveal are found by direct comparison.
    const bool is_bare = a_[x].bare.is_valid() || b_[y].bare.is_valid();
    if (is_bare || (in_a.has_flat_edges() && in_b.has_flat_edges())) test_directly(x, y);
  }

  /// Returns the pairs (a, b) as high and low half of each word.
  std::vector<std::uint64_t> take_keys() { return std::move(keys_); }

 private:
  template <bool kForward>
  const SpaceComplex& tested_complex() const {
    return kForward ? a_.complex() : b_.complex();
  }
  template <bool kForward>
  const ContactLeaves& others() const {
    return kForward ? b_ : a_;
  }

  /// Tests the vertices and edges of a leaf against the surface of leaf y of the other complex.
  /// Each vertex's side is computed once for all its edges in the leaf.
  template <bool kForward>
  void items_in_facet(const ContactLeaf& leaf, const LeafItems& items, std::size_t y) {
    const std::span<const VertexId> vertices = items.vertices();
    std::array<Sign, LeafItems::kMostVertices> sides;
    if (vertices.empty() || !find_sides<kForward>(vertices, y, sides)) return;
    for (std::size_t i = 0; i < items.own_vertices().size(); ++i) {
      if (sides[i] == Sign::Zero) vertex_in_facet<kForward>(leaf, vertices[i], y);
    }
    for (const LeafEdge& e : items.edges()) {
      if (sides[e.from] * sides[e.to] == Sign::Negative) edge_in_facet<kForward>(e, y);
    }
  }

  /// Computes the sides of the facet's plane on which vertices lie. Returns false if all are
  /// strictly on one side, because then no cell of the leaf meets the facet.
  template <bool kForward>
  bool find_sides(std::span<const VertexId> vertices, std::size_t y,
                  std::array<Sign, LeafItems::kMostVertices>& sides) const {
    const ContactLeaves& ys = others<kForward>();
    const PlaneId plane = ys.complex().facet_plane[ys[y].facet];
    bool has_both = false;
    for (std::size_t i = 0; i < vertices.size(); ++i) {
      sides[i] = side_of(tested_complex<kForward>(), vertices[i], plane);
      has_both |= sides[i] == Sign::Zero || sides[i] != sides[0];
    }
    return has_both;
  }

  /// Adds a vertex that lies in the facet's plane, with the cell on which it is located. A pair of
  /// vertices is added forward, and backward only if the tested vertex, of the second complex, has
  /// no facet: otherwise the pair is found forward from a facet around it.
  template <bool kForward>
  void vertex_in_facet(const ContactLeaf& leaf, VertexId v, std::size_t y) {
    const SpaceComplex& complex = tested_complex<kForward>();
    const ContactLeaves& ys = others<kForward>();
    if (!ys.boxes()[y].meets(box_of(complex, v))) return;
    const SpacePoint point = complex.vertex_point[v];
    const SpaceItem site = sites_of<!kForward>().site(ys[y].facet, point, context_);
    if (!site.is_valid()) return;
    if (kForward || site.kind() != SpaceItem::Kind::Vertex || leaf.bare.is_valid()) {
      add<kForward>(v, site);
    }
  }

  /// Adds an edge that crosses the facet's plane, with the facet or edge that it cuts. A pair of
  /// edges is added forward, and backward only if the tested edge, of the second complex, is flat:
  /// otherwise it has facets in two planes, the edge of the first complex crosses one of them, and
  /// the pair is found forward.
  template <bool kForward>
  void edge_in_facet(const LeafEdge& e, std::size_t y) {
    const ContactLeaves& ys = others<kForward>();
    const SpaceItem site = cut_of_edge(tested_complex<kForward>(), e.edge, ys.complex(),
                                       ys[y].facet, sites_of<!kForward>(), context_);
    if (!site.is_valid() || site.kind() == SpaceItem::Kind::Vertex) return;
    if (kForward || site.kind() == SpaceItem::Kind::Facet || e.is_flat) add<kForward>(e.edge, site);
  }

  /// Tests the contacts that no facet reveals: pairs of flat edges, vertices on free edges, pairs
  /// of vertices without facets.
  void test_directly(std::size_t x, std::size_t y) {
    const LeafItems &in_a = items_of_a_[x], &in_b = items_of_b_[y];
    for (const LeafEdge& e : in_a.edges()) {
      for (const LeafEdge& f : in_b.edges()) {
        if (e.is_flat && f.is_flat && edges_cross(a_.complex(), e.edge, b_.complex(), f.edge)) {
          add<true>(e.edge, f.edge);
        }
      }
    }
    const bool is_bare_a = a_[x].bare.is_valid(), is_bare_b = b_[y].bare.is_valid();
    if (is_bare_b) vertices_on_free_edges<true>(in_a, in_b);
    if (is_bare_a) vertices_on_free_edges<false>(in_b, in_a);
    if (is_bare_a && is_bare_b) equal_vertices(in_a, in_b);
  }

  template <bool kForward>
  void vertices_on_free_edges(const LeafItems& xs, const LeafItems& ys) {
    for (const LeafEdge& e : ys.edges()) {
      for (const VertexId v : xs.own_vertices()) {
        const SpaceComplex& of_edge = others<kForward>().complex();
        if (is_on_edge(tested_complex<kForward>(), v, of_edge, e.edge)) add<kForward>(v, e.edge);
      }
    }
  }

  /// Adds pairs of equal vertices that both have no facet. This is one of the few places that test
  /// the equality of points. Both points are vertices of the operands.
  void equal_vertices(const LeafItems& in_a, const LeafItems& in_b) {
    const SpaceComplex &a = a_.complex(), &b = b_.complex();
    for (const VertexId v : in_a.own_vertices()) {
      for (const VertexId w : in_b.own_vertices()) {
        if (equal(a.points(), a.vertex_point[v], b.vertex_point[w])) {
          add<true>(v, w);
        }
      }
    }
  }

  template <bool kIsFirst>
  const FacetSites& sites_of() const {
    return sites_[kIsFirst ? 0 : 1];
  }

  template <bool kForward>
  void add(SpaceItem tested, SpaceItem site) {
    const SpaceItem a = kForward ? tested : site, b = kForward ? site : tested;
    keys_.push_back(std::uint64_t{a.code()} << 32U | b.code());
  }

  /// Calls the checkpoint and charges the memory by which the list has grown.
  void report() {
    context_.checkpoint("contacts", 0, 1);
    const std::size_t bytes = keys_.capacity() * sizeof(keys_[0]);
    if (bytes > charged_) memory_.add(bytes - charged_, "contacts");
    charged_ = std::max(charged_, bytes);
  }

  const ContactLeaves& a_;
  const ContactLeaves& b_;
  LeafCache items_of_a_;
  LeafCache items_of_b_;
  const std::array<FacetSites, 2>& sites_;
  Context& context_;
  MemoryCharge memory_;
  std::size_t charged_ = 0;
  std::uint64_t tested_ = 0;
  std::vector<std::uint64_t> keys_;
};

/// Returns the point where an edge cuts another cell, which is a facet or an edge. If the cell is
/// an edge, one of its planes does not contain this edge, and defines the point. Both planes cannot
/// contain it, because the edges would then be on one line.
SpacePoint cut_point(SpaceTables& tables, const SpaceComplex& of_edge, EdgeId e,
                     const SpaceComplex& of_other, SpaceItem other) {
  const auto [p, q] = of_edge.edge_planes[e];
  if (other.kind() == SpaceItem::Kind::Facet) {
    return tables.points.add(p, q, of_other.facet_plane[other.index()]);
  }
  const auto [r, s] = of_other.edge_planes[other.index()];
  const SpacePoint point = tables.points.add(p, q, r);
  return point.is_valid() ? point : tables.points.add(p, q, s);
}

/// Returns the point of a contact. It is constructed unless one of the cells is a vertex.
SpacePoint contact_point(SpaceTables& tables, const SpaceComplex& a, SpaceItem x,
                         const SpaceComplex& b, SpaceItem y) {
  using Kind = SpaceItem::Kind;
  if (x.kind() == Kind::Vertex) return a.vertex_point[x.index()];
  if (y.kind() == Kind::Vertex) return b.vertex_point[y.index()];
  return x.kind() == Kind::Edge ? cut_point(tables, a, x.edge(), b, y)
                                : cut_point(tables, b, y.edge(), a, x);
}

}  // namespace

namespace {

/// Returns boxes around the leaves along the axes of another frame. The leaves of a facet are
/// consecutive, so the box of a large facet is computed once.
std::vector<Box3> turned_boxes(const ContactLeaves& leaves, const BoxFrame& frame,
                               Context& context) {
  constexpr std::size_t kLeavesPerCheckpoint = 1024;
  std::vector<Box3> boxes;
  boxes.reserve(leaves.boxes().size());
  LeafItems items;
  FacetId facet;
  Box3 of_facet;
  for (std::size_t i = 0; i < leaves.boxes().size(); ++i) {
    if (i % kLeavesPerCheckpoint == 0) context.checkpoint("box trees", 0, 0);
    Box3 box;
    if (leaves[i].facet.is_valid()) {
      if (leaves[i].facet != facet) of_facet = frame.box_of(leaves.complex(), leaves[i].facet);
      facet = leaves[i].facet;
      box = of_facet;
    }
    items.fill(leaves.complex(), leaves[i]);
    for (const VertexId v : items.vertices()) box.add(frame.box_of(leaves.complex(), v));
    boxes.push_back(box);
  }
  return boxes;
}

/// Trees over the leaves. They use boxes along the coordinate axes or, if those would give many
/// pairs, boxes in a frame that gives fewer. The frame affects only the cost.
struct LeafTrees {
  std::array<BoxTree, 2> of;    ///< One for each complex; empty if needs_oriented.
  bool is_turned = false;       ///< Whether the boxes are those of another frame.
  bool needs_oriented = false;  ///< Whether boxes would give many pairs in both frames.
};

/// Builds both trees, each as a job of its own.
LeafTrees make_trees(const ContactLeaves& xs, const ContactLeaves& ys, Context& context) {
  constexpr double kManyPairs = 64;  // For each leaf.
  LeafTrees trees;
  std::array<std::span<const Box3>, 2> boxes{xs.boxes(), ys.boxes()};
  std::array<std::vector<Box3>, 2> turned;
  const std::size_t leaves = xs.boxes().size() + ys.boxes().size();
  double pairs = expected_pairs(xs.boxes(), ys.boxes());
  // A frame along the edges of both complexes is tried only if the axes would give many pairs.
  if (has_many_pairs(pairs, leaves)) {
    context.check_limits("box trees");
    const BoxFrame frame = BoxFrame::of_edges(std::array{&xs.complex(), &ys.complex()});
    turned = {turned_boxes(xs, frame, context), turned_boxes(ys, frame, context)};
    context.check_limits("box trees");
    const double in_frame = expected_pairs(turned[0], turned[1]);
    trees.is_turned = is_better_frame(in_frame, pairs);
    if (trees.is_turned) {
      boxes = {turned[0], turned[1]};
      pairs = in_frame;
    }
    trees.needs_oriented = pairs > kManyPairs * static_cast<double>(leaves);
    if (trees.needs_oriented) return trees;
  }
  run_jobs(context, 2, [&](std::size_t i, Context& own) {
    own.checkpoint("box trees", i, 2);
    trees.of[i] = BoxTree(boxes[i]);
  });
  return trees;
}

using ContactKeys = std::vector<std::uint64_t>;

/// Tests all pairs of leaves whose oriented boxes meet.
ContactKeys keys_of_thin_leaves(const ContactLeaves& xs, const ContactLeaves& ys,
                                const std::array<FacetSites, 2>& sites, Context& context) {
  constexpr std::size_t kBytesPerTriangle = 700;
  MemoryCharge memory(context);
  memory.add(
      kBytesPerTriangle * (count_thin_triangles(xs.complex()) + count_thin_triangles(ys.complex())),
      "oriented boxes of facets");
  std::uint64_t steps = 0;
  const auto on_step = [&] {
    if (++steps % 4096 == 0) context.checkpoint("contacts", 0, 1);
  };
  const ThinLeaves a(xs, on_step), b(ys, on_step);
  ContactFinder finder(xs, ys, sites, context);
  ThinLeaves::for_each_pair(
      a, b,
      [&](std::uint32_t x, std::uint32_t y) {
        if (xs.boxes()[x].meets(ys.boxes()[y])) finder.test(x, y);
      },
      on_step);
  return finder.take_keys();
}

/// Tests all pairs of leaves whose boxes meet. The pairs are divided into parts that run at the
/// same time.
ContactKeys keys_of_leaves(const ContactLeaves& xs, const ContactLeaves& ys, const LeafTrees& trees,
                           const std::array<FacetSites, 2>& sites, Context& context) {
  constexpr std::size_t kPartsAThread = 16;
  const std::size_t threads = context.threads();
  // There are more parts than threads, so that uneven parts are balanced.
  const std::vector<BoxTree::Part> parts =
      BoxTree::parts(trees.of[0], trees.of[1], threads == 1 ? 1 : kPartsAThread * threads);
  std::vector<ContactKeys> found(parts.size());
  run_jobs(context, parts.size(), [&](std::size_t i, Context& own) {
    ContactFinder finder(xs, ys, sites, own);
    BoxTree::for_each_pair(trees.of[0], trees.of[1], parts[i],
                           [&](std::uint32_t x, std::uint32_t y) {
                             if (trees.is_turned && !xs.boxes()[x].meets(ys.boxes()[y])) return;
                             finder.test(x, y);
                           });
    found[i] = finder.take_keys();
  });
  ContactKeys keys;
  for (const auto& part : found) keys.insert(keys.end(), part.begin(), part.end());
  return keys;
}

/// Returns the contacts in sorted order, each once. After sorting, the result does not depend on
/// the trees and the parts.
ContactKeys contact_keys(const ContactLeaves& xs, const ContactLeaves& ys, Context& context) {
  const LeafTrees trees = make_trees(xs, ys, context);
  const std::array<FacetSites, 2> sites{FacetSites(xs.complex(), xs.large_facets(), context),
                                        FacetSites(ys.complex(), ys.large_facets(), context)};
  ContactKeys keys = trees.needs_oriented ? keys_of_thin_leaves(xs, ys, sites, context)
                                          : keys_of_leaves(xs, ys, trees, sites, context);
  std::sort(keys.begin(), keys.end());
  keys.erase(std::unique(keys.begin(), keys.end()), keys.end());
  return keys;
}

/// Returns the common part of two boxes that meet.
Box3 common_part(const Box3& a, const Box3& b) {
  Box3 part;
  for (std::size_t i = 0; i < 3; ++i) {
    part.low[i] = std::max(a.low[i], b.low[i]);
    part.high[i] = std::min(a.high[i], b.high[i]);
  }
  return part;
}

/// Returns the leaves of both complexes that may meet a leaf of the other complex. They are the
/// leaves in the box of the other complex and, if there are many, in a cell of a grid with leaves
/// of both complexes.
std::array<std::optional<ContactLeaves>, 2> leaves_within_reach(const SpaceComplex& a,
                                                                const SpaceComplex& b,
                                                                Context& context) {
  constexpr std::size_t kMany = 1024;  // For fewer leaves, a grid takes more time than it saves.
  const Box3 box_a = box_of(a), box_b = box_of(b);
  std::array<std::optional<ContactLeaves>, 2> leaves;
  run_jobs(context, 2, [&](std::size_t i, Context& own) {
    own.checkpoint("box trees", i, 2);
    i == 0 ? leaves[0].emplace(a, box_b, &own) : leaves[1].emplace(b, box_a, &own);
  });
  if (std::min(leaves[0]->boxes().size(), leaves[1]->boxes().size()) < kMany) return leaves;
  const Box3 common = common_part(box_a, box_b);
  std::array<std::optional<OccupiedCells>, 2> cells;
  run_jobs(context, 2, [&](std::size_t i, Context& own) {
    own.check_limits("box trees");
    cells[i].emplace(common, leaves[i]->boxes());
  });
  run_jobs(context, 2, [&](std::size_t i, Context& own) {
    own.check_limits("box trees");
    leaves[i]->keep_near(*cells[1 - i]);
  });
  context.check_limits("box trees");
  return leaves;
}

}  // namespace

std::vector<Contact> find_contacts(const SpaceComplex& a, const SpaceComplex& b,
                                   SpaceTables& tables, Context& context) {
  constexpr std::size_t kBytesAnItem = 100;
  MemoryCharge memory(context);
  memory.add((a.edge_count() + b.edge_count()) * kBytesAnItem, "box trees");
  const auto leaves = leaves_within_reach(a, b, context);
  const std::vector<std::uint64_t> keys = contact_keys(*leaves[0], *leaves[1], context);
  std::vector<Contact> contacts;
  contacts.reserve(keys.size());
  for (const std::uint64_t key : keys) {
    constexpr std::size_t kPointsPerCheckpoint = 1024;
    if (contacts.size() % kPointsPerCheckpoint == 0) context.checkpoint("contacts", 0, 1);
    const SpaceItem x = SpaceItem::from_code(static_cast<std::uint32_t>(key >> 32U));
    const SpaceItem y = SpaceItem::from_code(static_cast<std::uint32_t>(key));
    contacts.push_back({x, y, contact_point(tables, a, x, b, y)});
  }
  return contacts;
}

}  // namespace plumb
