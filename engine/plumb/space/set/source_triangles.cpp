// Places the triangles of sources, and compares the functions that their channels are.
//
// The points of a source that was not moved are input points of the tables, and its planes are
// interned from three input points, many at a time. Moved points are exact; the plane of a moved
// triangle is interned from its exact coefficients. In both cases the table gives equal planes the
// same id, which is what everything else rests on.
//
// Two triangles of a plane have the same channel if its function over the first triangle, which is
// affine, takes the values of the second triangle at the corners of the second one. The test is
// exact in the doubles of the channel.
//
// Tested by tests/space/mesh_with_attributes_test.cpp.
#include "plumb/space/set/source_triangles.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "plumb/predicates/point3_signs.h"
#include "plumb/space/planar/triangulate.h"
#include "plumb/space/repair_mesh.h"

namespace plumb {
namespace {

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

std::vector<SpacePoint> places_of(const PolygonMesh& mesh, const AffineMap3& map,
                                  SpaceTables& tables) {
  std::vector<SpacePoint> places(mesh.points.size());
  const bool is_placed = is_identity(map);
  if (is_placed) {
    const std::uint32_t first = tables.planes.add_points(mesh.points).value();
    for (std::uint32_t i = 0; i < places.size(); ++i) {
      places[i] = SpacePoint(InputPointId(first + i));
    }
    for (const auto& [i, p] : mesh.exact) places[i] = add_point(tables, p);
    return places;
  }
  std::size_t next_exact = 0;
  for (std::uint32_t i = 0; i < places.size(); ++i) {
    const bool is_exact = next_exact < mesh.exact.size() && mesh.exact[next_exact].first == i;
    const Point3& p = mesh.points[i];
    const RationalPoint3 at =
        is_exact ? mesh.exact[next_exact++].second : RationalPoint3{p.x, p.y, p.z};
    places[i] = add_point(tables, image(map, at));
  }
  return places;
}

/// Returns the places of three points of a plane, counter-clockwise seen from above.
std::vector<SpacePoint> places_of(const Plane3& plane, const AffineMap3& map, SpaceTables& tables) {
  const RationalPoint3 n{plane.a, plane.b, plane.c};
  const Rational scale = -plane.d / (n.x * n.x + n.y * n.y + n.z * n.z);
  const RationalPoint3 at{n.x * scale, n.y * scale, n.z * scale};
  // u is orthogonal to n, and v is n x u.
  const RationalPoint3 u =
      n.x != 0 || n.y != 0 ? RationalPoint3{-n.y, n.x, 0} : RationalPoint3{1, 0, 0};
  const RationalPoint3 v{n.y * u.z - n.z * u.y, n.z * u.x - n.x * u.z, n.x * u.y - n.y * u.x};
  const auto place = [&](const RationalPoint3& by) {
    return add_point(tables, image(map, {at.x + by.x, at.y + by.y, at.z + by.z}));
  };
  return {place({0, 0, 0}), place(u), place(v)};
}

/// Returns the index of the corner of a face at a point.
std::uint32_t corner_at(const PolygonMesh& mesh, std::uint32_t face, std::uint32_t point) {
  std::uint32_t corner = mesh.face_begin[face];
  while (mesh.corners[corner] != point) ++corner;
  return corner;
}

/// Calls visit(face, corners) for each triangle of a mesh.
template <class Visit>
void for_each_triangle(const PolygonMesh& mesh, Context& context, const Visit& visit) {
  const auto is_small = [&](std::uint32_t f) { return mesh.face(f).size() <= 3; };
  std::uint32_t polygons = 0;
  for (std::uint32_t f = 0; f < mesh.face_count(); ++f) polygons += is_small(f) ? 0 : 1;
  PolygonMesh cut;
  if (polygons > 0) cut = triangulated(mesh, context);
  std::uint32_t next = 0;  // The next face of `cut`.
  for (std::uint32_t f = 0; f < mesh.face_count(); ++f) {
    const auto corners = mesh.face(f);
    const std::uint32_t begin = mesh.face_begin[f];
    if (is_small(f)) {
      ++next;
      if (corners.size() == 3) visit(f, std::array{begin, begin + 1, begin + 2});
      continue;
    }
    for (std::size_t i = 2; i < corners.size(); ++i) {
      const auto t = cut.face(next++);
      visit(f, std::array{corner_at(mesh, f, t[0]), corner_at(mesh, f, t[1]),
                          corner_at(mesh, f, t[2])});
    }
  }
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

std::array<Rational, 3> barycentric_weights(const PlaneTable& planes, PlaneId plane,
                                            const std::array<RationalPoint3, 3>& triangle,
                                            const RationalPoint3& at) {
  const FlatView view = FlatView::of_plane(planes, plane);
  const auto shown = [&](const RationalPoint3& p) {
    const std::array<const Rational*, 3> c{&p.x, &p.y, &p.z};
    return RationalPoint2{*c[view.coordinate(0)], *c[view.coordinate(1)]};
  };
  const RationalPoint2 a = shown(triangle[0]);
  const RationalPoint2 u = shown(triangle[1]) - a, v = shown(triangle[2]) - a, x = shown(at) - a;
  const Rational area = u.x * v.y - u.y * v.x;
  Rational second = (x.x * v.y - x.y * v.x) / area, third = (u.x * x.y - u.y * x.x) / area;
  Rational first = 1 - second - third;
  return {std::move(first), std::move(second), std::move(third)};
}

SourceTriangles::SourceTriangles(std::span<const PlacedSource> sources, SpaceTables& tables,
                                 Context& context)
    : sources_(sources), tables_(tables) {
  for (std::uint32_t s = 0; s < sources.size(); ++s) {
    context.checkpoint("place sources", s, sources.size());
    const PolygonMesh& mesh = sources[s].source->mesh;
    const std::size_t first = triangles_.size();
    if (sources[s].source->plane) {
      places_.push_back(places_of(*sources[s].source->plane, sources[s].map, tables));
      triangles_.push_back({s, 0, {0, 1, 2}, {}, false});
      intern_planes(s, first, tables);
      continue;
    }
    places_.push_back(places_of(mesh, sources[s].map, tables));
    for_each_triangle(mesh, context, [&](std::uint32_t f, const std::array<std::uint32_t, 3>& c) {
      triangles_.push_back({s, f, c, {}, false});
    });
    intern_planes(s, first, tables);
  }
  sort_by_plane(tables.planes.size());
}

void SourceTriangles::intern_planes(std::uint32_t source, std::size_t first, SpaceTables& tables) {
  const std::span<SourceTriangle> added = std::span(triangles_).subspan(first);
  const std::vector<SpacePoint>& places = places_[source];
  const bool are_inputs =
      std::all_of(places.begin(), places.end(), [](SpacePoint p) { return p.is_input(); });
  std::vector<OrientedPlane> planes(added.size());
  if (are_inputs) {
    std::vector<std::array<InputPointId, 3>> corners;
    corners.reserve(added.size());
    for (const SourceTriangle& t : added) {
      corners.push_back({place(t, 0).input(), place(t, 1).input(), place(t, 2).input()});
    }
    tables.planes.intern_triangles(corners, planes);
  } else {
    for (std::size_t i = 0; i < added.size(); ++i) {
      std::array<RationalPoint3, 3> t;
      for (std::size_t j = 0; j < 3; ++j) t[j] = exact(tables.points, place(added[i], j));
      planes[i] = plane_through(tables.planes, t);
    }
  }
  // A map that mirrors turns the corners of a triangle around, but not the side of the set.
  const bool is_mirrored = determinant_of(sources_[source].map) < 0;
  for (std::size_t i = 0; i < added.size(); ++i) {
    if (!planes[i].is_valid()) continue;
    added[i].plane = planes[i].plane();
    added[i].is_opposite = planes[i].is_opposite() != is_mirrored;
  }
}

void SourceTriangles::sort_by_plane(std::size_t planes) {
  begin_.assign(planes + 1, 0);
  const auto has_plane = [](const SourceTriangle& t) { return t.plane.is_valid(); };
  for (const SourceTriangle& t : triangles_) {
    if (has_plane(t)) ++begin_[t.plane.value() + std::size_t{1}];
  }
  std::partial_sum(begin_.begin(), begin_.end(), begin_.begin());
  by_plane_.resize(begin_.back());
  std::vector<std::uint32_t> next(begin_.begin(), begin_.end() - 1);
  for (std::uint32_t i = 0; i < triangles_.size(); ++i) {
    if (has_plane(triangles_[i])) by_plane_[next[triangles_[i].plane.value()]++] = i;
  }
}

bool SourceTriangles::has_same_attributes(std::uint32_t s, std::uint32_t t) const {
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

bool SourceTriangles::has_same_channels(const SourceTriangle& s, const SourceTriangle& t) const {
  std::array<RationalPoint3, 3> triangle;
  for (std::size_t i = 0; i < 3; ++i) triangle[i] = exact(tables_.points, place(s, i));
  for (std::size_t i = 0; i < 3; ++i) {
    const std::array<Rational, 3> weights =
        barycentric_weights(tables_.planes, s.plane, triangle, exact(tables_.points, place(t, i)));
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
