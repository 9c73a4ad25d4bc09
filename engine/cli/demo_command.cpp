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
#include "plumb/io/map_overlay_writer.h"
#include "plumb/io/map_reader.h"
#include "plumb/io/map_report_json.h"
#include "plumb/io/map_report_text.h"
#include "plumb/io/text_output.h"
#include "plumb/picture/map_svg.h"
#include "plumb/picture/nef2_svg.h"
#include "plumb/picture/overlay_svg.h"
#include "plumb/plane/map_check.h"
#include "plumb/plane/nef2.h"

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

std::string svg_of(const Nef2& set, const std::string& title) {
  std::ostringstream svg;
  write_nef2_svg(svg, set, {.title = title});
  return svg.str();
}

Nef2 star() {
  const std::vector<Point2> corners = {{0, 9},  {-2, 3}, {-9, 3}, {-3, -1}, {-5, -8},
                                       {0, -4}, {5, -8}, {3, -1}, {9, 3},   {2, 3}};
  return Nef2::polygon(corners);
}

/// { x >= -1, y <= 2 }.
Nef2 quadrant() {
  return Nef2::half_plane(Line2::from_coefficients(-1, 0, -1), Boundary::Closed) *
         Nef2::half_plane(Line2::from_coefficients(0, 1, -2), Boundary::Closed);
}

std::string exact_area(const Nef2& set) { return format_exact(set.area().value()); }

void require_sound(const std::optional<DcelFlaw>& flaw) {
  if (flaw) throw std::logic_error("audit: " + flaw->invariant + " at " + flaw->place);
}

class Demo : public CommandBody {
 public:
  void declare(CLI::App& app) override;
  ExitCode run(Session& session) override;

 private:
  void check_defective(Session& session);
  void build_dcel(Session& session);
  void combine_sets(Session& session);
  void overlay(Session& session);
  void write_overlay(Session& session, const OverlayReport& report);
  MapReport check(Session& session, const std::string& file);
  void picture(Session& session, const MapReport& report, const std::string& name,
               const std::string& title);
  void picture(Session& session, const Nef2& set, const std::string& name, const std::string& title,
               const std::string& caption);
  void add_picture(Session& session, DemoPicture picture);
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
  combine_sets(session);
  overlay(session);
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
  require_sound(dcel.audit());
  step(session, "audited every invariant of it: all hold");
  std::ostringstream listing;
  write_map_report_text(listing, report);
  write(session, "us-counties.clean.dcel.txt",
        [listing = listing.str()](std::ostream& out) { out << listing; });
  picture(session, report, "us-counties.clean.svg",
          "The same map without the defective regions: a planar subdivision");
  step(session, "pictured it and wrote the DCEL listing");
}

void Demo::combine_sets(Session& session) {
  const Nef2 a = star(), b = quadrant();
  const Nef2 both = a * b, either = a + b, rest = a - b;
  step(session, "made a star and, of two half-planes, a quadrant; intersected, united, subtracted");
  for (const Nef2* set : {&both, &either, &rest}) require_sound(set->audit());
  const bool adds_up = both + rest == a && (both * rest).is_empty() &&
                       both.area().value() + rest.area().value() == a.area().value();
  if (!adds_up) throw std::logic_error("the parts of the star are not the star");
  step(session, "the star has area " + exact_area(a) + " = " + exact_area(both) + " + " +
                    exact_area(rest) + ", exactly, and is the union of its parts; all audited");
  picture(session, either, "star-or-quadrant.svg", "The star and the quadrant",
          "Their union goes on to infinity.");
  picture(
      session, rest, "star-without-quadrant.svg", "The star without the quadrant",
      "Open where the quadrant was closed: a solid edge is part of the set, a dashed one is not.");
  step(session, "pictured two of them");
}

void Demo::overlay(Session& session) {
  const MapReport states = check(session, "us-states.clean.map");
  const MapReport counties = check(session, "us-counties.clean.map");
  const MapOverlay cells = overlay_maps(states, counties, session.context());
  step(session,
       "laid the states over the counties: " + std::to_string(cells.complex.face_count() - 1) +
           " cells, " + std::to_string(cells.complex.vertex_count()) + " vertices, " +
           std::to_string(cells.complex.edge_count()) + " edges");
  const OverlayAreas areas = measure(cells, states, counties);
  if (!areas.add_up()) throw std::logic_error("the areas of the cells do not add up");
  step(session, "the cells add up to the area of each of " +
                    std::to_string(areas.first.size() - 1) + " regions of the states and " +
                    std::to_string(areas.second.size() - 1) + " of the counties, exactly");
  write_overlay(session, {states, counties, cells, areas});
  step(session, "pictured the cells and wrote them as GeoJSON");
}

void Demo::write_overlay(Session& session, const OverlayReport& report) {
  const std::string title = "States over counties";
  std::ostringstream svg, geojson, summary;
  write_overlay_svg(svg, report.overlay,
                    {.title = title, .first = "the states", .second = "the counties"});
  write_overlay_geojson(geojson, report);
  write_overlay_text(summary, report);
  std::string caption = summary.str();
  caption.resize(caption.find('\n'));
  add_picture(session, {title, "states-over-counties.svg", caption, svg.str()});
  write(session, "states-over-counties.geojson",
        [geojson = geojson.str()](std::ostream& out) { out << geojson; });
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
  add_picture(session, {title, name, summary_of(report), svg_of(report, title)});
}

void Demo::picture(Session& session, const Nef2& set, const std::string& name,
                   const std::string& title, const std::string& caption) {
  add_picture(session, {title, name, caption, svg_of(set, title), true});
}

void Demo::add_picture(Session& session, DemoPicture picture) {
  write(session, picture.file, [svg = picture.svg](std::ostream& out) { out << svg; });
  pictures_.push_back(std::move(picture));
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
