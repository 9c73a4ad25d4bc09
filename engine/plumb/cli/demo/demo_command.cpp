// The command `plumb demo`, and its chapters on the plane: defective maps, DCELs, sets, and
// overlays.
//
// Each chapter reads bundled data, runs the library as a command would, times every step, and
// requires that audits pass, so the demo is a test of the whole program as well.
// Tested by tests/cli/program_test.cpp.
#include <optional>
#include <ostream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "plumb/cli/demo/demo_book.h"
#include "plumb/cli/files/outputs.h"
#include "plumb/cli/session/command.h"
#include "plumb/cli/session/progress.h"
#include "plumb/io/map_io.h"
#include "plumb/io/map_report_io.h"
#include "plumb/io/plane/map_overlay_writer.h"
#include "plumb/io/text/file_names.h"
#include "plumb/io/text/text_output.h"
#include "plumb/picture/overlay_svg.h"
#include "plumb/plane/map_check.h"
#include "plumb/plane/nef2.h"

namespace plumb::cli {
namespace {

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

Nef2 star() {
  const std::vector<Point2> corners = {{0, 9},  {-2, 3}, {-9, 3}, {-3, -1}, {-5, -8},
                                       {0, -4}, {5, -8}, {3, -1}, {9, 3},   {2, 3}};
  return Nef2::polygon(corners);
}

/// Returns { x >= -1, y <= 2 }.
Nef2 quadrant() {
  return Nef2::half_plane(Line2::from_coefficients(-1, 0, -1), Boundary::Closed) *
         Nef2::half_plane(Line2::from_coefficients(0, 1, -2), Boundary::Closed);
}

std::string exact_area(const Nef2& set) { return format_exact(set.area().value()); }

void require_sound(const std::optional<DcelFlaw>& flaw) {
  if (flaw) throw std::logic_error("audit: " + flaw->invariant + " at " + flaw->place);
}

/// The chapters on the plane.
class PlaneDemo {
 public:
  explicit PlaneDemo(DemoBook& book) : book_(book) {}

  void check_defective();
  void build_dcel();
  void combine_sets();
  void overlay();

 private:
  void write_overlay(const OverlayReport& report);
  MapReport check(const std::string& file);
  void picture(const MapReport& report, const std::string& name, const std::string& title);
  void picture(const Nef2& set, const std::string& name, const std::string& title,
               const std::string& caption);

  DemoBook& book_;
};

void PlaneDemo::check_defective() {
  book_.chapter("A map, checked",
                "Is every point of the plane covered once by these regions? All defects, exactly.");
  const MapReport report = check("us-counties.map");
  picture(report, "us-counties.svg",
          "US counties as published: the defects, each numbered and explained");
  std::ostringstream text;
  write_map_report_text(text, report);
  book_.write("us-counties.txt", text.str());
  std::ostringstream geojson;
  write_map_report_geojson(geojson, report);
  book_.write("us-counties.geojson", geojson.str());
  book_.step("pictured them and wrote report and GeoJSON");
}

void PlaneDemo::build_dcel() {
  book_.chapter("A clean map", "Without the defective regions it becomes a half-edge structure.");
  const MapReport report = check("us-counties.clean.map");
  const Dcel dcel = to_dcel(report).dcel;
  book_.step("turned it into a half-edge structure: " + std::to_string(dcel.halfedge_count()) +
             " half-edges, " + std::to_string(dcel.loop_count()) + " loops, " +
             std::to_string(dcel.face_count()) + " faces");
  require_sound(dcel.audit());
  book_.step("audited every invariant of it: all hold");
  std::ostringstream listing;
  write_map_report_text(listing, report);
  book_.write("us-counties.clean.dcel.txt", listing.str());
  picture(report, "us-counties.clean.svg",
          "The same map without the defective regions: a planar subdivision");
  book_.step("pictured it and wrote the DCEL listing");
}

void PlaneDemo::combine_sets() {
  book_.chapter("Sets of the plane", "Open or closed along every edge, bounded or not.");
  const Nef2 a = star(), b = quadrant();
  const Nef2 both = a * b, either = a + b, rest = a - b;
  book_.step("made a star and, of two half-planes, a quadrant; intersected, united, subtracted");
  for (const Nef2* set : {&both, &either, &rest}) require_sound(set->audit());
  const bool adds_up = both + rest == a && (both * rest).is_empty() &&
                       both.area().value() + rest.area().value() == a.area().value();
  if (!adds_up) throw std::logic_error("the parts of the star are not the star");
  book_.step("the star has area " + exact_area(a) + " = " + exact_area(both) + " + " +
             exact_area(rest) + ", exactly, and is the union of its parts; all audited");
  picture(either, "star-or-quadrant.svg", "The star and the quadrant",
          "Their union goes on to infinity.");
  picture(
      rest, "star-without-quadrant.svg", "The star without the quadrant",
      "Open where the quadrant was closed: a solid edge is part of the set, a dashed one is not.");
  book_.step("pictured two of them");
}

void PlaneDemo::overlay() {
  book_.chapter("Two maps, laid over each other", "Areas add up to the last digit.");
  const MapReport states = check("us-states.clean.map");
  const MapReport counties = check("us-counties.clean.map");
  const MapOverlay cells = overlay_maps(states, counties, book_.session().context());
  book_.step(
      "laid the states over the counties: " + std::to_string(cells.complex.face_count() - 1) +
      " cells, " + std::to_string(cells.complex.vertex_count()) + " vertices, " +
      std::to_string(cells.complex.edge_count()) + " edges");
  const OverlayAreas areas = measure(cells, states, counties, book_.session().context());
  if (!areas.add_up()) throw std::logic_error("the areas of the cells do not add up");
  book_.step("the cells add up to the area of each of " + std::to_string(areas.first.size() - 1) +
             " regions of the states and " + std::to_string(areas.second.size() - 1) +
             " of the counties, exactly");
  write_overlay({states, counties, cells, areas});
  book_.step("pictured the cells and wrote them as GeoJSON");
}

void PlaneDemo::write_overlay(const OverlayReport& report) {
  const std::string title = "States over counties";
  std::ostringstream svg, geojson, summary;
  write_overlay_svg(svg, report.overlay,
                    {.title = title, .first = "the states", .second = "the counties"});
  write_overlay_geojson(geojson, report);
  write_overlay_text(summary, report);
  std::string caption = summary.str();
  caption.resize(caption.find('\n'));
  book_.add({title, "states-over-counties.svg", caption, svg.str()});
  book_.write("states-over-counties.geojson", geojson.str());
}

MapReport PlaneDemo::check(const std::string& file) {
  Map map = read_map_file(DemoBook::bundled("maps/" + file), {}, book_.session().context());
  book_.step("read " + file + ": " + std::to_string(map.cycle_count()) + " cycles");
  MapReport report = check_map(std::move(map), {}, book_.session().context());
  book_.step("checked it, exactly - " + summary_of(report));
  return report;
}

void PlaneDemo::picture(const MapReport& report, const std::string& name,
                        const std::string& title) {
  book_.add(
      {title, name, summary_of(report),
       picture_of(report, cli::picture(PictureFormat::Svg, title), book_.session().context())});
}

void PlaneDemo::picture(const Nef2& set, const std::string& name, const std::string& title,
                        const std::string& caption) {
  book_.add({title, name, caption,
             picture_of(set, cli::picture(PictureFormat::Svg, title), book_.session().context()),
             true});
}

class Demo : public CommandBody {
 public:
  void declare(CLI::App&) override {}

  ExitCode run(Session& session) override {
    const std::string& out = session.options().out;
    session.expect(stages_of_demo());
    DemoBook book(path_of(out.empty() ? "plumb-demo" : out), session);
    PlaneDemo plane(book);
    plane.check_defective();
    plane.build_dcel();
    plane.combine_sets();
    plane.overlay();
    demonstrate_solids(book);
    demonstrate_models(book);
    demonstrate_convex(book);
    demonstrate_surfaces(book);
    book.finish();
    return ExitCode::Yes;
  }
};

}  // namespace

std::unique_ptr<CommandBody> make_demo() { return std::make_unique<Demo>(); }

}  // namespace plumb::cli
