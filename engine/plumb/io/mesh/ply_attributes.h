// Properties of vertices and faces of PLY files that are attributes of the mesh.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "plumb/base/context.h"
#include "plumb/io/mesh/attribute_builder.h"
#include "plumb/io/mesh/ply_header.h"
#include "plumb/io/mesh_io.h"

namespace plumb {

/// Keeps the values of the properties that the header has marked as kept, record by record, and
/// makes attributes of them (docs/formats.md, "PLY"):
///   - red, green, blue, alpha   channel "color" of vertices; a material for each colour of faces
///   - nx, ny, nz                the channel "normal"
///   - s and t, u and v, ...     the channel "texcoord_0"
///   - NAME_0, NAME_1, ...       a channel NAME of so many numbers
///   - face_id and other names   the ids of faces, if the type is an integer
///   - others                    a channel of one number; for faces the same at all their corners
///   - texcoord (list of faces)  the channel "texcoord_0", two numbers for each corner
class PlyAttributes {
 public:
  PlyAttributes(const PlyHeader& header, Context& context);

  /// Whether any property is kept.
  bool has_any() const { return !vertices_.properties.empty() || !faces_.properties.empty(); }
  /// Adds the next value of a property that is kept and is no list.
  void add(PlyElement::Kind kind, double value);
  /// Begins the list of texture coordinates of the next face.
  void begin_texture_list() { textures_.begins.push_back(textures_.values.size()); }
  void add_texture(double value);
  /// Notes that the faces of the element begin at this face of the mesh; strips may precede them.
  void begin_faces(std::size_t face) { first_face_ = face; }
  /// Adds the attributes to the file, and notes about contents that they do not represent.
  void give(MeshFile& file);

 private:
  struct Table {
    std::vector<PlyProperty> properties;
    std::vector<double> values;  ///< Row by row.

    std::size_t rows() const { return properties.empty() ? 0 : values.size() / properties.size(); }
  };
  struct Group;

  static std::vector<Group> groups_of(const Table& table, bool of_faces);
  static std::vector<double> column(const Table& table, const Group& group);
  void push(std::vector<double>& values, double value);
  void give_vertices(const PolygonMesh& mesh, std::vector<std::string>& lost);
  void give_faces(const PolygonMesh& mesh, std::vector<std::string>& lost);
  void give_face_colors(const Group& group);
  void give_ids(const Group& group, std::vector<std::string>& lost);
  void give_constants(const Group& group, const PolygonMesh& mesh, std::vector<std::string>& lost);
  void give_textures(const PolygonMesh& mesh, std::vector<std::string>& lost);

  MemoryCharge charge_;
  AttributeBuilder builder_;
  Table vertices_, faces_;
  struct {
    std::vector<std::size_t> begins;  // For each face of the element, where its list begins.
    std::vector<double> values;
  } textures_;
  std::size_t first_face_ = 0;
  std::size_t not_finite_ = 0;
};

}  // namespace plumb
