// Planes and constructed points of space: interning, construction, side. Paired with the naive
// orient3d expression, by which figures of different machines are scaled. Counters: share of the
// calls each rung decides (filter, narrow, medium, wide; mpz is the rest), each = time of one
// triangle, point or sign.
#include <benchmark/benchmark.h>

#include <array>
#include <cmath>
#include <random>
#include <vector>

#include "naive_predicates.h"
#include "plumb/predicates/plane_signs.h"
#include "plumb/predicates/point3_signs.h"
#include "plumb/predicates/space/point3_table.h"

namespace plumb {
namespace {

using Random = std::mt19937_64;
using Triangle = std::array<InputPointId, 3>;

double uniform(Random& r, double low, double high) {
  return std::uniform_real_distribution<double>(low, high)(r);
}

/// n coordinates' triples of full 53-bit mantissas.
std::vector<Point3> random_points(std::size_t n, double low, double high) {
  Random r(1);
  std::vector<Point3> points(n);
  for (Point3& p : points)
    p = {uniform(r, low, high), uniform(r, low, high), uniform(r, low, high)};
  return points;
}

void per_item(benchmark::State& state, std::size_t items) {
  state.counters["each"] =
      benchmark::Counter(static_cast<double>(items), benchmark::Counter::kIsIterationInvariantRate |
                                                         benchmark::Counter::kInvert);
}

void BM_NaiveOrient3d(benchmark::State& state) {
  const std::vector<Point3> p = random_points(4096, -1, 1);
  for (auto _ : state) {
    int sum = 0;
    for (std::size_t i = 0; i + 4 <= p.size(); i += 4) {
      sum += bench::naive_orient3d(p[i], p[i + 1], p[i + 2], p[i + 3]);
    }
    benchmark::DoNotOptimize(sum);
  }
  per_item(state, p.size() / 4);
}
BENCHMARK(BM_NaiveOrient3d);

// --- interning -----------------------------------------------------------------------------------

struct Mesh {
  std::vector<Point3> points;
  std::vector<Triangle> triangles;
};

/// A height field of n x n vertices; flat: coplanar triangles in n planes.
Mesh height_field(std::uint32_t n, bool flat) {
  Random r(2);
  Mesh mesh;
  for (std::uint32_t y = 0; y < n; ++y) {
    for (std::uint32_t x = 0; x < n; ++x) {
      const double step = 1.0 / n, height = flat ? y * y * step : uniform(r, 0, step);
      mesh.points.push_back({flat ? x + uniform(r, 0, 1) : x * step + uniform(r, 0, step / 4),
                             flat ? y * 1.0 : y * step + uniform(r, 0, step / 4), height});
    }
  }
  for (std::uint32_t y = 0; y + 1 < n; ++y) {
    for (std::uint32_t x = 0; x + 1 < n; ++x) {
      const InputPointId a{y * n + x}, b{y * n + x + 1}, c{y * n + n + x + 1}, d{y * n + n + x};
      mesh.triangles.push_back({a, b, c});
      mesh.triangles.push_back({a, c, d});
    }
  }
  return mesh;
}

void BM_InternTriangles(benchmark::State& state) {
  const Mesh mesh = height_field(static_cast<std::uint32_t>(state.range(0)), state.range(1) != 0);
  std::vector<OrientedPlane> planes(mesh.triangles.size());
  std::size_t distinct = 0;
  for (auto _ : state) {
    PlaneTable table;
    table.add_points(mesh.points);
    table.intern_triangles(mesh.triangles, planes);
    distinct = table.size();
  }
  per_item(state, planes.size());
  state.counters["distinct"] = static_cast<double>(distinct) / static_cast<double>(planes.size());
}
BENCHMARK(BM_InternTriangles)->ArgNames({"n", "flat"})->ArgsProduct({{32, 320}, {0, 1}});

void BM_InternOne(benchmark::State& state) {
  const Mesh mesh = height_field(32, false);
  for (auto _ : state) {
    PlaneTable table;
    table.add_points(mesh.points);
    for (const Triangle& t : mesh.triangles) {
      benchmark::DoNotOptimize(table.intern(t[0], t[1], t[2]));
    }
  }
  per_item(state, mesh.triangles.size());
}
BENCHMARK(BM_InternOne);

// --- points
// ----------------------------------------------------------------------------------------

/// Planes of random triangles, points of consecutive triples, queries against the plane after them.
/// Coordinates in [1, 2) have 53 bits on one grid; those in [-1, 1) spread further.
struct Scene {
  Scene(double low, double high) {
    const std::vector<Point3> corners = random_points(3 * kPlanes, low, high);
    table.add_points(corners);
    for (std::size_t i = 0; i < kPlanes; ++i) {
      planes.push_back(
          table.intern(InputPointId(3 * i), InputPointId(3 * i + 1), InputPointId(3 * i + 2))
              .plane());
    }
    for (std::size_t i = 0; i < kPlanes; ++i) {
      points.push_back(constructed.add(at(i), at(i + 1), at(i + 2)));
    }
  }
  PlaneId at(std::size_t i) const { return planes[i % kPlanes]; }

  static constexpr std::size_t kPlanes = 1024;
  PlaneTable table;
  Point3Table constructed{table};
  std::vector<PlaneId> planes;
  std::vector<SpacePoint> points;
};

Scene scene(const benchmark::State& state) {
  return state.range(0) == 0 ? Scene(1, 2) : Scene(-1, 1);
}

/// What the ladder of side(point i, plane i + 3) takes.
void count_shares(benchmark::State& state, const Point3Table& points,
                  const std::vector<SpacePoint>& ids, const std::vector<PlaneId>& planes) {
  std::array<double, 4> share{};
  for (std::size_t i = 0; i < ids.size(); ++i) {
    const SpacePoint x = ids[i];
    const PlaneId p = planes[(i + 3) % planes.size()];
    const std::array<FilteredSign, 4> rungs = {
        rung::side_filter(points.box(x), points.planes().row(p)),
        rung::side_fixed<exact3::Narrow>(points, x, p),
        rung::side_fixed<exact3::Medium>(points, x, p),
        rung::side_fixed<exact3::Wide>(points, x, p)};
    std::size_t k = 0;
    while (k < 4 && !is_decided(rungs[k])) ++k;
    if (k < 4) ++share[k];
  }
  constexpr std::array<const char*, 4> kNames = {"filter", "narrow", "medium", "wide"};
  for (std::size_t k = 0; k < 4; ++k) {
    state.counters[kNames[k]] = share[k] / static_cast<double>(ids.size());
  }
}

void BM_AddThreePlanePoint(benchmark::State& state) {
  const Scene s(1, 2);
  for (auto _ : state) {
    Point3Table points(s.table);
    points.reserve(Scene::kPlanes);
    for (std::size_t i = 0; i < Scene::kPlanes; ++i) {
      benchmark::DoNotOptimize(points.add(s.at(i), s.at(i + 1), s.at(i + 2)));
    }
  }
  per_item(state, Scene::kPlanes);
}
BENCHMARK(BM_AddThreePlanePoint);

void BM_AddLinePlanePoint(benchmark::State& state) {
  const Scene s(1, 2);
  for (auto _ : state) {
    Point3Table points(s.table);
    points.reserve(Scene::kPlanes);
    for (std::size_t i = 0; i < Scene::kPlanes; ++i) {
      benchmark::DoNotOptimize(points.add(InputPointId(i), InputPointId(i + 7), s.at(i + 9)));
    }
  }
  per_item(state, Scene::kPlanes);
}
BENCHMARK(BM_AddLinePlanePoint);

/// The ladder on cached points.
void BM_SideOfCachedPoint(benchmark::State& state) {
  const Scene s = scene(state);
  for (auto _ : state) {
    int sum = 0;
    for (std::size_t i = 0; i < Scene::kPlanes; ++i) {
      sum += static_cast<int>(side(s.constructed, s.points[i], s.at(i + 3)));
    }
    benchmark::DoNotOptimize(sum);
  }
  per_item(state, Scene::kPlanes);
  count_shares(state, s.constructed, s.points, s.planes);
}
BENCHMARK(BM_SideOfCachedPoint)->ArgName("spread")->Arg(0)->Arg(1);

/// One of the planes known through the point.
void BM_SideByIdentity(benchmark::State& state) {
  const Scene s(1, 2);
  for (auto _ : state) {
    int sum = 0;
    for (std::size_t i = 0; i < Scene::kPlanes; ++i) {
      sum += static_cast<int>(side(s.constructed, s.points[i], s.at(i + 1)));
    }
    benchmark::DoNotOptimize(sum);
  }
  per_item(state, Scene::kPlanes);
}
BENCHMARK(BM_SideByIdentity);

template <class Side>
void run_exact(benchmark::State& state, const Scene& s, const Side& side) {
  for (auto _ : state) {
    int sum = 0;
    for (std::size_t i = 0; i < Scene::kPlanes; ++i) sum += side(s.points[i], s.at(i + 3));
    benchmark::DoNotOptimize(sum);
  }
  per_item(state, Scene::kPlanes);
}

/// Twelve input points -> four planes -> point -> side, all in integers; nothing cached.
void BM_PlanesPointSideMedium(benchmark::State& state) {
  const Scene s(1, 2);
  run_exact(state, s, [&](SpacePoint x, PlaneId p) {
    return static_cast<int>(rung::side_fixed<exact3::Medium>(s.constructed, x, p));
  });
}
BENCHMARK(BM_PlanesPointSideMedium);

void BM_PlanesPointSideWide(benchmark::State& state) {
  const Scene s(-1, 1);
  run_exact(state, s, [&](SpacePoint x, PlaneId p) {
    return static_cast<int>(rung::side_fixed<exact3::Wide>(s.constructed, x, p));
  });
}
BENCHMARK(BM_PlanesPointSideWide);

void BM_PlanesPointSideMpz(benchmark::State& state) {
  const Scene s(1, 2);
  run_exact(state, s, [&](SpacePoint x, PlaneId p) {
    return static_cast<int>(rung::side_big(s.constructed, x, p));
  });
}
BENCHMARK(BM_PlanesPointSideMpz);

/// Exactly degenerate: all planes hold one point. Small integers, then 40-bit coordinates.
void BM_FourPlanesThroughOnePoint(benchmark::State& state) {
  const int bits = static_cast<int>(state.range(0));
  Random r(3);
  PlaneTable table;
  const InputPointId centre = table.add_point({3, 5, 7});
  std::vector<PlaneId> planes;
  const auto coordinate = [&] { return std::floor(uniform(r, -1, 1) * std::ldexp(1.0, bits)); };
  while (planes.size() < 256) {
    const InputPointId q = table.add_point({coordinate(), coordinate(), coordinate()});
    const InputPointId p = table.add_point({coordinate(), coordinate(), coordinate()});
    if (const OrientedPlane o = table.intern(centre, q, p); o.is_valid())
      planes.push_back(o.plane());
  }
  Point3Table points(table);
  std::vector<SpacePoint> ids;
  for (std::size_t i = 0; i < 256; ++i) {
    ids.push_back(points.add(planes[i], planes[(i + 1) % 256], planes[(i + 2) % 256]));
  }
  for (auto _ : state) {
    int sum = 0;
    for (std::size_t i = 0; i < 256; ++i) {
      sum += static_cast<int>(side(points, ids[i], planes[(i + 3) % 256]));
    }
    benchmark::DoNotOptimize(sum);
  }
  per_item(state, 256);
  count_shares(state, points, ids, planes);
}
BENCHMARK(BM_FourPlanesThroughOnePoint)->ArgName("bits")->Arg(10)->Arg(40);

/// Points on one plane of the frame against ordinary planes: two asks of an exact rung at most.
void BM_SideOfFramePoint(benchmark::State& state) {
  Scene s = scene(state);
  const std::array<PlaneId, 6> frame = s.table.intern_frame();
  std::vector<SpacePoint> ids;
  for (std::size_t i = 0; i < Scene::kPlanes; ++i) {
    ids.push_back(s.constructed.add(s.at(i), s.at(i + 1), frame[i % 6]));
  }
  for (auto _ : state) {
    int sum = 0;
    for (std::size_t i = 0; i < Scene::kPlanes; ++i) {
      sum += static_cast<int>(side(s.constructed, ids[i], s.at(i + 3)));
    }
    benchmark::DoNotOptimize(sum);
  }
  per_item(state, Scene::kPlanes);
  count_shares(state, s.constructed, ids, s.planes);
}
BENCHMARK(BM_SideOfFramePoint)->ArgName("spread")->Arg(0)->Arg(1);

/// Ordinary points against a plane of the frame.
void BM_SideOnFramePlane(benchmark::State& state) {
  Scene s(1, 2);
  const std::array<PlaneId, 6> frame = s.table.intern_frame();
  for (auto _ : state) {
    int sum = 0;
    for (std::size_t i = 0; i < Scene::kPlanes; ++i) {
      sum += static_cast<int>(side(s.constructed, s.points[i], frame[i % 6]));
    }
    benchmark::DoNotOptimize(sum);
  }
  per_item(state, Scene::kPlanes);
}
BENCHMARK(BM_SideOnFramePlane);

// --- lines ---------------------------------------------------------------------------------------

void BM_LineFingerprint(benchmark::State& state) {
  const Scene s(1, 2);
  for (auto _ : state) {
    Fingerprint sum = 0;
    for (std::size_t i = 0; i < Scene::kPlanes; ++i) {
      sum += line_fingerprint(s.table, s.at(i), s.at(i + 1));
    }
    benchmark::DoNotOptimize(sum);
  }
  per_item(state, Scene::kPlanes);
}
BENCHMARK(BM_LineFingerprint);

/// Three planes of a pencil: through two common corners.
void BM_HoldsLine(benchmark::State& state) {
  const std::vector<Point3> corners = random_points(3 * Scene::kPlanes, 1, 2);
  PlaneTable table;
  table.add_points(corners);
  std::vector<PlaneId> planes;
  for (std::size_t i = 0; i < Scene::kPlanes; ++i) {
    const std::size_t line = i / 3 * 3;
    planes.push_back(
        table.intern(InputPointId(line), InputPointId(line + 1), InputPointId(Scene::kPlanes + i))
            .plane());
  }
  for (auto _ : state) {
    int sum = 0;
    for (std::size_t i = 0; i + 2 < planes.size(); i += 3) {
      sum += holds_line(table, planes[i], planes[i + 1], planes[i + 2]) ? 1 : 0;
    }
    benchmark::DoNotOptimize(sum);
  }
  per_item(state, planes.size() / 3);
}
BENCHMARK(BM_HoldsLine);

// --- tables
// ----------------------------------------------------------------------------------------

void BM_CopyPlaneTable(benchmark::State& state) {
  const Mesh mesh = height_field(320, false);
  std::vector<OrientedPlane> planes(mesh.triangles.size());
  PlaneTable table;
  table.add_points(mesh.points);
  table.intern_triangles(mesh.triangles, planes);
  for (auto _ : state) {
    PlaneTable other(table);
    benchmark::DoNotOptimize(other.size());
  }
  per_item(state, planes.size());
}
BENCHMARK(BM_CopyPlaneTable);

/// The same mesh moved (0) or again (1: all planes equal).
void BM_MergePlaneTables(benchmark::State& state) {
  Mesh mesh = height_field(320, false);
  std::vector<OrientedPlane> planes(mesh.triangles.size());
  PlaneTable table, other;
  table.add_points(mesh.points);
  table.intern_triangles(mesh.triangles, planes);
  if (state.range(0) == 0) {
    for (Point3& p : mesh.points) p.z *= 1.5;
  }
  other.add_points(mesh.points);
  other.intern_triangles(mesh.triangles, planes);
  for (auto _ : state) {
    state.PauseTiming();
    PlaneTable both(table);
    state.ResumeTiming();
    benchmark::DoNotOptimize(both.merge(other));
  }
  per_item(state, planes.size());
}
BENCHMARK(BM_MergePlaneTables)->ArgName("equal")->Arg(0)->Arg(1);

}  // namespace
}  // namespace plumb
