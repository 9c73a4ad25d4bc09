#include "plumb/convex/convexity.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "plumb/convex/vertex_tree.h"
#include "plumb/predicates/input_predicates.h"
#include "plumb/space/mesh_vertices.h"
#include "plumb/space/plane_cycles.h"

namespace plumb {
namespace {

// ---------------------------------------------------------------- meshes of triangles

/// Steps 1 to 4 of the header for triangles. No answer where a sign is Zero that must not be.
class TriangleTest {
 public:
  explicit TriangleTest(const PolygonMesh& mesh) : m_(mesh) {}

  std::optional<bool> run() {
    if (m_.face_count() < 4 || !m_.exact.empty()) return std::nullopt;
    for (std::size_t f = 0; f < m_.face_count(); ++f) {
      if (m_.face_begin[f + 1] - m_.face_begin[f] != 3) return std::nullopt;
    }
    if (!find_middle()) return std::nullopt;
    const std::optional<bool> is_convex = are_edges_convex();
    if (!is_convex.value_or(true)) return false;
    return is_convex ? is_covered_once() : std::nullopt;
  }

 private:
  const Point3& at(std::size_t corner) const { return m_.points[m_.corners[corner]]; }
  Sign side(std::size_t f, const Point3& x) const {
    return orient3d(at(3 * f), at(3 * f + 1), at(3 * f + 2), x);
  }

  /// A point strictly behind (or, inside out, before) all faces.
  bool find_middle() {
    double scale = 1.0 / static_cast<double>(m_.corners.size());
    for (std::size_t i = 0; i < m_.corners.size(); ++i) {
      middle_.x += scale * at(i).x;
      middle_.y += scale * at(i).y;
      middle_.z += scale * at(i).z;
    }
    behind_ = side(0, middle_);
    if (behind_ == Sign::Zero) return false;
    for (std::size_t f = 1; f < m_.face_count(); ++f) {
      if (side(f, middle_) != behind_) return false;
    }
    return true;
  }

  /// Half-edges by the lesser end of their edge: pairs are neighbours. None: not a closed surface.
  std::optional<bool> are_edges_convex() const {
    const auto next = [](std::size_t c) { return c % 3 == 2 ? c - 2 : c + 1; };
    std::vector<std::uint32_t> begin(m_.points.size() + 1, 0);
    const auto least = [&](std::size_t c) { return std::min(m_.corners[c], m_.corners[next(c)]); };
    for (std::size_t c = 0; c < m_.corners.size(); ++c) ++begin[least(c) + 1];
    for (std::size_t v = 0; v < m_.points.size(); ++v) begin[v + 1] += begin[v];
    std::vector<std::uint32_t> sorted(m_.corners.size()), end(begin.begin(), begin.end() - 1);
    for (std::size_t c = 0; c < m_.corners.size(); ++c) {
      sorted[end[least(c)]++] = static_cast<std::uint32_t>(c);
    }
    for (std::size_t v = 0; v < m_.points.size(); ++v) {
      for (std::uint32_t i = begin[v]; i < begin[v + 1]; i += 2) {
        const std::uint32_t c = sorted[i];
        std::uint32_t j = i + 1;
        while (j < begin[v + 1] && !is_reverse(c, sorted[j])) ++j;
        if (j >= begin[v + 1]) return std::nullopt;
        std::swap(sorted[i + 1], sorted[j]);
        const Sign sign = side(c / 3, at(next(next(sorted[i + 1]))));
        if (sign != behind_ && sign != Sign::Zero) return false;
      }
    }
    return true;
  }
  bool is_reverse(std::size_t c, std::size_t d) const {
    const auto next = [](std::size_t i) { return i % 3 == 2 ? i - 2 : i + 1; };
    return m_.corners[c] == m_.corners[next(d)] && m_.corners[d] == m_.corners[next(c)];
  }

  /// The ray from the middle through the middle of face 0.
  std::optional<bool> is_covered_once() const {
    const auto third = [&](double Point3::*x) {
      return at(0).*x / 3 + at(1).*x / 3 + at(2).*x / 3;
    };
    const Point3 through{third(&Point3::x), third(&Point3::y), third(&Point3::z)};
    const Sign inside = orient3d(middle_, through, at(0), at(1));
    std::size_t count = 0;
    for (std::size_t f = 0; f < m_.face_count(); ++f) {
      bool is_close = false, is_hit = true;
      for (std::size_t i = 0; i < 3 && is_hit; ++i) {
        const Sign sign = orient3d(middle_, through, at(3 * f + i), at(3 * f + (i + 1) % 3));
        is_hit = sign == inside || sign == Sign::Zero;
        is_close |= sign == Sign::Zero;
      }
      if (is_hit && is_close) return std::nullopt;
      if (is_hit) ++count;
    }
    return count == 1;
  }

  const PolygonMesh& m_;
  Point3 middle_{0, 0, 0};
  Sign behind_ = Sign::Zero;
};

/// An embedded closed surface in one part?
bool is_plain(const MeshComplex& mesh) {
  const MeshReport& report = mesh.report;
  return report.is_closed() && !report.crosses_itself() && report.doubled.empty() &&
         mesh.is_inside_out.size() == 1 &&
         std::all_of(mesh.jump.begin(), mesh.jump.end(),
                     [](std::int32_t jump) { return jump == 1 || jump == -1; });
}

// ---------------------------------------------------------------- edges

/// Does the wedge after the use span more than half a turn? (The header of space_convexity.cpp's test.)
bool is_wide_after(const SpaceComplex& c, EdgeId e, UseId u) {
  const UseId v = c.use_radial[u.value()];
  if (v == u) return true;
  const PlaneId n1 = c.facet_plane[c.use_facet[u.value()].value()];
  const PlaneId n2 = c.facet_plane[c.use_facet[v.value()].value()];
  if (n1 == n2) return false;
  const auto sense = [&](UseId w) {
    return SpaceComplex::is_reverse(c.use_halfedge[w.value()]) ? Sign::Negative : Sign::Positive;
  };
  const auto& [p, q] = c.edge_planes[e.value()];
  return sense(u) * sense(v) * same_direction(c.planes(), p, q, n1, n2) == Sign::Negative;
}

/// Edges with a wide wedge that is inside: by the use before it.
template <class IsInside>
std::vector<EdgeId> wide_edges(const SpaceComplex& c, IsInside&& is_inside_after) {
  std::vector<EdgeId> wide;
  for (std::size_t e = 0; e < c.edge_count(); ++e) {
    const UseId first = c.edge_use[e];
    if (c.edge_mark[e] == kBeyond || !first.is_valid()) continue;
    bool is_wide = false;
    UseId u = first;
    do {
      is_wide = is_inside_after(u) && is_wide_after(c, EdgeId(e), u);
      u = c.use_radial[u.value()];
    } while (u != first && !is_wide);
    if (is_wide) wide.push_back(EdgeId(e));
  }
  return wide;
}

// ---------------------------------------------------------------- faces

/// Facets with vertices on both sides; `outer` is the side of the plane that is outside.
template <class Outer>
std::vector<FailingFace> failing_facets(const SpaceComplex& c, Outer&& outer, Context& context) {
  std::vector<VertexId> ends;  // of edges that are not the frame's
  std::vector<std::uint8_t> is_end(c.vertex_count(), 0);
  for (std::size_t h = 0; h < c.origin.size(); ++h) {
    if (c.edge_mark[h / 2] != kBeyond) is_end[c.origin[h].value()] = 1;
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

/// Faces and vertices by their numbers in the mesh; a face that was cut into triangles is listed once.
void number_as_input(std::vector<FailingFace>& faces, const PolygonMesh& mesh,
                     const SpaceComplex& c) {
  SpaceTables tables;  // filled as those of the complex were
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

bool is_convex_mesh(const PolygonMesh& mesh, Context& context) {
  if (const std::optional<bool> known = TriangleTest(mesh).run()) return *known;
  MeshComplex complex = complex_of_mesh(mesh, {}, context);
  return is_plain(complex) &&
         Nef3::mesh(std::move(complex), WindingRule::NonZero, context).is_convex();
}

ConvexityEvidence convexity_of_mesh(const PolygonMesh& mesh, Context& context) {
  ConvexityEvidence evidence;
  evidence.is_convex = is_convex_mesh(mesh, context);
  if (evidence.is_convex) return evidence;
  const MeshComplex m = complex_of_mesh(mesh, {.surface = true}, context);
  const SpaceComplex& c = m.complex;
  const auto turned = [&](FacetId f) {  // the sign of what is inside
    const bool is_out = !m.is_inside_out.empty() && m.is_inside_out[m.component[f.value()]] != 0;
    return (m.jump[f.value()] > 0) != is_out ? Sign::Positive : Sign::Negative;
  };
  if (is_plain(m)) {
    const auto is_inside_after = [&](UseId u) {
      const bool is_negative_side = SpaceComplex::is_reverse(c.use_halfedge[u.value()]);
      return (turned(c.use_facet[u.value()]) == Sign::Negative) == is_negative_side;
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
      wide_edges(c, [&](UseId u) { return c.volume_mark[c.volume_after(u).value()] == 1; });
  for (std::size_t e = 0; e < c.edge_count(); ++e) {
    const bool is_free = !c.edge_use[e].is_valid() && c.edge_mark[e] != kBeyond;
    if (is_free && c.volume_mark[c.edge_volume[e].value()] == 1) edges.push_back(EdgeId(e));
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
        const auto& [above, below] = c.facet_volume[f.value()];
        return c.volume_mark[above.value()] == 1 && c.volume_mark[below.value()] != 1
                   ? Sign::Negative
                   : Sign::Positive;
      },
      context);
  return evidence;
}

}  // namespace plumb
