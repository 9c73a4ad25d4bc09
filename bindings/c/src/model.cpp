// Whole models: primitives, hulls, extrusions, slices, maps, offsets, and models of OpenSCAD.
// Tested by tests/c/interface_test.c and tests/c/refused_memory_test.cpp.
#include <cmath>

#include "files.h"
#include "handles.h"
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
#include "sets.h"

namespace plumb::c {
namespace {

Placement placement(bool is_centred) { return is_centred ? Placement::Centred : Placement::Corner; }

template <std::size_t N>
std::array<double, N> array_of(const double* numbers, const char* name) {
  const std::span<const double> given = finite(numbers, N, name, 1);
  std::array<double, N> result;
  std::copy(given.begin(), given.end(), result.begin());
  return result;
}

std::array<Rational, 3> three_of(const plumb_numbers* numbers, const char* name) {
  const std::span<const Rational> v = exactly(numbers, name, 3);
  return {v[0], v[1], v[2]};
}

std::vector<Rational> coefficients_of(const AffineMap3& map) {
  std::vector<Rational> result;
  result.reserve(12);
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) result.push_back(map.matrix[i][j]);
    result.push_back(map.offset[i]);
  }
  return result;
}

/// Returns what plumb_solid_transform() takes.
plumb_numbers numbers_of_map(const AffineMap3& map) { return numbers_of(coefficients_of(map)); }

OffsetJoin join_of(int join) {
  if (join < PLUMB_JOIN_ROUND || join > PLUMB_JOIN_BEVEL) {
    fail_argument("join is no constant of plumb_join");
  }
  return static_cast<OffsetJoin>(join);
}

CsgImports imports_of(int imports) {
  switch (imports) {
    case PLUMB_IMPORTS_BELOW:
      return CsgImports::BelowModel;
    case PLUMB_IMPORTS_NONE:
      return CsgImports::None;
    case PLUMB_IMPORTS_ANYWHERE:
      return CsgImports::Anywhere;
    default:
      fail_argument("imports is no constant of plumb_imports");
  }
}

/// Evaluates what `read` returns, and hands out its set.
template <class Read>
plumb_status evaluate_model(plumb_solid** solid, plumb_plane_set** set, plumb_notes** notes,
                            const plumb_context* context, plumb_error** error,
                            const Read& read) noexcept {
  if (solid != nullptr) *solid = nullptr;
  if (set != nullptr) *set = nullptr;
  if (notes != nullptr) *notes = nullptr;
  return guarded(error, [&] {
    need(solid, "solid");
    need(set, "set");
    Call call(context);
    Context& own = call;
    const CsgRead model = read(own);
    CsgResult result = evaluate(model.tree, own);
    auto told = std::make_unique<plumb_notes>();
    add_notes(*told, model.notes);
    add_notes(*told, result.notes);
    add_warnings(*told, model.warnings);
    if (result.dimension == CsgDimension::Space) {
      *solid = new_handle<plumb_solid>(std::move(result.solid));
    } else if (result.dimension == CsgDimension::Plane) {
      *set = new_handle<plumb_plane_set>(std::move(result.shape));
    }
    if (notes != nullptr) *notes = told.release();
  });
}

plumb_mesh flat_mesh(const PlaneTriangulation& triangulation) {
  plumb_mesh result;
  for (std::uint32_t i = 0; i < triangulation.points.size(); ++i) {
    const Point2 p = triangulation.points.approx(i);
    result.mesh.points.push_back({p.x, p.y, 0});
  }
  for (const auto& triangle : triangulation.triangles) result.mesh.add_face(triangle);
  return result;
}

template <class List, class Set>
List list_of(std::vector<Set> sets) {
  List list;
  list.sets.reserve(sets.size());
  for (Set& set : sets) list.sets.push_back({std::move(set)});
  return list;
}

}  // namespace
}  // namespace plumb::c

using namespace plumb;
using namespace plumb::c;

// --- primitives and hulls -----------------------------------------------------------------------

plumb_status plumb_solid_box(const double* size, bool is_centred, plumb_solid** out,
                             const plumb_context* context, plumb_error** error) {
  return make(out, error, [&] {
    Call call(context);
    return Nef3::from_mesh(box_mesh(array_of<3>(size, "size"), placement(is_centred)), {}, call);
  });
}

plumb_status plumb_solid_sphere(double radius, std::uint32_t chords, plumb_solid** out,
                                const plumb_context* context, plumb_error** error) {
  return make(out, error, [&] {
    Call call(context);
    return Nef3::from_mesh(sphere_mesh(radius, chords, call), {}, call);
  });
}

plumb_status plumb_solid_cylinder(double height, double bottom_radius, double top_radius,
                                  std::uint32_t chords, bool is_centred, plumb_solid** out,
                                  const plumb_context* context, plumb_error** error) {
  return make(out, error, [&] {
    Call call(context);
    const PolygonMesh mesh =
        cylinder_mesh(height, bottom_radius, top_radius, chords, placement(is_centred), call);
    return Nef3::from_mesh(mesh, {}, call);
  });
}

plumb_status plumb_solid_torus(double radius, double tube_radius, std::uint32_t chords,
                               std::uint32_t tube_chords, plumb_solid** out,
                               const plumb_context* context, plumb_error** error) {
  return make(out, error, [&] {
    Call call(context);
    return Nef3::from_mesh(torus_mesh(radius, tube_radius, chords, tube_chords, call), {}, call);
  });
}

plumb_status plumb_solid_hull(const double* xyz, std::size_t count, plumb_solid** out,
                              const plumb_context* context, plumb_error** error) {
  return make(out, error, [&] {
    Call call(context);
    const std::span<const double> given = finite(xyz, count, "xyz", 3);
    std::vector<Point3> points;
    points.reserve(count);
    for (std::size_t i = 0; i < given.size(); i += 3) {
      points.push_back({given[i], given[i + 1], given[i + 2]});
    }
    return convex_hull(std::span<const Point3>(points), call);
  });
}

plumb_status plumb_solid_hull_exact(const plumb_numbers* points, plumb_solid** out,
                                    const plumb_context* context, plumb_error** error) {
  return make(out, error, [&] {
    Call call(context);
    const std::vector<RationalPoint3> list = points3(points, "points");
    return convex_hull(std::span<const RationalPoint3>(list), call);
  });
}

plumb_status plumb_solid_hull_of(const plumb_solid* const* solids, std::size_t count,
                                 plumb_solid** out, const plumb_context* context,
                                 plumb_error** error) {
  return make(out, error, [&] {
    Call call(context);
    const std::vector<Nef3> sets = sets_of(solids, count);
    return convex_hull(std::span<const Nef3>(sets), call);
  });
}

plumb_status plumb_plane_set_disk(double radius, std::uint32_t chords, plumb_plane_set** out,
                                  const plumb_context* context, plumb_error** error) {
  return make(out, error, [&] {
    Call call(context);
    return disk(radius, chords, call);
  });
}

plumb_status plumb_plane_set_hull(const double* xy, std::size_t count, plumb_plane_set** out,
                                  const plumb_context* context, plumb_error** error) {
  return make(out, error, [&] {
    Call call(context);
    const std::span<const double> given = finite(xy, count, "xy", 2);
    std::vector<Point2> points;
    points.reserve(count);
    for (std::size_t i = 0; i < given.size(); i += 2) points.push_back({given[i], given[i + 1]});
    return convex_hull(std::span<const Point2>(points), call);
  });
}

plumb_status plumb_plane_set_hull_exact(const plumb_numbers* points, plumb_plane_set** out,
                                        const plumb_context* context, plumb_error** error) {
  return make(out, error, [&] {
    Call call(context);
    const std::vector<RationalPoint2> list = points2(points, "points");
    return convex_hull(std::span<const RationalPoint2>(list), call);
  });
}

plumb_status plumb_plane_set_hull_of(const plumb_plane_set* const* sets, std::size_t count,
                                     plumb_plane_set** out, const plumb_context* context,
                                     plumb_error** error) {
  return make(out, error, [&] {
    Call call(context);
    const std::vector<Nef2> list = sets_of(sets, count);
    return convex_hull(std::span<const Nef2>(list), call);
  });
}

// --- between plane and space --------------------------------------------------------------------

plumb_status plumb_plane_set_extrude(const plumb_plane_set* outline, const plumb_extrusion* options,
                                     plumb_solid** out, const plumb_context* context,
                                     plumb_error** error) {
  return make(out, error, [&] {
    Call call(context);
    const plumb_extrusion asked = options_of(options, PLUMB_EXTRUSION_INIT);
    LinearExtrusion extrusion;
    extrusion.height = asked.height;
    extrusion.centred = asked.is_centred;
    extrusion.twist = asked.twist;
    extrusion.slices = asked.layers;
    extrusion.scale = {asked.scale[0], asked.scale[1]};
    return linear_extrusion(need(outline, "outline").set, extrusion, call);
  });
}

plumb_status plumb_plane_set_revolve(const plumb_plane_set* outline, double angle,
                                     std::uint32_t steps, plumb_solid** out,
                                     const plumb_context* context, plumb_error** error) {
  return make(out, error, [&] {
    Call call(context);
    return rotational_extrusion(need(outline, "outline").set, angle, steps, call);
  });
}

plumb_status plumb_solid_slices(const plumb_solid* solid, const plumb_numbers* heights,
                                plumb_plane_set_list** out, const plumb_context* context,
                                plumb_error** error) {
  return make(out, error, [&] {
    Call call(context);
    const std::span<const Rational> list = records(heights, "heights", 1);
    return list_of<plumb_plane_set_list>(slices(need(solid, "solid").set, list, call));
  });
}

plumb_status plumb_solid_shadow(const plumb_solid* solid, plumb_plane_set** out,
                                const plumb_context* context, plumb_error** error) {
  return make(out, error, [&] {
    Call call(context);
    return shadow(need(solid, "solid").set, call);
  });
}

plumb_status plumb_solid_offset(const plumb_solid* solid, double distance, std::uint32_t rounds,
                                plumb_solid** out, const plumb_context* context,
                                plumb_error** error) {
  return make(out, error, [&] {
    Call call(context);
    return offset(need(solid, "solid").set, distance, SolidOffsetOptions{rounds}, call);
  });
}

plumb_status plumb_solid_components(const plumb_solid* solid, plumb_solid_list** out,
                                    const plumb_context* context, plumb_error** error) {
  return make(out, error, [&] {
    Call call(context);
    return list_of<plumb_solid_list>(components(need(solid, "solid").set, call));
  });
}

plumb_status plumb_solid_genus(const plumb_solid* solid, bool* is_surface, std::uint64_t* result,
                               plumb_error** error) {
  return guarded(error, [&] {
    need(is_surface, "is_surface");
    need(result, "genus");
    const std::optional<std::uint64_t> handles = genus(need(solid, "solid").set);
    *is_surface = handles.has_value();
    *result = handles.value_or(0);
  });
}

plumb_status plumb_solid_bounding_box(const plumb_solid* solid, plumb_numbers** out,
                                      plumb_error** error) {
  return make(out, error, [&] {
    const std::optional<BoundingBox3> box = bounding_box(need(solid, "solid").set);
    if (!box) return numbers_of(std::vector<Rational>{});
    return numbers_of({box->low.x, box->low.y, box->low.z, box->high.x, box->high.y, box->high.z});
  });
}

// --- affine maps --------------------------------------------------------------------------------

plumb_status plumb_numbers_rotation(const double* axis, double degrees, plumb_numbers** out,
                                    plumb_error** error) {
  return make(out, error,
              [&] { return numbers_of_map(rotation(array_of<3>(axis, "axis"), degrees)); });
}

plumb_status plumb_numbers_scaling(const plumb_numbers* factors, plumb_numbers** out,
                                   plumb_error** error) {
  return make(out, error, [&] { return numbers_of_map(scaling(three_of(factors, "factors"))); });
}

plumb_status plumb_numbers_reflection(const plumb_numbers* normal, plumb_numbers** out,
                                      plumb_error** error) {
  return make(out, error, [&] { return numbers_of_map(reflection(three_of(normal, "normal"))); });
}

plumb_status plumb_numbers_resizing(const plumb_solid* solid, const plumb_numbers* size,
                                    const bool* is_automatic, plumb_numbers** out,
                                    plumb_error** error) {
  return make(out, error, [&] {
    std::array<bool, 3> automatic{};
    if (is_automatic != nullptr) std::copy_n(is_automatic, 3, automatic.begin());
    const std::array<Rational, 3> sizes = three_of(size, "size");
    const std::optional<BoundingBox3> box = bounding_box(need(solid, "solid").set);
    if (!box) fail_argument("the solid is empty");
    return numbers_of_map(resizing(*box, sizes, automatic));
  });
}

// --- offsets and sums of the plane --------------------------------------------------------------

plumb_status plumb_plane_set_offset(const plumb_plane_set* set, double distance,
                                    const plumb_offset_options* options, plumb_plane_set** out,
                                    const plumb_context* context, plumb_error** error) {
  return make(out, error, [&] {
    Call call(context);
    const plumb_offset_options asked = options_of(options, PLUMB_OFFSET_OPTIONS_INIT);
    const OffsetOptions chosen{join_of(asked.join), asked.mitre_limit, asked.chord_error,
                               asked.circle_segments};
    return offset(need(set, "set").set, distance, chosen, call);
  });
}

plumb_status plumb_plane_set_simplify(const plumb_plane_set* set, double tolerance, double kept,
                                      double within, plumb_plane_set** out, double* moved,
                                      const plumb_context* context, plumb_error** error) {
  return make(out, error, [&] {
    Call call(context);
    SimplifiedSet made = simplify_borders(need(set, "set").set, {tolerance, kept, within}, call);
    if (moved != nullptr) *moved = made.borders_moved;
    return std::move(made.set);
  });
}

plumb_status plumb_plane_set_simplify_with_report(const plumb_plane_set* set, double tolerance,
                                                  double kept, double within, plumb_plane_set** out,
                                                  plumb_simplify_report* report,
                                                  const plumb_context* context,
                                                  plumb_error** error) {
  return make(out, error, [&] {
    Call call(context);
    SimplifiedSet made = simplify_borders(need(set, "set").set, {tolerance, kept, within}, call);
    if (report != nullptr) {
      plumb_simplify_report facts = PLUMB_SIMPLIFY_REPORT_INIT;
      facts.corners_before = made.corners_before;
      facts.corners_after = made.corners_after;
      facts.blocked = made.blocked;
      facts.borders_moved = made.borders_moved;
      facts.rounding_moved = made.rounding.largest_move;
      fill(report, facts, "report");
    }
    return std::move(made.set);
  });
}

plumb_status plumb_plane_set_minkowski_sum(const plumb_plane_set* a, const plumb_plane_set* b,
                                           plumb_plane_set** out, const plumb_context* context,
                                           plumb_error** error) {
  return make(out, error, [&] {
    Call call(context);
    return minkowski_sum(need(a, "a").set, need(b, "b").set, call);
  });
}

// --- triangles ----------------------------------------------------------------------------------

plumb_status plumb_plane_set_triangulate(const plumb_plane_set* set, plumb_mesh** out,
                                         const plumb_context* context, plumb_error** error) {
  return make(out, error, [&] {
    Call call(context);
    return flat_mesh(delaunay(round_to_doubles(need(set, "set").set, call).set, call));
  });
}

plumb_status plumb_mesh_delaunay(const double* xy, std::size_t count, plumb_mesh** out,
                                 const plumb_context* context, plumb_error** error) {
  return make(out, error, [&] {
    Call call(context);
    return flat_mesh(delaunay(points_of(finite(xy, count, "xy", 2)), call));
  });
}

// --- models of OpenSCAD -------------------------------------------------------------------------

plumb_status plumb_csg_read(const char* bytes, std::size_t size, const plumb_read_options* options,
                            int imports, plumb_solid** solid, plumb_plane_set** set,
                            plumb_notes** notes, const plumb_context* context,
                            plumb_error** error) {
  return evaluate_model(solid, set, notes, context, error, [&](Context& own) {
    const CsgReadOptions asked{imports_of(imports), reads_exact_decimals(options)};
    return read_csg(name_of(options), bytes_of(bytes, size), asked, own);
  });
}

plumb_status plumb_csg_read_file(const char* path, const plumb_read_options* options, int imports,
                                 plumb_solid** solid, plumb_plane_set** set, plumb_notes** notes,
                                 const plumb_context* context, plumb_error** error) {
  return evaluate_model(solid, set, notes, context, error, [&](Context& own) {
    const CsgReadOptions asked{imports_of(imports), reads_exact_decimals(options)};
    return read_csg_file(text(path, "path"), asked, own);
  });
}
