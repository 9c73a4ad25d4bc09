// Sets of space as text: the choice of a format, the losses of this format, and the validation of
// links.
//
// SolidText makes the mesh when it is constructed, so that a set that cannot be written fails
// before a file is opened, and the losses are known: parts that no volume touches, marks that a
// closed mesh cannot represent, and the effects of rounding. LinkCheck follows the data structure
// of a complex of which only the bounds of ids are guaranteed. It establishes first that `next` and
// `radial` are permutations, after which walks along them terminate, and then counts what each walk
// meets. It is the first of two checks of a `.nef` file; the second is the audit, which may follow
// links freely. Formats: docs/formats.md, sections Meshes and .nef.
// Tested by tests/io/solid_io_test.cpp and tests/io/nef3_reader_test.cpp.
#include "plumb/io/solid/solid_text.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "plumb/io/mesh/attribute_writer.h"
#include "plumb/io/mesh/glb.h"
#include "plumb/io/mesh/mesh_formats.h"
#include "plumb/io/nef3_writer.h"
#include "plumb/io/text/file_names.h"
#include "plumb/io/text/files.h"
#include "plumb/predicates/error.h"
#include "plumb/predicates/rounding.h"
#include "plumb/space/mesh_with_attributes.h"
#include "plumb/space/source_mesh.h"
#include "plumb/space/to_mesh.h"
#include "plumb/space/valid_mesh.h"

namespace plumb {
namespace {

constexpr std::array kFormats{
    SolidFormat{"off", ".off", MeshFormat::Off},
    SolidFormat{"obj", ".obj", MeshFormat::Obj},
    SolidFormat{"stl", ".stl", MeshFormat::Stl},
    SolidFormat{"ply", ".ply", MeshFormat::Ply},
    SolidFormat{"glb", ".glb", MeshFormat::Gltf},
    SolidFormat{"3mf", ".3mf", MeshFormat::ThreeMf},
    SolidFormat{"nef", ".nef", std::nullopt},
    SolidFormat{"off-exact", ".off", MeshFormat::ExactOff},
    SolidFormat{"stl-binary", ".stl", MeshFormat::StlBinary},
    SolidFormat{"ply-text", ".ply", MeshFormat::PlyText},
};

std::string counted(std::uint64_t count, const char* what) {
  return std::to_string(count) + " " + what + (count == 1 ? "" : "s");
}

std::string to_text(const ItemCounts& items) {
  std::string text;
  const auto add = [&text](std::uint64_t count, const char* what) {
    if (count != 0) text += (text.empty() ? "" : ", ") + counted(count, what);
  };
  add(items.facets, "facet");
  add(items.edges, "edge");
  text += items.vertices == 0 ? ""
                              : (text.empty() ? "" : ", ") + std::to_string(items.vertices) +
                                    (items.vertices == 1 ? " vertex" : " vertices");
  return text;
}

/// Describes what rounding does to a mesh that is not repaired.
void describe(const RoundingReport& rounding, std::vector<std::string>& losses) {
  const auto add = [&losses](std::uint64_t count, const std::string& what) {
    if (count != 0) {
      losses.push_back("rounding: " + std::to_string(count) + " " + what +
                       "; .nef keeps the exact set");
    }
  };
  add(rounding.vertices_merged, "vertices fell onto others");
  add(rounding.degenerate.size(), "faces lost their area");
  add(rounding.flipped.size(), "faces flipped");
  add(rounding.not_simple.size(), "faces cross themselves");
  add(rounding.doubled.size(), "faces fell onto each other");
  add(rounding.crossing_count, "pairs of faces cross");
}

/// Describes a repair. It is a loss if the shape changes; otherwise, a change.
void describe(const RoundingRepair& repair, std::vector<std::string>& losses,
              std::vector<std::string>& changes) {
  if (repair.rounds == 0) return;
  const auto with_distance = [](double distance) {
    return decimal_text(exact_rational(distance), 2) + "; .nef keeps the exact set";
  };
  if (repair.changes_topology) {
    losses.push_back("rounding closed gaps or holes, or removed parts, that are narrower than " +
                     with_distance(2 * repair.largest_move));
  } else {
    changes.push_back("rounding damaged " + counted(repair.damaged_faces, "face") +
                      ", and the repair moved the boundary by up to " +
                      with_distance(repair.largest_move));
  }
}

/// Describes the properties of a set that a mesh does not represent.
void describe(const ToMeshReport& report, std::vector<std::string>& losses,
              std::vector<std::string>& changes) {
  if (report.dropped.total() != 0) {
    losses.push_back("left out what no volume of the set touches: " + to_text(report.dropped));
  }
  if (report.closed.total() != 0) {
    changes.push_back("the set is not closed; its closure was written, with " +
                      to_text(report.closed));
  }
  if (report.filled.total() != 0) {
    losses.push_back("filled what is missing inside the set: " + to_text(report.filled));
  }
}

/// Returns the attributes that the sources of a set have, as lists without values.
MeshAttributes outline_of(const Nef3& set) {
  MeshAttributes all;
  for (const PlacedSource& placed : set.sources()) {
    const MeshAttributes& own = placed.source->attributes;
    all.materials.insert(all.materials.end(), own.materials.begin(), own.materials.end());
    if (!own.face_material.empty()) all.face_material = {MeshAttributes::kNone};
    if (!own.face_group.empty()) all.face_group = {MeshAttributes::kNone};
    if (!own.face_id.empty()) all.face_id = {MeshAttributes::kNone};
    for (const MeshChannel& channel : own.channels) {
      all.channels.push_back({channel.name, channel.width, {}});
    }
  }
  return all;
}

/// Whether a file of this format can store any of these attributes. If it cannot, the faces remain
/// polygons.
bool holds_any(const MeshAttributes& outline, MeshFormat format) {
  const bool is_off = format == MeshFormat::Off || format == MeshFormat::ExactOff;
  const bool is_ply = format == MeshFormat::Ply || format == MeshFormat::PlyText;
  const bool is_obj = format == MeshFormat::Obj;
  const bool is_3mf = format == MeshFormat::ThreeMf;
  if (format == MeshFormat::Gltf) {
    return !outline.face_material.empty() || !glb_channels(outline).empty();
  }
  if (!is_off && !is_ply && !is_obj && !is_3mf) return false;
  const bool has_color =
      std::any_of(outline.materials.begin(), outline.materials.end(),
                  [](const MeshMaterial& material) { return material.color.has_value(); });
  const bool has_usual = std::any_of(
      outline.channels.begin(), outline.channels.end(), [&](const MeshChannel& channel) {
        const bool is_shape = channel.name == "normal" || channel.name == "texcoord_0";
        return channel.name == "color" || (is_shape && !is_3mf);
      });
  if (has_color || has_usual) return true;
  if (is_ply) return !outline.face_id.empty() || !outline.channels.empty();
  const bool has_names = is_obj || is_3mf;
  return has_names && !(outline.face_material.empty() && outline.face_group.empty());
}

}  // namespace

std::span<const SolidFormat> solid_formats() { return kFormats; }

std::string material_library_of(const std::string& path) {
  const std::filesystem::path file = path_of(path);
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::status(file, error);
  const bool is_other =
      std::filesystem::exists(status) && !std::filesystem::is_regular_file(status);
  if (path == "-" || is_other || file.filename().empty() || file.extension() == ".mtl") return {};
  return file_name_of(file.filename().replace_extension(".mtl"));
}

namespace {

bool has_floats(MeshFormat format) {
  return format == MeshFormat::StlBinary || format == MeshFormat::Gltf;
}

}  // namespace

SolidText::SolidText(const Nef3& set, const SolidFormat& format, OutputRounding rounding,
                     Context& context, std::string library, SolidFaces faces)
    : set_(set), format_(format), faces_(faces), library_(std::move(library)) {
  const bool has_attributes = !set.sources().empty() && writes_attributes(rounding);
  // For an unbounded set, the error has the same words for all mesh formats.
  if (format.mesh && !(has_attributes && set.is_bounded())) {
    make_mesh(*format.mesh, rounding, context);
  }
  if (has_attributes) add_attributes(context);
}

bool SolidText::has_library() const {
  return format_.mesh == MeshFormat::Obj && !library_.empty() && !attributes_.materials.empty();
}

/// Whether the mesh is divided as the sources are. This is the case if the format can store some of
/// their attributes, or if their faces are kept apart. Notes the attributes that the format cannot
/// store.
bool SolidText::writes_attributes(OutputRounding rounding) {
  const MeshAttributes outline = outline_of(set_);
  if (!format_.mesh) {
    dropped_ = lost_attributes(outline, MeshFormat::Stl);
    return false;
  }
  dropped_ = lost_attributes(outline, *format_.mesh);
  if (!holds_any(outline, *format_.mesh) && faces_.join == PieceJoin::SameAttributes) return false;
  if (rounding == OutputRounding::Nearest || *format_.mesh == MeshFormat::ExactOff) {
    dropped_ = "colours, ids and other attributes are not written with --raw and in off-exact";
    return false;
  }
  return true;
}

MeshFaces SolidText::mesh_faces() const {
  return faces_.are_triangles || lists_triangles(*format_.mesh) ? MeshFaces::Triangles
                                                                : MeshFaces::PlanarPolygons;
}

/// Makes the mesh with the attributes of the sources.
void SolidText::add_attributes(Context& context) {
  AttributeOptions options;
  options.join = faces_.join;
  options.faces = mesh_faces();
  if (has_floats(*format_.mesh)) options.type = CoordinateType::Float;
  MeshWithAttributes made = mesh_with_attributes(set_, options, context);
  std::vector<std::string> losses, changes;
  describe(made.repair, losses, changes);
  describe(made.report, losses, changes);
  require_faces(made.mesh);
  const auto add_new = [](std::vector<std::string>& list, std::vector<std::string>& told) {
    for (std::string& text : told) {
      if (std::find(list.begin(), list.end(), text) == list.end()) list.push_back(std::move(text));
    }
  };
  add_new(losses_, losses);
  add_new(changes_, changes);
  mesh_ = std::move(made.mesh);
  if (!holds_any(made.attributes, *format_.mesh)) return;
  attributes_ = std::move(made.attributes);
  keep_used_materials(attributes_);
}

void SolidText::make_mesh(MeshFormat format, OutputRounding rounding, Context& context) {
  ToMeshOptions options;
  options.faces = mesh_faces();
  const CoordinateType type = has_floats(format) ? CoordinateType::Float : CoordinateType::Double;
  MeshOfComplex made;
  if (format == MeshFormat::ExactOff || rounding == OutputRounding::Nearest) {
    options.keeps_exact = true;
    made = mesh_of_complex(set_.complex(), options, context);
  } else {
    ValidMesh valid = valid_mesh(set_, options, type, context);
    describe(valid.repair, losses_, changes_);
    made = std::move(valid.made);
  }
  if (made.report.is_unbounded) {
    throw Error(ErrorCode::CannotWrite,
                "the set reaches to infinity: a mesh cannot hold it, .nef can");
  }
  describe(made.report, losses_, changes_);
  if (format != MeshFormat::ExactOff && rounding == OutputRounding::Nearest) {
    round_points(made.mesh, type);
    constexpr std::uint64_t kListed = 1;
    describe(check_rounding(made.mesh, kListed, context), losses_);
  }
  require_faces(made.mesh);
  mesh_ = std::move(made.mesh);
}

/// Throws if this is a mesh without faces, and the format cannot represent such a mesh.
void SolidText::require_faces(const PolygonMesh& mesh) const {
  if (format_.mesh == MeshFormat::Gltf && mesh.face_count() == 0) {
    throw Error(ErrorCode::CannotWrite, "the set has no volume: a .glb file cannot hold it");
  }
}

void SolidText::write_file(const std::string& path, Context& context) const {
  std::optional<OutputFile> library;
  if (has_library()) {
    library.emplace(std::filesystem::path(path).replace_filename(library_).string());
    write_library(library->stream());
    library->finish();
  }
  OutputFile file(path);
  write(file.stream(), context);
  file.finish();
  if (library) library->commit();
  file.commit();
}

void SolidText::write(std::ostream& out, Context& context) const {
  if (format_.mesh && attributes_.empty()) {
    write_mesh(out, mesh_, *format_.mesh, context);
  } else if (format_.mesh) {
    write_mesh(out, mesh_, attributes_, *format_.mesh, has_library() ? library_ : std::string());
  } else {
    write_nef3(out, set_.complex(), context);
  }
}

namespace {

class LinkCheck {
 public:
  explicit LinkCheck(const SpaceComplex& complex) : c_(complex) {}

  std::string first_flaw() {
    check_edges();
    check_vertices();
    check_uses();
    if (flaw_.empty()) check_radial_cycles();
    if (flaw_.empty()) check_facet_cycles();
    return flaw_;
  }

 private:
  void check_edges();
  void check_vertices();
  void check_uses();
  void check_radial_cycles();
  void check_facet_cycles();
  bool visit_cycle(UseId first, FacetId facet);

  void require(bool holds, std::string_view kind, std::size_t index, std::string_view rule) {
    if (holds || !flaw_.empty()) return;
    flaw_ = std::string(kind) + ' ' + std::to_string(index + 1) + ": " + std::string(rule);
  }

  const SpaceComplex& c_;
  IdVector<UseId, std::uint8_t> visited_;
  std::string flaw_;
};

void LinkCheck::check_edges() {
  for (std::uint32_t e = 0; e < c_.edge_count(); ++e) {
    require(c_.origin[2 * e] != c_.origin[2 * e + 1], "edge", e, "joins a vertex to itself");
    require(c_.edge_planes[e][0] != c_.edge_planes[e][1], "edge", e, "lies on one plane");
    const UseId use = c_.edge_use[e];
    require(use.is_valid() != c_.edge_volume[e].is_valid(), "edge", e,
            "is free in a volume or has uses, one of the two");
    if (!use.is_valid()) continue;
    const HalfedgeId h = c_.use_halfedge[use];
    require(SpaceComplex::edge_of(h) == EdgeId(e), "edge", e, "names a use of another edge");
  }
}

void LinkCheck::check_vertices() {
  for (std::uint32_t v = 0; v < c_.vertex_count(); ++v) {
    const bool is_alone = c_.star_of(VertexId(v)).empty() && !c_.vertex_facet[v].is_valid();
    require(is_alone == c_.vertex_volume[v].is_valid(), "vertex", v,
            "has a volume if nothing else is at it, and only then");
  }
}

/// Checks the uses. The reader made `use_prev` as the inverse of `use_next`, which is a permutation
/// if `use_prev` is complete.
void LinkCheck::check_uses() {
  IdVector<UseId, std::uint8_t> is_radial(c_.use_count(), 0);
  for (std::uint32_t u = 0; u < c_.use_count(); ++u) {
    const UseId next = c_.use_next[u];
    const UseId radial = c_.use_radial[u];
    require(c_.use_prev[u].is_valid(), "use", u, "is the next of none");
    require(c_.target(c_.use_halfedge[u]) == c_.use_origin(next), "use", u,
            "does not end where the next begins");
    require(c_.use_facet[u] == c_.use_facet[next], "use", u, "is in another facet than the next");
    const HalfedgeId h = c_.use_halfedge[radial];
    require(SpaceComplex::edge_of(h) == SpaceComplex::edge_of(c_.use_halfedge[u]), "use", u,
            "is of another edge than the next around it");
    require(c_.edge_use[SpaceComplex::edge_of(h)].is_valid(), "use", u,
            "is of an edge that has none");
    require(is_radial[radial] == 0, "use", radial.value(), "follows two uses around its edge");
    is_radial[radial] = 1;
  }
}

/// Checks the cycles around edges. Requires that the links are a permutation, so that each walk
/// returns to its start.
void LinkCheck::check_radial_cycles() {
  IdVector<EdgeId, std::uint32_t> at_edge(c_.edge_count(), 0);
  for (const HalfedgeId h : c_.use_halfedge) ++at_edge[SpaceComplex::edge_of(h)];
  for (std::uint32_t e = 0; e < c_.edge_count(); ++e) {
    const UseId first = c_.edge_use[e];
    std::uint32_t around = 0;
    UseId use = first;
    while (first.is_valid() && (around == 0 || use != first)) {
      use = c_.use_radial[use];
      ++around;
    }
    require(around == at_edge[e], "edge", e, "has uses that are not around it");
  }
}

void LinkCheck::check_facet_cycles() {
  visited_.assign(c_.use_count(), 0);
  for (std::uint32_t f = 0; f < c_.facet_count(); ++f) {
    const auto cycles = c_.cycles_of(FacetId(f));
    require(!cycles.empty(), "facet", f, "has no boundary");
    for (const UseId first : cycles) {
      require(visit_cycle(first, FacetId(f)), "facet", f,
              "lists a cycle twice or one of another facet");
    }
  }
  for (std::size_t u = 0; u < visited_.size(); ++u) {
    require(visited_[u] != 0, "use", u, "is on a cycle that its facet does not list");
  }
}

bool LinkCheck::visit_cycle(UseId first, FacetId facet) {
  if (visited_[first] != 0 || c_.use_facet[first] != facet) return false;
  for (UseId use = first; visited_[use] == 0; use = c_.use_next[use]) {
    visited_[use] = 1;
  }
  return true;
}

}  // namespace

std::string flaw_of_links(const SpaceComplex& complex) { return LinkCheck(complex).first_flaw(); }

}  // namespace plumb
