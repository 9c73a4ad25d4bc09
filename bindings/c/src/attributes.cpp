// Attributes of meshes: materials, groups, ids and channels in and out, and the meshes of solids
// with the attributes of their sources.
//
// A handle of a mesh has complete arrays and indices in range, whatever is set, so that writers and
// solids take it as it is. A setter builds its array first and moves it in at the end: if it fails,
// the mesh is unchanged. A solid copies the mesh that becomes its source, since the caller may go
// on to change the mesh.
// Tested by tests/c/interface_test.c and tests/c/refused_memory_test.cpp.
#include <cmath>

#include "files.h"
#include "handles.h"
#include "plumb/space/mesh_with_attributes.h"
#include "plumb/space/source_mesh.h"
#include "solids.h"

namespace plumb::c {
namespace {

using FaceValues = std::vector<std::uint32_t>;

static_assert(PLUMB_PIECES_APART == static_cast<int>(PieceJoin::None) &&
              PLUMB_PIECES_SAME_FACE == static_cast<int>(PieceJoin::SameFace));
static_assert(PLUMB_NONE == MeshAttributes::kNone && PLUMB_NONE == FaceSource::kNone);

/// Returns the array of a constant of plumb_face_values; null if there is no such constant.
template <class Mesh>
auto* face_values(Mesh& mesh, int which) {
  switch (which) {
    case PLUMB_FACE_MATERIAL:
      return &mesh.attributes.face_material;
    case PLUMB_FACE_GROUP:
      return &mesh.attributes.face_group;
    case PLUMB_FACE_ID:
      return &mesh.attributes.face_id;
    case PLUMB_FACE_SOURCE:
    case PLUMB_FACE_SOURCE_FACE:
    case PLUMB_FACE_IS_FLIPPED:
      return &mesh.sources[static_cast<std::size_t>(which - PLUMB_FACE_SOURCE)];
    default:
      return static_cast<decltype(&mesh.attributes.face_id)>(nullptr);
  }
}

FaceValues& settable_values(plumb_mesh& mesh, int which) {
  if (which < PLUMB_FACE_MATERIAL || which > PLUMB_FACE_ID) {
    fail_argument("which is not PLUMB_FACE_MATERIAL, PLUMB_FACE_GROUP or PLUMB_FACE_ID");
  }
  return *face_values(mesh, which);
}

void require_count(std::size_t count, std::size_t needed, const char* what) {
  if (count == needed) return;
  fail_argument("values has " + std::to_string(count) + " entries, but the mesh has " +
                std::to_string(needed) + " " + what);
}

/// Returns one more than the greatest index that values of faces may be, or 2^32 for ids.
std::uint64_t end_of_indices(const MeshAttributes& attributes, int which) {
  if (which == PLUMB_FACE_MATERIAL) return attributes.materials.size();
  if (which == PLUMB_FACE_GROUP) return attributes.groups.size();
  return std::uint64_t{1} << 32U;
}

void require_in_range(std::span<const std::uint32_t> values, std::uint64_t end) {
  for (std::size_t f = 0; f < values.size(); ++f) {
    if (values[f] == PLUMB_NONE || values[f] < end) continue;
    throw Error(ErrorCode::BadIndex, "values[" + std::to_string(f) + "] is " +
                                         std::to_string(values[f]) + ", but there are only " +
                                         std::to_string(end));
  }
}

MeshMaterial material_of(const plumb_material& given) {
  MeshMaterial material;
  material.name = text_or_empty(given.name);
  material.texture = text_or_empty(given.texture);
  if (!given.has_color) return material;
  material.color.emplace();
  for (std::size_t i = 0; i < 4; ++i) {
    const double part = given.color[i];
    if (!std::isfinite(part)) throw Error(ErrorCode::NotFinite, "color is not finite");
    if (part < 0 || part > 1) fail_argument("color has a number that is not from 0 to 1");
    (*material.color)[i] = part;
  }
  return material;
}

template <class List, class Value>
void append(List& list, Value value, std::uint32_t* index) {
  list.push_back(std::move(value));
  if (index != nullptr) *index = static_cast<std::uint32_t>(list.size() - 1);
}

/// Returns the numbers of all corners.
std::vector<double> corner_values(const PolygonMesh& mesh, int place, std::uint32_t width,
                                  std::span<const double> values) {
  if (place == PLUMB_PER_CORNER) return {values.begin(), values.end()};
  std::vector<double> of_corner;
  of_corner.reserve(mesh.corners.size() * width);
  for (const std::uint32_t v : mesh.corners) {
    const std::span<const double> own = values.subspan(std::size_t{v} * width, width);
    of_corner.insert(of_corner.end(), own.begin(), own.end());
  }
  return of_corner;
}

MeshChannel channel_of_arrays(const PolygonMesh& mesh, std::string name, std::uint32_t width,
                              int place, const double* values, std::size_t count) {
  if (name.empty()) fail_argument("name is empty");
  if (width == 0) fail_argument("width is 0");
  if (place != PLUMB_PER_CORNER && place != PLUMB_PER_POINT) {
    fail_argument("place is no constant of plumb_channel_place");
  }
  const bool has_corners = place == PLUMB_PER_CORNER;
  require_count(count, has_corners ? mesh.corners.size() : mesh.points.size(),
                has_corners ? "corners" : "points");
  MeshChannel channel;
  channel.name = std::move(name);
  channel.width = width;
  channel.values = corner_values(mesh, place, width, finite(values, count, "values", width));
  return channel;
}

/// Puts a channel in the place of that of the same name, if there is one.
void set_channel(std::vector<MeshChannel>& channels, MeshChannel channel) {
  for (MeshChannel& known : channels) {
    if (known.name != channel.name) continue;
    known = std::move(channel);
    return;
  }
  channels.push_back(std::move(channel));
}

const MeshChannel* channel_at(const plumb_mesh* mesh, std::size_t i) {
  return i < plumb_mesh_channel_count(mesh) ? &mesh->attributes.channels[i] : nullptr;
}

AttributeOptions attribute_options(const plumb_attribute_options* options) {
  const plumb_attribute_options asked = options_of(options, PLUMB_ATTRIBUTE_OPTIONS_INIT);
  if (asked.pieces < PLUMB_PIECES_SAME_ATTRIBUTES || asked.pieces > PLUMB_PIECES_SAME_FACE) {
    fail_argument("pieces is no constant of plumb_pieces");
  }
  if (asked.floats && asked.polygons) {
    throw Error(ErrorCode::Usage, "meshes of floats consist of triangles");
  }
  return {static_cast<PieceJoin>(asked.pieces),
          asked.floats ? CoordinateType::Float : CoordinateType::Double,
          asked.polygons ? MeshFaces::PlanarPolygons : MeshFaces::Triangles};
}

plumb_mesh mesh_of(MeshWithAttributes made) {
  plumb_mesh mesh{std::move(made.mesh), {}, std::move(made.attributes)};
  for (FaceValues& values : mesh.sources) values.reserve(made.source.size());
  for (const FaceSource& from : made.source) {
    mesh.sources[0].push_back(from.source);
    mesh.sources[1].push_back(from.face);
    mesh.sources[2].push_back(from.is_flipped ? 1 : 0);
  }
  return mesh;
}

}  // namespace
}  // namespace plumb::c

using namespace plumb;
using namespace plumb::c;

// --- materials and groups -----------------------------------------------------------------------

plumb_status plumb_mesh_add_material(plumb_mesh* mesh, const plumb_material* material,
                                     std::uint32_t* index, plumb_error** error) {
  return guarded(error, [&] {
    need(material, "material");
    plumb_mesh& changed = need(mesh, "mesh");
    const plumb_material given = options_of(material, PLUMB_MATERIAL_INIT);
    append(changed.attributes.materials, material_of(given), index);
  });
}

std::size_t plumb_mesh_material_count(const plumb_mesh* mesh) {
  return mesh != nullptr ? mesh->attributes.materials.size() : 0;
}

plumb_status plumb_mesh_material(const plumb_mesh* mesh, std::size_t i, plumb_material* material,
                                 plumb_error** error) {
  return guarded(error, [&] {
    const std::vector<MeshMaterial>& materials = need(mesh, "mesh").attributes.materials;
    if (i >= materials.size()) throw Error(ErrorCode::BadIndex, "there is no such material");
    const MeshMaterial& from = materials[i];
    plumb_material told = PLUMB_MATERIAL_INIT;
    told.name = from.name.c_str();
    told.texture = from.texture.c_str();
    told.has_color = from.color.has_value();
    if (from.color) std::copy(from.color->begin(), from.color->end(), told.color);
    fill(material, told, "material");
  });
}

plumb_status plumb_mesh_add_group(plumb_mesh* mesh, const char* name, std::uint32_t* index,
                                  plumb_error** error) {
  return guarded(error,
                 [&] { append(need(mesh, "mesh").attributes.groups, text(name, "name"), index); });
}

std::size_t plumb_mesh_group_count(const plumb_mesh* mesh) {
  return mesh != nullptr ? mesh->attributes.groups.size() : 0;
}
const char* plumb_mesh_group(const plumb_mesh* mesh, std::size_t i) {
  return i < plumb_mesh_group_count(mesh) ? mesh->attributes.groups[i].c_str() : nullptr;
}

// --- values of faces and corners ----------------------------------------------------------------

plumb_status plumb_mesh_set_face_values(plumb_mesh* mesh, int which, const std::uint32_t* values,
                                        std::size_t count, plumb_error** error) {
  return guarded(error, [&] {
    plumb_mesh& changed = need(mesh, "mesh");
    FaceValues& own = settable_values(changed, which);
    if (values == nullptr && count == 0) return own.clear();
    require_count(count, changed.mesh.face_count(), "faces");
    const std::span<const std::uint32_t> given = array(values, count, "values");
    require_in_range(given, end_of_indices(changed.attributes, which));
    own = FaceValues(given.begin(), given.end());
  });
}

const std::uint32_t* plumb_mesh_face_values(const plumb_mesh* mesh, int which) {
  const FaceValues* const values = mesh != nullptr ? face_values(*mesh, which) : nullptr;
  return values != nullptr && !values->empty() ? values->data() : nullptr;
}

plumb_status plumb_mesh_set_channel(plumb_mesh* mesh, const char* name, std::uint32_t width,
                                    int place, const double* values, std::size_t count,
                                    plumb_error** error) {
  return guarded(error, [&] {
    plumb_mesh& changed = need(mesh, "mesh");
    std::vector<MeshChannel>& channels = changed.attributes.channels;
    std::string called = text(name, "name");
    if (values == nullptr && count == 0) {
      std::erase_if(channels, [&](const MeshChannel& channel) { return channel.name == called; });
      return;
    }
    set_channel(channels,
                channel_of_arrays(changed.mesh, std::move(called), width, place, values, count));
  });
}

std::size_t plumb_mesh_channel_count(const plumb_mesh* mesh) {
  return mesh != nullptr ? mesh->attributes.channels.size() : 0;
}
const char* plumb_mesh_channel_name(const plumb_mesh* mesh, std::size_t i) {
  const MeshChannel* const channel = channel_at(mesh, i);
  return channel != nullptr ? channel->name.c_str() : nullptr;
}
std::uint32_t plumb_mesh_channel_width(const plumb_mesh* mesh, std::size_t i) {
  const MeshChannel* const channel = channel_at(mesh, i);
  return channel != nullptr ? channel->width : 0;
}
const double* plumb_mesh_channel_values(const plumb_mesh* mesh, std::size_t i) {
  const MeshChannel* const channel = channel_at(mesh, i);
  return channel != nullptr && !channel->values.empty() ? channel->values.data() : nullptr;
}

plumb_status plumb_mesh_lost_attributes(const plumb_mesh* mesh, const char* format,
                                        plumb_bytes** out, plumb_error** error) {
  return make(out, error, [&] {
    const MeshFormat wanted = written_format(text(format, "format"));
    return lost_attributes(need(mesh, "mesh").attributes, wanted);
  });
}

// --- solids -------------------------------------------------------------------------------------

plumb_status plumb_solid_to_mesh_with_attributes(const plumb_solid* solid,
                                                 const plumb_attribute_options* options,
                                                 plumb_mesh** out, plumb_to_mesh_report* report,
                                                 const plumb_context* context,
                                                 plumb_error** error) {
  return make(out, error, [&] {
    Call call(context);
    const AttributeOptions asked = attribute_options(options);
    MeshWithAttributes made = mesh_with_attributes(need(solid, "solid").set, asked, call);
    if (report != nullptr) fill(report, to_mesh_report(made.report, made.repair), "report");
    return mesh_of(std::move(made));
  });
}

plumb_status plumb_solid_with_source(const plumb_solid* solid, const plumb_mesh* mesh,
                                     const char* name, plumb_solid** out, plumb_error** error) {
  return make(out, error, [&] {
    const plumb_mesh& from = need(mesh, "mesh");
    auto source = std::make_shared<MeshSource>();
    source->name = text_or_empty(name);
    source->mesh = from.mesh;
    source->attributes = from.attributes;
    return need(solid, "solid").set.with_source(std::move(source));
  });
}

plumb_status plumb_solid_half_space_with_source(const plumb_numbers* plane, bool is_closed,
                                                const plumb_plane_source* source, plumb_solid** out,
                                                plumb_error** error) {
  return make(out, error, [&] {
    const plumb_plane_source asked = options_of(source, PLUMB_PLANE_SOURCE_INIT);
    const std::span<const Rational> v = exactly(plane, "plane", 4);
    auto made = std::make_shared<MeshSource>();
    made->name = text_or_empty(asked.name);
    made->plane = Plane3{v[0], v[1], v[2], v[3]};
    if (asked.material != nullptr) {
      const plumb_material material = options_of(asked.material, PLUMB_MATERIAL_INIT);
      made->attributes.materials = {material_of(material)};
      made->attributes.face_material = {0};
    }
    if (asked.group != nullptr) {
      made->attributes.groups = {text(asked.group, "group")};
      made->attributes.face_group = {0};
    }
    if (asked.id != PLUMB_NONE) made->attributes.face_id = {asked.id};
    const Nef3 half = Nef3::half_space(*made->plane, boundary(is_closed));
    return half.with_source(std::move(made));
  });
}

std::size_t plumb_solid_source_count(const plumb_solid* solid) {
  return solid != nullptr ? solid->set.sources().size() : 0;
}
const char* plumb_solid_source_name(const plumb_solid* solid, std::size_t i) {
  return i < plumb_solid_source_count(solid) ? solid->set.sources()[i].source->name.c_str()
                                             : nullptr;
}
