// Maps, sets of the plane and of the sphere.
#include <array>
#include <memory>
#include <vector>

#include "generate/counted_memory.h"
#include "plumb/base/set_expression.h"
#include "plumb/convex/plane_convexity.h"
#include "plumb/convex/plane_partition.h"
#include "plumb/io/map_io.h"
#include "plumb/plane/arrangement.h"
#include "plumb/plane/map_overlay.h"
#include "plumb/plane/plane_measure.h"
#include "plumb/sphere/sphere_locator.h"
#include "system/digest.h"
#include "system/public_operations.h"

namespace plumb::testing {
namespace {

constexpr const char* kMap = "6 3\n0 0\n2 0\n4 0\n4 3\n2 3\n0 3\n1 2 5 6\n2 3 4 5\n1 6 5 4 3 2\n";
constexpr const char* kCrossedMap = "5 2\n0 0\n4 0\n4 4\n0 4\n1 7\n1 2 3 4\n1 3 5\n";
constexpr const char* kWkt =
    "GEOMETRYCOLLECTION (POLYGON ((0 0, 9 0, 9 9, 0 9, 0 0), (2 2, 2 4, 4 4, 2 2)), "
    "LINESTRING (1 -1, 8 10), POINT (20 20))";
constexpr const char* kGeoJson =
    R"({"type": "Polygon", "coordinates": [[[1, 1], [12, 3], [5, 11], [1, 1]]]})";

template <class Range>
std::uint64_t sizes_of(const Range& sets, Context& context) {
  Digest out;
  for (const auto& set : sets) out.add(digest_of(set, context));
  return out.value();
}

std::uint64_t digest_of(const MapOverlay& overlay) {
  Digest out;
  for (const MapOverlay::Origin& origin : overlay.origin) {
    out.add(origin.first);
    out.add(origin.second);
  }
  return out.value();
}

Nef2 plane_set(const char* text, PlaneFormat format) {
  Context context;
  return read_plane_set(text, format, {}, context).set;
}

PointTable2 points_of(std::initializer_list<Point2> points) {
  PointTable2 table;
  for (const Point2 p : points) table.push_back(p);
  return table;
}

}  // namespace

OperationRoom map_operations() {
  struct Maps {
    MapReport first, second;
  };
  const auto maps = std::make_shared<Maps>();
  Context context;
  maps->first = check_map(read_map(kMap, {}, context), {}, context);
  maps->second =
      check_map(read_map("4 2\n1 1\n3 1\n3 2\n1 2\n1 2 3 4\n4 3 2 1\n", {}, context), {}, context);
  const auto checks = [](const char* text) {
    return [text](Context& own) { return digest_of(check_map(read_map(text, {}, own), {}, own)); };
  };
  return {
      "maps",
      [maps] { return digest_of(maps->first) ^ digest_of(maps->second); },
      {
          {"check_map", checks(kMap)},
          {"check_map of a crossing", checks(kCrossedMap)},
          {"write_map",
           [maps](Context&) {
             Digest out;
             write_map(out, maps->first.map);
             return out.value();
           }},
          {"to_dcel", [maps](Context&) { return to_dcel(maps->first).dcel.halfedge_count(); }},
          {"overlay_map",
           [maps](Context& own) { return digest_of(overlay_map(maps->first, own)); }},
          {"overlay_maps, measure",
           [maps](Context& own) {
             const MapOverlay overlay = overlay_maps(maps->first, maps->second, own);
             Digest out;
             out.add(digest_of(overlay));
             for (const Rational& area : measure(overlay, maps->first, maps->second, own).cell) {
               out.add(area);
             }
             return out.value();
           }},
          {"parse_set_expression",
           [](Context&) { return parse_set_expression("A + !(B ^ C) - A * B").steps.size(); }},
      }};
}

OperationRoom plane_operations() {
  struct Sets {
    Nef2 a = plane_set(kWkt, PlaneFormat::Wkt), b = plane_set(kGeoJson, PlaneFormat::GeoJson);
    Line2 line{{0, 0}, {3, 1}};
    PointTable2 points = points_of({{0, 0}, {5, 0}, {5, 5}, {0, 5}});
    std::vector<std::uint32_t> corners{0, 1, 2, 3}, begin{0, 4};
    std::vector<SweepSegment> segments{{0, 2}, {1, 3}};
    std::vector<Nef2> several{a, b, !a};
  };
  const auto s = std::make_shared<const Sets>();
  const auto set = [](auto make) {
    return [make](Context& context) { return digest_of(make(context), context); };
  };
  const auto text = [s](PlaneFormat format) {
    return [s, format](Context& own) {
      Digest out;
      const PlaneText text(s->a, format, own);
      text.write(out, own);
      return out.value() + text.losses().sentences().size();
    };
  };
  return {
      "plane",
      [s] {
        Context context;
        return digest_of(s->a, context) ^ digest_of(s->b, context);
      },
      {
          {"a + b", set([s](Context&) { return s->a + s->b; })},
          {"combine", set([s](Context& own) { return boolean_op(s->a, s->b, kDifference, own); })},
          {"combine with selectors", set([s](Context& own) {
             return boolean_op(s->a, {{}, [](EdgeId) { return false; }, {}}, s->b, {}, kUnion, own);
           })},
          {"!a ^ b", set([s](Context&) { return !s->a ^ s->b; })},
          {"union_of", set([s](Context& own) { return union_of(s->several, own); })},
          {"intersection_of", set([s](Context& own) { return intersection_of(s->several, own); })},
          {"boundary", set([s](Context&) { return s->a.boundary(); })},
          {"interior", set([s](Context&) { return s->a.interior(); })},
          {"closure", set([s](Context&) { return (!s->a).closure(); })},
          {"regularization, exterior",
           set([s](Context&) { return s->a.regularization().exterior(); })},
          {"transformed", set([s](Context&) {
             return s->a.transformed({2, 1, Rational(1, 3), 0, 1, 5});
           })},
          {"half_plane", set([s](Context&) { return Nef2::half_plane(s->line, Boundary::Open); })},
          {"line, ray",
           set([s](Context&) { return Nef2::line(s->line) + Nef2::ray(s->line, Boundary::Open); })},
          {"polygons", set([s](Context& own) {
             return Nef2::polygons(s->points, s->corners, s->begin, WindingRule::NonZero,
                                   Boundary::Closed, own);
           })},
          {"polylines", set([s](Context& own) {
             return Nef2::polylines(s->points, s->corners, s->begin, own);
           })},
          {"points", set([s](Context& own) { return Nef2::points(s->points, own); })},
          {"point", set([](Context&) {
             return Nef2::point({Rational(1, 3), 2});
           })},
          {"polygon, polyline", set([](Context&) {
             const std::array<Point2, 3> corners{{{0, 0}, {4, 0}, {0, 3}}};
             return Nef2::polygon(corners) + Nef2::polyline(corners);
           })},
          {"with_marks",
           set([s](Context&) { return s->a.with_marks(own_copy(s->a.complex().marks)); })},
          {"arrange",
           [s](Context& own) {
             return arrange(own_copy(s->points), s->segments, own).complex.face_count();
           }},
          {"comparisons",
           [s](Context&) {
             return std::uint64_t{s->a.is_subset_of(s->b)} + 2 * std::uint64_t{s->a == s->b};
           }},
          {"questions",
           [s](Context&) {
             return std::uint64_t{s->a.is_closed()} + 2 * std::uint64_t{s->a.is_open()} +
                    4 * std::uint64_t{s->a.is_bounded()} +
                    8 * std::uint64_t{s->a.audit().has_value()};
           }},
          {"parts", [s](Context&) { return s->a.parts().polygons.size(); }},
          {"area",
           [s](Context& own) {
             return std::uint64_t{marked_area(s->a.complex(), own) == s->a.area()};
           }},
          {"locate",
           [s](Context&) {
             const Nef2 fresh = s->a.complement();
             return std::uint64_t{fresh.contains(Point2{1, 1})};
           }},
          {"shoot",
           [s](Context&) {
             const Nef2 fresh = s->a.complement();
             return std::uint64_t{fresh.shoot_to_boundary({3, 1}, {1, 5}).has_value()};
           }},
          {"convexity",
           [s](Context& own) {
             return convexity_of_set(s->a.regularization(), own).reflex_corners;
           }},
          {"decompose",
           [s](Context& own) {
             return sizes_of(decompose(s->a.regularization(), {}, own).pieces, own);
           }},
          {"write WKT", text(PlaneFormat::Wkt)},
          {"write GeoJSON", text(PlaneFormat::GeoJson)},
      }};
}

OperationRoom sphere_operations() {
  struct Sets {
    NefSphere a = NefSphere::half_sphere({1, 2, 3}, Boundary::Closed);
    NefSphere b = NefSphere::half_sphere({-3, 1, 1}, Boundary::Open) -
                  NefSphere::half_sphere({1, 0, -2}, Boundary::Closed);
    std::vector<SphereVector> corners{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    std::vector<NefSphere> several{a, b, !a};
  };
  const auto s = std::make_shared<const Sets>();
  const auto set = [](auto make) { return [make](Context& own) { return digest_of(make(own)); }; };
  return {
      "sphere",
      [s] { return digest_of(s->a) ^ digest_of(s->b); },
      {
          {"a + b", set([s](Context&) { return s->a + s->b; })},
          {"combine", set([s](Context& own) { return boolean_op(s->a, s->b, kDifference, own); })},
          {"combine with selectors", set([s](Context& own) {
             return boolean_op(s->a, {{}, [](std::uint32_t) { return false; }, {}}, s->b, {},
                               kSymmetricDifference, own);
           })},
          {"union_of", set([s](Context& own) { return union_of(s->several, own); })},
          {"intersection_of", set([s](Context& own) { return intersection_of(s->several, own); })},
          {"!b", set([s](Context&) { return !s->b; })},
          {"boundary", set([s](Context&) { return s->b.boundary(); })},
          {"interior", set([s](Context&) { return s->b.interior(); })},
          {"closure, exterior", set([s](Context&) { return s->b.closure().exterior(); })},
          {"half_sphere", set([](Context&) {
             return NefSphere::half_sphere({2, 3, 5}, Boundary::Open);
           })},
          {"circle", set([](Context&) {
             return NefSphere::circle({2, 3, 5});
           })},
          {"convex", set([s](Context&) { return NefSphere::convex(s->corners, Boundary::Open); })},
          {"polygon",
           set([s](Context&) { return NefSphere::polygon(s->corners, Boundary::Closed); })},
          {"arc, points", set([s](Context&) {
             return NefSphere::arc(s->corners[0], s->corners[1]) + NefSphere::points(s->corners);
           })},
          {"from_map", set([s](Context&) { return NefSphere::from_complex(s->b.complex()); })},
          {"with_marks", set([s](Context&) { return s->b.with_marks(s->b.marks()); })},
          {"questions",
           [s](Context&) {
             return std::uint64_t{s->b.is_closed()} + 2 * std::uint64_t{s->b.is_open()} +
                    4 * std::uint64_t{s->b.audit().has_value()} +
                    8 * std::uint64_t{s->a.is_subset_of(s->b)};
           }},
          {"locate",
           [s](Context&) {
             return std::uint64_t{s->b.locate({1, 1, 4}).marked};
           }},
          {"locator",
           [s](Context&) {
             SphereLocator locator(s->b);
             return std::uint64_t{locator.locate({1, 1, 4}).marked} +
                    2 * std::uint64_t{locator.shoot({1, 1, 4}, {4, 1, 1}).has_value()};
           }},
          {"shoot",
           [s](Context&) {
             return std::uint64_t{s->b.shoot({1, 1, 4}, {4, 1, 1}).has_value()};
           }},
      }};
}

}  // namespace plumb::testing
