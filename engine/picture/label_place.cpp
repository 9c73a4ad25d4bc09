#include "plumb/picture/label_place.h"

#include <array>

namespace plumb {
namespace {

// Directions to try, the most pleasant first: above right, above left, ...
constexpr std::array<Point2, 12> kDirections = {{{.71, -.71},
                                                 {-.71, -.71},
                                                 {.71, .71},
                                                 {-.71, .71},
                                                 {0, -1},
                                                 {0, 1},
                                                 {1, 0},
                                                 {-1, 0},
                                                 {.92, -.38},
                                                 {-.92, -.38},
                                                 {.92, .38},
                                                 {-.92, .38}}};
constexpr std::array<double, 6> kDistances = {.7, 1, 1.5, 2.1, 3, 4};

}  // namespace

bool LabelPlacer::is_free(const Rectangle& r) const {
  if (!frame_.contains(r)) return false;
  return std::none_of(taken_.begin(), taken_.end(),
                      [&r](const Rectangle& t) { return t.overlaps(r.grown(2)); });
}

int LabelPlacer::covered(const Rectangle& r) const {
  return static_cast<int>(std::count_if(points_.begin(), points_.end(),
                                        [&r](const Rectangle& p) { return p.overlaps(r); }));
}

std::optional<Rectangle> LabelPlacer::place(Point2 anchor, double width, double height,
                                            double reach) {
  std::optional<Rectangle> best;
  int best_cover = 0;
  for (const double distance : kDistances) {
    for (const Point2& d : kDirections) {
      const Point2 centre = {anchor.x + d.x * (reach * distance + width / 2),
                             anchor.y + d.y * (reach * distance + height / 2)};
      const Rectangle r = Rectangle::around(centre, width / 2, height / 2);
      if (!is_free(r)) continue;
      const int cover = covered(r);
      if (best && cover >= best_cover) continue;
      best = r;
      best_cover = cover;
      if (cover == 0) break;
    }
    if (best && best_cover == 0) break;
  }
  if (best) taken_.push_back(*best);
  return best;
}

}  // namespace plumb
