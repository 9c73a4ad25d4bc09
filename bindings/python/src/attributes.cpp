// Attributes of meshes: from and to the classes of plumb/_attributes.py.
//
// Arrays come prepared: indices as uint32 with 0xffffffff for none, channels as float64 without
// numbers that are not finite. Whether they fit the mesh is seen here, when the mesh is known.
// Tests: tests/test_attributes.py.
#include "attributes.h"

#include <algorithm>
#include <memory>

#include "plumb/space/nef3.h"

namespace plumb::python {
namespace {

using Prepared = std::tuple<std::string, nb::list, std::vector<std::string>, nb::object, nb::object,
                            nb::object, nb::list, nb::list>;
using FaceArray = nb::ndarray<const std::uint32_t, nb::ndim<1>, nb::c_contig, nb::device::cpu>;
using ChannelArray = nb::ndarray<const double, nb::ndim<2>, nb::c_contig, nb::device::cpu>;

MeshMaterial material_of(nb::handle given) {
  using Color = std::optional<std::vector<double>>;
  const auto [name, color, texture] = nb::cast<std::tuple<std::string, Color, std::string>>(given);
  MeshMaterial material;
  material.name = name;
  material.texture = texture;
  if (color) {
    material.color.emplace();
    std::copy(color->begin(), color->end(), material.color->begin());
  }
  return material;
}

std::vector<std::uint32_t> face_values(const nb::object& given) {
  if (given.is_none()) return {};
  const auto array = nb::cast<FaceArray>(given);
  return {array.data(), array.data() + array.size()};
}

void add_channels(const nb::list& given, std::vector<MeshChannel>& channels,
                  std::vector<std::size_t>& rows) {
  for (const nb::handle entry : given) {
    const auto [name, array] = nb::cast<std::pair<std::string, ChannelArray>>(entry);
    MeshChannel channel;
    channel.name = name;
    channel.width = static_cast<std::uint32_t>(array.shape(1));
    channel.values.assign(array.data(), array.data() + array.size());
    channels.push_back(std::move(channel));
    rows.push_back(array.shape(0));
  }
}

void require_rows(std::size_t rows, std::size_t needed, const std::string& channel,
                  const char* what) {
  if (rows == needed) return;
  throw Error(ErrorCode::BadArgument, "the channel '" + channel + "' has " + std::to_string(rows) +
                                          " rows, but the mesh has " + std::to_string(needed) +
                                          " " + what);
}

/// Returns the channel of corners that a channel of vertices is.
MeshChannel spread(const MeshChannel& of_vertices, const MeshView& mesh) {
  MeshChannel channel;
  channel.name = of_vertices.name;
  channel.width = of_vertices.width;
  channel.values.reserve(mesh.corners.size() * channel.width);
  for (const std::uint32_t v : mesh.corners) {
    const auto own = of_vertices.values.begin() + std::ptrdiff_t{v} * channel.width;
    channel.values.insert(channel.values.end(), own, own + channel.width);
  }
  return channel;
}

template <std::size_t Columns, class T>
nb::object array_of(std::vector<T> values) {
  return nb::cast(ArrayOut<T, Columns>{std::move(values)});
}

nb::tuple face_arrays(MeshWithAttributes& mesh) {
  std::vector<std::uint32_t> source, face;
  ArrayOut<bool, 1> is_flipped;
  for (const FaceSource& from : mesh.source) {
    source.push_back(from.source);
    face.push_back(from.face);
    is_flipped.values.push_back(from.is_flipped ? 1 : 0);
  }
  const std::span<const double> xyz = coordinates_of(mesh.mesh);
  return nb::make_tuple(array_of<3>(std::vector<double>(xyz.begin(), xyz.end())),
                        array_of<1>(std::move(mesh.mesh.face_begin)),
                        array_of<1>(std::move(mesh.mesh.corners)), array_of<1>(std::move(source)),
                        array_of<1>(std::move(face)), nb::cast(std::move(is_flipped)));
}

nb::list material_list(const std::vector<MeshMaterial>& materials) {
  nb::list list;
  for (const MeshMaterial& material : materials) {
    nb::object color = nb::none();
    if (material.color) {
      const auto& c = *material.color;
      color = nb::make_tuple(c[0], c[1], c[2], c[3]);
    }
    list.append(nb::make_tuple(material.name, color, material.texture));
  }
  return list;
}

/// Returns the parts of attributes that plumb/_attributes.py makes objects of.
nb::tuple parts_of(MeshAttributes attributes) {
  const nb::tuple face_values = nb::make_tuple(array_of<1>(std::move(attributes.face_material)),
                                               array_of<1>(std::move(attributes.face_group)),
                                               array_of<1>(std::move(attributes.face_id)));
  nb::list channels;
  for (MeshChannel& channel : attributes.channels) {
    channels.append(
        nb::make_tuple(channel.name, channel.width, array_of<1>(std::move(channel.values))));
  }
  return nb::make_tuple(material_list(attributes.materials), nb::cast(attributes.groups),
                        face_values, channels);
}

nb::object call(const char* function, const nb::tuple& arguments) {
  return nb::module_::import_("plumb._attributes").attr(function)(*arguments);
}

}  // namespace

MeshAttributes fitted_attributes(const AttributesIn& given, const MeshView& mesh) {
  MeshAttributes attributes = given.attributes;
  const std::size_t own = attributes.channels.size();
  for (std::size_t i = 0; i < own; ++i) {
    require_rows(given.channel_rows[i], mesh.corners.size(), attributes.channels[i].name,
                 "corners");
  }
  for (std::size_t i = 0; i < given.of_vertices.size(); ++i) {
    require_rows(given.channel_rows[own + i], mesh.point_count(), given.of_vertices[i].name,
                 "vertices");
    attributes.channels.push_back(spread(given.of_vertices[i], mesh));
  }
  return attributes;
}

AttributesIn attributes_of(nb::handle given) {
  const nb::object prepared = nb::module_::import_("plumb._attributes").attr("prepared")(given);
  const auto [name, materials, groups, material, group, id, of_corners, of_vertices] =
      nb::cast<Prepared>(prepared);
  AttributesIn result;
  result.is_given = true;
  result.name = name;
  MeshAttributes& attributes = result.attributes;
  for (const nb::handle entry : materials) attributes.materials.push_back(material_of(entry));
  attributes.groups = groups;
  attributes.face_material = face_values(material);
  attributes.face_group = face_values(group);
  attributes.face_id = face_values(id);
  add_channels(of_corners, attributes.channels, result.channel_rows);
  add_channels(of_vertices, result.of_vertices, result.channel_rows);
  return result;
}

Nef3 with_attributes(const Nef3& set, const MeshView& mesh, const AttributesIn& given) {
  if (!given.is_given) return set;
  auto source = std::make_shared<MeshSource>();
  source->name = given.name;
  source->mesh = copied_mesh(mesh);
  source->attributes = fitted_attributes(given, mesh);
  return set.with_source(std::move(source));
}

Nef3 with_plane_source(const Nef3& set, const Plane3& plane, const AttributesIn& given) {
  if (!given.is_given) return set;
  if (!given.channel_rows.empty()) {
    throw Error(ErrorCode::BadArgument, "the boundary of a half-space has no channels");
  }
  auto source = std::make_shared<MeshSource>();
  source->name = given.name;
  source->plane = plane;
  source->attributes = given.attributes;
  return set.with_source(std::move(source));
}

nb::object mesh_object(MeshWithAttributes mesh) {
  const nb::tuple arrays = face_arrays(mesh);
  return call("made", nb::make_tuple(arrays, parts_of(std::move(mesh.attributes))));
}

nb::object attributes_object(MeshAttributes attributes) {
  return call("attributes_made", parts_of(std::move(attributes)));
}

}  // namespace plumb::python
