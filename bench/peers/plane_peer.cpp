// Arrangements and Booleans of the plane beside CGAL, on the same data.
//
//   plane_peer [--most PERCENT] [--rounds N] [--json FILE] [JOB...]     (short, long, stars, nef,
//   unbounded; default: all)
//
// unbounded: no other library, but plumb itself with sets clipped to a box. Answers are counts of
// vertices, edges and faces, or areas.
#include <CGAL/Arr_segment_traits_2.h>
#include <CGAL/Arrangement_2.h>
#include <CGAL/Exact_integer.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Filtered_extended_homogeneous.h>
#include <CGAL/Nef_polyhedron_2.h>
#include <CGAL/Polygon_2.h>
#include <CGAL/Polygon_set_2.h>
#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "../complexity/plane_jobs.h"
#include "flat_booleans.h"

namespace plumb::bench {
namespace {

using testing::PlanePolygon;

// ---------------------------------------------------------------- arrangements

using Exact = CGAL::Exact_predicates_exact_constructions_kernel;
using Traits = CGAL::Arr_segment_traits_2<Exact>;
using CgalArrangement = CGAL::Arrangement_2<Traits>;

/// Vertices, edges and faces.
double count(const Arrangement& a) {
  return static_cast<double>(a.complex.vertex_count() + a.complex.edge_count() +
                             a.complex.face_count());
}
double count(const CgalArrangement& a) {
  return static_cast<double>(a.number_of_vertices() + a.number_of_edges() + a.number_of_faces());
}

void arrangements(PeerReport& report, const PeerOptions& options, const std::string& input,
                  const std::vector<testing::PlaneSegment>& segments) {
  const SegmentScene scene = scene_of(segments);
  std::vector<Traits::Curve_2> curves;
  for (const auto& [p, q] : segments) {
    curves.emplace_back(Exact::Point_2(p.x, p.y), Exact::Point_2(q.x, q.y));
  }
  report.compare(
      {"arrangement", fmt::format("{} {} segments", segments.size(), input), "CGAL Arrangement_2",
       "vertices, edges, faces", 0, options.rounds},
      [&] {
        return timed([&] { return arranged(scene); },
                     [](const Arrangement& result) { return count(result); });
      },
      [&] {
        CgalArrangement result;
        return timed_run([&] { CGAL::insert(result, curves.begin(), curves.end()); },
                         [&] { return count(result); });
      });
}

// ---------------------------------------------------------------- Booleans of two stars

using CgalPolygon = CGAL::Polygon_2<Exact>;
using CgalSet = CGAL::Polygon_set_2<Exact>;

CgalPolygon cgal_polygon(const PlanePolygon& polygon) {
  CgalPolygon result;
  for (const Point2& p : polygon) result.push_back(Exact::Point_2(p.x, p.y));
  return result;
}

double cgal_area(const CgalSet& set) {
  std::vector<CGAL::Polygon_with_holes_2<Exact>> polygons;
  set.polygons_with_holes(std::back_inserter(polygons));
  double area = 0;
  for (const auto& p : polygons) {
    area += CGAL::to_double(p.outer_boundary().area());
    for (auto h = p.holes_begin(); h != p.holes_end(); ++h) area += CGAL::to_double(h->area());
  }
  return area;
}

PeerRun cgal_set_boolean(const CgalPolygon& p, const CgalPolygon& q, const std::string& name) {
  CgalSet a(p);
  const CgalSet b(q);
  return timed_run(
      [&] {
        if (name == "union") a.join(b);
        if (name == "intersection") a.intersection(b);
        if (name == "symmetric difference") a.symmetric_difference(b);
      },
      [&] { return cgal_area(a); });
}

void stars(PeerReport& report, const PeerOptions& options, std::size_t n) {
  const PlanePolygon p = testing::star_polygon(n, 1);
  const PlanePolygon q = testing::star_polygon(n, 2);
  const Nef2 a = Nef2::polygon(p);
  const Nef2 b = Nef2::polygon(q);
  const CgalPolygon cgal_p = cgal_polygon(p);
  const CgalPolygon cgal_q = cgal_polygon(q);
  for (const FlatBoolean& o : kFlatBooleans) {
    report.compare(
        {o.name, fmt::format("two stars of {}", n), "CGAL Polygon_set_2", "area", 1e-12,
         options.rounds},
        [&] { return timed_boolean(a, b, o.marks); },
        [&] { return cgal_set_boolean(cgal_p, cgal_q, o.name); });
  }
}

// ---------------------------------------------------------------- Nef_2

using NefKernel = CGAL::Filtered_extended_homogeneous<CGAL::Exact_integer>;
using CgalNef = CGAL::Nef_polyhedron_2<NefKernel>;

/// Coordinates times 2^40, as integers.
CgalNef cgal_nef(const PlanePolygon& polygon) {
  std::vector<CgalNef::Point> points;
  for (const Point2& p : polygon) {
    points.emplace_back(CGAL::Exact_integer(std::round(p.x * 0x1p40)),
                        CGAL::Exact_integer(std::round(p.y * 0x1p40)));
  }
  return CgalNef(points.begin(), points.end(), CgalNef::INCLUDED);
}

/// Of marked faces, which are to be bounded: along the half-edges around them.
double cgal_area(const CgalNef& set) {
  const auto explorer = set.explorer();
  const auto place = [&](const auto& vertex) {
    const auto p = explorer.point(vertex);
    return Point2{CGAL::to_double(p.x()) * 0x1p-40, CGAL::to_double(p.y()) * 0x1p-40};
  };
  double twice = 0;
  for (auto e = explorer.halfedges_begin(); e != explorer.halfedges_end(); ++e) {
    if (!explorer.mark(explorer.face(e))) continue;
    const Point2 p = place(explorer.source(e)), q = place(explorer.target(e));
    twice += p.x * q.y - p.y * q.x;
  }
  return twice / 2;
}

PlanePolygon rounded(PlanePolygon polygon) {
  for (Point2& p : polygon) {
    p = {std::round(p.x * 0x1p40) * 0x1p-40, std::round(p.y * 0x1p40) * 0x1p-40};
  }
  return polygon;
}

void nef(PeerReport& report, const PeerOptions& options, std::size_t n) {
  const PlanePolygon p = rounded(testing::star_polygon(n, 1));
  const PlanePolygon q = rounded(testing::star_polygon(n, 2));
  const Nef2 a = Nef2::polygon(p);
  const Nef2 b = Nef2::polygon(q);
  const CgalNef cgal_a = cgal_nef(p);
  const CgalNef cgal_b = cgal_nef(q);
  for (const FlatBoolean& o : kFlatBooleans) {
    const std::string name = o.name;
    report.compare(
        {name, fmt::format("two stars of {}", n), "CGAL Nef_polyhedron_2", "area", 1e-9,
         options.rounds},
        [&] { return timed_boolean(a, b, o.marks); },
        [&] {
          return timed(
              [&] {
                if (name == "union") return cgal_a.join(cgal_b);
                if (name == "intersection") return cgal_a.intersection(cgal_b);
                return cgal_a.symmetric_difference(cgal_b);
              },
              [](const CgalNef& set) { return cgal_area(set); });
        });
  }
}

// ---------------------------------------------------------------- unbounded sets

/// Against the same half-planes clipped to a box, in plumb itself.
void unbounded(PeerReport& report, const PeerOptions& options, std::size_t n) {
  const std::vector<Nef2> open_ended = half_planes(n);
  const Nef2 box =
      Nef2::polygon(std::vector<Point2>{{-4, -4}, {4, -4}, {4, 4}, {-4, 4}}, Boundary::Closed);
  std::vector<Nef2> clipped;
  for (const Nef2& h : open_ended) clipped.push_back(h * box);
  for (const FlatBoolean& o : kFlatBooleans) {
    if (o.name == std::string("union")) continue;
    const auto fold = [&](const std::vector<Nef2>& sets) {
      return timed(
          [&] {
            Nef2 result = sets.front();
            for (std::size_t i = 1; i < sets.size(); ++i) {
              Context context;
              result = boolean_op(result, sets[i], o.marks, context);
            }
            return result;
          },
          [&](const Nef2& set) { return area_of(set * box); });
    };
    report.compare(
        {fmt::format("{}, one by one", o.name), fmt::format("{} half-planes", n),
         "plumb, clipped to a box", "area in the box", 0, options.rounds},
        [&] { return fold(open_ended); }, [&] { return fold(clipped); });
  }
}

}  // namespace
}  // namespace plumb::bench

int main(int argc, char** argv) {
  using namespace plumb::bench;
  CLI::App app{"The plane beside CGAL"};
  PeerOptions options;
  options.add_to(app);
  options.add_most_to(app);
  options.add_jobs_to(app, "short, long, stars, nef, unbounded");
  CLI11_PARSE(app, argc, argv);
  PeerReport report("The plane beside CGAL; unbounded sets beside the same in a box");
  report.use("CGAL", CGAL_VERSION_STR);
  if (options.wants("short")) {
    arrangements(report, options, "short", plumb::testing::short_segments(options.size(100000)));
  }
  if (options.wants("long")) {
    arrangements(report, options, "long", plumb::testing::long_segments(options.size(2000)));
  }
  if (options.wants("stars")) {
    for (const std::size_t n : {1000U, 30000U}) stars(report, options, options.size(n));
  }
  if (options.wants("nef")) nef(report, options, options.size(1000));
  if (options.wants("unbounded")) unbounded(report, options, options.size(40));
  return report.finish(options.json);
}
