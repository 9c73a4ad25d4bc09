#include "generate/surface_scenes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>
#include <optional>

#include "generate/meshes.h"
#include "plumb/predicates/error.h"
#include "plumb/predicates/rational_predicates.h"
#include "plumb/predicates/rounding.h"
#include "plumb/predicates/segment2.h"
#include "plumb/testing/dice.h"

namespace plumb::testing {
namespace {

using Triangles = std::vector<SurfaceTriangle>;

/// Both triangles of the quadrilateral a b c d, counter-clockwise.
void add_quad(Triangles& t, std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
  t.push_back({a, b, c});
  t.push_back({a, c, d});
}

template <class Item>
void shuffle_items(std::vector<Item>& items, Dice& dice) {
  for (std::size_t i = items.size(); i > 1; --i) std::swap(items[i - 1], items[dice.below(i)]);
}

RationalPoint2 flat_point(const SurfaceMesh& mesh, std::uint32_t v) {
  const Point3& p = mesh.point(VertexId(v));
  return {exact_rational(p.x), exact_rational(p.y)};
}

MeshPointer made(std::vector<Point3> points, Triangles triangles) {
  return std::make_shared<const SurfaceMesh>(std::move(points), std::move(triangles));
}

void add_torus(std::vector<Point3>& points, Triangles& triangles, std::uint32_t major,
               std::uint32_t minor, double shift) {
  const auto first = static_cast<std::uint32_t>(points.size());
  const auto id = [&](std::uint32_t i, std::uint32_t j) {
    return first + (i % major) * minor + j % minor;
  };
  for (std::uint32_t i = 0; i < major; ++i) {
    for (std::uint32_t j = 0; j < minor; ++j) {
      const double s = 2 * std::numbers::pi * i / major, t = 2 * std::numbers::pi * j / minor;
      const double r = 1 + 0.4 * std::cos(t);
      points.push_back({shift + r * std::cos(s), r * std::sin(s), 0.4 * std::sin(t)});
      add_quad(triangles, id(i, j), id(i + 1, j), id(i + 1, j + 1), id(i, j + 1));
    }
  }
}

}  // namespace

MeshPointer grid_mesh(std::uint32_t columns, std::uint32_t rows, std::uint64_t shuffle) {
  std::vector<std::uint32_t> name(std::size_t{columns + 1} * (rows + 1));
  std::iota(name.begin(), name.end(), 0U);
  Dice dice(shuffle);
  if (shuffle != 0) shuffle_items(name, dice);
  std::vector<Point3> points(name.size());
  Triangles triangles;
  const auto id = [&](std::uint32_t x, std::uint32_t y) { return name[y * (columns + 1) + x]; };
  for (std::uint32_t y = 0; y <= rows; ++y) {
    for (std::uint32_t x = 0; x <= columns; ++x) {
      points[id(x, y)] = {static_cast<double>(x), static_cast<double>(y), 0};
      if (x == columns || y == rows) continue;
      if ((x + y) % 2 == 0) {
        add_quad(triangles, id(x, y), id(x + 1, y), id(x + 1, y + 1), id(x, y + 1));
      } else {
        add_quad(triangles, id(x + 1, y), id(x + 1, y + 1), id(x, y + 1), id(x, y));
      }
    }
  }
  if (shuffle != 0) {
    shuffle_items(triangles, dice);
    for (SurfaceTriangle& t : triangles) {
      std::rotate(t.begin(), t.begin() + dice.between(0, 2), t.end());
    }
  }
  return made(std::move(points), std::move(triangles));
}

MeshPointer torus_mesh(std::uint32_t major, std::uint32_t minor) {
  std::vector<Point3> points;
  Triangles triangles;
  add_torus(points, triangles, major, minor, 0);
  return made(std::move(points), std::move(triangles));
}

MeshPointer cylinder_mesh(std::uint32_t around, std::uint32_t up) {
  std::vector<Point3> points;
  Triangles triangles;
  for (std::uint32_t i = 0; i <= up; ++i) {
    for (std::uint32_t j = 0; j < around; ++j) {
      const double t = 2 * std::numbers::pi * j / around;
      points.push_back({std::cos(t), std::sin(t), static_cast<double>(i)});
      if (i == up) continue;
      const std::uint32_t k = (j + 1) % around;
      add_quad(triangles, i * around + j, i * around + k, (i + 1) * around + k,
               (i + 1) * around + j);
    }
  }
  return made(std::move(points), std::move(triangles));
}

MeshPointer cube_mesh() { return sphere_mesh(1); }

MeshPointer sphere_mesh(std::uint32_t n) {
  PolygonMesh cube = grid_cube_mesh(n, {0, 0, 0});
  for (Point3& p : cube.points) p = {p.x / n, p.y / n, p.z / n};
  Triangles triangles;
  for (std::size_t f = 0; f < cube.face_count(); ++f) {
    const auto corners = cube.face(f);
    triangles.push_back({corners[0], corners[1], corners[2]});
  }
  return made(std::move(cube.points), std::move(triangles));
}

MeshPointer joined_meshes(std::span<const MeshPointer> parts) {
  std::vector<Point3> points;
  Triangles triangles;
  for (const MeshPointer& part : parts) {
    const auto first = static_cast<std::uint32_t>(points.size());
    for (std::size_t v = 0; v < part->vertex_count(); ++v)
      points.push_back(part->point(VertexId(v)));
    for (std::size_t f = 0; f < part->face_count(); ++f) {
      SurfaceTriangle t = part->corners(FaceId(f));
      for (std::uint32_t& v : t) v += first;
      triangles.push_back(t);
    }
  }
  return made(std::move(points), std::move(triangles));
}

MeshPointer chain_of_tori(std::uint32_t handles, std::uint32_t major, std::uint32_t minor) {
  std::vector<Point3> points;
  Triangles triangles;
  for (std::uint32_t i = 0; i < handles; ++i) add_torus(points, triangles, major, minor, 3.0 * i);
  const std::uint32_t size = major * minor;
  const auto remove = [&](SurfaceTriangle t) { std::erase(triangles, t); };
  for (std::uint32_t i = 0; i + 1 < handles; ++i) {
    // The first triangle of one, at vertex (0, 0), and a triangle of the next at (major / 2, 0).
    const std::uint32_t a = i * size, b = (i + 1) * size + (major / 2) * minor;
    const SurfaceTriangle s = {a, a + minor, a + minor + 1};
    const SurfaceTriangle t = {b, b + minor, b + minor + 1};
    remove(s);
    remove(t);
    // A tube: the sides of s against those of t, which seen from it run the other way.
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t l = (k + 1) % 3;
      add_quad(triangles, s[k], s[l], t[(3 - l) % 3], t[(3 - k) % 3]);
    }
  }
  return made(std::move(points), std::move(triangles));
}

// ---------------------------------------------------------------- drawing

SurfaceDrawing::SurfaceDrawing(MeshPointer mesh)
    : scene{mesh, SurfacePolygons(*mesh), {}, FaceId{}} {}

SurfacePointId SurfaceDrawing::on_edge(std::uint32_t a, std::uint32_t b, const Rational& weight) {
  for (std::size_t e = 0; e < scene.mesh->edge_count(); ++e) {
    const EdgeId edge(e);
    if (scene.mesh->lower(edge).value() != std::min(a, b)) continue;
    if (scene.mesh->upper(edge).value() != std::max(a, b)) continue;
    return points().add_on_edge(edge, a < b ? weight : Rational(1 - weight));
  }
  throw Error(ErrorCode::BadArgument, "no such edge");
}

SurfacePointId SurfaceDrawing::at(const Rational& x, const Rational& y) {
  const SurfaceMesh& mesh = *scene.mesh;
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    const SurfaceTriangle& t = mesh.corners(FaceId(f));
    const RationalPoint2 a = flat_point(mesh, t[0]), b = flat_point(mesh, t[1]),
                         c = flat_point(mesh, t[2]);
    const Rational whole = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
    const Rational u = ((x - a.x) * (c.y - a.y) - (y - a.y) * (c.x - a.x)) / whole;
    const Rational v = ((b.x - a.x) * (y - a.y) - (b.y - a.y) * (x - a.x)) / whole;
    if (u >= 0 && v >= 0 && u + v <= 1) return points().add_in_face(FaceId(f), u, v);
  }
  throw Error(ErrorCode::BadArgument, "a point outside the mesh");
}

FaceId SurfaceDrawing::common_face(SurfacePointId p, SurfacePointId q) const {
  for (std::size_t f = 0; f < scene.mesh->face_count(); ++f) {
    if (scene.polygons.points.is_in(p, FaceId(f)) && scene.polygons.points.is_in(q, FaceId(f))) {
      return FaceId(f);
    }
  }
  throw Error(ErrorCode::BadArgument, "two points of no common face");
}

void SurfaceDrawing::add_polygon(std::span<const SurfacePointId> corners) {
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const SurfacePointId next = corners[(i + 1) % corners.size()];
    scene.polygons.add_segment(corners[i], common_face(corners[i], next),
                               SegmentStart::ControlPoint);
  }
  scene.polygons.close();
}

void SurfaceDrawing::add_vertex_polygon(std::span<const std::uint32_t> vertices) {
  std::vector<SurfacePointId> corners;
  for (const std::uint32_t v : vertices) corners.push_back(vertex(v));
  add_polygon(corners);
}

/// Cut where it meets edges; points along an edge are its vertices.
void SurfaceDrawing::add_flat_leg(const RationalPoint2& from, const RationalPoint2& to) {
  const SurfaceMesh& mesh = *scene.mesh;
  std::vector<RationalPoint2> stops = {from, to};
  const RationalSegment2 leg{from, to};
  if (!(from == to)) {
    for (std::size_t e = 0; e < mesh.edge_count(); ++e) {
      const RationalSegment2 edge{flat_point(mesh, mesh.lower(EdgeId(e)).value()),
                                  flat_point(mesh, mesh.upper(EdgeId(e)).value())};
      if (const auto p = meeting_point(leg, edge)) stops.push_back(*p);
      for (const RationalPoint2& p : {edge.source, edge.target}) {
        if (place_on(leg, p) != PlaceOnSegment::Off) stops.push_back(p);
      }
    }
    std::sort(stops.begin(), stops.end(), [&](const RationalPoint2& p, const RationalPoint2& q) {
      return compare_along(leg, p, q) == Sign::Negative;
    });
    stops.erase(std::unique(stops.begin(), stops.end()), stops.end());
  }
  SurfacePath path;
  for (std::size_t i = 0; i < stops.size(); ++i) {
    path.points.push_back(at(stops[i].x, stops[i].y));
    if (i > 0) path.faces.push_back(common_face(path.points[i - 1], path.points[i]));
  }
  scene.polygons.add_leg(path);
}

void SurfaceDrawing::add_flat_polygon(std::span<const RationalPoint2> corners) {
  for (std::size_t i = 0; i < corners.size(); ++i) {
    add_flat_leg(corners[i], corners[(i + 1) % corners.size()]);
  }
  scene.polygons.close();
}

void SurfaceDrawing::add_box(const RationalPoint2& low, const RationalPoint2& high) {
  const RationalPoint2 corners[] = {low, {high.x, low.y}, high, {low.x, high.y}};
  add_flat_polygon(corners);
}

std::vector<std::uint32_t> closed_walk(const SurfaceMesh& mesh,
                                       std::span<const std::uint8_t> steps) {
  const auto start = steps.empty() ? 0U : static_cast<std::uint32_t>(steps[0]);
  std::vector<std::uint32_t> walk = {start % static_cast<std::uint32_t>(mesh.vertex_count())};
  std::vector<std::uint32_t> parent;  // breadth first from the start
  const auto neighbours = [&](std::uint32_t v) {
    std::vector<std::uint32_t> found;
    const HalfedgeId begin = mesh.halfedge(VertexId(v));
    for (HalfedgeId h = begin; h.is_valid();) {
      found.push_back(mesh.target(h).value());
      const HalfedgeId in = SurfaceMesh::prev(h);
      if (mesh.is_border(in)) found.push_back(mesh.origin(in).value());
      h = mesh.twin(in);
      if (h == begin) break;
    }
    return found;
  };
  for (std::size_t i = 1; i < steps.size(); ++i) {
    const auto next = neighbours(walk.back());
    walk.push_back(next[steps[i] % next.size()]);
  }
  if (walk.size() == 1) return walk;
  // Home along a shortest way.
  std::vector<std::uint32_t> queue = {walk.front()};
  parent.assign(mesh.vertex_count(), ~0U);
  parent[walk.front()] = walk.front();
  for (std::size_t at = 0; at < queue.size(); ++at) {
    for (const std::uint32_t v : neighbours(queue[at])) {
      if (parent[v] != ~0U) continue;
      parent[v] = queue[at];
      queue.push_back(v);
    }
  }
  for (std::uint32_t v = parent[walk.back()]; v != walk.front(); v = parent[v]) walk.push_back(v);
  return walk;
}

}  // namespace plumb::testing
