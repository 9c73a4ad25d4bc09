#include <array>
#include <filesystem>
#include <optional>
#include <ostream>
#include <stdexcept>
#include <string>
#include <utility>

#include "command.h"
#include "format_choice.h"
#include "plumb/base/error.h"
#include "plumb/io/input.h"
#include "plumb/io/map_overlay_writer.h"
#include "plumb/io/map_reader.h"
#include "plumb/io/map_report_text.h"
#include "plumb/picture/overlay_svg.h"
#include "progress_stages.h"

namespace plumb::cli {
namespace {

std::string short_name(const std::string& file) {
  return std::filesystem::path(input_name(file)).filename().string();
}

/// Regions are called by the listed cycle around them.
std::vector<std::string> region_names(const MapReport& report) {
  std::vector<std::string> names;
  for (const MapRegion& region : report.regions) {
    names.push_back(region.outer ? std::to_string(*region.outer + 1) : "");
  }
  return names;
}

/// All that is written.
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

struct Format {
  std::string_view name;
  std::string_view extension;
  void (*write)(std::ostream&, const Overlaid&);
};

constexpr std::array kFormats{
    Format{"text", ".txt", write_text},
    Format{"json", ".json", write_json},
    Format{"svg", ".svg", write_svg},
    Format{"geojson", ".geojson", write_geojson},
};

class MapOverlayCommand : public CommandBody {
 public:
  void declare(CLI::App& app) override;
  ExitCode run(Session& session) override;

 private:
  void open_outputs(Session& session);
  MapReport read_valid(Session& session, const std::string& file) const;

  Overlaid overlaid() const;

  std::string first_file_, second_file_;
  bool infers_outer_ = false;
  std::optional<MapReport> first_, second_;
  MapOverlay overlay_;
  OverlayAreas areas_;
};

void MapOverlayCommand::declare(CLI::App& app) {
  app.add_option("A", first_file_, "A map; - is standard input")->required()->type_name("");
  app.add_option("B", second_file_, "Another map")->required()->type_name("");
  app.add_flag("--infer-outer", infers_outer_, "Complete outer boundaries that are not listed");
}

ExitCode MapOverlayCommand::run(Session& session) {
  open_outputs(session);
  session.expect(
      {reading_map(), checking_map(), reading_map(), checking_map(), overlaying_maps(), writing()});
  first_ = read_valid(session, first_file_);
  second_ = read_valid(session, second_file_);
  session.begin("overlay");
  overlay_ = overlay_maps(*first_, *second_, session.context());
  areas_ = measure(overlay_, *first_, *second_, session.context());
  if (!areas_.add_up()) throw std::logic_error("the areas of the cells do not add up");
  session.deliver();
  return ExitCode::Yes;
}

/// Only subdivisions have regions to lay over each other.
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

/// Before the work, so that a path that cannot be written costs nothing.
void MapOverlayCommand::open_outputs(Session& session) {
  if (first_file_ == "-" && second_file_ == "-") {
    throw Error(ErrorCode::Usage, "only one of the maps can be standard input");
  }
  add_outputs(session.options(), kFormats, true,
              [&](const std::string& path, const Format& format) {
                session.outputs().add(
                    path, [this, &format](std::ostream& out) { format.write(out, overlaid()); });
              });
}

Overlaid MapOverlayCommand::overlaid() const {
  return {{*first_, *second_, overlay_, areas_}, short_name(first_file_), short_name(second_file_)};
}

}  // namespace

std::unique_ptr<CommandBody> make_map_overlay() { return std::make_unique<MapOverlayCommand>(); }

}  // namespace plumb::cli
