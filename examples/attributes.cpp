// Materials and texture coordinates through a difference: each face of the result says which face
// of which input it is a part of.
#include <iostream>
#include <memory>

#include "plumb/space/mesh_with_attributes.h"

namespace {

using plumb::MeshSource;
using plumb::Nef3;

/// A box with one material, and the coordinates x and y as texture coordinates.
std::shared_ptr<const MeshSource> painted_box(const char* material, double low, double high) {
  MeshSource source;
  source.name = material;
  for (const double z : {low, high}) {
    for (const double y : {low, high}) {
      for (const double x : {low, high}) source.mesh.points.push_back({x, y, z});
    }
  }
  const unsigned squares[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                  {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  plumb::MeshChannel texture{"texcoord_0", 2, {}};
  for (const auto& square : squares) {
    source.mesh.add_face(square);
    for (const unsigned v : square) {
      texture.values.push_back(source.mesh.points[v].x);
      texture.values.push_back(source.mesh.points[v].y);
    }
  }
  source.attributes.channels = {texture};
  source.attributes.materials = {{material, {}, {}}};
  source.attributes.face_material.assign(6, 0);
  return std::make_shared<const MeshSource>(std::move(source));
}

}  // namespace

int main() {
  const Nef3 red = plumb::from_source(painted_box("red", 0, 2));
  const Nef3 blue = plumb::from_source(painted_box("blue", 1, 3));
  const plumb::MeshWithAttributes made = plumb::mesh_with_attributes(red - blue);

  for (std::size_t i = 0; i < 2; ++i) {
    std::cout << made.attributes.materials[i].name << ": "
              << made.run_begin[i + 1] - made.run_begin[i] << " triangles, "
              << (made.source[made.run_begin[i]].is_flipped ? "flipped" : "as they were") << "\n";
  }
  bool is_texture_right = true;
  const std::vector<double>& texture = made.attributes.channels[0].values;
  for (std::size_t c = 0; c < made.mesh.corners.size(); ++c) {
    const plumb::Point3& p = made.mesh.points[made.mesh.corners[c]];
    is_texture_right = is_texture_right && texture[2 * c] == p.x && texture[2 * c + 1] == p.y;
  }
  std::cout << "texture coordinates are right: " << (is_texture_right ? "yes" : "no") << "\n";
}
