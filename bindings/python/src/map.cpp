// plumb.Map, plumb.MapReport and plumb.MapOverlay: planar maps as a user lists them, what a check
// says of them, and the overlay of two checked maps.
// Tests: tests/test_map.py.
#include "page.h"
#include "plane_traits.h"
#include "plumb/io/map_io.h"
#include "plumb/io/map_report_io.h"
#include "plumb/io/text/files.h"
#include "plumb/plane/map_check.h"
#include "plumb/plane/map_overlay.h"
#include "plumb/plane/plane_arrays.h"

namespace plumb::python {
namespace {

// --- maps -------------------------------------------------------------------------------------

Map map_from_cycles(Context&, const Coordinates2& points,
                    const std::vector<std::vector<std::uint32_t>>& cycles) {
  Map map;
  map.points = points_of(points.span());
  for (const std::vector<std::uint32_t>& cycle : cycles) map.add_cycle(cycle);
  return map;
}

Map map_from_arrays(Context&, const Coordinates2& points, const Indices& cycle_begin,
                    const Indices& corners) {
  return map_of_cycles(points.span(), cycle_begin.span(), corners.span());
}

OuterRule outer_rule(const std::string& name) {
  if (name == "listed") return OuterRule::Listed;
  if (name == "infer") return OuterRule::Infer;
  if (name == "ignore") return OuterRule::Ignore;
  throw Error(ErrorCode::BadArgument,
              "outer must be 'listed', 'infer' or 'ignore', not '" + name + "'");
}

MapReport checked(Context& context, const Map& map, const std::string& outer, bool merge_vertices,
                  std::uint64_t max_defects) {
  MapCheckOptions options;
  options.outer = outer_rule(outer);
  options.merge_vertices = merge_vertices;
  options.max_defects = max_defects;
  return check_map(map, options, context);
}

std::string repr_of(const Map& map) {
  return "<plumb.Map: " + std::to_string(map.vertex_count()) + " vertices, " +
         std::to_string(map.cycle_count()) + " cycles>";
}

std::monostate write_map_file(Context&, const Map& map, const Path& path) {
  OutputFile file(path.string());
  write_map(file.stream(), map);
  file.finish();
  file.commit();
  return {};
}

void bind_map_class(nb::module_& m) {
  nb::class_<Map> c(m, "Map",
                    "A planar map as a user lists it: points, and cycles of indices of points. "
                    "check() decides whether the cycles subdivide the plane.");
  def_run_static(c, "from_cycles", &map_from_cycles,
                 "Return the map of points, float64 (n, 2), and lists of indices of points. In a "
                 "valid map, the outer boundaries of faces run counter-clockwise, and all other "
                 "cycles run clockwise.",
                 "points"_a, "cycles"_a);
  def_run_static(
      c, "from_arrays", &map_from_arrays,
      "Return the map of points, float64 (n, 2), and cycles in flat arrays: cycle_begin, "
      "uint32 (cycles + 1,), and corners, uint32 (k,).",
      "points"_a, "cycle_begin"_a, "corners"_a);
  c.def_static(
      "read",
      [](const Path& path, bool exact_decimals, unsigned threads, std::optional<double> timeout,
         std::optional<std::uint64_t> memory_limit, nb::object progress) {
        ReadOptions options;
        options.exact_decimals = exact_decimals;
        MapFile file =
            run(CallLimits{threads, timeout, memory_limit, std::move(progress)},
                [&](Context& k) { return read_map_or_polygons(path.string(), options, k); });
        note(file.notes);
        if (file.dropped > 0) {
          warn({std::to_string(file.dropped) + " lines and points of " + path.string() +
                " are left out"});
        }
        return std::move(file.map);
      },
      "path"_a, "exact_decimals"_a = false, nb::kw_only(), "threads"_a = 1U,
      "timeout"_a = nb::none(), "memory_limit"_a = nb::none(), "progress"_a = nb::none(),
      with_limits(
          "Read a map, or the polygons of a WKT, GeoJSON or WKB file as a map. Polygons do not "
          "list outer boundaries, so such a map must be checked with outer='infer'."));
  def_run(c, "write", &write_map_file,
          "Write the map without loss. If writing fails, no incomplete file remains.", "path"_a);
  def_run(c, "check", &checked,
          "Decide exactly whether the cycles subdivide the plane. outer='listed' requires that "
          "outer boundaries are listed. 'infer' adds missing outer boundaries. 'ignore' accepts "
          "that they are missing.",
          "outer"_a = "listed", "merge_vertices"_a = false, "max_defects"_a = 1000U);
  c.def(
      "points", [](const Map& map) { return ArrayOut<double, 2>{coordinates_of(map.points)}; },
      "Return the points, rounded to doubles: float64 (n, 2).");
  c.def(
      "cycles",
      [](const Map& map) {
        return std::pair(ArrayOut<std::uint32_t, 1>{map.cycle_begin},
                         ArrayOut<std::uint32_t, 1>{map.corners});
      },
      "Return cycle_begin, uint32 (cycles + 1,), and corners, uint32 (k,).");
  c.def_prop_ro("vertex_count", &Map::vertex_count, "The number of listed points.");
  c.def_prop_ro("cycle_count", &Map::cycle_count, "The number of listed cycles.");
  c.def("__repr__", &repr_of);
}

using DefectCountsOut = nb::typed<nb::dict, nb::str, std::optional<std::uint64_t>>;
using HalfEdgesOut = nb::typed<nb::dict, nb::str, ArrayOut<std::uint32_t, 1>>;

// --- reports ----------------------------------------------------------------------------------

DefectCountsOut defect_counts(const MapReport& report) {
  DefectCountsOut result;
  result["duplicate"] = report.counts.duplicate;
  result["open"] = report.counts.open;
  result["crossing"] = report.counts.crossing;
  result["twin"] = report.counts.twin;
  result["mixed"] = report.counts.mixed;
  result["nested"] = report.counts.nested;
  return result;
}

std::vector<std::pair<std::uint32_t, std::uint32_t>> edges_of(const MapDefect& defect) {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> result;
  for (const MapEdge& e : defect.edges) result.emplace_back(e.from, e.to);
  return result;
}

std::optional<std::pair<Rational, Rational>> point_of_defect(const MapDefect& defect) {
  if (!defect.point) return std::nullopt;
  return std::pair(defect.point->x, defect.point->y);
}

Nef2 selected(Context& context, const MapReport& report, const std::vector<std::uint32_t>& regions,
              bool closed) {
  std::vector<std::uint8_t> chosen(report.regions.size());
  for (const std::uint32_t r : regions) {
    if (r >= chosen.size()) {
      throw Error(ErrorCode::BadIndex, "there is no region " + std::to_string(r));
    }
    chosen[r] = 1;
  }
  return Nef2::subdivision(report, chosen, boundary_of(closed), context);
}

HalfEdgesOut dcel_of(const MapReport& report) {
  const DcelFromCycles made = to_dcel(report);
  const Dcel& dcel = made.dcel;
  std::vector<std::uint32_t> origin(dcel.halfedge_slots());
  std::vector<std::uint32_t> next(origin.size());
  std::vector<std::uint32_t> face(origin.size());
  for (std::size_t i = 0; i < origin.size(); ++i) {
    const HalfedgeId h(i);
    origin[i] = dcel.origin(h).value();
    next[i] = dcel.next(h).value();
    face[i] = dcel.face(h).value();
  }
  std::vector<std::uint32_t> of_corner;
  of_corner.reserve(made.halfedge_of_corner.size());
  for (const HalfedgeId h : made.halfedge_of_corner) of_corner.push_back(h.value());
  HalfEdgesOut result;
  result["origin"] = nb::cast(ArrayOut<std::uint32_t, 1>{std::move(origin)});
  result["next"] = nb::cast(ArrayOut<std::uint32_t, 1>{std::move(next)});
  result["face"] = nb::cast(ArrayOut<std::uint32_t, 1>{std::move(face)});
  result["halfedge_of_corner"] = nb::cast(ArrayOut<std::uint32_t, 1>{std::move(of_corner)});
  return result;
}

void bind_defect(nb::module_& m) {
  nb::class_<MapDefect> c(m, "MapDefect", "One defect of a map.");
  c.def_prop_ro(
      "kind", [](const MapDefect& d) { return std::string(name_of(d.kind)); },
      "'duplicate', 'open', 'crossing', 'twin', 'mixed' or 'nested'.");
  c.def_ro("cycles", &MapDefect::cycles, "The cycles at which the defect occurs.");
  c.def_prop_ro("edges", &edges_of, "The edges at which the defect occurs, as pairs of vertices.");
  c.def_prop_ro("point", &point_of_defect, "The exact position of the defect, or None.");
  c.def_prop_ro(
      "hint", [](const MapDefect& d) { return python_words(d.hint); },
      "A sentence that explains how to correct the defect.");
  c.def("__repr__", [](const MapDefect& d) {
    return "<plumb.MapDefect: " + std::string(name_of(d.kind)) + ": " + python_words(d.hint) + ">";
  });
}

void bind_region(nb::module_& m) {
  nb::class_<MapRegion> c(m, "MapRegion", "A region of a valid map.");
  c.def_ro("outer", &MapRegion::outer,
           "The cycle around the region; None for the unbounded "
           "region.");
  c.def_ro("holes", &MapRegion::holes, "The cycles that bound the holes of the region.");
}

void bind_report(nb::module_& m) {
  bind_defect(m);
  bind_region(m);
  nb::class_<MapReport> c(m, "MapReport", "The result of Map.check(). Indices are 0-based.");
  c.def_prop_ro(
      "verdict", [](const MapReport& r) { return std::string(headline(r.verdict)); },
      "'valid', 'not a planar subdivision', 'open' or 'superposed'.");
  c.def_prop_ro(
      "is_valid", [](const MapReport& r) { return r.verdict == MapVerdict::Valid; },
      "Whether the cycles subdivide the plane.");
  c.def_ro("vertices", &MapReport::vertices, "The number of listed vertices.");
  c.def_ro("edges", &MapReport::edges, "The number of undirected edges.");
  c.def_ro("cycles", &MapReport::cycles, "The number of cycles, including inferred cycles.");
  c.def_ro("components", &MapReport::components, "The number of connected components.");
  c.def_prop_ro("counts", &defect_counts, "The number of defects of each kind.");
  c.def_ro("defects", &MapReport::defects, "The described defects.");
  c.def_prop_ro(
      "warnings",
      [](const MapReport& r) {
        std::vector<std::string> texts;
        for (const MapWarning& w : r.warnings) texts.push_back(w.text);
        return texts;
      },
      "Sentences about unusual properties of the map that are not defects.");
  c.def_ro("regions", &MapReport::regions,
           "The regions of a valid map. The unbounded region "
           "comes first.");
  c.def_prop_ro(
      "map", [](const MapReport& r) { return r.map; },
      "The checked map. In this map, vertices are merged and outer cycles are added if the "
      "options of check() asked for it.");
  c.def("dcel", &dcel_of,
        "Return the half-edges of a valid map in arrays: origin, next and face, uint32 (h,), where "
        "the twin of h is h ^ 1, and halfedge_of_corner, uint32 (corners,).");
  def_run(c, "select", &selected, "Return the union of regions of a valid map as a PlaneSet.",
          "regions"_a, "closed"_a = true);
  def_run(
      c, "to_json",
      +[](Context&, const MapReport& r) {
        return written([&](std::ostream& out) { write_map_report_json(out, r); });
      },
      "Return the whole report as JSON, with ids from 1.");
  def_run(
      c, "to_text",
      +[](Context&, const MapReport& r) {
        return written([&](std::ostream& out) { write_map_report_text(out, r); });
      },
      "Return the listing of a valid map, or one line for each defect, with ids from 1.");
  def_run(
      c, "to_geojson",
      +[](Context&, const MapReport& r) {
        return written([&](std::ostream& out) { write_map_report_geojson(out, r); });
      },
      "Return the defects as a GeoJSON FeatureCollection.");
  c.def("__repr__", [](const MapReport& r) {
    return "<plumb.MapReport: " + std::string(headline(r.verdict)) + ", " +
           std::to_string(r.edges) + " edges, " + std::to_string(r.regions.size()) + " regions>";
  });
  def_page(c);
}

// --- overlays ---------------------------------------------------------------------------------

/// An overlay with its areas.
struct MeasuredOverlay {
  ArrayOut<std::uint32_t, 2> origins;
  OverlayAreas areas;
};

MeasuredOverlay overlaid(Context& context, const MapReport& a, const MapReport& b) {
  const MapOverlay overlay = overlay_maps(a, b, context);
  MeasuredOverlay result;
  result.origins.values.reserve(2 * overlay.origin.size());
  for (const MapOverlay::Origin& origin : overlay.origin) {
    result.origins.values.push_back(origin.first);
    result.origins.values.push_back(origin.second);
  }
  result.areas = measure(overlay, a, b, context);
  return result;
}

void bind_overlay(nb::module_& m) {
  nb::class_<MeasuredOverlay> c(m, "MapOverlay",
                                "The subdivision of the plane by the edges of two valid maps.");
  c.def_prop_ro(
      "origins", [](const MeasuredOverlay& o) { return o.origins; },
      "For each face, the region of the first map and the region of the second map that contain "
      "it: uint32 (faces, 2).");
  c.def_prop_ro(
      "areas", [](const MeasuredOverlay& o) { return o.areas.cell; },
      "The exact area of each face; 0 for unbounded faces.");
  c.def_prop_ro(
      "first_areas", [](const MeasuredOverlay& o) { return o.areas.first; },
      "The exact area of each region of the first map.");
  c.def_prop_ro(
      "second_areas", [](const MeasuredOverlay& o) { return o.areas.second; },
      "The exact area of each region of the second map.");
  c.def(
      "add_up", [](const MeasuredOverlay& o) { return o.areas.add_up(); },
      "Whether the area of every region is the sum of the areas of its faces.");
  c.def("__repr__", [](const MeasuredOverlay& o) {
    return "<plumb.MapOverlay: " + std::to_string(o.areas.cell.size()) + " faces>";
  });
  m.def("overlay", with_context(&overlaid), "first"_a, "second"_a, nb::kw_only(), "threads"_a = 1U,
        "timeout"_a = nb::none(), "memory_limit"_a = nb::none(), "progress"_a = nb::none(),
        with_limits("Return the overlay of two valid maps, given by their reports."));
}

}  // namespace

void bind_map(nb::module_& m) {
  bind_map_class(m);
  bind_report(m);
  bind_overlay(m);
}

}  // namespace plumb::python
