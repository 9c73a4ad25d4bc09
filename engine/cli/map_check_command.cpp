#include <array>
#include <filesystem>
#include <ostream>
#include <string>
#include <utility>

#include "command_app.h"
#include "format_choice.h"
#include "plumb/io/input.h"
#include "plumb/io/map_reader.h"
#include "plumb/io/map_report_json.h"
#include "plumb/io/map_report_text.h"
#include "plumb/picture/map_svg.h"
#include "plumb/plane/map_check.h"
#include "progress_stages.h"

namespace plumb::cli {
namespace {

using ReportWriter = void (*)(std::ostream&, const MapReport&, const std::string& title);

void write_text(std::ostream& out, const MapReport& report, const std::string&) {
  write_map_report_text(out, report);
}
void write_json(std::ostream& out, const MapReport& report, const std::string&) {
  write_map_report_json(out, report);
}
void write_svg(std::ostream& out, const MapReport& report, const std::string& title) {
  write_map_svg(out, report, {.title = title});
}
void write_geojson(std::ostream& out, const MapReport& report, const std::string&) {
  write_map_report_geojson(out, report);
}

struct Format {
  std::string_view name;
  std::string_view extension;
  ReportWriter write;
};

constexpr std::array kFormats{
    Format{"text", ".txt", write_text},
    Format{"json", ".json", write_json},
    Format{"svg", ".svg", write_svg},
    Format{"geojson", ".geojson", write_geojson},
};

/// Requires one of the three names.
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

  std::string file_;
  std::string outer_ = "listed";
  std::string svg_;
  std::string geojson_;
  MapCheckOptions options_;
  MapReport report_;
};

void MapCheck::declare(CLI::App& app) {
  app.add_option("FILE", file_, "The map; - is standard input")->required()->type_name("");
  add_choice(app, "--outer", outer_, {"listed", "infer", "ignore"},
             "Outer boundaries are listed (default), to be inferred, or to be ignored");
  app.add_flag("--merge-vertices", options_.merge_vertices,
               "Vertices with equal coordinates become one first");
  app.add_option("--max-defects", options_.max_defects, "Describe at most N defects (default 1000)")
      ->check(CLI::Range(std::uint64_t{0}, std::uint64_t{1} << 40U).description(""))
      ->type_name("N");
  app.add_option("--svg", svg_, "Draw the map and its defects")->type_name("OUT");
  app.add_option("--geojson", geojson_, "Write the defects as GeoJSON")->type_name("OUT");
}

ExitCode MapCheck::run(Session& session) {
  options_.outer = outer_rule(outer_);
  open_outputs(session);
  Context& context = session.context();
  const ReadOptions read_options{.exact_decimals = session.options().exact_decimals};
  session.expect({reading_map(), checking_map(), writing()});
  session.begin("read");
  Map map = read_map_file(file_, read_options, context);
  session.begin("check");
  report_ = check_map(std::move(map), options_, context);
  session.deliver();
  tell_notes(session);
  return report_.verdict == MapVerdict::Valid ? ExitCode::Yes : ExitCode::No;
}

/// Before the work, so that a path that cannot be written costs nothing.
void MapCheck::open_outputs(Session& session) {
  const auto add = [&](const std::string& path, const Format& format) {
    add_output(session, path, format);
  };
  if (!svg_.empty()) add(svg_, format_named(kFormats, "svg"));
  if (!geojson_.empty()) add(geojson_, format_named(kFormats, "geojson"));
  add_outputs(session.options(), kFormats, svg_ != "-" && geojson_ != "-", add);
}

void MapCheck::add_output(Session& session, const std::string& path, const Format& format) {
  session.outputs().add(path, [this, &format](std::ostream& out) {
    format.write(out, report_, std::filesystem::path(input_name(file_)).filename().string());
  });
}

void MapCheck::tell_notes(Session& session) const {
  for (const MapWarning& warning : report_.warnings) {
    session.note(input_name(file_) + ": warning: " + warning.text);
  }
  const MapDefectCounts& n = report_.counts;
  const std::uint64_t all =
      n.duplicate + n.open + n.crossing + n.twin + n.mixed.value_or(0) + n.nested;
  if (all > report_.defects.size()) {
    session.note(input_name(file_) + ": " + std::to_string(report_.defects.size()) + " of " +
                 std::to_string(all) + " defects are described (--max-defects)");
  }
}

}  // namespace

std::unique_ptr<CommandBody> make_map_check() { return std::make_unique<MapCheck>(); }

}  // namespace plumb::cli
