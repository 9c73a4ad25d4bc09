// Finds the places of the triangles of sources, and compares the functions that their channels
// represent.
//
// Most planes of a set are defined by the three corners of a source triangle. A facet whose
// facet_origin is the index of this triangle in its source finds it without a search. The remaining
// planes are found by a hash of these corners (planes_by_corners.h). Other triangles of a source
// that was not moved are interned from three input points, many at a time. The plane of a moved
// triangle is computed before the move, and its image is looked up among the planes of facets
// (moved_planes.h), because only triangles in these planes are ever asked for. A moved point gets
// its exact place when it is asked for. In all cases equal planes have the same id. All other steps
// rely on this.
//
// Two triangles of a plane have the same channel if its function over the first triangle, which is
// affine, takes the values of the second triangle at the corners of the second triangle. The test
// is exact in the doubles of the channel.
//
// Tested by tests/space/mesh_with_attributes_test.cpp.
#include "plumb/space/set/source_triangles.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "plumb/predicates/arithmetic/double_bits.h"
#include "plumb/predicates/arithmetic/scaled.h"
#include "plumb/predicates/point3_signs.h"
#include "plumb/predicates/space/point_as_line.h"
#include "plumb/space/planar/triangulate.h"
#include "plumb/space/set/barycentric_form.h"
#include "plumb/space/set/source_faces.h"

namespace plumb {
namespace {

// Moving a point takes some microseconds, and computing the plane of three moved points does, too.
constexpr std::size_t kStepsOfCheckpoint = 1024;
constexpr std::size_t kFacetsOfCheckpoint = 4096;

RationalPoint3 image(const AffineMap3& map, const RationalPoint3& p) {
  const auto row = [&](std::size_t i) {
    const auto& m = map.matrix[i];
    return Rational(m[0] * p.x + m[1] * p.y + m[2] * p.z + map.offset[i]);
  };
  return {row(0), row(1), row(2)};
}

Rational determinant_of(const AffineMap3& map) {
  const auto& m = map.matrix;
  return m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) -
         m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
         m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
}

/// Returns the places of three points of a plane, counter-clockwise seen from above.
std::vector<SpacePoint> places_of(const Plane3& plane, const AffineMap3& map, SpaceTables& tables) {
  const RationalPoint3 n{plane.a, plane.b, plane.c};
  const Rational scale = -plane.d / (n.x * n.x + n.y * n.y + n.z * n.z);
  const RationalPoint3 at{n.x * scale, n.y * scale, n.z * scale};
  // The vector u is orthogonal to n, and v is n x u.
  const RationalPoint3 u =
      n.x != 0 || n.y != 0 ? RationalPoint3{-n.y, n.x, 0} : RationalPoint3{1, 0, 0};
  const RationalPoint3 v{n.y * u.z - n.z * u.y, n.z * u.x - n.x * u.z, n.x * u.y - n.y * u.x};
  const auto place = [&](const RationalPoint3& by) {
    return add_point(tables, image(map, {at.x + by.x, at.y + by.y, at.z + by.z}));
  };
  return {place({0, 0, 0}), place(u), place(v)};
}

OrientedPlane plane_through(PlaneTable& planes, const std::array<RationalPoint3, 3>& t) {
  const RationalPoint3 u = t[1] - t[0], v = t[2] - t[0];
  const Rational a = u.y * v.z - u.z * v.y, b = u.z * v.x - u.x * v.z, c = u.x * v.y - u.y * v.x;
  if (a == 0 && b == 0 && c == 0) return {};
  return planes.intern(a, b, c, Rational(-(a * t[0].x + b * t[0].y + c * t[0].z)));
}

}  // namespace

bool is_identity(const AffineMap3& map) {
  for (std::size_t i = 0; i < 3; ++i) {
    if (map.offset[i] != 0) return false;
    for (std::size_t j = 0; j < 3; ++j) {
      if (map.matrix[i][j] != (i == j ? 1 : 0)) return false;
    }
  }
  return true;
}

std::size_t corner_index(const CornerPoints& corners, const Point3& p) {
  std::size_t i = 0;
  while (i < 3 && (corners[i] == nullptr || *corners[i] != p)) ++i;
  return i;
}

SourceTriangles::SourceTriangles(std::span<const PlacedSource> sources, GrowingComplex& complex,
                                 Context& context)
    : sources_(sources), complex_(complex) {
  std::size_t faces = 0;
  for (const PlacedSource& placed : sources) faces += placed.source->mesh.face_count();
  triangles_.reserve(faces);
  std::vector<std::size_t> first_of_source;
  for (std::uint32_t s = 0; s < sources.size(); ++s) {
    context.check_limits("place sources");
    is_mirrored_.push_back(determinant_of(sources[s].map) < 0 ? 1 : 0);
    first_of_source.push_back(triangles_.size());
    add_triangles(s, context);
  }
  first_of_source.push_back(triangles_.size());
  const std::vector<std::uint8_t> is_found = find_planes_of_facets(first_of_source, context);
  std::optional<PlanesByCorners> known;  // Made for the first triangle that needs it.
  std::optional<MovedPlanes> wanted;     // Made for the first source that was moved.
  for (std::uint32_t s = 0; s < sources.size(); ++s) {
    context.check_limits("place sources");
    if (moves_[s]) {
      if (!wanted) {
        const auto& planes = complex.get().facet_plane;
        wanted.emplace(complex.tables().planes, planes);
      }
      find_moved_planes(s, first_of_source[s], first_of_source[s + 1], *wanted, context);
      continue;
    }
    std::vector<std::uint32_t> left;
    for (std::size_t t = first_of_source[s]; t < first_of_source[s + 1]; ++t) {
      if (!triangles_[t].plane.is_valid()) left.push_back(static_cast<std::uint32_t>(t));
    }
    if (left.empty()) continue;
    if (!known) known.emplace(complex.tables().planes, is_found);
    find_planes(s, left, *known, context);
  }
  sort_by_plane(planes().size());
}

void SourceTriangles::add_triangles(std::uint32_t source, Context& context) {
  const auto& [mesh_source, map] = sources_[source];
  if (mesh_source->plane) {
    moves_.emplace_back();
    places_.push_back(places_of(*mesh_source->plane, map, complex_.changed_tables()));
    triangles_.push_back({source, 0, {0, 1, 2}, {}, false});
    return;
  }
  moves_.emplace_back();
  if (!is_identity(map)) moves_.back().emplace(map);
  add_exact_points(source, context);
  const auto triangles = triangles_of_source(*mesh_source, context);
  for (const FaceTriangle& t : *triangles) {
    triangles_.push_back({source, t.face, t.corner, {}, false});
  }
}

/// Places the points of a mesh that are not doubles.
void SourceTriangles::add_exact_points(std::uint32_t source, Context& context) {
  const PolygonMesh& mesh = sources_[source].source->mesh;
  places_.emplace_back(mesh.points.size());
  std::size_t steps = 0;
  for (const auto& [i, p] : mesh.exact) {
    if (steps++ % kStepsOfCheckpoint == 0)
      context.checkpoint("place sources", i, mesh.points.size());
    places_.back()[i] =
        add_point(complex_.changed_tables(), moves_[source] ? image(sources_[source].map, p) : p);
  }
}

SpacePoint SourceTriangles::image_of(const MovedPlanes::Map& map, const Point3& point) {
  const int low = std::min(Grid{point.x, point.y, point.z}.low(), 0);
  return add_point(complex_.changed_tables(),
                   map.exact.image_of_point({to_integer(point.x, low), to_integer(point.y, low),
                                             to_integer(point.z, low), shifted(Integer(1), -low)}));
}

/// In a separate table, interns the planes of triangles whose corners are doubles, before they are
/// moved. This is much faster than interning moved planes, and the exact image of a plane is
/// computed only if a facet may lie in it.
void SourceTriangles::find_moved_planes(std::uint32_t source, std::size_t first, std::size_t end,
                                        const MovedPlanes& wanted, Context& context) {
  const PolygonMesh& mesh = sources_[source].source->mesh;
  PlaneTable own;
  own.add_points(mesh.points);
  std::vector<std::uint32_t> by_doubles, others;
  std::vector<std::array<InputPointId, 3>> corners;
  for (auto t = static_cast<std::uint32_t>(first); t < end; ++t) {
    std::array<InputPointId, 3> ids;
    bool has_exact = false;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t p = point_index(triangles_[t], i);
      has_exact = has_exact || places_[source][p].is_valid();
      ids[i] = InputPointId(p);
    }
    (has_exact ? others : by_doubles).push_back(t);
    if (!has_exact) corners.push_back(ids);
  }
  std::vector<OrientedPlane> planes(corners.size());
  own.intern_triangles(corners, planes);
  std::vector<std::optional<OrientedPlane>> image(own.size());
  for (std::size_t i = 0; i < planes.size(); ++i) {
    if (i % kStepsOfCheckpoint == 0) context.checkpoint("planes of sources", i, planes.size());
    if (!planes[i].is_valid()) continue;
    auto& known = image[planes[i].plane().value()];
    if (!known) known = wanted.image_of(own, planes[i].plane(), *moves_[source]);
    if (!known->is_valid()) continue;
    SourceTriangle& triangle = triangles_[by_doubles[i]];
    triangle.plane = known->plane();
    triangle.is_opposite = known->is_opposite() != planes[i].is_opposite();
  }
  intern_planes(others, context);
}

/// Finds the planes of triangles that are facets, or that contain facets. For most facets of a set,
/// facet_origin is the index of their face, and the corners of this face define their plane. The
/// source is not known, so some sources are tried. The corners decide, whatever facet_origin is.
/// Returns 1 for each plane of the table whose triangle was found.
std::vector<std::uint8_t> SourceTriangles::find_planes_of_facets(
    std::span<const std::size_t> first_of_source, Context& context) {
  constexpr std::size_t kMostTries = 4;
  const SpaceComplex& complex = complex_.get();
  std::vector<std::uint8_t> is_found(planes().size(), 0);
  // Sources whose corners are doubles at their places.
  std::vector<std::uint32_t> plain;
  for (std::uint32_t s = 0; s < sources_.size(); ++s) {
    const MeshSource& source = *sources_[s].source;
    if (!moves_[s] && !source.plane && source.mesh.exact.empty()) plain.push_back(s);
  }
  std::size_t likely = 0;  // Facets of one source are consecutive.
  for (std::size_t f = 0; f < complex.facet_count() && !plain.empty(); ++f) {
    if (f % kFacetsOfCheckpoint == 0) {
      context.checkpoint("planes of sources", f, complex.facet_count());
    }
    const PlaneId plane = complex.facet_plane[FacetId(f)];
    if (is_found[plane.value()] != 0) continue;
    const std::uint32_t face = complex.facet_origin[FacetId(f)];
    for (std::size_t k = 0; k < std::min(kMostTries, plain.size()); ++k) {
      const std::uint32_t source = plain[likely];
      const std::size_t t = first_of_source[source] + face;
      if (t < first_of_source[source + 1] && triangles_[t].face == face &&
          take_plane_of_corners(triangles_[t], plane)) {
        is_found[plane.value()] = 1;
        break;
      }
      if (++likely == plain.size()) likely = 0;
    }
  }
  return is_found;
}

/// If the corners of a triangle are doubles at their places and define a plane, assigns this plane
/// to the triangle.
bool SourceTriangles::take_plane_of_corners(SourceTriangle& t, PlaneId plane) const {
  const PolygonMesh& mesh = mesh_of(t);
  PlanesByCorners::Found found;
  const std::array<const Point3*, 3> corners{&mesh.points[mesh.corners[t.corner[0]]],
                                             &mesh.points[mesh.corners[t.corner[1]]],
                                             &mesh.points[mesh.corners[t.corner[2]]]};
  if (!PlanesByCorners::is_defined_by(planes(), plane, corners, found)) return false;
  set_plane(t, found.plane);
  t.input = found.points;
  return true;
}

/// Most planes of a set are defined by the corners of the source triangle itself. A plane that is
/// found in this way needs no arithmetic. The others are interned.
void SourceTriangles::find_planes(std::uint32_t source, std::span<const std::uint32_t> triangles,
                                  const PlanesByCorners& known, Context& context) {
  std::vector<std::uint32_t> hash(places_[source].size(), 0);  // The value is 0 until it is needed.
  // The index is larger than the caches, so a block of triangles is prepared before it is looked
  // up.
  constexpr std::size_t kBlock = 32;
  std::array<std::array<PlanesByCorners::Corner, 3>, kBlock> corners{};
  std::array<std::uint32_t, kBlock> hash_of{};
  std::array<PlaneId, kBlock> candidate;
  std::vector<std::uint32_t> unknown;
  for (std::size_t begin = 0; begin < triangles.size(); begin += kBlock) {
    if (begin % kStepsOfCheckpoint == 0) {
      context.checkpoint("planes of sources", begin, triangles.size());
    }
    const std::size_t count = std::min(kBlock, triangles.size() - begin);
    std::array<bool, kBlock> has_all{};
    for (std::size_t k = 0; k < count; ++k) {
      has_all[k] = true;
      for (std::size_t i = 0; i < 3; ++i) {
        const std::uint32_t p = point_index(triangles_[triangles[begin + k]], i);
        const Point3* const at = doubles(source, p);
        has_all[k] = has_all[k] && at != nullptr;
        if (!has_all[k]) break;
        if (hash[p] == 0) hash[p] = PlanesByCorners::hash_of(*at);
        corners[k][i] = {at, hash[p]};
      }
      if (!has_all[k]) continue;
      hash_of[k] = PlanesByCorners::hash_of_all(corners[k]);
      known.prefetch(hash_of[k]);
    }
    for (std::size_t k = 0; k < count; ++k) {
      candidate[k] = has_all[k] ? known.candidate(hash_of[k]) : PlaneId();
    }
    for (std::size_t k = 0; k < count; ++k) {
      if (candidate[k].is_valid()) known.prefetch_points(candidate[k]);
    }
    for (std::size_t k = 0; k < count; ++k) {
      const auto found =
          candidate[k].is_valid() ? known.find(corners[k], candidate[k]) : PlanesByCorners::Found();
      if (found.plane.is_valid()) {
        set_plane(triangles_[triangles[begin + k]], found.plane);
        triangles_[triangles[begin + k]].input = found.points;
      } else {
        unknown.push_back(triangles[begin + k]);
      }
    }
  }
  intern_planes(unknown, context);
}

void SourceTriangles::set_plane(SourceTriangle& t, OrientedPlane plane) const {
  if (!plane.is_valid()) return;
  t.plane = plane.plane();
  // A map that mirrors reverses the order of the corners of a triangle, but does not change the
  // side of the set.
  t.is_opposite = plane.is_opposite() != (is_mirrored_[t.source] != 0);
}

void SourceTriangles::intern_planes(std::span<const std::uint32_t> triangles, Context& context) {
  std::vector<std::uint32_t> by_inputs;
  std::vector<std::array<InputPointId, 3>> corners;
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    if (i % kStepsOfCheckpoint == 0) {
      context.checkpoint("planes of sources", i, triangles.size());
    }
    const std::uint32_t t = triangles[i];
    SourceTriangle& triangle = triangles_[t];
    const std::array<SpacePoint, 3> at{place(triangle, 0), place(triangle, 1), place(triangle, 2)};
    if (at[0].is_input() && at[1].is_input() && at[2].is_input()) {
      by_inputs.push_back(t);
      corners.push_back({at[0].input(), at[1].input(), at[2].input()});
      continue;
    }
    std::array<RationalPoint3, 3> exact_corners;
    for (std::size_t k = 0; k < 3; ++k) exact_corners[k] = exact(complex_.tables().points, at[k]);
    set_plane(triangle, plane_through(complex_.changed_tables().planes, exact_corners));
  }
  if (by_inputs.empty()) return;
  std::vector<OrientedPlane> planes(by_inputs.size());
  complex_.changed_tables().planes.intern_triangles(corners, planes);
  for (std::size_t i = 0; i < planes.size(); ++i) set_plane(triangles_[by_inputs[i]], planes[i]);
}

/// Sorts the triangles by their planes. Triangles whose plane has no facet are left out.
void SourceTriangles::sort_by_plane(std::size_t planes) {
  std::vector<std::uint8_t> has_facet(planes, 0);
  for (const PlaneId plane : complex_.get().facet_plane) has_facet[plane.value()] = 1;
  begin_.assign(planes + 1, 0);
  const auto is_needed = [&](const SourceTriangle& t) {
    return t.plane.is_valid() && has_facet[t.plane.value()] != 0;
  };
  for (const SourceTriangle& t : triangles_) {
    if (is_needed(t)) ++begin_[t.plane.value() + std::size_t{1}];
  }
  std::partial_sum(begin_.begin(), begin_.end(), begin_.begin());
  std::vector<SourceTriangle> sorted(begin_.back());
  std::vector<std::uint32_t> next(begin_.begin(), begin_.end() - 1);
  for (const SourceTriangle& t : triangles_) {
    if (is_needed(t)) sorted[next[t.plane.value()]++] = t;
  }
  triangles_ = std::move(sorted);
}

bool SourceTriangles::has_definition_of(const SourceTriangle& t, std::size_t i,
                                        SpacePoint p) const {
  const SpacePoint corner = places_[t.source][point_index(t, i)];
  if (p.is_input() || !corner.is_valid() || corner.is_input()) return false;
  if (p == corner) return true;
  const Point3Table& points = complex_.tables().points;
  const PointSource &a = points.source(p), &b = points.source(corner);
  if (a.is_line() || b.is_line()) return false;
  return b.has_plane(a.plane(0)) && b.has_plane(a.plane(1)) && b.has_plane(a.plane(2));
}

std::size_t SourceTriangles::edge_of(const SourceTriangle& t, const CornerPoints& corners,
                                     SpacePoint p) const {
  if (p.is_input()) return 3;
  const SpaceTables& tables = complex_.tables();
  const PointSource line = exact3::as_line(tables.planes, tables.points.source(p));
  if (line.is_line()) {
    const std::size_t i = corner_index(corners, tables.planes.point(line.end(0)));
    const std::size_t j = corner_index(corners, tables.planes.point(line.end(1)));
    if (i < 3 && j < 3 && i != j) return (i + 1) % 3 == j ? i : j;
  }
  return edge_of_neighbour(t, p);
}

/// Returns i if a triangle of the same source that lies in one of the planes of a constructed point
/// has the corners i and i + 1 of triangle t, otherwise 3. The point lies in the plane of t, and so
/// on the line of these corners.
std::size_t SourceTriangles::edge_of_neighbour(const SourceTriangle& t, SpacePoint p) const {
  constexpr std::size_t kMostTriangles = 8;
  const Point3Table& points = complex_.tables().points;
  if (p.is_input() || points.source(p).is_line()) return 3;
  const PointSource& planes = points.source(p);
  const auto has_corner = [&](const SourceTriangle& other, std::size_t i) {
    const std::uint32_t point = point_index(t, i);
    return point_index(other, 0) == point || point_index(other, 1) == point ||
           point_index(other, 2) == point;
  };
  for (std::size_t k = 0; k < 3; ++k) {
    if (planes.plane(k) == t.plane) continue;
    const TriangleRange near = in_plane(planes.plane(k));
    if (near.size() > kMostTriangles) continue;
    for (std::uint32_t n = near.first; n != near.end; ++n) {
      const SourceTriangle& other = triangles_[n];
      if (other.source != t.source || is_plane(other)) continue;
      for (std::size_t i = 0; i < 3; ++i) {
        if (has_corner(other, i) && has_corner(other, (i + 1) % 3)) return i;
      }
    }
  }
  return 3;
}

bool SourceTriangles::has_same_attributes(std::uint32_t s, std::uint32_t t) {
  const SourceTriangle &a = triangles_[s], &b = triangles_[t];
  if (!has_same_face_attributes(a, b) || a.is_opposite != b.is_opposite) return false;
  return sources_[a.source].source->attributes.channels.empty() || has_same_channels(a, b);
}

bool SourceTriangles::has_same_constants(std::uint32_t s, std::uint32_t t) const {
  const SourceTriangle &a = triangles_[s], &b = triangles_[t];
  return has_same_face_attributes(a, b) && sources_[a.source].source->attributes.channels.empty();
}

bool SourceTriangles::has_same_face_attributes(const SourceTriangle& s,
                                               const SourceTriangle& t) const {
  if (s.source != t.source) return false;
  const MeshAttributes& attributes = sources_[s.source].source->attributes;
  const auto is_same = [&](const std::vector<std::uint32_t>& of_face) {
    return of_face.empty() || of_face[s.face] == of_face[t.face];
  };
  return is_same(attributes.face_material) && is_same(attributes.face_group) &&
         is_same(attributes.face_id);
}

bool SourceTriangles::has_same_channels(const SourceTriangle& s, const SourceTriangle& t) {
  std::array<IntegerRow, 3> corners;
  const auto corner_of = [this](const SourceTriangle& of, std::size_t i) {
    const SpacePoint at = place(of, i);  // The call may change the tables.
    return homogeneous(complex_.tables().points, at);
  };
  for (std::size_t i = 0; i < 3; ++i) corners[i] = corner_of(s, i);
  const BarycentricForm form(FlatView::of_plane(planes(), s.plane), corners);
  for (std::size_t i = 0; i < 3; ++i) {
    const std::array<Rational, 3> weights = form.at(corner_of(t, i)).exact();
    for (const MeshChannel& channel : sources_[s.source].source->attributes.channels) {
      if (channel.values.empty()) continue;
      for (std::uint32_t k = 0; k < channel.width; ++k) {
        const auto value = [&](std::uint32_t corner) {
          return channel.values[std::size_t{corner} * channel.width + k];
        };
        Rational sum = 0;
        for (std::size_t j = 0; j < 3; ++j) {
          if (!std::isfinite(value(s.corner[j]))) return false;
          sum += weights[j] * value(s.corner[j]);
        }
        if (!std::isfinite(value(t.corner[i])) || sum != value(t.corner[i])) return false;
      }
    }
  }
  return true;
}

}  // namespace plumb
