// The half-edges of a small map, each in its face: an SVG file on standard output.
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include "page.h"
#include "plumb/dcel/dcel.h"
#include "plumb/plane/map_check.h"
#include "plumb/plane/plane_arrays.h"

namespace {

using plumb::Dcel;
using plumb::HalfedgeId;
using plumb::LoopId;
using plumb::Point2;

// Two rectangles, a triangle in the first, and what is outside of all.
const std::vector<double> kCorners = {0, 0, 5, 0, 8, 0, 8, 6, 5, 6, 0, 6, 1, 1.5, 4, 1.5, 2.5, 4.5};
const std::vector<std::uint32_t> kBegin = {0, 4, 8, 11, 14, 20};
const std::vector<std::uint32_t> kCycles = {0, 1, 4, 5, 1, 2, 3, 4, 6, 7,
                                            8, 8, 7, 6, 5, 4, 3, 2, 1, 0};
const char* const kColours[] = {"#0b4f8a", "#00705a", "#a35c00", "#7a2e8e", "#a32020"};

Point2 on_page(Point2 p) { return {50 + 52 * p.x, 376 - 52 * p.y}; }

Point2 corner(plumb::VertexId v) {
  return on_page({kCorners[2 * v.value()], kCorners[2 * v.value() + 1]});
}

/// An arrow beside the edge, in the face to the left, with its number.
void draw(const Dcel& dcel, HalfedgeId h) {
  constexpr double kAside = 7, kShort = 17, kNumber = 13;
  const Point2 a = corner(dcel.origin(h)), b = corner(dcel.target(h));
  const double length = std::hypot(b.x - a.x, b.y - a.y);
  const Point2 along = {(b.x - a.x) / length, (b.y - a.y) / length};
  const Point2 left = {along.y, -along.x};  // y points down
  const auto place = [&](double forward, double aside) {
    return Point2{a.x + forward * along.x + aside * left.x,
                  a.y + forward * along.y + aside * left.y};
  };
  const Point2 from = place(kShort, kAside), to = place(length - kShort, kAside);
  const Point2 barb = place(length - kShort - 9, kAside + 5);
  const Point2 middle = place(length / 2, kAside + kNumber);
  const char* const colour = kColours[dcel.loop(h).value()];
  std::printf("<path class=\"half\" stroke=\"%s\" d=\"M%.1f %.1fL%.1f %.1fL%.1f %.1f\"/>\n", colour,
              from.x, from.y, to.x, to.y, barb.x, barb.y);
  std::printf("<text class=\"middle\" style=\"fill:%s\" x=\"%.1f\" y=\"%.1f\">%u</text>\n", colour,
              middle.x, middle.y + 5, h.value());
}

void draw_edges(const Dcel& dcel) {
  for (std::uint32_t e = 0; e < dcel.edge_count(); ++e) {
    const HalfedgeId h = plumb::first_half(plumb::EdgeId(e));
    const Point2 a = corner(dcel.origin(h)), b = corner(dcel.target(h));
    std::printf("<path class=\"edge\" d=\"M%.1f %.1fL%.1f %.1f\"/>\n", a.x, a.y, b.x, b.y);
    draw(dcel, h);
    draw(dcel, plumb::twin(h));
  }
  for (std::uint32_t v = 0; v < dcel.vertex_count(); ++v) {
    const Point2 p = corner(plumb::VertexId(v));
    std::printf("<circle cx=\"%.1f\" cy=\"%.1f\" r=\"4\"/>\n", p.x, p.y);
  }
}

void list_loops(const Dcel& dcel) {
  double y = 84;
  text(516, y - 28, "title", "Loops and their half-edges");
  for (std::uint32_t l = 0; l < dcel.loop_count(); ++l, y += 50) {
    const LoopId loop(l);
    std::string words =
        "loop " + std::to_string(l) + " of face " + std::to_string(dcel.face(loop).value());
    std::printf("<path class=\"half\" stroke=\"%s\" d=\"M516 %.1fh24\"/>\n", kColours[l], y - 5);
    text(548, y, "", words.c_str());
    words.clear();
    for (const HalfedgeId h : dcel.along(loop)) words += ' ' + std::to_string(h.value());
    text(548, y + 19, "sub", words.c_str());
  }
}

}  // namespace

int main() {
  const plumb::MapReport report = check_map(plumb::map_of_cycles(kCorners, kBegin, kCycles));
  const Dcel dcel = to_dcel(report).dcel;
  if (dcel.audit()) return 1;
  begin_page(760, 430, "A map as half-edges",
             ".title{font-weight:bold}\n.sub{fill:#5b6672}\n.edge{stroke:#c3c9d0;stroke-width:2}\n"
             ".half{fill:none;stroke-width:1.6;stroke-linejoin:round;stroke-linecap:round}\n");
  draw_edges(dcel);
  list_loops(dcel);
  text(516, 352, "sub", "Each half-edge lies in the face");
  text(516, 371, "sub", "to its left; its twin is its");
  text(516, 390, "sub", "number xor 1.");
  end_page();
}
