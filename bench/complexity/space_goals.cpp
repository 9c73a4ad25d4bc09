// What operations on sets of space cost beside what they are meant to cost.
//
//   space_goals [--depth N] [--slack X] [--only TEXT] [--json FILE]
//
// prints a line for each goal and exits 1 if one is missed by more than the factor --slack (default
// 1). --depth bounds the icospheres: 20 * 4^depth triangles (default 7).
//
//   memory     two icospheres from mesh to triangles of their union; how time grows:
//              space_families, meshes-to-triangles
//   degenerate pairs in almost equal or partly equal planes, the same way
//   locate     random points in an icosphere
//   file       an icosphere to .nef text and back
//   audit      the union of two icospheres audited, beside the union
#include <fmt/format.h>
#include <malloc.h>
#include <sys/resource.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "../report/report.h"
#include "cpu_time.h"
#include "generate/meshes.h"
#include "plumb/io/nef3_reader.h"
#include "plumb/io/nef3_writer.h"
#include "plumb/space/nef3.h"
#include "plumb/space/space_audit.h"
#include "plumb/space/to_mesh.h"
#include "plumb/testing/dice.h"

namespace plumb::bench {
namespace {

struct Options {
  int depth = 7;
  double slack = 1;
  nlohmann::ordered_json rows = nlohmann::ordered_json::array();  ///< what was measured
};

/// The seconds that once() takes.
template <class Once>
double seconds_of(const Once& once) {
  const double start = cpu_seconds();
  once();
  return cpu_seconds() - start;
}

/// Is the goal met, or missed by no more than the slack? 0: there is none.
bool report(Options& options, const std::string& what, double value, const char* unit,
            double goal = 0) {
  const bool is_met = goal == 0 || value <= goal * options.slack;
  fmt::print("{:60} {:10.4g} {:14}", what, value, unit);
  if (goal > 0) fmt::print(" goal {:8.4g}  {}", goal, is_met ? "" : "MISSED");
  fmt::print("\n");
  options.rows.push_back({{"what", what}, {"value", value}, {"unit", unit}});
  if (goal > 0) options.rows.back()["goal"] = goal;
  options.rows.back()["within"] = goal == 0 || value <= goal;
  return is_met;
}

Nef3 solid(const PolygonMesh& mesh) {
  Context context;
  return Nef3::from_mesh(mesh, {.rule = WindingRule::Positive}, context);
}

PolygonMesh ball(int depth, Point3 centre) { return testing::icosphere_mesh(depth, 1, centre); }

/// From meshes to the triangles of the union.
std::size_t unite(const PolygonMesh& a, const PolygonMesh& b) {
  Context context;
  const Nef3 both =
      boolean_op(Nef3::from_mesh(a, {.rule = WindingRule::Positive}, context),
                 Nef3::from_mesh(b, {.rule = WindingRule::Positive}, context), kUnion, context);
  return mesh_of_complex(both.complex(), {MeshFaces::Triangles, false, false}, context)
      .mesh.face_count();
}

// ---------------------------------------------------------------- the goals

double peak_bytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) * 1024;
}

/// What is in use, freed memory given back.
double resident_bytes() {
  malloc_trim(0);
  std::ifstream statm("/proc/self/statm");
  double pages = 0;
  statm >> pages >> pages;
  return pages * static_cast<double>(sysconf(_SC_PAGESIZE));
}

bool measure_memory(Options& options) {
  const PolygonMesh a = ball(options.depth, {0, 0, 0}), b = ball(options.depth, {0.5, 0.25, 0.125});
  const double before = resident_bytes();
  const double faces = static_cast<double>(a.face_count() + b.face_count());
  const double seconds = least_seconds([&] { return seconds_of([&] { unite(a, b); }); });
  const double bytes = peak_bytes() - before;
  const std::string what = fmt::format("two icospheres, mesh to triangles, {:.0f} faces", faces);
  report(options, what, seconds, "s");
  return report(options, "the same, memory, input left out", bytes / faces, "bytes a face", 600);
}

bool measure_degenerate(Options& options) {
  const auto print = [&](const char* what, const PolygonMesh& a, const PolygonMesh& b) {
    report(options, what, least_seconds([&] { return seconds_of([&] { unite(a, b); }); }), "s");
  };
  const PolygonMesh ico = ball(4, {0.1, 0.2, 0.3}), large = ball(5, {0.1, 0.2, 0.3});
  print("an icosphere of 5,120 around (0.1, 0.2, 0.3), and itself turned about the z axis by 1e-12",
        ico, testing::turned(ico, 1e-12));
  const PolygonMesh centred = ball(4, {0, 0, 0});
  print("an icosphere of 5,120 around the origin, turned likewise: ico5120-turned, 22,890 contacts",
        centred, testing::turned(centred, 1e-12));
  print("an icosphere of 20,480 twice: ico20480-twice", large, large);
  print("two cubes of 19,200 triangles, shifted in two planes: cubes19200",
        testing::grid_cube_mesh(40, {0, 0, 0}), testing::grid_cube_mesh(40, {3.25, 2.5, 0}));
  return true;
}

bool measure_location(Options& options) {
  const Nef3 set = solid(ball(std::min(options.depth, 6), {0, 0, 0}));
  testing::Dice dice(7);
  const auto coordinate = [&] {
    return 1e-6 * static_cast<double>(dice.between(-1200000, 1200000));
  };
  std::vector<Point3> points;
  for (int i = 0; i < 200000; ++i) {
    const double x = coordinate(), y = coordinate(), z = coordinate();
    points.push_back({x, y, z});
  }
  std::vector<Mark> marks(points.size());
  set.contains(std::span(points).first(1), std::span(marks).first(1));  // makes the locator
  const double seconds =
      least_seconds([&] { return seconds_of([&] { set.contains(points, marks); }); });
  const std::string what =
      fmt::format("a point located in an icosphere of {}", set.complex().facet_count());
  return report(options, what, seconds / static_cast<double>(points.size()) * 1e6, "microseconds",
                1);
}

bool measure_files(Options& options) {
  const Nef3 set = solid(ball(std::min(options.depth, 6), {0, 0, 0}));
  std::string text;
  const double writing = least_seconds([&] {
    return seconds_of([&] {
      std::ostringstream out;
      write_nef3(out, set.complex());
      text = std::move(out).str();
    });
  });
  const double reading = least_seconds([&] {
    return seconds_of([&] {
      Context context;
      read_nef3(text, {}, context);
    });
  });
  const double megabytes = static_cast<double>(text.size()) * 1e-6;
  const std::string what = fmt::format(".nef of {:.0f} MB", megabytes);
  bool is_met = report(options, what + " written", writing / megabytes * 1e3, "ms a MB", 20);
  is_met &= report(options, what + " read", reading / megabytes * 1e3, "ms a MB", 20);
  return is_met;
}

bool measure_audit(Options& options) {
  const int depth = std::min(options.depth, 5);
  const Nef3 a = solid(ball(depth, {0, 0, 0})), b = solid(ball(depth, {0.5, 0.25, 0.125}));
  Nef3 both;
  const double uniting = least_seconds([&] {
    return seconds_of([&] {
      Context context;
      both = boolean_op(a, b, kUnion, context);
    });
  });
  const double auditing =
      least_seconds([&] { return seconds_of([&] { audit(both.complex(), AuditForm::Minimal); }); });
  return report(options, "a union audited, beside the union", auditing / uniting, "times", 1);
}

}  // namespace
}  // namespace plumb::bench

int main(int argc, char** argv) {
  CLI::App app{"Goals for operations on sets of space"};
  plumb::bench::Options options;
  std::string only, json;
  app.add_option("--depth", options.depth, "of the largest icosphere (default 7)");
  app.add_option("--slack", options.slack, "a goal is missed above this times it (default 1)");
  app.add_option("--only", only, "goals with this in their names");
  app.add_option("--json", json, "write the rows there");
  CLI11_PARSE(app, argc, argv);
  using namespace plumb::bench;
  const std::vector<std::pair<std::string, bool (*)(Options&)>> goals{
      {"memory", measure_memory},
      {"degenerate", measure_degenerate},
      {"locate", measure_location},
      {"file", measure_files},
      {"audit", measure_audit}};
  bool is_met = true;
  for (const auto& [name, measure] : goals) {
    if (name.find(only) != std::string::npos) is_met &= measure(options);
  }
  return write_json(
      json, {{"part", "goals"}, {"title", "Goals for sets of space"}, {"rows", options.rows}},
      is_met ? 0 : 1);
}
