#include "system/large_operations.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "generate/meshes.h"
#include "generate/plane_families.h"
#include "generate/sphere_families.h"
#include "generate/surface_scenes.h"
#include "plumb/convex/decompose.h"
#include "plumb/convex/minkowski.h"
#include "plumb/convex/plane_partition.h"
#include "plumb/io/map_io.h"
#include "plumb/io/mesh_io.h"
#include "plumb/io/nef3_reader.h"
#include "plumb/io/nef3_writer.h"
#include "plumb/io/plane_io.h"
#include "plumb/io/svg_reader.h"
#include "plumb/plane/arrangement.h"
#include "plumb/plane/map_overlay.h"
#include "plumb/plane/plane_audit.h"
#include "plumb/plane/plane_measure.h"
#include "plumb/space/canonical.h"
#include "plumb/space/rounded_mesh.h"
#include "plumb/space/space_audit.h"
#include "plumb/space/space_measure.h"
#include "plumb/space/to_mesh.h"
#include "plumb/sphere/nef_sphere.h"
#include "plumb/surface/surface_homology.h"
#include "plumb/surface/trace.h"
#include "plumb/surface/triangulation.h"
#include "plumb/testing/map_families.h"

namespace plumb::testing {
namespace {

double size_factor = 1;
Measure measure;

std::size_t sized(double n) { return static_cast<std::size_t>(n * size_factor); }

template <class Write>
std::string written(Write write) {
  std::ostringstream out;
  write(out);
  return out.str();
}

void measure_reader(const std::string& text, const std::string& name,
                    const std::function<void(const std::string&, Context&)>& read) {
  measure("read " + name + ", " + std::to_string(text.size() / 1000) + " kB",
          [&](Context& context) { read(text, context); });
}

// ---------------------------------------------------------------- plane

Nef2 star(std::size_t corners, std::uint64_t seed, Context& context) {
  PointTable2 points;
  std::vector<std::uint32_t> chain;
  for (const Point2 p : star_polygon(corners, seed)) {
    chain.push_back(static_cast<std::uint32_t>(points.size()));
    points.push_back(p);
  }
  const std::vector<std::uint32_t> begin{0, static_cast<std::uint32_t>(chain.size())};
  return Nef2::polygons(points, chain, begin, WindingRule::NonZero, Boundary::Closed, context);
}

void measure_plane() {
  const std::size_t n = sized(10'000);
  Nef2 a, b, c;
  measure("polygons", [&](Context& context) { a = star(n, 1, context); });
  Context unwatched;
  b = star(n, 2, unwatched);
  measure("plane: combine", [&](Context& context) { c = boolean_op(a, b, kUnion, context); });
  measure("plane: audit",
          [&](Context& context) { (void)audit(c.complex(), AuditForm::Minimal, context); });
  measure("plane: area", [&](Context& context) { (void)marked_area(c.complex(), context); });
  measure("plane: decompose",
          [&](Context& context) { (void)decompose(star(n / 5, 1, context), {}, context); });
  measure("arrange", [&](Context& context) {
    PointTable2 points;
    std::vector<SweepSegment> segments;
    for (const auto& [from, to] : long_segments(sized(100))) {
      const auto first = static_cast<std::uint32_t>(points.size());
      points.push_back(from);
      points.push_back(to);
      segments.push_back({first, first + 1});
    }
    (void)arrange(std::move(points), segments, context);
  });
  for (const PlaneFormat format : {PlaneFormat::Wkt, PlaneFormat::GeoJson, PlaneFormat::Nef2}) {
    measure("write a set of the plane", [&](Context& context) {
      std::ostream nowhere(nullptr);
      PlaneText(c, format, context).write(nowhere, context);
    });
    const std::string text =
        written([&](std::ostream& out) { PlaneText(c, format, unwatched).write(out, unwatched); });
    measure_reader(text, "plane", [format](const std::string& t, Context& context) {
      (void)read_plane_set(t, format, {}, context);
    });
  }
}

void measure_maps() {
  const auto side = static_cast<std::uint32_t>(60 * std::sqrt(size_factor));
  const Map map = to_map(jittered_triangles(side, 1)), other = to_map(hexagons(side, 2));
  MapReport report, second;
  measure("check_map", [&](Context& context) { report = check_map(map, {}, context); });
  measure("check_map", [&](Context& context) { second = check_map(other, {}, context); });
  measure("overlay_maps", [&](Context& context) { (void)overlay_maps(report, second, context); });
  measure_reader(written([&](std::ostream& out) { write_map(out, map); }), "map",
                 [](const std::string& t, Context& context) { (void)read_map(t, {}, context); });
  std::string path = "<svg viewBox='0 0 9 9'><path d='M0 0";
  for (std::size_t i = 0; i < sized(100'000); ++i) path += "l1 .5-1-.5c1 2 3 4 5 6";
  measure_reader(path + "z'/></svg>", "SVG", [](const std::string& t, Context& context) {
    (void)read_svg(t, {}, 0.5, context);
  });
}

// ---------------------------------------------------------------- sphere

void measure_sphere() {
  const std::size_t n = 2 * sized(5'000);
  const NefSphere a = crown(n, 0, -0.1, 0.3), b = crown(n, 0.5, -0.1, 0.3);
  measure("sphere: combine", [&](Context& context) { (void)boolean_op(a, b, kUnion, context); });
  std::vector<NefSphere> patches;
  for (std::size_t i = 0; i < sized(200); ++i) {
    patches.push_back(
        crown(12, static_cast<double>(i) / 200, -0.1, 0.3 + 1e-4 * static_cast<double>(i)));
  }
  measure("sphere: union_of", [&](Context& context) { (void)union_of(patches, context); });
}

// ---------------------------------------------------------------- space

void measure_space() {
  const int depth = 4 + static_cast<int>(std::lround(std::log(size_factor) / std::log(4)));
  const PolygonMesh mesh = icosphere_mesh(depth, 1, {0, 0, 0});
  const PolygonMesh other = moved(icosphere_mesh(depth, 1, {0, 0, 0}), {0.5, 0.25, 0.125});
  Nef3 a, b, c;
  PolygonMesh extracted;
  measure("mesh to set", [&](Context& context) {
    a = Nef3::from_mesh(mesh, {.rule = WindingRule::NonZero}, context);
  });
  Context unwatched;
  b = Nef3::from_mesh(other, {.rule = WindingRule::NonZero}, unwatched);
  measure("space: combine", [&](Context& context) { c = boolean_op(a, b, kDifference, context); });
  measure("space: with a plane", [&](Context& context) {
    (void)boolean_op(a, {1, 2, 3, 0}, Section::ClosedHalfSpace, kIntersection, context);
  });
  measure("space: crossing mesh", [&](Context& context) {
    (void)Nef3::from_mesh(joined(mesh, other), {.rule = WindingRule::NonZero}, context);
  });
  measure("space: from_complex",
          [&](Context& context) { (void)Nef3::from_complex(c.complex(), context); });
  measure("space: audit",
          [&](Context& context) { (void)audit(c.complex(), AuditForm::Minimal, context); });
  measure("mesh_of_complex", [&](Context& context) {
    extracted = mesh_of_complex(c.complex(), {.keeps_exact = true}, context).mesh;
  });
  measure("soup_of_complex",
          [&](Context& context) { (void)soup_of_complex(c.complex(), {}, context); });
  measure("check_rounding",
          [&](Context& context) { (void)check_rounding(extracted, 10, context); });
  measure("canonical", [&](Context& context) { (void)canonical(c, context); });
  measure("volume", [&](Context& context) { (void)marked_volume(c.complex(), context); });
  measure("centroid", [&](Context& context) { (void)marked_centroid(c.complex(), context); });
  measure("area", [&](Context& context) { (void)surface_area(c.complex(), context); });
  for (const MeshFormat format :
       {MeshFormat::Off, MeshFormat::ExactOff, MeshFormat::Obj, MeshFormat::Stl,
        MeshFormat::StlBinary, MeshFormat::Ply, MeshFormat::PlyText}) {
    measure_reader(written([&](std::ostream& out) { write_mesh(out, extracted, format); }), "mesh",
                   [format](const std::string& t, Context& context) {
                     (void)read_mesh(t, format, {}, context);
                   });
  }
  measure("write .nef", [&](Context& context) {
    std::ostream nowhere(nullptr);
    write_nef3(nowhere, c.complex(), context);
  });
  measure_reader(written([&](std::ostream& out) { write_nef3(out, c.complex()); }), ".nef",
                 [](const std::string& t, Context& context) { (void)read_nef3(t, {}, context); });
}

void measure_convex() {
  Context unwatched;
  const auto set = [&](int depth, double radius) {
    return Nef3::from_mesh(icosphere_mesh(depth, radius, {0, 0, 0}), {.rule = WindingRule::NonZero},
                           unwatched);
  };
  const int more = size_factor >= 4 ? 1 : 0;
  const Nef3 shell =
      set(1 + static_cast<int>(std::lround(std::log(size_factor) / std::log(4))), 1) - set(1, 0.5);
  for (const DecomposeMethod method : {DecomposeMethod::Cuts, DecomposeMethod::Walls}) {
    measure("decompose", [&](Context& context) { (void)decompose(shell, {method}, context); });
  }
  const Nef3 facets = set(2 + more, 1).boundary();
  measure("decompose, facets", [&](Context& context) { (void)decompose(facets, {}, context); });
  const Nef3 ball = set(3 + more, 1), small = set(2 + more, 0.25);
  measure("minkowski_sum, convex",
          [&](Context& context) { (void)minkowski_sum(ball, small, context); });
  if (size_factor < 4) return;  // many Booleans
  const Nef3 bent = set(more, 1) - set(0, 0.5);
  measure("minkowski_sum",
          [&](Context& context) { (void)minkowski_sum(bent, set(0, 0.25), context); });
}

void measure_surface() {
  const auto around = static_cast<std::uint32_t>(60 * std::sqrt(size_factor));
  const MeshPointer mesh = torus_mesh(2 * around, around);
  SurfaceScene scene{mesh, SurfacePolygons(*mesh), {}, {}, {}};
  Tracer tracer(*mesh);
  measure("trace", [&](Context& context) {
    for (std::uint32_t k = 0; k < 20; ++k) {
      std::vector<SurfacePointId> control;
      for (const std::uint32_t i : {3 + k, 7 + 5 * k, 40 + k}) {
        control.push_back(scene.polygons.points.add_vertex(VertexId(i * around + i % around)));
      }
      (void)add_traced_polygon(tracer, control, scene.polygons, context);
    }
  });
  measure("divide", [&](Context& context) {
    const SurfaceDivision division(scene, context);
    (void)division.evaluate(parse_set_expression("A + B"), WindingRule::EvenOdd, context);
  });
  const SurfaceDivision division = [&] {
    Context unwatched;
    return SurfaceDivision(scene, unwatched);
  }();
  measure("triangulate_surface",
          [&](Context& context) { (void)triangulate_surface(division, context); });
  measure("homology", [&](Context& context) {
    (void)SurfaceHomology(*mesh, context).class_of(scene.polygons, 0, context);
  });
}

}  // namespace

void measure_large_operations(double size, const std::string& room, const Measure& measured) {
  size_factor = size;
  measure = measured;
  const std::pair<const char*, void (*)()> rooms[] = {
      {"plane", measure_plane}, {"maps", measure_maps},     {"sphere", measure_sphere},
      {"space", measure_space}, {"convex", measure_convex}, {"surface", measure_surface}};
  for (const auto& [name, measure_room] : rooms) {
    if (room.empty() || room == name) measure_room();
  }
}

}  // namespace plumb::testing
