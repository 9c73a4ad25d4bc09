// Layers of features, and the repair of their overlaps and gaps.
// Tested by tests/c/interface_test.c and tests/c/refused_memory_test.cpp.
#include "plumb/plane/layer.h"

#include <cmath>
#include <filesystem>

#include "files.h"
#include "handles.h"
#include "plumb/convex/voronoi.h"
#include "plumb/io/layer_io.h"
#include "plumb/io/layer_properties.h"
#include "plumb/plane/layer_dissolve.h"
#include "plumb/plane/layer_overlay.h"
#include "plumb/plane/layer_simplify.h"
#include "plumb/plane/plane_arrays.h"
#include "plumb/plane/plane_faces.h"
#include "plumb/plane/set_features.h"

struct plumb_layer {
  plumb::Layer layer;
};

struct plumb_layer_report {
  plumb::LayerReport report;
};

namespace plumb::c {
namespace {

LayerReadOptions layer_options(const char* object, std::string name) {
  return {std::move(name), text_or_empty(object)};
}

Layer layer_of(LayerFile file, plumb_notes& notes) {
  add_notes(notes, file.notes);
  return std::move(file.layer);
}

OwnerRule rule_of_owner(int owner) {
  if (owner < PLUMB_OWNER_LONGEST_BORDER || owner > PLUMB_OWNER_LOWEST_ID) {
    fail_argument("owner is no constant of plumb_owner");
  }
  if (owner == PLUMB_OWNER_LOWEST_ID) return OwnerRule::First;  // Of the ranks of ids.
  return static_cast<OwnerRule>(owner);
}

const Layer& layer_with(const plumb_layer* layer, std::size_t feature) {
  const Layer& found = need(layer, "layer").layer;
  if (feature >= found.feature_count()) {
    throw Error(ErrorCode::BadIndex, "the layer has no such feature");
  }
  return found;
}

using LayerWriter = void (*)(std::ostream&, const Layer&, Context&);

LayerWriter writer_named(const std::string& name) {
  if (name == "geojson") return &write_layer_geojson;
  if (name == "topojson") return &write_layer_topojson;
  if (name == "wkt") return &write_layer_wkt;
  fail_format(name, "geojson, topojson, wkt");
}

LayerWriter writer_of(const std::string& path) {
  const std::string extension = std::filesystem::path(path).extension().string();
  if (extension == ".geojson" || extension == ".json") return &write_layer_geojson;
  if (extension == ".topojson") return &write_layer_topojson;
  if (extension == ".wkt") return &write_layer_wkt;
  throw Error(ErrorCode::UnknownFormat, "no format of layers has the extension '" + extension + "'",
              {path});
}

OverlayPairs pairs_of(int kept) {
  if (kept < PLUMB_PAIRS_ALL || kept > PLUMB_PAIRS_FIRST_ONLY) {
    fail_argument("kept is no constant of plumb_overlay_pairs");
  }
  return static_cast<OverlayPairs>(kept);
}

std::vector<std::uint32_t> ranks_of(const Layer& layer, const plumb_layer_options& asked) {
  const std::span<const std::uint32_t> ranks = array(asked.ranks, asked.rank_count, "ranks");
  if (!ranks.empty() && asked.owner != PLUMB_OWNER_FIRST) {
    fail_argument("ranks need the owner PLUMB_OWNER_FIRST");
  }
  if (asked.owner == PLUMB_OWNER_LOWEST_ID) return id_ranks(layer);
  return {ranks.begin(), ranks.end()};
}

std::vector<OwnerPreference> preferences_of(const plumb_layer_options& asked) {
  const std::span<const std::uint32_t> features =
      array(asked.preferences, asked.preference_count, "preferences", 2);
  std::vector<OwnerPreference> preferences;
  for (std::size_t i = 0; i < features.size(); i += 2) {
    preferences.push_back({features[i], features[i + 1]});
  }
  return preferences;
}

/// Returns the options of a search for gaps, and of a repair; a negative bound stands for the
/// default.
LayerRepairOptions repair_options_of(const Layer& layer, const plumb_layer_options* options) {
  const plumb_layer_options asked = options_of(options, PLUMB_LAYER_OPTIONS_INIT);
  if (!std::isfinite(asked.gaps_below)) {
    throw Error(ErrorCode::NotFinite, "gaps_below is not finite");
  }
  LayerRepairOptions known{rule_of_owner(asked.owner), std::nullopt};
  if (asked.gaps_below >= 0) known.gaps_below = asked.gaps_below;
  known.open_gaps = !asked.enclosed_only;
  known.rank = ranks_of(layer, asked);
  known.preferences = preferences_of(asked);
  return known;
}

/// Makes the layer and, if it is wanted, the report.
void repair(const Layer& layer, const LayerRepairOptions& options, plumb_layer** out,
            plumb_layer_report** report, Context& context) {
  RepairedLayer repaired = repair_layer(layer, options, context);
  auto made = std::make_unique<plumb_layer>(plumb_layer{std::move(repaired.layer)});
  if (report != nullptr) *report = new plumb_layer_report{std::move(repaired.report)};
  *out = made.release();
}

plumb_simplify_report facts_of(const SimplifiedLayer& made) {
  plumb_simplify_report facts = PLUMB_SIMPLIFY_REPORT_INIT;
  facts.corners_before = made.corners_before;
  facts.corners_after = made.corners_after;
  facts.fixed = made.fixed;
  facts.blocked = made.blocked;
  facts.overlaps = made.overlaps;
  facts.borders_moved = made.borders_moved;
  facts.rounding_moved = made.rounding.largest_move;
  return facts;
}

/// Returns the layer with coordinates that are doubles, so that features still share borders.
plumb_layer rounded(const Layer& layer, Context& context) {
  return {repair_layer(layer, {OwnerRule::First, 0.0}, context).layer};
}

const LayerRegion* region_of(const plumb_layer_report* report, std::size_t i) {
  if (report == nullptr || i >= report->report.regions.size()) return nullptr;
  return &report->report.regions[i];
}

}  // namespace
}  // namespace plumb::c

using namespace plumb;
using namespace plumb::c;

// --- made of points and sets --------------------------------------------------------------------

plumb_status plumb_layer_voronoi(const double* xy, std::size_t count, const double* box,
                                 plumb_layer** out, const plumb_context* context,
                                 plumb_error** error) {
  return make(out, error, [&] {
    Call call(context);
    const std::span<const double> corners = finite(box, 4, "box", 1);
    const PointTable2 sites = points_of(finite(xy, count, "xy", 2));
    return rounded(voronoi_cells(sites, {corners[0], corners[1]}, {corners[2], corners[3]}, call),
                   call);
  });
}

plumb_status plumb_layer_of_faces(const plumb_plane_set* set, plumb_layer** out,
                                  const plumb_context* context, plumb_error** error) {
  return make(out, error, [&] {
    Call call(context);
    return rounded(layer_of_faces(need(set, "set").set, call), call);
  });
}

plumb_status plumb_layer_parts(const plumb_layer* layer, const plumb_plane_set* set,
                               plumb_layer** out, const plumb_context* context,
                               plumb_error** error) {
  return make(out, error, [&] {
    Call call(context);
    return plumb_layer{set_features(need(set, "set").set, need(layer, "layer").layer, call).layer};
  });
}

plumb_status plumb_layer_join(const plumb_layer* first, const plumb_layer* second,
                              plumb_layer** out, const plumb_context* context,
                              plumb_error** error) {
  return make(out, error, [&] {
    Call call(context);
    plumb_layer joined{need(first, "first").layer};
    append_layer(joined.layer, need(second, "second").layer);
    return joined;
  });
}

// --- files --------------------------------------------------------------------------------------

plumb_status plumb_layer_read(const char* bytes, std::size_t size,
                              const plumb_read_options* options, const char* object,
                              plumb_layer** out, plumb_notes** notes, const plumb_context* context,
                              plumb_error** error) {
  return make_with_notes(out, notes, error, [&](plumb_notes& told) {
    Call call(context);
    const LayerReadOptions asked = layer_options(object, name_of(options));
    return layer_of(plumb::read_layer(bytes_of(bytes, size), asked, call), told);
  });
}

plumb_status plumb_layer_read_file(const char* path, const char* object, plumb_layer** out,
                                   plumb_notes** notes, const plumb_context* context,
                                   plumb_error** error) {
  return make_with_notes(out, notes, error, [&](plumb_notes& told) {
    Call call(context);
    const std::string name = text(path, "path");
    return layer_of(plumb::read_layer_file(name, layer_options(object, name), call), told);
  });
}

plumb_status plumb_layer_write(const plumb_layer* layer, const char* format, plumb_bytes** out,
                               const plumb_context* context, plumb_error** error) {
  return make(out, error, [&] {
    Call call(context);
    Context& own = call;
    const LayerWriter writer = writer_named(text(format, "format"));
    const Layer& given = need(layer, "layer").layer;
    return written([&](std::ostream& stream) { writer(stream, given, own); });
  });
}

plumb_status plumb_layer_write_file(const plumb_layer* layer, const char* path, const char* format,
                                    const plumb_context* context, plumb_error** error) {
  return guarded(error, [&] {
    Call call(context);
    Context& own = call;
    const std::string file = text(path, "path");
    const LayerWriter writer = format != nullptr ? writer_named(format) : writer_of(file);
    const Layer& given = need(layer, "layer").layer;
    write_file(file, [&](std::ostream& stream) { writer(stream, given, own); });
  });
}

// --- features -----------------------------------------------------------------------------------

std::size_t plumb_layer_feature_count(const plumb_layer* layer) {
  return layer == nullptr ? 0 : layer->layer.feature_count();
}

plumb_status plumb_layer_id(const plumb_layer* layer, std::size_t feature, plumb_bytes** out,
                            plumb_error** error) {
  return make(out, error, [&] { return std::string(layer_with(layer, feature).id(feature)); });
}

plumb_status plumb_layer_properties(const plumb_layer* layer, std::size_t feature,
                                    plumb_bytes** out, plumb_error** error) {
  return make(out, error,
              [&] { return std::string(layer_with(layer, feature).properties(feature)); });
}

plumb_status plumb_layer_crs(const plumb_layer* layer, plumb_bytes** out, plumb_error** error) {
  return make(out, error, [&] { return need(layer, "layer").layer.crs; });
}

plumb_status plumb_layer_find(const plumb_layer* layer, const char* id_or_name,
                              std::uint32_t* feature, plumb_error** error) {
  return guarded(error, [&] {
    const Layer& given = need(layer, "layer").layer;
    need(feature, "feature") = feature_called(given, text(id_or_name, "id_or_name"));
  });
}

void plumb_layer_free(plumb_layer* layer) { delete layer; }

// --- repair -------------------------------------------------------------------------------------

plumb_status plumb_layer_repair(const plumb_layer* layer, int owner, double gaps_below,
                                plumb_layer** out, plumb_layer_report** report,
                                const plumb_context* context, plumb_error** error) {
  plumb_layer_options options = PLUMB_LAYER_OPTIONS_INIT;
  options.owner = owner;
  options.gaps_below = gaps_below;
  return plumb_layer_repair_with(layer, &options, out, report, context, error);
}

plumb_status plumb_layer_repair_with(const plumb_layer* layer, const plumb_layer_options* options,
                                     plumb_layer** out, plumb_layer_report** report,
                                     const plumb_context* context, plumb_error** error) {
  if (out != nullptr) *out = nullptr;
  if (report != nullptr) *report = nullptr;
  return guarded(error, [&] {
    need(out, "out");
    Call call(context);
    const Layer& given = need(layer, "layer").layer;
    repair(given, repair_options_of(given, options), out, report, call);
  });
}

plumb_status plumb_layer_check(const plumb_layer* layer, double gaps_below,
                               plumb_layer_report** out, const plumb_context* context,
                               plumb_error** error) {
  plumb_layer_options options = PLUMB_LAYER_OPTIONS_INIT;
  options.gaps_below = gaps_below;
  return plumb_layer_check_with(layer, &options, out, context, error);
}

plumb_status plumb_layer_check_with(const plumb_layer* layer, const plumb_layer_options* options,
                                    plumb_layer_report** out, const plumb_context* context,
                                    plumb_error** error) {
  return make(out, error, [&] {
    Call call(context);
    const Layer& given = need(layer, "layer").layer;
    return plumb_layer_report{check_layer(given, repair_options_of(given, options), call)};
  });
}

plumb_status plumb_layer_dissolve(const plumb_layer* layer, const std::uint32_t* groups,
                                  std::size_t count, std::size_t group_count, plumb_layer** out,
                                  const plumb_context* context, plumb_error** error) {
  return make(out, error, [&] {
    Call call(context);
    const std::span<const std::uint32_t> group = array(groups, count, "groups");
    return plumb_layer{dissolve_layer(need(layer, "layer").layer, group, group_count, call).layer};
  });
}

plumb_status plumb_layer_overlay(const plumb_layer* first, const plumb_layer* second, int kept,
                                 plumb_layer** out, plumb_indices** pairs,
                                 const plumb_context* context, plumb_error** error) {
  if (out != nullptr) *out = nullptr;
  if (pairs != nullptr) *pairs = nullptr;
  return guarded(error, [&] {
    need(out, "out");
    Call call(context);
    LayerOverlay overlay = overlay_layers(need(first, "first").layer, need(second, "second").layer,
                                          {pairs_of(kept), false}, call);
    auto made = std::make_unique<plumb_layer>(plumb_layer{std::move(overlay.layer)});
    auto partners = std::make_unique<plumb_indices>();
    for (const LayerOverlay::Pair& pair : overlay.pairs) {
      partners->values.insert(partners->values.end(), {pair.first, pair.second});
    }
    if (pairs != nullptr) *pairs = partners.release();
    *out = made.release();
  });
}

plumb_status plumb_layer_simplify(const plumb_layer* layer, double tolerance, double kept,
                                  plumb_layer** out, const plumb_context* context,
                                  plumb_error** error) {
  return make(out, error, [&] {
    Call call(context);
    return plumb_layer{simplify_layer(need(layer, "layer").layer, {tolerance, kept}, call).layer};
  });
}

plumb_status plumb_layer_simplify_with_report(const plumb_layer* layer, double tolerance,
                                              double kept, double within, plumb_layer** out,
                                              plumb_simplify_report* report,
                                              const plumb_context* context, plumb_error** error) {
  return make(out, error, [&] {
    Call call(context);
    SimplifiedLayer made =
        simplify_layer(need(layer, "layer").layer, {tolerance, kept, within}, call);
    if (report != nullptr) fill(report, facts_of(made), "report");
    return plumb_layer{std::move(made.layer)};
  });
}

std::size_t plumb_layer_report_count(const plumb_layer_report* report) {
  return report == nullptr ? 0 : report->report.regions.size();
}

bool plumb_layer_report_has_defects(const plumb_layer_report* report) {
  return report != nullptr && report->report.has_defects();
}

int plumb_layer_report_kind(const plumb_layer_report* report, std::size_t i) {
  const LayerRegion* const region = region_of(report, i);
  return region == nullptr ? -1 : static_cast<int>(region->kind);
}

bool plumb_layer_report_is_open(const plumb_layer_report* report, std::size_t i) {
  const LayerRegion* const region = region_of(report, i);
  return region != nullptr && region->is_open;
}

plumb_status plumb_layer_report_area(const plumb_layer_report* report, std::size_t i,
                                     plumb_numbers** out, plumb_error** error) {
  return make(out, error, [&] {
    need(report, "report");
    const LayerRegion* const region = region_of(report, i);
    if (region == nullptr) throw Error(ErrorCode::BadIndex, "the report has no such region");
    return numbers_of(std::vector<Rational>{region->area});
  });
}

double plumb_layer_report_width(const plumb_layer_report* report, std::size_t i) {
  const LayerRegion* const region = region_of(report, i);
  return region == nullptr ? 0 : region->width;
}

bool plumb_layer_report_place(const plumb_layer_report* report, std::size_t i, double xy[2]) {
  if (region_of(report, i) == nullptr || xy == nullptr) return false;
  const std::optional<Point2> at = place_of(report->report, i);
  if (!at) return false;
  xy[0] = at->x;
  xy[1] = at->y;
  return true;
}

const std::uint32_t* plumb_layer_report_features(const plumb_layer_report* report, std::size_t i,
                                                 std::size_t* count) {
  const LayerRegion* const region = region_of(report, i);
  if (count != nullptr) *count = 0;
  if (region == nullptr) return nullptr;
  const std::span<const std::uint32_t> features = report->report.features_of(*region);
  if (count != nullptr) *count = features.size();
  return features.data();
}

std::uint32_t plumb_layer_report_owner(const plumb_layer_report* report, std::size_t i) {
  const LayerRegion* const region = region_of(report, i);
  return region == nullptr ? LayerRegion::kNobody : region->owner;
}

plumb_status plumb_layer_report_write(const plumb_layer_report* report, const plumb_layer* layer,
                                      const char* format, plumb_bytes** out,
                                      const plumb_context* context, plumb_error** error) {
  return make(out, error, [&] {
    Call call(context);
    Context& own = call;
    const Layer& before = need(layer, "layer").layer;
    const LayerReport& found = need(report, "report").report;
    const std::string name = text(format, "format");
    for (const auto* const list : {&found.features, &found.emptied}) {
      for (const std::uint32_t f : *list) {
        if (f >= before.feature_count()) fail_argument("the report is of another layer");
      }
    }
    return written([&](std::ostream& stream) {
      if (name == "text") {
        write_layer_report_text(stream, before, found);
      } else if (name == "json") {
        write_layer_report_json(stream, before, found);
      } else if (name == "geojson") {
        write_layer_report_geojson(stream, before, found, own);
      } else {
        fail_format(name, "text, json, geojson");
      }
    });
  });
}

void plumb_layer_report_free(plumb_layer_report* report) { delete report; }
