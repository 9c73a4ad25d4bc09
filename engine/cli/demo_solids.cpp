// The chapter of the demo on sets of space: two solids combined, what is open, what has no end.

#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>

#include "demo_book.h"
#include "picture_files.h"
#include "plumb/io/solid_sets.h"
#include "plumb/io/solid_text.h"
#include "plumb/picture/sheet.h"
#include "plumb/picture/space_svg.h"
#include "plumb/space/nef3.h"
#include "plumb/space/space_audit.h"
#include "plumb/space/space_measure.h"

namespace plumb::cli {
namespace {

Rational volume_of(const Nef3& set) { return marked_volume(set.complex()).value(); }

void require_sound(const Nef3& set) {
  const auto flaw = audit(set.complex(), true);
  if (flaw) throw std::logic_error("audit: " + flaw->invariant + " at " + flaw->place);
}

std::string written(const Nef3& set, std::string_view format, Context& context) {
  for (const SolidFormat& f : solid_formats()) {
    if (f.name != format) continue;
    std::ostringstream out;
    SolidText(set, f, context).write(out, context);
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

  /// Their volumes, as fractions of thousands of digits, must add up; and so must the sets.
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

  /// A corner of the ball inside the bunny: on the boundary of the difference, but not part of it.
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
    book_.add({title, name, caption, picture_of(set, Picture::Svg, title, context_), true,
               picture_of(set, Picture::Html, title, context_)});
  }

  DemoBook& book_;
  Context& context_;
};

}  // namespace

void demonstrate_solids(DemoBook& book) {
  book.chapter("Solids", "United, intersected, subtracted: volumes add up to the last digit.");
  SolidDemo(book).run();
}

}  // namespace plumb::cli
