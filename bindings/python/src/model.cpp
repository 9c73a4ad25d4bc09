// What makes whole models: primitives, hulls, extrusions, slices, maps, offsets and sums in the
// plane, and models of OpenSCAD. The methods belong to plumb.Solid and plumb.PlaneSet.
// Tests: tests/test_model.py.
#include <array>
#include <limits>

#include "plane_traits.h"
#include "plumb/convex/plane_minkowski.h"
#include "plumb/convex/triangulation.h"
#include "plumb/csg/evaluate.h"
#include "plumb/io/csg_reader.h"
#include "plumb/model/extrude.h"
#include "plumb/model/hull.h"
#include "plumb/model/parts.h"
#include "plumb/model/primitives.h"
#include "plumb/model/slice.h"
#include "plumb/model/solid_offset.h"
#include "plumb/model/transform.h"
#include "plumb/plane/plane_arrays.h"
#include "plumb/plane/plane_offset.h"
#include "plumb/plane/plane_rounding.h"
#include "plumb/plane/plane_simplify.h"
#include "simplify_report.h"

namespace plumb::python {
namespace {

Placement placement_of(bool centred) { return centred ? Placement::Centred : Placement::Corner; }

// --- solids -----------------------------------------------------------------------------------

Nef3 sphere(Context& context, double radius, std::uint32_t chords) {
  return Nef3::from_mesh(sphere_mesh(radius, chords, context), {}, context);
}

Nef3 cylinder(Context& context, double height, double bottom_radius,
              const std::optional<double>& top_radius, std::uint32_t chords, bool centred) {
  const PolygonMesh mesh = cylinder_mesh(height, bottom_radius, top_radius.value_or(bottom_radius),
                                         chords, placement_of(centred), context);
  return Nef3::from_mesh(mesh, {}, context);
}

Nef3 torus(Context& context, double radius, double tube_radius, std::uint32_t chords,
           std::uint32_t tube_chords) {
  return Nef3::from_mesh(torus_mesh(radius, tube_radius, chords, tube_chords, context), {},
                         context);
}

Nef3 hull_of_points(Context& context, const Coordinates3& points) {
  std::vector<Point3> list;
  const std::span<const double> xyz = points.span();
  list.reserve(xyz.size() / 3);
  for (std::size_t i = 0; i < xyz.size(); i += 3) list.push_back({xyz[i], xyz[i + 1], xyz[i + 2]});
  return convex_hull(std::span<const Point3>(list), context);
}

using Corner = std::tuple<Rational, Rational, Rational>;

Corner corner_of(const RationalPoint3& p) { return {p.x, p.y, p.z}; }

std::optional<std::pair<Corner, Corner>> box_of(const Nef3& set) {
  const std::optional<BoundingBox3> box = bounding_box(set);
  if (!box) return std::nullopt;
  return std::pair(corner_of(box->low), corner_of(box->high));
}

std::vector<Nef2> slices_of(Context& context, const Nef3& set, const std::vector<Number>& heights) {
  std::vector<Rational> list;
  list.reserve(heights.size());
  for (const Number& height : heights) list.push_back(height.value);
  return slices(set, list, context);
}

Nef3 rotated(Context& context, const Nef3& set, const std::vector<double>& axis, double degrees) {
  if (axis.size() != 3) throw Error(ErrorCode::BadArgument, "the axis must have three numbers");
  return set.transformed(rotation({axis[0], axis[1], axis[2]}, degrees), context);
}

Nef3 resized(Context& context, const Nef3& set, const Exact<3>& size,
             const std::vector<bool>& automatic) {
  if (automatic.size() != 3) {
    throw Error(ErrorCode::BadArgument, "automatic must have three truth values");
  }
  const std::optional<BoundingBox3> box = bounding_box(set);
  if (!box) return set;
  const AffineMap3 map = resizing(*box, size.value, {automatic[0], automatic[1], automatic[2]});
  return set.transformed(map, context);
}

Nef3 solid_offset(Context& context, const Nef3& set, double distance, unsigned rounds) {
  return offset(set, distance, SolidOffsetOptions{rounds}, context);
}

void def_solid_makers(nb::class_<Nef3>& c) {
  def_run_static(
      c, "sphere", &sphere,
      "Return a ball around the origin. Its equator has `chords` corners. The ball is exactly "
      "convex.",
      "radius"_a, "chords"_a = 30U);
  def_run_static(
      c, "cylinder", &cylinder,
      "Return a cylinder along the z-axis. If the radii at the top and at the bottom differ, the "
      "result is a cone or a frustum. It extends upwards from z = 0. If `centred` is true, its "
      "centre is the origin.",
      "height"_a, "bottom_radius"_a, "top_radius"_a = nb::none(), "chords"_a = 30U,
      "centred"_a = false);
  def_run_static(c, "torus", &torus,
                 "Return a torus around the z-axis. `radius` is the distance of the centre of the "
                 "tube from the axis.",
                 "radius"_a, "tube_radius"_a, "chords"_a = 30U, "tube_chords"_a = 16U);
  def_run_static(c, "hull", &hull_of_points,
                 "Return the exact convex hull of points, float64 (n, 3). The points may lie in a "
                 "plane or on a line.",
                 "points"_a);
  def_run_static(
      c, "hull_of",
      +[](Context& k, const std::vector<Nef3>& sets) {
        return convex_hull(std::span<const Nef3>(sets), k);
      },
      "Return the convex hull of the union of bounded sets, as a closed set.", "sets"_a);
}

void def_solid_facts(nb::class_<Nef3>& c) {
  def_run(
      c, "convex_hull",
      +[](Context& k, const Nef3& set) { return convex_hull(std::span<const Nef3>(&set, 1), k); },
      "Return the convex hull of the closure of a bounded set.");
  def_run(
      c, "components", +[](Context& k, const Nef3& set) { return components(set, k); },
      "Return the connected components of the set.");
  def_run(c, "offset", &solid_offset,
          "Return the closure of the set, grown if `distance` is positive, and shrunk if it is "
          "negative. The ball of the offset is replaced by a polyhedron: an octahedron whose "
          "faces were subdivided `rounds` times.",
          "distance"_a, "rounds"_a = 2U);
  c.def("genus", &genus,
        "Return the number of handles of the boundary, or None if the set is not simple or not "
        "bounded.");
  c.def("bounding_box", &box_of,
        "Return the corners (low, high) of the bounding box of the set, as fractions, or None if "
        "the set is empty.");
  def_run(
      c, "slice",
      +[](Context& k, const Nef3& set, const Number& height) {
        return slice(set, height.value, k);
      },
      "Return the points (x, y) for which (x, y, height) belongs to the set.", "height"_a);
  def_run(c, "slices", &slices_of, "Return one slice for each height.", "heights"_a);
  def_run(
      c, "shadow", +[](Context& k, const Nef3& set) { return shadow(set, k); },
      "Return the closure of the projection of the set along the z-axis.");
}

void def_solid_maps(nb::class_<Nef3>& c) {
  def_run(c, "rotated", &rotated,
          "Return the set rotated about an axis through the origin. The matrix of the rotation is "
          "exactly orthogonal. A rotation about a coordinate axis by a multiple of 90 degrees is "
          "exact. Otherwise each entry of the matrix has an error of at most 2^-50.",
          "axis"_a, "degrees"_a);
  def_run(
      c, "scaled",
      +[](Context& k, const Nef3& set, const Exact<3>& factors) {
        return set.transformed(scaling(factors.value), k);
      },
      "Return the set scaled along the axes by three exact factors.", "factors"_a);
  def_run(
      c, "mirrored",
      +[](Context& k, const Nef3& set, const Exact<3>& normal) {
        return set.transformed(reflection(normal.value), k);
      },
      "Return the set reflected in the plane through the origin with this normal.", "normal"_a);
  def_run(c, "resized", &resized,
          "Return the set scaled so that its bounding box has this size. Along an axis with the "
          "size 0, the factor is 1. If this axis is `automatic`, its factor is instead the "
          "greatest factor of the other axes.",
          "size"_a, "automatic"_a = std::vector<bool>{false, false, false});
}

// --- sets of the plane ------------------------------------------------------------------------

OffsetJoin join_of(const std::string& name) {
  if (name == "round") return OffsetJoin::Round;
  if (name == "mitre") return OffsetJoin::Mitre;
  if (name == "square") return OffsetJoin::Square;
  if (name == "bevel") return OffsetJoin::Bevel;
  throw Error(ErrorCode::BadArgument,
              "join must be 'round', 'mitre', 'square' or 'bevel', not '" + name + "'");
}

Nef2 offset_of(Context& context, const Nef2& set, double distance, const std::string& join,
               double mitre_limit, double chord_error, std::uint32_t circle_segments) {
  OffsetOptions options;
  options.join = join_of(join);
  options.mitre_limit = mitre_limit;
  options.chord_error = chord_error;
  options.circle_segments = circle_segments;
  return offset(set, distance, options, context);
}

Nef2 plane_hull(Context& context, const Coordinates2& points) {
  std::vector<Point2> list;
  const std::span<const double> xy = points.span();
  list.reserve(xy.size() / 2);
  for (std::size_t i = 0; i < xy.size(); i += 2) list.push_back({xy[i], xy[i + 1]});
  return convex_hull(std::span<const Point2>(list), context);
}

Nef3 extruded(Context& context, const Nef2& outline, double height, bool centred, double twist,
              std::uint32_t layers, const std::pair<double, double>& scale) {
  LinearExtrusion options;
  options.height = height;
  options.centred = centred;
  options.twist = twist;
  options.slices = layers;
  options.scale = {scale.first, scale.second};
  return linear_extrusion(outline, options, context);
}

std::pair<Nef2, SimplifyReport> simplified_set_with_report(Context& context, const Nef2& set,
                                                           double tolerance, double kept,
                                                           double within) {
  SimplifiedSet made = simplify_borders(set, {tolerance, kept, within}, context);
  const SimplifyReport report = report_of(made);
  return {std::move(made.set), report};
}

using FlatMesh = std::pair<ArrayOut<double, 2>, ArrayOut<std::uint32_t, 3>>;

FlatMesh arrays_of(const PlaneTriangulation& triangulation) {
  FlatMesh result;
  result.first.values = coordinates_of(triangulation.points);
  for (const auto& triangle : triangulation.triangles) {
    result.second.values.insert(result.second.values.end(), triangle.begin(), triangle.end());
  }
  return result;
}

FlatMesh triangulated(Context& context, const Nef2& set) {
  return arrays_of(delaunay(round_to_doubles(set, context).set, context));
}

void def_plane_models(nb::class_<Nef2>& c) {
  def_run(c, "triangulated", &triangulated,
          "Return triangles that cover the set after its coordinates were rounded to doubles: "
          "points float64 (n, 2), triangles uint32 (m, 3). They form a constrained Delaunay "
          "triangulation: edges of the set are sides of triangles, and no points are added.");
  def_run_static(
      c, "delaunay",
      +[](Context& k, const Coordinates2& points) {
        return arrays_of(delaunay(points_of(points.span()), k)).second;
      },
      "Return the Delaunay triangulation of points, float64 (n, 2): uint32 (m, 3).", "points"_a);
  def_run_static(
      c, "disk",
      +[](Context& k, double radius, std::uint32_t chords) { return disk(radius, chords, k); },
      "Return the closed regular polygon with `chords` corners that is inscribed in a circle "
      "around the origin.",
      "radius"_a, "chords"_a = 30U);
  def_run_static(c, "hull", &plane_hull, "Return the exact convex hull of points, float64 (n, 2).",
                 "points"_a);
  def_run_static(
      c, "hull_of",
      +[](Context& k, const std::vector<Nef2>& sets) {
        return convex_hull(std::span<const Nef2>(sets), k);
      },
      "Return the convex hull of the union of bounded sets, as a closed set.", "sets"_a);
  def_run(
      c, "convex_hull",
      +[](Context& k, const Nef2& set) { return convex_hull(std::span<const Nef2>(&set, 1), k); },
      "Return the convex hull of the closure of a bounded set.");
  def_run(
      c, "simplified",
      +[](Context& k, const Nef2& set, double tolerance, double kept, double within) {
        return simplify_borders(set, {tolerance, kept, within}, k).set;
      },
      "Return the closure of a bounded set with fewer corners. A corner and its two neighbours "
      "form a triangle. A corner is removed only if the area of its triangle is at most "
      "`tolerance`, if more than the fraction `kept` of the removable corners remains, and if no "
      "point of a border moves farther than `within`. Coordinates are rounded to doubles.",
      "tolerance"_a = std::numeric_limits<double>::infinity(), "kept"_a = 0.0,
      "within"_a = std::numeric_limits<double>::infinity());
  def_run(c, "simplified_with_report", &simplified_set_with_report,
          "Do the same as simplified(), and return also a SimplifyReport.",
          "tolerance"_a = std::numeric_limits<double>::infinity(), "kept"_a = 0.0,
          "within"_a = std::numeric_limits<double>::infinity());
  def_run(c, "offset", &offset_of,
          "Return the closure of the set, grown if `distance` is positive, and shrunk if it is "
          "negative. `join` is the shape at convex corners: 'round', 'mitre', 'square' or "
          "'bevel'. An arc is replaced by chords. Their distance from the arc is at most "
          "`chord_error`, by default a thousandth of the distance of the offset. If "
          "`circle_segments` is given, it is the number of chords of a full circle.",
          "distance"_a, "join"_a = "round", "mitre_limit"_a = 2.0, "chord_error"_a = 0.0,
          "circle_segments"_a = 0U);
  def_run(
      c, "distance", &distance_of<Nef2>,
      "Return the distance between the closures of this set and another set, with nearest points "
      "and the cells that contain these points. One of the sets must be bounded.",
      "other"_a);
  def_run(
      c, "minkowski_sum",
      +[](Context& k, const Nef2& a, const Nef2& b) { return minkowski_sum(a, b, k); },
      "Return the Minkowski sum: the set of all sums of a point of this set and a point of the "
      "other set.",
      "other"_a);
  def_run(c, "extruded", &extruded,
          "Return the solid between this set at the bottom and its image at the top. The image is "
          "turned clockwise by `twist` degrees, and scaled. `layers` is the number of layers of "
          "equal height.",
          "height"_a, "centred"_a = false, "twist"_a = 0.0, "layers"_a = 1U,
          "scale"_a = std::pair(1.0, 1.0));
  def_run(
      c, "revolved",
      +[](Context& k, const Nef2& set, double degrees, std::uint32_t steps) {
        return rotational_extrusion(set, degrees, steps, k);
      },
      "Return the solid that the set sweeps when it turns around the z-axis. The y-axis of the "
      "set is placed on the z-axis. The set must not have points on both sides of the line x = 0.",
      "degrees"_a = 360.0, "steps"_a = 30U);
}

// --- models of OpenSCAD -----------------------------------------------------------------------

CsgImports imports_of(const std::string& name) {
  if (name == "none") return CsgImports::None;
  if (name == "below") return CsgImports::BelowModel;
  if (name == "anywhere") return CsgImports::Anywhere;
  throw Error(ErrorCode::BadArgument,
              "imports must be 'none', 'below' or 'anywhere', not '" + name + "'");
}

using Model = std::optional<std::variant<Nef3, Nef2>>;

struct Evaluated {
  CsgResult result;
  std::vector<std::string> notes;
  std::vector<std::string> warnings;
};

Evaluated evaluated(CsgRead read, Context& context) {
  Evaluated result{evaluate(read.tree, context), std::move(read.notes), std::move(read.warnings)};
  result.notes.insert(result.notes.end(), result.result.notes.begin(), result.result.notes.end());
  return result;
}

Model model_of(Evaluated model) {
  warn(model.warnings);
  note(model.notes);
  if (model.result.dimension == CsgDimension::Space) return std::move(model.result.solid);
  if (model.result.dimension == CsgDimension::Plane) return std::move(model.result.shape);
  return std::nullopt;
}

void def_csg(nb::module_& m) {
  m.def(
      "read_csg",
      [](const Path& path, const std::string& imports, bool exact_decimals, unsigned threads,
         std::optional<double> timeout, std::optional<std::uint64_t> memory_limit,
         nb::object progress) {
        const CsgReadOptions options{imports_of(imports), exact_decimals};
        return model_of(run(
            CallLimits{threads, timeout, memory_limit, std::move(progress)},
            [&](Context& k) { return evaluated(read_csg_file(path.string(), options, k), k); }));
      },
      "path"_a, "imports"_a = "below", "exact_decimals"_a = false, nb::kw_only(), "threads"_a = 1U,
      "timeout"_a = nb::none(), "memory_limit"_a = nb::none(), "progress"_a = nb::none(),
      with_limits("Read a flattened model of OpenSCAD (.csg), and return its set: a Solid, a "
                  "PlaneSet, or None if it has no geometry. `imports` states which files the "
                  "model may import: 'below' (files in the folder of the model, and in folders "
                  "below it), 'anywhere' (all files) or 'none'."));
  m.def(
      "parse_csg",
      [](const std::string& text, unsigned threads, std::optional<double> timeout,
         std::optional<std::uint64_t> memory_limit, nb::object progress) {
        return model_of(
            run(CallLimits{threads, timeout, memory_limit, std::move(progress)}, [&](Context& k) {
              return evaluated(read_csg("model", text, {CsgImports::None, false}, k), k);
            }));
      },
      "text"_a, nb::kw_only(), "threads"_a = 1U, "timeout"_a = nb::none(),
      "memory_limit"_a = nb::none(), "progress"_a = nb::none(),
      with_limits("Do the same as read_csg() for a text. Imports are refused."));
}

}  // namespace

void def_models(nb::class_<Nef3>& c) {
  def_solid_makers(c);
  def_solid_facts(c);
  def_solid_maps(c);
}

void def_models(nb::class_<Nef2>& c) { def_plane_models(c); }

void bind_models(nb::module_& m) { def_csg(m); }

}  // namespace plumb::python
