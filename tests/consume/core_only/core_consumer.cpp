// What a program does with the core alone: meshes in arrays, their union, a mesh in arrays.
#include <plumb/plumb.h>

int main() {
  const std::vector<double> xyz = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1};
  const std::vector<std::uint32_t> triangles = {0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3};
  const plumb::Nef3 a = plumb::Nef3::from_mesh(xyz, triangles);
  const plumb::Nef3 b = a.translated({0.25, 0.25, 0.25});
  const plumb::TriangleMesh both = (a + b).to_mesh();
  return both.point_count() == 10 && both.triangle_count() == 16 ? 0 : 1;
}
