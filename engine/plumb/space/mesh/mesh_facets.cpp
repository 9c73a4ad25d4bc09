// Makes simple polygons in planes of the faces of a mesh.
//
// Repeated corners, and corners between two equal corners, are removed. The plane of a face is
// found from three corners far apart; whether all others lie on it is decided exactly, so the
// choice of corners affects only the speed. A face that is not planar or not simple becomes
// triangles: constrained Delaunay triangles if its edges, seen along the axis of its largest area,
// meet in corners only, else a fan from one corner. All have the boundary of the polygon as an
// integer chain, which is what winding numbers need (docs/design/meshes.md, "Winding numbers").
// Faces without area contribute only their edges.
//
// Newell's normal, twice the area of the polygon seen along each axis, chooses that axis: in
// doubles where an error bound separates the largest area, else exactly, so that the choice depends
// on the polygon only.
//
// Tested by tests/space/from_mesh_test.cpp.

#include "plumb/space/mesh/mesh_facets.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "plumb/predicates/arithmetic/fingerprint.h"
#include "plumb/predicates/arithmetic/vectors.h"
#include "plumb/predicates/point3_signs.h"
#include "plumb/space/planar/facet_triangles.h"

namespace plumb {
namespace {

using Vector3 = std::array<double, 3>;

/// Returns the largest magnitude of a coordinate.
double largest(const Vector3& v) {
  return std::max({std::fabs(v[0]), std::fabs(v[1]), std::fabs(v[2])});
}

// ---------------------------------------------------------------- 1. corners

/// A face given by its vertices, after trimming.
struct Loop {
  std::span<const std::uint32_t> corners;
  std::uint32_t face;
};

/// The remaining parts of the faces after trimming.
struct Loops {
  std::vector<std::uint32_t> corner;       ///< The vertices of all loops.
  std::vector<std::uint32_t> begin = {0};  ///< Where each loop starts in `corner`, and the end.
  std::vector<std::uint32_t> face;         ///< The face of each loop.

  std::size_t size() const { return face.size(); }
  Loop at(std::size_t i) const {
    return {std::span(corner).subspan(begin[i], begin[i + 1] - begin[i]), face[i]};
  }
  /// Makes a loop of the corners since the last loop.
  void close(std::uint32_t f) {
    face.push_back(f);
    begin.push_back(static_cast<std::uint32_t>(corner.size()));
  }
};

/// Adds a face with three different corners, which needs no trimming, as nearly all faces are.
/// Returns false for any other face.
bool take_triangle(std::span<const std::uint32_t> face, std::uint32_t f,
                   const MeshVertices& vertices, Loops& loops) {
  if (face.size() != 3) return false;
  const IndexTriangle t{vertices.of_point[face[0]], vertices.of_point[face[1]],
                        vertices.of_point[face[2]]};
  if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0]) return false;
  for (const std::uint32_t v : t) loops.corner.push_back(v);
  loops.close(f);
  return true;
}

/// Returns all faces, trimmed. A face with fewer than three corners left has no area; its edges
/// cancel.
Loops trimmed_loops(const MeshView& mesh, const MeshVertices& vertices, MeshReport& report) {
  Loops loops;
  loops.corner.reserve(mesh.corners.size());
  loops.begin.reserve(mesh.face_count() + 1);
  loops.face.reserve(mesh.face_count());
  for (std::uint32_t f = 0; f < mesh.face_count(); ++f) {
    const auto face = mesh.face(f);
    if (take_triangle(face, f, vertices, loops)) continue;
    const std::size_t first = loops.corner.size();
    for (const std::uint32_t p : face) push_corner(loops.corner, first, vertices.of_point[p]);
    trim_ends(loops.corner, first);
    const std::size_t size = loops.corner.size() - first;
    if (size < face.size()) report.trimmed.push_back(f);
    if (size < 3) {
      loops.corner.resize(first);
      report.degenerate.push_back(f);
    } else {
      loops.close(f);
    }
  }
  return loops;
}

// ---------------------------------------------------------------- 2. planes

using Corners = std::span<const std::uint32_t>;

/// The point of each vertex of the mesh, in the tables.
struct VertexPoints {
  std::span<const SpacePoint> point;
  const Point3Table& table;

  SpacePoint operator[](std::uint32_t v) const { return point[v]; }
  /// Returns the middle of the box of the point.
  Vector3 middle(std::uint32_t v) const { return table.box(point[v]).mid; }
};

/// Returns the largest coordinate, or 1 if it is so small that its inverse overflows.
double reach(const VertexPoints& points, Corners corners) {
  double reach = 0;
  for (const std::uint32_t v : corners) reach = std::max(reach, largest(points.middle(v)));
  return reach > 0x1p-1000 ? reach : 1;
}

/// Returns three corners that are far apart: the first corner, the corner that is farthest from it,
/// and the corner that is farthest from their line. The choice affects only the speed. Any three
/// corners that are not collinear are sufficient.
IndexTriangle widest_triple(const VertexPoints& points, Corners corners) {
  const double scale = 1 / reach(points, corners);
  const auto from_first = [&](std::uint32_t v) {
    const auto p = points.middle(v);
    const auto o = points.middle(corners[0]);
    return Vector3{p[0] * scale - o[0] * scale, p[1] * scale - o[1] * scale,
                   p[2] * scale - o[2] * scale};
  };
  std::uint32_t far = corners[1], wide = corners[2];
  double best = 0;
  for (const std::uint32_t v : corners) {
    const double d = largest(from_first(v));
    if (d > best) best = d, far = v;
  }
  best = 0;
  for (const std::uint32_t v : corners) {
    const double area = largest(cross(from_first(far), from_first(v)));
    if (area > best) best = area, wide = v;
  }
  return {corners[0], far, wide};
}

/// The homogeneous coordinates of vertices, in lowest terms. The coordinates of a vertex are
/// computed at the first request, because several faces need them.
class HomogeneousVertices {
 public:
  HomogeneousVertices(std::span<const SpacePoint> point, const Point3Table& table)
      : point_(point), table_(table) {}

  const IntegerRow& operator[](std::uint32_t v) {
    if (rows_.empty()) rows_.resize(point_.size());
    if (!rows_[v]) rows_[v] = primitive(homogeneous(table_, point_[v]));
    return *rows_[v];
  }

 private:
  std::span<const SpacePoint> point_;
  const Point3Table& table_;
  std::vector<std::optional<IntegerRow>> rows_;
};

/// Returns the plane of three points, with the side positive from which they are seen
/// counter-clockwise; invalid if they lie on a line. The points have homogeneous coordinates with
/// positive weights. Whole numbers need one gcd for the plane, and fractions one for each sum.
OrientedPlane plane_through(PlaneTable& planes, const IntegerRow& a, const IntegerRow& b,
                            const IntegerRow& c) {
  const auto from_a = [&a](const IntegerRow& p) {
    const auto coordinate = [&](std::size_t k) { return Integer(p[k] * a[3] - a[k] * p[3]); };
    return std::array<Integer, 3>{coordinate(0), coordinate(1), coordinate(2)};
  };
  const std::array<Integer, 3> n = cross(from_a(b), from_a(c));
  if (n[0].is_zero() && n[1].is_zero() && n[2].is_zero()) return {};
  const Integer offset = -(n[0] * a[0] + n[1] * a[1] + n[2] * a[2]);
  const IntegerRow row = primitive({n[0] * a[3], n[1] * a[3], n[2] * a[3], offset});
  return planes.intern(row[0], row[1], row[2], row[3]);
}

/// Returns the plane of each loop, given by three of its corners. The id is invalid if these are
/// collinear. Planes through input points are interned all at once.
std::vector<OrientedPlane> planes_of(const Loops& loops, std::span<const SpacePoint> point,
                                     SpaceTables& tables) {
  HomogeneousVertices homogeneous(point, tables.points);
  std::vector<std::array<InputPointId, 3>> triples;
  std::vector<std::uint32_t> loop_of_triple;
  std::vector<OrientedPlane> plane(loops.size());
  const VertexPoints points{point, tables.points};
  for (std::uint32_t i = 0; i < loops.size(); ++i) {
    const Corners corners = loops.at(i).corners;
    // For triangles, there is no choice. For polygons, three corners that are far apart are used.
    const IndexTriangle t = corners.size() == 3 ? IndexTriangle{corners[0], corners[1], corners[2]}
                                                : widest_triple(points, corners);
    const SpacePoint a = point[t[0]], b = point[t[1]], c = point[t[2]];
    if (a.is_input() && b.is_input() && c.is_input()) {
      triples.push_back({a.input(), b.input(), c.input()});
      loop_of_triple.push_back(i);
    } else {
      plane[i] =
          plane_through(tables.planes, homogeneous[t[0]], homogeneous[t[1]], homogeneous[t[2]]);
    }
  }
  std::vector<OrientedPlane> found(triples.size());
  tables.planes.intern_triangles(triples, found);
  for (std::size_t k = 0; k < found.size(); ++k) plane[loop_of_triple[k]] = found[k];
  return plane;
}

// ---------------------------------------------------------------- views of polygons

/// Computes Newell's normal in doubles, with a bound for the error of each coordinate: sums of n
/// products of differences from the first corner, each off by less than 8 roundings of their
/// largest square, and each sum by n more. Returns false if rounding is not the only loss.
bool approximate_newell(const VertexPoints& points, Corners corners, Vector3& sum, double& bound) {
  const std::size_t n = corners.size();
  double reach = 0;
  Vector3 before{};
  for (std::size_t i = 1; i < n; ++i) {
    if (!points[corners[0]].is_input() || !points[corners[i]].is_input()) return false;
    const auto p = points.middle(corners[i]);
    const auto o = points.middle(corners[0]);
    const Vector3 d{p[0] - o[0], p[1] - o[1], p[2] - o[2]};
    const Vector3 term = cross(before, d);
    for (std::size_t k = 0; k < 3; ++k) sum[k] += term[k];
    reach = std::max(reach, largest(d));
    before = d;
  }
  const double count = static_cast<double>(n);
  bound = count * (count + 8) * 0x1p-51 * reach * reach;
  return reach > 0x1p-400 && reach < 0x1p400;
}

std::array<Rational, 3> coordinates(const VertexPoints& points, std::uint32_t v) {
  const RationalPoint3 p = exact(points.table, points[v]);
  return {p.x, p.y, p.z};
}

/// Returns the view of newell_view(), computed with rationals.
FlatView exact_newell_view(const VertexPoints& points, Corners corners) {
  std::array<Rational, 3> sum;
  std::array<Rational, 3> before = coordinates(points, corners.back());
  for (const std::uint32_t v : corners) {
    std::array<Rational, 3> p = coordinates(points, v);
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
      sum[k] += before[i] * p[j] - before[j] * p[i];
    }
    before = std::move(p);
  }
  std::size_t axis = 0;
  for (std::size_t k = 1; k < 3; ++k) {
    if (abs(sum[k]) > abs(sum[axis])) axis = k;
  }
  return {axis, sum[axis] < 0};
}

/// Returns the view along the axis in which the polygon has the largest area, from the side on
/// which it runs counter-clockwise. Of equal areas the first axis is taken.
FlatView newell_view(const VertexPoints& points, Corners corners) {
  Vector3 sum{};
  double bound = 0;
  const bool is_sure = approximate_newell(points, corners, sum, bound);
  std::array<double, 3> size{std::fabs(sum[0]), std::fabs(sum[1]), std::fabs(sum[2])};
  std::sort(size.begin(), size.end());
  // The error of both areas is less than `bound`, so a larger gap determines their order.
  if (!is_sure || !(size[2] - size[1] > 2 * bound)) return exact_newell_view(points, corners);
  std::size_t axis = 0;
  while (std::fabs(sum[axis]) != size[2]) ++axis;
  return {axis, sum[axis] < 0};
}

// ---------------------------------------------------------------- 3. facets

/// Adds the facets of one loop after the other. It is a class because all loops share the buffers
/// of the current polygon.
class FacetMaker {
 public:
  FacetMaker(const Loops& loops, std::span<const SpacePoint> point, SpaceTables& tables,
             MeshReport& report, Context& context)
      : tables_(tables),
        points_{point, tables.points},
        report_(report),
        context_(context),
        flat_(tables.points) {
    facets_.begin.reserve(loops.size() + 1);
    facets_.plane.reserve(loops.size());
    facets_.jump.reserve(loops.size());
    facets_.origin.reserve(loops.size());
    facets_.corner.reserve(loops.corner.size());
  }

  /// Adds the facet or facets of a loop. `plane` is the result of planes_of().
  void add(const Loop& loop, OrientedPlane plane) {
    if (loop.corners.size() == 3) {
      add_triangle(loop, plane);
    } else {
      add_polygon(loop, plane);
    }
  }
  /// Returns the facets, and removes them from this object.
  MeshFacets take() { return std::move(facets_); }

 private:
  /// Adds a facet whose corners are counter-clockwise seen from the positive side of `plane`. The
  /// facet lists them counter-clockwise seen from the canonical side, beginning with the least
  /// corner.
  void add_facet(Corners corners, OrientedPlane plane, std::uint32_t face) {
    const std::size_t last = corners.size() - 1;
    auto i = static_cast<std::size_t>(std::ranges::min_element(corners) - corners.begin());
    for (std::size_t k = 0; k <= last; ++k) {
      facets_.corner.push_back(corners[i]);
      if (plane.is_opposite()) {
        i = i == 0 ? last : i - 1;
      } else {
        i = i == last ? 0 : i + 1;
      }
    }
    facets_.begin.push_back(static_cast<std::uint32_t>(facets_.corner.size()));
    facets_.plane.push_back(plane.plane());
    facets_.jump.push_back(plane.is_opposite() ? 1 : -1);
    facets_.origin.push_back(face);
  }

  /// Adds the edges of a face without area.
  void add_loose(Corners corners) {
    for (std::size_t i = 0; i < corners.size(); ++i) {
      facets_.loose.push_back({corners[i], corners[(i + 1) % corners.size()]});
    }
  }

  void add_triangle(const Loop& loop, OrientedPlane plane) {
    if (plane.is_valid()) {
      add_facet(loop.corners, plane, loop.face);
    } else {
      add_loose(loop.corners);
      report_.degenerate.push_back(loop.face);
    }
  }

  /// Adds a face with at least four corners. It becomes one facet if it is planar and simple;
  /// otherwise, it is triangulated.
  void add_polygon(const Loop& loop, OrientedPlane by_widest) {
    const OrientedPlane plane = by_widest.is_valid() ? by_widest : any_plane(loop.corners);
    if (!plane.is_valid()) {
      add_loose(loop.corners);
      report_.degenerate.push_back(loop.face);
    } else if (is_planar(loop.corners, plane.plane())) {
      view(loop.corners, FlatView::of_plane(tables_.planes, plane.plane()));
      // Seen along an axis that crosses its plane, the polygon is simple if and only if it is
      // simple in the plane. Its orientation in this view determines its outer side.
      const PolygonShape shape = shape_of(flat_, local_, context_);
      if (shape == PolygonShape::Simple) {
        const bool is_opposite = orientation_of(flat_, local_) == Sign::Negative;
        add_facet(loop.corners, {plane.plane(), is_opposite}, loop.face);
      } else {
        add_pieces(loop, shape);
      }
    } else {
      report_.not_planar.push_back(loop.face);
      view(loop.corners, newell_view(points_, loop.corners));
      add_pieces(loop, shape_of(flat_, local_, context_));
    }
  }

  /// Returns the plane of three consecutive corners. The id is invalid if all corners are
  /// collinear. If every three neighbours are collinear, all corners are, because neighbours
  /// differ.
  OrientedPlane any_plane(Corners corners) const {
    OrientedPlane plane;
    for (std::size_t i = 2; i < corners.size() && !plane.is_valid(); ++i) {
      plane =
          plane_through(tables_, point(corners[i - 2]), point(corners[i - 1]), point(corners[i]));
    }
    return plane;
  }

  bool is_planar(Corners corners, PlaneId plane) const {
    return std::all_of(corners.begin(), corners.end(), [&](std::uint32_t v) {
      return side(tables_.points, point(v), plane) == Sign::Zero;
    });
  }

  // ---------------------------------------------------------------- polygons as triangles

  /// Projects the polygon to a plane. The array flat_ has its vertices in ascending order, and
  /// local_ has the index of each corner in flat_.
  void view(Corners corners, FlatView view) {
    shown_.assign(corners.begin(), corners.end());
    std::sort(shown_.begin(), shown_.end());
    shown_.erase(std::unique(shown_.begin(), shown_.end()), shown_.end());
    flat_.reset(view);
    for (const std::uint32_t v : shown_) flat_.push_back(point(v));
    local_.clear();
    for (const std::uint32_t v : corners) {
      const auto at = std::lower_bound(shown_.begin(), shown_.end(), v);
      local_.push_back(static_cast<std::uint32_t>(at - shown_.begin()));
    }
  }

  /// Adds triangles with the boundary of the polygon.
  void add_pieces(const Loop& loop, PolygonShape shape) {
    if (shape != PolygonShape::Simple) report_.not_simple.push_back(loop.face);
    pieces_.clear();
    if (shape == PolygonShape::Crossing || !add_delaunay_pieces()) add_fan_pieces();
    for (const IndexTriangle& t : pieces_) {
      const IndexTriangle v{shown_[t[0]], shown_[t[1]], shown_[t[2]]};
      const OrientedPlane plane = plane_through(tables_, point(v[0]), point(v[1]), point(v[2]));
      if (plane.is_valid()) {
        add_facet(v, plane, loop.face);
      } else {
        add_loose(v);
      }
    }
  }

  /// Makes constrained Delaunay triangles with the orientation of the polygon. Returns false if
  /// neither the polygon nor its reverse bounds a region.
  bool add_delaunay_pieces() {
    // The region lies to the left of a counter-clockwise polygon. A clockwise polygon is reversed
    // before it is triangulated, and its triangles are reversed afterwards.
    std::vector<IndexEdge> edges = boundary_of(local_);
    if (!triangulate(flat_, edges, pieces_)) {
      for (IndexEdge& e : edges) std::swap(e[0], e[1]);
      if (!triangulate(flat_, edges, pieces_)) return false;
      make_delaunay(flat_, edges, pieces_);
      for (IndexTriangle& t : pieces_) std::swap(t[1], t[2]);
      return true;
    }
    make_delaunay(flat_, edges, pieces_);
    return true;
  }

  /// Makes a fan of triangles that wind around every point as often as the polygon does.
  void add_fan_pieces() {
    for (std::size_t i = 2; i < local_.size(); ++i) {
      const IndexTriangle t{local_[0], local_[i - 1], local_[i]};
      if (t[0] != t[1] && t[1] != t[2] && t[2] != t[0]) pieces_.push_back(t);
    }
  }

  SpacePoint point(std::uint32_t v) const { return points_[v]; }

  SpaceTables& tables_;
  VertexPoints points_;
  MeshReport& report_;
  Context& context_;
  MeshFacets facets_;
  FlatPoints flat_;                   // The points of the current polygon.
  std::vector<std::uint32_t> shown_;  // For each point of flat_, its vertex.
  std::vector<std::uint32_t> local_;  // For each corner, its point in flat_.
  std::vector<IndexTriangle> pieces_;
};

// ---------------------------------------------------------------- meshes of triangles

/// Whether all faces are triangles with three different corners at input points, as in nearly all
/// meshes of triangles. They need no trimming, and their planes are interned in order.
bool has_plain_triangles_only(const MeshView& mesh, const MeshVertices& vertices) {
  if (mesh.corners.size() != 3 * mesh.face_count()) return false;
  for (std::size_t f = 0; f < mesh.face_begin.size(); ++f) {
    if (mesh.face_begin[f] != 3 * f) return false;
  }
  for (std::size_t i = 0; i < mesh.corners.size(); i += 3) {
    const std::uint32_t a = vertices.of_point[mesh.corners[i]],
                        b = vertices.of_point[mesh.corners[i + 1]],
                        c = vertices.of_point[mesh.corners[i + 2]];
    if (a == b || b == c || c == a) return false;
  }
  return std::ranges::all_of(vertices.point, &SpacePoint::is_input);
}

/// Returns the planes of all faces. The id is invalid for faces without area.
std::vector<OrientedPlane> planes_of_triangles(const MeshView& mesh, const MeshVertices& vertices,
                                               SpaceTables& tables) {
  std::vector<std::array<InputPointId, 3>> triples(mesh.face_count());
  const std::uint32_t* corner = mesh.corners.data();
  for (auto& triple : triples) {
    for (InputPointId& p : triple) p = vertices.point[vertices.of_point[*corner++]].input();
  }
  std::vector<OrientedPlane> planes(triples.size());
  tables.planes.intern_triangles(triples, planes);
  return planes;
}

/// Computes the result of FacetMaker for a mesh for which has_plain_triangles_only() holds.
MeshFacets flatten_triangles(const MeshView& mesh, const MeshVertices& vertices,
                             SpaceTables& tables, MeshReport& report, Context& context) {
  const std::vector<OrientedPlane> planes = planes_of_triangles(mesh, vertices, tables);
  MeshFacets facets;
  facets.corner.resize(mesh.corners.size());
  facets.plane.reserve(planes.size());
  facets.jump.reserve(planes.size());
  facets.origin.reserve(planes.size());
  std::size_t corners = 0;
  for (std::uint32_t f = 0; f < planes.size(); ++f) {
    if (f % 4096 == 0) context.checkpoint("planes of faces", f, planes.size());
    const std::uint32_t* const face = mesh.corners.data() + 3 * std::size_t{f};
    const IndexTriangle t{vertices.of_point[face[0]], vertices.of_point[face[1]],
                          vertices.of_point[face[2]]};
    if (!planes[f].is_valid()) {
      for (std::size_t i = 0; i < 3; ++i) facets.loose.push_back({t[i], t[i == 2 ? 0 : i + 1]});
      report.degenerate.push_back(f);
      continue;
    }
    const std::size_t least = t[0] < t[1] ? (t[0] < t[2] ? 0 : 2) : (t[1] < t[2] ? 1 : 2);
    const std::size_t ahead = least == 2 ? 0 : least + 1, behind = least == 0 ? 2 : least - 1;
    const bool is_opposite = planes[f].is_opposite();
    facets.corner[corners] = t[least];
    facets.corner[corners + 1] = t[is_opposite ? behind : ahead];
    facets.corner[corners + 2] = t[is_opposite ? ahead : behind];
    corners += 3;
    facets.plane.push_back(planes[f].plane());
    facets.jump.push_back(is_opposite ? 1 : -1);
    facets.origin.push_back(f);
  }
  facets.corner.resize(corners);
  facets.begin.resize(facets.size() + 1);
  for (std::uint32_t f = 0; f < facets.begin.size(); ++f) facets.begin[f] = 3 * f;
  return facets;
}

}  // namespace

void push_corner(std::vector<std::uint32_t>& corner, std::size_t first, std::uint32_t v) {
  const std::size_t size = corner.size() - first;
  if (size >= 1 && corner.back() == v) return;
  if (size >= 2 && corner[corner.size() - 2] == v) {
    corner.pop_back();
    return;
  }
  corner.push_back(v);
}

void trim_ends(std::vector<std::uint32_t>& corner, std::size_t first) {
  std::size_t begin = first, end = corner.size();
  const auto is_spike = [&](std::size_t before, std::size_t after) {
    return end - begin >= 3 && corner[before] == corner[after];
  };
  while (end - begin >= 2) {
    if (corner[end - 1] == corner[begin] || is_spike(end - 2, begin)) {
      --end;
    } else if (is_spike(end - 1, begin + 1)) {
      ++begin;
    } else {
      break;
    }
  }
  corner.resize(end);
  corner.erase(corner.begin() + static_cast<std::ptrdiff_t>(first),
               corner.begin() + static_cast<std::ptrdiff_t>(begin));
}

// Input points define the plane by their ids, and other points by the coefficients of (b - a) x (c
// - a).
OrientedPlane plane_through(SpaceTables& tables, SpacePoint a, SpacePoint b, SpacePoint c) {
  if (a.is_input() && b.is_input() && c.is_input()) {
    return tables.planes.intern(a.input(), b.input(), c.input());
  }
  return plane_through(tables.planes, homogeneous(tables.points, a), homogeneous(tables.points, b),
                       homogeneous(tables.points, c));
}

MeshFacets flatten_mesh(const MeshView& mesh, const MeshVertices& vertices, SpaceTables& tables,
                        MeshReport& report, Context& context) {
  if (has_plain_triangles_only(mesh, vertices)) {
    return flatten_triangles(mesh, vertices, tables, report, context);
  }
  const Loops loops = trimmed_loops(mesh, vertices, report);
  const std::vector<OrientedPlane> planes = planes_of(loops, vertices.point, tables);
  FacetMaker maker(loops, vertices.point, tables, report, context);
  for (std::size_t i = 0; i < loops.size(); ++i) {
    if (i % 4096 == 0) context.checkpoint("planes of faces", i, loops.size());
    maker.add(loops.at(i), planes[i]);
  }
  std::sort(report.degenerate.begin(), report.degenerate.end());
  return maker.take();
}

}  // namespace plumb
