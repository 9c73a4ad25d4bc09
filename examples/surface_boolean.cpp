// Two triangles drawn on a cube: the cells they make, how often each polygon winds around them, and
// the union, which is bounded by polygons again.
#include <array>
#include <iostream>
#include <memory>
#include <vector>

#include "plumb/surface/surface.h"
#include "plumb/surface/surface_arrays.h"

namespace {

using plumb::SurfaceMesh;

/// The cube of side 1, of plain arrays: its top is faces 2 and 3.
SurfaceMesh cube() {
  std::vector<double> xyz;
  for (int i = 0; i < 8; ++i) {
    xyz.insert(xyz.end(), {double(i & 1), double((i >> 1) & 1), double((i >> 2) & 1)});
  }
  const std::vector<std::uint32_t> corners = {0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6, 0, 1, 5, 0, 5, 4,
                                              2, 6, 7, 2, 7, 3, 0, 4, 6, 0, 6, 2, 1, 3, 7, 1, 7, 5};
  return plumb::surface_of(plumb::mesh_of_triangles(xyz, corners));
}

/// A triangle inside one face, through three points given by the weights of its second and third
/// corner.
void add_triangle(plumb::SurfacePolygons& polygons, plumb::FaceId face,
                  const std::array<std::array<double, 2>, 3>& corners) {
  for (const auto& [u, v] : corners) {
    polygons.add_segment(polygons.points.add_in_face(face, u, v), face,
                         plumb::SegmentStart::ControlPoint);
  }
  polygons.close();
}

}  // namespace

int main() {
  const auto mesh = std::make_shared<const SurfaceMesh>(cube());
  plumb::SurfacePolygons polygons(*mesh);
  const plumb::FaceId top(2);
  add_triangle(polygons, top, {{{0.125, 0.125}, {0.5, 0.125}, {0.125, 0.5}}});
  add_triangle(polygons, top, {{{0.25, 0.25}, {0.625, 0.25}, {0.25, 0.625}}});

  const plumb::SurfaceDivision division({mesh, polygons, {}, plumb::FaceId(0)});
  std::cout << division.cell_count() << " cells, " << division.counts().crossings << " crossings\n";
  for (std::size_t c = 0; c < division.cell_count(); ++c) {
    std::cout << "cell " << c << ": ";
    for (const plumb::SignedEntry& label : division.labels(plumb::CellId(c))) {
      std::cout << char('A' + label.id) << ' ' << label.value << ", ";
    }
    std::cout << "area " << division.area(plumb::CellId(c)) << '\n';
  }
  const plumb::SurfaceResult both =
      division.evaluate(plumb::parse_set_expression("A + B"), plumb::WindingRule::EvenOdd);
  std::cout << "union: " << both.region.cells << " cells, area " << both.region.area << ", "
            << both.borders.size() << " polygon around it\n";
}
