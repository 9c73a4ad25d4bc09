// Solids: made of arrays, planes and files, combined, measured and cut.
//
// The functions that all sets have are made by PLUMB_C_SET (sets.h). What is special of solids
// follows: meshes in and out, expressions, sections, affine maps, Minkowski sums, convex pieces.
// Tested by tests/c/interface_test.c and tests/c/refused_memory_test.cpp.
#include <cmath>
#include <limits>

#include "files.h"
#include "handles.h"
#include "pictures.h"
#include "plumb/base/set_expression.h"
#include "plumb/convex/convexity.h"
#include "plumb/convex/decompose.h"
#include "plumb/convex/minkowski.h"
#include "plumb/io/solid/solid_text.h"
#include "plumb/io/solid_io.h"
#include "plumb/model/distance.h"
#include "plumb/predicates/rounding.h"
#include "plumb/space/canonical.h"
#include "plumb/space/half_space_list.h"
#include "plumb/space/repair_mesh.h"
#include "plumb/space/source_mesh.h"
#include "plumb/space/space_measure.h"
#include "plumb/space/valid_mesh.h"
#include "plumb/space/weld_points.h"
#include "sets.h"
#include "solids.h"

namespace plumb::c {
namespace {

KeptAttributes kept_attributes(int keep) {
  switch (keep) {
    case PLUMB_KEEP_DEFAULT:
    case PLUMB_KEEP_NONE:
      return KeptAttributes::None;
    case PLUMB_KEEP_COLOURS:
      return KeptAttributes::Colours;
    case PLUMB_KEEP_IDS:
      return KeptAttributes::Ids;
    case PLUMB_KEEP_ALL:
      return KeptAttributes::All;
    default:
      fail_argument("keep is no constant of plumb_keep");
  }
}

SolidReadOptions solid_options(const plumb_solid_options* options,
                               const plumb_read_options* reading = nullptr) {
  const plumb_solid_options asked = options_of(options, PLUMB_SOLID_OPTIONS_INIT);
  SolidReadOptions result;
  result.rule = rule_of(asked.rule);
  result.surface = asked.surface;
  result.may_be_empty = asked.may_be_empty;
  result.repair = repair_options(asked.repair);
  result.exact_decimals = reads_exact_decimals(reading);
  result.attributes = kept_attributes(asked.keep);
  return result;
}

/// The view is read in place unless it is to be mended.
Nef3 set_of(const MeshView& mesh, const SolidReadOptions& options, Context& context) {
  const FromMeshOptions making{.rule = options.rule, .surface = options.surface};
  if (!options.repair.asks()) return Nef3::from_mesh(mesh, making, context);
  PolygonMesh mended = copied_mesh(mesh);
  repair_mesh(mended, options.repair, context);
  return Nef3::from_mesh(mended, making, context);
}

/// Returns the solid of a mesh. The mesh becomes its source if attributes are to be kept. Welding
/// moves faces into other planes, so the source has its points where the weld will move them.
Nef3 solid_of(const MeshView& mesh, const plumb_solid_options* options, Context& context,
              const MeshAttributes& attributes = {}) {
  const plumb_solid_options asked = options_of(options, PLUMB_SOLID_OPTIONS_INIT);
  const SolidReadOptions reading = solid_options(options);
  const bool is_wanted = asked.keep == PLUMB_KEEP_DEFAULT || asked.keep > PLUMB_KEEP_NONE;
  const KeptAttributes kept =
      asked.keep == PLUMB_KEEP_DEFAULT ? KeptAttributes::All : reading.attributes;
  Nef3 set = set_of(mesh, reading, context);
  if (!is_wanted) return set;
  MeshSource source;
  source.name = text_or_empty(asked.source_name);
  source.attributes = attributes;
  keep_only(kept, source.attributes);
  if (source.attributes.empty() && asked.keep != PLUMB_KEEP_ALL) return set;
  source.mesh = copied_mesh(mesh);
  if (reading.repair.weld > 0) weld_points(source.mesh, reading.repair.weld, context);
  return set.with_source(std::make_shared<const MeshSource>(std::move(source)));
}

Plane3 plane_of(const plumb_numbers* numbers) {
  const std::span<const Rational> v = exactly(numbers, "plane", 4);
  return {v[0], v[1], v[2], v[3]};
}

Nef3 solid_of_read(SolidRead read, plumb_notes& notes) {
  add_notes(notes, read.notes);
  add_warnings(notes, read.warnings);
  return std::move(read.set);
}

const SolidFormat& format_named(const std::string& name) {
  for (const SolidFormat& format : solid_formats()) {
    if (format.name == name) return format;
  }
  fail_format(name, "off, off-exact, obj, stl, stl-binary, ply, ply-text, glb, 3mf, nef");
}

const SolidFormat& format_of(const std::string& path) {
  const std::string extension = std::filesystem::path(path).extension().string();
  for (const SolidFormat& format : solid_formats()) {
    if (format.extension == extension) return format;
  }
  throw Error(ErrorCode::UnknownFormat, "no format has the extension '" + extension + "'", {path});
}

SolidText prepared(const plumb_solid* solid, const SolidFormat& format,
                   const plumb_write_options* options, plumb_notes& notes, Context& context,
                   std::string library = {}) {
  const plumb_write_options asked = options_of(options, PLUMB_WRITE_OPTIONS_INIT);
  if (asked.grid != nullptr) {
    throw Error(ErrorCode::Usage, "solids are not rounded to a grid");
  }
  const OutputRounding rounding = asked.raw ? OutputRounding::Nearest : OutputRounding::Valid;
  SolidText prepared(need(solid, "solid").set, format, rounding, context, std::move(library));
  add_notes(notes, prepared.changes());
  if (!prepared.dropped().empty()) add_notes(notes, {prepared.dropped()});
  add_warnings(notes, prepared.losses());
  return prepared;
}

plumb_to_mesh_report report_of(const ToMeshReport& made) {
  plumb_to_mesh_report report = PLUMB_TO_MESH_REPORT_INIT;
  report.dropped = made.dropped.total();
  report.filled = made.filled.total();
  report.closed = made.closed.total();
  report.non_manifold_edges = made.non_manifold_edges;
  report.non_manifold_vertices = made.non_manifold_vertices;
  return report;
}

/// The mesh with the nearest doubles, and the exact points if they are asked for.
MeshOfComplex nearest_mesh(const Nef3& set, const plumb_to_mesh_options& asked,
                           const ToMeshOptions& options, plumb_to_mesh_report& report,
                           Context& context) {
  if (asked.floats) throw Error(ErrorCode::Usage, "floats exclude exact and nearest");
  ToMeshOptions making = options;
  making.keeps_exact = asked.exact;
  MeshOfComplex made = mesh_of_complex(set.complex(), making, context);
  report = report_of(made.report);
  report.rounded_vertices = made.rounded.size();
  return made;
}

MeshOfComplex rounded_mesh(const Nef3& set, const plumb_to_mesh_options& asked,
                           const ToMeshOptions& options, plumb_to_mesh_report& report,
                           Context& context) {
  ValidMesh valid = valid_mesh(
      set, options, asked.floats ? CoordinateType::Float : CoordinateType::Double, context);
  report = to_mesh_report(valid.made.report, valid.repair);
  return std::move(valid.made);
}

plumb_mesh mesh_of(MeshOfComplex made) {
  if (made.report.is_unbounded) fail_argument("the solid is unbounded");
  plumb_mesh mesh{std::move(made.mesh), {}};
  mesh.facets.reserve(made.facet.size());
  for (const FacetId facet : made.facet) mesh.facets.push_back(facet.value());
  return mesh;
}

MarkFunction mark_function(SetOperator op) {
  switch (op) {
    case SetOperator::Union:
      return kUnion;
    case SetOperator::Intersection:
      return kIntersection;
    case SetOperator::Difference:
      return kDifference;
    default:
      return kSymmetricDifference;
  }
}

/// Returns the operand of each name of an expression.
std::vector<Nef3> operands_of(const SetExpression& expression, std::span<const char* const> names,
                              std::span<const plumb_solid* const> solids) {
  std::vector<Nef3> operands;
  for (const std::string& name : expression.names) {
    std::size_t i = 0;
    while (i < names.size() && text(names[i], "an element of names") != name) ++i;
    if (i == names.size()) {
      throw Error(ErrorCode::BadArgument, "there is no solid called '" + name + "'");
    }
    operands.push_back(need(solids[i], "an element of solids").set);
  }
  return operands;
}

Section section_of(int section) {
  if (section < PLUMB_SECTION_CLOSED_BELOW || section > PLUMB_SECTION_PLANE) {
    fail_argument("section is no constant of plumb_section");
  }
  return static_cast<Section>(section);
}

plumb_location location_of(const SpaceLocation& at) {
  return {static_cast<std::int32_t>(at.item.kind()), at.item.index(), at.marked};
}

RationalPoint3 point_at(std::span<const Rational> values) {
  return {values[0], values[1], values[2]};
}

DecomposeMethod method_of(int method) {
  switch (method) {
    case PLUMB_DECOMPOSE_BEST:
      return DecomposeMethod::Best;
    case PLUMB_DECOMPOSE_CUTS:
      return DecomposeMethod::Cuts;
    case PLUMB_DECOMPOSE_WALLS:
      return DecomposeMethod::Walls;
    default:
      fail_argument("method is no constant of plumb_decomposition");
  }
}

std::optional<std::vector<Rational>> coordinates(const std::optional<RationalPoint3>& point) {
  if (!point) return std::nullopt;
  return std::vector<Rational>{point->x, point->y, point->z};
}

}  // namespace

plumb_to_mesh_report to_mesh_report(const ToMeshReport& made, const RoundingRepair& repair) {
  plumb_to_mesh_report report = report_of(made);
  report.rounded_vertices = repair.rounded_vertices;
  report.rounds = repair.rounds;
  report.coarse_rounds = repair.coarse_rounds;
  report.damaged_faces = repair.damaged_faces;
  report.changes_topology = repair.changes_topology;
  report.largest_move = repair.largest_move;
  return report;
}

}  // namespace plumb::c

using namespace plumb;
using namespace plumb::c;

PLUMB_C_SET(plumb_solid, Nef3)

// --- made of meshes and planes ------------------------------------------------------------------

plumb_status plumb_solid_from_triangles(const double* xyz, std::size_t point_count,
                                        const std::uint32_t* triangles, std::size_t triangle_count,
                                        const plumb_solid_options* options, plumb_solid** out,
                                        const plumb_context* context, plumb_error** error) {
  return make(out, error, [&] {
    Call call(context);
    return solid_of(mesh_of_triangles(finite(xyz, point_count, "xyz", 3),
                                      array(triangles, triangle_count, "triangles", 3)),
                    options, call);
  });
}

plumb_status plumb_solid_from_polygons(const double* xyz, std::size_t point_count,
                                       const std::uint32_t* face_begin, std::size_t face_count,
                                       const std::uint32_t* corners, std::size_t corner_count,
                                       const plumb_solid_options* options, plumb_solid** out,
                                       const plumb_context* context, plumb_error** error) {
  return make(out, error, [&] {
    Call call(context);
    return solid_of(mesh_of_polygons(finite(xyz, point_count, "xyz", 3),
                                     offsets(face_begin, face_count, "face_begin"),
                                     array(corners, corner_count, "corners")),
                    options, call);
  });
}

plumb_status plumb_solid_from_mesh(const plumb_mesh* mesh, const plumb_solid_options* options,
                                   plumb_solid** out, const plumb_context* context,
                                   plumb_error** error) {
  return make(out, error, [&] {
    Call call(context);
    const plumb_mesh& given = need(mesh, "mesh");
    return solid_of(given.mesh, options, call, given.attributes);
  });
}

plumb_status plumb_solid_half_space(const plumb_numbers* plane, bool is_closed, plumb_solid** out,
                                    plumb_error** error) {
  return make(out, error, [&] { return Nef3::half_space(plane_of(plane), boundary(is_closed)); });
}

plumb_status plumb_solid_plane(const plumb_numbers* plane, plumb_solid** out, plumb_error** error) {
  return make(out, error, [&] { return Nef3::plane(plane_of(plane)); });
}

plumb_status plumb_solid_from_half_spaces(const double* planes, const bool* is_closed,
                                          std::size_t count, plumb_solid** out,
                                          const plumb_context* context, plumb_error** error) {
  return make(out, error, [&] {
    Call call(context);
    HalfSpaceList list;
    list.reserve(count);
    const std::span<const double> numbers = finite(planes, count, "planes", 4);
    for (std::size_t i = 0; i < count; ++i) {
      for (const double number : numbers.subspan(4 * i, 4)) list.add_number(number);
      list.end(boundary(is_closed == nullptr || is_closed[i]));
    }
    return plumb::intersection_of(list, call);
  });
}

plumb_status plumb_solid_read_half_spaces_file(const char* path, const plumb_read_options* options,
                                               plumb_solid** out, const plumb_context* context,
                                               plumb_error** error) {
  return make(out, error, [&] {
    Call call(context);
    const std::string name = text(path, "path");
    return plumb::intersection_of(read_half_spaces_file(name, read_options(options, name), call),
                                  call);
  });
}

plumb_status plumb_solid_points(const plumb_numbers* points, plumb_solid** out,
                                const plumb_context* context, plumb_error** error) {
  return make(out, error, [&] {
    Call call(context);
    return Nef3::points(points3(points, "points"), call);
  });
}

plumb_status plumb_solid_polyline(const plumb_numbers* points, plumb_solid** out,
                                  const plumb_context* context, plumb_error** error) {
  return make(out, error, [&] {
    Call call(context);
    return Nef3::polyline(points3(points, "points"), call);
  });
}

plumb_status plumb_solid_facet(const plumb_numbers* corners, plumb_solid** out,
                               const plumb_context* context, plumb_error** error) {
  return make(out, error, [&] {
    Call call(context);
    const std::vector<RationalPoint3> points = points3(corners, "corners");
    return Nef3::facet(std::span<const RationalPoint3>(points), call);
  });
}

plumb_status plumb_solid_ball(double radius, std::uint32_t rounds, plumb_solid** out,
                              plumb_error** error) {
  return make(out, error, [&] {
    if (!std::isfinite(radius)) throw Error(ErrorCode::NotFinite, "radius is not finite");
    return polyhedral_ball(radius, rounds);
  });
}

// --- files and pictures -------------------------------------------------------------------------

plumb_status plumb_solid_read(const char* bytes, std::size_t size,
                              const plumb_read_options* reading, const plumb_solid_options* options,
                              plumb_solid** out, plumb_notes** notes, const plumb_context* context,
                              plumb_error** error) {
  return make_with_notes(out, notes, error, [&](plumb_notes& told) {
    Call call(context);
    const SolidReadOptions asked = solid_options(options, reading);
    return solid_of_read(
        read_solid(name_of(reading), std::string(bytes_of(bytes, size)), asked, call), told);
  });
}

plumb_status plumb_solid_read_file(const char* path, const plumb_read_options* reading,
                                   const plumb_solid_options* options, plumb_solid** out,
                                   plumb_notes** notes, const plumb_context* context,
                                   plumb_error** error) {
  return make_with_notes(out, notes, error, [&](plumb_notes& told) {
    Call call(context);
    const SolidReadOptions asked = solid_options(options, reading);
    return solid_of_read(read_solid_file(text(path, "path"), asked, call), told);
  });
}

plumb_status plumb_solid_write(const plumb_solid* solid, const char* format,
                               const plumb_write_options* options, plumb_bytes** out,
                               plumb_notes** notes, const plumb_context* context,
                               plumb_error** error) {
  return make_with_notes(out, notes, error, [&](plumb_notes& told) {
    Call call(context);
    Context& own = call;
    const SolidText file =
        prepared(solid, format_named(text(format, "format")), options, told, own);
    return written([&](std::ostream& stream) { file.write(stream, own); });
  });
}

plumb_status plumb_solid_write_file(const plumb_solid* solid, const char* path, const char* format,
                                    const plumb_write_options* options, plumb_notes** notes,
                                    const plumb_context* context, plumb_error** error) {
  if (notes != nullptr) *notes = nullptr;
  return guarded(error, [&] {
    Call call(context);
    Context& own = call;
    auto told = std::make_unique<plumb_notes>();
    const std::string file = text(path, "path");
    const SolidFormat& wanted = format != nullptr ? format_named(format) : format_of(file);
    const SolidText ready = prepared(solid, wanted, options, *told, own, material_library_of(file));
    ready.write_file(file, own);
    if (notes != nullptr) *notes = told.release();
  });
}

plumb_status plumb_solid_draw(const plumb_solid* solid, const char* format, const char* title,
                              plumb_bytes** out, const plumb_context* context,
                              plumb_error** error) {
  return make(out, error, [&] {
    Call call(context);
    return picture_of(need(solid, "solid").set,
                      picture(text(format, "format"), text_or_empty(title)), call);
  });
}

plumb_status plumb_solid_draw_many(const plumb_solid* const* solids, std::size_t count,
                                   double apart, const char* format, const char* title,
                                   plumb_bytes** out, const plumb_context* context,
                                   plumb_error** error) {
  return make(out, error, [&] {
    Call call(context);
    const std::vector<Nef3> sets = sets_of(solids, count);
    return picture_of(sets, apart, picture(text(format, "format"), text_or_empty(title)), call);
  });
}

plumb_status plumb_solid_to_mesh(const plumb_solid* solid, const plumb_to_mesh_options* options,
                                 plumb_mesh** out, plumb_to_mesh_report* report,
                                 const plumb_context* context, plumb_error** error) {
  return make(out, error, [&] {
    Call call(context);
    const Nef3& set = need(solid, "solid").set;
    const plumb_to_mesh_options asked = options_of(options, PLUMB_TO_MESH_OPTIONS_INIT);
    ToMeshOptions making;
    making.faces = asked.polygons ? MeshFaces::PlanarPolygons : MeshFaces::Triangles;
    making.split_vertices = asked.split_vertices;
    plumb_to_mesh_report told = PLUMB_TO_MESH_REPORT_INIT;
    const bool is_nearest = asked.exact || asked.nearest != 0;
    plumb_mesh mesh = mesh_of(is_nearest ? nearest_mesh(set, asked, making, told, call)
                                         : rounded_mesh(set, asked, making, told, call));
    if (report != nullptr) fill(report, told, "report");
    return mesh;
  });
}

// --- operations ---------------------------------------------------------------------------------

plumb_status plumb_solid_evaluate(const char* expression, const char* const* names,
                                  const plumb_solid* const* solids, std::size_t count,
                                  plumb_solid** out, const plumb_context* context,
                                  plumb_error** error) {
  return make(out, error, [&] {
    Call call(context);
    const SetExpression parsed =
        parse_set_expression(text(expression, "expression"), SetOperators::WithSums);
    const std::vector<Nef3> operands =
        operands_of(parsed, array(names, count, "names"), array(solids, count, "solids"));
    return evaluate<Nef3>(
        parsed, [&](std::uint32_t name) { return operands[name]; },
        [&](const Nef3& a) { return a.complement(call); },
        [&](SetOperator op, const Nef3& a, const Nef3& b) {
          if (op == SetOperator::MinkowskiSum) return minkowski_sum(a, b, call);
          return boolean_op(a, b, mark_function(op), call);
        });
  });
}

plumb_status plumb_solid_canonical(const plumb_solid* solid, plumb_solid** out,
                                   const plumb_context* context, plumb_error** error) {
  return make(out, error, [&] {
    Call call(context);
    return canonical(need(solid, "solid").set, call);
  });
}

plumb_status plumb_solid_section(const plumb_solid* solid, const plumb_numbers* plane, int section,
                                 int operation, plumb_solid** out, const plumb_context* context,
                                 plumb_error** error) {
  return make(out, error, [&] {
    Call call(context);
    Nef3 result = boolean_op(need(solid, "solid").set, plane_of(plane), section_of(section),
                             c::function_of(operation), call);
    return (operation & PLUMB_REGULARIZED) != 0 ? result.regularization(call) : result;
  });
}

plumb_status plumb_solid_transform(const plumb_solid* solid, const plumb_numbers* map,
                                   plumb_solid** out, const plumb_context* context,
                                   plumb_error** error) {
  return make(out, error, [&] {
    Call call(context);
    const std::span<const Rational> v = exactly(map, "map", 12);
    AffineMap3 affine;
    for (std::size_t row = 0; row < 3; ++row) {
      for (std::size_t i = 0; i < 3; ++i) affine.matrix[row][i] = v[4 * row + i];
      affine.offset[row] = v[4 * row + 3];
    }
    return need(solid, "solid").set.transformed(affine, call);
  });
}

plumb_status plumb_solid_minkowski_sum(const plumb_solid* a, const plumb_solid* b,
                                       plumb_solid** out, const plumb_context* context,
                                       plumb_error** error) {
  return make(out, error, [&] {
    Call call(context);
    return minkowski_sum(need(a, "a").set, need(b, "b").set, call);
  });
}

plumb_status plumb_solid_minkowski_erosion(const plumb_solid* a, const plumb_solid* b,
                                           plumb_solid** out, const plumb_context* context,
                                           plumb_error** error) {
  return make(out, error, [&] {
    Call call(context);
    return minkowski_erosion(need(a, "a").set, need(b, "b").set, call);
  });
}

plumb_status plumb_solid_distance(const plumb_solid* a, const plumb_solid* b, plumb_numbers** out,
                                  plumb_location* cells, const plumb_context* context,
                                  plumb_error** error) {
  return find_distance(a, b, out, cells, context, error, location_of);
}

// --- questions ----------------------------------------------------------------------------------

plumb_status plumb_solid_describe(const plumb_solid* solid, plumb_solid_info* info,
                                  plumb_error** error) {
  return guarded(error, [&] {
    const Nef3& set = need(solid, "solid").set;
    const SpaceCounts counts = set.counts();
    fill(info,
         {0, counts.vertices, counts.edges, counts.facets, counts.volumes, counts.marked_volumes,
          set.bytes(), set.is_empty(), set.is_whole(), set.is_bounded(), set.is_closed(),
          set.is_open(), set.is_simple(), set.is_convex()},
         "info");
  });
}

plumb_status plumb_solid_contains(const plumb_solid* solid, const double* xyz, std::size_t count,
                                  bool* inside, const plumb_context* context, plumb_error** error) {
  return guarded(error, [&] {
    Call call(context);
    const std::span<const double> numbers = finite(xyz, count, "xyz", 3);
    if (count > 0) need(inside, "inside");
    std::vector<Point3> points;
    points.reserve(count);
    for (std::size_t i = 0; i < count; ++i) {
      points.push_back({numbers[3 * i], numbers[3 * i + 1], numbers[3 * i + 2]});
    }
    std::vector<Mark> marked(count);
    need(solid, "solid").set.contains(points, marked, call);
    for (std::size_t i = 0; i < count; ++i) inside[i] = marked[i] != 0;
  });
}

plumb_status plumb_solid_locate(const plumb_solid* solid, const plumb_numbers* points,
                                plumb_location* locations, std::size_t count,
                                const plumb_context* context, plumb_error** error) {
  return guarded(error, [&] {
    Call call(context);
    const std::span<const Rational> values = exactly(points, "points", 3, count);
    if (count > 0) need(locations, "locations");
    for (std::size_t i = 0; i < count; ++i) {
      locations[i] =
          location_of(need(solid, "solid").set.locate(point_at(values.subspan(3 * i, 3)), call));
    }
  });
}

plumb_status plumb_solid_shoot(const plumb_solid* solid, const plumb_numbers* ray, bool to_boundary,
                               bool* is_hit, plumb_location* location, plumb_numbers** point,
                               const plumb_context* context, plumb_error** error) {
  return shoot(solid, ray, 3, to_boundary, is_hit, location, point, context, error, point_at,
               location_of, [](const RationalPoint3& p) { return numbers_of(p); });
}

plumb_status plumb_solid_volume(const plumb_solid* solid, plumb_numbers** out,
                                const plumb_context* context, plumb_error** error) {
  return make(out, error, [&] {
    Call call(context);
    const std::optional<Rational> volume = need(solid, "solid").set.volume(call);
    return numbers_of(volume ? std::vector<Rational>{*volume} : std::vector<Rational>());
  });
}

plumb_status plumb_solid_centroid(const plumb_solid* solid, plumb_numbers** out,
                                  const plumb_context* context, plumb_error** error) {
  return make(out, error, [&] {
    Call call(context);
    const auto point = coordinates(marked_centroid(need(solid, "solid").set.complex(), call));
    return numbers_of(point.value_or(std::vector<Rational>()));
  });
}

plumb_status plumb_solid_surface_area(const plumb_solid* solid, double* out,
                                      const plumb_context* context, plumb_error** error) {
  return guarded(error, [&] {
    need(out, "out");
    Call call(context);
    const std::optional<double> area = surface_area(need(solid, "solid").set.complex(), call);
    *out = area.value_or(std::numeric_limits<double>::infinity());
  });
}

plumb_status plumb_solid_convexity(const plumb_solid* solid, bool* is_convex,
                                   std::uint64_t* reflex_edges, plumb_indices** failing,
                                   const plumb_context* context, plumb_error** error) {
  if (failing != nullptr) *failing = nullptr;
  return guarded(error, [&] {
    need(is_convex, "is_convex");
    Call call(context);
    deliver(convexity_of_set(need(solid, "solid").set, call), is_convex, reflex_edges, failing);
  });
}

// --- convex pieces ------------------------------------------------------------------------------

plumb_status plumb_solid_decompose(const plumb_solid* solid, int method, bool is_closed,
                                   plumb_solid_list** out, const plumb_context* context,
                                   plumb_error** error) {
  return make(out, error, [&] {
    Call call(context);
    const DecomposeOptions options{method_of(method), is_closed};
    ConvexPieces found = decompose(need(solid, "solid").set, options, call);
    plumb_solid_list list;
    for (Nef3& piece : found.pieces) list.sets.push_back({std::move(piece)});
    return list;
  });
}

std::size_t plumb_solid_list_count(const plumb_solid_list* list) {
  return list != nullptr ? list->sets.size() : 0;
}
const plumb_solid* plumb_solid_list_at(const plumb_solid_list* list, std::size_t i) {
  return i < plumb_solid_list_count(list) ? &list->sets[i] : nullptr;
}
void plumb_solid_list_free(plumb_solid_list* list) { delete list; }
