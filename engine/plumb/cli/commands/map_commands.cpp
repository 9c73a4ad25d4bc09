// The commands `plumb map check` and `plumb map overlay`.
//
// Both have a table of formats; outputs are opened before the work, so that a path that cannot be
// written costs nothing. The check prints the report in the formats asked for and exits with 1 for
// a defective map. The overlay requires two valid maps, because only subdivisions have regions,
// overlays them exactly, and prints the cells and their areas.
// Tested by tests/cli/map_commands_test.cpp and tests/cli/program_test.cpp.
#include <array>
#include <filesystem>
#include <optional>
#include <ostream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>

#include "plumb/cli/commands/layer_output.h"
#include "plumb/cli/commands/map_overlay_options.h"
#include "plumb/cli/files/certificate.h"
#include "plumb/cli/files/operands.h"
#include "plumb/cli/files/outputs.h"
#include "plumb/cli/session/command.h"
#include "plumb/cli/session/progress.h"
#include "plumb/io/layer_io.h"
#include "plumb/io/map_io.h"
#include "plumb/io/map_report_io.h"
#include "plumb/io/plane/map_overlay_writer.h"
#include "plumb/io/plane_io.h"
#include "plumb/io/text/file_names.h"
#include "plumb/io/text/files.h"
#include "plumb/picture/layer_svg.h"
#include "plumb/picture/map_svg.h"
#include "plumb/picture/overlay_svg.h"
#include "plumb/picture/plane_html.h"
#include "plumb/plane/map_check.h"
#include "plumb/plane/plane_rounding.h"
#include "plumb/predicates/error.h"

namespace plumb::cli {
namespace {

/// The report that is written: the report of a map, or the report of a layer.
struct Checked {
  std::string title;
  MapReport map;
  Layer layer;
  std::string crs;  // The coordinate reference system of the layer.
  std::optional<LayerReport> layer_report;
};

using ReportWriter = void (*)(std::ostream&, const Checked&);

void write_text(std::ostream& out, const Checked& checked) {
  if (checked.layer_report) {
    write_layer_report_text(out, checked.layer, *checked.layer_report);
  } else {
    write_map_report_text(out, checked.map);
  }
}
void write_json(std::ostream& out, const Checked& checked) {
  if (checked.layer_report) {
    write_layer_report_json(out, checked.layer, *checked.layer_report);
  } else {
    write_map_report_json(out, checked.map);
  }
}
void write_svg(std::ostream& out, const Checked& checked) {
  if (checked.layer_report) {
    write_layer_svg(out, checked.layer, *checked.layer_report, {.title = checked.title});
  } else {
    write_map_svg(out, checked.map, {.title = checked.title});
  }
}
void write_html(std::ostream& out, const Checked& checked) {
  if (checked.layer_report) {
    write_layer_html(out, checked.layer, *checked.layer_report, {.title = checked.title});
    return;
  }
  std::ostringstream svg;
  write_map_svg(svg, checked.map, {.title = checked.title});
  write_plane_html(out, svg.str(), checked.title);
}
void write_geojson(std::ostream& out, const Checked& checked) {
  if (checked.layer_report) {
    write_layer_report_geojson(out, checked.layer, *checked.layer_report, checked.crs);
  } else {
    write_map_report_geojson(out, checked.map);
  }
}

struct Format {
  std::string_view name;
  std::string_view extension;
  ReportWriter write;
};

constexpr std::array kFormats{
    Format{"text", ".txt", write_text},  Format{"json", ".json", write_json},
    Format{"svg", ".svg", write_svg},    Format{"geojson", ".geojson", write_geojson},
    Format{"html", ".html", write_html},
};

/// Returns the rule with the given name. Requires one of the three names.
OuterRule outer_rule(std::string_view name) {
  if (name == "infer") return OuterRule::Infer;
  return name == "ignore" ? OuterRule::Ignore : OuterRule::Listed;
}

class MapCheck : public CommandBody {
 public:
  void declare(CLI::App& app) override;
  ExitCode run(Session& session) override;

 private:
  void open_outputs(Session& session);
  void add_output(Session& session, const std::string& path, const Format& format);
  void tell_notes(Session& session) const;
  ExitCode check_map_file(Session& session, std::string_view text);
  ExitCode check_layer_file(Session& session, std::string_view text);
  void note(Session& session, const std::string& text) const {
    session.note(input_name(file_) + ": " + text);
  }

  std::string file_;
  std::string outer_;
  std::string svg_;
  std::string geojson_;
  bool checks_edges_ = false;
  LayerReadOptions read_options_;
  LayerRepairOptions layer_options_;
  bool is_enclosed_only_ = false;
  CertificateOption certificate_;
  MapCheckOptions options_;
  Checked checked_;
};

void MapCheck::declare(CLI::App& app) {
  app.add_option("FILE", file_,
                 "A map, or a layer: GeoJSON, TopoJSON, WKT, WKB; - is standard input")
      ->required()
      ->type_name("");
  add_choice(app, "--outer", outer_, {"listed", "infer", "ignore"},
             "Outer boundaries are listed (default for maps), to be inferred (default for "
             "layers), or to be ignored");
  app.add_flag("--edges", checks_edges_,
               "Check the edges of a layer, as those of a map; --outer implies this");
  app.add_option("--gaps-below", layer_options_.gaps_below,
                 "Layers: gaps at least W wide are holes, not defects (default: 1/10000 of the "
                 "diagonal; small lakes are holes, too)")
      ->check(CLI::Range(0.0, 1e300).description(""))
      ->type_name("W");
  app.add_flag("--enclosed-only", is_enclosed_only_,
               "Layers: leave gaps that open to the outside or into a hole");
  app.add_option("--object", read_options_.object, "The object of a TopoJSON file to read")
      ->type_name("NAME");
  app.add_flag("--merge-vertices", options_.merge_vertices,
               "Vertices with equal coordinates become one first");
  app.add_option("--max-defects", options_.max_defects, "Describe at most N defects (default 1000)")
      ->check(CLI::Range(std::uint64_t{0}, std::uint64_t{1} << 40U).description(""))
      ->type_name("N");
  app.add_option("--svg", svg_, "Draw the map and its defects")->type_name("OUT");
  app.add_option("--geojson", geojson_, "Write the defects as GeoJSON")->type_name("OUT");
  certificate_.declare(app);
}

ExitCode MapCheck::run(Session& session) {
  open_outputs(session);
  Context& context = session.context();
  checked_.title = file_name_of(path_of(input_name(file_)).filename());
  session.expect({reading_map(), checking_map(), writing()});
  session.begin("read");
  const LayerText input = read_layer_text(file_, read_options_, context);
  for (const std::string& line : input.notes) note(session, line);
  const std::string& text = input.text;
  const bool is_layer = !checks_edges_ && outer_.empty() && !options_.merge_vertices &&
                        !certificate_.is_given() && begins_like_layer(text);
  const ExitCode code = is_layer ? check_layer_file(session, text) : check_map_file(session, text);
  context.release_memory(text.size());
  return code;
}

/// Finds overlaps and gaps of a layer.
ExitCode MapCheck::check_layer_file(Session& session, std::string_view text) {
  read_options_.name = input_name(file_);
  LayerFile file = read_layer(text, read_options_, session.context());
  require_polygons(file, file_);
  for (const std::string& line : file.notes) note(session, line);
  checked_.layer = std::move(file.layer);
  checked_.crs = std::move(file.crs);
  session.begin("check");
  layer_options_.open_gaps = !is_enclosed_only_;
  checked_.layer_report = check_layer(checked_.layer, layer_options_, session.context());
  session.deliver();
  return checked_.layer_report->has_defects() ? ExitCode::No : ExitCode::Yes;
}

ExitCode MapCheck::check_map_file(Session& session, std::string_view text) {
  Context& context = session.context();
  const ReadOptions read_options{.exact_decimals = session.options().exact_decimals};
  MapFile file = read_map_or_polygons(text, file_, read_options, context);
  if (outer_.empty() && file.is_polygons) outer_ = "infer";
  options_.name_places = file.is_polygons;
  options_.outer = outer_rule(outer_);
  for (const std::string& line : file.notes) note(session, line);
  if (file.dropped > 0) {
    note(session, "passed over: " + std::to_string(file.dropped) +
                      (file.dropped == 1 ? " line or point" : " lines and points"));
  }
  const std::size_t listed_cycles = file.map.cycle_count();
  session.begin("check");
  checked_.map = check_map(std::move(file.map), options_, context);
  certify_map(checked_.map, options_, listed_cycles, session.options(), certificate_);
  session.deliver();
  tell_notes(session);
  return checked_.map.verdict == MapVerdict::Valid ? ExitCode::Yes : ExitCode::No;
}

/// Opens the outputs before the work, so that a path that cannot be written costs no time.
void MapCheck::open_outputs(Session& session) {
  const auto add = [&](const std::string& path, const Format& format) {
    add_output(session, path, format);
  };
  if (!svg_.empty()) add(svg_, format_named(kFormats, "svg"));
  if (!geojson_.empty()) add(geojson_, format_named(kFormats, "geojson"));
  certificate_.open(session);
  add_outputs(session.options(), kFormats, svg_ != "-" && geojson_ != "-", add);
}

void MapCheck::add_output(Session& session, const std::string& path, const Format& format) {
  session.outputs().add(path, [this, &format](std::ostream& out) { format.write(out, checked_); });
}

void MapCheck::tell_notes(Session& session) const {
  for (const MapWarning& warning : checked_.map.warnings) {
    session.note(input_name(file_) + ": warning: " + warning.text);
  }
  const MapDefectCounts& n = checked_.map.counts;
  const std::uint64_t all =
      n.duplicate + n.open + n.crossing + n.twin + n.mixed.value_or(0) + n.nested;
  if (all > checked_.map.defects.size()) {
    session.note(input_name(file_) + ": " + std::to_string(checked_.map.defects.size()) + " of " +
                 std::to_string(all) + " defects are described (--max-defects)");
  }
}

}  // namespace

std::unique_ptr<CommandBody> make_map_check() { return std::make_unique<MapCheck>(); }

namespace {

std::string short_name(const std::string& file) {
  return file_name_of(path_of(input_name(file)).filename());
}

/// Returns the names of the regions. A region has the name of the listed cycle around it.
std::vector<std::string> region_names(const MapReport& report) {
  std::vector<std::string> names;
  for (const MapRegion& region : report.regions) {
    names.push_back(region.outer ? std::to_string(*region.outer + 1) : "");
  }
  return names;
}

/// All data that the command writes.
struct Overlaid {
  OverlayReport report;
  std::string first_name, second_name;
};

void write_text(std::ostream& out, const Overlaid& overlaid) {
  write_overlay_text(out, overlaid.report);
}
void write_json(std::ostream& out, const Overlaid& overlaid) {
  write_overlay_json(out, overlaid.report);
}
void write_geojson(std::ostream& out, const Overlaid& overlaid) {
  write_overlay_geojson(out, overlaid.report);
}
void write_svg(std::ostream& out, const Overlaid& overlaid) {
  write_overlay_svg(out, overlaid.report.overlay,
                    {.title = overlaid.first_name + " over " + overlaid.second_name,
                     .first = overlaid.first_name,
                     .second = overlaid.second_name,
                     .first_names = region_names(overlaid.report.first),
                     .second_names = region_names(overlaid.report.second)});
}

struct OverlayFormat {
  std::string_view name;
  std::string_view extension;
  void (*write)(std::ostream&, const Overlaid&);
};

constexpr std::array kOverlayFormats{
    OverlayFormat{"text", ".txt", write_text},
    OverlayFormat{"json", ".json", write_json},
    OverlayFormat{"svg", ".svg", write_svg},
    OverlayFormat{"geojson", ".geojson", write_geojson},
};

class MapOverlayCommand : public CommandBody {
 public:
  void declare(CLI::App& app) override;
  ExitCode run(Session& session) override;

 private:
  void open_outputs(Session& session);
  void round_cells(Session& session);
  MapReport read_valid(Session& session, const std::string& file) const;

  Overlaid overlaid() const;

  std::string first_file_, second_file_;
  bool infers_outer_ = false;
  bool is_strict_ = false;
  LayerOverlayWords layer_words_;
  RoundingOptions rounding_;
  // The name of the output with coordinates, or empty if there is no such output.
  std::string rounded_output_;
  std::optional<MapReport> first_, second_;
  MapOverlay overlay_;
  OverlayAreas areas_;
  std::optional<RoundedSubdivision> rounded_;
  std::string loss_;  // The effect of rounding.
};

void MapOverlayCommand::declare(CLI::App& app) {
  app.add_option("A", first_file_, "A map or a layer; - is standard input")
      ->required()
      ->type_name("");
  app.add_option("B", second_file_, "Another map, or another layer")->required()->type_name("");
  add_choice(
      app, "--keep", layer_words_.keep, {"all", "first", "both", "first-only"},
      "Layers: keep what any layer covers (default), what A covers, what both cover, or what "
      "only A covers");
  app.add_flag("--areas", layer_words_.with_areas, "Layers: add the area as a property");
  app.add_option("--object", layer_words_.first_object, "Layers: the object to read of TopoJSON A")
      ->type_name("NAME");
  app.add_option("--object-b", layer_words_.second_object,
                 "Layers: the object to read of TopoJSON B")
      ->type_name("NAME");
  app.add_flag("--infer-outer", infers_outer_, "Complete outer boundaries that are not listed");
  app.add_flag("--strict", is_strict_,
               "Exit 2 instead of writing GeoJSON whose cells are reshaped by rounding");
  rounding_.declare(app, true);
}

ExitCode MapOverlayCommand::run(Session& session) {
  if (first_file_ == "-" && second_file_ == "-") {
    throw Error(ErrorCode::Usage, "only one of the maps can be standard input");
  }
  if (is_layer_file(first_file_) || is_layer_file(second_file_)) {
    if (infers_outer_ || is_strict_ || rounding_.is_given()) {
      throw Error(ErrorCode::Usage, "--infer-outer, --strict, --raw and --grid are for maps");
    }
    return overlay_layer_files(session, first_file_, second_file_, layer_words_);
  }
  open_outputs(session);
  session.expect(
      {reading_map(), checking_map(), reading_map(), checking_map(), overlaying_maps(), writing()});
  first_ = read_valid(session, first_file_);
  second_ = read_valid(session, second_file_);
  session.begin("overlay");
  overlay_ = overlay_maps(*first_, *second_, session.context());
  areas_ = measure(overlay_, *first_, *second_, session.context());
  if (!areas_.add_up()) throw std::logic_error("the areas of the cells do not add up");
  round_cells(session);
  session.deliver();
  if (!loss_.empty()) session.note(rounded_output_ + ": warning: " + loss_);
  return ExitCode::Yes;
}

/// Rounds all cells together, if coordinates are written. Throws under --strict if that changes the
/// shape of a cell.
void MapOverlayCommand::round_cells(Session& session) {
  if (rounded_output_.empty()) return;
  const PlaneWriteOptions options = rounding_.read(session);
  rounded_ = options.grid ? round_to_grid(overlay_.complex, *options.grid, session.context())
                          : round_to_doubles(overlay_.complex, session.context());
  loss_ = rounding_sentence(rounded_->report, options);
  if (is_strict_ && !loss_.empty()) {
    throw Error(ErrorCode::CannotWrite, "--strict: " + loss_, {rounded_output_});
  }
  if (!options.grid && options.rounding == OutputRounding::Nearest) rounded_.reset();
}

/// Reads a map. Throws unless it is a valid subdivision, because only these have regions.
MapReport MapOverlayCommand::read_valid(Session& session, const std::string& file) const {
  const ReadOptions read_options{.exact_decimals = session.options().exact_decimals};
  MapCheckOptions options;
  if (infers_outer_) options.outer = OuterRule::Infer;
  session.begin("read");
  Map map = read_map_file(file, read_options, session.context());
  session.begin("check");
  MapReport report = check_map(std::move(map), options, session.context());
  if (report.verdict == MapVerdict::Valid) return report;
  throw Error(ErrorCode::BadArgument,
              "no planar subdivision to overlay: " + std::string(headline(report.verdict)) +
                  (report.defects.empty() ? "" : "; " + report.defects.front().hint) +
                  " (plumb map check tells all)",
              {input_name(file)});
}

/// Opens the outputs before the work, so that a path that cannot be written costs no time.
void MapOverlayCommand::open_outputs(Session& session) {
  add_outputs(session.options(), kOverlayFormats, true,
              [&](const std::string& path, const OverlayFormat& format) {
                if (format.name == "geojson") rounded_output_ = path == "-" ? "stdout" : path;
                session.outputs().add(
                    path, [this, &format](std::ostream& out) { format.write(out, overlaid()); });
              });
  if (rounding_.is_given() && rounded_output_.empty()) {
    throw Error(ErrorCode::Usage, "--raw and --grid are for GeoJSON");
  }
  rounding_.read(session);  // Refuses an invalid grid step before the work.
}

Overlaid MapOverlayCommand::overlaid() const {
  return {{*first_, *second_, overlay_, areas_, rounded_ ? &*rounded_ : nullptr},
          short_name(first_file_),
          short_name(second_file_)};
}

}  // namespace

std::unique_ptr<CommandBody> make_map_overlay() { return std::make_unique<MapOverlayCommand>(); }

}  // namespace plumb::cli
