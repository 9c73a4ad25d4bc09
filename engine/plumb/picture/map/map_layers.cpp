// Layers of a picture of a map: painted faces, and the choice of close-ups.
//
// Faces are painted like a painter does, the largest first, and a clockwise cycle paints the
// background. So holes come out right for valid maps, and a defective map, whose cycles may overlap
// or be open, still gives a sensible picture without any topology. Cycles too small to be seen
// become a tint, so the size of the file is bounded by what can be seen.
//
// Close-ups are chosen greedily. The candidates are windows around the defects, whose sizes depend
// on the shortest edges. In each step, the window is chosen that shows the most new defects, until
// no window shows a new defect or the maximum is reached.
// Tested by tests/picture/map_svg_test.cpp.
#include "plumb/picture/map/map_layers.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "plumb/picture/plane/outlines.h"
#include "plumb/picture/svg/sheet.h"

namespace plumb {
namespace {

constexpr double kVisible = 1.2;  // In picture units. Smaller faces only tint the picture.
// The picture cannot hold more faces of at least this size than may be drawn.
constexpr double kVisibleAmongMany = 4;
constexpr double kLine = 0.7;
constexpr double kFineLine = 0.45;
constexpr std::size_t kManyCycles = 1500;

/// Returns the signed area of a cycle, summed from the least vertex towards its lesser neighbour.
/// Therefore the two orders of listing a cycle give results that differ only in sign.
double signed_area(const Plane& plane, std::span<const std::uint32_t> cycle) {
  const std::size_t n = cycle.size();
  const auto least = static_cast<std::size_t>(std::ranges::min_element(cycle) - cycle.begin());
  const bool is_forward = cycle[(least + 1) % n] <= cycle[(least + n - 1) % n];
  const auto at = [&](std::size_t i) {
    return plane.at(cycle[(is_forward ? least + i : least + n - i) % n]);
  };
  const Point2 o = at(0);
  double sum = 0;
  for (std::size_t i = 1; i + 1 < n; ++i) {
    const Point2 p = at(i), q = at(i + 1);
    sum += (p.x - o.x) * (q.y - o.y) - (p.y - o.y) * (q.x - o.x);
  }
  return (is_forward ? sum : -sum) / 2;
}

double perimeter(const Plane& plane, std::span<const std::uint32_t> cycle) {
  double sum = 0;
  Point2 last = plane.at(cycle.back());
  for (const std::uint32_t v : cycle) {
    const Point2 p = plane.at(v);
    sum += std::hypot(p.x - last.x, p.y - last.y);
    last = p;
  }
  return sum;
}

}  // namespace

Painter::Painter(const Plane& plane)
    : plane_(plane), colour_(colour_cycles(plane.map())), order_(colour_.size()) {
  std::vector<double> key(colour_.size());
  for (std::size_t c = 0; c < key.size(); ++c) {
    const double area = signed_area(plane, plane.map().cycle(c));
    key[c] = std::abs(area);
    if (area < 0) colour_[c] = kTints;
    perimeter_ += perimeter(plane, plane.map().cycle(c));
  }
  std::iota(order_.begin(), order_.end(), 0U);
  // If a cycle is listed both ways, the outside is painted first.
  const auto is_below = [&](std::uint32_t a, std::uint32_t b) {
    if (key[a] != key[b]) return key[a] > key[b];
    return colour_[a] == kTints && colour_[b] != kTints;
  };
  std::stable_sort(order_.begin(), order_.end(), is_below);
}

/// Returns the width of lines such that they cover at most about a third of the picture. Lines that
/// would be too thin are left out.
double Painter::line_width(const View& view, const PaintLimits& limits) const {
  if (!limits.is_overview || perimeter_ == 0) return kLine;
  const double area = view.frame().width() * view.frame().height();
  const double width = 0.3 * area / (perimeter_ * view.scale());
  return width < 0.1 ? 0 : std::min(order_.size() > kManyCycles ? kFineLine : kLine, width);
}

PaintCounts Painter::paint(const View& view, const PaintLimits& limits, std::ostream& out) const {
  PaintCounts counts;
  TinyFaces tiny(view.frame());
  std::size_t points = 0;
  const double visible = order_.size() > limits.polygons ? kVisibleAmongMany : kVisible;
  out << "<g class=\"faces\" stroke=\"" << kEdgeInk << "\" stroke-width=\""
      << svg_number(10 * line_width(view, limits)) << "\" transform=\"scale(.1)\">\n";
  for (const std::uint32_t c : order_) {
    const std::vector<Point2> ring = plane_.ring(c);
    const Rectangle box = box_of(ring);
    if (!view.window().overlaps(box)) {
      ++counts.outside;
      continue;
    }
    const double size = std::max(box.width(), box.height()) * view.scale();
    const bool is_full = points > limits.points || counts.drawn >= limits.polygons;
    if (size < visible || is_full) {
      ++(size < visible ? counts.tiny : counts.left_out);
      if (colour_[c] != kTints) tiny.mark(view.place(box.centre()));
      continue;
    }
    const std::vector<Point2> seen = view.window().contains(box) ? ring : view.clipped(ring);
    if (seen.size() < 2) continue;
    PathData path;
    append_ring(placed(view, seen), path);
    points += path.points();
    ++counts.drawn;
    out << "<path class=\"t" << int{colour_[c]} << "\" d=\"" << path.data() << "\"/>\n";
  }
  out << "</g>\n";
  tiny.write(out);
  return counts;
}

namespace {

constexpr std::size_t kConsidered = 1000;
// In picture units. Longer edges are visible without a close-up.
constexpr double kVisibleEdge = 45;
constexpr double kEdgeAmongMany = 12;
constexpr std::size_t kMany = 100;
constexpr double kWidestSource = 130;  // In picture units. Wider windows would hardly be enlarged.
// Half the height of a window in lengths of the shortest edge.
constexpr double kReach = 2.2;
constexpr double kLeastReach = 1e-150;  // In units of the plane.

/// The place of a defect and the length of its shortest edge.
struct Spot {
  Point2 at;
  double length;
  bool is_covered = false;
};

class InsetChooser {
 public:
  InsetChooser(const MapReport& report, const Plane& plane, const View& overview, double aspect)
      : aspect_(aspect), overview_(overview) {
    const double visible = report.defects.size() <= kMany ? kVisibleEdge : kEdgeAmongMany;
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
    // The function centred() may add a factor of 1.3.
    const double widest = kWidestSource / 2.6 / overview_.scale();
    const double half = std::min(aspect_ * kReach * s.length, widest);
    return Rectangle::around(s.at, half, half / aspect_);
  }

  /// Returns the spots that the window shows, except those that are far smaller than the window.
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

  /// Returns the window around the spots that it shows, with a margin.
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
