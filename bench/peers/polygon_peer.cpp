// Booleans of polygons beside libraries that round: GEOS, Boost.Geometry and Boost.Polygon, on the
// same data.
//
//   polygon_peer [--most PERCENT] [--rounds N] [--json FILE] [JOB...]     (stars, octagons;
//   default: both)
//
// The answer is the area, compared to 10^-9, with Boost, which rounds to grids of integers, to
// 10^-6.
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
#include <boost/geometry/geometries/geometries.hpp>
#include <boost/geometry/geometry.hpp>
#include <boost/polygon/polygon.hpp>
#include <boost/version.hpp>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "../complexity/plane_jobs.h"
#include "flat_booleans.h"

namespace plumb::bench {
namespace {

using testing::PlanePolygon;

// ---------------------------------------------------------------- GEOS

using GeosPointer = std::unique_ptr<geos::geom::Geometry>;

const geos::geom::GeometryFactory& geos_factory() {
  static const auto factory = geos::geom::GeometryFactory::create();
  return *factory;
}

GeosPointer geos_polygon(const PlanePolygon& polygon) {
  std::vector<geos::geom::Coordinate> points;
  for (const Point2& p : polygon) points.emplace_back(p.x, p.y);
  points.push_back(points.front());
  auto sequence = geos_factory().getCoordinateSequenceFactory()->create(std::move(points));
  return geos_factory().createPolygon(geos_factory().createLinearRing(std::move(sequence)));
}

PeerRun geos_overlay(const GeosPointer& p, const GeosPointer& q, int operation) {
  GeosPointer result;
  return timed_run(
      [&] {
        result = geos::operation::overlayng::OverlayNGRobust::Overlay(p.get(), q.get(), operation);
      },
      [&] { return result->getArea(); });
}

// ---------------------------------------------------------------- Boost.Geometry

namespace bg = boost::geometry;
using BoostPolygon =
    bg::model::polygon<bg::model::d2::point_xy<double>, false>;  // counter-clockwise
using BoostPolygons = bg::model::multi_polygon<BoostPolygon>;

BoostPolygon boost_polygon(const PlanePolygon& polygon) {
  BoostPolygon result;
  for (const Point2& p : polygon)
    bg::append(result.outer(), bg::model::d2::point_xy<double>(p.x, p.y));
  bg::correct(result);
  return result;
}

PeerRun boost_overlay(const BoostPolygon& p, const BoostPolygon& q, const std::string& name) {
  BoostPolygons result;
  return timed_run(
      [&] {
        if (name == "union") bg::union_(p, q, result);
        if (name == "intersection") bg::intersection(p, q, result);
        if (name == "symmetric difference") bg::sym_difference(p, q, result);
      },
      [&] { return bg::area(result); });
}

// ---------------------------------------------------------------- Booleans of two stars

int geos_code(const std::string& name) {
  using geos::operation::overlayng::OverlayNG;
  if (name == "union") return OverlayNG::UNION;
  return name == "intersection" ? OverlayNG::INTERSECTION : OverlayNG::SYMDIFFERENCE;
}

void stars(PeerReport& report, const PeerOptions& options, std::size_t n) {
  const PlanePolygon p = testing::star_polygon(n, 1);
  const PlanePolygon q = testing::star_polygon(n, 2);
  const Nef2 a = Nef2::polygon(p);
  const Nef2 b = Nef2::polygon(q);
  const GeosPointer geos_p = geos_polygon(p);
  const GeosPointer geos_q = geos_polygon(q);
  const BoostPolygon boost_p = boost_polygon(p);
  const BoostPolygon boost_q = boost_polygon(q);
  for (const FlatBoolean& o : kFlatBooleans) {
    const auto ours = [&] { return timed_boolean(a, b, o.marks); };
    PeerJob job{o.name,        fmt::format("two stars of {}", n), "GEOS OverlayNG", "area", 1e-9,
                options.rounds};
    report.compare(job, ours, [&] { return geos_overlay(geos_p, geos_q, geos_code(o.name)); });
    job.peer = "Boost.Geometry";
    job.tolerance = 1e-6;  // it rounds to a grid
    report.compare(job, ours, [&] { return boost_overlay(boost_p, boost_q, o.name); });
  }
}

// ---------------------------------------------------------------- union of many

namespace bp = boost::polygon;

double boost_area(const std::vector<bp::polygon_with_holes_data<int>>& polygons) {
  double area = 0;
  for (const auto& p : polygons) area += static_cast<double>(bp::area(p));
  return area;
}

PeerRun boost_union(const std::vector<PlanePolygon>& polygons) {
  std::vector<bp::polygon_with_holes_data<int>> result;
  return timed_run(
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
        set.get(result);
      },
      [&] { return boost_area(result); });
}

PeerRun geos_union(const std::vector<PlanePolygon>& polygons) {
  std::vector<GeosPointer> geometries;
  GeosPointer result;
  return timed_run(
      [&] {
        std::vector<geos::geom::Polygon*> pointers;
        for (const PlanePolygon& p : polygons) {
          geometries.push_back(geos_polygon(p));
          pointers.push_back(dynamic_cast<geos::geom::Polygon*>(geometries.back().get()));
        }
        result = geos::operation::geounion::CascadedPolygonUnion::Union(&pointers);
      },
      [&] { return result->getArea(); });
}

/// All begin with corners: making polygons of them is a part of it.
void octagons(PeerReport& report, const PeerOptions& options, std::size_t n) {
  const std::vector<PlanePolygon> polygons = testing::octagons(n);
  const auto ours = [&] {
    return timed([&] { return union_of_polygons(polygons); },
                 [](const Nef2& set) { return area_of(set); });
  };
  PeerJob job{"union",       fmt::format("{} octagons", n), "Boost.Polygon", "area", 1e-6,
              options.rounds};
  report.compare(job, ours, [&] { return boost_union(polygons); });
  job.peer = "GEOS CascadedPolygonUnion";
  report.compare(job, ours, [&] { return geos_union(polygons); });
}

}  // namespace
}  // namespace plumb::bench

int main(int argc, char** argv) {
  using namespace plumb::bench;
  CLI::App app{"Polygons beside libraries that round"};
  PeerOptions options;
  options.add_to(app);
  options.add_most_to(app);
  options.add_jobs_to(app, "stars, octagons");
  CLI11_PARSE(app, argc, argv);
  PeerReport report("Polygons beside libraries that round");
  report.use("GEOS", GEOS_VERSION);
  report.use("Boost", BOOST_LIB_VERSION);
  if (options.wants("stars")) {
    for (const std::size_t n : {1000U, 10000U}) stars(report, options, options.size(n));
  }
  if (options.wants("octagons")) octagons(report, options, options.size(30000));
  return report.finish(options.json);
}
