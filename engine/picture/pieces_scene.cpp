#include "plumb/picture/pieces_scene.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "plumb/base/error.h"
#include "plumb/base/refused_memory.h"
#include "plumb/convex/decompose.h"
#include "plumb/picture/distinct_colour.h"
#include "plumb/picture/scene_frame.h"
#include "plumb/picture/space_scene.h"
#include "plumb/predicates/rounding.h"

namespace plumb {
namespace {

double middle_of(double low, double high) { return low / 2 + high / 2; }
Point3 middle_of(const SceneFrame& frame) {
  const Point3 low = frame.low(), high = frame.high();
  return {middle_of(low.x, high.x), middle_of(low.y, high.y), middle_of(low.z, high.z)};
}

bool is_finite(const Point3& p) {
  return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
}

/// Where the points of a scene are in space.
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

/// Facets that cuts made, one patch each.
void hatch_walls(const SpaceComplex& complex, Scene& scene) {
  for (std::uint32_t f = 0; f < complex.facet_count(); ++f) {
    scene.patches[f].is_hatched = is_wall(complex, FacetId(f));
  }
}

/// Appends a scene whose points are `points` now.
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

Scene exploded_scene(std::span<const Nef3> sets, double apart, Context& context) try {
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

  // The points of a piece follow each other.
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
} catch (...) {
  rethrow_refused_memory();
}

}  // namespace plumb
