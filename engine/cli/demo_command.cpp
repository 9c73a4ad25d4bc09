#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <optional>
#include <ostream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "command.h"
#include "demo_page.h"
#include "plumb/base/error.h"
#include "plumb/io/map_reader.h"
#include "plumb/io/map_report_json.h"
#include "plumb/io/map_report_text.h"
#include "plumb/picture/map_svg.h"
#include "plumb/plane/map_check.h"

namespace plumb::cli {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

/// The bundled data: $PLUMB_ROOT, else where this program was built from.
fs::path corpus() {
  const char* const root = std::getenv("PLUMB_ROOT");
  return fs::path(root != nullptr && *root != '\0' ? root : PLUMB_SOURCE_DIR) / "corpus";
}

std::string summary_of(const MapReport& report) {
  const MapDefectCounts& n = report.counts;
  std::ostringstream text;
  text << headline(report.verdict) << ": " << report.vertices << " vertices, " << report.edges
       << " edges, " << report.cycles << " listed cycles, " << report.components << " components";
  if (report.verdict != MapVerdict::Valid) {
    text << "; duplicate " << n.duplicate << ", open " << n.open << ", crossing " << n.crossing
         << ", twin " << n.twin;
  }
  return text.str();
}

std::string svg_of(const MapReport& report, const std::string& title) {
  std::ostringstream svg;
  write_map_svg(svg, report, {.title = title});
  return svg.str();
}

class Demo : public CommandBody {
 public:
  void declare(CLI::App& app) override;
  ExitCode run(Session& session) override;

 private:
  void check_defective(Session& session);
  void build_dcel(Session& session);
  MapReport check(Session& session, const std::string& file);
  void picture(Session& session, const MapReport& report, const std::string& name,
               const std::string& title);
  void write(Session& session, const std::string& name, Outputs::Writer writer);
  /// Prints what was done since the last step, and how long it took.
  void step(Session& session, const std::string& what);

  fs::path directory_ = "plumb-demo";
  Clock::time_point step_start_;
  std::vector<DemoStep> steps_;
  std::vector<DemoPicture> pictures_;
};

void Demo::declare(CLI::App&) {}

ExitCode Demo::run(Session& session) {
  if (!session.options().out.empty()) directory_ = session.options().out;
  std::error_code error;
  fs::create_directories(directory_, error);
  if (error) throw Error(ErrorCode::CannotWrite, error.message(), {directory_.string()});
  step_start_ = Clock::now();
  check_defective(session);
  build_dcel(session);
  write(session, "index.html",
        [this](std::ostream& out) { write_demo_page(out, steps_, pictures_); });
  session.outputs().add("-", [this](std::ostream& out) {
    write_demo_steps(out, steps_);
    out << "open " << (directory_ / "index.html").string() << '\n';
  });
  session.finish_progress();
  session.outputs().deliver();
  return ExitCode::Yes;
}

void Demo::check_defective(Session& session) {
  const MapReport report = check(session, "us-counties.map");
  picture(session, report, "us-counties.svg",
          "US counties as published: the defects, each numbered and explained");
  std::ostringstream text;
  write_map_report_text(text, report);
  write(session, "us-counties.txt", [text = text.str()](std::ostream& out) { out << text; });
  std::ostringstream geojson;
  write_map_report_geojson(geojson, report);
  write(session, "us-counties.geojson",
        [geojson = geojson.str()](std::ostream& out) { out << geojson; });
  step(session, "pictured them and wrote report and GeoJSON");
}

void Demo::build_dcel(Session& session) {
  const MapReport report = check(session, "us-counties.clean.map");
  const Dcel dcel = to_dcel(report).dcel;
  step(session, "turned it into a half-edge structure: " + std::to_string(dcel.halfedge_count()) +
                    " half-edges, " + std::to_string(dcel.loop_count()) + " loops, " +
                    std::to_string(dcel.face_count()) + " faces");
  const std::optional<DcelFlaw> flaw = dcel.audit();
  if (flaw) throw std::logic_error("audit: " + flaw->invariant + " at " + flaw->place);
  step(session, "audited every invariant of it: all hold");
  std::ostringstream listing;
  write_map_report_text(listing, report);
  write(session, "us-counties.clean.dcel.txt",
        [listing = listing.str()](std::ostream& out) { out << listing; });
  picture(session, report, "us-counties.clean.svg",
          "The same map without the defective regions: a planar subdivision");
  step(session, "pictured it and wrote the DCEL listing");
}

MapReport Demo::check(Session& session, const std::string& file) {
  Map map = read_map_file((corpus() / "maps" / file).string(), {}, session.context());
  step(session, "read " + file + ": " + std::to_string(map.cycle_count()) + " cycles");
  MapReport report = check_map(std::move(map), {}, session.context());
  step(session, "checked it, exactly - " + summary_of(report));
  return report;
}

void Demo::picture(Session& session, const MapReport& report, const std::string& name,
                   const std::string& title) {
  std::string svg = svg_of(report, title);
  pictures_.push_back({title, name, summary_of(report), svg});
  write(session, name, [svg = std::move(svg)](std::ostream& out) { out << svg; });
}

void Demo::write(Session& session, const std::string& name, Outputs::Writer writer) {
  session.outputs().add((directory_ / name).string(), std::move(writer));
}

void Demo::step(Session&, const std::string& what) {
  const auto now = Clock::now();
  steps_.push_back({what, std::chrono::duration<double>(now - step_start_).count()});
  step_start_ = now;
}

}  // namespace

std::unique_ptr<CommandBody> make_demo() { return std::make_unique<Demo>(); }

}  // namespace plumb::cli
