// Reading of the model parts of 3MF: elements and their attributes.
//
// The reader keeps a stack of the elements that are open. What an element means follows from its
// name and the element that contains it (kGrammar). An element that is not in the grammar is
// skipped with all that it contains, and named in a note or, if it is geometry, in a warning.
//
// Objects are looked up when the scene is built, because a component may refer to another part.
// That step also finds cycles.
//
// Format: 3MF Consortium, 3D Manufacturing Format, Core Specification 1.3, and the extensions
// Production, Materials and Properties; docs/formats.md, section 3MF.
// Tested by tests/io/threemf_test.cpp.
#include "plumb/io/mesh/threemf_model.h"

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <optional>
#include <system_error>

#include "plumb/io/mesh/threemf_xml.h"
#include "plumb/io/text/input_cursors.h"
#include "plumb/predicates/sign.h"

namespace plumb {
namespace {

constexpr std::string_view kCore = "http://schemas.microsoft.com/3dmanufacturing/core/2015/02";
constexpr std::string_view kProduction =
    "http://schemas.microsoft.com/3dmanufacturing/production/2015/06";
constexpr std::string_view kMaterials =
    "http://schemas.microsoft.com/3dmanufacturing/material/2015/02";
constexpr std::string_view kTriangleSets =
    "http://schemas.microsoft.com/3dmanufacturing/trianglesets/2021/07";
constexpr std::string_view kTriangleSets2 =
    "http://schemas.3mf.io/3dmanufacturing/trianglesets/2021/07";
constexpr std::string_view kSlic3r = "http://schemas.slic3r.org/3mf/2017/06";

/// The extensions that a file may require, because they are read or do not change the shape.
constexpr std::array<std::string_view, 5> kUnderstood{kCore, kProduction, kMaterials, kTriangleSets,
                                                      kTriangleSets2};

enum class ModelElement : std::uint8_t {
  Outside,
  Model,
  Resources,
  Object,
  Mesh,
  Vertices,
  Vertex,
  Triangles,
  Triangle,
  Components,
  Component,
  Build,
  Item,
  Settings,
  Setting,
  BaseMaterials,
  Base,
  ColorGroup,
  Color,
  TriangleSets,
  TriangleSet,
  SetTriangle,
  SetRange,
  Passed,
};

struct GrammarRule {
  ModelElement parent;
  std::string_view name;
  ModelElement element;
};

constexpr std::array<GrammarRule, 15> kGrammar{{
    {ModelElement::Vertices, "vertex", ModelElement::Vertex},
    {ModelElement::Triangles, "triangle", ModelElement::Triangle},
    {ModelElement::Outside, "model", ModelElement::Model},
    {ModelElement::Model, "resources", ModelElement::Resources},
    {ModelElement::Model, "build", ModelElement::Build},
    {ModelElement::Resources, "object", ModelElement::Object},
    {ModelElement::Object, "mesh", ModelElement::Mesh},
    {ModelElement::Object, "components", ModelElement::Components},
    {ModelElement::Object, "metadatagroup", ModelElement::Settings},
    {ModelElement::Mesh, "vertices", ModelElement::Vertices},
    {ModelElement::Mesh, "triangles", ModelElement::Triangles},
    {ModelElement::Components, "component", ModelElement::Component},
    {ModelElement::Build, "item", ModelElement::Item},
    {ModelElement::Item, "metadatagroup", ModelElement::Settings},
    {ModelElement::Settings, "metadata", ModelElement::Setting},
}};

/// The elements that state looks. They are skipped if attributes are not kept.
struct LookRule {
  ModelElement parent;
  std::string_view space;
  std::string_view name;
  ModelElement element;
};

constexpr std::array<LookRule, 12> kLookGrammar{{
    {ModelElement::Resources, kCore, "basematerials", ModelElement::BaseMaterials},
    {ModelElement::BaseMaterials, kCore, "base", ModelElement::Base},
    {ModelElement::Resources, kMaterials, "colorgroup", ModelElement::ColorGroup},
    {ModelElement::ColorGroup, kMaterials, "color", ModelElement::Color},
    {ModelElement::Mesh, kTriangleSets, "trianglesets", ModelElement::TriangleSets},
    {ModelElement::TriangleSets, kTriangleSets, "triangleset", ModelElement::TriangleSet},
    {ModelElement::TriangleSet, kTriangleSets, "ref", ModelElement::SetTriangle},
    {ModelElement::TriangleSet, kTriangleSets, "refrange", ModelElement::SetRange},
    {ModelElement::Mesh, kTriangleSets2, "trianglesets", ModelElement::TriangleSets},
    {ModelElement::TriangleSets, kTriangleSets2, "triangleset", ModelElement::TriangleSet},
    {ModelElement::TriangleSet, kTriangleSets2, "ref", ModelElement::SetTriangle},
    {ModelElement::TriangleSet, kTriangleSets2, "refrange", ModelElement::SetRange},
}};

/// The elements that are not read, and their names in a note or a warning.
struct SkippedElement {
  std::string_view name;
  std::string_view called;
  bool is_geometry = false;
};

constexpr std::array<SkippedElement, 17> kSkippedElements{{
    {"metadata", "metadata"},
    {"metadatagroup", "metadata"},
    {"basematerials", "materials and colours"},
    {"colorgroup", "materials and colours"},
    {"texture2d", "textures"},
    {"texture2dgroup", "textures"},
    {"compositematerials", "materials and colours"},
    {"multiproperties", "materials and colours"},
    {"pbspecular", "materials and colours"},
    {"pbmetallic", "materials and colours"},
    {"trianglesets", "sets of triangles"},
    {"slicestack", "slices"},
    {"beamlattice", "beam lattices", true},
    {"booleanshape", "Booleans of objects", true},
    {"displacementmesh", "displaced meshes", true},
    {"levelset", "level sets", true},
    {"implicitfunction", "implicit functions", true},
}};

/// The settings of Cura that exclude an object from the model.
constexpr std::array<std::pair<std::string_view, std::string_view>, 4> kCuraMeshes{{
    {"support_mesh", "support volumes"},
    {"anti_overhang_mesh", "support blockers"},
    {"infill_mesh", "modifier volumes"},
    {"cutting_mesh", "modifier volumes"},
}};

struct NamedUnit {
  std::string_view name;
  std::int64_t numerator;
  std::int64_t denominator;
};

constexpr std::array<NamedUnit, 6> kUnits{{
    {"micron", 1, 1000},
    {"millimeter", 1, 1},
    {"centimeter", 10, 1},
    {"inch", 127, 5},
    {"foot", 1524, 5},
    {"meter", 1000, 1},
}};

/// Returns the next word of a list with blanks, and removes it. At the end, the word is empty.
std::string_view take_word(std::string_view& list) {
  constexpr std::string_view kBlanks = " \t\r\n";
  list.remove_prefix(std::min(list.find_first_not_of(kBlanks), list.size()));
  const std::string_view word = list.substr(0, list.find_first_of(kBlanks));
  list.remove_prefix(word.size());
  return word;
}

class ModelReader3mf : public XmlListener {
 public:
  ModelReader3mf(std::uint32_t part, const ReadOptions& options, std::size_t archive_bytes,
                 ThreeMfScene& scene, Context& context)
      : part_(part),
        scene_(scene),
        stream_(threemf_text_name(options.name, scene.parts[part].name), *this),
        numbers_(context, options.exact_decimals, archive_bytes) {}

  void read(ZipArchive& archive, std::uint64_t entry) {
    archive.read(entry, [this](std::string_view block) { stream_.feed(block); });
    stream_.finish();
  }
  [[nodiscard]] TextPlace place() const { return stream_.place(); }

  void start(const XmlTag& tag) override;
  void end() override;
  void text(std::string_view part) override {
    constexpr std::size_t kMostSetting = 64;
    if (top() == ModelElement::Setting && setting_.size() < kMostSetting) setting_ += part;
  }
  void declare(std::string_view prefix, std::string_view space) override {
    if (has_root_) return;
    if (spaces_.size() < kMostSpaces) spaces_.emplace(prefix, space);
  }

 private:
  static constexpr std::size_t kMostSpaces = 256;

  ModelElement top() const { return open_.empty() ? ModelElement::Outside : open_.back(); }
  ModelElement element_of(const XmlTag& tag) const;
  void skip(const XmlTag& tag);

  void start_model(const XmlTag& tag);
  void require_extensions(const XmlTag& tag) const;
  void start_object(const XmlTag& tag);
  void end_object();
  void add_vertex(const XmlTag& tag);
  void add_triangle(const XmlTag& tag);
  void add_component(const XmlTag& tag);
  void add_item(const XmlTag& tag);
  void end_setting();

  void start_group(const XmlTag& tag);
  void add_entry(const XmlTag& tag, const char* color);
  std::uint32_t name_of(const XmlTag& tag);
  void add_to_set(const XmlTag& tag, const char* first, const char* last);
  void add_look(const XmlTag& tag);
  ThreeMfLook& look_of(std::size_t face);
  std::optional<std::uint32_t> entry_of(std::uint32_t group, std::uint32_t index) const;
  std::optional<std::uint32_t> look_number(const XmlTag& tag, const char* name);
  void pass_over(const char* what) { scene_.passed.insert(what); }

  ThreeMfPlacement placement_of(const XmlTag& tag);
  std::uint32_t transform_of(std::string_view text);
  std::uint32_t whole_number(const XmlTag& tag, const char* name);
  void read_number(std::string_view text, const char* name, ReadNumber& number);
  std::string_view required(const XmlTag& tag, const char* name) const;
  ThreeMfObject& object() { return scene_.objects.back(); }
  [[noreturn]] void fail(ErrorCode code, const std::string& message) const {
    stream_.fail(code, message);
  }

  std::uint32_t part_;
  ThreeMfScene& scene_;
  XmlStream stream_;
  NumberReader numbers_;
  std::vector<ModelElement> open_;
  std::size_t skipped_depth_ = 0;  // The number of open elements that are skipped.
  bool has_root_ = false;
  std::map<std::string, std::string, std::less<>> spaces_;  // The prefixes at the root.
  std::string setting_name_;
  std::string setting_;
  ThreeMfGroup* group_ = nullptr;                // The group that is open.
  std::uint32_t set_name_ = ThreeMfLook::kNone;  // The name of the open set of triangles.
  std::size_t set_steps_ = 0;                    // The sum of the sizes of the object's sets.
  std::optional<std::uint32_t> object_group_, object_entry_;  // The defaults of triangles.
  ReadNumber x_, y_, z_;
};

// ---------------------------------------------------------------- elements

ModelElement ModelReader3mf::element_of(const XmlTag& tag) const {
  const ModelElement parent = top();
  if (tag.space == kCore) {
    for (const GrammarRule& rule : kGrammar) {
      if (rule.parent == parent && rule.name == tag.name) return rule.element;
    }
  }
  if (!scene_.looks.is_kept) return ModelElement::Passed;
  for (const LookRule& rule : kLookGrammar) {
    if (rule.parent == parent && rule.name == tag.name && rule.space == tag.space) {
      return rule.element;
    }
  }
  return ModelElement::Passed;
}

void ModelReader3mf::start(const XmlTag& tag) {
  if (skipped_depth_ > 0) {
    ++skipped_depth_;
    return;
  }
  const ModelElement element = element_of(tag);
  if (element == ModelElement::Passed) return skip(tag);
  open_.push_back(element);
  switch (element) {
    case ModelElement::Model:
      return start_model(tag);
    case ModelElement::Object:
      return start_object(tag);
    case ModelElement::Vertex:
      return add_vertex(tag);
    case ModelElement::Triangle:
      return add_triangle(tag);
    case ModelElement::Component:
      return add_component(tag);
    case ModelElement::Item:
      return add_item(tag);
    case ModelElement::Setting:
      setting_name_ = tag.attribute("name").value_or("");
      setting_.clear();
      return;
    case ModelElement::BaseMaterials:
    case ModelElement::ColorGroup:
      return start_group(tag);
    case ModelElement::Base:
      return add_entry(tag, "displaycolor");
    case ModelElement::Color:
      return add_entry(tag, "color");
    case ModelElement::TriangleSet:
      set_name_ = name_of(tag);
      return;
    case ModelElement::SetTriangle:
      return add_to_set(tag, "index", "index");
    case ModelElement::SetRange:
      return add_to_set(tag, "startindex", "endindex");
    default:
      return;
  }
}

void ModelReader3mf::end() {
  if (skipped_depth_ > 0) {
    --skipped_depth_;
    return;
  }
  const ModelElement element = top();
  open_.pop_back();
  if (element == ModelElement::Object) end_object();
  if (element == ModelElement::Setting) end_setting();
}

/// Skips an element that the grammar does not have. The root must be a model.
void ModelReader3mf::skip(const XmlTag& tag) {
  if (open_.empty()) {
    fail(ErrorCode::UnknownFormat, "the root element is " + quoted(tag.name) +
                                       ", not the model of 3MF (" + std::string(kCore) + ")");
  }
  skipped_depth_ = 1;
  const auto* const known =
      std::find_if(kSkippedElements.begin(), kSkippedElements.end(),
                   [&](const SkippedElement& skipped) { return skipped.name == tag.name; });
  if (known != kSkippedElements.end()) {
    (known->is_geometry ? scene_.left_out : scene_.passed).emplace(known->called);
    return;
  }
  constexpr std::size_t kMostNamed = 16;
  if (scene_.passed.size() < kMostNamed) scene_.passed.insert("elements " + quoted(tag.name));
}

/// Reads the unit and the extensions of a part.
void ModelReader3mf::start_model(const XmlTag& tag) {
  has_root_ = true;
  require_extensions(tag);
  const std::string_view unit = tag.attribute("unit").value_or("millimeter");
  const auto* const known = std::find_if(kUnits.begin(), kUnits.end(),
                                         [&](const NamedUnit& each) { return each.name == unit; });
  if (known == kUnits.end()) fail(ErrorCode::Syntax, "the unit is " + quoted(unit));
  scene_.parts[part_].unit = Rational(known->numerator) / known->denominator;
  scene_.parts[part_].unit_name = unit;
}

/// Throws if the part requires an extension that may change the shape.
void ModelReader3mf::require_extensions(const XmlTag& tag) const {
  std::string_view prefixes = tag.attribute("requiredextensions").value_or("");
  for (std::string_view prefix = take_word(prefixes); !prefix.empty();
       prefix = take_word(prefixes)) {
    const auto space = spaces_.find(prefix);
    if (space == spaces_.end()) {
      fail(ErrorCode::Syntax, "the required extension " + quoted(prefix) + " has no name space");
    }
    if (std::find(kUnderstood.begin(), kUnderstood.end(), space->second) != kUnderstood.end()) {
      continue;
    }
    fail(ErrorCode::UnknownFormat, "the file requires the extension " + quoted(prefix) + " (" +
                                       space->second +
                                       "), which is not supported; export the model as a mesh");
  }
}

// ---------------------------------------------------------------- objects

void ModelReader3mf::start_object(const XmlTag& tag) {
  // The memory of the object, twice, and its entry in the map.
  constexpr std::uint64_t kObjectBytes = 256;
  scene_.charge.add(kObjectBytes, "the objects of the file");
  ThreeMfObject object;
  object.part = part_;
  object.id = whole_number(tag, "id");
  const std::string_view type = tag.attribute("type").value_or("model");
  if (type == "support" || type == "solidsupport") object.type = ThreeMfType::Support;
  if (type == "surface") object.type = ThreeMfType::Surface;
  if (type == "other") object.type = ThreeMfType::Other;
  object.first_point = object.end_point = scene_.source.point_count();
  object.first_face = object.end_face = static_cast<std::uint32_t>(scene_.source.face_count());
  object.first_component = static_cast<std::uint32_t>(scene_.components.size());
  if (scene_.looks.is_kept) {
    object.name = name_of(tag);
    set_steps_ = 0;
    object_group_ = look_number(tag, "pid");
    object_entry_ = look_number(tag, "pindex");
  } else if (tag.attribute("pid")) {
    pass_over("materials and colours");
  }
  const auto number = static_cast<std::uint32_t>(scene_.objects.size());
  const bool is_new = scene_.object_of.emplace(std::pair(part_, object.id), number).second;
  if (!is_new) {
    fail(ErrorCode::BadShape, "a second object with the id " + std::to_string(object.id));
  }
  scene_.objects.push_back(object);
}

void ModelReader3mf::end_object() {
  object().end_point = scene_.source.point_count();
  object().end_face = static_cast<std::uint32_t>(scene_.source.face_count());
  object().end_component = static_cast<std::uint32_t>(scene_.components.size());
  const bool is_mesh = object().end_point > object().first_point;
  if (is_mesh && object().end_component > object().first_component) {
    fail(ErrorCode::BadShape, "object " + std::to_string(object().id) +
                                  " has a mesh and components, of which 3MF allows one");
  }
}

void ModelReader3mf::add_vertex(const XmlTag& tag) {
  read_number(required(tag, "x"), "x", x_);
  read_number(required(tag, "y"), "y", y_);
  read_number(required(tag, "z"), "z", z_);
  scene_.source.add_point(x_, y_, z_);
}

void ModelReader3mf::add_triangle(const XmlTag& tag) {
  const std::uint32_t first = object().first_point;
  const std::uint32_t count = scene_.source.point_count() - first;
  for (const char* const name : {"v1", "v2", "v3"}) {
    const std::uint32_t vertex = whole_number(tag, name);
    if (vertex >= count) {
      fail(ErrorCode::BadIndex, std::string(name) + " is vertex " + std::to_string(vertex) +
                                    "; the mesh has " + std::to_string(count) +
                                    (count == 1 ? " vertex" : " vertices"));
    }
    scene_.source.add_corner(first + vertex);
  }
  scene_.source.end_face();
  if (scene_.looks.is_kept) return add_look(tag);
  if (tag.attribute("pid") || tag.attribute("p1")) pass_over("materials and colours");
}

void ModelReader3mf::add_component(const XmlTag& tag) {
  scene_.components.push_back(placement_of(tag));
}

/// Adds an item of the build. 3MF has items in the first part only.
void ModelReader3mf::add_item(const XmlTag& tag) {
  if (part_ != 0) return;
  if (tag.attribute("printable") == std::string_view("0")) {
    scene_.passed.insert("that items are not printable");
  }
  scene_.items.push_back(placement_of(tag));
}

/// Reads a setting of Cura, which states the kind of an item or an object.
void ModelReader3mf::end_setting() {
  scene_.passed.insert("metadata");
  std::string_view name = setting_name_;
  if (!take_prefix(name, "cura:") || (setting_ != "True" && setting_ != "true")) return;
  for (const auto& [setting, called] : kCuraMeshes) {
    if (name != setting) continue;
    scene_.left_out.emplace(called);
    if (open_.size() < 2) return;
    ModelElement& owner = open_[open_.size() - 2];
    if (owner == ModelElement::Object) {
      object().type = ThreeMfType::Other;
      continue;
    }
    if (part_ == 0 && !scene_.items.empty()) scene_.items.pop_back();
    scene_.has_lost_items = true;
    // The item is removed, so other settings do not matter.
    owner = open_.back() = ModelElement::Passed;
    return;
  }
}

// ---------------------------------------------------------------- looks
//
// A look never decides whether a file is refused. What is wrong with one is named in a note.

/// Starts a group of base materials or colours. If two groups have the same id, the first one
/// counts.
void ModelReader3mf::start_group(const XmlTag& tag) {
  constexpr std::uint64_t kGroupBytes = 96;
  group_ = nullptr;
  const auto id = look_number(tag, "id");
  if (!id) return pass_over("groups of materials without an id");
  scene_.charge.add(kGroupBytes, "the materials of the file");
  const auto first = static_cast<std::uint32_t>(scene_.looks.entries.size());
  const auto [group, is_new] =
      scene_.looks.groups.try_emplace(std::pair(part_, *id), ThreeMfGroup{first, first});
  if (is_new) group_ = &group->second;
  if (!is_new) pass_over("groups of materials with the id of another one");
}

void ModelReader3mf::add_entry(const XmlTag& tag, const char* color) {
  if (group_ == nullptr) return;
  ThreeMfEntry entry;
  if (top() == ModelElement::Base) entry.name = tag.attribute("name").value_or("");
  const auto text = tag.attribute(color);
  entry.color = threemf_color(text.value_or(""));
  if (text && !entry.color) pass_over("colours that are not #RRGGBB or #RRGGBBAA");
  scene_.charge.add(2 * sizeof entry + 2 * entry.name.size(), "the materials of the file");
  scene_.looks.entries.push_back(std::move(entry));
  group_->end = static_cast<std::uint32_t>(scene_.looks.entries.size());
}

/// Returns the index of the name of an object or a set of triangles, or kNone if it has no name.
std::uint32_t ModelReader3mf::name_of(const XmlTag& tag) {
  const std::string_view name = tag.attribute("name").value_or("");
  if (name.empty()) return ThreeMfLook::kNone;
  scene_.charge.add(2 * sizeof(std::string) + 2 * name.size(), "the names of the file");
  scene_.looks.names.emplace_back(name);
  return static_cast<std::uint32_t>(scene_.looks.names.size() - 1);
}

/// Gives triangles of the object the name of the open set. If a triangle belongs to several sets,
/// the first one counts.
void ModelReader3mf::add_to_set(const XmlTag& tag, const char* first, const char* last) {
  if (set_name_ == ThreeMfLook::kNone) return;
  const auto begin = look_number(tag, first), end = look_number(tag, last);
  const std::size_t base = object().first_face, count = scene_.source.face_count() - base;
  if (!begin || !end || *begin > *end || *end >= count) {
    return pass_over("sets of triangles that there are not");
  }
  // Without a bound, a few ranges with many triangles would take long.
  constexpr std::size_t kMostSetsOfTriangle = 64;
  set_steps_ += *end - *begin + 1;
  if (set_steps_ > kMostSetsOfTriangle * count) return pass_over("sets of triangles that overlap");
  for (std::size_t f = base + *begin; f <= base + *end; ++f) {
    ThreeMfLook& look = look_of(f);
    if (look.name == ThreeMfLook::kNone) look.name = set_name_;
  }
}

/// Adds the look of the last triangle. Missing parts are taken from the object.
void ModelReader3mf::add_look(const XmlTag& tag) {
  if (tag.attribute("paint_color") || tag.attribute(kSlic3r, "mmu_segmentation")) {
    pass_over("colours painted in slicers");
  }
  const auto own = tag.attribute("p1");
  if (!own && !(object_group_ && object_entry_)) return;
  const auto group = tag.attribute("pid") && own ? look_number(tag, "pid") : object_group_;
  const auto first = own ? look_number(tag, "p1") : object_entry_;
  if (!group || !first) return pass_over("references to materials that are not read");
  ThreeMfLook look;
  constexpr std::array<const char*, 3> kCorners{"p1", "p2", "p3"};
  for (std::size_t i = 0; i < kCorners.size(); ++i) {
    const bool is_stated = own && tag.attribute(kCorners[i]);
    const auto index = is_stated ? look_number(tag, kCorners[i]) : first;
    const auto entry = index ? entry_of(*group, *index) : std::nullopt;
    if (!entry) return pass_over("references to materials that are not read");
    look.entry[i] = *entry;
  }
  // A face has one base material, which is the material of its first corner.
  if (!scene_.looks.entries[look.entry[0]].name.empty()) look.entry.fill(look.entry[0]);
  look_of(scene_.source.face_count() - 1).entry = look.entry;
}

ThreeMfLook& ModelReader3mf::look_of(std::size_t face) {
  std::vector<ThreeMfLook>& looks = scene_.looks.faces;
  if (face >= looks.size()) {
    if (face >= looks.capacity()) {
      scene_.charge.add((2 * face + 64) * sizeof(ThreeMfLook), "the materials of the file");
      looks.reserve(2 * face + 64);
    }
    looks.resize(face + 1);
  }
  return looks[face];
}

std::optional<std::uint32_t> ModelReader3mf::entry_of(std::uint32_t group,
                                                      std::uint32_t index) const {
  const auto found = scene_.looks.groups.find({part_, group});
  if (found == scene_.looks.groups.end()) return {};
  const auto [first, end] = found->second;
  return index < end - first ? std::optional(first + index) : std::nullopt;
}

/// Returns the integer that an attribute states, or nothing.
std::optional<std::uint32_t> ModelReader3mf::look_number(const XmlTag& tag, const char* name) {
  const std::string_view text = tag.attribute(name).value_or("");
  std::uint32_t value = 0;
  const char* const last = text.data() + text.size();
  const auto [end, code] = std::from_chars(text.data(), last, value);
  return code == std::errc() && end == last ? std::optional(value) : std::nullopt;
}

// ---------------------------------------------------------------- attributes

ThreeMfPlacement ModelReader3mf::placement_of(const XmlTag& tag) {
  scene_.charge.add(2 * sizeof(ThreeMfPlacement), "the components of the file");
  const TextPlace here = stream_.place();
  ThreeMfPlacement placement;
  placement.stated_in = placement.part = part_;
  placement.object = whole_number(tag, "objectid");
  placement.line = static_cast<std::uint32_t>(here.line);
  placement.column = static_cast<std::uint32_t>(here.column);
  if (const auto path = tag.attribute(kProduction, "path")) {
    placement.part = scene_.part_of(threemf_part_name(*path));
  }
  if (const auto transform = tag.attribute("transform")) {
    placement.transform = transform_of(*transform);
  }
  return placement;
}

/// Reads twelve numbers. If they are the identity, no transform is needed.
std::uint32_t ModelReader3mf::transform_of(std::string_view text) {
  ThreeMfTransform m;
  std::uint64_t limbs = 0;
  for (Rational& entry : m) {
    const std::string_view word = take_word(text);
    if (word.empty()) fail(ErrorCode::Syntax, "a transform needs 12 numbers");
    read_number(word, "transform", x_);
    entry = x_.exact();
    limbs += mpz_size(mpq_numref(entry.mpq())) + mpz_size(mpq_denref(entry.mpq()));
  }
  if (!take_word(text).empty()) fail(ErrorCode::Syntax, "a transform has 12 numbers");
  constexpr std::uint64_t kHeapBytes = 64;  // The memory of two blocks for each number.
  scene_.charge.add(sizeof m + m.size() * kHeapBytes + limbs * sizeof(mp_limb_t), "the transforms");
  const Rational determinant = m[0] * (m[4] * m[8] - m[5] * m[7]) -
                               m[1] * (m[3] * m[8] - m[5] * m[6]) +
                               m[2] * (m[3] * m[7] - m[4] * m[6]);
  if (determinant.sign() == 0) {
    fail(ErrorCode::BadShape, "the transform is singular: it makes the object flat");
  }
  static const ThreeMfTransform kIdentity{1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0};
  if (m == kIdentity) return ThreeMfPlacement::kNoTransform;
  scene_.transforms.push_back(std::move(m));
  return static_cast<std::uint32_t>(scene_.transforms.size() - 1);
}

std::string_view ModelReader3mf::required(const XmlTag& tag, const char* name) const {
  const auto value = tag.attribute(name);
  if (!value) {
    fail(ErrorCode::Syntax, std::string(tag.name) + " lacks the attribute " + name);
  }
  return *value;
}

std::uint32_t ModelReader3mf::whole_number(const XmlTag& tag, const char* name) {
  const std::string_view text = required(tag, name);
  std::uint32_t value = 0;
  const char* const last = text.data() + text.size();
  const auto [end, code] = std::from_chars(text.data(), last, value);
  if (code != std::errc() || end != last) {
    fail(ErrorCode::Syntax, std::string(name) + " is " + quoted(text) + ", not a whole number");
  }
  return value;
}

/// Reads a number. Errors have the place of the tag.
void ModelReader3mf::read_number(std::string_view text, const char* name, ReadNumber& number) {
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

/// Returns the value of a hexadecimal digit, or 16 if the character is not a digit.
unsigned hex_digit(char c) {
  if (c >= '0' && c <= '9') return static_cast<unsigned>(c - '0');
  if (c >= 'a' && c <= 'f') return static_cast<unsigned>(c - 'a') + 10;
  if (c >= 'A' && c <= 'F') return static_cast<unsigned>(c - 'A') + 10;
  return 16;
}

}  // namespace

std::uint32_t ThreeMfScene::part_of(const std::string& name) {
  // The memory of the part, twice, and an entry of the map.
  constexpr std::uint64_t kPartBytes = 512;
  const auto number = static_cast<std::uint32_t>(parts.size());
  const auto [entry, is_new] = part_numbers.try_emplace(name, number);
  if (is_new) {
    charge.add(kPartBytes + 3 * name.size(), "the parts of the file");
    parts.push_back({name});
  }
  return entry->second;
}

std::string threemf_text_name(const std::string& file, const std::string& part) {
  if (part.empty()) return file;
  return file + '(' + std::string(part).substr(0, text_prefix(part)) + ')';
}

std::string threemf_part_name(std::string_view uri) {
  take_prefix(uri, "/");
  std::string name;
  for (std::size_t i = 0; i < uri.size(); ++i) {
    const bool is_code = uri[i] == '%' && i + 2 < uri.size() && hex_digit(uri[i + 1]) < 16 &&
                         hex_digit(uri[i + 2]) < 16;
    name +=
        is_code ? static_cast<char>(hex_digit(uri[i + 1]) * 16 + hex_digit(uri[i + 2])) : uri[i];
    if (is_code) i += 2;
  }
  return name;
}

void read_threemf_model(ZipArchive& archive, std::uint32_t part, const ReadOptions& options,
                        std::size_t archive_bytes, ThreeMfScene& scene, Context& context) {
  const std::string name = scene.parts[part].name;
  const auto entry = archive.find(name);
  if (!entry) {
    throw Error(ErrorCode::CannotOpen, "the archive lacks the part " + plumb::quoted(name),
                {options.name});
  }
  ModelReader3mf(part, options, archive_bytes, scene, context).read(archive, *entry);
}

}  // namespace plumb
