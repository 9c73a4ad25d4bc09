// Left of a line, right of it or on it? Points one unit in the last place apart, judged by the
// usual determinant in doubles and by orient2d: an SVG file on standard output. (After Kettner,
// Mehlhorn, Pion, Schirra, Yap, 2008.)
#include <cstdio>
#include <string>

#include "page.h"
#include "plumb/predicates/input_predicates.h"

namespace {

using plumb::Point2;
using plumb::Sign;

constexpr int kPoints = 64;  // a side of the grid
constexpr int kPixels = 5;
constexpr Point2 kFrom = {12, 12}, kTo = {24, 24};

Point2 grid_point(int i, int j) { return {0.5 + i * 0x1p-53, 0.5 + j * 0x1p-53}; }

Sign naive(Point2 p) {
  const double determinant =
      (kTo.x - kFrom.x) * (p.y - kFrom.y) - (kTo.y - kFrom.y) * (p.x - kFrom.x);
  return determinant > 0 ? Sign::Positive : determinant < 0 ? Sign::Negative : Sign::Zero;
}

Sign exact(Point2 p) { return plumb::orient2d(kFrom, kTo, p); }

/// The points of one sign, as rows of equal neighbours.
void draw_points(Sign (*judge)(Point2), Sign sign, const char* css) {
  std::printf("<path class=\"%s\" d=\"", css);
  for (int j = 0; j < kPoints; ++j) {
    for (int i = 0, end = 0; i < kPoints; i = end + 1) {
      for (end = i; end < kPoints && judge(grid_point(end, j)) == sign;) ++end;
      if (end > i) std::printf("M%d %dh%dv1h%dz", i, kPoints - 1 - j, end - i, i - end);
    }
  }
  std::printf("\"/>\n");
}

int wrong_points() {
  int wrong = 0;
  for (int k = 0; k < kPoints * kPoints; ++k) {
    const Point2 p = grid_point(k % kPoints, k / kPoints);
    wrong += naive(p) != exact(p) ? 1 : 0;
  }
  return wrong;
}

void draw_panel(int x, const char* title, Sign (*judge)(Point2)) {
  text(x, 34, "title", title);
  std::printf("<g transform=\"translate(%d 48) scale(%d)\" shape-rendering=\"crispEdges\">\n", x,
              kPixels);
  draw_points(judge, Sign::Positive, "left");
  draw_points(judge, Sign::Zero, "on");
  draw_points(judge, Sign::Negative, "right");
  std::printf("</g>\n");
}

void draw_key(int x, const char* css, const char* words) {
  std::printf("<rect class=\"%s\" x=\"%d\" y=\"386\" width=\"16\" height=\"16\"/>\n", css, x);
  text(x + 24, 399, "", words);
}

}  // namespace

int main() {
  begin_page(720, 472, "The sign of a determinant, rounded and exact",
             ".title{font-size:17px;font-weight:bold}\n.left{fill:#f2a65a}\n.on{fill:#0b2545}\n"
             ".right{fill:#8ecae6}\n");
  draw_panel(24, "In doubles", naive);
  draw_panel(376, "orient2d", exact);
  draw_key(24, "left", "left of the line");
  draw_key(180, "on", "on it");
  draw_key(266, "right", "right of it");
  const std::string wrong = std::to_string(wrong_points()) + " of " +
                            std::to_string(kPoints * kPoints) +
                            " points are judged wrong in doubles.";
  text(24, 432, "", wrong.c_str());
  text(24, 454, "",
       "Points (1/2 + i 2^-53, 1/2 + j 2^-53), from bottom left; the line through (12, 12) and "
       "(24, 24).");
  end_page();
}
