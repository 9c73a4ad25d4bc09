// Reading of SVG drawings: elements, transforms, and the basic shapes as outlines.
//
// XmlScanner reports elements one after the other; a stack contains the products of the transforms
// of all open elements. Groups are entered, shapes are given to SvgOutline, which flattens them in
// the coordinates of the drawing, and elements that would be drawn but are not supported (text,
// images) are left out with a note. For a use, a second scanner reads the element that the use
// names, as if it stood there, and the first scanner waits; the work is bounded by the bytes that
// all uses read. Elements that are not drawn (display, visibility) are left out. Style sheets apply
// to the whole drawing, so they are read before the first element (svg_style.h). The root fixes the
// frame: the middle of the drawing becomes the origin, the y axis is turned upwards, and the
// default tolerance is a thousandth of the larger side. Format: W3C, Scalable Vector Graphics (SVG)
// 1.1; docs/formats.md, section Drawings. Tested by tests/io/svg_reader_test.cpp.
#include "plumb/io/svg_reader.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "plumb/base/internal/degrees.h"
#include "plumb/io/svg/svg_outline.h"
#include "plumb/io/svg/svg_style.h"
#include "plumb/io/svg/svg_syntax.h"
#include "plumb/io/text/input_cursors.h"
#include "plumb/predicates/arithmetic/elementary.h"
#include "plumb/predicates/error.h"

namespace plumb {
namespace {

constexpr double kThousandth = 1e-3;

/// The elements that would be drawn, but are left out.
constexpr std::array<std::string_view, 3> kLeftOut{"text", "image", "foreignObject"};

/// The role of an open element for the elements in it.
enum class SvgChoice : std::uint8_t {
  All,   ///< All of them are drawn.
  One,   ///< A switch: the first one without conditions is drawn.
  Made,  ///< A switch of which one was drawn.
};

constexpr std::size_t kMostUsesNested = 64;
/// Nested uses can place an element any number of times. All placed elements together have at most
/// this many bytes of text, or this multiple of the text.
constexpr std::uint64_t kMostUsedBytes = std::uint64_t{1} << 23U, kMostUsedTimes = 16;

class SvgReader {
 public:
  SvgReader(std::string_view text, const ReadOptions& options, std::optional<double> tolerance,
            SvgFrame frame, Context& context)
      : frame_(frame),
        document_(text, options.name, context),
        scanners_{document_},
        numbers_(context, false, text.size()),
        text_(text),
        tolerance_(tolerance),
        outline_(text, tolerance, context),
        context_(context) {}

  SvgDrawing read();

 private:
  using Outline = void (SvgReader::*)();
  struct Kind {
    std::string_view name;
    Outline outline;
  };
  static const std::array<Kind, 7> kKinds;
  /// The place where the used element begins, and the size that the use states.
  struct Use {
    const char* tag;
    std::optional<double> width, height;
  };

  XmlScanner& scanner() { return scanners_.back(); }
  const XmlScanner& scanner() const { return scanners_.back(); }
  void start_root();
  void start_element();
  void end_element();
  bool is_used_root() const;
  bool is_chosen();
  void start_use();
  void end_use();
  void find_ids();
  SvgTransform placing();
  SvgTransform viewport(Point2 corner, double width, double height);
  void skip_element();
  std::optional<SvgValue> value(std::string_view name);
  double whole_of(std::string_view name) const;
  std::optional<double> length_if(std::string_view name);
  double length(std::string_view name);
  double size(std::string_view name);
  Point2 size() const { return sizes_.empty() ? Point2{0, 0} : sizes_.back(); }
  void end_value(SvgValue& text);
  SvgTransform read_transform(SvgValue text);
  SvgTransform read_one_transform(SvgValue& text);
  TextCursor here() const { return scanner().cursor_at(scanner().tag()); }

  void read_rect();
  void add_rounded(Point2 low, Point2 high, double rx, double ry);
  void read_circle();
  void read_ellipse();
  void read_line();
  void read_points();
  void read_path();

  std::string_view property(std::string_view name) const;
  bool is_even_odd(bool inherited) const;
  bool is_hidden(bool inherited) const;
  bool refers(std::string_view name) const;
  void note_effects();
  void read_style_sheets();
  std::optional<double> millimetres(std::string_view name);
  void set_frame(double x, double y, double width, double height);

  SvgFrame frame_;
  const XmlScanner document_;  // The scanner at the beginning.
  // The scanner of the drawing, followed by the scanners of the used elements. The innermost is
  // last.
  std::vector<XmlScanner> scanners_;
  NumberReader numbers_;
  std::string_view text_;
  std::optional<double> tolerance_;
  SvgOutline outline_;
  Context& context_;
  // Transforms of the open elements, each the product of all above it.
  std::vector<SvgTransform> transforms_;
  std::vector<std::uint8_t> even_odd_;  // The fill rules of the open elements.
  std::vector<std::uint8_t> hidden_;    // Whether the open elements are invisible.
  std::vector<SvgChoice> choices_;      // For the open elements.
  // For the open elements, the width and the height to which percentages refer, or 0 if they are
  // unknown.
  std::vector<Point2> sizes_;
  // The size of the element that is being entered.
  Point2 inner_size_{0, 0};
  // The elements by their ids, after a use has requested one.
  std::map<std::string_view, XmlScanner> elements_;
  bool has_ids_ = false;
  bool is_undrawn_root_ = false;  // Whether nothing of the drawing is drawn.
  std::vector<Use> uses_;         // The uses that are being read. The innermost is last.
  std::uint64_t used_bytes_ = 0;  // The size of all elements that uses have placed.
  std::set<std::string_view> left_out_;
  SvgStyleSheet style_sheet_;
};

const std::array<SvgReader::Kind, 7> SvgReader::kKinds{{
    {"rect", &SvgReader::read_rect},
    {"circle", &SvgReader::read_circle},
    {"ellipse", &SvgReader::read_ellipse},
    {"line", &SvgReader::read_line},
    {"polyline", &SvgReader::read_points},
    {"polygon", &SvgReader::read_points},
    {"path", &SvgReader::read_path},
}};

/// Returns the name without the prefix that some programs give elements of SVG.
std::string_view plain_name(std::string_view name) {
  take_prefix(name, "svg:");
  return name;
}

// ---------------------------------------------------------------- elements

SvgDrawing SvgReader::read() {
  for (bool is_first = true;; is_first = false) {
    switch (scanner().next()) {
      case XmlScanner::Event::Done: {
        for (const std::string_view name : left_out_) {
          outline_.note("left out: " + std::string(name));
        }
        for (const auto& [property, selector] : style_sheet_.not_applied()) {
          outline_.note("a rule of the style sheet is not applied: " + quoted(selector) + " sets " +
                        std::string(property));
        }
        return outline_.take();
      }
      case XmlScanner::Event::End:
        end_element();
        break;
      case XmlScanner::Event::Start:
        if (is_first) {
          start_root();
        } else {
          start_element();
        }
    }
    while (scanners_.size() > 1 && scanner().finished()) end_use();
  }
}

void SvgReader::end_element() {
  transforms_.pop_back();
  even_odd_.pop_back();
  hidden_.pop_back();
  choices_.pop_back();
  sizes_.pop_back();
}

/// Reads the size of the drawing from its viewBox, or otherwise from width and height. The
/// transform of the root moves the middle to the origin, and turns the y axis upwards.
void SvgReader::start_root() {
  if (plain_name(scanner().element()) != "svg") {
    scanner().fail(ErrorCode::UnknownFormat,
                   "the root element is " + quoted(scanner().element()) + ", not svg",
                   scanner().tag());
  }
  // The middle of the drawing and its size.
  double x = 0, y = 0, width = 0, height = 0;
  if (std::optional<SvgValue> box = value("viewBox")) {
    x = box->number();
    y = box->number();
    width = box->number();
    height = box->number();
    end_value(*box);
  } else if (value("width") && value("height")) {
    const auto is_relative = [this](std::string_view name) {
      return scanner().attribute(name)->ends_with('%');
    };
    if (!is_relative("width") && !is_relative("height")) {
      width = length("width");
      height = length("height");
    }
  }
  if (width < 0 || height < 0) {
    scanner().fail(ErrorCode::BadShape, "a drawing of negative size", scanner().tag());
  }
  sizes_.push_back({width, height});
  read_style_sheets();
  is_undrawn_root_ = is_css_word(property("display"), "none");
  set_frame(x, y, width, height);
  even_odd_.push_back(is_even_odd(false) ? 1 : 0);
  hidden_.push_back(is_hidden(false) ? 1 : 0);
  choices_.push_back(SvgChoice::All);
}

/// Sets the root's transform and, if none is given, the tolerance.
void SvgReader::set_frame(double x, double y, double width, double height) {
  const bool is_corner = frame_ == SvgFrame::Corner;
  double unit = 1;
  if (is_corner && width > 0 && height > 0) {
    const std::optional<double> wide = millimetres("width"), high = millimetres("height");
    if (wide || high) {
      unit = std::min(wide.value_or(HUGE_VAL) / width, high.value_or(HUGE_VAL) / height);
    }
  }
  const double larger = std::max(width, height) * unit;
  if (!tolerance_ && larger * kThousandth > 0) outline_.set_tolerance(larger * kThousandth);
  if (is_corner) {
    transforms_.push_back({unit, 0, 0, -unit, -x * unit, (y + height) * unit});
  } else {
    transforms_.push_back({1, 0, 0, -1, -(x + width / 2), y + height / 2});
  }
}

/// Returns a length of the root in millimetres, if the length has a physical unit.
std::optional<double> SvgReader::millimetres(std::string_view name) {
  constexpr std::array<std::pair<std::string_view, double>, 5> kPhysical{
      {{"mm", 1}, {"cm", 10}, {"in", 25.4}, {"pt", 25.4 / 72}, {"pc", 25.4 / 6}}};
  const std::string_view text = scanner().attribute(name).value_or("");
  for (const auto& [suffix, unit] : kPhysical) {
    if (!text.ends_with(suffix)) continue;
    const double length = value(name)->number();
    if (length > 0) return length * unit;
  }
  return {};
}

/// Returns a presentation property of the element that started last, or an empty text. The
/// attribute style decides before style sheets, which may have important rules, and these decide
/// before the attribute of this name.
std::string_view SvgReader::property(std::string_view name) const {
  const auto attribute = [&](std::string_view which) {
    return scanner().attribute(which).value_or(std::string_view{});
  };
  const std::string_view style = attribute("style");
  if (const std::size_t entity = find_entity(style); entity != style.npos) {
    scanner().fail(ErrorCode::Syntax, "a reference to an entity: entities are not expanded",
                   style.data() + entity);
  }
  SvgDeclaration decisive = svg_declaration(style, name);
  if (!style_sheet_.is_empty()) {
    const SvgDeclaration other = style_sheet_.value(
        name, {plain_name(scanner().element()), attribute("id"), attribute("class")});
    const bool is_stronger = other.is_important && !decisive.is_important;
    if (!other.value.empty() && (decisive.value.empty() || is_stronger)) decisive = other;
  }
  return decisive.value.empty() ? trimmed_value(attribute(name)) : decisive.value;
}

/// Returns whether the fill rule of the element that started last is evenodd.
bool SvgReader::is_even_odd(bool inherited) const {
  const std::string_view rule = property("fill-rule");
  if (is_css_word(rule, "evenodd")) return true;
  return is_css_word(rule, "nonzero") ? false : inherited;
}

bool SvgReader::is_hidden(bool inherited) const {
  const std::string_view visibility = property("visibility");
  if (is_css_word(visibility, "hidden") || is_css_word(visibility, "collapse")) return true;
  return is_css_word(visibility, "visible") ? false : inherited;
}

/// Reads all style sheets of the drawing but those for print and other media.
void SvgReader::read_style_sheets() {
  if (text_.find("<style") == text_.npos && text_.find("<svg:style") == text_.npos) return;
  XmlScanner all = document_;
  for (auto event = all.next(); event != XmlScanner::Event::Done; event = all.next()) {
    if (event != XmlScanner::Event::Start || plain_name(all.element()) != "style") continue;
    const std::string_view media = trimmed_value(all.attribute("media").value_or(""));
    const bool is_for_screens =
        media.empty() || is_css_word(media, "all") || is_css_word(media.substr(0, 6), "screen");
    const char* const begin = all.tag();
    while (all.next() == XmlScanner::Event::Start) {
    }
    std::string_view sheet(begin, static_cast<std::size_t>(all.tag() - begin));
    sheet.remove_prefix(std::min(sheet.find('>'), sheet.size() - 1) + 1);
    if (!is_for_screens) continue;
    with_place(all.cursor_at(all.tag()), [&] { style_sheet_.add(sheet, context_); });
  }
  all.release_attributes();
}

void SvgReader::skip_element() {
  for (std::size_t open = 1; open > 0;) {
    open += scanner().next() == XmlScanner::Event::Start ? 1 : std::size_t(0) - 1;
  }
}

/// Whether the element that started last is the element that a use names. A symbol is drawn only
/// there.
bool SvgReader::is_used_root() const {
  return scanners_.size() > 1 && scanner().tag() == uses_.back().tag;
}

/// Finds the elements that have ids. If an id occurs twice, the first element counts.
void SvgReader::find_ids() {
  constexpr std::uint64_t kElementBytes = 2 * sizeof(XmlScanner);
  if (std::exchange(has_ids_, true)) return;
  XmlScanner all = document_;
  for (auto event = all.next(); event != XmlScanner::Event::Done; event = all.next()) {
    if (event != XmlScanner::Event::Start) continue;
    const std::optional<std::string_view> id = all.attribute("id");
    if (!id) continue;
    with_place(all.cursor_at(all.tag()),
               [&] { context_.charge_memory(kElementBytes, "the drawing"); });
    elements_.emplace(*id, all.of_element());
  }
  all.release_attributes();
}

/// Enters the element that the use names. A use that refers to another file, or to a missing
/// element, is left out.
void SvgReader::start_use() {
  std::string_view name = scanner().attribute("href").value_or(
      scanner().attribute("xlink:href").value_or(std::string_view{}));
  if (!take_prefix(name, "#")) {
    left_out_.insert("use of what is not in the file");
    return;
  }
  find_ids();
  const auto found = elements_.find(name);
  if (found == elements_.end()) {
    left_out_.insert("use of what is not in the file");
    return;
  }
  const char* const tag = found->second.tag();
  if (std::ranges::count(uses_, tag, &Use::tag) > 0) {
    scanner().fail(ErrorCode::BadShape, "a use of an element that contains it", scanner().tag());
  }
  if (uses_.size() == kMostUsesNested) {
    scanner().fail(ErrorCode::ResourceLimit, "uses nested more than 64 deep", scanner().tag());
  }
  uses_.push_back({tag, length_if("width"), length_if("height")});
  scanners_.push_back(found->second);
}

void SvgReader::end_use() {
  scanner().release_attributes();
  used_bytes_ += static_cast<std::uint64_t>(scanner().tag() - uses_.back().tag);
  scanners_.pop_back();
  uses_.pop_back();
  if (used_bytes_ > kMostUsedBytes + kMostUsedTimes * text_.size()) {
    scanner().fail(ErrorCode::ResourceLimit, "uses that place too many elements", scanner().tag());
  }
}

/// Returns the map from the coordinates inside the element that started last to those outside of
/// it, without its attribute transform.
SvgTransform SvgReader::placing() {
  const std::string_view name = plain_name(scanner().element());
  if (name == "use") return {1, 0, 0, 1, length("x"), length("y")};
  const bool is_symbol = name == "symbol";
  if (!is_symbol && name != "svg") return {};
  const Use use = is_used_root() ? uses_.back() : Use{};
  const auto side = [&](std::string_view which, std::optional<double> of_use, double whole) {
    return of_use ? *of_use : length_if(which).value_or(whole);
  };
  const double width = side("width", use.width, size().x);
  const double height = side("height", use.height, size().y);
  return viewport(is_symbol ? Point2{0, 0} : Point2{length("x"), length("y")}, width, height);
}

/// Returns the map from the viewBox of the element to a box of the given corner and size. By
/// default the picture keeps its shape, and is as large as fits, in the middle.
SvgTransform SvgReader::viewport(Point2 corner, double width, double height) {
  std::optional<SvgValue> box = value("viewBox");
  inner_size_ = {width, height};
  if (!box) return {1, 0, 0, 1, corner.x, corner.y};
  const double x = box->number(), y = box->number();
  const double wide = box->number(), high = box->number();
  end_value(*box);
  inner_size_ = {wide, high};
  if (!(wide > 0 && high > 0 && width > 0 && height > 0)) {
    return {1, 0, 0, 1, corner.x - x, corner.y - y};
  }
  const std::string_view rule = scanner().attribute("preserveAspectRatio").value_or("");
  const auto has = [&](std::string_view word) { return rule.find(word) != rule.npos; };
  Point2 scale{width / wide, height / high};
  if (!has("none")) {
    scale.x = scale.y = has("slice") ? std::max(scale.x, scale.y) : std::min(scale.x, scale.y);
  }
  const double right = has("xMin") ? 0 : has("xMax") ? 1 : 0.5;
  const double down = has("YMin") ? 0 : has("YMax") ? 1 : 0.5;
  return {scale.x,
          0,
          0,
          scale.y,
          corner.x + right * (width - wide * scale.x) - x * scale.x,
          corner.y + down * (height - high * scale.y) - y * scale.y};
}

/// Whether the element that started last is drawn, if it belongs to a switch. In a switch, the
/// first element without conditions is drawn, because plumb knows no extensions and prefers no
/// language.
bool SvgReader::is_chosen() {
  SvgChoice& choice = choices_.back();
  if (choice == SvgChoice::All) return true;
  if (choice == SvgChoice::Made || scanner().attribute("requiredExtensions")) return false;
  if (scanner().attribute("systemLanguage")) {
    left_out_.insert("parts of a switch for a language");
    return false;
  }
  choice = SvgChoice::Made;
  return true;
}

/// Enters a group, reads a shape, or skips an element with its content.
void SvgReader::start_element() {
  const std::string_view name = plain_name(scanner().element());
  const auto kind = std::ranges::find(kKinds, name, &Kind::name);
  const bool is_group = name == "g" || name == "a" || name == "svg" || name == "use" ||
                        name == "switch" || (name == "symbol" && is_used_root());
  const bool is_left_out = std::ranges::count(kLeftOut, name) > 0;
  if ((is_group || is_left_out || kind != kKinds.end()) && !is_chosen()) return skip_element();
  if ((kind == kKinds.end() && !is_group) || is_undrawn_root_ ||
      is_css_word(property("display"), "none")) {
    if (is_left_out) left_out_.insert(name);
    return skip_element();
  }
  SvgTransform transform = transforms_.back();
  if (std::optional<SvgValue> text = value("transform")) {
    transform = product(transform, read_transform(std::move(*text)));
  }
  inner_size_ = size();
  if (is_group) transform = product(transform, placing());
  with_place(here(), [&] {
    context_.charge_memory(2 * sizeof(SvgTransform) + 2 * sizeof(Point2) + 4, "the drawing");
  });
  transforms_.push_back(transform);
  const bool fills_by_evenodd = is_even_odd(even_odd_.back() != 0);
  even_odd_.push_back(fills_by_evenodd ? 1 : 0);
  note_effects();
  const bool hides = is_hidden(hidden_.back() != 0);
  hidden_.push_back(hides ? 1 : 0);
  choices_.push_back(name == "switch" ? SvgChoice::One : SvgChoice::All);
  sizes_.push_back(inner_size_);
  if (name == "use") return start_use();
  if (is_group || hides) return;
  outline_.set_transform(transform);
  (this->*kind->outline)();
  outline_.end_shape(fills_by_evenodd);
}

/// Notes the effects that a drawing program would give the element that started last, in addition
/// to its outline.
void SvgReader::note_effects() {
  constexpr std::array<std::string_view, 2> kCuts{"clip-path", "mask"};
  constexpr std::array<std::string_view, 4> kMarkers{"marker", "marker-start", "marker-mid",
                                                     "marker-end"};
  for (const std::string_view name : kCuts) {
    if (refers(name)) left_out_.insert(name);
  }
  for (const std::string_view name : kMarkers) {
    if (refers(name)) left_out_.insert("markers");
  }
  if (!refers("fill")) return;
  std::string_view id = property("fill");
  id.remove_prefix(std::min(id.find('#'), id.size() - 1) + 1);
  id = id.substr(0, id.find_first_of("\"')"));
  find_ids();
  const auto found = elements_.find(id);
  if (found != elements_.end() && plain_name(found->second.element()) == "pattern") {
    left_out_.insert("patterns that fill shapes; the whole shapes are read");
  }
}

/// Whether a property of the element that started last names another element.
bool SvgReader::refers(std::string_view name) const {
  const bool may_be_in_style =
      scanner().attribute("style").value_or("").find("url(") != std::string_view::npos;
  if (!may_be_in_style && !scanner().attribute(name)) return false;
  return property(name).starts_with("url(");
}

// ---------------------------------------------------------------- attributes

std::optional<SvgValue> SvgReader::value(std::string_view name) {
  const std::optional<std::string_view> found = scanner().attribute(name);
  if (!found) return {};
  return SvgValue(scanner().cursor_at(found->data()), *found, numbers_);
}

void SvgReader::end_value(SvgValue& text) {
  if (!text.at_end()) text.fail_expected("the end of the value");
}

/// Returns the length to which a percentage in an attribute refers, or 0 if it is unknown.
double SvgReader::whole_of(std::string_view name) const {
  if (name == "r") return std::hypot(size().x, size().y) / std::numbers::sqrt2;
  const bool is_vertical = name == "height" || name.find('y') != name.npos;
  return is_vertical ? size().y : size().x;
}

std::optional<double> SvgReader::length_if(std::string_view name) {
  std::optional<SvgValue> text = value(name);
  if (!text) return {};
  const double length = text->length(whole_of(name));
  end_value(*text);
  return length;
}

double SvgReader::length(std::string_view name) { return length_if(name).value_or(0); }

double SvgReader::size(std::string_view name) {
  const double size = length(name);
  if (size >= 0) return size;
  scanner().fail(ErrorCode::BadShape, quoted(name) + " is negative",
                 scanner().attribute(name)->data());
}

SvgTransform SvgReader::read_transform(SvgValue text) {
  SvgTransform all;
  while (!text.at_end()) {
    outline_.step();
    all = product(all, read_one_transform(text));
  }
  return all;
}

SvgTransform SvgReader::read_one_transform(SvgValue& text) {
  const char* const where = text.position();
  const std::string_view name = text.word();
  text.take('(');
  std::array<double, 6> n{};
  std::size_t count = 0;
  while (!text.at_end() && text.peek() != ')' && count < n.size()) n[count++] = text.number();
  text.take(')');
  const auto is = [&](std::string_view other, std::size_t least, std::size_t most) {
    return name == other && (count == least || count == most);
  };
  constexpr double kDegree = std::numbers::pi / 180;
  if (is("matrix", 6, 6)) return {n[0], n[1], n[2], n[3], n[4], n[5]};
  if (is("translate", 1, 2)) return {1, 0, 0, 1, n[0], n[1]};
  if (is("scale", 1, 2)) return {n[0], 0, 0, count == 1 ? n[0] : n[1], 0, 0};
  if (is("skewX", 1, 1)) return {1, 0, tangent(n[0] * kDegree), 1, 0, 0};
  if (is("skewY", 1, 1)) return {1, tangent(n[0] * kDegree), 0, 1, 0, 0};
  if (is("rotate", 1, 3)) {
    const Point2 turn = unit_vector(n[0]);
    const SvgTransform rotation{turn.x, turn.y, -turn.y, turn.x, 0, 0};
    const SvgTransform there{1, 0, 0, 1, n[1], n[2]}, back{1, 0, 0, 1, -n[1], -n[2]};
    return product(product(there, rotation), back);
  }
  text.fail(ErrorCode::Syntax,
            "expected matrix, translate, scale, rotate, skewX or skewY and their numbers", where);
}

// ---------------------------------------------------------------- outlines

void SvgReader::read_rect() {
  const double x = length("x"), y = length("y"), width = size("width"), height = size("height");
  // By the specification of SVG, such an element is not drawn.
  if (width == 0 || height == 0) return;
  const std::optional<double> given_x = length_if("rx"), given_y = length_if("ry");
  const double rx = std::clamp(given_x.value_or(given_y.value_or(0)), 0., width / 2);
  const double ry = std::clamp(given_y.value_or(given_x.value_or(0)), 0., height / 2);
  if (rx > 0 && ry > 0) return add_rounded({x, y}, {x + width, y + height}, rx, ry);
  const TextCursor at = here();
  outline_.move_to(at, {x, y});
  outline_.line_to(at, {x + width, y});
  outline_.line_to(at, {x + width, y + height});
  outline_.line_to(at, {x, y + height});
}

/// Adds a rectangle with rounded corners: four lines and four quarters of ellipses, as SVG defines
/// it.
void SvgReader::add_rounded(Point2 low, Point2 high, double rx, double ry) {
  const TextCursor at = here();
  constexpr double kQuarter = std::numbers::pi / 2;
  const double right = high.x - rx, left = low.x + rx, bottom = high.y - ry, top = low.y + ry;
  const auto corner = [&](Point2 centre, int quarters, Point2 to) {
    outline_.arc_to(at, centre, {rx, 0}, {0, ry}, quarters * kQuarter, (quarters + 1) * kQuarter,
                    to);
  };
  outline_.move_to(at, {left, low.y});
  outline_.line_to(at, {right, low.y});
  corner({right, top}, -1, {high.x, top});
  outline_.line_to(at, {high.x, bottom});
  corner({right, bottom}, 0, {right, high.y});
  outline_.line_to(at, {left, high.y});
  corner({left, bottom}, 1, {low.x, bottom});
  outline_.line_to(at, {low.x, top});
  corner({left, top}, 2, {left, low.y});
}

void SvgReader::read_circle() {
  const double radius = size("r");
  const Point2 centre{length("cx"), length("cy")};
  if (radius > 0) add_svg_ellipse(here(), centre, radius, radius, outline_);
}

void SvgReader::read_ellipse() {
  const double rx = size("rx"), ry = size("ry");
  const Point2 centre{length("cx"), length("cy")};
  if (rx > 0 && ry > 0) add_svg_ellipse(here(), centre, rx, ry, outline_);
}

void SvgReader::read_line() {
  const Point2 from{length("x1"), length("y1")}, to{length("x2"), length("y2")};
  outline_.move_to(here(), from);
  outline_.line_to(here(), to);
}

void SvgReader::read_points() {
  std::optional<SvgValue> text = value("points");
  if (!text) return;
  for (bool is_first = true; !text->at_end(); is_first = false) {
    const double x = text->number();
    const double y = text->number();
    if (is_first) {
      outline_.move_to(text->cursor(), {x, y});
    } else {
      outline_.line_to(text->cursor(), {x, y});
    }
  }
}

void SvgReader::read_path() {
  if (std::optional<SvgValue> text = value("d")) read_svg_path(*text, outline_);
}

}  // namespace

SvgDrawing read_svg(std::string_view text, const ReadOptions& options,
                    std::optional<double> tolerance, Context& context, SvgFrame frame) {
  const RoundToNearest rounding;
  return SvgReader(text, options, tolerance, frame, context).read();
}

}  // namespace plumb
