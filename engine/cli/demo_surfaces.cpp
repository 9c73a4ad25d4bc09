// The chapter of the demo on surfaces: polygons on a torus and on the bunny, cells, labels, a Boolean.

#include <algorithm>
#include <array>
#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>

#include "demo_book.h"
#include "picture_files.h"
#include "plumb/base/set_expression.h"
#include "plumb/io/scene_reader.h"
#include "plumb/io/surface_writer.h"
#include "plumb/picture/sheet.h"
#include "plumb/picture/surface_scene.h"
#include "plumb/surface/surface_audit.h"

namespace plumb::cli {
namespace {

struct SurfaceExhibit {
  std::string name;        ///< of the scene, and of files
  std::string title;       ///< "The torus"
  std::string expression;  ///< of the result
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
      const auto drawn = [&, shown = layer](Picture kind) {
        return picture_of(division, &result, shown, kind, exhibit.title, context_);
      };
      // The page has all layers.
      const std::string page = layer == SurfaceLayer::Labels ? drawn(Picture::Html) : "";
      book_.add({exhibit.title + ": " + what, exhibit.name + '-' + what + ".svg",
                 std::string(caption), drawn(Picture::Svg), true, page});
    }
    book_.step("pictured the five stages; wrote a page to turn them around");
  }

  /// A meridian and a longitude: neither has an inside, and a cycle of cells proves it.
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
