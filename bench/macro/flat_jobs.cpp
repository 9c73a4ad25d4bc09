// Capabilities of the plane and of the sphere.
#include <fmt/core.h>

#include <algorithm>
#include <cstdint>
#include <memory>

#include "../complexity/plane_jobs.h"
#include "generate/sphere_families.h"
#include "jobs.h"
#include "plumb/convex/plane_partition.h"
#include "plumb/plane/map_check.h"
#include "plumb/plane/map_overlay.h"
#include "plumb/plane/plane_audit.h"
#include "plumb/predicates/error.h"
#include "plumb/sphere/sphere_locator.h"
#include "plumb/testing/map_families.h"

namespace plumb::bench {
namespace {

const std::string kCounties = "corpus/maps/us-counties.clean.map";
const std::string kStates = "corpus/maps/us-states.clean.map";

// ---------------------------------------------------------------- maps

MapReport report_of(const Map& map) {
  Context context;
  return check_map(map, {}, context);
}

Once check_of(const Map& map) {
  return timed([map] { return report_of(map); },
               [](const MapReport& report) { return report.regions.size(); });
}

Once dcel_of(const Map& map) {
  return timed([report = report_of(map)] { return to_dcel(report).dcel; },
               [](const Dcel& dcel) { return dcel.halfedge_count(); });
}

Once overlay_of(const Map& a, const Map& b) {
  return timed(
      [first = report_of(a), second = report_of(b)] {
        Context context;
        return overlay_maps(first, second, context);
      },
      [](const MapOverlay& overlay) { return overlay.complex.face_count(); });
}

/// Of all cells, exactly.
Once areas_of_overlay(const Map& a, const Map& b) {
  Context context;
  const auto first = std::make_shared<const MapReport>(report_of(a));
  const auto second = std::make_shared<const MapReport>(report_of(b));
  const auto overlay = std::make_shared<const MapOverlay>(overlay_maps(*first, *second, context));
  return timed_of(overlay->complex.face_count(), [=] {
    Context own;
    return measure(*overlay, *first, *second, own);
  });
}

Map generated_map(const char* family, std::size_t faces) {
  return to_map(testing::map_family(family).make(static_cast<std::uint32_t>(faces)));
}

void add_maps(std::vector<Job>& jobs, const MacroOptions& options) {
  const std::size_t faces = options.size(100000, 1000);
  const auto hexagons = [faces] { return generated_map("hexagons", faces); };
  for (const std::string& file :
       {kCounties, std::string("corpus/maps/world-countries.clean.map")}) {
    jobs.push_back({"map check", file, true, "regions", [file] { return check_of(map_of(file)); }});
  }
  jobs.push_back({"map check", "hexagons", false, "regions", [=] { return check_of(hexagons()); }});
  jobs.push_back(
      {"DCEL of a map", kCounties, true, "half-edges", [] { return dcel_of(map_of(kCounties)); }});
  jobs.push_back(
      {"DCEL of a map", "hexagons", false, "half-edges", [=] { return dcel_of(hexagons()); }});
  const auto real = [](Once (*of)(const Map&, const Map&)) {
    return [of] { return of(map_of(kStates), map_of(kCounties)); };
  };
  const auto generated = [faces](Once (*of)(const Map&, const Map&)) {
    return [=] {
      return of(generated_map("hexagons", faces / 3), generated_map("hexagons", faces / 6));
    };
  };
  const char* const states = "corpus/maps: us-states over us-counties";
  const char* const half = "hexagons over half as many";
  jobs.push_back({"map overlay", states, true, "faces", real(overlay_of)});
  jobs.push_back({"map overlay", half, false, "faces", generated(overlay_of)});
  jobs.push_back({"exact areas of an overlay", states, true, "faces", real(areas_of_overlay)});
  jobs.push_back({"exact areas of an overlay", half, false, "faces", generated(areas_of_overlay)});
}

// ---------------------------------------------------------------- sets of the plane

/// Every other region of a map.
Nef2 half_of(const std::string& file) {
  const MapReport report = report_of(map_of(file));
  std::vector<std::uint8_t> chosen(report.regions.size());
  for (std::size_t r = 1; r < chosen.size(); r += 2) chosen[r] = 1;
  Context context;
  return Nef2::subdivision(report, chosen, Boundary::Closed, context);
}

Nef2 star(std::size_t corners, std::uint64_t seed) {
  return Nef2::polygon(testing::star_polygon(corners, seed));
}

std::size_t edges_of(const Nef2& set) { return set.complex().edge_count(); }

Once union_of_sets(const Nef2& a, const Nef2& b) {
  return timed(
      [a, b] {
        Context context;
        return boolean_op(a, b, kUnion, context);
      },
      edges_of);
}

/// The least and the greatest x of the set's input points, or y.
std::pair<double, double> range_of(const Nef2& set, double Point2::*coordinate) {
  const PointTable2& points = set.complex().points.inputs;
  double low = 1e300, high = -1e300;
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    const double c = points.approx(i).*coordinate;
    low = std::min(low, c), high = std::max(high, c);
  }
  return {low, high};
}

/// Of points in the set's box; with the structures that the first one makes.
template <class Ask>
Once asked(const Nef2& set, Ask ask) {
  constexpr std::size_t kQueries = 1000;
  const auto [left, right] = range_of(set, &Point2::x);
  const auto [bottom, top] = range_of(set, &Point2::y);
  std::vector<Point2> points;
  for (const Point2& p : testing::star_polygon(kQueries, 5)) {  // within 1 of the origin
    points.push_back(
        {left + (right - left) * (p.x + 1) / 2, bottom + (top - bottom) * (p.y + 1) / 2});
  }
  return timed_of(kQueries, [set, points, ask] {
    const Nef2 fresh = !set;  // shares nothing with `set`
    return std::ranges::count_if(points, [&](const Point2& p) { return ask(fresh, p); });
  });
}

/// Alike for a set that comes from real data and for a generated one.
void add_sets(std::vector<Job>& jobs, const std::string& input, bool is_real,
              const std::function<Nef2(int)>& make) {
  const auto add = [&](const char* capability, const char* unit, std::function<Once(Nef2)> of) {
    jobs.push_back({capability, input, is_real, unit, [make, of] { return of(make(0)); }});
  };
  jobs.push_back({"plane Boolean", input + " and another", is_real, "edges",
                  [make] { return union_of_sets(make(0), make(1)); }});
  add("plane topology: regularization", "edges",
      [](const Nef2& set) { return timed([set] { return set.regularization(); }, edges_of); });
  add("plane location, locator made", "points", [](const Nef2& set) {
    return asked(set, [](const Nef2& in, const Point2& p) { return in.contains(p); });
  });
  add("plane ray shooting, structures made", "rays", [](const Nef2& set) {
    return asked(set, [](const Nef2& in, const Point2& p) {
      return in.shoot_to_boundary({Rational(p.x), Rational(p.y)}, {3, 1}).has_value();
    });
  });
  add("exact area", "edges",
      [](const Nef2& set) { return timed_of(edges_of(set), [set] { return *set.area(); }); });
  add("plane audit", "edges", [](const Nef2& set) {
    return timed_of(edges_of(set), [set] {
      Context context;
      PLUMB_CHECK(!audit(set.complex(), AuditForm::Minimal, context));
      return true;
    });
  });
  add("convex pieces of the plane, diagonals", "pieces", [](const Nef2& set) {
    return timed(
        [set] {
          Context context;
          return decompose(set, {PartitionMethod::Diagonals, false}, context);
        },
        [](const auto& result) { return result.pieces.size(); });
  });
}

/// The sides of all cycles of a map: every inner one twice.
SegmentScene sides_of(const Map& map) {
  SegmentScene scene{map.points, {}};
  for (std::size_t c = 0; c < map.cycle_count(); ++c) {
    const auto cycle = map.cycle(c);
    for (std::size_t i = 0; i < cycle.size(); ++i) {
      scene.segments.push_back({cycle[i], cycle[(i + 1) % cycle.size()]});
    }
  }
  return scene;
}

Once arrangement_of(const SegmentScene& scene) {
  return timed([scene] { return arranged(scene); },
               [](const Arrangement& a) { return a.complex.face_count(); });
}

// ---------------------------------------------------------------- the sphere

void add_sphere(std::vector<Job>& jobs, const MacroOptions& options) {
  const std::size_t corners = options.size(10000, 100) / 2 * 2;
  jobs.push_back({"sphere Boolean", "two crowns that cross", false, "arcs", [corners] {
                    const NefSphere a = testing::crown(corners, 0, 0.5, 1.5);
                    const NefSphere b = testing::crown(corners, 0.37, 0.6, 1.4);
                    return timed(
                        [a, b] {
                          Context context;
                          return boolean_op(a, b, kUnion, context);
                        },
                        [](const NefSphere& set) { return set.map().arc_count(); });
                  }});
  const std::size_t triangles = options.size(10000, 100);
  jobs.push_back({"sphere location, locator made", "triangles", false, "directions", [triangles] {
                    return timed_of(1000, [set = testing::scattered_triangles(triangles),
                                           directions = testing::any_directions(1000, 1)] {
                      SphereLocator locator(set);
                      return std::ranges::count_if(
                          directions, [&](const SphereVector& u) { return locator.contains(u); });
                    });
                  }});
}

}  // namespace

void add_flat_jobs(std::vector<Job>& jobs, const MacroOptions& options) {
  add_maps(jobs, options);
  add_sets(jobs, "every other region of us-counties", true,
           [](int which) { return half_of(which == 0 ? kCounties : kStates); });
  const std::size_t corners = options.size(30000, 100);
  add_sets(jobs, "a star", false,
           [corners](int which) { return star(corners, static_cast<std::uint64_t>(which) + 1); });
  jobs.push_back({"plane arrangement", "sides of all cycles of us-counties", true, "faces",
                  [] { return arrangement_of(sides_of(map_of(kCounties))); }});
  const std::size_t segments = options.size(2000, 50);
  jobs.push_back(
      {"plane arrangement", fmt::format("{} long segments", segments), false, "faces",
       [segments] { return arrangement_of(scene_of(testing::long_segments(segments))); }});
  add_sphere(jobs, options);
}

}  // namespace plumb::bench
