#include "plumb/picture/map_insets.h"

#include <cmath>

namespace plumb {
namespace {

constexpr std::size_t kConsidered = 1000;
constexpr double kVisibleEdge = 45;  // picture units: long enough without an inset
constexpr double kVisibleAmongMany = 12;
constexpr std::size_t kMany = 100;
constexpr double kWidestSource = 130;   // picture units: wider windows would hardly be enlarged
constexpr double kReach = 2.2;          // half the height of a window, in edge lengths
constexpr double kLeastReach = 1e-150;  // plane units

/// A defect's place and the length of its shortest edge.
struct Spot {
  Point2 at;
  double length;
  bool is_covered = false;
};

class InsetChooser {
 public:
  InsetChooser(const MapReport& report, const Plane& plane, const View& overview, double aspect)
      : aspect_(aspect), overview_(overview) {
    const double visible = report.defects.size() <= kMany ? kVisibleEdge : kVisibleAmongMany;
    for (std::size_t i = 0; i < std::min(report.defects.size(), kConsidered); ++i) {
      const MapDefect& defect = report.defects[i];
      const Spot spot{plane.at(defect.near), shortest_edge(defect, plane)};
      if (spot.length * overview.scale() < visible) spots_.push_back(spot);
    }
  }

  std::vector<Inset> choose(std::size_t max) {
    std::vector<Inset> chosen;
    while (chosen.size() < max) {
      const Inset best = fullest();
      if (best.defects == 0) break;
      for (Spot& s : spots_) s.is_covered |= best.window.contains(s.at);
      chosen.push_back(best);
    }
    return chosen;
  }

 private:
  double shortest_edge(const MapDefect& defect, const Plane& plane) const {
    double length = 0;
    for (const MapEdge& e : defect.edges) {
      const Point2 a = plane.at(e.from), b = plane.at(e.to);
      const double l = std::hypot(a.x - b.x, a.y - b.y);
      if (l > 0 && (length == 0 || l < length)) length = l;
    }
    return std::max(length > 0 ? length : 10 / overview_.scale(), kLeastReach);
  }

  Rectangle window_at(const Spot& s) const {
    const double widest = kWidestSource / 2.6 / overview_.scale();  // centred() may add 1.3
    const double half = std::min(aspect_ * kReach * s.length, widest);
    return Rectangle::around(s.at, half, half / aspect_);
  }

  /// Spots that the window shows and that are not far smaller than it.
  std::vector<const Spot*> seen(const Rectangle& window, double length) const {
    std::vector<const Spot*> spots;
    for (const Spot& s : spots_) {
      if (!s.is_covered && window.contains(s.at) && s.length * 8 > length) spots.push_back(&s);
    }
    return spots;
  }

  Inset fullest() const {
    const Spot* best = nullptr;
    std::size_t most = 0;
    for (const Spot& s : spots_) {
      if (s.is_covered) continue;
      const std::size_t count = seen(window_at(s), s.length).size();
      if (count <= most) continue;
      most = count;
      best = &s;
    }
    return best == nullptr ? Inset{} : Inset{centred(*best), most};
  }

  /// The window around what it shows, the spots well inside.
  Rectangle centred(const Spot& best) const {
    Rectangle box = Rectangle::around(best.at, 0, 0);
    for (const Spot* s : seen(window_at(best), best.length)) box.include(s->at);
    const double needed = std::max(box.height() / 2, box.width() / 2 / aspect_) * 1.3;
    const double half = std::max(needed, kReach * 0.6 * best.length);
    return Rectangle::around(box.centre(), aspect_ * half, half);
  }

  double aspect_;
  const View& overview_;
  std::vector<Spot> spots_;
};

}  // namespace

std::vector<Inset> choose_insets(const MapReport& report, const Plane& plane, const View& overview,
                                 double aspect, std::size_t max) {
  return InsetChooser(report, plane, overview, aspect).choose(max);
}

}  // namespace plumb
