// Arrangements and Booleans of the plane beside CGAL, on the same data.
//
//   plane_peer [--most PERCENT] [--rounds N] [--json FILE] [JOB...]     (short, long, stars, nef, unbounded; default: all)
//
// unbounded: no other library, but plumb itself with sets clipped to a box. Answers are counts of vertices, edges and faces, marked faces, or areas.
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
#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "../complexity/plane_jobs.h"
#include "peer_report.h"
#include "plumb/predicates/rounding.h"

namespace plumb::bench {
namespace {

using testing::PlanePolygon;

/// What all jobs share.
struct Session {
  PeerReport& report;
  int rounds;
  double most;  ///< percent of the sizes

  std::size_t size(std::size_t full) const {
    return std::max<std::size_t>(10,
                                 static_cast<std::size_t>(static_cast<double>(full) * most / 100));
  }
};

template <class Work, class Answer>
PeerRun timed(Work work, Answer answer) {
  std::optional<decltype(work())> result;
  return timed_run([&] { result.emplace(work()); }, [&] { return answer(*result); });
}

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

void arrangements(const Session& session, const std::string& input,
                  const std::vector<testing::PlaneSegment>& segments) {
  const SegmentScene scene = scene_of(segments);
  std::vector<Traits::Curve_2> curves;
  for (const auto& [p, q] : segments) {
    curves.emplace_back(Exact::Point_2(p.x, p.y), Exact::Point_2(q.x, q.y));
  }
  session.report.compare(
      {"arrangement", fmt::format("{} {} segments", segments.size(), input), "CGAL Arrangement_2",
       "vertices, edges, faces", 0, session.rounds},
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

struct Operation {
  const char* name;
  MarkFunction marks;
};
constexpr Operation kOperations[] = {{"intersection", kIntersection},
                                     {"union", kUnion},
                                     {"symmetric difference", kSymmetricDifference}};

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

void stars(const Session& session, std::size_t n) {
  const PlanePolygon p = testing::star_polygon(n, 1);
  const PlanePolygon q = testing::star_polygon(n, 2);
  const Nef2 a = Nef2::polygon(p);
  const Nef2 b = Nef2::polygon(q);
  const CgalPolygon cgal_p = cgal_polygon(p);
  const CgalPolygon cgal_q = cgal_polygon(q);
  for (const Operation& o : kOperations) {
    session.report.compare(
        {o.name, fmt::format("two stars of {}", n), "CGAL Polygon_set_2", "area", 1e-12,
         session.rounds},
        [&] {
          Context context;
          return timed([&] { return combine(a, b, o.marks, context); },
                       [](const Nef2& set) { return nearest_double(*set.area()); });
        },
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

void nef(const Session& session, std::size_t n) {
  const PlanePolygon p = rounded(testing::star_polygon(n, 1));
  const PlanePolygon q = rounded(testing::star_polygon(n, 2));
  const Nef2 a = Nef2::polygon(p);
  const Nef2 b = Nef2::polygon(q);
  const CgalNef cgal_a = cgal_nef(p);
  const CgalNef cgal_b = cgal_nef(q);
  for (const Operation& o : kOperations) {
    const std::string name = o.name;
    session.report.compare(
        {name, fmt::format("two stars of {}", n), "CGAL Nef_polyhedron_2", "marked faces", 0,
         session.rounds},
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

// ---------------------------------------------------------------- unbounded sets

/// Against the same half-planes clipped to a box, in plumb itself.
void unbounded(const Session& session, std::size_t n) {
  const std::vector<Nef2> open_ended = half_planes(n);
  const Nef2 box =
      Nef2::polygon(std::vector<Point2>{{-4, -4}, {4, -4}, {4, 4}, {-4, 4}}, Boundary::Closed);
  std::vector<Nef2> clipped;
  for (const Nef2& h : open_ended) clipped.push_back(h * box);
  for (const Operation& o : kOperations) {
    if (o.name == std::string("union")) continue;
    const auto fold = [&](const std::vector<Nef2>& sets) {
      return timed(
          [&] {
            Nef2 result = sets.front();
            for (std::size_t i = 1; i < sets.size(); ++i) {
              Context context;
              result = combine(result, sets[i], o.marks, context);
            }
            return result;
          },
          [&](const Nef2& set) { return nearest_double(*(set * box).area()); });
    };
    session.report.compare(
        {fmt::format("{}, one by one", o.name), fmt::format("{} half-planes", n),
         "plumb, clipped to a box", "area in the box", 0, session.rounds},
        [&] { return fold(open_ended); }, [&] { return fold(clipped); });
  }
}

int run(const Session& session, const std::vector<std::string>& jobs, const std::string& json) {
  const auto is_wanted = [&](const char* job) {
    return jobs.empty() || std::ranges::find(jobs, job) != jobs.end();
  };
  session.report.use("CGAL", CGAL_VERSION_STR);
  if (is_wanted("short")) {
    arrangements(session, "short", testing::short_segments(session.size(100000)));
  }
  if (is_wanted("long")) {
    arrangements(session, "long", testing::long_segments(session.size(2000)));
  }
  if (is_wanted("stars")) {
    for (const std::size_t n : {1000, 30000}) stars(session, session.size(n));
  }
  if (is_wanted("nef")) nef(session, session.size(1000));
  if (is_wanted("unbounded")) unbounded(session, session.size(40));
  return session.report.finish(json);
}

}  // namespace
}  // namespace plumb::bench

int main(int argc, char** argv) {
  CLI::App app{"The plane beside CGAL"};
  std::vector<std::string> jobs;
  double most = 100;
  int rounds = 3;
  std::string json;
  app.add_option("--most", most, "percent of the full sizes (default 100)");
  app.add_option("--rounds", rounds, "of plumb and CGAL in turn (default 3)");
  app.add_option("--json", json, "write the comparisons there");
  app.add_option("jobs", jobs, "short, long, stars, nef, unbounded; default: all");
  CLI11_PARSE(app, argc, argv);
  plumb::bench::PeerReport report("The plane beside CGAL; unbounded sets beside the same in a box");
  return plumb::bench::run({report, rounds, most}, jobs, json);
}
