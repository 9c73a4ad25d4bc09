// The commands `plumb map dissolve`, `plumb map simplify`, and `plumb map overlay` of layers.
//
// The resulting layer goes to -o, and a summary to standard output: as text, or as JSON with
// --json. Outputs are opened before the work. `map overlay` comes here if one of its files is a
// layer (map_commands.cpp).
// Tested by tests/cli/layer_command_test.cpp.
#include <array>
#include <filesystem>
#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

#include "plumb/base/internal/message_text.h"
#include "plumb/cli/commands/layer_output.h"
#include "plumb/cli/commands/map_overlay_options.h"
#include "plumb/cli/session/command.h"
#include "plumb/cli/session/progress.h"
#include "plumb/io/layer_io.h"
#include "plumb/io/layer_properties.h"
#include "plumb/io/text/file_names.h"
#include "plumb/plane/layer_dissolve.h"
#include "plumb/plane/layer_overlay.h"
#include "plumb/plane/layer_simplify.h"
#include "plumb/predicates/error.h"

namespace plumb::cli {
namespace {

using OrderedJson = nlohmann::ordered_json;

/// Opens the layer and the summary. The summary as text has one sentence in each line.
void open_layer_and_summary(Session& session, const std::function<const Layer&()>& layer,
                            const std::function<OrderedJson()>& json,
                            const std::function<std::string()>& text, const std::string& crs) {
  const bool is_on_stdout = open_layer_output(session, layer, crs);
  if (session.options().json) {
    session.outputs().add("-", [json](std::ostream& out) { out << json().dump() << '\n'; });
  } else if (!is_on_stdout) {
    session.outputs().add("-", [text](std::ostream& out) { out << text(); });
  }
}

std::string numbered(std::size_t n, const std::string& one) {
  return std::to_string(n) + ' ' + one + (n == 1 ? "" : "s");
}

/// Notes the overlaps that a command has resolved by the order of the features.
void note_overlaps(Session& session, const std::string& file, std::size_t overlaps) {
  if (overlaps == 0) return;
  session.note(input_name(file) + ": " + numbered(overlaps, "overlap") +
               " went to the first feature (plumb map repair has other rules)");
}

class MapDissolve : public CommandBody {
 public:
  void declare(CLI::App& app) override {
    app.add_option("LAYER", file_, "A layer: GeoJSON, TopoJSON, WKT or WKB; - is standard input")
        ->required()
        ->type_name("");
    app.add_option("--by", property_,
                   "Unite features with the same value of this property (default: all features)")
        ->type_name("NAME");
    app.add_option("--sum", sums_,
                   "Add up the values of this property; others are kept if all are equal")
        ->type_name("NAME");
    app.add_option("--object", read_options_.object, "The object of a TopoJSON file to read")
        ->type_name("NAME");
  }

  ExitCode run(Session& session) override {
    open_layer_and_summary(
        session, [this]() -> const Layer& { return result_; }, [this] { return json(); },
        [this] { return text(); }, crs_);
    session.expect({reading_map(), repairing_layer(), writing()});
    const Layer layer = read_layer_operand(session, file_, read_options_, crs_);
    before_ = layer.feature_count();
    session.begin("repair");
    Context& context = session.context();
    const FeatureGroups groups =
        property_.empty() ? one_group(layer) : group_features(layer, property_, context);
    DissolvedLayer dissolved = dissolve_layer(layer, groups.group, groups.count, context);
    overlaps_ = dissolved.overlaps;
    moved_ = dissolved.rounding.largest_move;
    result_ = with_group_properties(std::move(dissolved.layer), layer, groups, sums_, context);
    session.deliver();
    note_overlaps(session, file_, overlaps_);
    return ExitCode::Yes;
  }

 private:
  OrderedJson json() const {
    return {{"features", before_},
            {"groups", result_.feature_count()},
            {"polygons", result_.polygon_count()},
            {"overlaps", overlaps_},
            {"rounding_moved_by", moved_}};
  }
  std::string text() const {
    return numbered(before_, "feature") + " united to " + std::to_string(result_.feature_count()) +
           " with " + numbered(result_.polygon_count(), "polygon") + '\n';
  }

  std::string file_, property_, crs_;
  std::vector<std::string> sums_;
  LayerReadOptions read_options_;
  std::size_t before_ = 0, overlaps_ = 0;
  double moved_ = 0;
  Layer result_;
};

class MapSimplify : public CommandBody {
 public:
  void declare(CLI::App& app) override {
    app.add_option("LAYER", file_, "A layer: GeoJSON, TopoJSON, WKT or WKB; - is standard input")
        ->required()
        ->type_name("");
    app.add_option("--tolerance", tolerance_,
                   "Remove corners whose triangle has at most this area, in square units of the "
                   "layer")
        ->check(CLI::Range(0.0, 1e300).description(""))
        ->type_name("AREA");
    app.add_option("--percent", percent_, "Keep P percent of the corners that may be removed")
        ->check(CLI::Range(0.0, 100.0).description(""))
        ->type_name("P");
    app.add_option("--within", within_, "Move no point of a border farther than this distance")
        ->check(CLI::Range(0.0, 1e300).description(""))
        ->type_name("D");
    app.add_option("--object", read_options_.object, "The object of a TopoJSON file to read")
        ->type_name("NAME");
  }

  ExitCode run(Session& session) override {
    if (!tolerance_ && !percent_ && !within_) {
      throw Error(ErrorCode::Usage,
                  "map simplify needs --tolerance AREA, --percent P or --within D");
    }
    open_layer_and_summary(
        session, [this]() -> const Layer& { return result_.layer; }, [this] { return json(); },
        [this] { return text(); }, crs_);
    session.expect({reading_map(), repairing_layer(), writing()});
    const Layer layer = read_layer_operand(session, file_, read_options_, crs_);
    session.begin("repair");
    LayerSimplifyOptions options{.tolerance = std::numeric_limits<double>::infinity(), .kept = 0};
    if (tolerance_) options.tolerance = *tolerance_;
    if (percent_) options.kept = *percent_ / 100;
    if (within_) options.within = *within_;
    result_ = simplify_layer(layer, options, session.context());
    session.deliver();
    note_overlaps(session, file_, result_.overlaps);
    return ExitCode::Yes;
  }

 private:
  OrderedJson json() const {
    return {{"features", result_.layer.feature_count()},
            {"corners_before", result_.corners_before},
            {"corners_after", result_.corners_after},
            {"fixed", result_.fixed},
            {"blocked", result_.blocked},
            {"overlaps", result_.overlaps},
            {"borders_moved_by", result_.borders_moved},
            {"rounding_moved_by", result_.rounding.largest_move}};
  }
  std::string text() const {
    return numbered(result_.layer.feature_count(), "feature") + ", " +
           std::to_string(result_.corners_after) + " of " +
           numbered(result_.corners_before, "corner") + " left; " + std::to_string(result_.fixed) +
           " where three or more borders meet, " + std::to_string(result_.blocked) +
           " that protect others; no border moved by more than " +
           format_double(result_.borders_moved) + '\n';
  }

  std::string file_, crs_;
  std::optional<double> tolerance_, percent_, within_;
  LayerReadOptions read_options_;
  SimplifiedLayer result_;
};

// ---------------------------------------------------------------- overlay

/// Returns the choice with the given name. Requires one of the four names, or an empty one.
OverlayPairs pairs_named(std::string_view name) {
  if (name == "first") return OverlayPairs::First;
  if (name == "both") return OverlayPairs::Both;
  return name == "first-only" ? OverlayPairs::FirstOnly : OverlayPairs::All;
}

struct OverlaidLayers {
  Layer layer;
  std::size_t features[2] = {0, 0};
  std::size_t both = 0, only_first = 0, only_second = 0, vanished = 0, overlaps[2] = {0, 0};
  double moved = 0;
  std::string crs;
};

void count_pairs(const LayerOverlay& overlay, OverlaidLayers& result) {
  for (const LayerOverlay::Pair& pair : overlay.pairs) {
    if (pair.first == LayerRegion::kNobody) {
      ++result.only_second;
    } else {
      ++(pair.second == LayerRegion::kNobody ? result.only_first : result.both);
    }
  }
  result.vanished = overlay.vanished.size();
  result.overlaps[0] = overlay.first_overlaps;
  result.overlaps[1] = overlay.second_overlaps;
  result.moved = overlay.rounding.largest_move;
}

OrderedJson overlay_json(const OverlaidLayers& result) {
  return {{"features", {result.features[0], result.features[1]}},
          {"pairs", result.both + result.only_first + result.only_second},
          {"both", result.both},
          {"only_first", result.only_first},
          {"only_second", result.only_second},
          {"vanished", result.vanished},
          {"overlaps", {result.overlaps[0], result.overlaps[1]}},
          {"rounding_moved_by", result.moved}};
}

std::string overlay_text(const OverlaidLayers& result) {
  return std::to_string(result.features[0]) + " and " + std::to_string(result.features[1]) +
         " features: " + numbered(result.both, "pair") + ", " + std::to_string(result.only_first) +
         " only of the first layer, " + std::to_string(result.only_second) +
         " only of the second layer, " + std::to_string(result.vanished) +
         " vanished by rounding\n";
}

}  // namespace

bool is_layer_file(const std::string& path) {
  if (path == "-") return false;
  const std::string extension = std::filesystem::path(path).extension().string();
  for (const char* const name : {".geojson", ".json", ".topojson", ".wkt", ".wkb"}) {
    if (extension == name) return true;
  }
  require_layer_format(path);
  if (is_read_by_gdal(path)) return true;
  // Only the beginning of the file is read. A named pipe is not read, because it would lose these
  // bytes.
  std::error_code error;
  if (extension == ".map" || !std::filesystem::is_regular_file(path_of(path), error)) return false;
  std::string begin(256, '\0');
  std::ifstream in(path_of(path), std::ios::binary);
  in.read(begin.data(), static_cast<std::streamsize>(begin.size()));
  begin.resize(static_cast<std::size_t>(in.gcount()));
  return begins_like_layer(begin);
}

ExitCode overlay_layer_files(Session& session, const std::string& first, const std::string& second,
                             const LayerOverlayWords& words) {
  OverlaidLayers result;
  open_layer_and_summary(
      session, [&result]() -> const Layer& { return result.layer; },
      [&result] { return overlay_json(result); }, [&result] { return overlay_text(result); },
      result.crs);
  session.expect({reading_map(), reading_map(), overlaying_maps(), writing()});
  const Layer a =
      read_layer_operand(session, first, {.name = {}, .object = words.first_object}, result.crs);
  const Layer b =
      read_layer_operand(session, second, {.name = {}, .object = words.second_object}, result.crs);
  result.features[0] = a.feature_count();
  result.features[1] = b.feature_count();
  session.begin("overlay");
  LayerOverlay overlay =
      overlay_layers(a, b, {pairs_named(words.keep), words.with_areas}, session.context());
  count_pairs(overlay, result);
  result.layer = with_pair_properties(std::move(overlay), a, b, session.context());
  session.deliver();
  note_overlaps(session, first, result.overlaps[0]);
  note_overlaps(session, second, result.overlaps[1]);
  return ExitCode::Yes;
}

std::unique_ptr<CommandBody> make_map_dissolve() { return std::make_unique<MapDissolve>(); }
std::unique_ptr<CommandBody> make_map_simplify() { return std::make_unique<MapSimplify>(); }

}  // namespace plumb::cli
