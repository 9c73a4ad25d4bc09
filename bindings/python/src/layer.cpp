// plumb.Layer and plumb.LayerReport: features with polygons, and the repair of their overlaps and
// gaps. Ids and properties are kept as JSON texts, and are parsed when they are asked for.
// Tests: tests/test_layer.py.
#include "plumb/plane/layer.h"

#include <algorithm>
#include <limits>
#include <sstream>

#include "binding.h"
#include "plumb/convex/voronoi.h"
#include "plumb/io/layer_io.h"
#include "plumb/io/layer_properties.h"
#include "plumb/io/text/files.h"
#include "plumb/plane/layer_dissolve.h"
#include "plumb/plane/layer_overlay.h"
#include "plumb/plane/layer_simplify.h"
#include "plumb/plane/plane_arrays.h"
#include "plumb/plane/plane_faces.h"
#include "plumb/plane/set_features.h"
#include "simplify_report.h"

namespace plumb::python {
namespace {

struct Repair {
  Layer layer;
  LayerReport report;
};

OwnerRule owner_rule(const std::string& name) {
  if (name == "longest-border") return OwnerRule::LongestBorder;
  if (name == "largest") return OwnerRule::Largest;
  if (name == "smallest") return OwnerRule::Smallest;
  if (name == "first" || name == "lowest-id") return OwnerRule::First;
  throw Error(
      ErrorCode::BadArgument,
      "rule must be 'longest-border', 'largest', 'smallest', 'first' or 'lowest-id', not '" + name +
          "'");
}

/// A feature: its index, or its id or name as a text.
using FeatureName = std::variant<std::uint32_t, std::string>;

std::uint32_t feature_of(const Layer& layer, const FeatureName& name) {
  if (const auto* const index = std::get_if<std::uint32_t>(&name)) return *index;
  return feature_called(layer, std::get<std::string>(name));
}

/// The arguments of repaired().
struct RepairWords {
  std::string rule;
  std::optional<double> gaps_below;
  bool enclosed_only;
  std::optional<std::vector<std::uint32_t>> ranks;
  std::vector<std::pair<FeatureName, FeatureName>> preferences;
};

LayerRepairOptions options_of(const Layer& layer, const RepairWords& words) {
  LayerRepairOptions options{owner_rule(words.rule), words.gaps_below, !words.enclosed_only};
  if (words.ranks && words.rule != "first") {
    throw Error(ErrorCode::BadArgument, "ranks need the rule 'first'");
  }
  if (words.ranks) options.rank = *words.ranks;
  if (words.rule == "lowest-id") options.rank = id_ranks(layer);
  for (const auto& [winner, loser] : words.preferences) {
    options.preferences.push_back({feature_of(layer, winner), feature_of(layer, loser)});
  }
  return options;
}

nb::object parsed(std::string_view json) {
  if (json.empty()) return nb::none();
  return nb::module_::import_("json").attr("loads")(nb::str(json.data(), json.size()));
}

using Values = nb::typed<nb::list, nb::object>;

Values ids_of(const Layer& layer) {
  Values values;
  for (std::size_t f = 0; f < layer.feature_count(); ++f) values.append(parsed(layer.id(f)));
  return values;
}

Values properties_of(const Layer& layer) {
  Values values;
  for (std::size_t f = 0; f < layer.feature_count(); ++f) {
    values.append(parsed(layer.properties(f)));
  }
  return values;
}

std::string geojson_of(Context& context, const Layer& layer) {
  std::ostringstream out;
  write_layer_geojson(out, layer, context);
  return std::move(out).str();
}

std::monostate write_layer(Context& context, const Layer& layer, const Path& path) {
  const std::string extension = path.extension().string();
  if (extension != ".geojson" && extension != ".json" && extension != ".topojson" &&
      extension != ".wkt") {
    throw Error(ErrorCode::UnknownFormat,
                "the extension of " + path.string() + " names no format for layers");
  }
  OutputFile file(path.string());
  if (extension == ".topojson") {
    write_layer_topojson(file.stream(), layer, context);
  } else if (extension == ".wkt") {
    write_layer_wkt(file.stream(), layer, context);
  } else {
    write_layer_geojson(file.stream(), layer, context);
  }
  file.finish();
  file.commit();
  return {};
}

Layer layer_of(LayerFile file) {
  note(file.notes);
  return std::move(file.layer);
}

Repair repaired(Context& context, const Layer& layer, const RepairWords& words) {
  RepairedLayer result = repair_layer(layer, options_of(layer, words), context);
  return {std::move(result.layer), std::move(result.report)};
}

LayerReport checked_layer(Context& context, const Layer& layer,
                          const std::optional<double>& gaps_below, bool enclosed_only) {
  return check_layer(layer, {OwnerRule::First, gaps_below, !enclosed_only}, context);
}

Layer dissolved(Context& context, const Layer& layer, const std::vector<std::uint32_t>& groups) {
  std::size_t count = 0;
  for (const std::uint32_t group : groups) count = std::max<std::size_t>(count, group + 1U);
  return dissolve_layer(layer, groups, count, context).layer;
}

std::pair<Layer, SimplifyReport> simplified_with_report(Context& context, const Layer& layer,
                                                        double tolerance, double kept,
                                                        double within) {
  SimplifiedLayer made = simplify_layer(layer, {tolerance, kept, within}, context);
  const SimplifyReport report = report_of(made);
  return {std::move(made.layer), report};
}

Layer simplified(Context& context, const Layer& layer, double tolerance, double kept,
                 double within) {
  return simplify_layer(layer, {tolerance, kept, within}, context).layer;
}

Layer parts_of(Context& context, const Layer& layer, const Nef2& set) {
  return set_features(set, layer, context).layer;
}

Layer joined(Context&, const Layer& first, const Layer& second) {
  Layer result = first;
  append_layer(result, second);
  return result;
}

OverlayPairs overlay_pairs(const std::string& name) {
  if (name == "all") return OverlayPairs::All;
  if (name == "first") return OverlayPairs::First;
  if (name == "both") return OverlayPairs::Both;
  if (name == "first-only") return OverlayPairs::FirstOnly;
  throw Error(ErrorCode::BadArgument,
              "pairs must be 'all', 'first', 'both' or 'first-only', not '" + name + "'");
}

using Partner = std::optional<std::uint32_t>;

Partner partner(std::uint32_t feature) {
  if (feature == LayerRegion::kNobody) return std::nullopt;
  return feature;
}

std::pair<Layer, std::vector<std::pair<Partner, Partner>>> overlaid(Context& context,
                                                                    const Layer& first,
                                                                    const Layer& second,
                                                                    const std::string& pairs) {
  LayerOverlay result = overlay_layers(first, second, {overlay_pairs(pairs), false}, context);
  std::vector<std::pair<Partner, Partner>> partners;
  partners.reserve(result.pairs.size());
  for (const LayerOverlay::Pair& pair : result.pairs) {
    partners.emplace_back(partner(pair.first), partner(pair.second));
  }
  return {std::move(result.layer), std::move(partners)};
}

using RegionOut = nb::typed<nb::dict, nb::str, nb::object>;

nb::typed<nb::list, RegionOut> regions_of(const LayerReport& report) {
  nb::typed<nb::list, RegionOut> regions;
  for (std::size_t i = 0; i < report.regions.size(); ++i) {
    const LayerRegion& region = report.regions[i];
    const std::optional<Point2> at = place_of(report, i);
    RegionOut out;
    nb::list features;
    for (const std::uint32_t f : report.features_of(region)) features.append(f);
    out["kind"] = name_of(region.kind);
    out["area"] = region.area;
    out["open"] = region.is_open;
    out["width"] = region.width;
    out["features"] = features;
    out["owner"] =
        region.owner == LayerRegion::kNobody ? nb::none() : nb::object(nb::int_(region.owner));
    out["at"] = at ? nb::object(nb::make_tuple(at->x, at->y)) : nb::none();
    regions.append(out);
  }
  return regions;
}

void def_reading(nb::class_<Layer>& c) {
  c.def_static(
      "read",
      [](const Path& path, const std::optional<std::string>& object, unsigned threads,
         std::optional<double> timeout, std::optional<std::uint64_t> memory_limit,
         nb::object progress) {
        LayerReadOptions options;
        options.object = object.value_or("");
        return layer_of(
            run(CallLimits{threads, timeout, memory_limit, std::move(progress)},
                [&](Context& k) { return read_layer_file(path.string(), options, k); }));
      },
      "path"_a, "object"_a = nb::none(), nb::kw_only(), "threads"_a = 1U, "timeout"_a = nb::none(),
      "memory_limit"_a = nb::none(), "progress"_a = nb::none(),
      with_limits(
          "Read the features of a GeoJSON, TopoJSON, WKT or WKB file. `object` is the name of an "
          "object of TopoJSON; by default, the first object is read."));
  c.def_static(
      "parse",
      [](const std::string& text, const std::optional<std::string>& object, unsigned threads,
         std::optional<double> timeout, std::optional<std::uint64_t> memory_limit,
         nb::object progress) {
        LayerReadOptions options;
        options.name = "text";
        options.object = object.value_or("");
        return layer_of(run(CallLimits{threads, timeout, memory_limit, std::move(progress)},
                            [&](Context& k) { return read_layer(text, options, k); }));
      },
      "text"_a, "object"_a = nb::none(), nb::kw_only(), "threads"_a = 1U, "timeout"_a = nb::none(),
      "memory_limit"_a = nb::none(), "progress"_a = nb::none(),
      with_limits("Do the same as read() for a text."));
}

/// Returns the layer with coordinates that are doubles, so that features still share borders.
Layer rounded(Context& context, const Layer& layer) {
  return repair_layer(layer, {OwnerRule::First, 0.0}, context).layer;
}

Layer voronoi(Context& context, const Coordinates2& sites, const Exact<2>& low,
              const Exact<2>& high) {
  const RationalPoint2 from{low.value[0], low.value[1]};
  const RationalPoint2 to{high.value[0], high.value[1]};
  return rounded(context, voronoi_cells(points_of(sites.span()), from, to, context));
}

Layer faces(Context& context, const Nef2& set) {
  return rounded(context, layer_of_faces(set, context));
}

void def_making(nb::class_<Layer>& c) {
  def_run_static(c, "voronoi", &voronoi,
                 "Return the Voronoi cells of sites, float64 (n, 2), inside the box between two "
                 "corners. Feature i is the cell of site i.",
                 "sites"_a, "low"_a, "high"_a);
  def_run_static(c, "of_faces", &faces,
                 "Return a layer with a feature for each bounded face of a set. To get the faces "
                 "that lines bound, pass the complement of the lines.",
                 "set"_a);
}

void bind_simplify_report(nb::module_& m) {
  nb::class_<SimplifyReport> c(m, "SimplifyReport",
                               "A report on the changes that simplified_with_report() of a set "
                               "or a layer has made.");
  c.def_ro("corners_before", &SimplifyReport::corners_before,
           "The number of corners of the original borders.");
  c.def_ro("corners_after", &SimplifyReport::corners_after,
           "The number of corners of the simplified borders.");
  c.def_ro("fixed", &SimplifyReport::fixed,
           "The number of corners of a layer that cannot be removed because three or more borders "
           "meet there. It is 0 for a set.");
  c.def_ro("blocked", &SimplifyReport::blocked,
           "The number of corners whose removal the bounds allow. They are kept for another "
           "reason: their triangle contains another corner, or a ring would collapse.");
  c.def_ro("overlaps", &SimplifyReport::overlaps,
           "The number of overlaps of features, which went to the first feature.");
  c.def_ro("borders_moved", &SimplifyReport::borders_moved,
           "An upper bound for the distance by which borders have moved.");
  c.def_ro("rounding_moved", &SimplifyReport::rounding_moved,
           "An upper bound for the distance by which rounding has moved borders. Rounding comes "
           "before the simplification.");
}

}  // namespace

void bind_layer(nb::module_& m) {
  bind_simplify_report(m);
  nb::class_<LayerReport> report(m, "LayerReport",
                                 "The regions that Layer.check() or "
                                 "Layer.repaired() found, and the changes of "
                                 "the repair.");
  report.def_prop_ro(
      "regions", &regions_of,
      "The overlaps, gaps, holes, crossings and nestings. Each of them is a dict with kind "
      "('overlap', 'gap', 'hole', 'crossing' or 'nesting'), area (an exact fraction), open, width, "
      "features (indices), owner (an index, or None), and at (x and y of a place to look at, or "
      "None). A crossing is a point at which the border of a feature crosses itself, or edges on "
      "which it lies twice. A nesting is a ring that is listed as a hole, but lies outside of the "
      "outer ring or in another hole.");
  report.def_prop_ro("has_defects", &LayerReport::has_defects,
                     "Whether the layer had overlaps, gaps, crossings or nestings.");
  report.def_ro("gaps_below", &LayerReport::gaps_below, "The bound for the widths of gaps.");
  report.def_ro("emptied", &LayerReport::emptied,
                "The features that have polygons, but no area after the repair.");
  report.def_prop_ro(
      "largest_move", [](const LayerReport& r) { return r.rounding.largest_move; },
      "An upper bound for the distance by which rounding has moved a border.");

  nb::class_<Layer> c(m, "Layer", "Features with ids, properties and polygons, such as countries.");
  def_reading(c);
  def_making(c);
  c.def("__len__", &Layer::feature_count, "Return the number of features.");
  c.def("__repr__", [](const Layer& layer) {
    return "<plumb.Layer: " + std::to_string(layer.feature_count()) + " features, " +
           std::to_string(layer.polygon_count()) + " polygons>";
  });
  c.def_ro("crs", &Layer::crs,
           "The name of the coordinate reference system that the file states, or an empty text. "
           "Operations pass it on, and GeoJSON is written with it. Coordinates are never "
           "converted.");
  c.def("ids", &ids_of, "Return the id of each feature, or None.");
  c.def("properties", &properties_of, "Return the properties of each feature, or None.");
  def_run(c, "to_geojson", &geojson_of,
          "Return a FeatureCollection as text, one feature in each line.");
  def_run(c, "write", &write_layer,
          "Write a .geojson, .json, .topojson or .wkt file. If writing fails, no incomplete file "
          "remains.",
          "path"_a);
  def_run(c, "check", &checked_layer,
          "Return the overlaps, gaps, holes, crossings and nestings of the layer as a LayerReport. "
          "Its regions have no owners. If `enclosed_only` is true, gaps that open to the outside "
          "or into a hole are not found.",
          "gaps_below"_a = nb::none(), "enclosed_only"_a = false);
  c.def(
      "find",
      [](const Layer& layer, const std::string& id_or_name) {
        return feature_called(layer, id_or_name);
      },
      "id_or_name"_a,
      "Return the index of the feature that has the id `id_or_name`. If there is none, return "
      "the index of the feature whose property 'name' or 'NAME' is `id_or_name`.");
  def_run(c, "dissolved", &dissolved,
          "Return a layer with a feature for each group. `groups` contains the group of each "
          "feature, which is a number 0, 1, ...",
          "groups"_a);
  def_run(c, "simplified", &simplified,
          "Return the layer with fewer corners on its borders. Features of the result do not "
          "overlap. A corner and its two neighbours form a triangle. A corner is removed only if "
          "the area of its triangle is at most `tolerance`, if more than the fraction `kept` of "
          "the removable corners remains, and if no point of a border moves farther than `within`.",
          "tolerance"_a = std::numeric_limits<double>::infinity(), "kept"_a = 0.0,
          "within"_a = std::numeric_limits<double>::infinity());
  def_run(c, "simplified_with_report", &simplified_with_report,
          "Do the same as simplified(), and return also a SimplifyReport.",
          "tolerance"_a = std::numeric_limits<double>::infinity(), "kept"_a = 0.0,
          "within"_a = std::numeric_limits<double>::infinity());
  def_run(c, "parts", &parts_of,
          "Divide a set into the parts that the features cover, and return them as a layer. Each "
          "part is a feature with the id and the properties of the feature that covers it. A part "
          "that several features cover is assigned to the first of them. Parts that no feature "
          "covers form the last feature, which has no id.",
          "set"_a);
  def_run(c, "joined", &joined,
          "Return a layer with the features of this layer, followed by the features of another "
          "layer.",
          "other"_a);
  def_run(c, "overlaid", &overlaid,
          "Return the overlay with another layer: a layer with a feature for each pair of "
          "overlapping features, and the list of these pairs of indices. A part of a feature that "
          "no feature of the other layer covers forms a pair with None. `pairs` selects the "
          "pairs: 'all', 'first' (pairs with a feature of this layer), 'both' (pairs without "
          "None) or 'first-only' (pairs without a feature of the other layer).",
          "other"_a, "pairs"_a = "all");
  c.def(
      "repaired",
      [](const Layer& layer, const std::string& rule, const std::optional<double>& gaps_below,
         bool enclosed_only, const std::optional<std::vector<std::uint32_t>>& ranks,
         const std::vector<std::pair<FeatureName, FeatureName>>& preferences, unsigned threads,
         std::optional<double> timeout, std::optional<std::uint64_t> memory_limit,
         nb::object progress) {
        const RepairWords words{rule, gaps_below, enclosed_only, ranks, preferences};
        Repair result = run(CallLimits{threads, timeout, memory_limit, std::move(progress)},
                            [&](Context& k) { return repaired(k, layer, words); });
        return std::pair(std::move(result.layer), std::move(result.report));
      },
      "rule"_a = "longest-border", "gaps_below"_a = nb::none(), "enclosed_only"_a = false,
      "ranks"_a = nb::none(), "preferences"_a = std::vector<std::pair<FeatureName, FeatureName>>(),
      nb::kw_only(), "threads"_a = 1U, "timeout"_a = nb::none(), "memory_limit"_a = nb::none(),
      "progress"_a = nb::none(),
      with_limits(
          "Return the layer without overlaps and gaps, and a LayerReport. `rule` selects the "
          "feature that gets an overlap or a gap: 'longest-border', 'largest', 'smallest', "
          "'first' or 'lowest-id'. A region that no feature covers is a gap if it is narrower "
          "than `gaps_below`. If `enclosed_only` is true, gaps that open to the outside or into "
          "a hole are not filled. `ranks` contains a number for each feature; under the rule "
          "'first', the feature with the least number gets a region. `preferences` are pairs of "
          "features, as indices or as texts for find(): the second feature of a pair does not "
          "get a region that the first feature may get."));
}

}  // namespace plumb::python
