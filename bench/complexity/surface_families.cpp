// How the time of dividing surfaces grows, family by family; and scenes of the sizes others publish.
//
//   surface_families [--most N] [--slack S] [--goals]
//
// CPU time of SurfaceDivision alone (slicing, cells, labels) against s + k, segments and crossings, up to about N
// segments (default 100000; a short run: 10000). Prints times and the fitted exponent with its 95% confidence
// interval. Exit status 1 when an exponent is above the limit. --goals: four scenes, once each.
#include <fmt/core.h>
#include <sys/resource.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <random>
#include <vector>

#include "cpu_time.h"
#include "plumb/surface/surface.h"
#include "power_fit.h"

namespace plumb::bench {
namespace {

constexpr double kLimit = 1.2;

/// A torus of columns x rows squares, each cut by its diagonal; and rings drawn on it, from square to square.
class TorusScene {
 public:
  TorusScene(std::uint32_t columns, std::uint32_t rows)
      : columns_(columns), rows_(rows), mesh_(make_mesh()), polygons_(*mesh_) {}

  /// A ring of `corners` corners around (x, y), in squares.
  void add_ring(double x, double y, double radius, int corners, double turn) {
    Place last = ring_point(x, y, radius, corners, 0, turn);
    for (int i = 1; i <= corners; ++i) {
      const Place to = ring_point(x, y, radius, corners, i % corners, turn);
      add_leg(last, to);
      last = to;
    }
    polygons_.close();
  }
  SurfaceScene scene() && { return {mesh_, std::move(polygons_), {}, FaceId{}}; }

 private:
  struct Place {
    double x, y;
  };

  std::uint32_t vertex(long x, long y) const {
    const long i = (x % columns_ + columns_) % columns_, j = (y % rows_ + rows_) % rows_;
    return static_cast<std::uint32_t>(j * columns_ + i);
  }
  /// Of the square at (x, y): the lower right triangle, then the upper left one.
  FaceId face(long x, long y, bool is_upper) const {
    return FaceId(std::size_t{2} * vertex(x, y) + (is_upper ? 1 : 0));
  }
  std::shared_ptr<const SurfaceMesh> make_mesh() const {
    std::vector<Point3> points;
    std::vector<SurfaceTriangle> triangles;
    for (long y = 0; y < rows_; ++y) {
      for (long x = 0; x < columns_; ++x) {
        const double s =
            2 * std::numbers::pi * static_cast<double>(x) / static_cast<double>(columns_);
        const double t = 2 * std::numbers::pi * static_cast<double>(y) / static_cast<double>(rows_);
        const double r = 2 + std::cos(t);
        points.push_back({r * std::cos(s), r * std::sin(s), std::sin(t)});
        triangles.push_back({vertex(x, y), vertex(x + 1, y), vertex(x + 1, y + 1)});
        triangles.push_back({vertex(x, y), vertex(x + 1, y + 1), vertex(x, y + 1)});
      }
    }
    return std::make_shared<const SurfaceMesh>(std::move(points), std::move(triangles));
  }

  static Place ring_point(double x, double y, double radius, int corners, int i, double turn) {
    const double angle = turn + 2 * std::numbers::pi * i / corners;
    return {x + radius * std::cos(angle), y + radius * std::sin(angle)};
  }
  static bool is_upper(Place p) { return p.y - std::floor(p.y) > p.x - std::floor(p.x); }

  /// Where a leg crosses lines of the grid and diagonals, in order.
  void add_leg(Place a, Place b) {
    struct Stop {
      double at;
      int line;  ///< 0: x is whole, 1: y is, 2: y - x is
      double value;
    };
    std::vector<Stop> stops;
    const auto cut = [&](double from, double to, int line) {
      const double low = std::min(from, to), high = std::max(from, to);
      for (double v = std::floor(low) + 1; v < high; ++v) {
        stops.push_back({(v - from) / (to - from), line, v});
      }
    };
    cut(a.x, b.x, 0);
    cut(a.y, b.y, 1);
    cut(a.y - a.x, b.y - b.x, 2);
    std::sort(stops.begin(), stops.end(), [](const Stop& s, const Stop& t) { return s.at < t.at; });
    SurfacePointId point = add_in_face(a);
    bool is_control = true;
    double last = 0;
    stops.push_back({1, 3, 0});
    for (const Stop& s : stops) {
      const double middle = (last + s.at) / 2;
      const Place m{a.x + middle * (b.x - a.x), a.y + middle * (b.y - a.y)};
      const auto x = static_cast<long>(std::floor(m.x)), y = static_cast<long>(std::floor(m.y));
      const FaceId f = face(x, y, is_upper(m));
      polygons_.add_segment(point, f, is_control);
      is_control = false;
      last = s.at;
      if (s.line == 3) break;
      const Place p{a.x + s.at * (b.x - a.x), a.y + s.at * (b.y - a.y)};
      point = add_on_line(
          f, s.line, s.line == 1 ? p.x - static_cast<double>(x) : p.y - static_cast<double>(y));
    }
  }
  SurfacePointId add_in_face(Place p) {
    const double x = p.x - std::floor(p.x), y = p.y - std::floor(p.y);
    const FaceId f =
        face(static_cast<long>(std::floor(p.x)), static_cast<long>(std::floor(p.y)), is_upper(p));
    // (0, 0), (1, 0), (1, 1): u = x - y, v = y; (0, 0), (1, 1), (0, 1): u = x, v = y - x.
    return is_upper(p) ? polygons_.points.add_in_face(f, x, y - x)
                       : polygons_.points.add_in_face(f, x - y, y);
  }
  /// On the side of a face that lies on a line of that kind; `t` from its lower or left end.
  SurfacePointId add_on_line(FaceId f, int line, double t) {
    const bool upper = f.value() % 2 == 1;
    // Lower: bottom, right, diagonal (downwards). Upper: diagonal (upwards), top (to the left), left (downwards).
    const std::size_t side =
        line == 2 ? (upper ? 0 : 2) : (line == 0 ? (upper ? 2 : 1) : (upper ? 1 : 0));
    const bool is_forward = side == 0 || (side == 1 && !upper);
    constexpr double kGrid = 0x1p50;  // 1 - t is exact
    t = std::clamp(std::round(t * kGrid), 1.0, kGrid - 1) / kGrid;
    const HalfedgeId h = SurfaceMesh::halfedge(f, side);
    const bool is_upward = mesh_->is_upward(h) == is_forward;
    return polygons_.points.add_on_edge(mesh_->edge(h), is_upward ? t : 1 - t);
  }

  long columns_;
  long rows_;
  std::shared_ptr<const SurfaceMesh> mesh_;
  SurfacePolygons polygons_;
};

SurfaceScene rings(std::uint32_t columns, std::uint32_t rows, int count, double radius) {
  TorusScene torus(columns, rows);
  std::mt19937 random(1);
  std::uniform_real_distribution<double> any(0, 1);
  for (int i = 0; i < count; ++i) {
    const double x = columns * any(random);
    const double y = rows * any(random);
    const double r = radius * (0.7 + 0.6 * any(random));
    torus.add_ring(x, y, r, 16, any(random));
  }
  return std::move(torus).scene();
}

Sample measure(const SurfaceScene& scene, SurfaceCounts& counts) {
  const double seconds = least_seconds([&] {
    SurfaceScene copy = scene;
    Context context;
    const double start = cpu_seconds();
    const SurfaceDivision division(std::move(copy), context);
    const double spent = cpu_seconds() - start;
    counts = division.counts();
    return spent;
  });
  return {static_cast<double>(counts.segments + counts.crossings), seconds};
}

/// A mesh that grows with what is drawn on it.
Sample scattered(std::size_t n, SurfaceCounts& counts) {
  const auto side = static_cast<std::uint32_t>(std::sqrt(static_cast<double>(n) / 2));
  return measure(rings(side, side, static_cast<int>(n / 90), 4), counts);
}
/// The same number of triangles and more and more rings: crossings outgrow the rest.
Sample crowded(std::size_t n, SurfaceCounts& counts) {
  return measure(rings(54, 54, static_cast<int>(n / 90), 4), counts);
}
/// Rings in one face each: islands.
Sample tiny(std::size_t n, SurfaceCounts& counts) {
  const auto side = static_cast<std::uint32_t>(std::sqrt(static_cast<double>(n) / 64) + 3);
  return measure(rings(side, side, static_cast<int>(n / 16), 0.05), counts);
}

struct Job {
  const char* name;
  Sample (*run)(std::size_t n, SurfaceCounts& counts);
};
constexpr Job kJobs[] = {{"scattered", scattered}, {"crowded", crowded}, {"tiny", tiny}};

void print(const char* name, const Sample& s, const SurfaceCounts& c) {
  fmt::print("{:10} {:8} triangles {:7} segments {:7} crossings {:7} cells {:9.4f} s\n", name,
             c.triangles, c.segments, c.crossings, c.cells, s.seconds);
}

bool measure(const Job& job, std::size_t most, double slack) {
  std::vector<Sample> samples;
  for (double n = 1000; n <= static_cast<double>(most) * 1.01; n *= std::sqrt(10.0)) {
    SurfaceCounts counts;
    samples.push_back(job.run(static_cast<std::size_t>(n), counts));
    print(job.name, samples.back(), counts);
  }
  const PowerFit fit = fit_power(samples);
  const bool within = fit.slope <= kLimit + slack;
  fmt::print("{:10} time ~ (s + k)^{:.3f}, 95% confidence {:.3f} .. {:.3f}, limit {:.2f}{}\n\n",
             job.name, fit.slope, fit.slope - fit.half_width, fit.slope + fit.half_width, kLimit,
             within ? "" : "  ABOVE THE LIMIT");
  return within;
}

void measure_goals() {
  struct Goal {
    const char* name;
    std::uint32_t columns, rows;
    int rings;
    double radius;
  };
  constexpr Goal kGoals[] = {{"5.9k", 54, 54, 250, 5.9},
                             {"52k", 228, 114, 430, 11},
                             {"100k", 316, 158, 530, 12.5},
                             {"1M", 1000, 500, 300, 24}};
  for (const Goal& g : kGoals) {
    SurfaceCounts counts;
    const Sample s = measure(rings(g.columns, g.rows, g.rings, g.radius), counts);
    print(g.name, s, counts);
  }
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  fmt::print("most memory of all four: {} MB\n", usage.ru_maxrss / 1024);
}

}  // namespace
}  // namespace plumb::bench

int main(int argc, char** argv) {
  CLI::App app{"Growth of divided surfaces"};
  std::size_t most = 100000;
  double slack = 0;
  bool goals = false;
  app.add_option("--most", most, "largest number of segments")
      ->check(CLI::Range(10000U, 10000000U));
  app.add_option("--slack", slack, "added to the limit");
  app.add_flag("--goals", goals, "the published sizes only");
  CLI11_PARSE(app, argc, argv);
  if (goals) {
    plumb::bench::measure_goals();
    return 0;
  }
  bool within = true;
  for (const auto& job : plumb::bench::kJobs) {
    if (!plumb::bench::measure(job, most, slack)) within = false;
  }
  return within ? 0 : 1;
}
