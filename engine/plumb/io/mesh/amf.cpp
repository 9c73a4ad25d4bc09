// Reading of AMF: elements, and the texts that they contain.
//
// The reader keeps a stack of the elements that are open. What an element means follows from its
// name and the element that contains it (kAmfGrammar). All other elements are skipped with all that
// they contain, and named in a note. Numbers are texts between tags, so a number has the place of
// the tag that ends it.
//
// Objects and constellations have ids of their own, and files use the same number for both. Objects
// are in part 0 of the scene and constellations in part 1. An instance names an object, or, if
// there is none of this id, a constellation. That is known when the file ends, as are materials.
//
// A rotation turns about x, then about y, then about z, by degrees (ISO/ASTM 52915). Slic3r and the
// programs that descend from it write radians, and also factors of scales and of mirrors (-1
// mirrors), which are applied first. Tested by tests/io/amf_test.cpp.
#include "plumb/io/mesh/amf.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <map>
#include <numbers>
#include <optional>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "plumb/base/internal/round_to_nearest.h"
#include "plumb/io/mesh/attribute_builder.h"
#include "plumb/io/mesh/threemf_build.h"
#include "plumb/io/mesh/threemf_model.h"
#include "plumb/io/mesh/threemf_xml.h"
#include "plumb/io/text/input_cursors.h"
#include "plumb/model/transform.h"
#include "plumb/predicates/rounding.h"

namespace plumb {
namespace {

constexpr std::uint32_t kObjects = 0, kConstellations = 1;  // The parts of the scene.

enum class AmfElement : std::uint8_t {
  Outside,
  Root,
  Object,
  Material,
  Constellation,
  Instance,
  Mesh,
  Vertices,
  Vertex,
  Coordinates,
  Volume,
  Triangle,
  Number,  // A text that is a number: a coordinate, a corner, a part of a colour or of a placement.
  Metadata,
  Color,
  Curved,  // What makes triangles curved.
  Skipped,
};

struct AmfRule {
  AmfElement parent;
  std::string_view name;
  AmfElement element;
};

constexpr std::array kAmfGrammar{
    AmfRule{AmfElement::Vertices, "vertex", AmfElement::Vertex},
    AmfRule{AmfElement::Vertex, "coordinates", AmfElement::Coordinates},
    AmfRule{AmfElement::Coordinates, "x", AmfElement::Number},
    AmfRule{AmfElement::Coordinates, "y", AmfElement::Number},
    AmfRule{AmfElement::Coordinates, "z", AmfElement::Number},
    AmfRule{AmfElement::Volume, "triangle", AmfElement::Triangle},
    AmfRule{AmfElement::Triangle, "v1", AmfElement::Number},
    AmfRule{AmfElement::Triangle, "v2", AmfElement::Number},
    AmfRule{AmfElement::Triangle, "v3", AmfElement::Number},
    AmfRule{AmfElement::Outside, "amf", AmfElement::Root},
    AmfRule{AmfElement::Root, "object", AmfElement::Object},
    AmfRule{AmfElement::Root, "material", AmfElement::Material},
    AmfRule{AmfElement::Root, "constellation", AmfElement::Constellation},
    AmfRule{AmfElement::Constellation, "instance", AmfElement::Instance},
    AmfRule{AmfElement::Object, "mesh", AmfElement::Mesh},
    AmfRule{AmfElement::Mesh, "vertices", AmfElement::Vertices},
    AmfRule{AmfElement::Mesh, "volume", AmfElement::Volume},
    AmfRule{AmfElement::Vertex, "normal", AmfElement::Curved},
    AmfRule{AmfElement::Vertices, "edge", AmfElement::Curved},
    AmfRule{AmfElement::Root, "metadata", AmfElement::Metadata},
    AmfRule{AmfElement::Object, "metadata", AmfElement::Metadata},
    AmfRule{AmfElement::Volume, "metadata", AmfElement::Metadata},
    AmfRule{AmfElement::Material, "metadata", AmfElement::Metadata},
    AmfRule{AmfElement::Object, "color", AmfElement::Color},
    AmfRule{AmfElement::Volume, "color", AmfElement::Color},
    AmfRule{AmfElement::Triangle, "color", AmfElement::Color},
    AmfRule{AmfElement::Material, "color", AmfElement::Color},
    AmfRule{AmfElement::Color, "r", AmfElement::Number},
    AmfRule{AmfElement::Color, "g", AmfElement::Number},
    AmfRule{AmfElement::Color, "b", AmfElement::Number},
    AmfRule{AmfElement::Color, "a", AmfElement::Number},
};

struct AmfUnit {
  std::string_view name;
  std::int64_t numerator;
  std::int64_t denominator;
  const char* called;
};

constexpr std::array<AmfUnit, 8> kAmfUnits{{
    {"millimeter", 1, 1, "millimeter"},
    {"inch", 127, 5, "inch"},
    {"feet", 1524, 5, "foot"},
    {"foot", 1524, 5, "foot"},
    {"meter", 1000, 1, "meter"},
    {"centimeter", 10, 1, "centimeter"},
    {"micron", 1, 1000, "micron"},
    {"micrometer", 1, 1000, "micron"},
}};

/// The texts of an instance, in the order of kPlacementTexts.
constexpr std::array<std::string_view, 13> kPlacementTexts{
    "deltax", "deltay", "deltaz", "rx",      "ry",      "rz",     "scale",
    "scalex", "scaley", "scalez", "mirrorx", "mirrory", "mirrorz"};

std::string_view amf_trimmed(std::string_view text) {
  constexpr std::string_view kBlanks = " \t\r\n";
  text.remove_prefix(std::min(text.find_first_not_of(kBlanks), text.size()));
  return text.substr(0, text.find_last_not_of(kBlanks) + 1);
}

std::optional<std::uint32_t> amf_whole_number(std::string_view text) {
  text = amf_trimmed(text);
  std::uint32_t value = 0;
  const char* const last = text.data() + text.size();
  const auto [end, code] = std::from_chars(text.data(), last, value);
  return code == std::errc() && end == last && !text.empty() ? std::optional(value) : std::nullopt;
}

/// Returns an angle in degrees. Programs write nine digits of radians, so a right angle is exact if
/// the digits are those of its multiple of pi / 2.
double degrees_of_radians(double angle) {
  constexpr double kRightAngle = std::numbers::pi / 2, kDigits = 1e-8;
  const double turns = angle / kRightAngle, whole = std::round(turns);
  return std::fabs(turns - whole) < kDigits * std::max(1.0, std::fabs(whole)) ? 90 * whole
                                                                              : 90 * turns;
}

class AmfReader : public XmlListener {
 public:
  AmfReader(const ReadOptions& options, const std::string& entry, std::size_t bytes,
            ThreeMfScene& scene, Context& context)
      : scene_(scene),
        stream_(entry.empty() ? options.name : threemf_text_name(options.name, entry), *this),
        numbers_(context, options.exact_decimals, bytes),
        context_(context) {
    scene_.part_of(entry);
    scene_.part_of(entry + "#");  // The constellations; no name of an entry ends with this.
    scene_.parts[kConstellations].name = entry;
    scene_.parts[kConstellations].unit_name.clear();  // One note is enough.
  }

  void feed(std::string_view block) { stream_.feed(block); }
  void finish() {
    stream_.finish();
    find_objects_of_instances();
    paint_materials();
    add_items();
  }

  void start(const XmlTag& tag) override;
  void end() override;
  void text(std::string_view part) override {
    constexpr std::size_t kMostText = std::size_t{1} << 20U;
    const AmfElement element = top();
    if (skipped_depth_ > 0) return;
    if (element != AmfElement::Number && element != AmfElement::Metadata) return;
    // The metadata of a file may be all settings of a program, which are passed over.
    if (element == AmfElement::Metadata) part = part.substr(0, kMostText - text_.size());
    if (text_.size() + part.size() > kMostText)
      fail(ErrorCode::ResourceLimit, "a text of more than 1 MiB");
    text_ += part;
  }

 private:
  using Color = std::array<double, 4>;
  /// The triangles of a volume without a colour. They have the look of its material, or else that
  /// of the object, each of which the file may state later.
  struct UnpaintedVolume {
    std::size_t first, end;
    std::optional<std::uint32_t> material;
    std::optional<std::uint32_t> entry_of_object;
  };

  AmfElement top() const { return open_.empty() ? AmfElement::Outside : open_.back(); }
  AmfElement element_of(const XmlTag& tag) const {
    const AmfElement parent = top();
    if (parent == AmfElement::Instance) return AmfElement::Number;
    for (const AmfRule& rule : kAmfGrammar) {
      if (rule.parent == parent && rule.name == tag.name) return rule.element;
    }
    return AmfElement::Skipped;
  }

  void skip(const XmlTag& tag);
  void start_root(const XmlTag& tag);
  void start_object(const XmlTag& tag, std::uint32_t part);
  void start_instance(const XmlTag& tag);
  void start_volume(const XmlTag& tag);
  void end_number();
  void end_vertex();
  void end_triangle();
  void end_volume();
  void end_object_color();
  void end_instance();
  void end_metadata();
  void end_color();
  std::optional<std::uint32_t> entry_of(const Color& color);
  void paint(std::size_t face, std::uint32_t entry);
  void find_objects_of_instances();
  void paint_materials();
  void add_items();

  std::uint32_t id_of(const XmlTag& tag, const char* name) const {
    const auto id = amf_whole_number(tag.attribute(name).value_or(""));
    if (!id) fail(ErrorCode::Syntax, std::string(tag.name) + " needs a whole number " + name);
    return *id;
  }
  void read_number(std::string_view text, std::string_view name, ReadNumber& number);
  ThreeMfObject& object() { return scene_.objects.back(); }
  [[noreturn]] void fail(ErrorCode code, const std::string& message) const {
    stream_.fail(code, message);
  }

  ThreeMfScene& scene_;
  XmlStream stream_;
  NumberReader numbers_;
  Context& context_;
  std::vector<AmfElement> open_;
  std::size_t skipped_depth_ = 0;  // Open elements that are skipped.
  std::string text_;
  std::string name_;  // Of the number or the metadata that is open.
  std::array<std::optional<ReadNumber>, 3> coordinates_;
  std::array<std::optional<std::uint32_t>, 3> corners_;
  std::array<ReadNumber, kPlacementTexts.size()> placement_;
  std::uint32_t placement_texts_ = 0;  // Which of them are given, as bits.
  std::optional<Color> color_, object_color_, volume_color_, triangle_color_;
  std::uint32_t mesh_begin_ = 0;  // The first point of the mesh.
  std::size_t volume_begin_ = 0;  // The first triangle of the volume.
  std::optional<std::uint32_t> volume_material_, material_;
  bool is_volume_left_out_ = false;
  std::map<std::uint32_t, std::uint32_t> entry_of_material_;
  std::map<Color, std::uint32_t> entry_of_color_;
  std::vector<UnpaintedVolume> unpainted_;
  std::size_t unpainted_before_ = 0;  // Those of the objects before the one that is open.
  bool is_of_slic3r_ = false;         // Whether rotations are in radians.
};

// ---------------------------------------------------------------- elements

void AmfReader::start(const XmlTag& tag) {
  if (skipped_depth_ > 0) {
    ++skipped_depth_;
    return;
  }
  const AmfElement element = element_of(tag);
  if (element == AmfElement::Skipped || element == AmfElement::Curved) return skip(tag);
  open_.push_back(element);
  switch (element) {
    case AmfElement::Root:
      return start_root(tag);
    case AmfElement::Object:
      object_color_.reset();
      unpainted_before_ = unpainted_.size();
      return start_object(tag, kObjects);
    case AmfElement::Constellation:
      return start_object(tag, kConstellations);
    case AmfElement::Instance:
      return start_instance(tag);
    case AmfElement::Material:
      material_ = id_of(tag, "id");
      return;
    case AmfElement::Mesh:
      mesh_begin_ = scene_.source.point_count();
      return;
    case AmfElement::Vertex:
      coordinates_ = {};
      return;
    case AmfElement::Volume:
      return start_volume(tag);
    case AmfElement::Triangle:
      corners_ = {};
      triangle_color_.reset();
      return;
    case AmfElement::Color:
      color_ = Color{0, 0, 0, 1};
      return;
    case AmfElement::Number:
      text_.clear();
      name_ = tag.name;
      return;
    case AmfElement::Metadata:
      text_.clear();
      name_ = tag.attribute("type").value_or("");
      return;
    default:
      return;
  }
}

void AmfReader::end() {
  if (skipped_depth_ > 0) {
    --skipped_depth_;
    return;
  }
  const AmfElement element = top();
  open_.pop_back();
  switch (element) {
    case AmfElement::Number:
      return end_number();
    case AmfElement::Vertex:
      return end_vertex();
    case AmfElement::Triangle:
      return end_triangle();
    case AmfElement::Volume:
      return end_volume();
    case AmfElement::Instance:
      return end_instance();
    case AmfElement::Metadata:
      return end_metadata();
    case AmfElement::Color:
      return end_color();
    case AmfElement::Object:
      end_object_color();
      [[fallthrough]];
    case AmfElement::Constellation:
      object().end_point = scene_.source.point_count();
      object().end_face = static_cast<std::uint32_t>(scene_.source.face_count());
      object().end_component = static_cast<std::uint32_t>(scene_.components.size());
      return;
    default:
      return;
  }
}

/// Skips an element that the grammar does not have. The root must be an `amf`.
void AmfReader::skip(const XmlTag& tag) {
  if (open_.empty()) {
    fail(ErrorCode::UnknownFormat, "the root element is " + quoted(tag.name) + ", not an amf");
  }
  skipped_depth_ = 1;
  if (element_of(tag) == AmfElement::Curved) {
    scene_.left_out.insert("the curvature of triangles, which are read as flat");
  } else if (tag.name == "metadata") {
    scene_.passed.insert("metadata");
  } else if (tag.name == "color") {
    scene_.passed.insert("colours of vertices");
  } else if (tag.name == "texture" || tag.name == "texmap" || tag.name == "map") {
    scene_.passed.insert("textures");
  } else if (tag.name == "composite") {
    scene_.passed.insert("mixed materials");
  } else {
    constexpr std::size_t kMostNamed = 16;
    if (scene_.passed.size() < kMostNamed) scene_.passed.insert("elements " + quoted(tag.name));
  }
}

void AmfReader::start_root(const XmlTag& tag) {
  const std::string_view unit = tag.attribute("unit").value_or("millimeter");
  const auto* const known = std::find_if(kAmfUnits.begin(), kAmfUnits.end(),
                                         [&](const AmfUnit& each) { return each.name == unit; });
  if (known == kAmfUnits.end()) {
    fail(ErrorCode::Syntax, "the unit is " + quoted(unit) +
                                ", which is none of millimeter, inch, feet, meter and micron");
  }
  for (ThreeMfPart& part : scene_.parts)
    part.unit = Rational(known->numerator) / known->denominator;
  scene_.parts[kObjects].unit_name = known->called;
}

void AmfReader::start_object(const XmlTag& tag, std::uint32_t part) {
  constexpr std::uint64_t kObjectBytes = 256;  // The object, twice, and its entry in the map.
  scene_.charge.add(kObjectBytes, "the objects of the file");
  ThreeMfObject object;
  object.part = part;
  object.id = id_of(tag, "id");
  object.first_point = object.end_point = scene_.source.point_count();
  object.first_face = object.end_face = static_cast<std::uint32_t>(scene_.source.face_count());
  object.first_component = object.end_component =
      static_cast<std::uint32_t>(scene_.components.size());
  const auto number = static_cast<std::uint32_t>(scene_.objects.size());
  if (!scene_.object_of.emplace(std::pair(part, object.id), number).second) {
    fail(ErrorCode::BadShape,
         std::string(part == kObjects ? "a second object" : "a second constellation") +
             " with the id " + std::to_string(object.id));
  }
  scene_.objects.push_back(object);
}

// ---------------------------------------------------------------- meshes

/// Reads a number. Its place is that of the tag that ends it.
void AmfReader::read_number(std::string_view text, std::string_view name, ReadNumber& number) {
  text = amf_trimmed(text);
  bool is_whole = false;
  try {
    TextCursor cursor(text, {});
    if (cursor.next_line()) {
      numbers_.read_next(cursor, number);
      is_whole = cursor.at_line_end();
    }
  } catch (const Error& error) {
    fail(error.code(), std::string(name) + ": " + error.message());
  }
  if (!is_whole) fail(ErrorCode::Syntax, std::string(name) + " is " + quoted(text) + ", no number");
}

void AmfReader::end_number() {
  const AmfElement parent = top();
  if (parent == AmfElement::Coordinates) {
    ReadNumber& number = coordinates_[static_cast<std::size_t>(name_[0] - 'x')].emplace();
    return read_number(text_, name_, number);
  }
  if (parent == AmfElement::Triangle) {
    const auto corner = amf_whole_number(text_);
    if (!corner)
      fail(ErrorCode::Syntax, name_ + " is " + quoted(amf_trimmed(text_)) + ", not a whole number");
    corners_[static_cast<std::size_t>(name_[1] - '1')] = corner;
    return;
  }
  if (parent == AmfElement::Color) {
    const AttributeNumber part = attribute_number(amf_trimmed(text_));
    constexpr std::string_view kParts = "rgba";
    if (!part.is_finite) return color_.reset();  // A formula, perhaps.
    if (color_) (*color_)[kParts.find(name_[0])] = std::clamp(part.value, 0.0, 1.0);
    return;
  }
  const auto* const known = std::find(kPlacementTexts.begin(), kPlacementTexts.end(), name_);
  if (known == kPlacementTexts.end()) {
    scene_.passed.insert("other settings of instances");
    return;
  }
  const auto index = static_cast<std::size_t>(known - kPlacementTexts.begin());
  read_number(text_, name_, placement_[index]);
  placement_texts_ |= 1U << index;
}

void AmfReader::end_vertex() {
  for (const auto& coordinate : coordinates_) {
    if (!coordinate) fail(ErrorCode::Syntax, "a vertex lacks one of x, y and z");
  }
  scene_.source.add_point(*coordinates_[0], *coordinates_[1], *coordinates_[2]);
}

void AmfReader::start_volume(const XmlTag& tag) {
  volume_begin_ = scene_.source.face_count();
  volume_material_ = amf_whole_number(tag.attribute("materialid").value_or(""));
  volume_color_.reset();
  is_volume_left_out_ = tag.attribute("type") == std::string_view("support");
  if (is_volume_left_out_) scene_.left_out.insert("support volumes");
}

void AmfReader::end_triangle() {
  const std::uint32_t first = mesh_begin_;
  const std::uint32_t count = scene_.source.point_count() - first;
  for (std::size_t i = 0; i < corners_.size(); ++i) {
    const std::string name = "v" + std::to_string(i + 1);
    if (!corners_[i]) fail(ErrorCode::Syntax, "a triangle lacks " + name);
    if (*corners_[i] >= count) {
      fail(ErrorCode::BadIndex, name + " is vertex " + std::to_string(*corners_[i]) +
                                    "; the mesh has " + std::to_string(count) +
                                    (count == 1 ? " vertex" : " vertices"));
    }
  }
  if (is_volume_left_out_) return;
  for (const auto& corner : corners_) scene_.source.add_corner(first + *corner);
  scene_.source.end_face();
  if (!triangle_color_) return;
  if (const auto entry = entry_of(*triangle_color_)) paint(scene_.source.face_count() - 1, *entry);
}

/// Gives the triangles of the volume that have no colour that of the volume.
void AmfReader::end_volume() {
  const std::size_t end = scene_.source.face_count();
  if (!scene_.looks.is_kept) {
    if (volume_material_) scene_.passed.insert("materials and colours");
    return;
  }
  if (!volume_color_) {
    scene_.charge.add(2 * sizeof(UnpaintedVolume), "the materials of the file");
    unpainted_.push_back({volume_begin_, end, volume_material_, {}});
    return;
  }
  const auto entry = entry_of(*volume_color_);
  for (std::size_t f = volume_begin_; entry && f < end; ++f) paint(f, *entry);
}

/// Notes the colour of the object for its volumes. It may stand behind the mesh.
void AmfReader::end_object_color() {
  if (!object_color_) return;
  const auto entry = entry_of(*object_color_);
  for (std::size_t i = unpainted_before_; i < unpainted_.size(); ++i) {
    unpainted_[i].entry_of_object = entry;
  }
}

/// Reads the kind of a volume that Slic3r and PrusaSlicer state, and names of objects and
/// materials.
void AmfReader::end_metadata() {
  const std::string_view value = amf_trimmed(text_);
  const AmfElement owner = top();
  if (owner == AmfElement::Root) {
    const bool is_known = value.starts_with("Slic3r") || value.starts_with("PrusaSlicer") ||
                          value.starts_with("SuperSlicer");
    is_of_slic3r_ =
        is_of_slic3r_ || (name_ == "cad" && is_known) || name_ == "slic3rpe_amf_version";
    scene_.passed.insert("metadata");
    return;
  }
  if (owner == AmfElement::Volume) {
    constexpr std::array<std::pair<std::string_view, std::string_view>, 5> kKinds{{
        {"ParameterModifier", "modifier volumes"},
        {"SupportModifier", "support volumes"},
        {"SupportEnforcer", "support enforcers"},
        {"SupportBlocker", "support blockers"},
        {"NegativeVolume", "negative volumes"},
    }};
    const auto* const kind = std::find_if(kKinds.begin(), kKinds.end(),
                                          [&](const auto& each) { return each.first == value; });
    const bool is_modifier = name_ == "slic3r.modifier" && value == "1";
    if (is_modifier || (name_ == "slic3r.volume_type" && kind != kKinds.end())) {
      const bool is_late = scene_.source.face_count() > volume_begin_;
      is_volume_left_out_ = true;
      scene_.left_out.emplace(is_late       ? "the rest of volumes that their settings leave out"
                              : is_modifier ? "modifier volumes"
                                            : kind->second);
      return;
    }
  }
  const bool is_name = name_ == "name" || name_ == "Name";
  if (!is_name || !scene_.looks.is_kept || value.empty()) {
    scene_.passed.insert("metadata");
    return;
  }
  if (owner == AmfElement::Object) {
    scene_.charge.add(2 * sizeof(std::string) + 2 * value.size(), "the names of the file");
    scene_.looks.names.emplace_back(value);
    object().name = static_cast<std::uint32_t>(scene_.looks.names.size() - 1);
  } else if (owner == AmfElement::Material && material_) {
    const auto [known, is_new] = entry_of_material_.try_emplace(
        *material_, static_cast<std::uint32_t>(scene_.looks.entries.size()));
    if (is_new) scene_.looks.entries.emplace_back();
    scene_.charge.add(2 * sizeof(ThreeMfEntry) + 2 * value.size(), "the materials of the file");
    scene_.looks.entries[known->second].name = value;
  } else {
    scene_.passed.insert("names of volumes");
  }
}

// ---------------------------------------------------------------- looks

void AmfReader::end_color() {
  if (!scene_.looks.is_kept || !color_) {
    scene_.passed.insert(color_ ? "materials and colours" : "colours that are no numbers");
    return;
  }
  switch (top()) {
    case AmfElement::Object:
      object_color_ = color_;
      return;
    case AmfElement::Volume:
      volume_color_ = color_;
      return;
    case AmfElement::Triangle:
      triangle_color_ = color_;
      return;
    default:
      break;
  }
  const auto [known, is_new] = entry_of_material_.try_emplace(
      *material_, static_cast<std::uint32_t>(scene_.looks.entries.size()));
  if (is_new) {
    scene_.charge.add(2 * sizeof(ThreeMfEntry), "the materials of the file");
    scene_.looks.entries.emplace_back();
  }
  scene_.looks.entries[known->second].color = color_;
}

std::optional<std::uint32_t> AmfReader::entry_of(const Color& color) {
  if (!scene_.looks.is_kept) return {};
  const auto [known, is_new] =
      entry_of_color_.try_emplace(color, static_cast<std::uint32_t>(scene_.looks.entries.size()));
  if (is_new) {
    scene_.charge.add(4 * sizeof(ThreeMfEntry), "the materials of the file");
    scene_.looks.entries.push_back({{}, color});
  }
  return known->second;
}

/// Gives a triangle a look, unless it has one.
void AmfReader::paint(std::size_t face, std::uint32_t entry) {
  std::vector<ThreeMfLook>& looks = scene_.looks.faces;
  if (face >= looks.capacity()) {
    scene_.charge.add((2 * face + 64) * sizeof(ThreeMfLook), "the materials of the file");
    looks.reserve(2 * face + 64);
  }
  if (face >= looks.size()) looks.resize(face + 1);
  if (looks[face].entry[0] == ThreeMfLook::kNone) looks[face].entry.fill(entry);
}

/// Materials may come after the objects. Each triangle is in one range at most.
void AmfReader::paint_materials() {
  for (const UnpaintedVolume& volume : unpainted_) {
    std::optional<std::uint32_t> entry = volume.entry_of_object;
    if (volume.material) {
      const auto known = entry_of_material_.find(*volume.material);
      if (known != entry_of_material_.end()) {
        entry = known->second;
      } else if (*volume.material != 0) {
        scene_.passed.insert("references to materials that are not read");
      }
    }
    context_.check_limits("read");
    for (std::size_t f = volume.first; entry && f < volume.end; ++f) paint(f, *entry);
  }
}

// ---------------------------------------------------------------- constellations

void AmfReader::start_instance(const XmlTag& tag) {
  scene_.charge.add(2 * sizeof(ThreeMfPlacement), "the components of the file");
  const TextPlace here = stream_.place();
  ThreeMfPlacement placement;
  placement.stated_in = kConstellations;
  placement.object = id_of(tag, "objectid");
  placement.line = static_cast<std::uint32_t>(here.line);
  placement.column = static_cast<std::uint32_t>(here.column);
  scene_.components.push_back(placement);
  placement_texts_ = 0;
}

/// Sets the transform of the last instance: scales, then rotations about x, y and z, then a move.
void AmfReader::end_instance() {
  if (placement_texts_ == 0) return;
  const auto is_given = [&](std::size_t i) { return (placement_texts_ >> i & 1U) != 0; };
  const auto value = [&](std::size_t i) {
    return is_given(i) ? placement_[i].exact() : Rational(0);
  };
  AffineMap3 map = scaling({1, 1, 1});
  for (std::size_t axis = 0; axis < 3; ++axis) {
    Rational& factor = map.matrix[axis][axis];
    if (is_given(6)) factor *= value(6);
    if (is_given(7 + axis)) factor *= value(7 + axis);
    if (value(10 + axis) < 0) factor = -factor;
  }
  if (determinant(map) == 0) fail(ErrorCode::BadShape, "a scale of 0 makes the object flat");
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (!is_given(3 + axis)) continue;
    std::array<double, 3> direction{0, 0, 0};
    direction[axis] = 1;
    const double angle = nearest_double(value(3 + axis));
    map = composed(rotation(direction, is_of_slic3r_ ? degrees_of_radians(angle) : angle), map);
  }
  ThreeMfTransform m;
  for (std::size_t row = 0; row < 3; ++row) {
    for (std::size_t column = 0; column < 3; ++column)
      m[3 * column + row] = map.matrix[row][column];
    m[9 + row] = value(row);
  }
  constexpr std::uint64_t kTransformBytes = sizeof m + 12 * 256;
  scene_.charge.add(kTransformBytes + 64 * text_.size(), "the transforms");
  scene_.components.back().transform = static_cast<std::uint32_t>(scene_.transforms.size());
  scene_.transforms.push_back(std::move(m));
}

void AmfReader::find_objects_of_instances() {
  context_.check_limits("read");
  for (ThreeMfPlacement& placement : scene_.components) {
    if (scene_.object_of.contains({kObjects, placement.object})) continue;
    placement.part = kConstellations;
    if (scene_.object_of.contains({kConstellations, placement.object})) continue;
    throw Error(ErrorCode::BadIndex, "there is no object " + std::to_string(placement.object),
                {stream_.place().file, placement.line, placement.column});
  }
}

/// Adds an item for each object and constellation that no constellation places.
void AmfReader::add_items() {
  std::vector<std::uint8_t> is_placed(scene_.objects.size());
  for (const ThreeMfPlacement& placement : scene_.components) {
    is_placed[scene_.object_of.at({placement.part, placement.object})] = 1;
  }
  std::vector<std::size_t> stack;
  for (std::size_t i = 0; i < scene_.objects.size(); ++i) {
    if (is_placed[i] != 0) continue;
    ThreeMfPlacement item;
    item.part = scene_.objects[i].part;
    item.object = scene_.objects[i].id;
    scene_.charge.add(2 * sizeof item, "the components of the file");
    scene_.items.push_back(item);
    stack.push_back(i);
  }
  // Constellations that contain each other, and that nothing else places, would be lost.
  std::size_t reached = stack.size();
  while (!stack.empty()) {
    context_.check_limits("read");
    const ThreeMfObject& object = scene_.objects[stack.back()];
    stack.pop_back();
    for (std::uint32_t c = object.first_component; c < object.end_component; ++c) {
      const ThreeMfPlacement& placement = scene_.components[c];
      const std::uint32_t next = scene_.object_of.at({placement.part, placement.object});
      if (std::exchange(is_placed[next], std::uint8_t{0}) == 0) continue;
      ++reached;
      stack.push_back(next);
    }
  }
  if (reached == scene_.objects.size()) return;
  const auto lost = std::find(is_placed.begin(), is_placed.end(), 1) - is_placed.begin();
  throw Error(ErrorCode::BadShape,
              "constellation " + std::to_string(scene_.objects[static_cast<std::size_t>(lost)].id) +
                  " contains itself, or is placed by one that does",
              {stream_.place().file});
}

/// Returns the entry of an archive that is the AMF file: the first one with this extension, or the
/// only one.
std::uint64_t amf_entry(const ZipArchive& archive, std::string& name) {
  const std::vector<std::string> names = archive.names();
  for (const std::string& each : names) {
    if (!each.ends_with(".amf") && !each.ends_with(".AMF") && names.size() != 1) continue;
    name = each;
    if (const auto entry = archive.find(each)) return *entry;
  }
  throw Error(ErrorCode::UnknownFormat, "the ZIP archive has no AMF file");
}

MeshFile read_amf_scene(std::string_view bytes, const ReadOptions& options, Context& context) {
  ThreeMfScene scene(context);
  scene.looks.is_kept = options.attributes;
  if (bytes.starts_with("PK\x03\x04")) {
    ZipArchive archive(bytes, context);
    std::string name;
    const std::uint64_t entry = amf_entry(archive, name);
    AmfReader reader(options, name, bytes.size(), scene, context);
    archive.read(entry, [&](std::string_view block) { reader.feed(block); });
    reader.finish();
  } else {
    AmfReader reader(options, {}, bytes.size(), scene, context);
    constexpr std::size_t kBlock = std::size_t{1} << 16U;
    for (std::size_t at = 0; at < bytes.size(); at += kBlock) {
      context.checkpoint("read", at, bytes.size());
      reader.feed(bytes.substr(at, kBlock));
    }
    reader.finish();
  }
  MeshFile file = build_threemf(scene, {}, options.name, context);
  scene.source.clear();
  return file;
}

}  // namespace

bool begins_like_amf(std::string_view bytes) {
  constexpr std::size_t kMostSearched = 4096;
  bytes = bytes.substr(0, kMostSearched);
  take_prefix(bytes, "\xEF\xBB\xBF");
  const std::size_t root = bytes.find("<amf");
  const bool is_xml = amf_trimmed(bytes).starts_with('<');
  return is_xml && root != bytes.npos && root + 4 < bytes.size() &&
         std::string_view(" \t\r\n>").find(bytes[root + 4]) != std::string_view::npos;
}

MeshFile read_amf(std::string_view bytes, const ReadOptions& options, Context& context) {
  const RoundToNearest rounding;
  if (!has_threemf()) {
    throw Error(ErrorCode::UnknownFormat,
                "AMF needs libzip and expat; install libzip-dev and libexpat1-dev and build plumb "
                "again",
                {options.name});
  }
  try {
    return read_amf_scene(bytes, options, context);
  } catch (const Error& error) {
    if (!error.place().file.empty() || error.code() == ErrorCode::Cancelled) throw;
    throw Error(error.code(), error.message(), {options.name});
  }
}

}  // namespace plumb
