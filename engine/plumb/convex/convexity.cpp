// Tests of convexity for meshes and sets, and the evidence against it.
//
// A mesh is first tried by the star test (StarTest), which needs nothing but orientation signs of
// input points: a point o strictly behind every face exists, every face is a convex polygon, no
// edge is reflex, and one ray from o meets one face. The projection from o to a sphere is then a
// covering of degree one, so the surface is star-shaped, and it is convex because its edges are.
// The ray is needed: a double pyramid that winds twice around its axis passes every other test. If
// a sign is Zero that must not be Zero, or if a face is not a convex polygon, the test gives no
// answer. Then a set is made from the mesh, and the test of this set decides. Proof:
// docs/design/walls.md, section Convexity, after K. Mehlhorn et al., Computational Geometry 12
// (1999).
//
// Evidence is the number of reflex edges and the faces with vertices on both sides. VertexTree
// answers for each face whether a vertex lies strictly on a side of its plane; it discards boxes by
// a bound on the rounding error of the plane's row, and takes exact signs of single vertices.
// Tested by tests/convex/convexity_test.cpp.

#include "plumb/convex/convexity.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <tuple>
#include <utility>
#include <vector>

#include "plumb/base/internal/box_tree.h"
#include "plumb/convex/wall/wall_section.h"
#include "plumb/predicates/input_predicates.h"
#include "plumb/predicates/point3_signs.h"
#include "plumb/space/mesh/mesh_vertices.h"
#include "plumb/space/planar/facet_site.h"
#include "plumb/space/space_complex.h"

namespace plumb {

/// A binary tree of boxes of vertices, built in O(n log n). A query descends only into boxes that
/// may hold a vertex on the asked side, and stops at the first vertex found: O(log n) for a face of
/// a convex surface, early where many vertices qualify.
class VertexTree {
 public:
  VertexTree(const SpaceComplex& complex, std::vector<VertexId> vertices);

  /// Returns a vertex strictly on that side of the plane, or an invalid id if there is none.
  VertexId find(PlaneId plane, Sign side) const;

 private:
  static constexpr std::size_t kLeaf = 8;

  void build(std::size_t begin, std::size_t end, std::size_t node);
  VertexId find(PlaneId plane, Sign side, std::size_t begin, std::size_t end,
                std::size_t node) const;
  bool can_hold(PlaneId plane, Sign side, const Box3& box) const;

  const SpaceComplex& c_;
  std::vector<VertexId> vertices_;
  // Boxes of a full binary tree; node i has the children 2i + 1 and 2i + 2.
  std::vector<Box3> boxes_;
};

namespace {

std::size_t middle_of(std::size_t begin, std::size_t end) { return begin + (end - begin) / 2; }

}  // namespace

VertexTree::VertexTree(const SpaceComplex& complex, std::vector<VertexId> vertices)
    : c_(complex), vertices_(std::move(vertices)) {
  if (!vertices_.empty()) build(0, vertices_.size(), 0);
}

void VertexTree::build(std::size_t begin, std::size_t end, std::size_t node) {
  if (boxes_.size() <= node) boxes_.resize(node + 1);
  Box3 box;
  for (std::size_t i = begin; i < end; ++i) {
    const PointBox at = c_.points().box(c_.vertex_point[vertices_[i]]);
    for (std::size_t k = 0; k < 3; ++k) {
      box.low[k] = std::min(box.low[k], at.mid[k] - at.radius);
      box.high[k] = std::max(box.high[k], at.mid[k] + at.radius);
    }
  }
  boxes_[node] = box;
  if (end - begin <= kLeaf) return;
  std::size_t axis = 0;
  for (std::size_t k = 1; k < 3; ++k) {
    if (box.high[k] - box.low[k] > box.high[axis] - box.low[axis]) axis = k;
  }
  const std::size_t middle = middle_of(begin, end);
  const auto at = [&](VertexId v) { return c_.points().box(c_.vertex_point[v]).mid[axis]; };
  const auto from = vertices_.begin();
  std::nth_element(from + static_cast<std::ptrdiff_t>(begin),
                   from + static_cast<std::ptrdiff_t>(middle),
                   from + static_cast<std::ptrdiff_t>(end),
                   [&](VertexId v, VertexId w) { return at(v) != at(w) ? at(v) < at(w) : v < w; });
  build(begin, middle, 2 * node + 1);
  build(middle, end, 2 * node + 2);
}

/// Whether the box may contain a vertex on that side. It does not if the corner that is farthest to
/// that side is certainly not beyond the plane, that is, if the value there is below minus the
/// error bound of the row.
bool VertexTree::can_hold(PlaneId plane, Sign side, const Box3& box) const {
  const PlaneRow& row = c_.planes().row(plane);
  const double s = side == Sign::Positive ? 1 : -1;
  double value = s * row.d, size = std::abs(row.d);
  for (std::size_t k = 0; k < 3; ++k) {
    const double n = s * row.n[k], x = n > 0 ? box.high[k] : box.low[k];
    value += n * x;
    size += std::abs(x);
  }
  return !(value <
           -(static_cast<double>(row.normal_error) * size + static_cast<double>(row.offset_error)));
}

VertexId VertexTree::find(PlaneId plane, Sign side) const {
  return vertices_.empty() ? VertexId() : find(plane, side, 0, vertices_.size(), 0);
}

VertexId VertexTree::find(PlaneId plane, Sign side, std::size_t begin, std::size_t end,
                          std::size_t node) const {
  if (!can_hold(plane, side, boxes_[node])) return {};
  if (end - begin > kLeaf) {
    const std::size_t middle = middle_of(begin, end);
    const VertexId v = find(plane, side, begin, middle, 2 * node + 1);
    return v.is_valid() ? v : find(plane, side, middle, end, 2 * node + 2);
  }
  for (std::size_t i = begin; i < end; ++i) {
    const SpacePoint x = c_.vertex_point[vertices_[i]];
    if (plumb::side(c_.points(), x, plane) == side) return vertices_[i];
  }
  return {};
}

namespace {

// ---------------------------------------------------------------- meshes of convex polygons

/// Steps 1 to 4 of convexity.h, for polygons that are planar and convex. The test gives no answer
/// if a face is not planar or not convex, or if a sign is Zero that must not be Zero.
class StarTest {
 public:
  StarTest(const MeshView& mesh, Context& context) : m_(mesh), context_(context) {}

  std::optional<bool> run() {
    if (m_.face_count() < 4 || !m_.exact.empty()) return std::nullopt;
    for (std::size_t f = 0; f < m_.face_count(); ++f) {
      if (m_.face(f).size() < 3) return std::nullopt;
    }
    if (!are_points_there()) return std::nullopt;
    if (!find_middle() || !are_faces_convex()) return std::nullopt;
    const std::optional<bool> is_convex = are_edges_convex();
    if (!is_convex.value_or(true)) return false;
    return is_convex ? is_covered_once() : std::nullopt;
  }

 private:
  static constexpr std::size_t kStride = 4096;  // This is the number of faces between checkpoints.

  void checkpoint(std::size_t f) const {
    if (f % kStride == 0) context_.checkpoint("convexity", f, m_.face_count());
  }
  Point3 at(std::size_t corner) const { return m_.point(m_.corners[corner]); }
  std::size_t next(std::size_t corner) const {
    const std::size_t f = face_[corner];
    return corner + 1 == m_.begin_of(f + 1) ? m_.begin_of(f) : corner + 1;
  }
  /// Returns the side of x with respect to the plane of face f. Three corners of the face that are
  /// not collinear span this plane.
  Sign side(std::size_t f, const Point3& x) const {
    const auto& [a, b, c] = three_[f];
    return orient3d(at(a), at(b), at(c), x);
  }

  static bool is_finite(const Point3& p) {
    return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
  }
  /// Whether all corners are finite points of the mesh. If a corner is not, the general test throws
  /// the error that names the point.
  bool are_points_there() const {
    return std::ranges::all_of(m_.corners, [&](std::uint32_t v) {
      return v < m_.point_count() && is_finite(m_.point(v));
    });
  }

  /// Finds a point strictly behind all faces, or strictly before all of them if the mesh is inside
  /// out. The function tries the mean of the corners, which up to rounding lies inside of every
  /// convex mesh. Also chooses three corners of each face that span its plane.
  bool find_middle() {
    const double scale = 1.0 / static_cast<double>(m_.corners.size());
    for (std::size_t i = 0; i < m_.corners.size(); ++i) {
      middle_.x += scale * at(i).x;
      middle_.y += scale * at(i).y;
      middle_.z += scale * at(i).z;
    }
    if (!is_finite(middle_)) return false;
    face_.resize(m_.corners.size());
    three_.resize(m_.face_count());
    for (std::size_t f = 0; f < m_.face_count(); ++f) {
      checkpoint(f);
      const std::uint32_t begin = m_.begin_of(f), end = m_.begin_of(f + 1);
      Sign sign = Sign::Zero;
      for (std::uint32_t c = begin; c < end; ++c) {
        face_[c] = static_cast<std::uint32_t>(f);
        if (sign != Sign::Zero) continue;
        three_[f] = {c, c + 1 == end ? begin : c + 1, c + 2 >= end ? c + 2 - (end - begin) : c + 2};
        sign = side(f, middle_);
      }
      if (sign == Sign::Zero || (f > 0 && sign != behind_)) return false;
      behind_ = sign;
    }
    return true;
  }

  /// Whether each face lies in one plane, has no right turns, and winds around once.
  bool are_faces_convex() const {
    for (std::size_t f = 0; f < m_.face_count(); ++f) {
      if (m_.face(f).size() == 3) continue;
      checkpoint(f);
      if (!is_convex_polygon(f)) return false;
    }
    return true;
  }

  /// Whether face f is a convex polygon. A closed chain that only turns left winds around as often
  /// as it has local minima in any direction. The direction used here is the lexicographic order of
  /// coordinates.
  bool is_convex_polygon(std::size_t f) const {
    std::size_t least = 0;
    for (std::size_t a = m_.begin_of(f); a < m_.begin_of(f + 1); ++a) {
      const std::size_t b = next(a), c = next(b);
      if (side(f, at(a)) != Sign::Zero) return false;
      const Sign turn = orient3d(at(a), at(b), at(c), middle_);
      if (turn != behind_ && turn != Sign::Zero) return false;
      if (!is_less(b, a) && !is_less(a, b)) return false;
      if (is_less(b, a) && is_less(b, c)) ++least;
    }
    return least == 1;
  }
  bool is_less(std::size_t a, std::size_t b) const {
    const Point3 p = at(a), q = at(b);
    return std::tie(p.x, p.y, p.z) < std::tie(q.x, q.y, q.z);
  }

  /// Whether no edge is reflex; no value if the surface is not a closed 2-manifold. A counting sort
  /// sorts the half-edges by the lesser end of their edge. In the slot of its other end, each
  /// half-edge waits for its reverse, so the pass takes O(n) without hashing.
  std::optional<bool> are_edges_convex() const {
    std::vector<std::uint32_t> begin(m_.point_count() + 1, 0);
    const auto least = [&](std::size_t c) { return std::min(m_.corners[c], m_.corners[next(c)]); };
    for (std::size_t c = 0; c < m_.corners.size(); ++c) ++begin[least(c) + 1];
    for (std::size_t v = 0; v < m_.point_count(); ++v) begin[v + 1] += begin[v];
    std::vector<std::uint32_t> sorted(m_.corners.size()), end(begin.begin(), begin.end() - 1);
    for (std::size_t c = 0; c < m_.corners.size(); ++c) {
      sorted[end[least(c)]++] = static_cast<std::uint32_t>(c);
    }
    std::vector<std::uint32_t> waiting(m_.point_count(), kNone);
    for (std::size_t v = 0; v < m_.point_count(); ++v) {
      if (v % kStride == 0) context_.checkpoint("convexity", v, m_.point_count());
      std::size_t left = 0;
      for (std::uint32_t i = begin[v]; i < begin[v + 1]; ++i) {
        const std::uint32_t c = sorted[i];
        std::uint32_t& other = waiting[std::max(m_.corners[c], m_.corners[next(c)])];
        if (other == kNone) {
          other = c;
          ++left;
          continue;
        }
        if (m_.corners[other] == m_.corners[c]) return std::nullopt;
        if (!is_edge_convex(other, c)) return false;
        other = kNone;
        --left;
      }
      if (left > 0) return std::nullopt;
    }
    return true;
  }

  /// Whether the edge is convex or flat. Its half-edges c and d have opposite directions.
  bool is_edge_convex(std::size_t c, std::size_t d) const {
    // This is a corner of the face of d that is not on the line of the edge.
    std::size_t off = next(next(d));
    while (next(off) != d && orient3d(at(d), at(next(d)), at(off), middle_) == Sign::Zero) {
      off = next(off);
    }
    const Sign sign = side(face_[c], at(off));
    return sign == behind_ || sign == Sign::Zero;
  }

  /// Whether one ray from the middle meets exactly one face. The ray goes through the (rounded)
  /// centroid of three corners of face 0. Gives no answer if it meets an edge, or if rounding moved
  /// it off face 0.
  std::optional<bool> is_covered_once() const {
    const auto third = [&](double Point3::*x) {
      return at(three_[0][0]).*x / 3 + at(three_[0][1]).*x / 3 + at(three_[0][2]).*x / 3;
    };
    const Point3 through{third(&Point3::x), third(&Point3::y), third(&Point3::z)};
    if (!is_finite(through)) return std::nullopt;
    const Sign inside = orient3d(middle_, through, at(three_[0][0]), at(three_[0][1]));
    if (inside == Sign::Zero) return std::nullopt;
    std::size_t count = 0;
    for (std::size_t f = 0; f < m_.face_count(); ++f) {
      checkpoint(f);
      bool is_close = false, is_hit = true;
      for (std::size_t c = m_.begin_of(f); c < m_.begin_of(f + 1) && is_hit; ++c) {
        const Sign sign = orient3d(middle_, through, at(c), at(next(c)));
        is_hit = sign == inside || sign == Sign::Zero;
        is_close |= sign == Sign::Zero;
      }
      if (is_hit && is_close) return std::nullopt;
      if (is_hit) ++count;
    }
    return count == 0 ? std::nullopt : std::optional(count == 1);
  }

  const MeshView& m_;
  Context& context_;
  Point3 middle_{0, 0, 0};
  Sign behind_ = Sign::Zero;
  std::vector<std::uint32_t> face_;  // The face of each corner.
  // For each face, three corners that are not collinear.
  std::vector<std::array<std::uint32_t, 3>> three_;
};

/// Whether the mesh is an embedded closed surface with one component.
bool is_plain(const MeshComplex& mesh) {
  const MeshReport& report = mesh.report;
  return report.is_closed() && !report.crosses_itself() && report.doubled.empty() &&
         mesh.is_inside_out.size() == 1 &&
         std::all_of(mesh.jump.begin(), mesh.jump.end(),
                     [](std::int32_t jump) { return jump == 1 || jump == -1; });
}

// ---------------------------------------------------------------- edges

/// Returns the edges at which the solid has a reflex wedge. A wedge is represented by the edge use
/// before it.
template <class IsInside>
std::vector<EdgeId> wide_edges(const SpaceComplex& c, IsInside&& is_inside_after) {
  const SectorTest test(c);
  std::vector<EdgeId> wide;
  for (std::uint32_t e = 0; e < c.edge_count(); ++e) {
    const UseId first = c.edge_use[e];
    if (c.edge_mark[e] == kBeyond || !first.is_valid()) continue;
    bool is_wide = false;
    UseId u = first;
    do {
      const UseId next = c.use_radial[u];
      is_wide = is_inside_after(u) && test.is_reflex({EdgeId(e), {}, u, next});
      u = next;
    } while (u != first && !is_wide);
    if (is_wide) wide.push_back(EdgeId(e));
  }
  return wide;
}

// ---------------------------------------------------------------- faces

/// Returns the facets that have vertices on both sides; `outer` gives the side of a facet's plane
/// that is outside.
template <class Outer>
std::vector<FailingFace> failing_facets(const SpaceComplex& c, Outer&& outer, Context& context) {
  std::vector<VertexId> ends;  // The ends of edges that do not belong to the frame.
  IdVector<VertexId, std::uint8_t> is_end(c.vertex_count(), 0);
  for (std::size_t h = 0; h < c.origin.size(); ++h) {
    if (c.edge_mark[h / 2] != kBeyond) is_end[c.origin[h]] = 1;
  }
  for (std::size_t v = 0; v < c.vertex_count(); ++v) {
    if (is_end[v] != 0) ends.push_back(VertexId(v));
  }
  const VertexTree tree(c, ends);
  std::vector<FailingFace> failing;
  for (std::size_t f = 0; f < c.facet_count(); ++f) {
    context.checkpoint("faces", f, c.facet_count());
    if (c.facet_mark[f] == kBeyond) continue;
    const Sign out = outer(FacetId(f));
    const VertexId v = tree.find(c.facet_plane[f], out);
    if (!v.is_valid() || !tree.find(c.facet_plane[f], out * Sign::Negative).is_valid()) continue;
    failing.push_back({static_cast<std::uint32_t>(f), v.value()});
  }
  return failing;
}

/// Replaces the numbers of facets and vertices of the complex by those of the mesh. A face that was
/// triangulated is listed once.
void number_as_input(std::vector<FailingFace>& faces, const MeshView& mesh, const SpaceComplex& c) {
  // The tables of the complex were filled in the same order, so equal points have equal ids.
  SpaceTables tables;
  const MeshVertices vertices = merge_equal_points(mesh, tables);
  std::vector<std::pair<SpacePoint, std::uint32_t>> inputs;
  for (std::size_t v = 0; v < vertices.point.size(); ++v) {
    inputs.emplace_back(vertices.point[v], vertices.input[v]);
  }
  std::sort(inputs.begin(), inputs.end());
  for (FailingFace& failing : faces) {
    const std::pair key(c.vertex_point[failing.vertex], std::uint32_t{0});
    failing.face = c.facet_origin[failing.face];
    failing.vertex = std::lower_bound(inputs.begin(), inputs.end(), key)->second;
  }
  std::ranges::stable_sort(faces, {}, [](const FailingFace& f) { return f.face; });
  const auto is_same = [](const FailingFace& f, const FailingFace& g) { return f.face == g.face; };
  faces.erase(std::unique(faces.begin(), faces.end(), is_same), faces.end());
}

}  // namespace

bool is_convex_mesh(const MeshView& mesh, Context& context) {
  if (const std::optional<bool> known = StarTest(mesh, context).run()) return *known;
  MeshComplex complex = complex_of_mesh(mesh, {}, context);
  return is_plain(complex) &&
         Nef3::from_mesh_complex(std::move(complex), WindingRule::NonZero, context).is_convex();
}

ConvexityEvidence convexity_of_mesh(const MeshView& mesh, Context& context) {
  ConvexityEvidence evidence;
  evidence.is_convex = is_convex_mesh(mesh, context);
  if (evidence.is_convex) return evidence;
  const MeshComplex m = complex_of_mesh(mesh, {.surface = true}, context);
  const SpaceComplex& c = m.complex;
  const auto turned = [&](FacetId f) {  // The sign of the inner side.
    const bool is_out = !m.is_inside_out.empty() && m.is_inside_out[m.component[f.value()]] != 0;
    return (m.jump[f.value()] > 0) != is_out ? Sign::Positive : Sign::Negative;
  };
  if (is_plain(m)) {
    const auto is_inside_after = [&](UseId u) {
      const bool is_negative_side = SpaceComplex::is_reverse(c.use_halfedge[u]);
      return (turned(c.use_facet[u]) == Sign::Negative) == is_negative_side;
    };
    evidence.reflex_edges = wide_edges(c, is_inside_after).size();
  }
  evidence.faces = failing_facets(
      c, [&](FacetId f) { return turned(f) * Sign::Negative; }, context);
  number_as_input(evidence.faces, mesh, c);
  return evidence;
}

std::vector<EdgeId> reflex_edges(const SpaceComplex& c) {
  std::vector<EdgeId> edges =
      wide_edges(c, [&](UseId u) { return c.volume_mark[c.volume_after(u)] == 1; });
  for (std::size_t e = 0; e < c.edge_count(); ++e) {
    const bool is_free = !c.edge_use[e].is_valid() && c.edge_mark[e] != kBeyond;
    if (is_free && c.volume_mark[c.edge_volume[e]] == 1) edges.push_back(EdgeId(e));
  }
  std::sort(edges.begin(), edges.end());
  return edges;
}

ConvexityEvidence convexity_of_set(const Nef3& set, Context& context) {
  const SpaceComplex& c = set.complex();
  ConvexityEvidence evidence;
  evidence.is_convex = set.is_convex();
  evidence.reflex_edges = reflex_edges(c).size();
  if (evidence.is_convex) return evidence;
  evidence.faces = failing_facets(
      c,
      [&](FacetId f) {
        const auto& [above, below] = c.facet_volume[f];
        return c.volume_mark[above] == 1 && c.volume_mark[below] != 1 ? Sign::Negative
                                                                      : Sign::Positive;
      },
      context);
  return evidence;
}

}  // namespace plumb
