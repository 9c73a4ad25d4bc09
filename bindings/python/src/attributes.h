// How attributes of meshes come into the module and go out of it.
//
// plumb/_attributes.py has the classes that users see, and converts their arrays; the casters below
// take what it prepares, and pass back what it makes an object of.
#pragma once

#include "binding.h"
#include "plumb/space/mesh_with_attributes.h"

namespace plumb::python {

/// Attributes that a caller gives with a mesh; none if is_given is false.
struct AttributesIn {
  bool is_given = false;
  std::string name;
  MeshAttributes attributes;              // Channels of corners only.
  std::vector<MeshChannel> of_vertices;   // Their values are those of the vertices.
  std::vector<std::size_t> channel_rows;  // How many corners, and then vertices, each channel has.
  std::exception_ptr problem;
};

/// Returns the set with a plane as its source, which has these attributes on its only face, if they
/// are given.
Nef3 with_plane_source(const Nef3& set, const Plane3& plane, const AttributesIn& given);

/// A mesh with attributes that goes out.
struct MeshOut {
  MeshWithAttributes mesh;
};

/// Attributes that go out, as plumb.MeshAttributes.
struct AttributesOut {
  MeshAttributes attributes;
};

/// Reads an object of plumb.MeshAttributes. Throws what its conversion throws.
AttributesIn attributes_of(nb::handle given);
/// Returns an object of plumb.MeshWithAttributes.
nb::object mesh_object(MeshWithAttributes mesh);
/// Returns an object of plumb.MeshAttributes.
nb::object attributes_object(MeshAttributes attributes);

/// Returns the attributes with all channels for corners; none if none are given. Throws
/// Error{BadArgument} if a channel does not fit the mesh.
MeshAttributes fitted_attributes(const AttributesIn& given, const MeshView& mesh);

/// Returns the solid with the mesh as its source if attributes are given. Throws
/// Error{BadArgument} if arrays do not fit the mesh.
Nef3 with_attributes(const Nef3& set, const MeshView& mesh, const AttributesIn& given);

}  // namespace plumb::python

namespace nanobind::detail {

template <>
struct type_caster<plumb::python::AttributesIn> {
  NB_TYPE_CASTER(plumb::python::AttributesIn, const_name("plumb._attributes.MeshAttributes"))
  bool from_python(handle source, std::uint32_t, cleanup_list*) noexcept {
    try {
      if (!source.is_none()) value = plumb::python::attributes_of(source);
    } catch (...) {
      value.problem = std::current_exception();
    }
    return true;
  }
};

template <>
struct type_caster<plumb::python::AttributesOut> {
  using Value = plumb::python::AttributesOut;
  static constexpr auto Name = const_name("plumb._attributes.MeshAttributes");
  template <class>
  using Cast = plumb::python::AttributesOut;
  static handle from_cpp(plumb::python::AttributesOut&& out, rv_policy, cleanup_list*) {
    return plumb::python::attributes_object(std::move(out.attributes)).release();
  }
};

template <>
struct type_caster<plumb::python::MeshOut> {
  using Value = plumb::python::MeshOut;
  static constexpr auto Name = const_name("plumb._attributes.MeshWithAttributes");
  template <class>
  using Cast = plumb::python::MeshOut;
  static handle from_cpp(plumb::python::MeshOut&& out, rv_policy, cleanup_list*) {
    return plumb::python::mesh_object(std::move(out.mesh)).release();
  }
};

}  // namespace nanobind::detail
