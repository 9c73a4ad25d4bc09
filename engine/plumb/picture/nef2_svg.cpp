// The picture of a set of the plane: fill, edges and vertices by their marks, and optional parts in
// colours.
//
// The set is intersected exactly with a window that surrounds its vertices, so unbounded cells end
// at the frame, where they fade out. Edges that only the cut made lie on the window's border and
// are not drawn. Marks decide the look: marked edges are solid, and unmarked edges are dashed. A
// vertex gets a full or hollow dot if its mark does not follow from its edges. Edges of one kind
// are joined into chains so that dashes run on. Parts of a decomposition are drawn over the fill
// and under the edges of the set.
// Tested by tests/picture/nef2_svg_test.cpp.

#include "plumb/picture/nef2_svg.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <ostream>
#include <span>
#include <vector>

#include "plumb/base/context.h"
#include "plumb/io/text/text_output.h"
#include "plumb/picture/plane/outlines.h"
#include "plumb/picture/plane/plane_view.h"
#include "plumb/picture/scene.h"
#include "plumb/picture/scene/scene_frame.h"
#include "plumb/picture/svg/sheet.h"
#include "plumb/picture/svg/svg_text.h"
#include "plumb/plane/nef2.h"
#include "plumb/plane/plane_measure.h"

namespace plumb {

// The parts of a set in its picture. Each part is filled with a different colour and has thin lines
// around it.
inline constexpr const char* kPieceStyle =
    R"(.piece{fill-rule:evenodd;stroke:#5b6672;stroke-width:10}
.under{fill:none;stroke:#fff;stroke-linecap:butt}
)";

/// The numbers of parts. Parts that are too small to be visible, and parts of dimension 1 and 0,
/// are not counted.
struct PieceCounts {
  std::size_t drawn = 0;
  std::size_t left_out = 0;  ///< Parts beyond what one file should hold.
};

/// Draws the marked faces of the pieces. `is_cut` says that pieces may leave the window. The
/// context is checked at each piece.
PieceCounts write_pieces(std::span<const Nef2> pieces, const PlaneWindow& window, const View& view,
                         bool is_cut, Context& context, std::ostream& out);

namespace {

constexpr double kVisible = 1.2;
constexpr std::size_t kMaxPoints = 400000;

/// Returns the marked faces in picture units.
PathData path_of(const Nef2& piece, const PlaneWindow& window, const View& view) {
  const PlaneComplex& c = piece.complex();
  std::vector<Point2> at;
  for (const std::uint32_t i : c.vertex_point) at.push_back(view.place(window.at(c.points, i)));
  PathData path;
  for (std::size_t f = 0; f < c.face_count(); ++f) {
    if (!c.mark(FaceId(f))) continue;
    for (const std::vector<VertexId>& ring : face_rings(c, FaceId(f))) {
      const std::vector<Point2> places = points_of(ring, at);
      const Rectangle box = box_of(places);
      if (std::max(box.width(), box.height()) >= kVisible) append_ring(places, path);
    }
  }
  return path;
}

}  // namespace

PieceCounts write_pieces(std::span<const Nef2> pieces, const PlaneWindow& window, const View& view,
                         bool is_cut, Context& context, std::ostream& out) {
  std::size_t points = 0;
  PieceCounts counts;
  out << "<g transform=\"scale(.1)\">\n";
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    context.checkpoint("drawing pieces", i, pieces.size());
    const PathData path =
        path_of(is_cut ? cut_at(pieces[i], window, context) : pieces[i], window, view);
    if (path.empty()) continue;
    points += path.points();
    if (points > kMaxPoints) {
      ++counts.left_out;
      continue;
    }
    ++counts.drawn;
    out << "<path class=\"piece\" fill=\"" << hex(distinct_colour(i)) << "\" d=\"" << path.data()
        << "\"/>\n";
  }
  out << "</g>\n";
  return counts;
}

namespace {

constexpr double kWidth = 600;  // The text remains legible on a phone.
constexpr double kTickRoom = 46;
constexpr double kTickFont = 14;
constexpr double kBoundedMargin = 0.1;
// The width of the margin, as a part of the longer side. The part that fades out lies within it.
constexpr double kFadingMargin = 0.34;
// The width of the part that fades out at each side, as a part of the frame.
constexpr double kFaded = 0.17;
constexpr double kEdgeWidth = 2.6;
constexpr double kDotRadius = 5;
constexpr std::size_t kMaxDots = 5000;
// If there are more vertices, a dot is drawn only if the mark does not follow from the edges.
constexpr std::size_t kFewDots = 120;
constexpr std::size_t kLongNumber = 24;
constexpr std::size_t kCheckedPoints = 256;  // Testing a point takes some microseconds.
constexpr const char* kPhase = "drawing";

constexpr const char* kStyle = R"(.inside{fill:#cfe2f3;fill-rule:evenodd}
.tiny{fill:#cfe2f3}
.edge{fill:none;stroke:#0b4f8a;stroke-linecap:round;stroke-linejoin:round}
.open{stroke-dasharray:7 6;stroke-linecap:butt}
.scaled .open{stroke-dasharray:70 60}
.dot{fill:#0b4f8a}
.hollow{fill:#fff;stroke:#0b4f8a;stroke-width:2}
.tick{font-size:14px;fill:#5b6672}
.axis{stroke:#9aa5b1;stroke-width:1}
.middle{text-anchor:middle;fill:#5b6672}
)";

enum EdgeKind : std::uint8_t { kNotDrawn, kSolid, kDashed };
enum class Dot : std::uint8_t { None, Solid, Hollow };

struct EdgeMarksAround {
  std::size_t marked = 0;
  std::size_t unmarked = 0;
};

EdgeMarksAround marks_around(const PlaneComplex& complex, VertexId v) {
  EdgeMarksAround around;
  for (const HalfedgeId h : complex.dcel.around(v)) {
    ++(complex.mark(edge_of(h)) ? around.marked : around.unmarked);
  }
  return around;
}

/// Whether the mark of v does not follow from the marks of the lines that end there.
bool says_more(const PlaneComplex& complex, VertexId v) {
  if (complex.dcel.is_isolated(v)) return true;
  const EdgeMarksAround around = marks_around(complex, v);
  return complex.mark(v) ? around.unmarked > 0 : around.marked > 0;
}

/// Returns the picture of one dot. If there are `few` dots, ends of slits and all open vertices get
/// a dot, too.
Dot dot_of(const PlaneComplex& complex, VertexId v, bool few) {
  const bool is_shown =
      says_more(complex, v) || (few && (!complex.mark(v) || marks_around(complex, v).marked == 1));
  if (!is_shown) return Dot::None;
  return complex.mark(v) ? Dot::Solid : Dot::Hollow;
}

std::string area_text(const Nef2& set, Context& context) {
  const std::optional<Rational> area = set.area(context);
  if (!area) return "infinite area";
  const std::string exact = format_exact(*area);
  if (exact.size() <= kLongNumber) return "area " + exact;
  std::ostringstream text;
  text.exceptions(std::ios::badbit);  // The stream throws if the memory limit is exceeded.
  text << "area \xE2\x89\x88 " << static_cast<double>(*area);
  return text.str();
}

Badge badge_of(const Nef2& set) {
  if (set.is_empty()) return {"empty set", kPlainBadge};
  if (set.is_whole()) return {"whole plane", kPlainBadge};
  const char* edges = set.is_closed() ? "closed" : set.is_open() ? "open" : "partly open";
  return {std::string(set.is_bounded() ? "bounded, " : "unbounded, ") + edges, kPlainBadge};
}

std::string facts_of(const Nef2& set, Context& context) {
  const PlaneComplex& c = set.complex();
  return counted(c.vertex_count(), "vertex", "vertices") + ", " + counted(c.edge_count(), "edge") +
         ", " + counted(c.face_count(), "face") + ", " + area_text(set, context);
}

class SetSheet {
 public:
  SetSheet(const Nef2& set, const Nef2SvgOptions& options)
      : set_(set),
        options_(options),
        context_(options.context != nullptr ? *options.context : unlimited_context()),
        fades_(set.complex().has_frame() || set.complex().mark(FaceId(0))),
        window_(set.complex(), fades_ ? kFadingMargin : kBoundedMargin),
        shown_(cut_at(set, window_, context_)),
        complex_(shown_.complex()) {}

  void write(std::ostream& out) {
    const Badge badge = badge_of(set_);
    const std::string title = options_.title.empty() ? "set" : options_.title;
    std::string facts = facts_of(set_, context_);
    if (has_pieces()) facts = counted(options_.pieces.size(), "convex piece") + ", " + facts;
    sheet_.write_header(title, badge, facts);
    place();
    write_axes();
    begin_fade();
    write_faces();
    if (has_pieces()) {
      const PieceCounts counts =
          write_pieces(options_.pieces, window_, *view_, fades_, context_, sheet_.body());
      has_cuts_ = counts.drawn > 1;
      left_out_ += counts.left_out;
    }
    write_edges();
    write_dots();
    sheet_.body() << (fades_ ? "</g></g>\n" : "");
    write_frame();
    write_legend();
    sheet_.write(out, title + ": " + badge.text,
                 std::string(kStyle) + (has_pieces() ? kPieceStyle : ""));
  }

 private:
  bool has_pieces() const { return !options_.pieces.empty(); }
  void place();
  void write_axes();
  void begin_fade();
  void write_mask(const char* id, bool is_vertical);
  void write_faces();
  void write_face(FaceId f, PathData& path, TinyFaces& tiny);
  void classify_edges();
  void write_edges();
  double edge_width() const;
  std::vector<VertexId> candidates() const;
  void write_dots();
  void write_frame();
  void write_legend();

  const Nef2& set_;
  const Nef2SvgOptions& options_;
  Context& context_;
  bool fades_;
  PlaneWindow window_;
  Nef2 shown_;
  const PlaneComplex& complex_;  // The complex of shown_.
  Sheet sheet_{{.width = kWidth}};
  Rectangle frame_{};
  std::optional<View> view_;
  IdVector<VertexId, Point2> at_;               ///< Place of each vertex in the picture.
  IdVector<VertexId, std::uint8_t> on_border_;  ///< PlaneWindow::borders() of each vertex.
  std::vector<std::uint8_t> kind_;              ///< EdgeKind of each edge.
  std::size_t left_out_ = 0;
  bool has_faces_ = false, has_solid_ = false, has_dashed_ = false;
  bool has_dots_ = false, has_hollow_ = false, has_cuts_ = false;
};

// ------------------------------------------------------------------ places

void SetSheet::place() {
  const double left = Sheet::kMargin + kTickRoom;
  const double width = sheet_.right() - left;
  frame_ = {left, sheet_.y(), left + width, sheet_.y() + width * window_.aspect()};
  sheet_.set_y(frame_.bottom + kTickFont + 18);
  view_.emplace(frame_, Rectangle{-1, -window_.aspect(), 1, window_.aspect()});
  for (const std::uint32_t i : complex_.vertex_point) {
    if (at_.size() % kCheckedPoints == 0) context_.checkpoint(kPhase, at_.size(), 0);
    at_.push_back(view_->place(window_.at(complex_.points, i)));
    on_border_.push_back(static_cast<std::uint8_t>(window_.borders(complex_.points, i)));
  }
  classify_edges();
}

/// Decides how each edge is drawn. Edges on the border of the window come from the cut.
void SetSheet::classify_edges() {
  for (std::size_t e = 0; e < complex_.edge_count(); ++e) {
    const HalfedgeId h = first_half(EdgeId(e));
    const unsigned borders =
        on_border_[complex_.dcel.origin(h)] & on_border_[complex_.dcel.target(h)];
    kind_.push_back(borders != 0 ? kNotDrawn : complex_.mark(EdgeId(e)) ? kSolid : kDashed);
  }
}

void SetSheet::write_axes() {
  for (const bool is_vertical : {false, true}) {
    for (const PlaneWindow::Tick& tick : window_.ticks(is_vertical)) {
      const double t = tick.at * frame_.width() / 2;
      const Point2 p = is_vertical ? Point2{frame_.left, frame_.centre().y - t}
                                   : Point2{frame_.centre().x + t, frame_.bottom};
      const bool is_inside = is_vertical
                                 ? std::fabs(p.y - frame_.centre().y) < frame_.height() / 2 - 6
                                 : std::fabs(t) < frame_.width() / 2 - 12;
      if (!is_inside) continue;
      sheet_.body() << "<path class=\"axis\" d=\"M" << svg_number(p.x) << ' ' << svg_number(p.y)
                    << (is_vertical ? "h-6" : "v6") << "\"/><text class=\"tick\" text-anchor=\""
                    << (is_vertical ? "end" : "middle") << "\" x=\""
                    << svg_number(p.x - (is_vertical ? 9 : 0)) << "\" y=\""
                    << svg_number(p.y + (is_vertical ? 5 : 20)) << "\">" << tick.text
                    << "</text>\n";
    }
  }
}

// ------------------------------------------------------------------ fading

/// Writes a mask that is white with black ends. A masked element fades out at two opposite sides of
/// the frame.
void SetSheet::write_mask(const char* id, bool is_vertical) {
  const std::string faded = svg_number(kFaded), solid = svg_number(1 - kFaded);
  sheet_.body() << "<linearGradient id=\"g" << id << "\" x1=\"0\" y1=\"0\" x2=\""
                << (is_vertical ? "0\" y2=\"1" : "1\" y2=\"0")
                << "\"><stop offset=\"0\" stop-color=\"#000\"/><stop offset=\"" << faded
                << "\" stop-color=\"#fff\"/><stop offset=\"" << solid
                << "\" stop-color=\"#fff\"/><stop offset=\"1\" stop-color=\"#000\"/>"
                << "</linearGradient><mask id=\"" << id << "\" maskUnits=\"userSpaceOnUse\" "
                << svg_box(frame_) << "><rect " << svg_box(frame_) << " fill=\"url(#g" << id
                << ")\"/></mask>\n";
}

void SetSheet::begin_fade() {
  if (!fades_) return;
  write_mask("h", false);
  write_mask("v", true);
  sheet_.body() << "<g mask=\"url(#h)\"><g mask=\"url(#v)\">\n";
}

// ------------------------------------------------------------------ faces

void SetSheet::write_face(FaceId f, PathData& path, TinyFaces& tiny) {
  for (const std::vector<VertexId>& ring : face_rings(complex_, f)) {
    const std::vector<Point2> places = points_of(ring, at_);
    const Rectangle box = box_of(places);
    const bool is_tiny = std::max(box.width(), box.height()) < kVisible;
    if (is_tiny || path.points() > kMaxPoints) {
      tiny.mark(box.centre());
      left_out_ += is_tiny ? 0 : 1;
    } else {
      append_ring(places, path);
    }
  }
}

void SetSheet::write_faces() {
  PathData path;
  TinyFaces tiny(frame_);
  for (std::size_t f = 0; f < complex_.face_count(); ++f) {
    if (!complex_.mark(FaceId(f))) continue;
    context_.checkpoint(kPhase, f, complex_.face_count());
    has_faces_ = true;
    write_face(FaceId(f), path, tiny);
  }
  if (!path.empty()) {
    sheet_.body() << "<path class=\"inside\" transform=\"scale(.1)\" d=\"" << path.data()
                  << "\"/>\n";
  }
  tiny.write(sheet_.body());
}

// ------------------------------------------------------------------ edges

/// Returns the width of edges such that they cover at most about a third of the picture.
double SetSheet::edge_width() const {
  const double length =
      total_length(complex_, kind_, kSolid, at_) + total_length(complex_, kind_, kDashed, at_);
  const double most = 0.3 * frame_.width() * frame_.height() / std::max(length, 1.0);
  return std::min(kEdgeWidth, most);
}

void SetSheet::write_edges() {
  sheet_.body() << "<g class=\"scaled\" transform=\"scale(.1)\" stroke-width=\""
                << svg_number(10 * edge_width()) << "\">\n";
  for (const EdgeKind kind : {kSolid, kDashed}) {
    context_.checkpoint(kPhase, kind, kDashed);
    PathData path;
    left_out_ += append_chains(complex_, kind_, kind, at_, kMaxPoints, path);
    if (path.empty()) continue;
    (kind == kSolid ? has_solid_ : has_dashed_) = true;
    // A white line hides the outlines of the pieces between the dashes.
    if (kind == kDashed && has_pieces()) {
      sheet_.body() << "<path class=\"under\" d=\"" << path.data() << "\"/>\n";
    }
    sheet_.body() << "<path class=\"edge" << (kind == kDashed ? " open" : "") << "\" d=\""
                  << path.data() << "\"/>\n";
  }
  sheet_.body() << "</g>\n";
}

// ------------------------------------------------------------------ dots

/// Returns vertices of the set itself that may get a dot.
std::vector<VertexId> SetSheet::candidates() const {
  std::vector<VertexId> vertices;
  for (std::size_t v = 0; v < at_.size(); ++v) {
    if (on_border_[v] == 0) vertices.push_back(VertexId(v));
  }
  const auto wants_dot = [this](bool few) {
    return [this, few](VertexId v) { return dot_of(complex_, v, few) == Dot::None; };
  };
  std::vector<VertexId> all = vertices;
  std::erase_if(all, wants_dot(true));
  if (all.size() <= kFewDots) return all;
  std::erase_if(vertices, wants_dot(false));
  return vertices;
}

void SetSheet::write_dots() {
  std::vector<VertexId> vertices = candidates();
  if (vertices.size() > kMaxDots) {
    left_out_ += vertices.size() - kMaxDots;
    vertices.resize(kMaxDots);
  }
  const double radius = vertices.size() <= kFewDots ? kDotRadius : kDotRadius / 2;
  for (const VertexId v : vertices) {
    const bool is_solid = complex_.mark(v);
    (is_solid ? has_dots_ : has_hollow_) = true;
    const Point2 p = at_[v];
    sheet_.body() << "<circle class=\"" << (is_solid ? "dot" : "hollow") << "\" cx=\""
                  << svg_number(p.x) << "\" cy=\"" << svg_number(p.y) << "\" r=\""
                  << svg_number(radius) << "\"/>\n";
  }
}

// ------------------------------------------------------------------ around

void SetSheet::write_frame() {
  sheet_.body() << "<rect class=\"panel\" " << svg_box(frame_) << "/>\n";
  if (!set_.is_empty() && !set_.is_whole()) return;
  sheet_.body() << "<text class=\"middle\" x=\"" << svg_number(frame_.centre().x) << "\" y=\""
                << svg_number(frame_.centre().y) << "\">"
                << (set_.is_empty() ? "no point at all" : "every point") << "</text>\n";
}

void SetSheet::write_legend() {
  if (has_faces_ && !has_pieces()) {
    sheet_.write_item("<rect class=\"inside\" x=\"-11\" y=\"-8\" width=\"22\" height=\"16\"/>",
                      "inside", "points of the set");
  }
  if (has_cuts_) {
    sheet_.write_item("<path d=\"M-11 0H11\" stroke=\"#5b6672\"/>", "cut", "between two pieces");
  }
  if (has_solid_) {
    sheet_.write_item("<path class=\"edge\" stroke-width=\"2.6\" d=\"M-11 0H11\"/>", "closed",
                      "the edge is part of the set");
  }
  if (has_dashed_) {
    sheet_.write_item("<path class=\"edge open\" stroke-width=\"2.6\" d=\"M-11 0H11\"/>", "open",
                      "the edge is not");
  }
  if (has_dots_) {
    sheet_.write_item("<circle class=\"dot\" r=\"5\"/>", "point", "part of the set");
  }
  if (has_hollow_) {
    sheet_.write_item("<circle class=\"hollow\" r=\"5\"/>", "hollow", "a point that is not");
  }
  if (fades_) {
    sheet_.write_item(
        "<linearGradient id=\"f\"><stop stop-color=\"#cfe2f3\"/><stop offset=\"1\" "
        "stop-color=\"#fff\"/></linearGradient>"
        "<rect x=\"-11\" y=\"-8\" width=\"22\" height=\"16\" fill=\"url(#f)\"/>",
        "fading", "goes on to infinity");
  }
  sheet_.end_legend();
  if (left_out_ > 0) {
    sheet_.note("Too many to be drawn one by one: " + counted(left_out_, "part") + " left out.");
  }
}

}  // namespace

void write_nef2_svg(std::ostream& out, const Nef2& set, const Nef2SvgOptions& options) {
  SetSheet(set, options).write(out);
}

}  // namespace plumb
