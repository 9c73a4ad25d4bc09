// Maps, their checks, half-edge structures and overlays.
//
// A report flattens what C cannot walk, once, when it is made: defects, regions and warnings. An
// overlay shares the reports of its maps, because writers need them.
// Tested by tests/c/interface_test.c.
#include "files.h"
#include "handles.h"
#include "pictures.h"
#include "plumb/dcel/dcel.h"
#include "plumb/io/map_io.h"
#include "plumb/io/map_report_io.h"
#include "plumb/io/plane/map_overlay_writer.h"
#include "plumb/picture/overlay_svg.h"
#include "plumb/picture/plane_html.h"
#include "plumb/plane/map_check.h"
#include "plumb/plane/map_overlay.h"
#include "plumb/plane/plane_arrays.h"
#include "plumb/plane/plane_rounding.h"
#include "plumb/predicates/rounding.h"

struct plumb_map {
  plumb::Map map;
  std::vector<double> xy;
};

struct plumb_map_report {
  struct Defect {
    std::vector<std::uint32_t> edges;  // Pairs of vertices.
    std::string x, y;                  // Empty if there is no point.
  };

  std::shared_ptr<const plumb::MapReport> report;
  std::vector<Defect> defects;
  std::vector<std::vector<std::uint32_t>> regions;  // The cycles around each, the outer one first.
  plumb_notes warnings;
};

struct plumb_dcel {
  std::vector<double> xy;
  std::vector<std::uint32_t> origin, next, prev, face, leaving;
  std::size_t faces = 0;
};

struct plumb_overlay {
  std::shared_ptr<const plumb::MapReport> first, second;
  plumb::MapOverlay overlay;
  plumb::OverlayAreas areas;
  std::vector<std::uint32_t> regions;  // Pairs.
};

namespace plumb::c {
namespace {

plumb_map map_handle(Map map) {
  std::vector<double> xy = coordinates_of(map.points);
  return {std::move(map), std::move(xy)};
}

/// Sets the cycles. Corners are checked by check_map(), and here for the writer, which does not.
Map with_cycles(PointTable2 points, std::span<const std::uint32_t> begin,
                std::span<const std::uint32_t> corners) {
  if (begin.front() != 0 || begin.back() != corners.size() ||
      !std::is_sorted(begin.begin(), begin.end())) {
    fail_argument("cycle_begin does not ascend from 0 to the number of corners");
  }
  const auto is_bad = [&](std::uint32_t corner) { return corner >= points.size(); };
  if (std::any_of(corners.begin(), corners.end(), is_bad)) {
    throw Error(ErrorCode::BadIndex, "a corner is no index of a point");
  }
  Map map;
  map.points = std::move(points);
  map.corners.assign(corners.begin(), corners.end());
  map.cycle_begin.assign(begin.begin(), begin.end());
  return map;
}

MapCheckOptions check_options(const plumb_map_options* options) {
  const plumb_map_options asked = options_of(options, PLUMB_MAP_OPTIONS_INIT);
  MapCheckOptions result;
  switch (asked.outer) {
    case PLUMB_OUTER_LISTED:
      result.outer = OuterRule::Listed;
      break;
    case PLUMB_OUTER_INFER:
      result.outer = OuterRule::Infer;
      break;
    case PLUMB_OUTER_IGNORE:
      result.outer = OuterRule::Ignore;
      break;
    default:
      fail_argument("outer is no constant of plumb_outer");
  }
  result.merge_vertices = asked.merge_vertices;
  result.name_places = asked.name_places;
  result.max_defects = asked.max_defects;
  return result;
}

plumb_map_report report_handle(MapReport found) {
  plumb_map_report handle;
  for (const MapDefect& defect : found.defects) {
    plumb_map_report::Defect flat;
    for (const MapEdge& edge : defect.edges) {
      flat.edges.push_back(edge.from);
      flat.edges.push_back(edge.to);
    }
    if (defect.point) {
      flat.x = exact_text(defect.point->x);
      flat.y = exact_text(defect.point->y);
    }
    handle.defects.push_back(std::move(flat));
  }
  for (const MapRegion& region : found.regions) {
    std::vector<std::uint32_t> cycles;
    if (region.outer) cycles.push_back(*region.outer);
    cycles.insert(cycles.end(), region.holes.begin(), region.holes.end());
    handle.regions.push_back(std::move(cycles));
  }
  for (const MapWarning& warning : found.warnings) handle.warnings.texts.push_back(warning.text);
  handle.report = std::make_shared<const MapReport>(std::move(found));
  return handle;
}

int verdict_of(MapVerdict verdict) {
  switch (verdict) {
    case MapVerdict::Valid:
      return PLUMB_MAP_VALID;
    case MapVerdict::NotAPlanarSubdivision:
      return PLUMB_MAP_NOT_PLANAR;
    case MapVerdict::Open:
      return PLUMB_MAP_OPEN;
    default:
      return PLUMB_MAP_SUPERPOSED;
  }
}

/// Fills all but the coordinates.
plumb_dcel dcel_handle(const Dcel& dcel) {
  plumb_dcel handle;
  for (std::uint32_t h = 0; h < dcel.halfedge_slots(); ++h) {
    const HalfedgeId id(h);
    handle.origin.push_back(dcel.origin(id).value());
    handle.next.push_back(dcel.next(id).value());
    handle.prev.push_back(dcel.prev(id).value());
    handle.face.push_back(dcel.face(id).value());
  }
  for (std::uint32_t v = 0; v < dcel.vertex_slots(); ++v) {
    const VertexId id(v);
    const bool leaves = dcel.contains(id) && !dcel.is_isolated(id);
    handle.leaving.push_back(leaves ? dcel.halfedge(id).value() : kNone);
  }
  handle.faces = dcel.face_slots();
  return handle;
}

/// Returns the names of regions, which are called by the listed cycle around them.
std::vector<std::string> region_names(const MapReport& report) {
  std::vector<std::string> names;
  for (const MapRegion& region : report.regions) {
    names.push_back(region.outer ? std::to_string(*region.outer + 1) : "");
  }
  return names;
}

void write_overlay_picture(std::ostream& out, const plumb_overlay& overlay,
                           const std::string& title, bool as_page) {
  const std::string svg = written([&](std::ostream& drawing) {
                            write_overlay_svg(drawing, overlay.overlay,
                                              {.title = title,
                                               .first_names = region_names(*overlay.first),
                                               .second_names = region_names(*overlay.second)});
                          }).bytes;
  if (as_page) {
    write_plane_html(out, svg, title);
  } else {
    out << svg;
  }
}

void write_overlay_cells(std::ostream& out, const plumb_overlay& overlay, OverlayReport report,
                         const PlaneWriteOptions& options, Context& context) {
  std::optional<RoundedSubdivision> rounded;
  const PlaneComplex& complex = overlay.overlay.complex;
  if (options.grid) {
    rounded = round_to_grid(complex, *options.grid, context);
  } else if (options.rounding == OutputRounding::Valid) {
    rounded = round_to_doubles(complex, context);
  }
  if (rounded) report.rounded = &*rounded;
  write_overlay_geojson(out, report);
}

}  // namespace
}  // namespace plumb::c

using namespace plumb;
using namespace plumb::c;

// --- maps ---------------------------------------------------------------------------------------

plumb_status plumb_map_from_cycles(const double* xy, std::size_t point_count,
                                   const std::uint32_t* cycle_begin, std::size_t cycle_count,
                                   const std::uint32_t* corners, std::size_t corner_count,
                                   plumb_map** out, plumb_error** error) {
  return make(out, error, [&] {
    return map_handle(with_cycles(points_of(finite(xy, point_count, "xy", 2)),
                                  offsets(cycle_begin, cycle_count, "cycle_begin"),
                                  array(corners, corner_count, "corners")));
  });
}

plumb_status plumb_map_from_exact_cycles(const plumb_numbers* points,
                                         const std::uint32_t* cycle_begin, std::size_t cycle_count,
                                         const std::uint32_t* corners, std::size_t corner_count,
                                         plumb_map** out, plumb_error** error) {
  return make(out, error, [&] {
    PointTable2 table;
    for (const RationalPoint2& p : points2(points, "points")) table.push_back(p.x, p.y);
    return map_handle(with_cycles(std::move(table),
                                  offsets(cycle_begin, cycle_count, "cycle_begin"),
                                  array(corners, corner_count, "corners")));
  });
}

plumb_status plumb_map_read(const char* text, std::size_t size, const plumb_read_options* options,
                            plumb_map** out, const plumb_context* context, plumb_error** error) {
  return make(out, error, [&] {
    Call call(context);
    return map_handle(
        read_map(bytes_of(text, size), read_options(options, name_of(options)), call));
  });
}

plumb_status plumb_map_read_file(const char* path, const plumb_read_options* options,
                                 plumb_map** out, bool* is_polygons, plumb_notes** notes,
                                 const plumb_context* context, plumb_error** error) {
  return make_with_notes(out, notes, error, [&](plumb_notes& told) {
    Call call(context);
    const std::string name = text(path, "path");
    MapFile file = read_map_or_polygons(name, read_options(options, name), call);
    add_notes(told, file.notes);
    if (file.dropped > 0) {
      add_notes(told, {"lines and points that were passed over: " + std::to_string(file.dropped)});
    }
    if (is_polygons != nullptr) *is_polygons = file.is_polygons;
    return map_handle(std::move(file.map));
  });
}

plumb_status plumb_map_write(const plumb_map* map, plumb_bytes** out, plumb_error** error) {
  return make(out, error, [&] {
    need(map, "map");
    return written([&](std::ostream& stream) { write_map(stream, map->map); });
  });
}

std::size_t plumb_map_point_count(const plumb_map* map) {
  return map != nullptr ? map->map.vertex_count() : 0;
}
std::size_t plumb_map_cycle_count(const plumb_map* map) {
  return map != nullptr ? map->map.cycle_count() : 0;
}
const double* plumb_map_points(const plumb_map* map) {
  return map != nullptr ? map->xy.data() : nullptr;
}
const std::uint32_t* plumb_map_cycle_begin(const plumb_map* map) {
  return map != nullptr ? map->map.cycle_begin.data() : nullptr;
}
const std::uint32_t* plumb_map_corners(const plumb_map* map) {
  return map != nullptr ? map->map.corners.data() : nullptr;
}
void plumb_map_free(plumb_map* map) { delete map; }

// --- reports ------------------------------------------------------------------------------------

plumb_status plumb_map_check(const plumb_map* map, const plumb_map_options* options,
                             plumb_map_report** out, const plumb_context* context,
                             plumb_error** error) {
  return make(out, error, [&] {
    Call call(context);
    return report_handle(check_map(need(map, "map").map, check_options(options), call));
  });
}

plumb_status plumb_map_report_count(const plumb_map_report* report, plumb_map_counts* counts,
                                    plumb_error** error) {
  return guarded(error, [&] {
    const MapReport& of = *need(report, "report").report;
    fill(counts,
         {0, verdict_of(of.verdict), of.vertices, of.edges, of.cycles, of.components,
          of.regions.size(), of.counts.duplicate, of.counts.open, of.counts.crossing,
          of.counts.twin, of.counts.mixed.value_or(0), of.counts.nested},
         "counts");
  });
}

int plumb_map_report_verdict(const plumb_map_report* report) {
  return report != nullptr ? verdict_of(report->report->verdict) : PLUMB_MAP_VALID;
}

std::size_t plumb_map_report_defect_count(const plumb_map_report* report) {
  return report != nullptr ? report->defects.size() : 0;
}

plumb_status plumb_map_report_defect(const plumb_map_report* report, std::size_t i,
                                     plumb_map_defect* defect, plumb_error** error) {
  return guarded(error, [&] {
    if (i >= need(report, "report").defects.size()) {
      throw Error(ErrorCode::BadIndex, "there is no such defect");
    }
    const MapDefect& of = report->report->defects[i];
    const plumb_map_report::Defect& flat = report->defects[i];
    const bool has_point = of.point.has_value();
    fill(defect,
         {0, static_cast<int>(of.kind), of.cycles.data(), of.cycles.size(), flat.edges.data(),
          flat.edges.size() / 2, has_point ? flat.x.c_str() : nullptr,
          has_point ? flat.y.c_str() : nullptr, of.near.x, of.near.y, of.hint.c_str()},
         "defect");
  });
}

const plumb_notes* plumb_map_report_warnings(const plumb_map_report* report) {
  return report != nullptr ? &report->warnings : nullptr;
}

const std::uint32_t* plumb_map_report_region(const plumb_map_report* report, std::size_t i,
                                             std::size_t* count) {
  const bool is_there = report != nullptr && i < report->regions.size();
  if (count != nullptr) *count = is_there ? report->regions[i].size() : 0;
  return is_there ? report->regions[i].data() : nullptr;
}

plumb_status plumb_map_report_write(const plumb_map_report* report, const char* format,
                                    const char* title, plumb_bytes** out, plumb_error** error) {
  return make(out, error, [&]() -> plumb_bytes {
    const std::string name = text(format, "format");
    const MapReport& of = *need(report, "report").report;
    if (name == "text") {
      return written([&](std::ostream& stream) { write_map_report_text(stream, of); });
    }
    if (name == "json") {
      return written([&](std::ostream& stream) { write_map_report_json(stream, of); });
    }
    if (name == "geojson") {
      return written([&](std::ostream& stream) { write_map_report_geojson(stream, of); });
    }
    return {picture_of(of, picture(name, text_or_empty(title)))};
  });
}

plumb_status plumb_map_report_map(const plumb_map_report* report, plumb_map** out,
                                  plumb_error** error) {
  return make(out, error, [&] { return map_handle(need(report, "report").report->map); });
}

plumb_status plumb_map_report_to_set(const plumb_map_report* report, const bool* chosen,
                                     std::size_t count, bool is_closed, plumb_plane_set** out,
                                     const plumb_context* context, plumb_error** error) {
  return make(out, error, [&] {
    Call call(context);
    std::vector<std::uint8_t> flags;
    for (const bool is_chosen : array(chosen, count, "chosen")) flags.push_back(is_chosen ? 1 : 0);
    return Nef2::subdivision(*need(report, "report").report, flags, boundary(is_closed), call);
  });
}

void plumb_map_report_free(plumb_map_report* report) { delete report; }

// --- half-edges ---------------------------------------------------------------------------------

plumb_status plumb_map_report_dcel(const plumb_map_report* report, plumb_dcel** out,
                                   plumb_error** error) {
  return make(out, error, [&] {
    const MapReport& of = *need(report, "report").report;
    plumb_dcel handle = dcel_handle(to_dcel(of).dcel);
    handle.xy = coordinates_of(of.map.points);
    handle.leaving.resize(of.map.vertex_count(), kNone);
    return handle;
  });
}

std::size_t plumb_dcel_vertex_count(const plumb_dcel* dcel) {
  return dcel != nullptr ? dcel->leaving.size() : 0;
}
std::size_t plumb_dcel_halfedge_count(const plumb_dcel* dcel) {
  return dcel != nullptr ? dcel->origin.size() : 0;
}
std::size_t plumb_dcel_face_count(const plumb_dcel* dcel) {
  return dcel != nullptr ? dcel->faces : 0;
}
const double* plumb_dcel_points(const plumb_dcel* dcel) {
  return dcel != nullptr ? dcel->xy.data() : nullptr;
}
const std::uint32_t* plumb_dcel_origin(const plumb_dcel* dcel) {
  return dcel != nullptr ? dcel->origin.data() : nullptr;
}
const std::uint32_t* plumb_dcel_next(const plumb_dcel* dcel) {
  return dcel != nullptr ? dcel->next.data() : nullptr;
}
const std::uint32_t* plumb_dcel_prev(const plumb_dcel* dcel) {
  return dcel != nullptr ? dcel->prev.data() : nullptr;
}
const std::uint32_t* plumb_dcel_face(const plumb_dcel* dcel) {
  return dcel != nullptr ? dcel->face.data() : nullptr;
}
const std::uint32_t* plumb_dcel_leaving(const plumb_dcel* dcel) {
  return dcel != nullptr ? dcel->leaving.data() : nullptr;
}
void plumb_dcel_free(plumb_dcel* dcel) { delete dcel; }

// --- overlays -----------------------------------------------------------------------------------

plumb_status plumb_overlay_new(const plumb_map_report* first, const plumb_map_report* second,
                               plumb_overlay** out, const plumb_context* context,
                               plumb_error** error) {
  return make(out, error, [&] {
    Call call(context);
    plumb_overlay handle;
    handle.first = need(first, "first").report;
    handle.second = need(second, "second").report;
    handle.overlay = overlay_maps(*handle.first, *handle.second, call);
    handle.areas = measure(handle.overlay, *handle.first, *handle.second, call);
    PLUMB_CHECK(handle.areas.add_up());
    for (const MapOverlay::Origin& origin : handle.overlay.origin) {
      handle.regions.push_back(origin.first);
      handle.regions.push_back(origin.second);
    }
    return handle;
  });
}

std::size_t plumb_overlay_face_count(const plumb_overlay* overlay) {
  return overlay != nullptr ? overlay->overlay.origin.size() : 0;
}
const std::uint32_t* plumb_overlay_regions(const plumb_overlay* overlay) {
  return overlay != nullptr ? overlay->regions.data() : nullptr;
}

plumb_status plumb_overlay_areas(const plumb_overlay* overlay, plumb_numbers** out,
                                 plumb_error** error) {
  return make(out, error, [&] { return numbers_of(need(overlay, "overlay").areas.cell); });
}

plumb_status plumb_overlay_dcel(const plumb_overlay* overlay, plumb_dcel** out,
                                plumb_error** error) {
  return make(out, error, [&] {
    const PlaneComplex& complex = need(overlay, "overlay").overlay.complex;
    plumb_dcel handle = dcel_handle(complex.dcel);
    for (const std::uint32_t point : complex.vertex_point) {
      const Point2 at = approx(complex.points, point);
      handle.xy.push_back(at.x);
      handle.xy.push_back(at.y);
    }
    return handle;
  });
}

plumb_status plumb_overlay_write(const plumb_overlay* overlay, const char* format,
                                 const plumb_write_options* options, const char* title,
                                 plumb_bytes** out, const plumb_context* context,
                                 plumb_error** error) {
  return make(out, error, [&] {
    Call call(context);
    const std::string name = text(format, "format");
    const plumb_overlay& of = need(overlay, "overlay");
    const PlaneWriteOptions asked = write_options(options);
    const OverlayReport report{*of.first, *of.second, of.overlay, of.areas};
    return written([&](std::ostream& stream) {
      if (name == "text") return write_overlay_text(stream, report);
      if (name == "json") return write_overlay_json(stream, report);
      if (name == "geojson") return write_overlay_cells(stream, of, report, asked, call);
      if (name != "svg" && name != "html") fail_format(name, "text, json, geojson, svg, html");
      write_overlay_picture(stream, of, text_or_empty(title), name == "html");
    });
  });
}

void plumb_overlay_free(plumb_overlay* overlay) { delete overlay; }
