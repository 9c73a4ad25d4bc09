// The chapter of the demo on convex pieces: the five polyhedra of the cutting problem and a comb, cut and moved apart.

#include <array>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "demo_book.h"
#include "picture_files.h"
#include "plumb/convex/decompose.h"
#include "plumb/io/solid_sets.h"
#include "plumb/picture/sheet.h"
#include "plumb/space/space_measure.h"

namespace plumb::cli {
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
  /// A bar with teeth along one way above, and along the other below: notches cross.
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
               picture_of(cut.pieces, kApart, Picture::Svg, title, context_), true,
               picture_of(cut.pieces, kApart, Picture::Html, title, context_)});
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

}  // namespace plumb::cli
