// Nodes of a tree from the parameters in a file.
//
// Parameters that are missing or undef have OpenSCAD's defaults. Numbers that have no meaning for a
// shape, such as a negative radius, are kept: the evaluation defines their values. An index that
// would be out of range later is refused here, with its place in the file.
//
// Tested by tests/io/csg_reader_test.cpp.
#include "plumb/io/csg/csg_nodes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <limits>
#include <span>

#include "plumb/io/csg/color_names.h"
#include "plumb/predicates/error.h"

namespace plumb {
namespace {

/// A word of the language, the parameters that are read, and the parameters that are skipped
/// without a note.
struct CsgWord {
  std::string_view name;
  CsgKind kind;
  std::string_view parameters;  // The names are separated by blanks.
};

constexpr std::array kWords{
    CsgWord{"group", CsgKind::Group, " "},
    CsgWord{"union", CsgKind::Union, " "},
    CsgWord{"color", CsgKind::Color, " c alpha "},
    CsgWord{"render", CsgKind::Render, " convexity "},
    CsgWord{"difference", CsgKind::Difference, " "},
    CsgWord{"intersection", CsgKind::Intersection, " "},
    CsgWord{"hull", CsgKind::Hull, " "},
    CsgWord{"minkowski", CsgKind::Minkowski, " convexity "},
    CsgWord{"multmatrix", CsgKind::Multmatrix, " m "},
    CsgWord{"resize", CsgKind::Resize, " newsize auto convexity "},
    CsgWord{"offset", CsgKind::Offset, " r delta chamfer $fn $fa $fs "},
    CsgWord{"projection", CsgKind::Projection, " cut convexity "},
    CsgWord{
        "linear_extrude", CsgKind::LinearExtrude,
        " height center twist slices scale convexity v file layer origin timestamp $fn $fa $fs "},
    CsgWord{"rotate_extrude", CsgKind::RotateExtrude,
            " angle start convexity file layer origin scale timestamp $fn $fa $fs "},
    CsgWord{"cube", CsgKind::Cube, " size center "},
    CsgWord{"sphere", CsgKind::Sphere, " r $fn $fa $fs "},
    CsgWord{"cylinder", CsgKind::Cylinder, " h r r1 r2 center $fn $fa $fs "},
    CsgWord{"polyhedron", CsgKind::Polyhedron, " points faces triangles convexity "},
    CsgWord{"square", CsgKind::Square, " size center "},
    CsgWord{"circle", CsgKind::Circle, " r $fn $fa $fs "},
    CsgWord{"polygon", CsgKind::Polygon, " points paths convexity "},
    CsgWord{"text", CsgKind::Group,
            " text size font halign valign spacing direction language script $fn $fa $fs "},
    CsgWord{"import", CsgKind::Solid,
            " file layer origin scale center dpi id width height filename timestamp convexity $fn "
            "$fa $fs "},
    CsgWord{"surface", CsgKind::Solid, " file center invert convexity timestamp "},
};

const CsgWord* word_of(std::string_view name) {
  const auto found = std::find_if(kWords.begin(), kWords.end(),
                                  [&](const CsgWord& word) { return word.name == name; });
  return found == kWords.end() ? nullptr : &*found;
}

constexpr std::size_t kMostNotes = 20;

}  // namespace

CsgKind CsgNodes::kind_of_node() {
  if (const CsgWord* word = word_of(scanner_.name())) return word->kind;
  const std::string name(scanner_.name());
  scanner_.fail(
      ErrorCode::UnknownFormat,
      plumb::quoted(name) + " is no node of OpenSCAD's flattened models that is supported");
}

void CsgNodes::append() {
  const CsgKind kind = kind_of_node();
  memory_.add(sizeof(CsgTree::Node), "a model");
  CsgTree::Node node;
  node.kind = kind;
  node.end = static_cast<std::uint32_t>(tree_.nodes.size() + 1);
  node.first_number = static_cast<std::uint32_t>(tree_.numbers.size());
  node.first_index = static_cast<std::uint32_t>(tree_.indices.size());
  node.line = scanner_.line();
  node.column = scanner_.column();
  tree_.nodes.push_back(node);
  has_lost_number_ = false;
  append_numbers(kind);
  if (has_lost_number_) empty_last_node();
  if (scanner_.name() == "text") append_text();
  if (names_profile()) append_profile();
  CsgTree::Node& added = tree_.nodes[node.end - 1];
  if (tree_.nodes.size() == added.end) count_entries(added);
  added.end = static_cast<std::uint32_t>(tree_.nodes.size());
  note_unknown();
}

void CsgNodes::remove_from(std::uint32_t node) {
  tree_.numbers.resize(tree_.nodes[node].first_number);
  tree_.indices.resize(tree_.nodes[node].first_index);
  tree_.nodes.resize(node);
  while (!imports_.empty() && imports_.back().node >= node) imports_.pop_back();
}

void CsgNodes::append_numbers(CsgKind kind) {
  switch (kind) {
    case CsgKind::Color:
      return append_color();
    case CsgKind::Multmatrix:
      return append_map();
    case CsgKind::Resize:
      return append_resize();
    case CsgKind::Offset:
      return append_offset();
    case CsgKind::Projection:
      return push(flag("cut"));
    case CsgKind::LinearExtrude:
      return append_linear();
    case CsgKind::RotateExtrude:
      push(number("angle", 360));
      append_division();
      if (const auto start = find("start")) push(number_of(*start));
      return;
    case CsgKind::Cube:
      append_vector(find_or_first("size"), 3, 1);
      return push(flag("center"));
    case CsgKind::Square:
      append_vector(find_or_first("size"), 2, 1);
      return push(flag("center"));
    case CsgKind::Sphere:
    case CsgKind::Circle:
      push(number("r", 1));
      return append_division();
    case CsgKind::Cylinder:
      return append_cylinder();
    case CsgKind::Polyhedron:
      return append_points(3);
    case CsgKind::Polygon:
      return append_points(2);
    case CsgKind::Solid:
      return append_import();
    default:
      return;
  }
}

// ---------------------------------------------------------------- nodes

/// The rows are those of an affine map. As in OpenSCAD, all entries are divided by the last one,
/// and the other entries of the last row have no effect.
void CsgNodes::append_map() {
  const std::optional<CsgValue> matrix = find_or_first("m");
  if (!matrix) scanner_.fail(ErrorCode::BadArgument, "multmatrix needs a matrix");
  std::array<double, 16> entries{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
  const std::vector<CsgValue> rows = elements(*matrix);
  for (std::size_t row = 0; row < std::min<std::size_t>(rows.size(), 4); ++row) {
    const std::vector<CsgValue> columns = elements(rows[row]);
    for (std::size_t column = 0; column < std::min<std::size_t>(columns.size(), 4); ++column) {
      entries[4 * row + column] = number_of(columns[column]);
    }
  }
  const double divisor = entries[15];
  if (entries[12] != 0 || entries[13] != 0 || entries[14] != 0) {
    add_note("the first three numbers of the last row of a matrix have no effect");
  }
  for (std::size_t i = 0; i < 12; ++i) {
    const double entry = entries[i] / divisor;
    if (!std::isfinite(entry)) {
      scanner_.fail(ErrorCode::BadArgument, "the last number of the matrix is 0 or too small",
                    matrix->at);
    }
    push(entry);
  }
}

void CsgNodes::append_color() {
  const std::optional<CsgValue> color = find_or_first("c");
  if (!color || (color->kind != Kind::Vector && color->kind != Kind::Text)) return;
  const std::size_t first = tree_.numbers.size();
  if (color->kind == Kind::Vector) {
    append_vector(color, 4, 1);
  } else {
    append_named_color(*color);
  }
  const bool is_complete = tree_.numbers.size() == first + 4;
  if (const std::optional<CsgValue> alpha = find("alpha"); alpha && is_complete) {
    tree_.numbers.back() = number_of(*alpha);
  }
}

/// Appends the numbers of a colour that is given as text. As in OpenSCAD, an unknown name gives no
/// colour, and a note names it.
void CsgNodes::append_named_color(const CsgValue& text) {
  const std::string name = scanner_.text_of(text);
  if (const auto color = color_named(name)) {
    for (const double part : *color) push(part);
    return;
  }
  add_note("the colour " + plumb::quoted(name) + " is unknown, so its children keep theirs");
}

void CsgNodes::append_resize() {
  append_vector(find_or_first("newsize"), 3, 0);
  const std::optional<CsgValue> automatic = find("auto");
  const bool is_vector = automatic && automatic->kind == Kind::Vector;
  if (is_vector) return append_vector(automatic, 3, 0);
  const double all = automatic ? number_of(*automatic) : 0;
  for (int axis = 0; axis < 3; ++axis) push(all);
}

void CsgNodes::append_offset() {
  const bool is_round = find("r").has_value();
  push(is_round ? number("r", 1) : number("delta", 1));
  push(is_round ? 0 : flag("chamfer") != 0 ? 2 : 1);
  append_division();
}

/// The direction `v`, which later versions of OpenSCAD write, is a unit vector. The height is
/// measured along it.
void CsgNodes::append_linear() {
  const double length = number("height", 100);
  std::array<double, 3> direction{0, 0, 1};
  const std::optional<CsgValue> given = find("v");
  if (given) {
    const std::vector<CsgValue> parts = elements(*given);
    if (parts.size() != 3) {
      scanner_.fail(ErrorCode::BadArgument, "v must have three numbers", given->at);
    }
    for (std::size_t axis = 0; axis < 3; ++axis) direction[axis] = number_of(parts[axis]);
  }
  push(length * direction[2]);
  push(flag("center"));
  push(number("twist", 0));
  push(number("slices", 0));
  append_vector(find("scale"), 2, 1);
  append_division();
  if (!given) return;
  push(length * direction[0]);
  push(length * direction[1]);
}

void CsgNodes::append_cylinder() {
  const double both = number("r", 1);
  push(number("h", 1));
  push(number("r1", both));
  push(number("r2", both));
  push(flag("center"));
  append_division();
}

void CsgNodes::append_points(std::uint32_t axes) {
  const std::optional<CsgValue> points = find_or_first("points");
  std::uint32_t count = 0;
  if (points) {
    for (const CsgValue& point : elements(*points)) {
      append_vector(point, axes, 0);
      ++count;
    }
  }
  const bool are_faces = axes == 3;
  std::optional<CsgValue> lists = find(are_faces ? "faces" : "paths");
  if (are_faces && !lists) lists = find("triangles");
  append_lists(lists, count, are_faces);
}

/// Appends faces or paths. A polygon without paths, or with an empty list of them, has one path
/// through all points.
void CsgNodes::append_lists(std::optional<CsgValue> lists, std::uint32_t points, bool are_faces) {
  if (!lists) {
    push_index(are_faces || points == 0 ? 0 : 1);
    if (are_faces || points == 0) return;
    push_index(points);
    for (std::uint32_t i = 0; i < points; ++i) push_index(i);
    return;
  }
  const std::vector<CsgValue> all = elements(*lists);
  if (all.empty() && !are_faces) return append_lists({}, points, are_faces);
  push_index(all.size());
  for (const CsgValue& list : all) push_index(elements(list).size());
  for (const CsgValue& list : all) {
    for (const CsgValue& corner : elements(list)) push_index(index_of(corner, points));
  }
}

/// Whether the node is an extrusion of a drawing that it names itself.
bool CsgNodes::names_profile() {
  const std::string_view name = scanner_.name();
  if (name != "linear_extrude" && name != "rotate_extrude") return false;
  const std::optional<CsgValue> file = find("file");
  return file && file->kind == Kind::Text && !scanner_.text_of(*file).empty();
}

/// Appends the drawing that an extrusion names, as its only child. As in OpenSCAD, `scale` scales
/// the drawing; of linear_extrude() it is also the scale at the top.
void CsgNodes::append_profile() {
  count_entries(tree_.nodes.back());
  CsgTree::Node node = tree_.nodes.back();
  node.kind = CsgKind::Solid;
  node.end = static_cast<std::uint32_t>(tree_.nodes.size() + 1);
  node.first_number = static_cast<std::uint32_t>(tree_.numbers.size());
  node.first_index = static_cast<std::uint32_t>(tree_.indices.size());
  node.number_count = node.index_count = 0;
  memory_.add(sizeof(CsgTree::Node), "a model");
  tree_.nodes.push_back(node);
  append_import();
}

void CsgNodes::append_import() {
  const std::optional<CsgValue> file = find_or_first("file");
  if (!file || file->kind != Kind::Text) {
    scanner_.fail(ErrorCode::BadArgument,
                  std::string(scanner_.name()) + " needs the name of a file");
  }
  const auto node = static_cast<std::uint32_t>(tree_.nodes.size() - 1);
  CsgImport import;
  import.node = node;
  import.file = scanner_.text_of(*file);
  import.division = division();
  import.is_surface = scanner_.name() == "surface";
  // The center of linear_extrude() is that of the solid.
  import.is_centred = !names_profile() && flag("center") != 0;
  if (import.is_surface) import.is_inverted = flag("invert") != 0;
  if (const auto layer = find("layer"); layer && layer->kind == Kind::Text) {
    import.layer = scanner_.text_of(*layer);
  }
  if (const auto origin = find("origin"); origin && origin->kind == Kind::Vector) {
    const std::vector<CsgValue> values = elements(*origin);
    for (std::size_t i = 0; i < std::min<std::size_t>(values.size(), 2); ++i) {
      import.origin[i] = number_of(values[i]);
    }
  }
  const std::optional<CsgValue> scale = find("scale");
  const bool is_vector = scale && scale->kind == Kind::Vector;
  if (is_vector && names_profile()) {
    const std::vector<CsgValue> scales = elements(*scale);
    if (!scales.empty()) import.scale = number_of(scales[0]);
  } else {
    import.scale = number("scale", 1);
  }
  if (!(import.scale > 0)) {
    scanner_.fail(ErrorCode::BadArgument, "the scale of an import must be positive");
  }
  memory_.add(import.file.size() + import.layer.size() + sizeof(CsgImport), "a model");
  imports_.push_back(std::move(import));
}

/// Appends the polygons of the characters. OpenSCAD divides a curve into one chord for every eight
/// chords of a circle of the size of the text, and one more.
void CsgNodes::append_text() {
  constexpr std::uint32_t kMostChords = 1024;
  TextRequest request;
  const std::optional<CsgValue> shown = find_or_first("text");
  if (shown && shown->kind == Kind::Text) {
    request.text = scanner_.text_of(*shown);
  } else if (shown) {
    add_note("a text() whose text is not a string is empty");
  }
  request.font = text("font", "");
  request.size = number("size", request.size);
  request.spacing = number("spacing", request.spacing);
  request.halign = text("halign", request.halign);
  request.valign = text("valign", request.valign);
  const auto note_alignment = [&](std::string_view name, const std::string& value,
                                  std::initializer_list<std::string_view> known) {
    if (std::find(known.begin(), known.end(), value) != known.end()) return;
    add_note("the " + std::string(name) + " " + plumb::quoted(value) +
             " of text() is unknown, so it is ignored");
  };
  note_alignment("halign", request.halign, {"left", "center", "right"});
  note_alignment("valign", request.valign, {"baseline", "bottom", "center", "top"});
  constexpr std::array<std::string_view, 4> kDirections{"ltr", "rtl", "ttb", "btt"};
  const std::string direction = text("direction", "ltr");
  const auto* const known = std::find(kDirections.begin(), kDirections.end(), direction);
  if (known == kDirections.end()) {
    scanner_.fail(ErrorCode::BadArgument, "the direction of text() is " + plumb::quoted(direction) +
                                              ", which is none of ltr, rtl, ttb and btt");
  }
  request.direction = static_cast<TextDirection>(known - kDirections.begin());
  if (!(request.size > 0)) return add_note("a text() whose size is not positive is empty");
  request.chords = std::max(chords_of(request.size, division()) / 8 + 1, 2U);
  if (request.chords > kMostChords) {
    scanner_.fail(ErrorCode::ResourceLimit, "a curve of text() has at most 1024 chords");
  }
  const TextOutlines outlines = outlines_of(request);
  for (const GlyphOutline& glyph : outlines.glyphs) append_glyph(glyph);
}

/// Reads the outlines of a text. Adds the place of the node to every error.
TextOutlines CsgNodes::outlines_of(const TextRequest& request) {
  TextOutlines outlines;
  try {
    outlines = text_outlines(request, context_);
  } catch (const Error& error) {
    if (error.code() == ErrorCode::Cancelled) throw;
    scanner_.fail(error.code(), error.what());
  }
  if (!outlines.is_named) {
    add_note("the font " + plumb::quoted(request.font) + " is not installed, so text() uses " +
             plumb::quoted(outlines.family));
  }
  return outlines;
}

void CsgNodes::append_glyph(const GlyphOutline& glyph) {
  memory_.add(sizeof(CsgTree::Node), "a model");
  CsgTree::Node node;
  node.kind = CsgKind::Polygon;
  node.end = static_cast<std::uint32_t>(tree_.nodes.size() + 1);
  node.first_number = static_cast<std::uint32_t>(tree_.numbers.size());
  node.first_index = static_cast<std::uint32_t>(tree_.indices.size());
  node.line = scanner_.line();
  node.column = scanner_.column();
  for (const auto& [x, y] : glyph.points) {
    push(x);
    push(y);
  }
  push_index(glyph.path_sizes.size());
  for (const std::uint32_t size : glyph.path_sizes) push_index(size);
  for (std::size_t i = 0; i < glyph.points.size(); ++i) push_index(i);
  count_entries(node);
  tree_.nodes.push_back(node);
}

/// Sets the numbers of entries of the node whose numbers and indices are the last ones.
void CsgNodes::count_entries(CsgTree::Node& node) const {
  node.number_count = static_cast<std::uint32_t>(tree_.numbers.size() - node.first_number);
  node.index_count = static_cast<std::uint32_t>(tree_.indices.size() - node.first_index);
}

/// Bounds of chords that never decide, and that always leave the fewest chords.
constexpr double kNoBound = 1e-200, kWeakestBound = 1e200;

/// Zero or negative angles and lengths would divide a circle into endlessly many chords; OpenSCAD
/// takes 0.01 instead.
CircleDivision CsgNodes::division() {
  const double angle = bound_of_chords("$fa", 12), length = bound_of_chords("$fs", 2);
  return {fragments(), std::max(angle, length) == kNoBound ? kWeakestBound : angle, length};
}

/// Returns $fa or $fs. As in OpenSCAD, nan is no bound, so the other one decides alone; inf is the
/// weakest bound, so a circle has five chords.
double CsgNodes::bound_of_chords(const char* name, double otherwise) {
  constexpr double kLeast = 0.01;
  const std::optional<CsgValue> value = find(name);
  if (!value || value->kind != Kind::Number || std::isfinite(value->number)) {
    return std::max(number(name, otherwise), kLeast);
  }
  add_warning(std::string(name) + " is not finite");
  if (std::isnan(value->number)) return kNoBound;
  return value->number > 0 ? kWeakestBound : kLeast;
}

/// Returns $fn. As in OpenSCAD, a number that is not finite counts as 3.
double CsgNodes::fragments() {
  const std::optional<CsgValue> value = find("$fn");
  if (!value || value->kind != Kind::Number || std::isfinite(value->number))
    return number("$fn", 0);
  add_warning("$fn is not finite, so it counts as 3");
  return 3;
}

void CsgNodes::append_division() {
  const CircleDivision all = division();
  for (const double x : {all.count, all.angle, all.length}) push(x);
}

// ---------------------------------------------------------------- parameters

/// Returns the value of a parameter, unless it is missing or undef.
std::optional<CsgValue> CsgNodes::find(std::string_view name) {
  for (const CsgParameter& parameter : scanner_.parameters()) {
    if (parameter.name != name) continue;
    const CsgValue& value = scanner_.value(parameter.value);
    if (value.kind != Kind::Undefined) return value;
  }
  return {};
}

/// Returns the same value. If the parameter is missing, and the first parameter has no name,
/// returns the value of the first parameter.
std::optional<CsgValue> CsgNodes::find_or_first(std::string_view name) {
  const std::optional<CsgValue> found = find(name);
  const auto parameters = scanner_.parameters();
  if (found || parameters.empty() || !parameters[0].name.empty()) return found;
  const CsgValue& first = scanner_.value(parameters[0].value);
  return first.kind == Kind::Undefined ? std::nullopt : std::optional(first);
}

double CsgNodes::number_of(const CsgValue& value) {
  if (value.kind != Kind::Number && value.kind != Kind::Boolean) {
    scanner_.fail(ErrorCode::BadArgument, "expected a number", value.at);
  }
  if (std::isfinite(value.number)) return value.number;
  // As in OpenSCAD, a primitive or a matrix with such a number gives nothing.
  const std::string_view name = scanner_.name();
  constexpr std::array<std::string_view, 6> kEmptied{"cube",   "sphere", "cylinder",
                                                     "square", "circle", "multmatrix"};
  if (std::find(kEmptied.begin(), kEmptied.end(), name) == kEmptied.end()) {
    scanner_.fail(ErrorCode::NumberOutOfRange, "the number is not finite", value.at);
  }
  has_lost_number_ = true;
  return 0;
}

/// Sets all numbers of the last node to 0, which makes a primitive or an image empty.
void CsgNodes::empty_last_node() {
  const std::size_t first = tree_.nodes.back().first_number;
  std::fill(tree_.numbers.begin() + static_cast<std::ptrdiff_t>(first), tree_.numbers.end(), 0);
  add_warning("a number is not finite, so it gives nothing");
}

/// Adds a warning with the place of the node that the scanner reported last.
void CsgNodes::add_warning(const std::string& text) {
  if (warnings_.size() >= kMostNotes) return;
  warnings_.push_back(std::to_string(scanner_.line()) + ":" + std::to_string(scanner_.column()) +
                      ": " + std::string(scanner_.name()) + ": " + text);
}

double CsgNodes::number(std::string_view name, double otherwise) {
  const std::optional<CsgValue> value = find(name);
  return value ? number_of(*value) : otherwise;
}

std::string CsgNodes::text(std::string_view name, const std::string& otherwise) {
  const std::optional<CsgValue> value = find(name);
  if (!value) return otherwise;
  if (value->kind == Kind::Text) return scanner_.text_of(*value);
  add_note("the parameter " + plumb::quoted(name) + " of text() is not a string, so it is ignored");
  return otherwise;
}

double CsgNodes::flag(std::string_view name) { return number(name, 0) != 0 ? 1 : 0; }

/// Returns the elements of a vector.
std::vector<CsgValue> CsgNodes::elements(const CsgValue& vector) {
  if (vector.kind != Kind::Vector) {
    scanner_.fail(ErrorCode::BadArgument, "expected a vector", vector.at);
  }
  std::vector<CsgValue> all;
  for (std::uint32_t i = vector.first; i < vector.end; i = scanner_.value(i).end) {
    all.push_back(scanner_.value(i));
    count_step();
  }
  return all;
}

/// A list may have millions of elements.
void CsgNodes::count_step() {
  constexpr std::uint32_t kStepsPerCheckpoint = std::uint32_t{1} << 16;
  if (++steps_ % kStepsPerCheckpoint == 0) context_.check_limits("read");
}

/// Appends `count` numbers of a vector. A single number is repeated. Missing numbers are replaced
/// by `otherwise`.
void CsgNodes::append_vector(const std::optional<CsgValue>& value, std::size_t count,
                             double otherwise) {
  std::vector<double> numbers(count, otherwise);
  if (value && value->kind == Kind::Number) {
    std::fill(numbers.begin(), numbers.end(), number_of(*value));
  } else if (value) {
    const std::vector<CsgValue> all = elements(*value);
    for (std::size_t i = 0; i < std::min(count, all.size()); ++i) numbers[i] = number_of(all[i]);
  }
  for (const double x : numbers) push(x);
}

std::uint32_t CsgNodes::index_of(const CsgValue& value, std::uint32_t count) {
  const double index = number_of(value);
  if (!(index >= 0 && index < count) || std::floor(index) != index) {
    scanner_.fail(ErrorCode::BadIndex,
                  "there is no point of this number; the points are numbered from 0 to " +
                      std::to_string(static_cast<std::int64_t>(count) - 1),
                  value.at);
  }
  return static_cast<std::uint32_t>(index);
}

void CsgNodes::push(double value) {
  count_step();
  if (tree_.numbers.size() == std::numeric_limits<std::uint32_t>::max()) {
    scanner_.fail(ErrorCode::ResourceLimit, "a model has at most 2^32 - 1 numbers");
  }
  memory_.add(sizeof(double), "a model");
  tree_.numbers.push_back(value);
}

void CsgNodes::push_index(std::size_t value) {
  count_step();
  if (tree_.indices.size() == std::numeric_limits<std::uint32_t>::max()) {
    scanner_.fail(ErrorCode::ResourceLimit, "a model has at most 2^32 - 1 indices");
  }
  memory_.add(sizeof(std::uint32_t), "a model");
  tree_.indices.push_back(static_cast<std::uint32_t>(value));
}

void CsgNodes::note_unknown() {
  const CsgWord& word = *word_of(scanner_.name());
  for (const CsgParameter& parameter : scanner_.parameters()) {
    const std::string padded = " " + std::string(parameter.name) + " ";
    if (parameter.name.empty() || word.parameters.find(padded) != std::string_view::npos) continue;
    const std::string note = "the parameter " + plumb::quoted(parameter.name) + " of " +
                             std::string(word.name) + " is passed over";
    add_note(note);
  }
}

void CsgNodes::add_note(const std::string& note) {
  const bool is_known = std::find(notes_.begin(), notes_.end(), note) != notes_.end();
  if (!is_known && notes_.size() < kMostNotes) notes_.push_back(note);
}

}  // namespace plumb
