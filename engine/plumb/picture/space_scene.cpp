// Scenes of sets of space, and exploded scenes of their parts.
//
// The window surrounds all vertices, and a point of each facet and edge without one, in doubles.
// The set is then intersected exactly with the box of the window, so unbounded facets end on it;
// what lies on the box is drawn as a cut. Facets are triangulated on their exact complex and become
// patches whose normals point away from the marked volume. Vertices get a dot where their mark says
// more than the edges there.
//
// An exploded scene moves every part away from the common middle, in proportion to the distance of
// its own middle.
// Tested by tests/picture/space_scene_test.cpp.
#include "plumb/picture/space_scene.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "plumb/convex/decompose.h"
#include "plumb/picture/scene/scene_frame.h"
#include "plumb/predicates/arithmetic/vectors.h"
#include "plumb/predicates/error.h"
#include "plumb/predicates/point3_signs.h"
#include "plumb/predicates/rounding.h"
#include "plumb/space/planar/facet_triangles.h"

namespace plumb {
namespace {

constexpr double kFadingMargin = 0.45;  // Part of the longest side; the faded part lies within it.
constexpr double kGoodBox = 1e-9;       // Ratio of radius to coordinates.
constexpr double kOnBox = 1e-7;         // Scene units: the box is far from everything else.

Point3 normal_of(const SpaceComplex& complex, PlaneId plane) {
  const PlaneRow& row = complex.planes().row(plane);
  const double length = std::hypot(row.n[0], row.n[1], row.n[2]);
  return {row.n[0] / length, row.n[1] / length, row.n[2] / length};
}

bool is_finite(const Point3& p) {
  return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
}

// ---------------------------------------------------------------- the window

/// Finds the window around all vertices, and a point of each facet and edge without one.
class WindowFinder {
 public:
  WindowFinder(const SpaceComplex& complex, SceneFrame& frame) : complex_(complex), frame_(frame) {}

  void run() {
    for (const SpacePoint p : complex_.vertex_point) {
      if (!complex_.points().depends_on_frame(p)) include(place(p));
    }
    for (std::size_t e = 0; e < complex_.edge_count(); ++e) {
      const HalfedgeId h(static_cast<std::uint32_t>(2 * e));
      if (!is_far(complex_.origin[h]) || !is_far(complex_.target(h))) continue;
      const auto& [p, q] = complex_.edge_planes[e];
      if (!complex_.planes().is_frame(p) && !complex_.planes().is_frame(q)) include_line(p, q);
    }
    for (std::size_t f = 0; f < complex_.facet_count(); ++f) {
      if (!complex_.planes().is_frame(complex_.facet_plane[f])) include_plane(FacetId(f));
    }
  }

 private:
  bool is_far(VertexId v) const {
    return complex_.points().depends_on_frame(complex_.vertex_point[v]);
  }
  Point3 place(SpacePoint p) const {
    const PointBox box = complex_.points().box(p);
    const double most =
        std::max({std::fabs(box.mid[0]), std::fabs(box.mid[1]), std::fabs(box.mid[2])});
    if (box.radius <= kGoodBox * most) return {box.mid[0], box.mid[1], box.mid[2]};
    const RationalPoint3 at = exact(complex_.points(), p);
    const auto nearest = [](const Rational& x) { return clamped_to_finite(nearest_double(x)); };
    return {nearest(at.x), nearest(at.y), nearest(at.z)};
  }
  void include(const Point3& p) {
    if (is_finite(p)) frame_.include(p);
  }

  /// Includes the point of the line that is nearest to the origin.
  void include_line(PlaneId p, PlaneId q) {
    const Point3 a = normal_of(complex_, p), b = normal_of(complex_, q), along = cross(a, b);
    const double s = -offset(p), t = -offset(q), w = dot(along, along);
    const Point3 x = cross(b, along), y = cross(along, a);
    include({(s * x.x + t * y.x) / w, (s * x.y + t * y.y) / w, (s * x.z + t * y.z) / w});
  }
  void include_plane(FacetId f) {
    for (const UseId first : complex_.cycles_of(f)) {
      UseId u = first;
      do {
        if (!is_far(complex_.use_origin(u))) return;
        u = complex_.use_next[u];
      } while (u != first);
    }
    const PlaneId plane = complex_.facet_plane[f];
    const Point3 n = normal_of(complex_, plane);
    const double d = -offset(plane);
    include({n.x * d, n.y * d, n.z * d});
  }
  double offset(PlaneId p) const {
    const PlaneRow& row = complex_.planes().row(p);
    return row.d / std::hypot(row.n[0], row.n[1], row.n[2]);
  }

  const SpaceComplex& complex_;
  SceneFrame& frame_;
};

Nef3 inside_box(const Nef3& set, const SceneFrame& frame, Context& context) {
  const Point3 low = frame.low(), high = frame.high();
  const std::array<HalfSpace3, 6> sides = {{{{-1, 0, 0, low.x}, Boundary::Open},
                                            {{1, 0, 0, -high.x}, Boundary::Open},
                                            {{0, -1, 0, low.y}, Boundary::Open},
                                            {{0, 1, 0, -high.y}, Boundary::Open},
                                            {{0, 0, -1, low.z}, Boundary::Open},
                                            {{0, 0, 1, -high.z}, Boundary::Open}}};
  return boolean_op(set, Nef3::intersection(sides, context), kIntersection, context);
}

// ---------------------------------------------------------------- the scene

class SceneMaker {
 public:
  SceneMaker(const SpaceComplex& complex, const SceneFrame& frame, bool fades, Context& context)
      : complex_(complex), frame_(frame), context_(context), triangles_(complex) {
    scene_.fades = fades;
    frame.describe(scene_);
  }

  Scene run() {
    add_points();
    for (std::uint32_t f = 0; f < complex_.facet_count(); ++f) add_facet(FacetId(f));
    for (std::uint32_t e = 0; e < complex_.edge_count(); ++e) add_edge(EdgeId(e));
    for (std::uint32_t v = 0; v < complex_.vertex_count(); ++v) add_dot(VertexId(v));
    return std::move(scene_);
  }

 private:
  void add_points() {
    scene_.points.reserve(complex_.vertex_count());
    for (const SpacePoint p : complex_.vertex_point) {
      scene_.points.push_back(p.is_input() ? frame_.at(complex_.planes().point(p.input()))
                                           : frame_.at(exact(complex_.points(), p)));
    }
  }

  /// Returns the sides of the box that a vertex lies on, a bit for each.
  unsigned sides_at(VertexId v) const {
    if (!scene_.fades) return 0;
    const Point3& p = scene_.points[v.value()];
    const Point3& h = scene_.half;
    unsigned sides = 0;
    const auto see = [&](double x, double half, unsigned bit) {
      if (std::fabs(std::fabs(x) - half) < kOnBox) sides |= x < 0 ? bit : 2 * bit;
    };
    see(p.x, h.x, 1);
    see(p.y, h.y, 4);
    see(p.z, h.z, 16);
    return sides;
  }
  bool is_on_box(FacetId f) const {
    unsigned sides = scene_.fades ? ~0U : 0U;
    for (const UseId first : complex_.cycles_of(f)) {
      UseId u = first;
      do {
        sides &= sides_at(complex_.use_origin(u));
        u = complex_.use_next[u];
      } while (sides != 0 && u != first);
    }
    return sides != 0;
  }

  bool is_marked(VolumeId v) const { return complex_.volume_mark[v] == 1; }

  /// Adds a facet. Normals point away from the marked volume.
  void add_facet(FacetId f) {
    if (f.value() % 4096 == 0) context_.checkpoint("facets", f.value(), complex_.facet_count());
    const auto& [above, below] = complex_.facet_volume[f];
    const bool is_reversed = is_marked(above) && !is_marked(below);
    const bool is_solid = is_marked(above) || is_marked(below);
    const Paint paint = is_on_box(f)                  ? Paint::Cut
                        : complex_.facet_mark[f] != 1 ? Paint::OpenFacet
                        : is_solid                    ? Paint::ClosedFacet
                                                      : Paint::Sheet;
    const Point3 n = normal_of(complex_, complex_.facet_plane[f]);
    const double sign = is_reversed ? -1 : 1;
    const auto patch = static_cast<std::uint32_t>(scene_.patches.size());
    scene_.patches.push_back({{sign * n.x, sign * n.y, sign * n.z}, paint});
    triangles_.for_each(f, [&](VertexId a, VertexId b, VertexId c) {
      if (is_reversed) std::swap(b, c);
      scene_.triangles.push_back({{a.value(), b.value(), c.value()}, patch});
    });
  }

  void add_edge(EdgeId e) {
    const HalfedgeId h(2 * e.value());
    const VertexId a = complex_.origin[h], b = complex_.target(h);
    if ((sides_at(a) & sides_at(b)) != 0) return;
    Scene::Line line{{a.value(), b.value()}, Paint::Edge, {Scene::kNoPatch, Scene::kNoPatch}};
    const UseId use = complex_.edge_use[e];
    if (complex_.edge_mark[e] != 1) {
      line.paint = Paint::OpenEdge;
    } else if (!use.is_valid()) {
      line.paint = Paint::FreeEdge;
    }
    if (use.is_valid()) {
      const UseId next = complex_.use_radial[use];
      line.patches = {complex_.use_facet[use].value(), complex_.use_facet[next].value()};
    }
    scene_.lines.push_back(line);
  }

  /// Adds a dot for a point that says more than the edges there.
  void add_dot(VertexId v) {
    if (sides_at(v) != 0) return;
    const bool is_point = complex_.vertex_mark[v] == 1;
    const auto star = complex_.star_of(v);
    const auto is_unlike = [&](HalfedgeId h) {
      return (complex_.edge_mark[SpaceComplex::edge_of(h)] == 1) != is_point;
    };
    const bool says_more = star.empty() || (is_point ? std::ranges::all_of(star, is_unlike)
                                                     : std::ranges::any_of(star, is_unlike));
    if (says_more) scene_.dots.push_back({v.value(), is_point ? Paint::Point : Paint::OpenPoint});
  }

  const SpaceComplex& complex_;
  const SceneFrame& frame_;
  Context& context_;
  FacetTriangles triangles_;
  Scene scene_;
};

}  // namespace

Scene scene_of(const Nef3& set, Context& context) {
  SceneFrame frame;
  WindowFinder(set.complex(), frame).run();
  const bool fades = !set.is_bounded();
  frame.close(fades ? kFadingMargin : 0);
  const Nef3 shown = fades ? inside_box(set, frame, context) : set;
  return SceneMaker(shown.complex(), frame, fades, context).run();
}

namespace {

double middle_of(double low, double high) { return low / 2 + high / 2; }
Point3 middle_of(const SceneFrame& frame) {
  const Point3 low = frame.low(), high = frame.high();
  return {middle_of(low.x, high.x), middle_of(low.y, high.y), middle_of(low.z, high.z)};
}

/// Returns where the points of a scene are in space.
std::vector<Point3> unscaled_points(const Scene& scene) {
  const auto along = [&scene](double p, double quarter_centre) {
    return clamped_to_finite(4 * (quarter_centre + scene.quarter_scale * p));
  };
  std::vector<Point3> points;
  for (const Point3& p : scene.points) {
    points.push_back({along(p.x, scene.quarter_centre.x), along(p.y, scene.quarter_centre.y),
                      along(p.z, scene.quarter_centre.z)});
  }
  return points;
}

SceneFrame frame_of(std::span<const Point3> points) {
  SceneFrame frame;
  for (const Point3& p : points) frame.include(p);
  frame.close(0);
  return frame;
}

/// Hatches facets that cuts made; each has one patch.
void hatch_walls(const SpaceComplex& complex, Scene& scene) {
  for (std::uint32_t f = 0; f < complex.facet_count(); ++f) {
    scene.patches[f].is_hatched = is_wall(complex, FacetId(f));
  }
}

/// Appends a scene whose points are now at `points`.
void append(const Scene& part, std::span<const Point3> points, Scene& all) {
  const auto point = static_cast<std::uint32_t>(all.points.size());
  const auto patch = static_cast<std::uint32_t>(all.patches.size());
  const auto group = static_cast<std::uint32_t>(all.groups.size());
  all.points.insert(all.points.end(), points.begin(), points.end());
  for (Scene::Patch p : part.patches) {
    p.group = group;
    all.patches.push_back(p);
  }
  for (Scene::Triangle t : part.triangles) {
    for (std::uint32_t& c : t.corners) c += point;
    t.patch += patch;
    all.triangles.push_back(t);
  }
  for (Scene::Line l : part.lines) {
    for (std::uint32_t& e : l.ends) e += point;
    for (std::uint32_t& p : l.patches) p += p == Scene::kNoPatch ? 0 : patch;
    all.lines.push_back(l);
  }
  for (Scene::Dot d : part.dots) {
    d.at += point;
    all.dots.push_back(d);
  }
  all.groups.push_back({"piece " + std::to_string(group + 1), ""});
}

}  // namespace

Scene exploded_scene(std::span<const Nef3> sets, double apart, Context& context) {
  if (!(apart >= 0) || !std::isfinite(apart)) {
    throw Error(ErrorCode::BadArgument, "pieces cannot be moved apart by that");
  }
  Scene all;
  SceneFrame together;
  for (const Nef3& set : sets) {
    if (!set.is_bounded()) {
      throw Error(ErrorCode::BadArgument, "an unbounded set has no middle to be moved");
    }
    Scene part = scene_of(set, context);
    hatch_walls(set.complex(), part);
    const std::vector<Point3> points = unscaled_points(part);
    for (const Point3& p : points) together.include(p);
    append(part, points, all);
  }
  together.close(0);
  const Point3 middle = middle_of(together);

  // The points of a piece are consecutive.
  std::vector<Point3> moved;
  std::size_t begin = 0;
  for (const Nef3& set : sets) {
    const auto own = std::span(all.points).subspan(begin, set.complex().vertex_count());
    begin += own.size();
    const Point3 at = own.empty() ? middle : middle_of(frame_of(own));
    for (const Point3& p : own) {
      moved.push_back({p.x + apart * (at.x - middle.x), p.y + apart * (at.y - middle.y),
                       p.z + apart * (at.z - middle.z)});
      if (!is_finite(moved.back())) {
        throw Error(ErrorCode::BadArgument, "pieces would be moved beyond the largest double");
      }
    }
  }
  const SceneFrame frame = frame_of(moved);
  for (std::size_t i = 0; i < moved.size(); ++i) all.points[i] = frame.at(moved[i]);
  frame.describe(all);

  Scene::Layer layer{"pieces", {}};
  for (std::size_t i = 0; i < sets.size(); ++i) layer.tints.push_back(distinct_colour(i));
  all.layers.push_back(std::move(layer));
  all.shown = 1;
  return all;
}

}  // namespace plumb
