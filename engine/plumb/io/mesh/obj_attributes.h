// Attributes of OBJ files: materials and their libraries, groups, texture coordinates, normals and
// colours of vertices.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <ostream>
#include <string>
#include <string_view>
#include <vector>

#include "plumb/base/context.h"
#include "plumb/io/mesh/attribute_builder.h"
#include "plumb/io/mesh_io.h"

namespace plumb {

/// Returns the bytes of a file in the folder of the file that is read.
using ObjLoader = std::function<std::string(const std::string& name)>;

/// Collects attributes while the statements of a file are read (docs/formats.md, "OBJ").
class ObjAttributes {
 public:
  /// If `is_wanted` is false, all functions do nothing. An empty loader reads no libraries.
  ObjAttributes(bool is_wanted, const ObjLoader& loader, Context& context)
      : is_wanted_(is_wanted),
        loader_(loader),
        context_(context),
        charge_(context),
        builder_(context) {}

  bool is_wanted() const { return is_wanted_; }
  /// The numbers of the statement vt or vn. Missing numbers are 0.
  void add_texture(const std::vector<AttributeNumber>& numbers) { add(textures_, 2, numbers); }
  void add_normal(const std::vector<AttributeNumber>& numbers) { add(normals_, 3, numbers); }
  /// The numbers behind the coordinates of a vertex: a weight, a colour, or both.
  void add_vertex(const std::vector<AttributeNumber>& numbers);
  /// Takes a corner of the form v, v/vt, v//vn or v/vt/vn.
  void add_corner(std::string_view corner);
  /// Takes the material and the group of a face.
  void end_face(std::size_t face);
  void use_material(std::string_view name);
  void use_group(std::string_view name);
  void use_library(std::string_view name);
  /// Adds the attributes to the file, and notes about contents that could not be read.
  void give(MeshFile& file);

 private:
  /// Numbers of the statements vt or vn, and for each corner which one it has.
  struct List {
    std::vector<double> values;
    std::vector<std::uint32_t> of_corner;  // kNone if there is none.
    bool has_corner = false;
  };

  void add(List& list, std::size_t width, const std::vector<AttributeNumber>& numbers);
  template <class Value>
  void push(std::vector<Value>& values, Value value);
  void add_reference(List& list, std::size_t width, std::string_view text);
  void give_list(const char* name, std::size_t width, List& list, const PolygonMesh& mesh);
  void give_colors(const PolygonMesh& mesh);
  void load_libraries(std::vector<std::string>& notes);
  bool load_library(const std::string& name, std::string& why);
  void read_library(std::string_view text);
  void read_library_line(std::string_view line, MeshMaterial*& material);

  bool is_wanted_;
  const ObjLoader& loader_;
  Context& context_;
  MemoryCharge charge_;
  AttributeBuilder builder_;
  List textures_, normals_;
  std::vector<StatedColor> colors_;
  bool has_colors_ = false;
  std::vector<std::string> libraries_;
  std::uint32_t material_ = MeshAttributes::kNone;
  std::uint32_t group_ = MeshAttributes::kNone;
  std::size_t not_finite_ = 0;
  std::size_t unknown_ = 0;  // References to vt and vn that there are not.
};

/// Writes a mesh with the attributes that OBJ holds. `library` is the name of the material library
/// in the statement mtllib, which is left out if the name is empty. Requires complete attributes
/// (attribute_writer.h). Throws as write_obj().
void write_obj(std::ostream& out, const PolygonMesh& mesh, const MeshAttributes& attributes,
               const std::string& library);

/// Writes the material library of a mesh that write_obj() has written.
void write_obj_library(std::ostream& out, const MeshAttributes& attributes);

}  // namespace plumb
