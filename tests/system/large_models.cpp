#include "system/large_models.h"

#include <cmath>
#include <cstdint>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "generate/mesh_solid.h"
#include "generate/meshes.h"
#include "generate/plane_families.h"
#include "generate/sphere_families.h"
#include "plumb/convex/convexity.h"
#include "plumb/convex/plane_convexity.h"
#include "plumb/convex/plane_minkowski.h"
#include "plumb/convex/triangulation.h"
#include "plumb/convex/voronoi.h"
#include "plumb/csg/evaluate.h"
#include "plumb/io/csg_reader.h"
#include "plumb/io/layer_io.h"
#include "plumb/io/plane_io.h"
#include "plumb/model/distance.h"
#include "plumb/model/extrude.h"
#include "plumb/model/hull.h"
#include "plumb/model/parts.h"
#include "plumb/model/slice.h"
#include "plumb/model/transform.h"
#include "plumb/plane/layer.h"
#include "plumb/plane/layer_dissolve.h"
#include "plumb/plane/layer_overlay.h"
#include "plumb/plane/layer_simplify.h"
#include "plumb/plane/plane_offset.h"
#include "plumb/plane/plane_rounding.h"
#include "plumb/plane/plane_simplify.h"
#include "plumb/space/repair_mesh.h"
#include "plumb/space/valid_mesh.h"
#include "plumb/space/weld_points.h"
#include "plumb/testing/dice.h"

namespace plumb::testing {
namespace {

/// Returns a number between 0 and 1.
double part(Dice& dice) { return std::ldexp(static_cast<double>(dice.below(1U << 30U)), -30); }

/// What all measurements need: the size, and who measures.
class LargeModels {
 public:
  LargeModels(double size, const Measure& measured) : size_(size), measured_(measured) {}

  void offsets() const;
  void layers() const;
  void mending() const;
  void models() const;
  void trees() const;
  void queries() const;

 private:
  std::size_t sized(double n) const { return static_cast<std::size_t>(n * size_); }
  /// The depth of a sphere whose number of triangles is near 1,280 or 5,120 times the size.
  int depth(int standard) const {
    return standard + static_cast<int>(std::lround(std::log(size_) / std::log(4)));
  }
  Nef3 ball(int standard_depth, Point3 centre) const {
    return solid(icosphere_mesh(depth(standard_depth), 1, centre));
  }
  Nef2 star(std::size_t corners, std::uint64_t seed) const {
    return Nef2::polygon(star_polygon(corners, seed));
  }
  Layer octagon_layer(std::size_t count, std::uint64_t seed) const;

  /// Measures an operation whose result is dropped.
  template <class Run>
  void measure(const std::string& name, Run run) const {
    measured_(name, [&](Context& context) { (void)run(context); });
  }

  double size_;
  const Measure& measured_;
};

// ---------------------------------------------------------------- plane

void LargeModels::offsets() const {
  const Nef2 set = star(sized(2'000), 1);
  const OffsetOptions round{.join = OffsetJoin::Round, .chord_error = 0, .circle_segments = 16};
  measure("plane: offset outwards", [&](Context& c) { return offset(set, 1e-3, round, c); });
  measure("plane: offset inwards",
          [&](Context& c) { return offset(set, -1e-3, {.join = OffsetJoin::Mitre}, c); });
  const Nef2 tool = Nef2::polygon(std::vector<Point2>{{0, 0}, {0.01, 0}, {0, 0.01}});
  measure("plane: minkowski_sum", [&](Context& c) { return minkowski_sum(set, tool, c); });
  const Nef2 both = star(sized(10'000), 1) ^ star(sized(10'000), 2);
  measure("plane: round_to_doubles", [&](Context& c) { return round_to_doubles(both, c); });
  measure("plane: round_to_grid",
          [&](Context& c) { return round_to_grid(both, Rational(1, 1'000), c); });
  measure("plane: simplify_borders",
          [&](Context& c) { return simplify_borders(both, {.tolerance = 0.05}, c); });
  measure("plane: parts", [&](Context& c) { return both.parts(c); });
  measure("plane: convexity", [&](Context& c) { return convexity_of_set(both, c); });
  measure("plane: transformed",
          [&](Context& c) { return both.transformed({.xy = 1, .y0 = Rational(1, 3)}, c); });
  PointTable2 sites;
  Dice dice(1);
  for (std::size_t i = 0; i < sized(10'000); ++i) sites.push_back({part(dice), part(dice)});
  measure("plane: delaunay", [&](Context& c) { return delaunay(sites, c); });
  measure("plane: delaunay of a set", [&](Context& c) { return delaunay(both, c); });
  measure("plane: voronoi_cells", [&](Context& c) {
    return voronoi_cells(sites, {0, 0}, {1, 1}, c);
  });
  measure("plane: distance",
          [&](Context& c) { return distance(set, set.transformed({.x0 = 5}), c); });
}

Layer LargeModels::octagon_layer(std::size_t count, std::uint64_t seed) const {
  Layer layer;
  for (const PlanePolygon& polygon : octagons(count, seed)) {
    for (const Point2 p : polygon) {
      layer.ring_corners.push_back(static_cast<std::uint32_t>(layer.points.size()));
      layer.points.push_back(p);
    }
    layer.end_ring();
    layer.end_polygon();
    layer.end_feature("", R"({"name": "octagon"})");
  }
  return layer;
}

void LargeModels::layers() const {
  const Layer layer = octagon_layer(sized(1'250), 1), other = octagon_layer(sized(1'250), 2);
  Layer coverage;
  measure("check_layer", [&](Context& c) { return check_layer(layer, {}, c); });
  measure("repair_layer", [&](Context& c) {
    coverage = repair_layer(layer, {.gaps_below = 1e5}, c).layer;
    return 0;
  });
  std::vector<std::uint32_t> group(layer.feature_count());
  for (std::size_t f = 0; f < group.size(); ++f) group[f] = static_cast<std::uint32_t>(f % 7);
  measure("dissolve_layer", [&](Context& c) { return dissolve_layer(layer, group, 7, c); });
  measure("overlay_layers",
          [&](Context& c) { return overlay_layers(layer, other, {.with_areas = true}, c); });
  measure("simplify_layer",
          [&](Context& c) { return simplify_layer(coverage, {.tolerance = 1e6}, c); });
  std::ostringstream geojson, topojson;
  measure("write a layer as GeoJSON", [&](Context& c) {
    write_layer_geojson(geojson, coverage, c);
    return 0;
  });
  measure("write a layer as TopoJSON", [&](Context& c) {
    write_layer_topojson(topojson, coverage, c);
    return 0;
  });
  measure("read a layer, GeoJSON", [&](Context& c) { return read_layer(geojson.str(), {}, c); });
  measure("read a layer, TopoJSON", [&](Context& c) { return read_layer(topojson.str(), {}, c); });
}

// ---------------------------------------------------------------- space

void LargeModels::mending() const {
  const PolygonMesh sphere = icosphere_mesh(depth(4), 1, {0, 0, 0});
  const Nef3 cut = solid(sphere) - ball(4, {0.5, 0.25, 0.125});
  measure("valid_mesh", [&](Context& c) { return valid_mesh(cut, {}, CoordinateType::Double, c); });
  measure("valid_mesh, floats",
          [&](Context& c) { return valid_mesh(cut, {}, CoordinateType::Float, c); });
  PolygonMesh twice = joined(sphere, sphere);
  measure("repair_mesh", [&](Context& c) {
    return repair_mesh(twice, {.weld = 1e-6, .doubled = DoubledFaces::Drop, .reorient = true}, c);
  });
  PolygonMesh open = sphere;
  open.corners.resize(open.corners.size() / 2 / 3 * 3);
  open.face_begin.resize(open.corners.size() / 3 + 1);
  measure("repair_mesh, a hole", [&](Context& c) {
    return repair_mesh(open, {.fill_holes = 1'000'000, .fill_holes_below = 100}, c);
  });
  PolygonMesh near = joined(sphere, moved(sphere, {1e-9, 0, 0}));
  measure("weld_points", [&](Context& c) { return weld_points(near, 1e-6, c); });
  measure("triangulated", [&](Context& c) {
    return triangulated(prism_mesh(star_polygon(sized(5'000), 1), 0, 1), c);
  });
  measure("convexity of a mesh", [&](Context& c) { return convexity_of_mesh(sphere, c); });
}

void LargeModels::models() const {
  const Nef2 outline = star(sized(1'250), 1);
  measure("linear_extrusion", [&](Context& c) { return linear_extrusion(outline, {}, c); });
  measure("linear_extrusion, twisted",
          [&](Context& c) { return linear_extrusion(outline, {.twist = 30, .slices = 4}, c); });
  const Nef2 wheel = star(sized(100), 1).transformed({.x0 = 3});
  measure("rotational_extrusion",
          [&](Context& c) { return rotational_extrusion(wheel, 360, 24, c); });
  const Nef3 a = ball(4, {0, 0, 0}), b = ball(4, {3, 0, 0});
  const std::vector<Nef3> both{a, b};
  measure("convex_hull of sets", [&](Context& c) { return convex_hull(both, c); });
  const std::vector<Point3> points = icosphere_mesh(depth(4), 1, {0, 0, 0}).points;
  measure("hull_mesh", [&](Context& c) { return hull_mesh(points, c); });
  measure("slices", [&](Context& c) {
    return slices(a, std::vector<Rational>{0, Rational(1, 3), Rational(1, 2)}, c);
  });
  measure("shadow", [&](Context& c) { return shadow(ball(2, {0, 0, 0}), c); });
  measure("components", [&](Context& c) { return components(a + b, c); });
  measure("space: transformed", [&](Context& c) {
    return a.transformed(rotation({1, 2, 3}, 40), c);
  });
}

void LargeModels::trees() const {
  std::string text = "difference() {\nunion() {\n";
  for (std::size_t i = 0; i < sized(200); ++i) {
    text += "multmatrix([[1, 0, 0, " + std::to_string(3 * i) +
            "], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]) sphere($fn = 12, r = 2);\n";
  }
  text += "}\ncube(size = [1000, 1, 1], center = false);\n}\n";
  CsgRead model;
  measure("read a model", [&](Context& c) {
    model = read_csg("model.csg", text, {}, c);
    return 0;
  });
  measure("evaluate a model", [&](Context& c) { return evaluate(model.tree, c); });
}

void LargeModels::queries() const {
  const Nef3 a = ball(4, {0, 0, 0}), b = ball(4, {3, 0, 0});
  measure("space: distance", [&](Context& c) { return distance(a, b, c); });
  measure("space: locate", [&](Context& c) {
    return a.locate(RationalPoint3{Rational(1, 3), 0, 0}, c);
  });
  measure("space: shoot", [&](Context& c) { return b.shoot({0, 0, 0}, {1, 0, 0}, c); });
  std::vector<Point3> points;
  Dice dice(1);
  for (std::size_t i = 0; i < sized(10'000); ++i) {
    points.push_back({part(dice), part(dice), part(dice)});
  }
  measure("space: contains many", [&](Context& c) {
    std::vector<Mark> marked(points.size());
    a.contains(points, marked, c);
    return 0;
  });
  measure("space: is_subset_of", [&](Context& c) { return a.is_subset_of(a + b, c); });
  measure("space: complement", [&](Context& c) { return a.complement(c); });
  measure("space: boundary", [&](Context& c) { return a.boundary(c); });
  measure("space: convexity", [&](Context& c) { return convexity_of_set(a, c); });
  const NefSphere patches = scattered_triangles(sized(2'500));
  const NefSphere band = crown(100, 0, -0.1, 0.3);
  measure("sphere: many parts", [&](Context& c) { return boolean_op(patches, band, kUnion, c); });
  const Nef2 set = star(sized(10'000), 1);
  measure("plane: locate", [&](Context& c) { return set.locate(Point2{0.1, 0.2}, c); });
  measure("plane: shoot", [&](Context& c) { return set.shoot({0, 0}, {1, 2}, c); });
  measure("plane: is_subset_of", [&](Context& c) { return set.is_subset_of(set, c); });
}

}  // namespace

void measure_large_models(double size, const std::string& room, const Measure& measured) {
  const LargeModels large(size, measured);
  const std::pair<const char*, void (LargeModels::*)() const> rooms[] = {
      {"offsets", &LargeModels::offsets}, {"layers", &LargeModels::layers},
      {"mending", &LargeModels::mending}, {"models", &LargeModels::models},
      {"trees", &LargeModels::trees},     {"queries", &LargeModels::queries}};
  for (const auto& [name, measure_room] : rooms) {
    if (room.empty() || room == name) (large.*measure_room)();
  }
}

}  // namespace plumb::testing
