// How arrangements, Booleans and queries of the plane grow (growth.h says how it is measured), and
// the memory of an arrangement: exit status 1, too, when 2,000 long segments peak above 400 bytes a
// crossing.
#include <fmt/core.h>
#include <sys/resource.h>

#include <algorithm>
#include <functional>
#include <utility>

#include "growth.h"
#include "plane_jobs.h"
#include "plumb/io/plane_io.h"

namespace plumb::bench {
namespace {

Work arrange_all(const std::function<std::vector<testing::PlaneSegment>(std::uint64_t)>& make) {
  std::vector<SegmentScene> scenes;
  std::size_t elements = 0;
  while (static_cast<double>(elements) < kVariedElements) {
    const SegmentScene& scene = scenes.emplace_back(scene_of(make(scenes.size() + 1)));
    elements += arranged(scene).complex.vertex_count() + scene.segments.size();
  }
  const double size = static_cast<double>(elements) / static_cast<double>(scenes.size());
  return measured_in_turn(size, std::move(scenes), arranged);
}
Work arrange_short(std::size_t n) {
  return arrange_all([n](std::uint64_t seed) { return testing::short_segments(n, seed); });
}
Work arrange_long(std::size_t n) {
  return arrange_all([n](std::uint64_t seed) { return testing::long_segments(n, seed); });
}

/// Segments of one line, each within the one before: its edges come from n^2 of them in all.
Work arrange_nested(std::size_t n) {
  std::vector<testing::PlaneSegment> segments;
  for (std::size_t i = 0; i < n; ++i) {
    const double from = static_cast<double>(i);
    const double to = static_cast<double>(2 * n - i);
    segments.push_back({{from, 3 * from}, {to, 3 * to}});
  }
  return arrange_all([&](std::uint64_t) { return segments; });
}

Work stars(std::size_t n, MarkFunction f) {
  std::vector<std::pair<Nef2, Nef2>> pairs;
  for (double elements = 0; elements < kVariedElements; elements += static_cast<double>(2 * n)) {
    Nef2 a = Nef2::polygon(testing::star_polygon(n, 2 * pairs.size() + 1));
    Nef2 b = Nef2::polygon(testing::star_polygon(n, 2 * pairs.size() + 2));
    pairs.emplace_back(std::move(a), std::move(b));
  }
  return measured_in_turn(static_cast<double>(2 * n), std::move(pairs), [f](const auto& pair) {
    Context context;
    return boolean_op(pair.first, pair.second, f, context);
  });
}
Work star_intersection(std::size_t n) { return stars(n, kIntersection); }
Work star_union(std::size_t n) { return stars(n, kUnion); }
Work star_difference(std::size_t n) { return stars(n, kSymmetricDifference); }

/// Polygons with holes, in fractions, then as shapes that files have.
Work polygons_of_union(std::size_t n) {
  const Nef2 set =
      Nef2::polygon(testing::star_polygon(n, 1)) + Nef2::polygon(testing::star_polygon(n, 2));
  return measured(static_cast<double>(set.complex().edge_count()), [set] {
    Context context;
    return to_shapes(set.parts(context), context);
  });
}

Work octagon_union(std::size_t n) {
  return measured(static_cast<double>(8 * n),
                  [polygons = testing::octagons(n)] { return union_of_polygons(polygons); });
}

/// Interior, then closure: no sweep.
Work regularize(std::size_t n) {
  const Nef2 set = union_of_polygons(testing::octagons(n));
  return measured(static_cast<double>(set.complex().edge_count()),
                  [set] { return set.regularization(); });
}

Work complement(std::size_t n) {
  const Nef2 set = union_of_polygons(testing::octagons(n));
  return measured(static_cast<double>(set.complex().edge_count()), [set] { return !set; });
}

/// Building the locator and asking it n times.
Work locate(std::size_t n) {
  const Nef2 star = Nef2::polygon(testing::star_polygon(n, 1));
  return measured(static_cast<double>(n), [star, queries = testing::star_polygon(n, 3)] {
    const Nef2 fresh = !star;  // shares nothing with star
    return std::ranges::count_if(queries, [&](Point2 p) { return fresh.contains(p); });
  });
}

/// From each corner of 200 octagons towards its next one but two, to the first place that is met.
/// Wherever a ray starts, something is near. The structures are made before.
Work shoot(std::size_t n) {
  const Nef2 set = union_of_polygons(testing::octagons(n));
  std::vector<Line2> rays;
  for (const testing::PlanePolygon& polygon : testing::octagons(200, 2)) {
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const Point2 p = polygon[i];
      const Point2 q = polygon[(i + 3) % polygon.size()];
      rays.push_back({{Rational(p.x), Rational(p.y)}, {Rational(q.x - p.x), Rational(q.y - p.y)}});
    }
  }
  static_cast<void>(set.shoot_to_boundary({0, 0}, {1, 0}));
  return measured(static_cast<double>(set.complex().edge_count()), [set, rays] {
    return std::ranges::count_if(
        rays, [&](const Line2& ray) { return set.shoot_to_boundary(ray.a, ray.b).has_value(); });
  });
}

/// The boundaries of n half-planes that all bound their intersection.
Work half_plane_intersection(std::size_t n) {
  return measured(static_cast<double>(n), [planes = half_planes(n)] {
    Context context;
    Nef2 all = Nef2::whole();
    for (const Nef2& h : planes) all = boolean_op(all, h, kIntersection, context);
    return all;
  });
}

const std::vector<Family> kFamilies{
    {"arrange-short",
     "arrangement of segments (Bentley-Ottmann)",
     "n + k",
     {1, 1},
     sizes_between(1000, 100000),
     arrange_short,
     1.1},
    {"arrange-long",
     "arrangement of segments, k = 0.11 n^2",
     "n + k",
     {1, 1},
     sizes_between(30, 3334),
     arrange_long,
     1.1},
    {"arrange-nested",
     "arrangement of segments that overlap, each within the one before",
     "n + k",
     {1, 1},
     sizes_between(1000, 100000),
     arrange_nested,
     1.25},
    {"stars-intersection",
     "Boolean, O((n + m) log(n + m) + k) in the note on Nef polyhedra",
     "n + k",
     {1, 1},
     sizes_between(1000, 100000),
     star_intersection,
     1.25},
    {"stars-union", "the same", "n + k", {1, 1}, sizes_between(1000, 100000), star_union, 1.25},
    {"stars-symmetric-difference",
     "the same",
     "n + k",
     {1, 1},
     sizes_between(1000, 100000),
     star_difference,
     1.25},
    {"octagons-union",
     "union of polygons by winding number",
     "corners",
     {1, 1},
     sizes_between(300, 33334),
     octagon_union,
     1.25},
    {"polygons-of-union",
     "conversion to polygons, O(n) in the note on Nef polyhedra",
     "edges",
     {1, 1},
     sizes_between(1000, 100000),
     polygons_of_union,
     1.25},
    {"octagons-regularize",
     "regularization, O(n) in the note on Nef polyhedra",
     "edges",
     {1, 0},
     sizes_between(300, 36000, 2.6),
     regularize,
     1.15},
    {"octagons-complement",
     "complement, O(n) in the note on Nef polyhedra",
     "edges",
     {1, 0},
     sizes_between(300, 36000, 2.6),
     complement},
    {"star-locate",
     "containment; the note says O(n) a point",
     "points",
     {1, 2},
     sizes_between(1000, 100000),
     locate,
     1.35},
    {"octagons-shoot",
     "1,600 rays; a question to every edge would be O(n) a ray",
     "edges",
     {0, 2},
     sizes_between(300, 36000, 2.6),
     shoot,
     0.4},
    {"half-planes",
     "n half-planes, one by one: O(n^2) in the note",
     "half-planes",
     {2, 0},
     sizes_between(16, 1600),
     half_plane_intersection},
};

double peak_bytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return 1024.0 * static_cast<double>(usage.ru_maxrss);
}

/// Before anything else has raised the peak.
bool measure_memory() {
  const std::size_t n = 2000;
  const SegmentScene scene = scene_of(testing::long_segments(n));
  const double before = peak_bytes();
  const Arrangement arrangement = arranged(scene);
  const double crossings =
      static_cast<double>(arrangement.complex.vertex_count()) - 2.0 * static_cast<double>(n);
  const double bytes = (peak_bytes() - before) / crossings;
  fmt::print(
      "arrangement of {} long segments, {:.0f} crossings: peak of {:.0f} bytes a crossing\n\n", n,
      crossings, bytes);
  return bytes <= 400;
}

}  // namespace
}  // namespace plumb::bench

int main(int argc, char** argv) {
  const bool is_small = plumb::bench::measure_memory();
  const int status = plumb::bench::growth_main("Growth of arrangements and sets of the plane",
                                               plumb::bench::kFamilies, argc, argv);
  return is_small ? status : 1;
}
