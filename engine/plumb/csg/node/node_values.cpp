// Values of single nodes: primitives, maps, sizes, offsets, projections, extrusions.
//
// The numbers of fragments, of slices and of steps are the same as in OpenSCAD 2021.01, so that
// vertices lie where its users expect them. OpenSCAD computes these numbers in doubles. They only
// decide how finely a curved shape is divided. Sizes of sets are exact.
//
// Tested by tests/csg/evaluate_test.cpp.
#include "plumb/csg/node/node_values.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "plumb/model/extrude.h"
#include "plumb/model/hull.h"
#include "plumb/model/primitives.h"
#include "plumb/model/slice.h"
#include "plumb/model/transform.h"
#include "plumb/plane/plane_offset.h"
#include "plumb/predicates/arithmetic/elementary.h"
#include "plumb/predicates/error.h"
#include "plumb/predicates/rounding.h"
#include "plumb/space/from_mesh.h"
#include "plumb/space/mesh_arrays.h"
#include "plumb/space/repair_mesh.h"

namespace plumb {
namespace {

using Numbers = std::span<const double>;

/// If a radius or a shift is shorter than this, OpenSCAD makes the fewest slices.
constexpr double kLeastLength = 0x1p-20;
constexpr double kMostSlices = 1 << 20;
/// OpenSCAD prolongs mitres as far as they go, up to this limit.
constexpr double kMitreLimit = 1e6;

CircleDivision division(Numbers n, std::size_t at) { return {n[at], n[at + 1], n[at + 2]}; }

Placement placement(double is_centred) {
  return is_centred != 0 ? Placement::Centred : Placement::Corner;
}

bool are_positive(Numbers n) {
  return std::all_of(n.begin(), n.end(), [](double x) { return x > 0; });
}

// ---------------------------------------------------------------- primitives

/// Returns the mesh of a polyhedron node. OpenSCAD's faces are clockwise seen from outside.
PolygonMesh mesh_of(Numbers n, std::span<const std::uint32_t> indices) {
  PolygonMesh mesh;
  for (std::size_t i = 0; i + 2 < n.size(); i += 3)
    mesh.points.push_back({n[i], n[i + 1], n[i + 2]});
  if (indices.empty()) return mesh;
  const std::uint32_t faces = indices[0];
  auto corners = indices.subspan(1 + faces);
  for (const std::uint32_t size : indices.subspan(1, faces)) {
    std::vector<std::uint32_t> face(corners.begin(), corners.begin() + size);
    std::reverse(face.begin(), face.end());
    if (size >= 3) mesh.add_face(face);
    corners = corners.subspan(size);
  }
  return mesh;
}

/// Returns the solid of a polyhedron node. If the mesh has no holes, faces with the wrong
/// orientation are flipped.
Nef3 polyhedron(Numbers n, std::span<const std::uint32_t> indices, std::string& remark,
                Context& context) {
  PolygonMesh mesh = mesh_of(n, indices);
  if (mesh.face_count() == 0) return Nef3::empty();
  try {
    return Nef3::from_mesh(mesh, {}, context);
  } catch (const OpenMesh&) {
    RepairOptions options;
    options.reorient = true;
    const RepairReport report = repair_mesh(mesh, options, context);
    if (!report.is_closed() || report.flipped.empty()) throw;
    remark = std::to_string(report.flipped.size()) +
             (report.flipped.size() == 1 ? " face is" : " faces are") +
             " oriented opposite to the others, and flipped; the first is face " +
             std::to_string(report.flipped[0]) + " (0-based)";
  }
  return Nef3::from_mesh(mesh, {}, context);
}

Nef2 polygon(Numbers n, std::span<const std::uint32_t> indices, Context& context) {
  PointTable2 points;
  points.reserve(n.size() / 2);
  for (std::size_t i = 0; i + 1 < n.size(); i += 2) points.push_back(Point2{n[i], n[i + 1]});
  if (indices.empty()) return Nef2::empty();
  const std::uint32_t paths = indices[0];
  std::vector<std::uint32_t> begin{0};
  for (const std::uint32_t size : indices.subspan(1, paths)) begin.push_back(begin.back() + size);
  return Nef2::polygons(points, indices.subspan(1 + paths), begin, WindingRule::EvenOdd,
                        Boundary::Closed, context)
      .regularization(context);
}

// ---------------------------------------------------------------- extents

/// The least and the greatest coordinates along each axis.
template <std::size_t Axes>
struct Extent {
  std::array<Rational, Axes> low;
  std::array<Rational, Axes> high;
};

/// Calls visit(point) for each corner of the polygons of a set of the plane.
template <class Visit>
void for_each_corner(const Nef2& set, Context& context, Visit visit) {
  const PlaneParts parts = set.parts(context);
  for (const PolygonWithHoles2& polygon : parts.polygons) {
    for (const RationalPoint2& corner : polygon.outer) visit(corner);
  }
}

std::optional<Extent<3>> extent_of(const Nef3& set, Context&) {
  const auto box = bounding_box(set);
  if (!box) return {};
  return Extent<3>{{box->low.x, box->low.y, box->low.z}, {box->high.x, box->high.y, box->high.z}};
}

std::optional<Extent<2>> extent_of(const Nef2& set, Context& context) {
  std::optional<Extent<2>> extent;
  for_each_corner(set, context, [&](const RationalPoint2& p) {
    const std::array<Rational, 2> at{p.x, p.y};
    if (!extent) extent = Extent<2>{at, at};
    for (std::size_t axis = 0; axis < 2; ++axis) {
      if (at[axis] < extent->low[axis]) extent->low[axis] = at[axis];
      if (extent->high[axis] < at[axis]) extent->high[axis] = at[axis];
    }
  });
  return extent;
}

/// Returns the factors of a resize node. An axis with the size 0 keeps its length, or, if it is
/// automatic, has the factor of the axis with the greatest size.
template <std::size_t Axes>
std::array<Rational, 3> resize_factors(const Extent<Axes>& extent, Numbers n) {
  std::array<Rational, 3> factor{1, 1, 1};
  const auto set_factor = [&](std::size_t axis) {
    const Rational length = extent.high[axis] - extent.low[axis];
    if (n[axis] > 0 && length != 0) factor[axis] = Rational(n[axis]) / length;
  };
  for (std::size_t axis = 0; axis < Axes; ++axis) set_factor(axis);
  const auto greatest = std::max_element(n.begin(), n.begin() + Axes) - n.begin();
  for (std::size_t axis = 0; axis < Axes; ++axis) {
    if (!(n[axis] > 0) && n[3 + axis] != 0)
      factor[axis] = factor[static_cast<std::size_t>(greatest)];
  }
  return factor;
}

template <class Set>
Set resized_set(const Set& set, Numbers n, std::string& remark, Context& context) {
  const auto extent = extent_of(set, context);
  if (!extent) return set;
  return mapped(set, scaling(resize_factors(*extent, n)), remark, context);
}

// ---------------------------------------------------------------- extrusions

/// The parameters of a linear_extrude node.
struct LinearNumbers {
  explicit LinearNumbers(Numbers n)
      : height(n[0]),
        is_centred(n[1] != 0),
        twist(n[2]),
        slices(n[3]),
        scale{std::max(n[4], 0.0), std::max(n[5], 0.0)},
        division{n[6], n[7], n[8]} {
    if (n.size() > 9) shift = {n[9], n[10]};
  }

  double height;
  bool is_centred;
  double twist;
  double slices;
  std::array<double, 2> scale;
  CircleDivision division;
  std::array<double, 2> shift = {0, 0};  ///< The shift of the top, along x and y.
};

/// Returns the length of an Archimedean spiral r = a theta from 0 to theta.
double spiral_length(double a, double theta) {
  const double root = std::sqrt(1 + theta * theta);
  return a / 2 * (theta * root + std::log(theta + root));
}

/// Returns the length of the path that a point at a radius runs along while it is turned by an
/// angle, lifted by a height, and scaled.
double path_length(double radius, const LinearNumbers& n) {
  const double turn = std::abs(n.twist) * std::numbers::pi / 180;
  const double scale = n.scale[0];
  if (scale == 1) return std::hypot(turn * radius, n.height);
  const double end = scale > 1 ? turn * scale / (scale - 1) : turn / (1 - scale);
  const double a = radius / end;
  return std::hypot(spiral_length(a, end) - spiral_length(a, end - turn), n.height);
}

/// Returns the number of slices for a twist whose two scales are equal, or so close that OpenSCAD
/// treats them as equal.
double slices_of_twist(double radius, const LinearNumbers& n) {
  const double turn = std::abs(n.twist);
  const double least = std::max(std::ceil(turn / 120), 1.0);
  if (radius < kLeastLength) return least;
  if (n.division.count > 0) return std::max(std::ceil(turn / 360 * n.division.count), least);
  const double by_angle = std::ceil(turn / n.division.angle);
  const double by_length = std::ceil(path_length(radius, n) / n.division.length);
  return std::max(std::min(by_angle, by_length), least);
}

/// Returns the number of slices for two scales that differ. `shift` is the greatest distance by
/// which a point moves.
double slices_of_scale(double shift, const LinearNumbers& n) {
  if (shift < kLeastLength) return 1;
  if (n.division.count > 0) return std::max(std::floor(n.division.count), 1.0);
  return std::max(std::ceil(std::hypot(shift, n.height) / n.division.length), 1.0);
}

double slices_of(const Nef2& set, const LinearNumbers& n, Context& context) {
  if (n.slices >= 1) return std::floor(n.slices);
  const bool is_uniform = n.scale[0] == n.scale[1];
  if (n.twist == 0 && is_uniform) return 1;
  double radius = 0, shift = 0;
  for_each_corner(set, context, [&](const RationalPoint2& p) {
    const double x = nearest_double(p.x), y = nearest_double(p.y);
    radius = std::max(radius, std::hypot(x, y));
    shift = std::max(shift, std::hypot(x * (1 - n.scale[0]), y * (1 - n.scale[1])));
  });
  if (is_uniform) return slices_of_twist(radius, n);
  LinearNumbers unscaled = n;
  unscaled.scale = {1, 1};
  return n.twist == 0 ? slices_of_scale(shift, n) : slices_of_twist(radius, unscaled);
}

std::uint32_t checked_steps(double steps) {
  if (!(steps <= kMostSlices)) {
    throw Error(ErrorCode::ResourceLimit, "an extrusion has at most 2^20 slices");
  }
  return static_cast<std::uint32_t>(steps);
}

Nef3 linear(const Nef2& set, const LinearNumbers& n, std::string& remark, Context& context) {
  if (!(n.height > 0)) {
    remark = "the height is not positive, so it gives nothing";
    return Nef3::empty();
  }
  const std::uint32_t slices = checked_steps(slices_of(set, n, context));
  const Nef3 upright =
      linear_extrusion(set, {n.height, n.is_centred, n.twist, slices, n.scale}, context);
  if (n.shift == std::array<double, 2>{0, 0}) return upright;
  AffineMap3 shear = scaling({1, 1, 1});
  for (std::size_t axis = 0; axis < 2; ++axis) {
    shear.matrix[axis][2] = Rational(n.shift[axis]) / Rational(n.height);
  }
  return upright.transformed(shear, context);
}

Nef3 rotational(const Nef2& set, Numbers n, std::string& remark, Context& context) {
  const double angle = n[0] > 360 || n[0] <= -360 ? 360 : n[0];
  const auto extent = extent_of(set, context);
  if (!extent) return Nef3::empty();
  if (angle == 0) {
    remark = "the angle is 0, so it gives nothing";
    return Nef3::empty();
  }
  const double left = std::min(nearest_double(extent->low[0]), 0.0);
  const double right = std::max(nearest_double(extent->high[0]), 0.0);
  const double chords = chords_of(right - left, division(n, 1));
  const double steps = std::max(std::floor(chords * std::abs(angle) / 360), 1.0);
  const Nef3 turned = rotational_extrusion(set, angle, checked_steps(steps), context);
  // The angle at which OpenSCAD begins a turn if the file states none.
  const double first = std::abs(angle) == 360 ? 180 : 0;
  if (n.size() < 5 || n[4] == first) return turned;
  return turned.transformed(rotation({0, 0, 1}, n[4] - first), context);
}

}  // namespace

Nef3 primitive_solid(const CsgTree& tree, const CsgTree::Node& node, std::string& remark,
                     Context& context) {
  const Numbers n = tree.numbers_of(node);
  const auto indices = tree.indices_of(node);
  if (node.kind == CsgKind::Solid) return tree.solids.at(indices[0]);
  if (node.kind == CsgKind::Polyhedron) return polyhedron(n, indices, remark, context);
  if (node.kind == CsgKind::Cube && are_positive(n.first(3))) {
    return Nef3::from_mesh(box_mesh({n[0], n[1], n[2]}, placement(n[3])), {}, context);
  }
  if (node.kind == CsgKind::Sphere && n[0] > 0) {
    const std::uint32_t chords = chords_of(n[0], division(n, 1));
    return Nef3::from_mesh(sphere_mesh(n[0], chords, context), {}, context);
  }
  const bool is_cylinder = node.kind == CsgKind::Cylinder && n[0] > 0 && n[1] >= 0 && n[2] >= 0;
  if (is_cylinder && n[1] + n[2] > 0) {
    const std::uint32_t chords = chords_of(std::max(n[1], n[2]), division(n, 4));
    return Nef3::from_mesh(cylinder_mesh(n[0], n[1], n[2], chords, placement(n[3]), context), {},
                           context);
  }
  remark = "a length is not positive, so it gives nothing";
  return Nef3::empty();
}

Nef3 hull_of_polyhedron(const CsgTree& tree, const CsgTree::Node& node, Context& context) {
  const PolygonMesh mesh = mesh_of(tree.numbers_of(node), tree.indices_of(node));
  std::vector<Point3> corners;
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    for (const std::uint32_t p : mesh.face(f)) corners.push_back(mesh.points[p]);
  }
  return convex_hull(std::span<const Point3>(corners), context);
}

Nef2 primitive_shape(const CsgTree& tree, const CsgTree::Node& node, std::string& remark,
                     Context& context) {
  const Numbers n = tree.numbers_of(node);
  const auto indices = tree.indices_of(node);
  if (node.kind == CsgKind::Shape) return tree.shapes.at(indices[0]);
  if (node.kind == CsgKind::Polygon) return polygon(n, indices, context);
  if (node.kind == CsgKind::Square && are_positive(n.first(2))) {
    return rectangle({n[0], n[1]}, placement(n[2]));
  }
  if (node.kind == CsgKind::Circle && n[0] > 0) {
    return disk(n[0], chords_of(n[0], division(n, 1)), context);
  }
  remark = "a length is not positive, so it gives nothing";
  return Nef2::empty();
}

AffineMap3 map_of(const CsgTree& tree, const CsgTree::Node& node) {
  const Numbers n = tree.numbers_of(node);
  AffineMap3 map;
  for (std::size_t row = 0; row < 3; ++row) {
    for (std::size_t column = 0; column < 3; ++column) {
      map.matrix[row][column] = Rational(n[4 * row + column]);
    }
    map.offset[row] = Rational(n[4 * row + 3]);
  }
  return map;
}

Nef3 mapped(const Nef3& set, const AffineMap3& map, std::string& remark, Context& context) {
  if (determinant(map) != 0) return set.transformed(map, context);
  remark = "the matrix is singular, so it gives nothing";
  return Nef3::empty();
}

Nef2 mapped(const Nef2& set, const AffineMap3& map, std::string& remark, Context& context) {
  const auto& m = map.matrix;
  if (m[0][0] * m[1][1] != m[0][1] * m[1][0]) {
    return set.transformed({m[0][0], m[0][1], map.offset[0], m[1][0], m[1][1], map.offset[1]},
                           context);
  }
  remark = "the matrix is singular, so it gives nothing";
  return Nef2::empty();
}

Nef3 resized(const Nef3& set, const CsgTree& tree, const CsgTree::Node& node, std::string& remark,
             Context& context) {
  return resized_set(set, tree.numbers_of(node), remark, context);
}

Nef2 resized(const Nef2& set, const CsgTree& tree, const CsgTree::Node& node, std::string& remark,
             Context& context) {
  return resized_set(set, tree.numbers_of(node), remark, context);
}

namespace {

/// Returns the angle of the chords of an arc, given the chords of a full circle. OpenSCAD passes
/// the error of such a chord to the library Clipper, which takes at most a quarter of the radius,
/// and computes the chords of a full circle back from it. The same arithmetic gives the same number
/// of chords where an arc has a half of one too many.
double step_of_arcs(double radius, std::uint32_t chords) {
  const double error = radius * (1 - cosine_of_degrees(180.0 / chords));
  const double share = std::min(error, radius / 4) / radius;
  const double steps = std::numbers::pi / arc_cosine(1 - share);
  return 2 * std::numbers::pi / std::min<double>(steps, kMostCircleSegments);
}

}  // namespace

Nef2 offset_of(const Nef2& set, const CsgTree& tree, const CsgTree::Node& node, Context& context) {
  const Numbers n = tree.numbers_of(node);
  OffsetOptions options;
  if (n[1] == 0) {
    const double radius = std::abs(n[0]);
    if (radius > 0) options.arc_step = step_of_arcs(radius, chords_of(radius, division(n, 2)));
  } else {
    options.join = n[1] == 1 ? OffsetJoin::Mitre : OffsetJoin::Square;
    options.mitre_limit = kMitreLimit;
  }
  return offset(set, n[0], options, context);
}

Nef2 projection_of(const Nef3& set, const CsgTree& tree, const CsgTree::Node& node,
                   Context& context) {
  const bool is_cut = tree.numbers_of(node)[0] != 0;
  return is_cut ? slice(set, Rational(0), context).regularization(context) : shadow(set, context);
}

Nef3 extrusion_of(const Nef2& set, const CsgTree& tree, const CsgTree::Node& node,
                  std::string& remark, Context& context) {
  const Numbers n = tree.numbers_of(node);
  if (set.is_empty()) return Nef3::empty();
  return node.kind == CsgKind::LinearExtrude ? linear(set, LinearNumbers(n), remark, context)
                                             : rotational(set, n, remark, context);
}

}  // namespace plumb
