// The picture of two overlaid maps: each cell in a colour for its pair of regions.
//
// Regions of the first map are coloured greedily in their order, unlike their neighbours; within
// one region the pairs are distinguished by shades, again unlike their neighbours. Borders are
// drawn in three kinds, by the map or maps that they belong to. Cells are drawn the largest first,
// labels in them where a box of their size fits inside; the numbers of points, titles and labels
// are bounded, and notes name the parts that are left out.
// Tested by tests/picture/overlay_svg_test.cpp.
#include "plumb/picture/overlay_svg.h"

#include <algorithm>
#include <cstdlib>
#include <ostream>
#include <utility>

#include "plumb/picture/plane/outlines.h"
#include "plumb/picture/plane/plane_view.h"
#include "plumb/picture/svg/sheet.h"
#include "plumb/plane/plane_measure.h"

namespace plumb {
namespace {

constexpr double kWidth = 1000;
constexpr double kTextScale = 1.45;  // The page may be viewed on small screens.
constexpr double kMargin = 0.02;
// A part of the width. Parts that are nearer to the core belong to it.
constexpr double kNear = 0.02;
constexpr double kLeastAspect = 0.45;
constexpr double kMostAspect = 1.15;
// A part of half the width. The coordinates of more distant points exceed the numbers of SVG.
constexpr double kLeastCore = 0.03;
constexpr double kVisible = 1.2;
constexpr std::size_t kMaxPoints = 600000;
// The greatest number of cells that show their pair when the pointer is on them.
constexpr std::size_t kMaxTitles = 8000;
constexpr std::size_t kMaxLabels = 400;
constexpr double kLabelSizes[] = {36, 27, 20, 16, 13};
constexpr double kMostLine = 2.2;

constexpr const char* kStyle = R"(.cells path{fill-rule:evenodd}
.tiny{fill:#c3c9d0}
.none{fill:#fff}
.hatch{fill:url(#hatch);fill-rule:evenodd}
.border{fill:none;stroke-linecap:round;stroke-linejoin:round}
.both{stroke:#1f2933}
.first{stroke:#c01060}
.second{stroke:#76808c}
.label{text-anchor:middle;stroke:#fff;stroke-opacity:.7;stroke-width:4px;stroke-linejoin:round;paint-order:stroke}
)";

enum BorderKind : std::uint8_t { kNoBorder, kSecondOnly, kFirstOnly, kBoth };
constexpr const char* kBorderClass[] = {"", "second", "first", "both"};

using Pairs = std::vector<std::pair<std::uint32_t, std::uint32_t>>;

// ------------------------------------------------------------------ colours

const MapOverlay::Origin& origin_beside(const MapOverlay& overlay, HalfedgeId h) {
  return overlay.origin[overlay.complex.dcel.face(h).value()];
}

/// Calls see(left, right) with the origins on both sides of every edge.
template <class See>
void for_borders(const MapOverlay& overlay, const See& see) {
  for (std::size_t e = 0; e < overlay.complex.edge_count(); ++e) {
    const HalfedgeId h = first_half(EdgeId(e));
    see(origin_beside(overlay, h), origin_beside(overlay, twin(h)));
  }
}

/// Colours the nodes in order. Each node gets a colour that differs from the colours of its
/// neighbours so far. `neighbours` has every pair of neighbours, in any order, possibly repeated.
std::vector<std::uint8_t> coloured(std::size_t nodes, Pairs neighbours, std::size_t colours) {
  for (auto& [a, b] : neighbours) {
    if (a < b) std::swap(a, b);
  }
  std::sort(neighbours.begin(), neighbours.end());
  std::vector<std::uint8_t> colour(nodes);
  auto next = neighbours.begin();
  for (std::uint32_t node = 0; node < nodes; ++node) {
    std::uint32_t taken = 0;
    for (; next != neighbours.end() && next->first == node; ++next) {
      if (next->second != node) taken |= 1U << colour[next->second];
    }
    colour[node] = free_colour(taken, node, colours);
  }
  return colour;
}

std::vector<std::uint8_t> colour_first_regions(const MapOverlay& overlay) {
  Pairs neighbours;
  std::uint32_t regions = 1;
  for (const MapOverlay::Origin& o : overlay.origin) regions = std::max(regions, o.first + 1);
  for_borders(overlay, [&neighbours](const auto& left, const auto& right) {
    if (left.first != right.first && left.first != 0 && right.first != 0) {
      neighbours.emplace_back(left.first, right.first);
    }
  });
  return coloured(regions, std::move(neighbours), kTints);
}

/// Returns the pairs that occur, each once, in ascending order.
Pairs pairs_of(const MapOverlay& overlay) {
  Pairs pairs;
  for (const MapOverlay::Origin& o : overlay.origin) pairs.emplace_back(o.first, o.second);
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  return pairs;
}

std::uint32_t index_of(const Pairs& pairs, const MapOverlay::Origin& o) {
  const auto at = std::lower_bound(pairs.begin(), pairs.end(), std::pair(o.first, o.second));
  return static_cast<std::uint32_t>(at - pairs.begin());
}

/// Returns a shade of a colour. Darker shades have more of the colour of the tint.
std::string shaded(const char* hex, std::size_t shade) {
  std::string text = "#";
  for (int i = 0; i < 3; ++i) {
    const std::string channel(hex + 1 + 2 * i, 2);
    const double value = static_cast<double>(std::strtol(channel.c_str(), nullptr, 16));
    const double darker = 255 - (255 - value) * (1 + 0.4 * static_cast<double>(shade));
    const auto byte = static_cast<unsigned>(darker);
    text += "0123456789abcdef"[byte / 16];
    text += "0123456789abcdef"[byte % 16];
  }
  return text;
}

std::string css_class(const OverlayColour& colour) {
  return "t" + std::to_string(colour.tint) + "s" + std::to_string(colour.shade);
}

std::string style() {
  std::string css = kStyle;
  for (std::uint8_t t = 0; t <= kTints; ++t) {
    for (std::uint8_t s = 0; s < kShades; ++s) {
      css += "." + css_class({t, s}) + "{fill:" + shaded(t < kTints ? tint(t) : "#e3e6ea", s) + "}";
    }
  }
  return css + "\n";
}

// ------------------------------------------------------------------ picture

class OverlaySheet {
 public:
  OverlaySheet(const MapOverlay& overlay, const OverlaySvgOptions& options)
      : overlay_(overlay),
        complex_(overlay.complex),
        options_(options),
        window_(overlay.complex, kMargin) {}

  void write(std::ostream& out) {
    const std::string title = options_.title.empty() ? "overlay" : options_.title;
    std::size_t both = 0;
    for (const MapOverlay::Origin& o : overlay_.origin) both += is_in_both(o) ? 1 : 0;
    sheet_.write_header(title, {counted(complex_.face_count() - 1, "cell"), kPlainBadge},
                        std::to_string(both) + " of them in both maps; " +
                            counted(complex_.vertex_count(), "vertex", "vertices") + ", " +
                            counted(complex_.edge_count(), "edge"));
    place();
    write_cells();
    write_borders();
    write_labels();
    sheet_.body() << "</g><rect class=\"panel\" " << svg_box(frame_) << "/>\n";
    write_legend();
    sheet_.write(out, title, style());
  }

 private:
  struct Cell {
    FaceId face;
    std::vector<std::vector<Point2>> rings;  ///< Picture units.
    Rectangle box;
  };

  static bool is_in_both(const MapOverlay::Origin& o) { return o.first != 0 && o.second != 0; }
  static bool is_in_one(const MapOverlay::Origin& o) { return (o.first != 0) != (o.second != 0); }
  const MapOverlay::Origin& origin(FaceId f) const { return overlay_.origin[f.value()]; }
  std::string pair_text(const MapOverlay::Origin& o) const;

  Rectangle choose_window() const;
  void place();
  void collect_cells();
  void write_cells();
  void write_cell(const Cell& cell, const OverlayColour& colour, bool has_title);
  void write_hatch(const PathData& path);
  void write_borders();
  void write_labels();
  bool write_label(const Cell& cell);
  void write_legend();

  const MapOverlay& overlay_;
  const PlaneComplex& complex_;
  const OverlaySvgOptions& options_;
  PlaneWindow window_;
  Sheet sheet_{{.width = kWidth, .text_scale = kTextScale}};
  Rectangle frame_{};
  IdVector<VertexId, Point2> at_;  ///< Place of each vertex in the picture.
  std::vector<Cell> cells_;        ///< Cells large enough to be seen, the largest first.
  bool has_hatch_ = false, has_tiny_ = false, has_labels_ = false;
  bool has_border_[4] = {};
};

std::string name_of(const std::vector<std::string>& names, std::uint32_t region) {
  if (region == 0) return "\xE2\x80\x93";  // The character is an en dash.
  return region < names.size() ? names[region] : std::to_string(region);
}

std::string OverlaySheet::pair_text(const MapOverlay::Origin& o) const {
  return name_of(options_.first_names, o.first) + " / " + name_of(options_.second_names, o.second);
}

/// Returns the box of the whole overlay. If a few parts lie far away, returns the box of its core
/// and of the parts that are connected with it.
Rectangle OverlaySheet::choose_window() const {
  const Rectangle all = {-1, -window_.aspect(), 1, window_.aspect()};
  Rectangle shown = without_far_parts(core_of(at_), all);
  std::vector<Rectangle> boxes;
  for (std::size_t e = 0; e < complex_.edge_count(); ++e) {
    const HalfedgeId h = first_half(EdgeId(e));
    boxes.push_back(Rectangle::around(at_[complex_.dcel.origin(h)], 0, 0));
    boxes.back().include(at_[complex_.dcel.target(h)]);
  }
  for (bool grows = true; grows;) {
    const Rectangle before = shown;
    const Rectangle reach = shown.grown(kNear * shown.width());
    for (const Rectangle& box : boxes) {
      if (!reach.overlaps(box)) continue;
      shown.include({box.left, box.top});
      shown.include({box.right, box.bottom});
    }
    grows = shown.width() > 1.001 * before.width() || shown.height() > 1.001 * before.height();
  }
  shown = shown.grown(kMargin * shown.width());
  const bool is_small = shown.width() * shown.height() < all.width() * all.height() / 2;
  return is_small && std::min(shown.width(), shown.height()) > kLeastCore ? shown : all;
}

void OverlaySheet::place() {
  for (const std::uint32_t i : complex_.vertex_point) {
    at_.push_back(window_.at(complex_.points, i));
  }
  const Rectangle shown = choose_window();
  const double aspect = std::clamp(shown.height() / shown.width(), kLeastAspect, kMostAspect);
  frame_ = {Sheet::kMargin, sheet_.y(), sheet_.right(), sheet_.y() + sheet_.column() * aspect};
  sheet_.set_y(frame_.bottom + 12);
  const View view(frame_, shown);
  for (Point2& p : at_) p = view.place(p);
  collect_cells();
}

/// Collects the bounded cells that are large enough to be visible, by decreasing size of their
/// boxes. Therefore a cell inside of another cell is drawn after it.
void OverlaySheet::collect_cells() {
  TinyFaces tiny(frame_);
  std::size_t outside = 0;
  for (std::size_t f = 1; f < complex_.face_count(); ++f) {  // Face 0 is unbounded.
    Cell cell{FaceId(f), {}, {}};
    for (const std::vector<VertexId>& ring : face_rings(complex_, FaceId(f))) {
      cell.rings.push_back(points_of(ring, at_));
    }
    if (cell.rings.empty()) continue;
    cell.box = box_of(cell.rings[0]);
    if (!frame_.overlaps(cell.box)) {
      ++outside;
    } else if (std::max(cell.box.width(), cell.box.height()) < kVisible) {
      tiny.mark(cell.box.centre());
    } else {
      cells_.push_back(std::move(cell));
    }
  }
  const auto size = [](const Cell& c) { return c.box.width() * c.box.height(); };
  std::stable_sort(cells_.begin(), cells_.end(),
                   [&size](const Cell& a, const Cell& b) { return size(a) > size(b); });
  has_tiny_ = !tiny.is_empty();
  if (outside > 0) {
    sheet_.note("Far from the rest and outside this picture: " + counted(outside, "cell") + ".");
  }
  sheet_.begin_clip(frame_);
  tiny.write(sheet_.body());
}

void OverlaySheet::write_cell(const Cell& cell, const OverlayColour& colour, bool has_title) {
  PathData path;
  for (const auto& ring : cell.rings) append_ring(ring, path);
  const MapOverlay::Origin& o = origin(cell.face);
  sheet_.body() << "<path class=\"" << (o == MapOverlay::Origin{0, 0} ? "none" : css_class(colour))
                << "\" d=\"" << path.data();
  if (has_title) {
    sheet_.body() << "\"><title>" << xml_escaped(pair_text(o)) << "</title></path>\n";
  } else {
    sheet_.body() << "\"/>\n";
  }
}

/// Hatches cells that belong to only one of the maps.
void OverlaySheet::write_hatch(const PathData& path) {
  if (path.empty()) return;
  sheet_.body() << "<pattern id=\"hatch\" width=\"70\" height=\"70\" "
                   "patternUnits=\"userSpaceOnUse\" patternTransform=\"rotate(45)\">"
                   "<path d=\"M0 0V70\" stroke=\"#5b6672\" stroke-width=\"18\"/></pattern>"
                   "<path class=\"hatch\" d=\""
                << path.data() << "\"/>\n";
}

void OverlaySheet::write_cells() {
  const IdVector<FaceId, OverlayColour> colours = colour_cells(overlay_);
  PathData hatched;
  std::size_t points = 0, left_out = 0;
  sheet_.body() << "<g class=\"cells\" transform=\"scale(.1)\">\n";
  for (const Cell& cell : cells_) {
    for (const auto& ring : cell.rings) points += ring.size();
    if (points > kMaxPoints) {
      ++left_out;
      continue;
    }
    write_cell(cell, colours[cell.face], cells_.size() <= kMaxTitles);
    if (!is_in_one(origin(cell.face))) continue;
    for (const auto& ring : cell.rings) append_ring(ring, hatched);
  }
  has_hatch_ = !hatched.empty();
  write_hatch(hatched);
  sheet_.body() << "</g>\n";
  if (left_out > 0) sheet_.note("Too many to be drawn: " + counted(left_out, "cell") + ".");
}

void OverlaySheet::write_borders() {
  std::vector<std::uint8_t> kind;
  for_borders(overlay_, [&kind](const auto& left, const auto& right) {
    const bool first = left.first != right.first, second = left.second != right.second;
    kind.push_back(first && second ? kBoth : first ? kFirstOnly : second ? kSecondOnly : kNoBorder);
  });
  sheet_.body() << "<g transform=\"scale(.1)\">\n";
  for (const BorderKind k : {kSecondOnly, kBoth, kFirstOnly}) {
    PathData path;
    const std::size_t left_out = append_chains(complex_, kind, k, at_, kMaxPoints, path);
    if (left_out > 0) sheet_.note("Too many to be drawn: " + counted(left_out, "edge") + ".");
    if (path.empty()) continue;
    has_border_[k] = true;
    const double length = std::max(total_length(complex_, kind, k, at_), 1.0);
    const double most = 0.15 * frame_.width() * frame_.height() / length;
    const double width = std::min(k == kSecondOnly ? kMostLine / 3 : kMostLine, most);
    sheet_.body() << "<path class=\"border " << kBorderClass[k] << "\" stroke-width=\""
                  << svg_number(10 * width) << "\" d=\"" << path.data() << "\"/>\n";
  }
  sheet_.body() << "</g>\n";
}

bool OverlaySheet::write_label(const Cell& cell) {
  const std::string text = pair_text(origin(cell.face));
  for (const double size : kLabelSizes) {
    const auto room = room_inside(cell.rings, text_width(text, size) + 0.3 * size, size);
    if (!room || !frame_.contains(*room)) continue;
    sheet_.body() << "<text class=\"label\" style=\"font-size:" << size << "px\" x=\""
                  << svg_number(room->centre().x) << "\" y=\""
                  << svg_number(room->centre().y + 0.36 * size) << "\">" << xml_escaped(text)
                  << "</text>\n";
    return true;
  }
  return false;
}

void OverlaySheet::write_labels() {
  std::size_t labels = 0;
  for (const Cell& cell : cells_) {
    if (labels == kMaxLabels) break;
    if (origin(cell.face) != MapOverlay::Origin{0, 0} && write_label(cell)) ++labels;
  }
  has_labels_ = labels > 0;
  const std::size_t all = complex_.face_count() - 1;
  if (labels < all) {
    sheet_.note("No room for the labels of " + counted(all - labels, "cell") +
                (cells_.size() <= kMaxTitles ? "; point at a cell to read its own." : "."));
  }
}

void OverlaySheet::write_legend() {
  const auto line = [](const char* css, double width) {
    return std::string("<path class=\"border ") + css + "\" stroke-width=\"" + svg_number(width) +
           "\" d=\"M-14 0H14\"/>";
  };
  if (has_labels_)
    sheet_.write_item("<text class=\"label\" y=\"6\" style=\"font-size:18px\">a/b</text>", "labels",
                      "region a of " + options_.first + ", b of " + options_.second);
  if (has_border_[kBoth]) sheet_.write_item(line("both", 3), "both", "a border in both maps");
  if (has_border_[kFirstOnly])
    sheet_.write_item(line("first", 3), "one", "a border of " + options_.first + " only");
  if (has_border_[kSecondOnly])
    sheet_.write_item(line("second", 1.5), "thin", "a border of " + options_.second + " only");
  if (has_hatch_)
    sheet_.write_item(
        "<rect class=\"hatch\" transform=\"scale(.1)\" x=\"-140\" y=\"-100\" "
        "width=\"280\" height=\"200\"/>",
        "hatched", "in one map only; grey: outside of " + options_.first);
  if (has_tiny_) sheet_.note("Cells too small to be seen are a grey tint.");
  sheet_.end_legend();
}

}  // namespace

IdVector<FaceId, OverlayColour> colour_cells(const MapOverlay& overlay) {
  const std::vector<std::uint8_t> tints = colour_first_regions(overlay);
  const Pairs pairs = pairs_of(overlay);
  Pairs neighbours;
  for_borders(overlay, [&](const auto& left, const auto& right) {
    if (left.first == right.first && left.second != right.second) {
      neighbours.emplace_back(index_of(pairs, left), index_of(pairs, right));
    }
  });
  const std::vector<std::uint8_t> shades = coloured(pairs.size(), std::move(neighbours), kShades);
  IdVector<FaceId, OverlayColour> colours;
  for (const MapOverlay::Origin& o : overlay.origin) {
    const std::uint8_t tint = o.first == 0 ? kTints : tints[o.first];
    colours.push_back({tint, shades[index_of(pairs, o)]});
  }
  return colours;
}

void write_overlay_svg(std::ostream& out, const MapOverlay& overlay,
                       const OverlaySvgOptions& options) {
  OverlaySheet(overlay, options).write(out);
}

}  // namespace plumb
