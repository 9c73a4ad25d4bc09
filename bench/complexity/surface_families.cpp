// How dividing surfaces grows, family by family (growth.h says how it is measured): SurfaceDivision
// alone (slicing, cells, labels) against s + k, segments and crossings. With --goals instead:
// scenes of the sizes others publish, once each.
#include <fmt/core.h>
#include <sys/resource.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <random>
#include <string_view>
#include <utility>
#include <vector>

#include "generate/surface_meshes.h"
#include "growth.h"
#include "plumb/surface/exponential_map.h"
#include "plumb/surface/surface.h"
#include "plumb/surface/trace.h"

namespace plumb::bench {
namespace {

/// A torus of columns x rows squares, each cut by its diagonal; and rings drawn on it, from square
/// to square.
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
      polygons_.add_segment(point, f,
                            is_control ? SegmentStart::ControlPoint : SegmentStart::PathPoint);
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
    // Lower: bottom, right, diagonal (downwards). Upper: diagonal (upwards), top (to the left),
    // left (downwards).
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

SurfaceCounts counts_of(const SurfaceScene& scene) {
  Context context;
  return SurfaceDivision(scene, context).counts();
}

Work division_of(SurfaceScene scene) {
  const SurfaceCounts counts = counts_of(scene);
  return {static_cast<double>(counts.segments + counts.crossings),
          [scene = std::move(scene)](Meter& meter) {
            SurfaceScene copy = scene;
            Context context;
            meter.start();
            const SurfaceDivision division(std::move(copy), context);
            meter.stop();
          }};
}

/// A mesh that grows with what is drawn on it.
Work scattered(std::size_t n) {
  const auto side = static_cast<std::uint32_t>(std::sqrt(static_cast<double>(n) / 2));
  return division_of(rings(side, side, static_cast<int>(n / 90), 4));
}
/// The same number of triangles and more and more rings: crossings outgrow the rest.
Work crowded(std::size_t n) { return division_of(rings(54, 54, static_cast<int>(n / 90), 4)); }
/// Rings in one face each: islands.
Work tiny(std::size_t n) {
  const auto side = static_cast<std::uint32_t>(std::sqrt(static_cast<double>(n) / 64) + 3);
  return division_of(rings(side, side, static_cast<int>(n / 16), 0.05));
}

const std::vector<std::size_t> kSizes = sizes_between(1000, 100000);
const std::vector<Family> kFamilies{
    {"scattered",
     "division of a surface, which grows with what is drawn",
     "s + k",
     {1, 1},
     kSizes,
     scattered,
     1.2},
    {"crowded", "the same, more and more on one surface", "s + k", {1, 1}, kSizes, crowded, 1.2},
    {"tiny", "the same, each polygon within one face", "s + k", {1, 1}, kSizes, tiny, 1.2},
};

std::size_t label_entries(const SurfaceDivision& division) {
  std::size_t entries = 0;
  for (std::uint32_t c = 0; c < division.cell_count(); ++c) {
    entries += division.labels(CellId(c)).size();
  }
  return entries;
}

std::size_t peak_megabytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<std::size_t>(usage.ru_maxrss) / 1024;
}

/// A sphere of 20 * 4^depth triangles whose radius swells and shrinks by up to `bumps`: triangles
/// of all shapes.
std::shared_ptr<const SurfaceMesh> bumpy_sphere(int depth, double bumps) {
  const SurfaceMesh sphere = testing::sphere_surface(depth);
  std::vector<Point3> points;
  for (std::size_t i = 0; i < sphere.vertex_count(); ++i) {
    const Point3& p = sphere.point(VertexId(i));
    const double radius =
        1 + bumps * std::sin(5 * p.x + 1) * std::sin(4 * p.y + 2) * std::sin(6 * p.z + 3);
    points.push_back({radius * p.x, radius * p.y, radius * p.z});
  }
  std::vector<SurfaceTriangle> triangles;
  for (std::size_t f = 0; f < sphere.face_count(); ++f) {
    triangles.push_back(sphere.corners(FaceId(f)));
  }
  return std::make_shared<const SurfaceMesh>(std::move(points), std::move(triangles));
}

/// Rings of 16 corners around random places, joined by geodesics.
SurfaceScene traced_rings(std::shared_ptr<const SurfaceMesh> mesh, int count, double radius) {
  SurfacePolygons polygons(*mesh);
  Tracer tracer(*mesh);
  Context context;
  std::mt19937 random(1);
  std::uniform_int_distribution<std::size_t> any_face(0, mesh->face_count() - 1);
  std::uniform_real_distribution<double> any_size(0.7, 1.3);
  constexpr int kCorners = 16;
  for (int i = 0; i < count; ++i) {
    const FaceId face(any_face(random));
    const double size = radius * any_size(random);
    SurfacePointTable& points = polygons.points;
    const SurfacePointId centre = points.add_in_face(face, 0.375, 0.25);
    const ExponentialMap map(points, centre, face, 0);
    std::vector<SurfacePointId> corners;
    for (int k = 0; k < kCorners; ++k) {
      const double angle = 2 * std::numbers::pi * k / kCorners;
      const Point2 offset{size * std::cos(angle), size * std::sin(angle)};
      corners.push_back(map.add(offset, points, context).value());
    }
    add_traced_polygon(tracer, corners, polygons, context);
  }
  return {std::move(mesh), std::move(polygons), {}, FaceId{}};
}

void measure_goal(const char* name, const SurfaceScene& scene) {
  Meter meter;
  Context context;
  SurfaceScene copy = scene;
  meter.start();
  const SurfaceDivision division(std::move(copy), context);
  meter.stop();
  const SurfaceCounts c = division.counts();
  fmt::print(
      "{:12} {:8} triangles {:7} segments {:7} crossings {:7} cells {:4} polygons {:8} label "
      "entries {:9.4f} s, peak so far {} MB\n",
      name, c.triangles, c.segments, c.crossings, c.cells, scene.polygons.size(),
      label_entries(division), meter.take().seconds, peak_megabytes());
}

/// On tori, spheres and spheres with bumps. In the order of their size, so that the peak so far is
/// that of the last one.
void measure_goals() {
  struct Goal {
    const char* name;
    std::uint32_t columns, rows;
    int rings;
    double radius;
  };
  constexpr Goal kGoals[] = {{"5.9k", 54, 54, 250, 5.9}, {"17k x 256", 54, 54, 256, 8.1},
                             {"52k", 228, 114, 430, 11}, {"100k", 316, 158, 530, 12.5},
                             {"1M", 1000, 500, 300, 24}, {"1M, 1000", 1000, 500, 1000, 24}};
  for (const Goal& g : kGoals) {
    measure_goal(g.name, rings(g.columns, g.rows, g.rings, g.radius));
  }
  struct TracedGoal {
    const char* name;
    int depth;
    double bumps;
    int rings;
    double radius;
  };
  constexpr TracedGoal kTraced[] = {
      {"sphere 5k", 4, 0, 256, 0.54},    {"bumpy 5k", 4, 0.3, 256, 0.54},
      {"sphere 82k", 6, 0, 430, 0.25},   {"bumpy 82k", 6, 0.3, 430, 0.25},
      {"sphere 1.3M", 8, 0, 300, 0.128}, {"bumpy 1.3M", 8, 0.3, 300, 0.128}};
  for (const TracedGoal& g : kTraced) {
    measure_goal(g.name, traced_rings(bumpy_sphere(g.depth, g.bumps), g.rings, g.radius));
  }
}

}  // namespace
}  // namespace plumb::bench

int main(int argc, char** argv) {
  if (argc == 2 && std::string_view(argv[1]) == "--goals") {
    plumb::bench::measure_goals();
    return 0;
  }
  return plumb::bench::growth_main("Growth of divided surfaces", plumb::bench::kFamilies, argc,
                                   argv);
}
