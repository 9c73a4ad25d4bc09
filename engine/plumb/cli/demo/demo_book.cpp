// The book of `plumb demo`: its page, its files, and the chapters on solids, convex pieces and
// surfaces.
//
// Pictures are embedded as data addresses, so that the styles and ids of one SVG do not affect
// another, and pages that can be turned are embedded as text that is loaded on demand. Each chapter
// does real work with the library and checks what it claims: volumes of parts must add up exactly,
// audits must pass, and a claim that fails throws.
// Declared in cli/demo/demo_book.h.
// Tested by tests/cli/program_test.cpp.
#include "plumb/cli/demo/demo_book.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <numeric>
#include <ostream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include "plumb/base/set_expression.h"
#include "plumb/cli/files/outputs.h"
#include "plumb/convex/decompose.h"
#include "plumb/csg/evaluate.h"
#include "plumb/io/csg_reader.h"
#include "plumb/io/scene_reader.h"
#include "plumb/io/solid/solid_text.h"
#include "plumb/io/solid_io.h"
#include "plumb/io/surface_writer.h"
#include "plumb/io/text/file_names.h"
#include "plumb/io/text/text_output.h"
#include "plumb/picture/space_svg.h"
#include "plumb/picture/surface_scene.h"
#include "plumb/picture/svg/sheet.h"
#include "plumb/predicates/error.h"
#include "plumb/predicates/rounding.h"
#include "plumb/space/nef3.h"
#include "plumb/space/space_audit.h"
#include "plumb/space/space_measure.h"
#include "plumb/surface/surface_audit.h"

namespace plumb::cli {
namespace {

constexpr std::string_view kHead = R"(<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>plumb demo</title>
<style>
body { font: 16px/1.5 system-ui, sans-serif; margin: 2rem auto; max-width: 75rem; padding: 0 1rem; }
h2 { margin: 3rem 0 0.5rem; }
.pictures { display: grid; grid-template-columns: repeat(auto-fill, minmax(min(100%, 30rem), 1fr)); gap: 1.5rem; }
.pictures { margin-top: 1rem; align-items: start; }
figure { margin: 0; min-width: 0; }
figure.wide { grid-column: 1 / -1; }
figure img { width: 100%; height: auto; border: 1px solid #ccc; box-sizing: border-box; display: block; }
.sheet { overflow-x: auto; }
.sheet img { min-width: 50rem; }
.scrolls { display: none; color: #444; margin: 0 0 0.3rem; }
@media (max-width: 52rem) { .scrolls { display: block; } }
figure iframe { width: 100%; height: min(80vh, 40rem); border: 1px solid #ccc; box-sizing: border-box; display: block; }
figure button { font: inherit; margin: 0.5rem 0 0; padding: 0.3rem 1rem; cursor: pointer; }
figcaption { color: #444; margin-top: 0.3rem; overflow-wrap: anywhere; }
table { border-spacing: 0; }
td { padding: 0.1rem 1rem 0.1rem 0; vertical-align: top; overflow-wrap: anywhere; }
td.time { text-align: right; white-space: nowrap; font-variant-numeric: tabular-nums; }
</style>
</head>
<body>
<h1>plumb demo</h1>
<p>What plumb does, on real data, with the time each step took here. Solids and surfaces can be turned around.</p>
)";

std::string escaped(std::string_view text) {
  std::string html;
  for (const char c : text) {
    if (c == '&') {
      html += "&amp;";
    } else if (c == '<') {
      html += "&lt;";
    } else if (c == '"') {
      html += "&quot;";
    } else {
      html += c;
    }
  }
  return html;
}

std::string milliseconds(double seconds) {
  char text[32];
  std::snprintf(text, sizeof text, "%.1f ms", seconds * 1000);
  return text;
}

/// Returns an SVG file as a data address, so that its styles and ids do not affect other pictures.
std::string data_uri(std::string_view svg) {
  static constexpr std::string_view kHex = "0123456789ABCDEF";
  std::string uri = "data:image/svg+xml,";
  for (const char c : svg) {
    const auto byte = static_cast<unsigned char>(c);
    const bool is_plain = byte > 0x20 && byte < 0x7F &&
                          std::string_view("\"#%<>&\\^`{|}").find(c) == std::string_view::npos;
    if (is_plain || c == ' ') {
      uri += c;
    } else {
      uri += {'%', kHex[byte >> 4U], kHex[byte & 15U]};
    }
  }
  return uri;
}

/// A script that embeds a page in this page when its button is pressed, because a browser cannot
/// show many such pages at the same time.
constexpr std::string_view kTurning = R"(<script>
for (const button of document.querySelectorAll('figure button')) button.addEventListener('click', () => {
  const frame = document.createElement('iframe');
  frame.title = button.title;
  frame.srcdoc = button.dataset.page;
  button.previousElementSibling.replaceWith(frame);
  button.remove();
});
</script>
)";

void write_picture(std::ostream& out, const DemoPicture& picture) {
  const std::string title = escaped(picture.title);
  // On a phone, the text of the picture would be too small, so the picture scrolls there.
  const bool is_wide = !picture.is_small;
  out << (is_wide ? "<figure class=\"wide\">\n<p class=\"scrolls\">Drag the picture sideways to "
                    "see all "
                    "of it.</p>\n<div class=\"sheet\">"
                  : "<figure>\n")
      << "<img alt=\"" << title << "\" src=\"" << data_uri(picture.svg) << "\">"
      << (is_wide ? "</div>\n" : "\n");
  if (!picture.page.empty()) {
    out << "<button title=\"" << title << "\" data-page=\"" << escaped(picture.page)
        << "\">Turn it around</button>\n";
  }
  out << "<figcaption>" << escaped(picture.caption) << " (<a href=\"" << picture.file << "\">"
      << picture.file << "</a>)</figcaption>\n</figure>\n";
}

void write_row(std::ostream& out, double seconds, const std::string& html) {
  out << "<tr><td class=\"time\">" << milliseconds(seconds) << "</td><td>" << html
      << "</td></tr>\n";
}

/// Writes the contents, and how long each chapter took in all.
void write_contents(std::ostream& out, const std::vector<DemoChapter>& chapters) {
  out << "<table>\n";
  for (std::size_t i = 0; i < chapters.size(); ++i) {
    write_row(out, chapters[i].seconds(),
              "<a href=\"#chapter-" + std::to_string(i) + "\">" + escaped(chapters[i].title) +
                  "</a>: " + escaped(chapters[i].claim));
  }
  out << "</table>\n";
}

void write_chapter(std::ostream& out, const DemoChapter& chapter, std::size_t number) {
  out << "<h2 id=\"chapter-" << number << "\">" << escaped(chapter.title) << "</h2>\n<p>"
      << escaped(chapter.claim) << "</p>\n<table>\n";
  for (const DemoStep& step : chapter.steps) write_row(out, step.seconds, escaped(step.what));
  out << "</table>\n<div class=\"pictures\">\n";
  for (const DemoPicture& picture : chapter.pictures) write_picture(out, picture);
  out << "</div>\n";
}

}  // namespace

double DemoChapter::seconds() const {
  return std::accumulate(steps.begin(), steps.end(), 0.0,
                         [](double sum, const DemoStep& step) { return sum + step.seconds; });
}

void write_demo_steps(std::ostream& out, const std::vector<DemoChapter>& chapters) {
  for (const DemoChapter& chapter : chapters) {
    out << chapter.title << '\n';
    for (const DemoStep& step : chapter.steps) {
      const std::string time = milliseconds(step.seconds);
      out << std::string(time.size() < 10 ? 10 - time.size() : 0, ' ') << time << "  " << step.what
          << '\n';
    }
  }
}

void write_demo_page(std::ostream& out, const std::vector<DemoChapter>& chapters) {
  out << kHead;
  write_contents(out, chapters);
  for (std::size_t i = 0; i < chapters.size(); ++i) write_chapter(out, chapters[i], i);
  out << kTurning << "</body>\n</html>\n";
}

namespace {

namespace fs = std::filesystem;

nlohmann::ordered_json demo_json(const std::string& page,
                                 const std::vector<DemoChapter>& chapters) {
  nlohmann::ordered_json json{{"page", page}, {"steps", nullptr}, {"pictures", nullptr}};
  for (const DemoChapter& chapter : chapters) {
    for (const DemoStep& step : chapter.steps) {
      json["steps"].push_back(
          {{"chapter", chapter.title}, {"what", step.what}, {"seconds", step.seconds}});
    }
    for (const DemoPicture& p : chapter.pictures) {
      json["pictures"].push_back({{"chapter", chapter.title},
                                  {"title", p.title},
                                  {"file", p.file},
                                  {"caption", p.caption}});
    }
  }
  return json;
}

}  // namespace

DemoBook::DemoBook(fs::path directory, Session& session)
    : directory_(std::move(directory)), session_(session) {
  std::error_code error;
  fs::create_directories(directory_, error);
  if (error) throw Error(ErrorCode::CannotWrite, error.message(), {file_name_of(directory_)});
}

/// The file is in $PLUMB_ROOT if this variable is set. Otherwise, it is in the sources from which
/// the program was built, if they exist. Otherwise, it is where `cmake --install` and the packages
/// install it.
std::string DemoBook::bundled(const std::string& file) {
  const char* const root = std::getenv("PLUMB_ROOT");
  if (root != nullptr && *root != '\0') return file_name_of(path_of(root) / "corpus" / file);
  const fs::path in_sources = fs::path(PLUMB_SOURCE_DIR) / "corpus" / file;
  std::error_code error;
  if (fs::exists(in_sources, error)) return in_sources.string();
  return (fs::path(PLUMB_INSTALLED_DATA) / "corpus" / file).string();
}

void DemoBook::chapter(std::string title, std::string claim) {
  session_.begin("chapter");
  chapters_.push_back({std::move(title), std::move(claim)});
}

void DemoBook::step(const std::string& what) {
  const auto now = Clock::now();
  chapters_.back().steps.push_back(
      {what, std::chrono::duration<double>(now - step_start_).count()});
  step_start_ = now;
}

void DemoBook::write(const std::string& name, std::string bytes) {
  session_.outputs().add(file_name_of(directory_ / name),
                         [bytes = std::move(bytes)](std::ostream& out) { out << bytes; });
}

void DemoBook::add(DemoPicture picture) {
  write(picture.file, picture.svg);
  if (!picture.page.empty()) {
    write(fs::path(picture.file).replace_extension(".html").string(), picture.page);
  }
  chapters_.back().pictures.push_back(std::move(picture));
}

std::string in_full(const Rational& value) {
  constexpr std::size_t kShort = 40;
  std::string exact = format_exact(value);
  if (exact.size() <= kShort) return exact;
  return "about " + format_double(nearest_double(value)) + ", exactly " + exact;
}

void DemoBook::finish() {
  session_.outputs().add(file_name_of(directory_ / "index.html"),
                         [this](std::ostream& out) { write_demo_page(out, chapters_); });
  session_.outputs().add("-", [this](std::ostream& out) {
    const std::string page = file_name_of(directory_ / "index.html");
    if (session_.options().json) {
      out << demo_json(page, chapters_).dump() << '\n';
      return;
    }
    write_demo_steps(out, chapters_);
    out << "open " << page << '\n';
  });
  session_.deliver();
}

// The chapter on sets of space: two solids combined, what is open, what is unbounded.

namespace {

Rational volume_of(const Nef3& set) { return marked_volume(set.complex()).value(); }

void require_sound(const Nef3& set) {
  const auto flaw = audit(set.complex(), AuditForm::Minimal);
  if (flaw) throw std::logic_error("audit: " + flaw->invariant + " at " + flaw->place);
}

std::string written(const Nef3& set, std::string_view format, Context& context) {
  for (const SolidFormat& f : solid_formats()) {
    if (f.name != format) continue;
    std::ostringstream out;
    SolidText(set, f, OutputRounding::Valid, context).write(out, context);
    return std::move(out).str();
  }
  throw std::logic_error("no such format");
}

class SolidDemo {
 public:
  explicit SolidDemo(DemoBook& book) : book_(book), context_(book.session().context()) {}

  void run() {
    const Nef3 bunny = read("bunny.off"), ball = read("ball.off");
    const Nef3 bitten = combine_both(bunny, ball);
    find_openness(bunny, ball, bitten);
    leave_a_mould(bunny);
  }

 private:
  Nef3 read(const std::string& file) {
    Nef3 set = read_solid_file(DemoBook::bundled("solids/" + file), {}, context_).set;
    book_.step("read " + file + ": " + facts_of(set));
    return set;
  }

  Nef3 timed(Nef3 set, const std::string& what) {
    book_.step(what + ": " + facts_of(set));
    return set;
  }

  /// Combines both solids. The volumes are fractions with thousands of digits, and must add up
  /// exactly. The difference and the second solid must be disjoint, and their union the union.
  Nef3 combine_both(const Nef3& a, const Nef3& b) {
    const Nef3 either = timed(a + b, "united the two");
    const Nef3 both = timed(a * b, "intersected them");
    Nef3 rest = timed(a - b, "subtracted the second from the first");
    for (const Nef3* set : {&either, &both, &std::as_const(rest)}) require_sound(*set);
    book_.step("audited every invariant of the three: all hold");
    const bool adds_up = volume_of(either) + volume_of(both) == volume_of(a) + volume_of(b) &&
                         volume_of(rest) + volume_of(both) == volume_of(a) && rest + b == either &&
                         (rest * b).is_empty();
    if (!adds_up) throw std::logic_error("the parts of the solids are not the solids");
    book_.step(
        "union and intersection have the volume of both solids together, to the last digit: " +
        in_full(volume_of(a) + volume_of(b)));
    picture(either, "bunny-or-ball.svg", "The bunny and the ball", "Their union.");
    picture(both, "bunny-and-ball.svg", "What is in both", "Their intersection.");
    picture(rest, "bunny-without-ball.svg", "The bunny without the ball",
            "Open where the ball was, which is closed.");
    book_.write("bunny-without-ball.nef", written(rest, "nef", context_));
    book_.write("bunny-without-ball.off", written(rest, "off", context_));
    book_.step(
        "pictured them, with pages to turn them around; wrote the last one as .nef and as a mesh");
    return rest;
  }

  /// Finds a corner of the ball inside the bunny: it is on the boundary of the difference, but not
  /// part of it.
  void find_openness(const Nef3& bunny, const Nef3& ball, const Nef3& rest) {
    for (const SpacePoint p : ball.complex().vertex_point) {
      const Point3 at = ball.complex().planes().point(p.input());
      const SpaceLocation inside = bunny.locate(at);
      if (inside.item.kind() != SpaceItem::Kind::Volume || !inside.marked) continue;
      const SpaceLocation before = rest.locate(at), after = rest.closure().locate(at);
      if (before.marked || !after.marked || before.item.kind() != SpaceItem::Kind::Vertex) break;
      std::ostringstream text;
      text << "located (" << at.x << ", " << at.y << ", " << at.z
           << "), a corner of the ball inside the bunny: a vertex of the difference and not in it; "
              "in its closure";
      book_.step(text.str());
      return;
    }
    throw std::logic_error("the difference is not open where the ball was");
  }

  void leave_a_mould(const Nef3& bunny) {
    const Nef3 below = Nef3::half_space({0, -1, 0, 0}, Boundary::Closed);
    const Nef3 mould = timed(below - bunny, "subtracted the bunny from a half-space");
    require_sound(mould);
    if (mould.is_bounded() || mould + (bunny * below) != below) {
      throw std::logic_error("the mould and its half of the bunny are not the half-space");
    }
    book_.step("with its half of the bunny it is the half-space again; audited");
    picture(mould, "mould.svg", "A mould of the bunny",
            "A half-space without the bunny: goes on to infinity, open towards the cavity.");
    book_.step("pictured it");
  }

  void picture(const Nef3& set, const std::string& name, const std::string& title,
               const std::string& caption) {
    book_.add({title, name, caption,
               picture_of(set, cli::picture(PictureFormat::Svg, title), context_), true,
               picture_of(set, cli::picture(PictureFormat::Html, title), context_)});
  }

  DemoBook& book_;
  Context& context_;
};

}  // namespace

void demonstrate_solids(DemoBook& book) {
  book.chapter("Solids", "United, intersected, subtracted: volumes add up to the last digit.");
  SolidDemo(book).run();
}

// The chapter on models: a tree of OpenSCAD, evaluated exactly.

namespace {

/// Returns the number of nodes whose values were computed separately.
std::size_t computed_nodes(const CsgResult& result) {
  return static_cast<std::size_t>(
      std::count_if(result.nodes.begin(), result.nodes.end(),
                    [](const CsgNodeReport& node) { return node.work == CsgWork::Computed; }));
}

}  // namespace

void demonstrate_models(DemoBook& book) {
  book.chapter("A model of OpenSCAD", "Exact from the primitives to the result.");
  Context& context = book.session().context();
  const CsgRead model = read_csg_file(DemoBook::bundled("csg/bracket.csg"), {}, context);
  book.step("read bracket.csg, as OpenSCAD writes it: " +
            counted(model.tree.nodes.size() - 1, "node"));
  const CsgResult result = evaluate(model.tree, context);
  book.step("evaluated it, " + counted(computed_nodes(result), "node") +
            " after rewriting: " + facts_of(result.solid));
  require_sound(result.solid);
  if (!result.solid.is_closed() || result.solid.regularization(context) != result.solid) {
    throw std::logic_error("the bracket is not a closed regular set");
  }
  book.step(
      "audited every invariant: all hold; it is the closure of its interior, and its volume is " +
      in_full(volume_of(result.solid)));
  const std::string title = "A bracket";
  book.add({title, "bracket.svg", "A plate with a rib, a hull and three bores.",
            picture_of(result.solid, cli::picture(PictureFormat::Svg, title), context), true,
            picture_of(result.solid, cli::picture(PictureFormat::Html, title), context)});
  book.write("bracket.off", written(result.solid, "off", context));
  book.step("pictured it, and wrote it as a mesh");
}

// The chapter on convex pieces: the five polyhedra of the cutting problem and a comb, cut and moved
// apart.

namespace {

constexpr double kApart = .5;

Nef3 box(const std::array<double, 3>& low, const std::array<double, 3>& high, Context& context) {
  std::vector<HalfSpace3> sides;
  for (std::size_t i = 0; i < 3; ++i) {
    std::array<double, 3> n{0, 0, 0};
    n[i] = 1;
    sides.push_back({{n[0], n[1], n[2], -high[i]}, Boundary::Closed});
    sides.push_back({{-n[0], -n[1], -n[2], low[i]}, Boundary::Closed});
  }
  return Nef3::intersection(sides, context);
}

class ConvexDemo {
 public:
  explicit ConvexDemo(DemoBook& book) : book_(book), context_(book.session().context()) {}

  void run() {
    for (const char* name : {"test_zero", "test_one", "test_two", "test_three", "test_four"}) {
      const std::string file = std::string("polyhedra/") + name + ".off";
      show(read_solid_file(DemoBook::bundled(file), {}, context_).set, name);
    }
    show(comb(12), "comb");
  }

 private:
  /// Returns a bar with teeth along one direction above and along the other below, so that notches
  /// cross.
  Nef3 comb(int teeth) {
    std::vector<Nef3> parts{box({0, 0, -1}, {2. * teeth - 1, 2. * teeth - 1, 1}, context_)};
    for (int i = 0; i + 1 < teeth; ++i) {
      const double from = 2. * i + 1, to = from + 1, all = 2. * teeth - 1;
      parts.push_back(box({from, 0, .25}, {to, all, 1}, context_));
      parts.push_back(box({0, from, -1}, {all, to, -.25}, context_));
    }
    const Nef3 notches = union_of(std::span(parts).subspan(1), context_);
    return (parts.front() - notches).closure();
  }

  void show(const Nef3& set, const std::string& name) {
    const ConvexPieces cut = decompose(set, {}, context_);
    const std::string pieces = counted(cut.pieces.size(), "convex piece");
    book_.step("cut " + name + ", which has " + counted(cut.reflex_edges, "reflex edge") +
               ", into " + pieces);
    Rational sum = 0;
    for (const Nef3& piece : cut.pieces) {
      sum += marked_volume(piece.complex()).value();
      if (!piece.closure().is_convex()) throw std::logic_error("a piece is not convex");
    }
    if (sum != marked_volume(set.complex()).value() || union_of(cut.pieces, context_) != set) {
      throw std::logic_error("the pieces are not the solid");
    }
    book_.step("the closure of each is convex; their union is " + name +
               ", their volumes add up to " + in_full(sum));
    const std::string title = name + ": " + pieces;
    book_.add({title, name + "-pieces.svg", "Cut along reflex edges, then moved apart.",
               picture_of(cut.pieces, kApart, cli::picture(PictureFormat::Svg, title), context_),
               true,
               picture_of(cut.pieces, kApart, cli::picture(PictureFormat::Html, title), context_)});
    book_.step("pictured them, moved apart");
  }

  DemoBook& book_;
  Context& context_;
};

}  // namespace

void demonstrate_convex(DemoBook& book) {
  book.chapter("Convex pieces", "None twice, nothing lost.");
  ConvexDemo(book).run();
}

// The chapter on surfaces: polygons on a torus and on the bunny, cells, labels, a Boolean.

namespace {

struct SurfaceExhibit {
  std::string name;        ///< Name of the scene and of files.
  std::string title;       ///< Title, such as "The torus".
  std::string expression;  ///< Expression of the result.
};

constexpr std::array<std::pair<SurfaceLayer, std::string_view>, 5> kPictures{{
    {SurfaceLayer::Polygons, "Control points in black, crossings in red."},
    {SurfaceLayer::Slices, "The triangles, cut along the polygons."},
    {SurfaceLayer::Cells, "Each cell in a colour of its own."},
    {SurfaceLayer::Labels,
     "How often each shape winds around a cell; equal labels, equal colours."},
    {SurfaceLayer::Result, "What the expression selects, with the control points of its border."},
}};

class SurfaceDemo {
 public:
  explicit SurfaceDemo(DemoBook& book) : book_(book), context_(book.session().context()) {}

  void run() {
    show({"torus", "The torus", "(A + B) - C"});
    show({"bunny", "The bunny", "A ^ B"});
    find_loops();
  }

 private:
  SurfaceDivision divided(const std::string& name) {
    SceneFile file = read_scene_file(DemoBook::bundled("scenes/" + name + ".json"), {}, context_);
    book_.step("read " + name + ".json and traced its polygons");
    SurfaceDivision division(std::move(file.scene), context_);
    book_.step("divided the surface: " + facts_of(division));
    return division;
  }

  static SurfaceResult evaluated(const SurfaceDivision& division, const std::string& expression) {
    return division.evaluate(parse_set_expression(expression), WindingRule::EvenOdd);
  }

  void show(const SurfaceExhibit& exhibit) {
    const SurfaceDivision division = divided(exhibit.name);
    if (const auto flaw = audit(division)) throw std::logic_error("audit: " + *flaw);
    const auto same = [&](const std::string& a, const std::string& b) {
      return evaluated(division, a).region.is_selected == evaluated(division, b).region.is_selected;
    };
    if (!same("!(A + B)", "!A * !B") || !same("A ^ B", "(A - B) + (B - A)")) {
      throw std::logic_error("the laws of sets do not hold on the surface");
    }
    book_.step("audited every invariant: all hold, and so do De Morgan's laws");
    const SurfaceResult result = evaluated(division, exhibit.expression);
    book_.step(exhibit.expression + " selects " + counted(result.region.cells, "cell") +
               ", bounded by " + counted(result.borders.size(), "loop"));
    for (const auto& [layer, caption] : kPictures) {
      const std::string what = layer_name(layer);
      const auto drawn = [&, shown = layer](PictureFormat kind) {
        return picture_of(division, &result, shown, cli::picture(kind, exhibit.title), context_);
      };
      // The page contains all layers.
      const std::string page = layer == SurfaceLayer::Labels ? drawn(PictureFormat::Html) : "";
      book_.add({exhibit.title + ": " + what, exhibit.name + '-' + what + ".svg",
                 std::string(caption), drawn(PictureFormat::Svg), true, page});
    }
    book_.step("pictured the five stages; wrote a page to turn them around");
  }

  /// Shows a meridian and a longitude. Neither of them encloses a region, and a cycle of cells
  /// proves this.
  void find_loops() {
    const SurfaceDivision division = divided("torus-loops");
    for (std::uint32_t s = 0; s < division.shape_count(); ++s) {
      const Separation& separation = division.shape_separation(s);
      if (separation.over_z || separation.mod_2 || separation.cycle.empty()) {
        throw std::logic_error("a loop around a handle separates the torus");
      }
    }
    book_.step("found that neither the meridian nor the longitude separates the torus");
  }

  DemoBook& book_;
  Context& context_;
};

}  // namespace

void demonstrate_surfaces(DemoBook& book) {
  book.chapter("Polygons on surfaces",
               "The cells they make, how often each winds around them, what a Boolean selects.");
  SurfaceDemo(book).run();
}

}  // namespace plumb::cli
