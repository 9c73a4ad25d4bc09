// Arrangements and Booleans of the plane beside CGAL, GEOS and Boost.Polygon, on the same data.
//
//   plane_peer JOB... (short, long, stars, nef, octagons, unbounded; default all) [--size N]
//
// Runs are interleaved, plumb and peer in turn, in one process; CPU time of the operation alone,
// least, median and greatest ratio of plumb to the peer over the rounds. The answers are compared:
// counts of vertices, edges and faces, or areas (exactly with CGAL, to 10^-9 with GEOS and
// Boost.Polygon, which round).
#include <CGAL/Arr_segment_traits_2.h>
#include <CGAL/Arrangement_2.h>
#include <CGAL/Exact_integer.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Filtered_extended_homogeneous.h>
#include <CGAL/Nef_polyhedron_2.h>
#include <CGAL/Polygon_2.h>
#include <CGAL/Polygon_set_2.h>
#include <fmt/core.h>
#include <geos/geom/CoordinateSequence.h>
#include <geos/geom/CoordinateSequenceFactory.h>
#include <geos/geom/Geometry.h>
#include <geos/geom/GeometryFactory.h>
#include <geos/geom/LinearRing.h>
#include <geos/geom/Polygon.h>
#include <geos/operation/overlayng/OverlayNG.h>
#include <geos/operation/overlayng/OverlayNGRobust.h>
#include <geos/operation/union/CascadedPolygonUnion.h>
#include <geos/version.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <boost/polygon/polygon.hpp>
#include <boost/version.hpp>
#include <cmath>
#include <cstdio>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "../complexity/cpu_time.h"
#include "../complexity/plane_jobs.h"
#include "plumb/predicates/rounding.h"

namespace plumb::bench {
namespace {

using testing::PlanePolygon;

/// What a run took, and a figure of its answer to compare.
struct Run {
  double seconds = 0;
  double answer = 0;
};

bool agree_all = true;

// One job against one peer.
void compare(const std::string& job, const std::string& peer, int rounds, double tolerance,
             const std::function<Run()>& ours, const std::function<Run()>& theirs) {
  std::vector<double> ratios;
  Run a;
  Run b;
  double least_ours = 1e300;
  double least_theirs = 1e300;
  for (int i = 0; i < rounds; ++i) {
    a = ours();
    b = theirs();
    ratios.push_back(a.seconds / b.seconds);
    least_ours = std::min(least_ours, a.seconds);
    least_theirs = std::min(least_theirs, b.seconds);
  }
  std::sort(ratios.begin(), ratios.end());
  const bool agree = std::fabs(a.answer - b.answer) <= tolerance * std::fabs(a.answer);
  fmt::print("{:34} {:22} plumb {:9.4f} s  peer {:9.4f} s  ratio {:.3f} ({:.3f} .. {:.3f}){}\n",
             job, peer, least_ours, least_theirs, ratios[ratios.size() / 2], ratios.front(),
             ratios.back(),
             agree ? "" : fmt::format("  ANSWERS DIFFER: {} and {}", a.answer, b.answer));
  std::fflush(stdout);
  agree_all = agree_all && agree;
}

template <class Work, class Answer>
Run timed(Work work, Answer answer) {
  const double start = cpu_seconds();
  const auto result = work();
  const double seconds = cpu_seconds() - start;
  return {seconds, answer(result)};
}

// ---------------------------------------------------------------- arrangements

using Exact = CGAL::Exact_predicates_exact_constructions_kernel;
using Traits = CGAL::Arr_segment_traits_2<Exact>;
using CgalArrangement = CGAL::Arrangement_2<Traits>;

void arrangements(const std::string& job, const std::vector<testing::PlaneSegment>& segments) {
  const SegmentScene scene = scene_of(segments);
  std::vector<Traits::Curve_2> curves;
  for (const auto& [p, q] : segments) {
    curves.emplace_back(Exact::Point_2(p.x, p.y), Exact::Point_2(q.x, q.y));
  }
  const auto ours = [&] {
    return timed([&] { return arranged(scene); },
                 [](const Arrangement& a) {
                   return static_cast<double>(a.complex.vertex_count() + a.complex.edge_count() +
                                              a.complex.face_count());
                 });
  };
  const auto theirs = [&] {
    return timed(
        [&] {
          CgalArrangement arrangement;
          CGAL::insert(arrangement, curves.begin(), curves.end());
          return arrangement;
        },
        [](const CgalArrangement& a) {
          return static_cast<double>(a.number_of_vertices() + a.number_of_edges() +
                                     a.number_of_faces());
        });
  };
  compare(fmt::format("{} n={}", job, segments.size()), "CGAL Arrangement_2", 3, 0, ours, theirs);
}

// ---------------------------------------------------------------- Booleans of two stars

struct Operation {
  const char* name;
  MarkFunction marks;
  int geos;
};
constexpr Operation kOperations[] = {
    {"intersection", kIntersection, geos::operation::overlayng::OverlayNG::INTERSECTION},
    {"union", kUnion, geos::operation::overlayng::OverlayNG::UNION},
    {"symmetric difference", kSymmetricDifference,
     geos::operation::overlayng::OverlayNG::SYMDIFFERENCE}};

double nef_area(const Nef2& set) { return nearest_double(*set.area()); }

std::function<Run()> plumb_boolean(const Nef2& a, const Nef2& b, MarkFunction f) {
  return [&a, &b, f] {
    Context context;
    return timed([&] { return combine(a, b, f, context); }, nef_area);
  };
}

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

Run cgal_set_boolean(const CgalPolygon& p, const CgalPolygon& q, const std::string& name) {
  CgalSet a(p);
  const CgalSet b(q);
  return timed(
      [&] {
        if (name == "union") a.join(b);
        if (name == "intersection") a.intersection(b);
        if (name == "symmetric difference") a.symmetric_difference(b);
        return a;
      },
      cgal_area);
}

const geos::geom::GeometryFactory& geos_factory() {
  static const auto factory = geos::geom::GeometryFactory::create();
  return *factory;
}

std::unique_ptr<geos::geom::Geometry> geos_polygon(const PlanePolygon& polygon) {
  std::vector<geos::geom::Coordinate> points;
  for (const Point2& p : polygon) points.emplace_back(p.x, p.y);
  points.push_back(points.front());
  auto sequence = geos_factory().getCoordinateSequenceFactory()->create(std::move(points));
  return geos_factory().createPolygon(geos_factory().createLinearRing(std::move(sequence)));
}

void stars(std::size_t n) {
  const PlanePolygon p = testing::star_polygon(n, 1);
  const PlanePolygon q = testing::star_polygon(n, 2);
  const Nef2 a = Nef2::polygon(p);
  const Nef2 b = Nef2::polygon(q);
  const CgalPolygon cgal_p = cgal_polygon(p);
  const CgalPolygon cgal_q = cgal_polygon(q);
  const auto geos_p = geos_polygon(p);
  const auto geos_q = geos_polygon(q);
  for (const Operation& o : kOperations) {
    const std::string job = fmt::format("stars n={} {}", n, o.name);
    compare(job, "CGAL Polygon_set_2", 3, 1e-9, plumb_boolean(a, b, o.marks),
            [&] { return cgal_set_boolean(cgal_p, cgal_q, o.name); });
    compare(job, "GEOS OverlayNG", n > 30000 ? 1 : 3, 1e-9, plumb_boolean(a, b, o.marks), [&] {
      return timed(
          [&] {
            return geos::operation::overlayng::OverlayNGRobust::Overlay(geos_p.get(), geos_q.get(),
                                                                        o.geos);
          },
          [](const auto& g) { return g->getArea(); });
    });
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

double faces_of(const CgalNef& set) {
  const auto explorer = set.explorer();
  double marked = 0;
  for (auto f = explorer.faces_begin(); f != explorer.faces_end(); ++f) marked += f->mark() ? 1 : 0;
  return marked;
}

double marked_faces(const Nef2& set) {
  const auto& marks = set.complex().marks.face;
  return static_cast<double>(std::count(marks.begin(), marks.end(), std::uint8_t{1}));
}

PlanePolygon rounded(PlanePolygon polygon) {
  for (Point2& p : polygon) {
    p = {std::round(p.x * 0x1p40) * 0x1p-40, std::round(p.y * 0x1p40) * 0x1p-40};
  }
  return polygon;
}

void nef(std::size_t n) {
  const PlanePolygon p = rounded(testing::star_polygon(n, 1));
  const PlanePolygon q = rounded(testing::star_polygon(n, 2));
  const Nef2 a = Nef2::polygon(p);
  const Nef2 b = Nef2::polygon(q);
  const CgalNef cgal_a = cgal_nef(p);
  const CgalNef cgal_b = cgal_nef(q);
  for (const Operation& o : kOperations) {
    const std::string name = o.name;
    compare(
        fmt::format("stars n={} {}", n, name), "CGAL Nef_2", 1, 0,
        [&] {
          Context context;
          return timed([&] { return combine(a, b, o.marks, context); }, marked_faces);
        },
        [&] {
          return timed(
              [&] {
                if (name == "union") return cgal_a.join(cgal_b);
                if (name == "intersection") return cgal_a.intersection(cgal_b);
                return cgal_a.symmetric_difference(cgal_b);
              },
              faces_of);
        });
  }
}

// ---------------------------------------------------------------- union of many

namespace bp = boost::polygon;

void octagons(std::size_t n) {
  const std::vector<PlanePolygon> polygons = testing::octagons(n);
  const auto ours = [&] { return timed([&] { return union_of_polygons(polygons); }, nef_area); };
  compare(fmt::format("octagons n={} union", n), "Boost.Polygon", 3, 1e-6, ours, [&] {
    return timed(
        [&] {
          bp::polygon_set_data<int> set;
          for (const PlanePolygon& polygon : polygons) {
            std::vector<bp::point_data<int>> points;
            for (const Point2& p : polygon) {
              points.emplace_back(static_cast<int>(p.x), static_cast<int>(p.y));
            }
            bp::polygon_data<int> data;
            data.set(points.begin(), points.end());
            set.insert(data);
          }
          std::vector<bp::polygon_with_holes_data<int>> result;
          set.get(result);
          return result;
        },
        [](const auto& result) {
          double area = 0;
          for (const auto& p : result) area += static_cast<double>(bp::area(p));
          return area;
        });
  });
  std::vector<std::unique_ptr<geos::geom::Geometry>> geometries;
  std::vector<geos::geom::Polygon*> pointers;
  for (const PlanePolygon& p : polygons) {
    geometries.push_back(geos_polygon(p));
    pointers.push_back(dynamic_cast<geos::geom::Polygon*>(geometries.back().get()));
  }
  compare(fmt::format("octagons n={} union", n), "GEOS CascadedUnion", 1, 1e-6, ours, [&] {
    return timed([&] { return geos::operation::geounion::CascadedPolygonUnion::Union(&pointers); },
                 [](const auto& g) { return g->getArea(); });
  });
}

// ---------------------------------------------------------------- unbounded sets

/// Against the same half-planes clipped to a box, in plumb itself.
void unbounded(std::size_t n) {
  const std::vector<Nef2> open_ended = half_planes(n);
  const Nef2 box =
      Nef2::polygon(std::vector<Point2>{{-4, -4}, {4, -4}, {4, 4}, {-4, 4}}, Boundary::Closed);
  std::vector<Nef2> clipped;
  for (const Nef2& h : open_ended) clipped.push_back(h * box);
  const auto fold = [](std::span<const Nef2> sets, MarkFunction f) {
    return [sets, f] {
      return timed(
          [&] {
            Nef2 result = sets.front();
            for (const Nef2& s : sets.subspan(1)) {
              Context context;
              result = combine(result, s, f, context);
            }
            return result;
          },
          [](const Nef2&) { return 0.0; });
    };
  };
  compare(fmt::format("half-planes n={} symmetric diff.", n), "the same in a box", 3, 0,
          fold(open_ended, kSymmetricDifference), fold(clipped, kSymmetricDifference));
  compare(fmt::format("half-planes n={} intersection", n), "the same in a box", 3, 0,
          fold(open_ended, kIntersection), fold(clipped, kIntersection));
}

int run(const std::vector<std::string>& jobs, std::size_t size) {
  const auto wanted = [&](const char* job) {
    return jobs.empty() || std::find(jobs.begin(), jobs.end(), job) != jobs.end();
  };
  fmt::print("CGAL {}, GEOS {}, Boost {}\n", CGAL_VERSION_STR, GEOS_VERSION, BOOST_LIB_VERSION);
  if (wanted("short"))
    arrangements("short segments", testing::short_segments(size ? size : 100000));
  if (wanted("long")) arrangements("long segments", testing::long_segments(size ? size : 2000));
  if (wanted("stars")) {
    for (const std::size_t n : {1000, 10000, 100000}) {
      if (size == 0 || size == n) stars(n);
    }
  }
  if (wanted("nef")) nef(size ? size : 1000);
  if (wanted("octagons")) octagons(size ? size : 100000);
  if (wanted("unbounded")) unbounded(size ? size : 40);
  return agree_all ? 0 : 1;
}

}  // namespace
}  // namespace plumb::bench

int main(int argc, char** argv) {
  CLI::App app{"The plane beside its peers"};
  std::vector<std::string> jobs;
  std::size_t size = 0;
  app.add_option("jobs", jobs, "short, long, stars, nef, octagons, unbounded; default: all");
  app.add_option("--size", size, "instead of the default sizes");
  CLI11_PARSE(app, argc, argv);
  return plumb::bench::run(jobs, size);
}
