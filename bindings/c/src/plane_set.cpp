// Sets of the plane: made of arrays and files, combined, rounded, measured and cut.
//
// The functions that all sets have are made by PLUMB_C_SET (sets.h). The engine requires that
// chains ascend and that their corners are indices of points; check_chains() checks both here,
// because a caller of C may pass anything. write_options() serves the overlays of maps, too.
// Tested by tests/c/interface_test.c.
#include "files.h"
#include "handles.h"
#include "pictures.h"
#include "plumb/convex/plane_convexity.h"
#include "plumb/convex/plane_partition.h"
#include "plumb/io/plane_io.h"
#include "plumb/model/distance.h"
#include "plumb/plane/plane_arrays.h"
#include "plumb/plane/plane_rounding.h"
#include "plumb/predicates/rounding.h"
#include "sets.h"

struct plumb_shapes {
  plumb::PlaneShapes shapes;
  std::vector<double> xy;
};

namespace plumb::c {
namespace {

PointTable2 table_of(const plumb_numbers* numbers, const char* name) {
  PointTable2 table;
  for (const RationalPoint2& p : points2(numbers, name)) table.push_back(p.x, p.y);
  return table;
}

Line2 line_of(const plumb_numbers* numbers) {
  const std::span<const Rational> v = exactly(numbers, "line", 3);
  return Line2::from_coefficients(v[0], v[1], v[2]);
}

/// Throws unless all corners are indices of points, and the offsets ascend to their number.
void check_chains(std::span<const std::uint32_t> begin, std::span<const std::uint32_t> corners,
                  std::size_t points) {
  if (begin.front() != 0 || begin.back() != corners.size() ||
      !std::is_sorted(begin.begin(), begin.end())) {
    fail_argument("chain_begin does not ascend from 0 to the number of corners");
  }
  const auto is_bad = [points](std::uint32_t corner) { return corner >= points; };
  if (std::any_of(corners.begin(), corners.end(), is_bad)) {
    throw Error(ErrorCode::BadIndex, "a corner is no index of a point");
  }
}

PlaneFormat format_named(const std::string& name) {
  if (name == "wkt") return PlaneFormat::Wkt;
  if (name == "geojson") return PlaneFormat::GeoJson;
  if (name == "wkb") return PlaneFormat::Wkb;
  if (name == "dxf") return PlaneFormat::Dxf;
  if (name == "nef2") return PlaneFormat::Nef2;
  fail_format(name, "wkt, geojson, wkb, dxf, nef2");
}

PlaneFormat format_of(const std::string& path) {
  if (const std::optional<PlaneFormat> format = plane_format_of(path)) return *format;
  throw Error(ErrorCode::UnknownFormat, "the extension names no format of sets of the plane",
              {path});
}

Nef2 set_of_read(PlaneRead read, plumb_notes& notes) {
  add_notes(notes, read.notes);
  add_warnings(notes, read.warnings);
  return std::move(read.set);
}

PlaneText prepared(const plumb_plane_set* set, PlaneFormat format,
                   const plumb_write_options* options, plumb_notes& notes, Context& context) {
  PlaneText text(need(set, "set").set, format, write_options(options), context);
  const std::string closing = text.losses().closing();
  if (!closing.empty()) add_notes(notes, {closing});
  add_warnings(notes, text.losses().sentences());
  return text;
}

plumb_location location_of(const PlaneLocation& at) {
  if (at.vertex.is_valid()) return {0, at.vertex.value(), at.marked};
  if (at.edge.is_valid()) return {1, at.edge.value(), at.marked};
  return {2, at.face.value(), at.marked};
}

RationalPoint2 point2_at(std::span<const Rational> values) { return {values[0], values[1]}; }

PartitionMethod method_of(int method) {
  switch (method) {
    case PLUMB_PARTITION_BEST:
      return PartitionMethod::Best;
    case PLUMB_PARTITION_CUTS:
      return PartitionMethod::Cuts;
    case PLUMB_PARTITION_DIAGONALS:
      return PartitionMethod::Diagonals;
    case PLUMB_PARTITION_OPTIMAL:
      return PartitionMethod::Optimal;
    default:
      fail_argument("method is no constant of plumb_partition");
  }
}

}  // namespace

PlaneWriteOptions write_options(const plumb_write_options* options) {
  const plumb_write_options asked = options_of(options, PLUMB_WRITE_OPTIONS_INIT);
  PlaneWriteOptions result;
  if (asked.raw && asked.grid != nullptr) {
    throw Error(ErrorCode::Usage, "raw and grid exclude each other");
  }
  if (asked.raw) result.rounding = OutputRounding::Nearest;
  if (asked.grid != nullptr) {
    result.grid = exactly(asked.grid, "grid", 1).front();
    if (result.grid->sign() <= 0) fail_argument("grid is not positive");
  }
  return result;
}

}  // namespace plumb::c

using namespace plumb;
using namespace plumb::c;

PLUMB_C_SET(plumb_plane_set, Nef2)

// --- made of arrays -----------------------------------------------------------------------------

plumb_status plumb_plane_set_half_plane(const plumb_numbers* line, bool is_closed,
                                        plumb_plane_set** out, plumb_error** error) {
  return make(out, error, [&] { return Nef2::half_plane(line_of(line), boundary(is_closed)); });
}

plumb_status plumb_plane_set_line(const plumb_numbers* line, plumb_plane_set** out,
                                  plumb_error** error) {
  return make(out, error, [&] { return Nef2::line(line_of(line)); });
}

plumb_status plumb_plane_set_polygons(const double* xy, std::size_t point_count,
                                      const std::uint32_t* chain_begin, std::size_t chain_count,
                                      const std::uint32_t* corners, std::size_t corner_count,
                                      int rule, bool is_closed, plumb_plane_set** out,
                                      const plumb_context* context, plumb_error** error) {
  return make(out, error, [&] {
    Call call(context);
    const PointTable2 points = points_of(finite(xy, point_count, "xy", 2));
    const std::span<const std::uint32_t> begin = offsets(chain_begin, chain_count, "chain_begin");
    const std::span<const std::uint32_t> of = array(corners, corner_count, "corners");
    check_chains(begin, of, point_count);
    return Nef2::polygons(points, of, begin, rule_of(rule).value_or(WindingRule::EvenOdd),
                          boundary(is_closed), call);
  });
}

plumb_status plumb_plane_set_polygon(const plumb_numbers* points, bool is_closed,
                                     plumb_plane_set** out, const plumb_context* context,
                                     plumb_error** error) {
  return make(out, error, [&] {
    Call call(context);
    const PointTable2 table = table_of(points, "points");
    std::vector<std::uint32_t> corners(table.size());
    for (std::uint32_t i = 0; i < corners.size(); ++i) corners[i] = i;
    const std::array<std::uint32_t, 2> begin{0, static_cast<std::uint32_t>(table.size())};
    const std::size_t chains = table.size() == 0 ? 0 : 1;
    return Nef2::polygons(table, corners, std::span(begin).first(chains + 1), WindingRule::NonZero,
                          boundary(is_closed), call);
  });
}

plumb_status plumb_plane_set_polylines(const double* xy, std::size_t point_count,
                                       const std::uint32_t* chain_begin, std::size_t chain_count,
                                       const std::uint32_t* corners, std::size_t corner_count,
                                       plumb_plane_set** out, const plumb_context* context,
                                       plumb_error** error) {
  return make(out, error, [&] {
    Call call(context);
    const PointTable2 points = points_of(finite(xy, point_count, "xy", 2));
    const std::span<const std::uint32_t> begin = offsets(chain_begin, chain_count, "chain_begin");
    const std::span<const std::uint32_t> of = array(corners, corner_count, "corners");
    check_chains(begin, of, point_count);
    return Nef2::polylines(points, of, begin, call);
  });
}

plumb_status plumb_plane_set_points(const plumb_numbers* points, plumb_plane_set** out,
                                    const plumb_context* context, plumb_error** error) {
  return make(out, error, [&] {
    Call call(context);
    return Nef2::points(table_of(points, "points"), call);
  });
}

// --- files and pictures -------------------------------------------------------------------------

plumb_status plumb_plane_set_read(const char* bytes, std::size_t size,
                                  const plumb_read_options* options, plumb_plane_set** out,
                                  plumb_notes** notes, const plumb_context* context,
                                  plumb_error** error) {
  return make_with_notes(out, notes, error, [&](plumb_notes& told) {
    Call call(context);
    const std::string name = name_of(options);
    const std::string_view given = bytes_of(bytes, size);
    return set_of_read(
        read_plane_set(given, plane_format_of(name, given), read_options(options, name), call),
        told);
  });
}

plumb_status plumb_plane_set_read_file(const char* path, const plumb_read_options* options,
                                       plumb_plane_set** out, plumb_notes** notes,
                                       const plumb_context* context, plumb_error** error) {
  return make_with_notes(out, notes, error, [&](plumb_notes& told) {
    Call call(context);
    const std::string name = text(path, "path");
    return set_of_read(read_plane_set_file(name, {}, read_options(options, name), call), told);
  });
}

plumb_status plumb_plane_set_write(const plumb_plane_set* set, const char* format,
                                   const plumb_write_options* options, plumb_bytes** out,
                                   plumb_notes** notes, const plumb_context* context,
                                   plumb_error** error) {
  return make_with_notes(out, notes, error, [&](plumb_notes& told) {
    Call call(context);
    Context& own = call;
    const PlaneText ready = prepared(set, format_named(text(format, "format")), options, told, own);
    return written([&](std::ostream& stream) { ready.write(stream, own); });
  });
}

plumb_status plumb_plane_set_write_file(const plumb_plane_set* set, const char* path,
                                        const char* format, const plumb_write_options* options,
                                        plumb_notes** notes, const plumb_context* context,
                                        plumb_error** error) {
  if (notes != nullptr) *notes = nullptr;
  return guarded(error, [&] {
    Call call(context);
    Context& own = call;
    auto told = std::make_unique<plumb_notes>();
    const std::string file = text(path, "path");
    const PlaneFormat wanted = format != nullptr ? format_named(format) : format_of(file);
    const PlaneText ready = prepared(set, wanted, options, *told, own);
    write_file(file, [&](std::ostream& stream) { ready.write(stream, own); });
    if (notes != nullptr) *notes = told.release();
  });
}

plumb_status plumb_plane_set_draw(const plumb_plane_set* set, const char* format, const char* title,
                                  plumb_bytes** out, const plumb_context* context,
                                  plumb_error** error) {
  return make(out, error, [&] {
    Call call(context);
    return picture_of(need(set, "set").set, picture(text(format, "format"), text_or_empty(title)),
                      call);
  });
}

// --- operations and questions -------------------------------------------------------------------

plumb_status plumb_plane_set_transform(const plumb_plane_set* set, const plumb_numbers* map,
                                       plumb_plane_set** out, const plumb_context* context,
                                       plumb_error** error) {
  return make(out, error, [&] {
    Call call(context);
    const std::span<const Rational> v = exactly(map, "map", 6);
    return need(set, "set").set.transformed(AffineMap2{v[0], v[1], v[2], v[3], v[4], v[5]}, call);
  });
}

plumb_status plumb_plane_set_round(const plumb_plane_set* set, const plumb_numbers* step,
                                   plumb_plane_set** out, plumb_rounding_report* report,
                                   const plumb_context* context, plumb_error** error) {
  return make(out, error, [&] {
    Call call(context);
    const Nef2& of = need(set, "set").set;
    RoundedSet rounded = step != nullptr ? round_to_grid(of, exactly(step, "step", 1).front(), call)
                                         : round_to_doubles(of, call);
    if (report != nullptr) {
      const PlaneRoundingReport& told = rounded.report;
      fill(report,
           {0, told.vertices_moved, told.vertices_merged, told.edges_bent, told.edges_folded,
            told.collapsed, told.largest_move},
           "report");
    }
    return std::move(rounded.set);
  });
}

plumb_status plumb_plane_set_describe(const plumb_plane_set* set, plumb_plane_set_info* info,
                                      plumb_error** error) {
  return guarded(error, [&] {
    const Nef2& of = need(set, "set").set;
    const PlaneCounts counts = of.counts();
    fill(info,
         {0, counts.vertices, counts.edges, counts.faces, counts.marked_faces, of.bytes(),
          of.is_empty(), of.is_whole(), of.is_bounded(), of.is_closed(), of.is_open()},
         "info");
  });
}

plumb_status plumb_plane_set_contains(const plumb_plane_set* set, const double* xy,
                                      std::size_t count, bool* inside, const plumb_context* context,
                                      plumb_error** error) {
  return guarded(error, [&] {
    Call call(context);
    const std::span<const double> numbers = finite(xy, count, "xy", 2);
    if (count > 0) need(inside, "inside");
    for (std::size_t i = 0; i < count; ++i) {
      const Point2 point{numbers[2 * i], numbers[2 * i + 1]};
      inside[i] = need(set, "set").set.contains(point, call);
    }
  });
}

plumb_status plumb_plane_set_distance(const plumb_plane_set* a, const plumb_plane_set* b,
                                      plumb_numbers** out, plumb_location* cells,
                                      const plumb_context* context, plumb_error** error) {
  return find_distance(a, b, out, cells, context, error, location_of);
}

plumb_status plumb_plane_set_locate(const plumb_plane_set* set, const plumb_numbers* points,
                                    plumb_location* locations, std::size_t count,
                                    const plumb_context* context, plumb_error** error) {
  return guarded(error, [&] {
    Call call(context);
    const std::span<const Rational> values = exactly(points, "points", 2, count);
    if (count > 0) need(locations, "locations");
    for (std::size_t i = 0; i < count; ++i) {
      locations[i] =
          location_of(need(set, "set").set.locate(point2_at(values.subspan(2 * i, 2)), call));
    }
  });
}

plumb_status plumb_plane_set_shoot(const plumb_plane_set* set, const plumb_numbers* ray,
                                   bool to_boundary, bool* is_hit, plumb_location* location,
                                   plumb_numbers** point, const plumb_context* context,
                                   plumb_error** error) {
  return shoot(set, ray, 2, to_boundary, is_hit, location, point, context, error, point2_at,
               location_of, [](const RationalPoint2& p) { return numbers_of(p); });
}

plumb_status plumb_plane_set_area(const plumb_plane_set* set, plumb_numbers** out,
                                  const plumb_context* context, plumb_error** error) {
  return make(out, error, [&] {
    Call call(context);
    const std::optional<Rational> area = need(set, "set").set.area(call);
    return numbers_of(area ? std::vector<Rational>{*area} : std::vector<Rational>());
  });
}

plumb_status plumb_plane_set_convexity(const plumb_plane_set* set, bool* is_convex,
                                       std::uint64_t* reflex_corners, std::uint64_t* parts,
                                       const plumb_context* context, plumb_error** error) {
  return guarded(error, [&] {
    need(is_convex, "is_convex");
    Call call(context);
    const PlaneConvexity found = convexity_of_set(need(set, "set").set, call);
    *is_convex = found.is_convex;
    if (reflex_corners != nullptr) *reflex_corners = found.reflex_corners;
    if (parts != nullptr) *parts = found.parts;
  });
}

// --- arrays out ---------------------------------------------------------------------------------

plumb_status plumb_plane_set_shapes(const plumb_plane_set* set, plumb_shapes** out,
                                    const plumb_context* context, plumb_error** error) {
  return make(out, error, [&] {
    Call call(context);
    plumb_shapes result;
    result.shapes = to_shapes(need(set, "set").set.parts(call), call);
    result.xy = coordinates_of(result.shapes.points);
    return result;
  });
}

std::size_t plumb_shapes_point_count(const plumb_shapes* shapes) {
  return shapes != nullptr ? shapes->shapes.points.size() : 0;
}
std::size_t plumb_shapes_polygon_count(const plumb_shapes* shapes) {
  return shapes != nullptr ? shapes->shapes.polygon_count() : 0;
}
std::size_t plumb_shapes_ring_count(const plumb_shapes* shapes) {
  return shapes != nullptr ? shapes->shapes.ring_count() : 0;
}
std::size_t plumb_shapes_line_count(const plumb_shapes* shapes) {
  return shapes != nullptr ? shapes->shapes.line_count() : 0;
}
std::size_t plumb_shapes_single_count(const plumb_shapes* shapes) {
  return shapes != nullptr ? shapes->shapes.single_points.size() : 0;
}
const double* plumb_shapes_points(const plumb_shapes* shapes) {
  return shapes != nullptr ? shapes->xy.data() : nullptr;
}
const std::uint32_t* plumb_shapes_polygon_begin(const plumb_shapes* shapes) {
  return shapes != nullptr ? shapes->shapes.polygon_begin.data() : nullptr;
}
const std::uint32_t* plumb_shapes_ring_begin(const plumb_shapes* shapes) {
  return shapes != nullptr ? shapes->shapes.ring_begin.data() : nullptr;
}
const std::uint32_t* plumb_shapes_ring_corners(const plumb_shapes* shapes) {
  return shapes != nullptr ? shapes->shapes.ring_corners.data() : nullptr;
}
const std::uint32_t* plumb_shapes_line_begin(const plumb_shapes* shapes) {
  return shapes != nullptr ? shapes->shapes.line_begin.data() : nullptr;
}
const std::uint32_t* plumb_shapes_line_corners(const plumb_shapes* shapes) {
  return shapes != nullptr ? shapes->shapes.line_corners.data() : nullptr;
}
const std::uint32_t* plumb_shapes_singles(const plumb_shapes* shapes) {
  return shapes != nullptr ? shapes->shapes.single_points.data() : nullptr;
}

plumb_status plumb_shapes_exact_point(const plumb_shapes* shapes, std::size_t point,
                                      plumb_numbers** out, plumb_error** error) {
  return make(out, error, [&] {
    const PointTable2& points = need(shapes, "shapes").shapes.points;
    if (point >= points.size()) throw Error(ErrorCode::BadIndex, "there is no such point");
    return numbers_of(points.exact(static_cast<std::uint32_t>(point)));
  });
}

void plumb_shapes_free(plumb_shapes* shapes) { delete shapes; }

// --- convex pieces ------------------------------------------------------------------------------

plumb_status plumb_plane_set_decompose(const plumb_plane_set* set, int method, bool is_closed,
                                       plumb_plane_set_list** out, const plumb_context* context,
                                       plumb_error** error) {
  return make(out, error, [&] {
    Call call(context);
    const PartitionOptions options{method_of(method), is_closed};
    PlanePieces found = decompose(need(set, "set").set, options, call);
    plumb_plane_set_list list;
    for (Nef2& piece : found.pieces) list.sets.push_back({std::move(piece)});
    return list;
  });
}

std::size_t plumb_plane_set_list_count(const plumb_plane_set_list* list) {
  return list != nullptr ? list->sets.size() : 0;
}
const plumb_plane_set* plumb_plane_set_list_at(const plumb_plane_set_list* list, std::size_t i) {
  return i < plumb_plane_set_list_count(list) ? &list->sets[i] : nullptr;
}
void plumb_plane_set_list_free(plumb_plane_set_list* list) { delete list; }
