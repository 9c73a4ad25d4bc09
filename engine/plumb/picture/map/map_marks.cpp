// Marks over a picture of a map: edges of defects, symbols, labels and vertex numbers.
//
// Symbols of several kinds at one place stand side by side; defects near each other share a label.
// Labels are placed greedily in a fixed order of directions and distances, each off all earlier
// labels and off as many lines and symbols as possible, so the same report always gives the same
// picture. Numbers of marks and labels are bounded; groups left without a label are counted for the
// notes.
// Tested by tests/picture/map_svg_test.cpp and tests/picture/plane_view_test.cpp.
#include "plumb/picture/map/map_marks.h"

#include <array>
#include <cmath>
#include <map>
#include <set>

#include "plumb/picture/svg/sheet.h"
#include "plumb/picture/svg/svg_text.h"

namespace plumb {
namespace {

// The directions to try, the most pleasant first: above on the right, above on the left, and so on.
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

namespace {

constexpr double kGroupRadius = 32;  // In picture units.
constexpr double kLabelHeight = 24;
constexpr double kLabelFont = 16;
constexpr double kNumberFont = 14;
constexpr double kArrowFrom = 34;  // The shortest edge that gets an arrow for its direction.
constexpr std::size_t kMaxVertexNumbers = 16;
// The part outside of the view in which vertices are marked, too.
constexpr double kOutsideMargin = 12;
constexpr double kSamePlace = 3;  // In picture units.

std::string move_line(Point2 a, Point2 b) {
  return "M" + svg_number(a.x) + " " + svg_number(a.y) + "L" + svg_number(b.x) + " " +
         svg_number(b.y);
}

double distance(Point2 a, Point2 b) { return std::hypot(a.x - b.x, a.y - b.y); }

/// Returns a small arrow head in the middle of a directed edge.
std::string arrow(Point2 a, Point2 b) {
  const double length = distance(a, b);
  if (length < kArrowFrom) return {};
  const Point2 d = {(b.x - a.x) / length, (b.y - a.y) / length};
  const Point2 tip = {(a.x + 2 * b.x) / 3 + 5 * d.x, (a.y + 2 * b.y) / 3 + 5 * d.y};
  const Point2 l = {tip.x - 11 * d.x + 6 * d.y, tip.y - 11 * d.y - 6 * d.x};
  const Point2 r = {tip.x - 11 * d.x - 6 * d.y, tip.y - 11 * d.y + 6 * d.x};
  return move_line(l, tip) + "L" + svg_number(r.x) + " " + svg_number(r.y);
}

void avoid_line(Point2 a, Point2 b, LabelPlacer& room) {
  const int steps = static_cast<int>(std::min(distance(a, b) / 12, 30.0));
  for (int i = 1; i < steps; ++i) {
    const double t = static_cast<double>(i) / steps;
    room.avoid(Rectangle::around({a.x + (b.x - a.x) * t, a.y + (b.y - a.y) * t}, 4, 4));
  }
}

bool is_directed(DefectKind kind) {
  return kind == DefectKind::Duplicate || kind == DefectKind::Open;
}

Point2 nearest_in(const Rectangle& r, Point2 p) {
  return {std::clamp(p.x, r.left, r.right), std::clamp(p.y, r.top, r.bottom)};
}

}  // namespace

std::string group_label(const std::vector<std::size_t>& members, std::size_t long_text) {
  std::string text;
  for (std::size_t i = 0; i < members.size();) {
    std::size_t last = i;
    while (last + 1 < members.size() && members[last + 1] == members[last] + 1) ++last;
    if (text.size() > long_text) return text + ", \xE2\x80\xA6";
    text += (text.empty() ? "" : ", ") + std::to_string(members[i] + 1);
    if (last > i)
      text += (last == i + 1 ? ", " : "\xE2\x80\x93") + std::to_string(members[last] + 1);
    i = last + 1;
  }
  return text;
}

MapMarks::MapMarks(const MapReport& report, const Plane& plane)
    : report_(report), plane_(plane), count_(std::min(report.defects.size(), kMaxMarks)) {}

std::size_t MapMarks::count_in(const Rectangle& window) const {
  std::size_t count = 0;
  for (std::size_t i = 0; i < count_; ++i) count += window.contains(place(i)) ? 1 : 0;
  return count;
}

std::size_t MapMarks::paint(const View& view, Detail detail, LabelPlacer& room,
                            std::ostream& out) const {
  paint_edges(view, detail, room, out);
  paint_warnings(view, detail, out);
  paint_symbols(view, detail, room, out);
  const std::size_t left_out = paint_labels(view, detail, room, out);
  if (detail == Detail::Closeup) paint_vertex_numbers(view, room, out);
  return left_out;
}

/// Returns the lines and arrows of all defects of one kind. Labels avoid them.
std::pair<std::string, std::string> MapMarks::edge_paths(const View& view, DefectKind kind,
                                                         LabelPlacer& room) const {
  std::string path, arrows;
  for (std::size_t i = 0; i < count_; ++i) {
    const MapDefect& defect = report_.defects[i];
    if (defect.kind != kind) continue;
    for (const MapEdge& e : defect.edges) {
      const auto seen = view.clipped(plane_.at(e.from), plane_.at(e.to));
      if (!seen) continue;
      const Point2 a = view.place(seen->first), b = view.place(seen->second);
      path += move_line(a, b);
      if (is_directed(kind)) arrows += arrow(a, b);
      avoid_line(a, b, room);
    }
  }
  return {path, arrows};
}

/// Draws edges. Edges of several kinds lie upon each other, and later kinds are thinner.
void MapMarks::paint_edges(const View& view, Detail detail, LabelPlacer& room,
                           std::ostream& out) const {
  std::string halo, bands;
  for (const DefectStyle& style : defect_styles()) {
    const auto [path, arrows] = edge_paths(view, style.kind, room);
    if (path.empty()) continue;
    halo += path;
    const double full = 7 - 0.9 * static_cast<double>(style.kind);
    const double width = detail == Detail::Overview ? 0.6 * full : full;
    bands += "<path class=\"bad\" stroke-width=\"" + svg_number(width) + "\" stroke=\"" +
             style.colour + "\" d=\"" + path + "\"/>\n";
    if (detail == Detail::Overview || arrows.empty()) continue;
    bands += std::string("<path class=\"bad\" stroke-width=\"3.2\" stroke=\"") + style.colour +
             "\" d=\"" + arrows + "\"/>\n";
  }
  if (!halo.empty())
    out << "<path class=\"halo\" stroke-width=\"" << (detail == Detail::Overview ? 6 : 10)
        << "\" d=\"" << halo << "\"/>\n"
        << bands;
}

void MapMarks::paint_warnings(const View& view, Detail detail, std::ostream& out) const {
  std::string inferred;
  for (std::size_t i = 0; i < std::min(report_.warnings.size(), kMaxMarks); ++i) {
    const MapWarning& w = report_.warnings[i];
    if (w.kind == WarningKind::InferredOuter) {
      if (w.vertex >= report_.map.cycle_count()) continue;
      const auto ring = plane_.ring(w.vertex);
      for (std::size_t k = 0; k < ring.size(); ++k) {
        const auto seen = view.clipped(ring[k], ring[k + 1 < ring.size() ? k + 1 : 0]);
        if (!seen) continue;
        const Point2 a = view.place(seen->first), b = view.place(seen->second);
        if (distance(a, b) >= 0.5) inferred += move_line(a, b);
      }
      continue;
    }
    const Point2 seen = view.place(plane_.at(w.vertex));
    if (detail == Detail::Closeup && !view.frame().contains(seen)) continue;
    const Point2 p = nearest_in(view.frame().grown(kOutsideMargin), seen);
    out << "<circle class=\"warning\" cx=\"" << svg_number(p.x) << "\" cy=\"" << svg_number(p.y)
        << "\" r=\"5\"/>\n";
  }
  if (!inferred.empty()) out << "<path class=\"inferred\" d=\"" << inferred << "\"/>\n";
}

/// Draws symbols. Symbols of several kinds at one place stand side by side, and each kind occurs
/// only once at a place.
void MapMarks::paint_symbols(const View& view, Detail detail, LabelPlacer& room,
                             std::ostream& out) const {
  const double radius = detail == Detail::Closeup ? 7 : count_ <= 100 ? 6 : 4.5;
  std::map<std::pair<long, long>, std::vector<DefectKind>> drawn;
  out << "<g class=\"marks\">\n";
  for (std::size_t i = 0; i < count_; ++i) {
    const Point2 seen = view.place(place(i));
    if (!view.frame().contains(seen) && detail == Detail::Closeup) continue;
    const Point2 at = nearest_in(view.frame(), seen);
    auto& kinds = drawn[{std::lround(at.x / kSamePlace), std::lround(at.y / kSamePlace)}];
    const DefectKind kind = report_.defects[i].kind;
    if (std::find(kinds.begin(), kinds.end(), kind) != kinds.end()) continue;
    const Point2 p = {at.x + 2.1 * radius * static_cast<double>(kinds.size()), at.y};
    kinds.push_back(kind);
    out << symbol(style_of(kind), p, radius) << '\n';
    room.avoid(Rectangle::around(p, radius, radius));
  }
  out << "</g>\n";
}

/// Returns groups of defects. Each defect joins the first group whose anchor is near.
std::vector<DefectGroup> MapMarks::grouped(const View& view) const {
  std::vector<DefectGroup> groups;
  for (std::size_t i = 0; i < count_; ++i) {
    const Point2 p = view.place(place(i));
    if (!view.frame().contains(p)) continue;
    const auto is_near = [p](const DefectGroup& g) { return distance(g.anchor, p) < kGroupRadius; };
    const auto group = std::find_if(groups.begin(), groups.end(), is_near);
    if (group != groups.end()) {
      group->members.push_back(i);
    } else {
      groups.push_back({p, {i}});
    }
  }
  return groups;
}

std::string MapMarks::label_colour(const DefectGroup& group) const {
  const DefectKind kind = report_.defects[group.members.front()].kind;
  for (const std::size_t i : group.members) {
    if (report_.defects[i].kind != kind) return kMixedInk;
  }
  return style_of(kind).colour;
}

std::size_t MapMarks::paint_labels(const View& view, Detail detail, LabelPlacer& room,
                                   std::ostream& out) const {
  std::size_t left_out = 0;
  const std::vector<DefectGroup> groups = grouped(view);
  // Labels are distributed evenly over the groups.
  const std::size_t step = (groups.size() + kMaxLabels - 1) / kMaxLabels;
  for (std::size_t i = 0; i < groups.size(); ++i) {
    const DefectGroup& group = groups[i];
    const std::string text = group_label(group.members, detail == Detail::Overview ? 6 : 13);
    const double width = 1.1 * text_width(text, kLabelFont) + 14;  // Bold letters are wider.
    const auto box =
        i % step == 0 ? room.place(group.anchor, width, kLabelHeight, 13) : std::nullopt;
    if (!box) {
      ++left_out;
      continue;
    }
    const std::string line = move_line(group.anchor, nearest_in(*box, group.anchor));
    out << "<path class=\"lead\" d=\"" << line << "\"/><rect class=\"tag\" " << svg_box(*box)
        << " rx=\"6\" fill=\"" << label_colour(group) << "\"/><text class=\"number\" x=\""
        << svg_number(box->centre().x) << "\" y=\"" << svg_number(box->centre().y + 5.7) << "\">"
        << text << "</text>\n";
  }
  return left_out;
}

void MapMarks::paint_vertex_numbers(const View& view, LabelPlacer& room, std::ostream& out) const {
  std::set<std::uint32_t> vertices;
  for (std::size_t i = 0; i < count_ && vertices.size() < kMaxVertexNumbers; ++i) {
    for (const MapEdge& e : report_.defects[i].edges) {
      for (const std::uint32_t v : {e.from, e.to}) {
        if (view.frame().contains(view.place(plane_.at(v)))) vertices.insert(v);
      }
    }
  }
  for (const std::uint32_t v : vertices) {
    const Point2 p = view.place(plane_.at(v));
    out << "<circle class=\"vertex\" cx=\"" << svg_number(p.x) << "\" cy=\"" << svg_number(p.y)
        << "\" r=\"2.6\"/>";
    const std::string text = std::to_string(v + 1);
    const auto box = room.place(p, text_width(text, kNumberFont), kNumberFont, 6);
    if (!box) continue;
    out << "<text class=\"vertex-number\" x=\"" << svg_number(box->centre().x) << "\" y=\""
        << svg_number(box->centre().y + 5) << "\">" << text << "</text>\n";
  }
}

}  // namespace plumb
